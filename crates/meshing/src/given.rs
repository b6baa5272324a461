//! A body given by its cells.

use hpfem::{Curve, Mesh};
use scene::{Fault, Geometry, Material};

use crate::couple::Body;

/// The cells of a body as they are written; the boundaries of the mesh are the named edges.
#[derive(Debug, Clone)]
pub struct Given {
    /// The cells.
    pub mesh: Mesh,
    /// Materials, by the index that cells have.
    pub materials: Vec<Material>,
}

/// Where files beside the scene come from: a path as the scene has it, to bytes or to why not.
pub type Files<'f> = &'f dyn Fn(&str) -> Result<Vec<u8>, String>;

/// The curves of a named edge.
pub(crate) fn edge_curves(mesh: &Mesh, edge: &str) -> Vec<Curve> {
    mesh.boundary(edge).unwrap_or_default().into_iter().map(|e| mesh.edges[e].curve).collect()
}

/// Refuses an edge with a part inside the body, where nothing can touch or press it.
pub fn outside(body: &Body, edge: &str) -> Result<(), Fault> {
    let Some(mesh) = &body.cells else { return Ok(()) };
    let key = body.key;
    let cells = mesh.edge_cells();
    let inside = mesh.boundary(edge).unwrap_or_default().into_iter().find(|e| cells[*e].len() > 1);
    let Some(e) = inside else { return Ok(()) };
    let [x, z] = mesh.edges[e].curve.point(0.0);
    let place = match &body.geometry {
        Geometry::Blocks(_) => format!("{key}.geometry.blocks.edges.{edge}"),
        _ => format!("{key}.geometry.mesh.file"),
    };
    let message = format!("the edge `{edge}` lies inside the body at x = {x}, z = {z}, where nothing can touch or load it");
    Err(Fault::at(place, "not-on-boundary", message, "name curves of one cell only; inner lines can be held by supports"))
}
