//! The contact surface where geometry alone gives it: arcs, strips, rings, and the bare surfaces.

use std::f64::consts::{PI, TAU};

use hpfem::Kinematics;
use meshing::{Body, ContactLine, Extent, contact_line};
use nalgebra::Vector3;
use scene::{Fault, Length, Sliding, SurfaceShape, missing, positive};
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
    pub fn between(kinematics: Kinematics, bodies: [&Body; 2], sliding: Option<&Sliding>) -> Result<Option<Patch>, Fault> {
        let [first, second] = bodies;
        let found = along(kinematics, [contact_line(first, true)?, contact_line(second, false)?])?;
        found
            .map(|found| {
                let backwards = matches!(found.shape, Shape::Arc { internal: true, .. });
                Patch::new(found, sliding, backwards)
            })
            .transpose()
    }

    fn new(found: Found, sliding: Option<&Sliding>, backwards: bool) -> Result<Patch, Fault> {
        let Found { shape, kind, centre, key } = found;
        let motion = motion(sliding, kind, &shape, centre)?;
        let surface = Surface::new(shape, motion)
            .map_err(|error| Fault::at(key, "degenerate", error.to_string(), "give a surface with area"))?;
        Ok(Patch { surface, kind, backwards })
    }

    /// Its extent in its own coordinate; none where bodies cannot be meshed for it.
    pub fn extent(&self) -> Option<Extent> {
        match self.surface.shape() {
            Shape::Arc { angles, .. } => Some(Extent::Angles(*angles)),
            Shape::Strip { x, .. } => Some(Extent::X(*x)),
            Shape::Annulus { radii } => Some(Extent::X(*radii)),
            _ => None,
        }
    }

    /// The surface with all sliding speeds multiplied by a factor.
    pub fn faster(self, factor: f64) -> Patch {
        let SlidingMotion { velocity, angular_velocity, about } = *self.surface.motion();
        let motion = SlidingMotion { velocity: velocity * factor, angular_velocity: angular_velocity * factor, about };
        match Surface::new(self.surface.shape().clone(), motion) {
            Ok(surface) => Patch { surface, ..self },
            Err(_) => self,
        }
    }

    /// `count` points equally spaced in the surface's own coordinate, towards +x.
    pub fn sample(&self, count: usize) -> Vec<SurfacePoint> {
        self.towards_x(self.surface.sample(count))
    }

    /// Points of the surface in the order of its own coordinate, turned towards +x.
    pub fn towards_x(&self, mut points: Vec<SurfacePoint>) -> Vec<SurfacePoint> {
        if self.backwards {
            points.reverse();
        }
        points
    }

    /// The arc length from the middle of a point, positive towards +x; on rings and sectors its radius.
    pub fn place(&self, point: &SurfacePoint) -> f64 {
        let position = point.position;
        match self.surface.shape() {
            Shape::Arc { radius, centre, angles, .. } => {
                let (from, middle) = (position - centre, 0.5 * (angles[0] + angles[1]));
                let off = (from.x.atan2(from.z) - middle + PI).rem_euclid(TAU) - PI;
                if self.backwards { -radius * off } else { radius * off }
            }
            Shape::Annulus { .. } | Shape::Sector { .. } => position.x.hypot(position.y),
            Shape::Strip { x, .. } | Shape::Rectangle { x, .. } => position.x - 0.5 * (x[0] + x[1]),
            _ => position.x,
        }
    }

    /// The angle (rad, from the z axis towards +x) at an arc length from the middle; none off an arc.
    pub fn angle(&self, s: f64) -> Option<f64> {
        let Shape::Arc { radius, angles, .. } = self.surface.shape() else { return None };
        let middle = 0.5 * (angles[0] + angles[1]);
        Some(if self.backwards { middle - s / radius } else { middle + s / radius })
    }
}

impl Patch {
    /// A flat surface from and to the given x (or radius), where a round body meets a flat one.
    pub fn flat(kinematics: Kinematics, x: [f64; 2], z: f64, sliding: Option<&Sliding>) -> Result<Patch, Fault> {
        let (shape, kind) = match kinematics.is_revolved() {
            true => (Shape::Annulus { radii: x }, PatchKind::Ring),
            false => (Shape::Strip { x, z, thickness: thickness(kinematics) }, PatchKind::Plane),
        };
        Patch::new(Found { shape, kind, centre: [0.0, z], key: EDGES }, sliding, false)
    }
}

/// Thickness of plane bodies (mm); 1 for solids of revolution, which have none.
fn thickness(kinematics: Kinematics) -> f64 {
    match kinematics {
        Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness } => thickness,
        _ => 1.0,
    }
}

/// A contact surface without its sliding.
struct Found {
    shape: Shape,
    kind: PatchKind,
    /// Point [x, z] about which body 2 turns in the plane.
    centre: [f64; 2],
    /// The key to blame for it.
    key: &'static str,
}

