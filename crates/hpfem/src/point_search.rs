//! Which cell holds a point.

use crate::box_tree::{Bounds, BoxTree};
use crate::error::Error;
use crate::mesh::{Cell, Mesh, blend, distance};
use crate::triangle::collapsed;

/// Finds the cells of a mesh that hold points, in about a microsecond a point: a tree of boxes around the cells names the few that may,
/// Newton's method on their maps says which does.
#[derive(Clone, Debug)]
pub struct PointSearch<'a> {
    mesh: &'a Mesh,
    boxes: CellBoxes,
}

/// The boxes of a search, without the mesh.
#[derive(Clone, Debug)]
pub(crate) struct CellBoxes {
    tree: BoxTree,
    /// How far each cell reaches beyond its corners, by component.
    off: Vec<[f64; 2]>,
}

impl<'a> PointSearch<'a> {
    /// Puts boxes around the cells of a mesh. They hold the curved edges for certain, by bounds on their distance from the chords.
    pub fn new(mesh: &'a Mesh) -> PointSearch<'a> {
        PointSearch { mesh, boxes: CellBoxes::new(mesh) }
    }

    /// The cell that holds a point (mm) and the reference coordinates there, `(cell, xi, eta)`. On an edge or vertex that cells share
    /// it is the first of these. Points outside count as inside up to 1e-9 of the size of a cell, or the round-off of their coordinates.
    ///
    /// # Errors
    /// [`Error::OutsideMesh`].
    pub fn locate(&self, x: [f64; 2]) -> Result<(usize, f64, f64), Error> {
        self.boxes.locate(self.mesh, x)
    }
}

impl CellBoxes {
    pub(crate) fn new(mesh: &Mesh) -> CellBoxes {
        let off: Vec<[f64; 2]> = (0..mesh.cells.len()).map(|cell| reach(mesh, cell)).collect();
        let corners = |cell: &Cell| Bounds::around(cell.vertices().iter().map(|v| mesh.vertices[*v]));
        let boxes = mesh.cells.iter().zip(&off).map(|(cell, off)| corners(cell).widened(*off)).collect();
        CellBoxes { tree: BoxTree::new(boxes), off }
    }

    /// As [`PointSearch::locate`], on the mesh that the boxes were made of.
    pub(crate) fn locate(&self, mesh: &Mesh, x: [f64; 2]) -> Result<(usize, f64, f64), Error> {
        let mut near = Vec::new();
        self.tree.holding(x, &mut near);
        let hit = |cell: &usize| {
            let place = if self.beyond_edge(mesh, *cell, x) { None } else { reference_point(mesh, *cell, x) };
            place.map(|(xi, eta)| (*cell, xi, eta))
        };
        near.iter().find_map(hit).ok_or(Error::OutsideMesh { x: x[0], z: x[1] })
    }

    /// The first cell other than `own` that holds a point well inside, farther from its edges than a millionth of its size.
    pub(crate) fn other_cell(&self, mesh: &Mesh, own: Option<usize>, x: [f64; 2], near: &mut Vec<usize>) -> Option<usize> {
        const INSIDE: f64 = 1.0 - 1e-6;
        self.tree.holding(x, near);
        near.retain(|cell| Some(*cell) != own && !self.beyond_edge(mesh, *cell, x));
        let inside = |cell: &usize| {
            let at = reference_point(mesh, *cell, x);
            at.is_some_and(|(xi, eta)| xi.abs() < INSIDE && eta.abs() < INSIDE)
        };
        near.iter().copied().find(inside)
    }

