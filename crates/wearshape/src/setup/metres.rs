//! A mesh file in metres beside a body in mm.

use meshing::{Body, outline};
use scene::{Fault, Geometry};

/// A body this many times smaller than the other one is taken to be in metres: the factor is 1000.
const SMALLER: f64 = 100.0;

/// The fault of two bodies that do not touch, with a hint where one is a mesh whose coordinates look like metres.
pub(super) fn hinted(fault: Fault, bodies: [&Body; 2]) -> Fault {
    let sizes = bodies.map(size);
    let small = (0..2).find(|number| {
        let unscaled = matches!(&bodies[*number].geometry, Geometry::Mesh(file) if file.scale.is_none());
        unscaled && SMALLER * sizes[*number] < sizes[1 - number]
    });
    let Some(number) = small else { return fault };
    let (key, size, other) = (bodies[number].key, scene::short(sizes[number]), scene::short(sizes[1 - number]));
    Fault {
        message: format!("{}; {key} is {size} mm long and the other body {other} mm", fault.message),
        remedy: format!("if the mesh is in metres, write {key}.geometry.mesh.scale = \"m\"; otherwise {}", fault.remedy),
        ..fault
    }
}

/// Longest extent of what is known of a body without its mesh, or of its cells (mm).
fn size(body: &Body) -> f64 {
    let points: Vec<[f64; 2]> = match &body.cells {
        Some(mesh) => mesh.vertices.clone(),
        None => outline(body).edges.into_iter().flat_map(|edge| edge.points).collect(),
    };
    let extent = |i: usize| {
        let (low, high) = points.iter().fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x[i]), high.max(x[i])));
        high - low
    };
    extent(0).max(extent(1))
}