fn symmetric_arc(key: &str, radius: Length, half_angle: f64, width: f64) -> Result<Shape, Fault> {
    positive(&format!("{key}.radius"), radius.0, "radius", " mm")?;
    positive(&format!("{key}.width"), width, "width", " mm")?;
    angle_below_quarter(&format!("{key}.half_angle"), half_angle)?;
    let (centre, internal) = (Vector3::zeros(), false);
    Ok(Shape::Arc { radius: radius.0, centre, angles: [-half_angle, half_angle], thickness: width, internal })
}

fn angle_below_quarter(key: &str, angle: f64) -> Result<(), Fault> {
    if angle > 0.0 && angle < std::f64::consts::FRAC_PI_2 {
        return Ok(());
    }
    let message = format!("half angle {} deg is out of range", angle.to_degrees());
    Err(Fault::at(key, "degenerate", message, "give a half angle greater than 0 and less than 90 deg"))
}

fn bare(surface: &SurfaceShape) -> Result<Found, Fault> {
    let range = |key: &str, range: [Length; 2]| {
        if range[1].0 > range[0].0 {
            return Ok([range[0].0, range[1].0]);
        }
        let message = format!("{key} = [{}, {}] does not increase", range[0].0, range[1].0);
        Err(Fault::at(key, "degenerate", message, "write [from, to] with from < to"))
    };
    let found = |shape: Shape, kind: PatchKind, key: &'static str| Ok(Found { shape, kind, centre: [0.0, 0.0], key });
    match surface {
        SurfaceShape::DiscPad(pad) => {
            let key = "surface.disc-pad";
            positive(&format!("{key}.inner"), pad.inner.0, "inner radius", " mm")?;
            let radii = range(&format!("{key}.outer"), [pad.inner, pad.outer])?;
            let half = pad.half_angle.0;
            if !(half > 0.0 && half <= std::f64::consts::PI) {
                let message = format!("half angle {} deg is out of range", half.to_degrees());
                return Err(Fault::at(format!("{key}.half_angle"), "degenerate", message, "give 0 to 180 deg"));
            }
            found(Shape::Sector { radii, angles: [-half, half] }, PatchKind::Turning, key)
        }
        SurfaceShape::PinnedShoe(shoe) => {
            let key = "surface.pinned-shoe";
            positive(&format!("{key}.radius"), shoe.radius.0, "radius", " mm")?;
            positive(&format!("{key}.width"), shoe.width.0, "width", " mm")?;
            positive(&format!("{key}.pin_distance"), shoe.pin_distance.0, "distance of the pin", " mm")?;
            positive(&format!("{key}.arm"), shoe.arm.0, "lever arm", " mm")?;
            let angles = [shoe.from.0, shoe.to.0];
            if !(angles[0] >= 0.0 && angles[1] > angles[0] && angles[1] < std::f64::consts::PI) {
                let (from, to) = (angles[0].to_degrees(), angles[1].to_degrees());
                let message = format!("the lining reaches from {from} to {to} deg, where it cannot close everywhere");
                return Err(Fault::at(format!("{key}.to"), "degenerate", message, "give 0 <= from < to < 180 deg"));
            }
            let shape =
                Shape::Arc { radius: shoe.radius.0, centre: Vector3::zeros(), angles, thickness: shoe.width.0, internal: true };
            found(shape, PatchKind::Turning, key)
        }
        SurfaceShape::PivotedShoe(shoe) => {
            let key = "surface.pivoted-shoe";
            found(symmetric_arc(key, shoe.radius, shoe.half_angle.0, shoe.width.0)?, PatchKind::Turning, key)
        }
        SurfaceShape::JournalArc(arc) => {
            let key = "surface.journal-arc";
            found(symmetric_arc(key, arc.radius, arc.half_angle.0, arc.width.0)?, PatchKind::Turning, key)
        }
        SurfaceShape::RectangularPunch(punch) => {
            let key = "surface.rectangular-punch";
            let shape = Shape::Rectangle { x: range(&format!("{key}.x"), punch.x)?, y: range(&format!("{key}.y"), punch.y)? };
            found(shape, PatchKind::Plane, key)
        }
        SurfaceShape::EllipticPunch(punch) => {
            let key = "surface.elliptic-punch";
            for axis in punch.half_axes {
                positive(&format!("{key}.half_axes"), axis.0, "half axis", " mm")?;
            }
            let semi_axes = [punch.half_axes[0].0, punch.half_axes[1].0];
            found(Shape::Ellipse { semi_axes }, PatchKind::Plane, key)
        }
    }
}

fn same(one: f64, other: f64, scale: f64) -> bool {
    (one - other).abs() <= 1e-9 * scale
}