    /// Whether a point lies on the far side of one of the edges of a cell, beyond everything that the cell may reach.
    fn beyond_edge(&self, mesh: &Mesh, cell: usize, x: [f64; 2]) -> bool {
        let (own, off) = (&mesh.cells[cell], self.off[cell]);
        let corners = own.corners.map(|v| mesh.vertices[v]);
        let n = own.vertices().len();
        (0..n).any(|k| {
            let (a, b) = (corners[k], corners[(k + 1) % n]);
            let out = [b[1] - a[1], a[0] - b[0]];
            let far = |p: [f64; 2]| out[0] * (p[0] - a[0]) + out[1] * (p[1] - a[1]);
            let reached = corners.iter().fold(0.0_f64, |m, c| m.max(far(*c)));
            far(x) > reached + out[0].abs() * off[0] + out[1].abs() * off[1]
        })
    }
}

/// How far a cell reaches beyond the box, or any other convex set, that holds its corners. The blended map of a quadrilateral adds at
/// most the larger offset of each pair of opposite edges to a mean of the corners, that of a triangle at most its three offsets.
fn reach(mesh: &Mesh, cell: usize) -> [f64; 2] {
    let own = &mesh.cells[cell];
    let bulge = |local: usize| own.edges[local].map_or([0.0; 2], |e| mesh.edges[e].curve.bulge());
    let [a, b, c, d] = [0, 1, 2, 3].map(bulge);
    let corners = own.corners.map(|v| mesh.vertices[v]);
    let size = distance(corners[0], corners[2]) + distance(corners[1], corners[3]);
    let place = corners.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    // More than what `reference_point` lets pass.
    let more = 1e-8 * size + 64.0 * f64::EPSILON * place;
    [0, 1].map(|i| more + if own.is_triangle() { a[i] + b[i] + d[i] } else { a[i].max(c[i]) + b[i].max(d[i]) })
}

/// The reference coordinates of a point in a cell, by Newton's method; none if it lies outside.
pub(crate) fn reference_point(mesh: &Mesh, cell: usize, x: [f64; 2]) -> Option<(f64, f64)> {
    let own = &mesh.cells[cell];
    let first = mesh.vertices[own.corners[0]];
    let size = own.vertices().iter().map(|v| distance(mesh.vertices[*v], first)).fold(0.0, f64::max);
    let triangle = own.is_triangle();
    let corners = own.corners.map(|v| mesh.vertices[v]);
    let edges = [0, 1, 2, 3].map(|e| mesh.local_curve(cell, e));
    // Newton's method in the cell's own coordinates, in which the map of a triangle is regular up to its corners.
    let map = |[a, b]: [f64; 2]| match triangle {
        true => mesh.reference_map(cell, [1.0 - a - b, a, b]),
        false => blend(&corners, [edges[0].jet(a), edges[1].jet(b), edges[2].jet(a), edges[3].jet(b)], a, b),
    };
    let mut t = if triangle { [1.0 / 3.0; 2] } else { [0.0; 2] };
    let mut last = f64::INFINITY;
    for _ in 0..50 {
        let (at, [[a, b], [c, d]]) = map(t);
        let det = a * d - b * c;
        let r = [x[0] - at[0], x[1] - at[1]];
        let step = [(d * r[0] - b * r[1]) / det, (a * r[1] - c * r[0]) / det];
        let next = [(t[0] + step[0]).clamp(-1.5, 1.5), (t[1] + step[1]).clamp(-1.5, 1.5)];
        let (held, length) = (next == t, step[0].abs() + step[1].abs());
        t = next;
        last = length;
        // What is left after a step is of the order of its square.
        if length < 1e-10 || held || length.is_nan() {
            break;
        }
    }
    // A small cell far from the origin never gets there for round-off.
    let round_off = 8.0 * f64::EPSILON * (x[0].abs() + x[1].abs());
    let near = 1e-9 * size + round_off;
    if !(last < 1e-10 || distance(map(t).0, x) < near) {
        return None;
    }
    if triangle {
        let l = [1.0 - t[0] - t[1], t[0], t[1]];
        let (xi, eta) = collapsed(l.map(|v| v.max(0.0)));
        return l.iter().all(|v| *v >= -1e-9).then(|| (xi, eta.clamp(-1.0, 1.0)));
    }
    let within = t.map(|v| v.clamp(-1.0, 1.0));
    // A corner of a cell as small as the round-off of its place is nowhere inside by its coordinates.
    let inside = t.iter().all(|v| v.abs() <= 1.0 + 1e-9) || distance(map(within).0, x) < round_off;
    inside.then_some((within[0], within[1]))
}

/// The middle of a cell.
pub(crate) fn centre(mesh: &Mesh, cell: usize) -> [f64; 2] {
    let own = &mesh.cells[cell];
    let straight = own.sides().all(|(_, e)| mesh.edges[e].curve.is_straight());
    if straight {
        let corners = own.vertices();
        return [0, 1].map(|i| corners.iter().map(|v| mesh.vertices[*v][i]).sum::<f64>() / corners.len() as f64);
    }
    if own.is_triangle() { mesh.reference_map(cell, [1.0 / 3.0; 3]).0 } else { mesh.map(cell, 0.0, 0.0).0 }
}
