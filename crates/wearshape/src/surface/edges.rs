//! The contact surface of two edges that touch: one line, or parts of one circle.

use std::f64::consts::{PI, TAU};

use hpfem::Kinematics;
use meshing::ContactLine;
use nalgebra::Vector3;
use scene::Fault;
use wear::Shape;

use crate::surface::found::{Found, Other, PatchKind, Round};

/// The key to blame for edges that do not touch.
pub(super) const EDGES: &str = "contact.edges";

/// The surface of two contact edges; none of a round body on a flat one.
pub(super) fn along(kinematics: Kinematics, lines: [ContactLine; 2]) -> Result<Option<Found>, Fault> {
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

fn same(one: f64, other: f64, scale: f64) -> bool {
    (one - other).abs() <= 1e-9 * scale
}

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
        true => Found { shape: Shape::Annulus { radii: x }, kind: PatchKind::Ring, centre: [0.0, z], key: EDGES, other: None },
        false => {
            let shape = Shape::Strip { x, z, thickness: thickness(kinematics) };
            Found { shape, kind: PatchKind::Plane, centre: [0.0, 0.0], key: EDGES, other: None }
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
    let one = same(radius, r, radius) && same(centre[0], c[0], radius) && same(centre[1], c[1], radius);
    if internal && !within && !one {
        return on_round(thickness, first, second);
    }
    if internal != within {
        let [first, second] = [internal, !within].map(|inside| if inside { "inside" } else { "outside" });
        let message = format!("body 1 lies {first} its circle, and body 2 {second} its own");
        return apart(message, "let one body lie inside the circle, and the other outside");
    }
    let other = other_circle([([centre[0], centre[1]], radius), (c, r)], internal)?;
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
    let (centre, radius) = if other.is_some() { (c, r) } else { (centre, radius) };
    let shape = Shape::Arc { radius, centre: Vector3::new(centre[0], 0.0, centre[1]), angles, thickness, internal };
    Ok(Found { shape, kind: PatchKind::Turning, centre, key: EDGES, other })
}

/// The circle of body 1, where it is another than that of body 2: a shaft and its hole, one drawn in the other with their centres on one line along z.
fn other_circle([first, second]: [Round; 2], internal: bool) -> Result<Option<Other>, Fault> {
    let ((centre, radius), (c, r)) = (first, second);
    let level = same(centre[0], c[0], radius);
    if same(radius, r, radius) {
        if level && same(centre[1], c[1], radius) {
            return Ok(None);
        }
        let message = format!("the arcs do not touch: radius {radius} about {centre:?} and radius {r} about {c:?}");
        return apart(message, "give both the same radius and centre");
    }
    let (shaft, hole) = if internal { (radius, r) } else { (r, radius) };
    if shaft > hole {
        let message = format!("the arcs cross: the shaft has the radius {shaft}, its hole the radius {hole}");
        return apart(message, "let the hole have the larger radius");
    }
    if !level || (centre[1] - c[1]).abs() > (hole - shaft) + 1e-9 * radius {
        let message = format!("the arcs cross or lie apart: radius {radius} about {centre:?} and radius {r} about {c:?}");
        let remedy = "draw the shaft inside the hole, with the same centre or touching it at the top or bottom";
        return apart(message, remedy);
    }
    Ok(Some(Other { circle: first, convex: false }))
}

/// Share of the smaller radius to which two round bodies may touch.
const ROUND: f64 = 0.25;

/// Two round bodies that touch from outside, body 1 above body 2. The contact surface is the part of body 2 around that place that may touch.
fn on_round(thickness: f64, first: Circle, second: Circle) -> Result<Found, Fault> {
    let Circle { centre, radius, angles, .. } = first;
    let Circle { centre: c, radius: r, angles: under, .. } = second;
    if !same(centre[0], c[0], radius + r) {
        let message =
            format!("the round bodies touch beside the z axis: their centres are at x = {} and x = {}", centre[0], c[0]);
        return apart(message, "put the centre of body 1 straight above that of body 2");
    }
    let distance = centre[1] - c[1];
    if !same(distance, radius + r, radius + r) {
        let how = if distance < radius + r { "cross" } else { "do not touch" };
        let message = format!("the round bodies {how}: radii {radius} and {r}, centres at z = {} and z = {}", centre[1], c[1]);
        return apart(message, "put the centre of body 1 above that of body 2 by the sum of both radii");
    }
    // How far each arc reaches to both sides of where they touch.
    let around = |[from, to]: [f64; 2], about: f64| {
        let off = 0.5 * (from + to) - about;
        let off = (off + PI).rem_euclid(TAU) - PI;
        0.5 * (to - from) - off.abs()
    };
    let reach = (radius * around(angles, PI)).min(r * around(under, 0.0)).min(ROUND * radius.min(r));
    if reach <= 0.0 {
        let message = "an arc does not contain the place where the round bodies touch";
        return apart(message.into(), "let the lowest point of body 1 lie on the highest of body 2");
    }
    let angles = [-reach / r, reach / r];
    let shape = Shape::Arc { radius: r, centre: Vector3::new(c[0], 0.0, c[1]), angles, thickness, internal: false };
    let other = Some(Other { circle: (centre, radius), convex: true });
    Ok(Found { shape, kind: PatchKind::Turning, centre: c, key: EDGES, other })
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

/// Thickness of plane bodies (mm); 1 for solids of revolution, which have none.
pub(super) fn thickness(kinematics: Kinematics) -> f64 {
    kinematics.thickness().unwrap_or(1.0)
}
