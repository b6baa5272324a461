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
        self.check_apart(&neighbours, |_, _| true)?;
        let piece = self.pieces(&neighbours);
        piece.iter().position(|p| *p != 0).map_or(Ok(()), |cell| Err(self.other_piece(cell)))
    }

    /// What lets a held body move like a hinge: two pieces without a common edge, one of which has a vertex that hangs on an edge of the other, or
    /// which share a vertex. None if there are no such pieces.
    pub(crate) fn hinge(&self) -> Option<Error> {
        let neighbours = self.edge_cells();
        let piece = self.pieces(&neighbours);
        if let Err(hanging) = self.check_apart(&neighbours, |cell, other| piece[cell] != piece[other]) {
            return Some(hanging);
        }
        let mut first: Vec<Option<usize>> = vec![None; self.vertices.len()];
        for (c, cell) in self.cells.iter().enumerate() {
            for v in cell.vertices() {
                let known = *first[*v].get_or_insert(c);
                if piece[known] != piece[c] {
                    return Some(self.other_piece(if piece[c] == 0 { known } else { c }));
                }
            }
        }
        None
    }

    /// Refuses vertices on edges that they do not belong to, where the cell of the edge and one of the vertex `count`.
    fn check_apart(&self, neighbours: &[Vec<(usize, usize)>], count: impl Fn(usize, usize) -> bool) -> Result<(), Error> {
        let outer: Vec<usize> = (0..self.edges.len()).filter(|e| neighbours[*e].len() == 1).collect();
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
                let near = || off(&edge.curve, place) <= NEAR * lengths[**k].min(shortest);
                !edge.vertices.contains(&vertex) && count(neighbours[outer[**k]][0].0, other) && near()
            };
            if let Some(k) = near.iter().find(on) {
                let [x, z] = place;
                return Err(Error::TouchingApart { vertex, cell: neighbours[outer[*k]][0].0, other, x, z });
            }
        }
        Ok(())
    }

    /// For each cell the first one of its piece, from which it can be reached across edges.
    fn pieces(&self, neighbours: &[Vec<(usize, usize)>]) -> Vec<usize> {
        let mut piece = vec![usize::MAX; self.cells.len()];
        let mut open = Vec::new();
        for first in 0..self.cells.len() {
            open.push(first);
            while let Some(c) = open.pop() {
                if piece[c] == usize::MAX {
                    piece[c] = first;
                    open.extend(self.cells[c].sides().flat_map(|(_, e)| neighbours[e].iter().map(|(cell, _)| *cell)));
                }
            }
        }
        piece
    }

    /// Says that a cell is in another piece than the first one.
    fn other_piece(&self, cell: usize) -> Error {
        let [x, z] = self.vertices[self.cells[cell].corners[0]];
        Error::Pieces { cell, x, z }
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
