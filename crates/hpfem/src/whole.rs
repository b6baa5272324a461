//! Whether a mesh is one body: its cells share the edges and vertices along which they touch, and all are joined by edges.

use crate::box_tree::{Bounds, BoxTree};
use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::{Mesh, distance};

/// Share of the edges within which a vertex lies on another edge: mesh files have few digits.
const NEAR: f64 = 1e-6;

impl Mesh {
    /// Refuses a mesh that is not one body: a vertex of the boundary that lies on an edge of the boundary it is no end of (a hanging
    /// node, or nodes written twice), and cells that no common edges join to the others. Meshes from elsewhere are worth this check,
    /// which [`Mesh::new`] leaves to the user: along such edges a body is solved as if it were cut there. A slit whose faces lie on
    /// each other is refused too, since it looks the same.
    ///
    /// # Errors
    /// [`Error::TouchingApart`] and [`Error::Pieces`], each with its place.
    pub fn check_whole(&self) -> Result<(), Error> {
        let neighbours = self.edge_cells();
        let outer: Vec<usize> = (0..self.edges.len()).filter(|e| neighbours[*e].len() == 1).collect();
        self.check_apart(&neighbours, &outer)?;
        self.check_joined(&neighbours)
    }

    /// Refuses vertices on edges that they do not belong to.
    fn check_apart(&self, neighbours: &[Vec<(usize, usize)>], outer: &[usize]) -> Result<(), Error> {
        // For each vertex of the boundary its shortest edge there and a cell of it.
        let mut at: Vec<Option<(f64, usize)>> = vec![None; self.vertices.len()];
        let lengths: Vec<f64> = outer.iter().map(|e| self.edges[*e].curve.length()).collect();
        for (e, length) in outer.iter().zip(&lengths) {
            for v in self.edges[*e].vertices {
                if at[v].is_none_or(|(shortest, _)| *length < shortest) {
                    at[v] = Some((*length, neighbours[*e][0].0));
                }
            }
        }
        let boxes = outer.iter().zip(&lengths).map(|(e, length)| {
            let (ends, [x, z]) = (self.edges[*e].vertices.map(|v| self.vertices[v]), self.edges[*e].curve.bulge());
            Bounds::around(ends).widened([x + NEAR * length, z + NEAR * length])
        });
        let tree = BoxTree::new(boxes.collect());
        let mut near = Vec::new();
        for (vertex, own) in at.iter().enumerate().filter_map(|(v, own)| Some((v, (*own)?))) {
            let (place, (shortest, other)) = (self.vertices[vertex], own);
            tree.holding(place, &mut near);
            let on = |k: &&usize| {
                let edge = &self.edges[outer[**k]];
                !edge.vertices.contains(&vertex) && off(&edge.curve, place) <= NEAR * lengths[**k].min(shortest)
            };
            if let Some(k) = near.iter().find(on) {
                let [x, z] = place;
                return Err(Error::TouchingApart { vertex, cell: neighbours[outer[*k]][0].0, other, x, z });
            }
        }
        Ok(())
    }

    /// Refuses cells that cannot be reached from the first one across edges.
    fn check_joined(&self, neighbours: &[Vec<(usize, usize)>]) -> Result<(), Error> {
        let mut reached = vec![false; self.cells.len()];
        let mut open = vec![0];
        while let Some(c) = open.pop() {
            if c < reached.len() && !std::mem::replace(&mut reached[c], true) {
                open.extend(self.cells[c].sides().flat_map(|(_, e)| neighbours[e].iter().map(|(cell, _)| *cell)));
            }
        }
        let Some(cell) = reached.iter().position(|r| !r) else { return Ok(()) };
        let [x, z] = self.vertices[self.cells[cell].corners[0]];
        Err(Error::Pieces { cell, x, z })
    }
}

/// Distance of a point from a curve.
fn off(curve: &Curve, x: [f64; 2]) -> f64 {
    let from = |t: f64| distance(curve.point(t), x);
    let starts = (0..=16).map(|k| f64::from(k) / 8.0 - 1.0);
    let mut t = starts.min_by(|a, b| from(*a).total_cmp(&from(*b))).unwrap_or(0.0);
    // Next to the curve this is Newton's method.
    for _ in 0..20 {
        let (p, d) = curve.jet(t);
        let along = (x[0] - p[0]) * d[0] + (x[1] - p[1]) * d[1];
        let next = (t + along / (d[0] * d[0] + d[1] * d[1])).clamp(-1.0, 1.0);
        if next.is_nan() || (next - t).abs() < 1e-14 {
            break;
        }
        t = next;
    }
    from(t)
}
