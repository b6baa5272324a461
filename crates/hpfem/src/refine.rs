//! Refinement of meshes: geometric towards vertices, and uniform. A mesh never changes; every refinement is a new one.

use crate::error::Error;
use crate::mesh::{Mesh, Quad};
use crate::pieces::Pieces;

impl Mesh {
    /// Refines towards the given vertices: `layers` times, every cell that touches such a vertex is cut into a small cell at the
    /// vertex, `ratio` times as large, and two cells around it; a triangle into a small triangle and one quadrilateral. No hanging
    /// nodes arise; cells away from the vertices stay.
    ///
    /// The layer number of a new cell is its parent's plus one per cut that made it smaller, so that degrees may fall with it.
    ///
    /// # Errors
    /// [`Error::TwoGradedCorners`] if a cell touches two of the vertices; [`Error::OutOfRange`] for a ratio outside (0, 1);
    /// [`Error::Beyond`] for a vertex that does not exist; [`Error::FoldedCell`] if a cell cannot be cut.
    pub fn refined_towards(&self, vertices: &[usize], ratio: f64, layers: usize) -> Result<Mesh, Error> {
        in_range(ratio)?;
        self.check_graded(vertices)?;
        if layers == 0 {
            self.check_cells()?;
            return Ok(self.clone());
        }
        let mut pieces = Pieces::of(self);
        for _ in 0..layers {
            pieces.cut(vertices, &|_| Ok(ratio))?;
        }
        pieces.joined()
    }

    /// One layer of [`Mesh::refined_towards`] in which each edge at one of the vertices is cut at a ratio of its own, which `ratio` tells of its number: so
    /// the small cells of slender ones may be as long as high.
    ///
    /// # Errors
    /// Those of [`Mesh::refined_towards`].
    pub fn refined_towards_by(&self, vertices: &[usize], ratio: impl Fn(usize) -> f64) -> Result<Mesh, Error> {
        self.check_graded(vertices)?;
        let number = |[a, b]: [usize; 2]| self.edges.iter().position(|edge| edge.vertices == [a, b] || edge.vertices == [b, a]);
        let mut pieces = Pieces::of(self);
        pieces.cut(vertices, &|walk| number(walk).map_or(Ok(0.0), |edge| in_range(ratio(edge))))?;
        pieces.joined()
    }

    /// Whether vertices exist, and no cell touches two of them.
    fn check_graded(&self, vertices: &[usize]) -> Result<(), Error> {
        if let Some(v) = vertices.iter().find(|v| **v >= self.vertices.len()) {
            return Err(Error::Beyond { by: "the refinement".into(), what: "vertex", index: *v, count: self.vertices.len() });
        }
        for (cell, c) in self.cells.iter().enumerate() {
            let mut touched = c.vertices().iter().filter(|v| vertices.contains(v));
            if let (Some(first), Some(second)) = (touched.next(), touched.next()) {
                return Err(Error::TwoGradedCorners { cell, first: *first, second: *second });
            }
        }
        Ok(())
    }

    /// Cuts every cell into four at the middles of its edges; layer numbers stay.
    ///
    /// # Errors
    /// [`Error::FoldedCell`] if a cell cannot be cut.
    pub fn refined(&self) -> Result<Mesh, Error> {
        let mut vertices = self.vertices.clone();
        let mut quads = Vec::with_capacity(4 * self.cells.len());
        let mut curves = Vec::new();
        let mut names: Vec<([usize; 2], &str)> = Vec::new();
        let first = vertices.len();
        for edge in &self.edges {
            let ([a, b], v) = (edge.vertices, vertices.len());
            vertices.push(edge.curve.point(0.0));
            curves.push(([a, v], edge.curve.part(-1.0, 0.0)));
            curves.push(([v, b], edge.curve.part(0.0, 1.0)));
            for tag in &edge.tags {
                let name = self.boundaries[*tag].as_str();
                names.extend([([a, v], name), ([v, b], name)]);
            }
        }
        for (c, cell) in self.cells.iter().enumerate() {
            // Middles of the edges anti-clockwise: corner k is between numbers k - 1 and k.
            let middle: Vec<usize> = cell.sides().map(|(_, e)| first + e).collect();
            let quad = |corners| Quad { corners, material: cell.material, layer: cell.layer };
            if let [a, b, d] = middle[..] {
                let k = cell.corners;
                quads.extend([[k[0], a, d, d], [a, k[1], b, b], [d, b, k[2], k[2]], [a, b, d, d]].map(quad));
                continue;
            }
            let centre = vertices.len();
            vertices.push(self.map(c, 0.0, 0.0).0);
            quads.extend((0..4).map(|k| quad([cell.corners[k], middle[k], centre, middle[(k + 3) % 4]])));
        }
        let mesh = Mesh::joined(vertices, &quads, &curves, &names)?;
        mesh.check_cells()?;
        Ok(mesh)
    }
}

/// A ratio of graded layers, if it is one.
fn in_range(ratio: f64) -> Result<f64, Error> {
    if ratio > 0.0 && ratio < 1.0 {
        return Ok(ratio);
    }
    Err(Error::OutOfRange { quantity: "the ratio of graded layers".into(), value: ratio, range: "in (0, 1)" })
}
