//! Cutting the edges of a mesh, the first step of cutting its cells.

use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::{Mesh, Quad};
use std::collections::HashMap;

/// A mesh whose edges are cut and whose cells are yet to come.
pub(crate) struct Split<'m> {
    /// The vertices of the mesh, then those that cut edges.
    pub(crate) vertices: Vec<[f64; 2]>,
    pub(crate) quads: Vec<Quad>,
    /// Curves of all pieces of edges.
    pub(crate) curves: Vec<([usize; 2], Curve)>,
    /// The names that the pieces inherit.
    pub(crate) names: Vec<([usize; 2], &'m str)>,
    /// The vertex that cuts an edge.
    pub(crate) cut: HashMap<usize, usize>,
}

impl Mesh {
    /// Cuts the edges for which `at` gives a parameter, in the edge's own direction.
    pub(crate) fn split_edges(&self, at: impl Fn(usize) -> Option<f64>) -> Split<'_> {
        let vertices = self.vertices.clone();
        let (quads, curves) = (Vec::with_capacity(self.cells.len()), Vec::new());
        let mut split = Split { vertices, quads, curves, names: Vec::new(), cut: HashMap::new() };
        for (e, own) in self.edges.iter().enumerate() {
            let [a, b] = own.vertices;
            let mut pieces = vec![([a, b], own.curve)];
            if let Some(at) = at(e) {
                let v = split.vertices.len();
                split.vertices.push(own.curve.point(at));
                split.cut.insert(e, v);
                pieces = vec![([a, v], own.curve.part(-1.0, at)), ([v, b], own.curve.part(at, 1.0))];
            }
            for tag in &own.tags {
                split.names.extend(pieces.iter().map(|(walk, _)| (*walk, self.boundaries[*tag].as_str())));
            }
            split.curves.extend(pieces);
        }
        split
    }
}

impl Split<'_> {
    /// The mesh of the cells that were added, before they are checked.
    pub(crate) fn joined(self) -> Result<Mesh, Error> {
        Mesh::joined(self.vertices, &self.quads, &self.curves, &self.names)
    }
}
