//! Refinement towards boundaries, for thin layers and boundary layers.

use crate::blocks::between;
use crate::curve::{CURVE_DEGREE, Curve};
use crate::error::Error;
use crate::mesh::{CELL_EDGES, Cell, Mesh, Quad};
use crate::split::Split;
use std::collections::HashSet;

/// The boundary that a mesh is refined towards.
struct Strip<'b> {
    boundary: &'b str,
    /// Width of the thin cells as a share of the cells that they are cut from.
    ratio: f64,
    edges: HashSet<usize>,
    /// Vertices of the edges.
    vertices: HashSet<usize>,
}

impl Mesh {
    /// Refines towards the edges of a boundary: `layers` times, every cell with an edge there is cut along it into a thin cell, `ratio`
    /// times as wide, and the rest; a quadrilateral in a corner between two such edges is cut along both, and a cell that only
    /// touches an end of the boundary as by [`Mesh::refined_towards`]. No hanging nodes arise. Layer numbers stay: across such layers
    /// the degree need not fall.
    ///
    /// # Errors
    /// [`Error::NoSuchBoundary`]; [`Error::OutOfRange`] for a ratio outside (0, 1); [`Error::BetweenGradedEdges`] if a cell reaches
    /// from one side of the boundary to another; [`Error::FoldedCell`] if a cell cannot be cut.
    pub fn refined_towards_edges(&self, boundary: &str, ratio: f64, layers: usize) -> Result<Mesh, Error> {
        if !(ratio > 0.0 && ratio < 1.0) {
            let quantity = "the ratio of graded layers".into();
            return Err(Error::OutOfRange { quantity, value: ratio, range: "in (0, 1)" });
        }
        let mut mesh = self.clone();
        for _ in 0..layers {
            mesh = mesh.cut_along(boundary, ratio)?;
        }
        mesh.check_cells()?;
        Ok(mesh)
    }

    /// One cut of [`Mesh::refined_towards_edges`].
    fn cut_along(&self, boundary: &str, ratio: f64) -> Result<Mesh, Error> {
        let graded: HashSet<usize> = self.boundary(boundary)?.into_iter().collect();
        let touched: HashSet<usize> = graded.iter().flat_map(|e| self.edges[*e].vertices).collect();
        let mut split = self.split_edges(|e| {
            let [a, b] = self.edges[e].vertices;
            match (touched.contains(&a), touched.contains(&b)) {
                (true, false) => Some(2.0 * ratio - 1.0),
                (false, true) => Some(1.0 - 2.0 * ratio),
                _ => None,
            }
        });
        let strip = Strip { boundary, ratio, edges: graded, vertices: touched };
        (0..self.cells.len()).try_for_each(|c| self.cut_cell(c, &strip, &mut split))?;
        split.joined()
    }

