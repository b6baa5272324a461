//! The contact surface where geometry alone gives it: arcs, strips, rings, and the bare surfaces.

use std::f64::consts::{PI, TAU};

use hpfem::Kinematics;
use meshing::{Body, ContactLine, contact_line};
use nalgebra::Vector3;
use scene::{Fault, Geometry, Length, Sliding, SurfaceShape, missing, positive};
use wear::{Shape, SlidingMotion, Surface, SurfacePoint};

/// A contact surface known without a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    /// The surface with its sliding motion.
    pub surface: Surface,
    /// What kind of motion closes a track, which decides how the counter-face wears.
    pub kind: PatchKind,
    /// Whether the surface's own angle falls towards +x: a shoe at the bottom inside its drum.
    pub backwards: bool,
}

/// Kind of contact surface, by how body 2 passes under it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PatchKind {
    /// Plane strip or plane surface over which a long plate slides.
    Plane,
    /// Full ring on a turning disc.
    Ring,
    /// Arc or sector under which a drum, shaft or disc turns.
    Turning,
}

impl Patch {
    /// A surface without bodies.
    pub fn bare(surface: &SurfaceShape, sliding: Option<&Sliding>) -> Result<Patch, Fault> {
        Patch::new(bare(surface)?, sliding, false)
    }

    /// The surface between two bodies; none when it takes a mesh to know it.
    pub /// The surface of two contact edges; none of a round body on a flat one.
fn along(kinematics: Kinematics, lines: [ContactLine; 2]) -> Result<Option<Found>, Fault> {
    let key = "contact.edges";
    let thickness = thickness(kinematics);
    let revolved = kinematics.is_revolved();
    let apart = |message: String, remedy: &str| Err(Fault::at(key, "no-contact", message, remedy));
    let inside = |[from, to]: [f64; 2], [low, high]: [f64; 2]| {
        let near = 1e-9 * (to - from);
        from >= low - near && to <= high + near
    };
    match lines {
        [ContactLine::Line { z, x }, ContactLine::Line { z: below, x: under }] => {
            if !same(z, below, x[1] - x[0]) {
                let message = format!("the edges do not touch: z = {z} and z = {below}");
                return apart(message, "give both contact edges the same height");
            }
            if !inside(x, under) {
                let [a, b, c, d] = [x[0], x[1], under[0], under[1]];
                let message = format!("body 1 reaches from x = {a} to {b} over body 2 from {c} to {d}");
                return apart(message, "make the contact edge of body 2 as wide as that of body 1 or wider");
            }
            if revolved {
                return Ok(Some((Shape::Annulus { radii: x }, PatchKind::Ring, [0.0, z], key)));
            }
            Ok(Some((Shape::Strip { x, z, thickness }, PatchKind::Plane, [0.0, 0.0], key)))
        }
        [
            ContactLine::Circle { centre, radius, angles, internal },
            ContactLine::Circle { centre: c, radius: r, angles: under, internal: within },
        ] if !revolved => {
            if internal != within {
                let [first, second] = [internal, !within].map(|inside| if inside { "inside" } else { "outside" });
                let message = format!("body 1 lies {first} its circle, and body 2 {second} its own");
                return apart(message, "let one body lie inside the circle, and the other outside");
            }
            if !(same(radius, r, radius) && same(centre[0], c[0], radius) && same(centre[1], c[1], radius)) {
                let message = format!("the arcs do not touch: radius {radius} about {centre:?} and radius {r} about {c:?}");
                return apart(message, "give both the same radius and centre");
            }
            let turn = std::f64::consts::TAU;
            let full = under[1] - under[0] > turn * (1.0 - 1e-12);
            if !(full || [-turn, 0.0, turn].iter().any(|by| inside(angles, under.map(|a| a + by)))) {
                let [a, b, c, d] = [angles[0], angles[1], under[0], under[1]].map(f64::to_degrees);
                let message = format!("body 1 reaches from {a:.6} to {b:.6} deg over body 2 from {c:.6} to {d:.6} deg");
                return apart(message, "make the contact edge of body 2 as long as that of body 1 or longer");
            }
            // Half a circle from side to side cannot close everywhere.
            if angles[1] - angles[0] >= std::f64::consts::PI * (1.0 - 1e-9) {
                return apart(
                    "the contact reaches up to the middle of the circle".into(),
                    "let the arc of body 1 be less than half a circle",
                );
            }
            let shape = Shape::Arc { radius, centre: Vector3::new(centre[0], 0.0, centre[1]), angles, thickness, internal };
            Ok(Some((shape, PatchKind::Turning, centre, key)))
        }
        [ContactLine::Circle { centre, radius, angles, internal: true }, ContactLine::Line { z, x }] => {
            let lowest = centre[1] - radius;
            let near = 1e-9;
            if !(angles[0] <= std::f64::consts::PI + near && angles[1] >= std::f64::consts::PI - near) {
                let message = "the arc of the round body 1 does not contain its lowest point";
                return apart(message.into(), "let it touch the line with its lowest point");
            }
            if !same(lowest, z, radius) {
                let message = format!("the edges do not touch: lowest point z = {lowest}, plane z = {z}");
                return apart(message, "let the round body 1 touch the line with its lowest point");
            }
            if !inside([centre[0]; 2], x) {
                let message = format!("body 1 touches at x = {}, beside body 2 from {} to {}", centre[0], x[0], x[1]);
                return apart(message, "let body 2 lie under the lowest point of body 1");
            }
            Ok(None)
        }
        [ContactLine::Circle { .. }, ContactLine::Circle { .. }] => {
            apart("axisymmetric bodies touch along horizontal lines only".into(), "let both contact edges be horizontal")
        }
        _ => apart(
            "one contact edge is a line and the other part of a circle".into(),
            "let both be one horizontal line, or parts of one circle, or let a round body 1 touch a line",
        ),
    }
}

/// Motion of body 2; zero when the scene has none.
fn motion(sliding: Option<&Sliding>, kind: PatchKind, shape: &Shape, centre: [f64; 2]) -> Result<SlidingMotion, Fault> {
    let Some(sliding) = sliding else {
        return Ok(SlidingMotion::along_x(0.0));
    };
    let (wanted, found, other) = match kind {
        PatchKind::Plane => ("speed", sliding.speed.map(|speed| speed.0), sliding.omega.map(|_| "omega")),
        _ => ("omega", sliding.omega.map(|omega| omega.0), sliding.speed.map(|_| "speed")),
    };
    let example = if wanted == "speed" { "sliding = { speed = \"5 mm/s\" }" } else { "sliding = { omega = \"2.5 rad/s\" }" };
    let Some(value) = found else {
        return Err(match other {
            Some(other) => Fault::at(
                format!("sliding.{other}"),
                "wrong-key",
                format!("`sliding.{other}` does not fit this contact surface, which needs `sliding.{wanted}`"),
                format!("write {example}"),
            ),
            None => missing(&format!("sliding.{wanted}"), "it says how body 2 moves", example),
        });
    };
    if value == 0.0 {
        let message = format!("sliding.{wanted} = 0: nothing slides");
        return Err(Fault::at(
            format!("sliding.{wanted}"),
            "wrong-value",
            message,
            format!("write {example}, or remove `sliding`"),
        ));
    }
    Ok(match (kind, shape) {
        (PatchKind::Plane, _) => SlidingMotion::along_x(value),
        (PatchKind::Ring, _) | (_, Shape::Sector { .. }) => SlidingMotion::about_z(value),
        _ => SlidingMotion::in_plane(value, Vector3::new(centre[0], 0.0, centre[1])),
    })
}
