//! The line or circle that a contact edge lies on, which the pressure stage needs to know exactly.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use hpfem::{Curve, Mesh};
use scene::{Fault, Geometry, short};

use crate::couple::Body;
use crate::gmsh_file::circle;
use crate::line::ContactLine;
use crate::outline::{outline, reach_of_whole};

/// The line of a body's contact edge; `shaped` is body 1, which lies above the line, around the circle or inside it.
///
/// # Errors
/// The fault of `contact.edges` that says why the edge of this body cannot touch the other one.
pub fn contact_line(body: &Body, shaped: bool) -> Result<ContactLine, Fault> {
    let (key, edge) = (body.key, body.contact.as_str());
    let refuse = |message: String| {
        let remedy = "let the contact edge be one horizontal line with body 1 above, or part of one circle with body 1 around its top or inside its bottom, or let a round body 1 touch a line of body 2";
        Err(Fault::at(if shaped { "contact.edges.0" } else { "contact.edges.1" }, "not-available", message, remedy))
    };
    if let Some(mesh) = &body.cells {
        if let Some((pieces, radius)) = facets(mesh, edge).filter(|_| matches!(body.geometry, Geometry::Mesh(_))) {
            let radius = short(radius);
            let message = format!("the edge `{edge}` of {key} is an arc of radius {radius} made of {pieces} straight sides");
            let remedy = "mesh with order 2 (Mesh.ElementOrder = 2), so that the sides are curved";
            return Err(Fault::at(if shaped { "contact.edges.0" } else { "contact.edges.1" }, "not-available", message, remedy));
        }
        return of_mesh(mesh, edge, shaped).map_or_else(|why| refuse(format!("the edge `{edge}` of {key} {why}")), Ok);
    }
    let touches = outline(body).edge(edge).and_then(|edge| edge.touches[usize::from(!shaped)]);
    touches.map_or_else(|| refuse(format!("the edge `{edge}` of the {} {key} cannot touch this body", body.geometry.name())), Ok)
}

/// Number of sides and radius of an edge whose straight sides turn along one circle: a mesh of order 1 on an arc.
fn facets(mesh: &Mesh, edge: &str) -> Option<(usize, f64)> {
    let walk = walk(mesh, edge)?;
    let first = walk.first().filter(|_| walk.len() > 1 && walk.iter().all(Curve::is_straight))?;
    let points: Vec<[f64; 2]> = std::iter::once(first.point(-1.0)).chain(walk.iter().map(|side| side.point(1.0))).collect();
    let (centre, radius) = circle(&points)?;
    let length: f64 = walk.iter().map(Curve::length).sum();
    let on = |x: &[f64; 2]| ((x[0] - centre[0]).hypot(x[1] - centre[1]) - radius).abs() <= 1e-6 * length;
    (radius < 100.0 * length && points.iter().all(on)).then_some((walk.len(), radius))
}