/// The surface of two contact edges; none of a round body on a flat one.
fn along(kinematics: Kinematics, lines: [ContactLine; 2]) -> Result<Option<Found>, Fault> {
    let revolved = kinematics.is_revolved();
    match lines {
        [ContactLine::Line { z, x }, ContactLine::Line { z: below, x: under }] => {
            on_line(kinematics, Line { z, x }, Line { z: below, x: under }).map(Some)
        }
        [
            ContactLine::Circle { centre, radius, angles, internal },
            ContactLine::Circle { centre: c, radius: r, angles: under, internal: within },
        ] if !revolved => {
            let first = Circle { centre, radius, angles, internal };
            on_circle(thickness(kinematics), first, Circle { centre: c, radius: r, angles: under, internal: within }).map(Some)
        }
        [ContactLine::Circle { centre, radius, angles, internal: true }, ContactLine::Line { z, x }] => {
            round_on_flat(Circle { centre, radius, angles, internal: true }, Line { z, x }).map(|()| None)
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

/// The key to blame for edges that do not touch.
const EDGES: &str = "contact.edges";

fn apart<T>(message: String, remedy: &str) -> Result<T, Fault> {
    Err(Fault::at(EDGES, "no-contact", message, remedy))
}

fn inside([from, to]: [f64; 2], [low, high]: [f64; 2]) -> bool {
    let near = 1e-9 * (to - from);
    from >= low - near && to <= high + near
}

/// A horizontal line: height, and from where to where in x.
struct Line {
    z: f64,
    x: [f64; 2],
}

/// Two horizontal lines.
fn on_line(kinematics: Kinematics, Line { z, x }: Line, Line { z: below, x: under }: Line) -> Result<Found, Fault> {
    if !same(z, below, x[1] - x[0]) {
        return apart(format!("the edges do not touch: z = {z} and z = {below}"), "give both contact edges the same height");
    }
    if !inside(x, under) {
        let [a, b, c, d] = [x[0], x[1], under[0], under[1]];
        let message = format!("body 1 reaches from x = {a} to {b} over body 2 from {c} to {d}");
        return apart(message, "make the contact edge of body 2 as wide as that of body 1 or wider");
    }
    Ok(match kinematics.is_revolved() {
        true => Found { shape: Shape::Annulus { radii: x }, kind: PatchKind::Ring, centre: [0.0, z], key: EDGES },
        false => {
            let shape = Shape::Strip { x, z, thickness: thickness(kinematics) };
            Found { shape, kind: PatchKind::Plane, centre: [0.0, 0.0], key: EDGES }
        }
    })
}

/// Part of a circle.
struct Circle {
    centre: [f64; 2],
    radius: f64,
    /// From and to, from the z axis.
    angles: [f64; 2],
    /// Whether body 1 lies inside.
    internal: bool,
}

/// Two parts of one circle.
fn on_circle(thickness: f64, first: Circle, second: Circle) -> Result<Found, Fault> {
    let Circle { centre, radius, angles, internal } = first;
    let Circle { centre: c, radius: r, angles: under, internal: within } = second;
    if internal != within {
        let [first, second] = [internal, !within].map(|inside| if inside { "inside" } else { "outside" });
        let message = format!("body 1 lies {first} its circle, and body 2 {second} its own");
        return apart(message, "let one body lie inside the circle, and the other outside");
    }
    if !(same(radius, r, radius) && same(centre[0], c[0], radius) && same(centre[1], c[1], radius)) {
        let message = format!("the arcs do not touch: radius {radius} about {centre:?} and radius {r} about {c:?}");
        return apart(message, "give both the same radius and centre");
    }
    let full = under[1] - under[0] > TAU * (1.0 - 1e-12);
    if !(full || [-TAU, 0.0, TAU].iter().any(|by| inside(angles, under.map(|a| a + by)))) {
        let [a, b, c, d] = [angles[0], angles[1], under[0], under[1]].map(f64::to_degrees);
        let message = format!("body 1 reaches from {a:.6} to {b:.6} deg over body 2 from {c:.6} to {d:.6} deg");
        return apart(message, "make the contact edge of body 2 as long as that of body 1 or longer");
    }
    // Half a circle from side to side cannot close everywhere.
    if angles[1] - angles[0] >= PI * (1.0 - 1e-9) {
        let message = "the contact reaches up to the middle of the circle";
        return apart(message.into(), "let the arc of body 1 be less than half a circle");
    }
    let shape = Shape::Arc { radius, centre: Vector3::new(centre[0], 0.0, centre[1]), angles, thickness, internal };
    Ok(Found { shape, kind: PatchKind::Turning, centre, key: EDGES })
}

/// A round body 1 that touches a line of body 2 with its lowest point.
fn round_on_flat(round: Circle, Line { z, x }: Line) -> Result<(), Fault> {
    let Circle { centre, radius, angles, .. } = round;
    let lowest = centre[1] - radius;
    let near = 1e-9;
    if !(angles[0] <= PI + near && angles[1] >= PI - near) {
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
    Ok(())
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