    /// Adds the pieces of a cell.
    fn cut_cell(&self, c: usize, strip: &Strip<'_>, split: &mut Split<'_>) -> Result<(), Error> {
        let Split { vertices, quads, curves, cut, .. } = split;
        let cell = &self.cells[c];
        let quad = |corners| Quad { corners, material: cell.material, layer: cell.layer };
        let n = cell.vertices().len();
        let k = |i: usize| cell.corners[i % n];
        let side = |i: usize| cell.leaving(i % n)[0];
        let edge = |i: usize| cell.edges[side(i)];
        let on = |i: usize| edge(i).is_some_and(|e| strip.edges.contains(&e));
        // The cut of the edge from corner i to the next.
        let m = |i: usize| edge(i).and_then(|e| cut.get(&e).copied());
        let near = (0..n).filter(|i| strip.vertices.contains(&k(*i))).count();
        let start = (0..n).find(|i| on(*i) && !on(i + n - 1)).or((0..n).find(|i| strip.vertices.contains(&k(*i))));
        let Some(i) = start else {
            quads.push(quad(cell.corners));
            return Ok(());
        };
        let sides = (0..n).filter(|i| on(*i)).count();
        let refused = || Error::BetweenGradedEdges { cell: c, boundary: strip.boundary.to_string() };
        match (near, sides, n) {
            // The end of the boundary in corner i.
            (1, 0, 3) => {
                let (a, b) = (m(i).ok_or_else(refused)?, m(i + 2).ok_or_else(refused)?);
                quads.extend([quad([k(i), a, b, b]), quad([a, k(i + 1), k(i + 2), b])]);
            }
            (1, 0, _) => {
                let (a, b) = (m(i).ok_or_else(refused)?, m(i + 3).ok_or_else(refused)?);
                let centre = vertices.len();
                vertices.push(self.corner_point(c, i, [strip.ratio; 2]));
                quads.push(quad([k(i), a, centre, b]));
                quads.extend([quad([a, k(i + 1), k(i + 2), centre]), quad([b, centre, k(i + 2), k(i + 3)])]);
            }
            // Along the edge from corner i.
            (2, 1, _) => {
                let (a, b) = (m(i + n - 1).ok_or_else(refused)?, m(i + 1).ok_or_else(refused)?);
                curves.push(([a, b], self.parallel(cell, c, side(i), strip.ratio)));
                quads.push(quad([k(i), k(i + 1), b, a]));
                quads.push(if n == 3 { quad([a, b, k(i + 2), k(i + 2)]) } else { quad([a, b, k(i + 2), k(i + 3)]) });
            }
            // Along the edges before and after corner i + 1.
            (3, 2, 4) => {
                let (a, b) = (m(i + 2).ok_or_else(refused)?, m(i + 3).ok_or_else(refused)?);
                let centre = vertices.len();
                vertices.push(self.corner_point(c, i + 1, [strip.ratio; 2]));
                quads.extend([quad([k(i), k(i + 1), centre, b]), quad([k(i + 1), k(i + 2), a, centre])]);
                quads.push(quad([b, centre, a, k(i + 3)]));
            }
            _ => return Err(refused()),
        }
        Ok(())
    }

    /// The point of a quadrilateral at the given shares of the way from a corner to the opposite one, in both directions.
    fn corner_point(&self, cell: usize, corner: usize, share: [f64; 2]) -> [f64; 2] {
        const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let near = CORNERS[corner % 4];
        self.map(cell, near[0] * (1.0 - 2.0 * share[0]), near[1] * (1.0 - 2.0 * share[1])).0
    }

    /// The curve of a cell at the share `ratio` of the way from its local edge `side` to what lies opposite, walked as the edge is when
    /// the cell lies on its left.
    fn parallel(&self, cell: &Cell, number: usize, side: usize, ratio: f64) -> Curve {
        // Edges 2 and 3 are walked clockwise.
        let along = if side < 2 { 1.0 } else { -1.0 };
        if cell.is_triangle() {
            let [from, to] = CELL_EDGES[side].map(|k| k.min(2));
            let (from, to) = if side < 2 { (from, to) } else { (to, from) };
            let point = |t: f64| {
                let mut l = [ratio; 3];
                l[from] = 0.5 * (1.0 - t) * (1.0 - ratio);
                l[to] = 0.5 * (1.0 + t) * (1.0 - ratio);
                self.reference_map(number, l).0
            };
            let straight = cell.sides().all(|(_, e)| self.edges[e].curve.is_straight());
            return if straight {
                Curve::Line { start: point(-1.0), end: point(1.0) }
            } else {
                Curve::interpolated(CURVE_DEGREE, point)
            };
        }
        let level = 2.0 * ratio - 1.0;
        let point = |t: f64| {
            let s = along * t;
            let (xi, eta) = [(s, level), (-level, s), (s, -level), (level, s)][side];
            self.map(number, xi, eta).0
        };
        let (own, opposite) = (self.local_curve(number, side), self.local_curve(number, (side + 2) % 4));
        let rungs = [(side + 1) % 4, (side + 3) % 4].map(|e| self.local_curve(number, e).is_straight());
        if rungs == [true; 2] {
            if own.is_straight() && opposite.is_straight() {
                return Curve::Line { start: point(-1.0), end: point(1.0) };
            }
            if let Some(arc) = between(&own, &opposite, ratio) {
                return if side < 2 { arc } else { arc.reversed() };
            }
        }
        Curve::interpolated(CURVE_DEGREE, point)
    }
}