fn of_mesh(mesh: &Mesh, edge: &str, shaped: bool) -> Result<ContactLine, String> {
    let walk = walk(mesh, edge).ok_or("is not one connected line")?;
    let length: f64 = walk.iter().map(Curve::length).sum();
    let first = walk.first().copied().ok_or("has no curves")?;
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * length;
    match first {
        Curve::Line { start, .. } => of_line(&walk, start, near, shaped),
        Curve::Arc { centre, radius, from, .. } => {
            let mut turned = 0.0;
            for curve in &walk {
                match *curve {
                    Curve::Arc { centre: c, radius: r, from, to }
                        if near(c[0], centre[0]) && near(c[1], centre[1]) && near(r, radius) =>
                    {
                        turned += to - from;
                    }
                    Curve::Arc { .. } | Curve::Line { .. } | Curve::Polynomial { .. } => {
                        return Err("is not part of one circle".into());
                    }
                }
            }
            // Left of an anti-clockwise walk is inside the circle.
            let internal = shaped == (turned > 0.0);
            // Angles from the z axis run the other way; they are counted around the middle of what body 1 may touch.
            let about = if internal { PI } else { 0.0 };
            let middle = FRAC_PI_2 - from - 0.5 * turned;
            let off = (middle - about + PI).rem_euclid(TAU) - PI;
            let off = if off.abs() < 1e-14 { 0.0 } else { off };
            let half = 0.5 * turned.abs();
            if shaped && half > PI * (1.0 - 1e-9) {
                return Ok(ContactLine::Circle { centre, radius, angles: reach_of_whole(internal), internal });
            }
            // Half a disc may touch a flat.
            let most = if internal { FRAC_PI_2 * (1.0 + 1e-9) } else { FRAC_PI_2 };
            if shaped && off.abs() + half >= most {
                let [from, to] = [about + off - half, about + off + half].map(f64::to_degrees);
                let (side, place) = if internal { ("below", "inside") } else { ("above", "around") };
                return Err(format!(
                    "reaches from {from:.3} to {to:.3} deg from the z axis, and of a body {place} its circle must stay {side} its middle"
                ));
            }
            Ok(ContactLine::Circle { centre, radius, angles: [about + off - half, about + off + half], internal })
        }
        Curve::Polynomial { .. } => Err("is neither a line nor an arc".into()),
    }
}

/// The line that curves on a level make up.
fn of_line(walk: &[Curve], start: [f64; 2], near: impl Fn(f64, f64) -> bool, shaped: bool) -> Result<ContactLine, String> {
    let height = start[1];
    for curve in walk {
        match curve {
            Curve::Line { start, end } if near(start[1], height) && near(end[1], height) => {}
            Curve::Line { .. } => {
                let heights = walk.iter().flat_map(|curve| [curve.point(-1.0)[1], curve.point(1.0)[1]]);
                let off = heights.map(|z| (z - height).abs()).fold(0.0, f64::max);
                return Err(format!("is not horizontal: it leaves the height of its first point by {} mm", short(off)));
            }
            Curve::Arc { .. } | Curve::Polynomial { .. } => return Err("is partly straight and partly curved".into()),
        }
    }
    let ends = [start[0], walk[walk.len() - 1].point(1.0)[0]];
    let x = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    // The body lies on the left of the walk.
    let above = ends[1] > ends[0];
    match (shaped, above) {
        (true, false) => Err("has its body below it, which must be above".into()),
        (false, true) => Err("has its body above it, which must be below".into()),
        _ => Ok(ContactLine::Line { z: height, x }),
    }
}

/// The curves of a boundary in order, each with the body on the left; none if they are not one path or ring.
fn walk(mesh: &Mesh, edge: &str) -> Option<Vec<Curve>> {
    let neighbours = mesh.edge_cells();
    let mut directed: Vec<([usize; 2], Curve)> = Vec::new();
    for e in mesh.boundary(edge).ok()? {
        let own = &mesh.edges[e];
        let (cell, local) = neighbours[e][0];
        // Local edges 0 and 1 have the cell on their left.
        let left = (local < 2) != mesh.cells[cell].against[local];
        let [a, b] = own.vertices;
        directed.push(if left { ([a, b], own.curve) } else { ([b, a], own.curve.reversed()) });
    }
    let is_end = |v: usize| directed.iter().any(|(ends, _)| ends[1] == v);
    let start = directed.iter().position(|(ends, _)| !is_end(ends[0])).unwrap_or(0);
    let mut curves = Vec::new();
    let mut at = directed.get(start)?.0[0];
    while curves.len() < directed.len() {
        let (ends, curve) = directed.iter().find(|(ends, _)| ends[0] == at)?;
        curves.push(*curve);
        at = ends[1];
        // A second piece beside a closed one.
        if at == directed[start].0[0] && curves.len() < directed.len() {
            return None;
        }
    }
    Some(curves)
}
