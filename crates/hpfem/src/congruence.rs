//! Cells of one shape.
//!
//! Plane stiffness does not change when a cell is moved, turned, mirrored or scaled, so congruent and similar cells of one material and
//! degree share their condensed matrix. Shapes are compared to round-off: the corners and the middles of the edges, which determine lines and
//! arcs with their parameter, must go over into each other by a similarity of the plane.

use crate::curve::Curve;
use crate::mesh::{CELL_EDGES, Mesh};
use crate::space::Space;
use std::collections::HashMap;

/// Cells that share one condensed matrix, and how each lies in the plane compared with the first of them.
pub(crate) struct Congruence {
    pub(crate) classes: Vec<Class>,
    /// Class of each cell.
    pub(crate) class: Vec<usize>,
    /// How each cell lies compared with the first of its class.
    pub(crate) turn: Vec<Turn>,
}

/// The cells of one shape, material and degree.
pub(crate) struct Class {
    /// The first of them.
    pub(crate) first: usize,
    /// Number of cells.
    pub(crate) members: usize,
    /// Largest degree that any member has on each edge, in the numbering of the first cell.
    pub(crate) edges: [usize; 4],
}

/// A symmetry of the reference square followed by a rotation or reflection of the plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    /// Corner of the member at each corner of the first cell.
    pub(crate) corner: [usize; 4],
    /// Edge of the member at each edge of the first cell, and whether it is walked the other way.
    pub(crate) edge: [(usize, bool); 4],
    /// Takes displacements of the first cell to displacements of the member.
    pub(crate) matrix: [[f64; 2]; 2],
}

impl Turn {
    /// The member is the first cell itself.
    pub(crate) const NONE: Turn =
        Turn { corner: [0, 1, 2, 3], edge: [(0, false), (1, false), (2, false), (3, false)], matrix: [[1.0, 0.0], [0.0, 1.0]] };

    /// The symmetry of the square that takes corner 0 to `start` and keeps or reverses the sense of walking.
    fn of_square(start: usize, mirrored: bool) -> Turn {
        let corner = std::array::from_fn(|i| if mirrored { start + 4 - i } else { start + i } % 4);
        let mut turn = Turn { corner, ..Turn::NONE };
        for (edge, ends) in turn.edge.iter_mut().zip(CELL_EDGES) {
            let image = ends.map(|v| corner[v]);
            for (e, other) in CELL_EDGES.iter().enumerate() {
                if *other == image || [other[1], other[0]] == image {
                    *edge = (e, *other != image);
                }
            }
        }
        turn
    }
}

/// Corners, then middles of the edges.
type Outline = [[f64; 2]; 8];

impl Congruence {
    /// Every cell in a class of its own.
    pub(crate) fn none(mesh: &Mesh, space: &Space) -> Congruence {
        let class = |c| Class { first: c, members: 1, edges: edge_degrees(mesh, space, c) };
        let cells = mesh.cells.len();
        Congruence { classes: (0..cells).map(class).collect(), class: (0..cells).collect(), turn: vec![Turn::NONE; cells] }
    }

    /// Finds the classes of plane cells with straight and circular edges.
    pub(crate) fn of_plane_cells(mesh: &Mesh, space: &Space) -> Congruence {
        let mut found = Congruence { classes: Vec::new(), class: Vec::new(), turn: Vec::new() };
        let mut outlines: Vec<Outline> = Vec::new();
        let mut buckets: HashMap<[i64; 5], Vec<usize>> = HashMap::new();
        for (c, cell) in mesh.cells.iter().enumerate() {
            let edges = edge_degrees(mesh, space, c);
            let outline = outline(mesh, c);
            let mut hit = None;
            if let Some(outline) = &outline {
                let [a, b, d] = invariants(outline);
                let key = [a, b, d, cell.material as i64, space.cell_degree[c] as i64];
                let bucket = buckets.entry(key).or_default();
                hit = bucket.iter().find_map(|k| similarity(&outlines[*k], outline).map(|turn| (*k, turn)));
                if hit.is_none() {
                    bucket.push(found.classes.len());
                }
            }
            let (class, turn) = hit.unwrap_or_else(|| {
                outlines.push(outline.unwrap_or_default());
                found.classes.push(Class { first: c, members: 0, edges });
                (found.classes.len() - 1, Turn::NONE)
            });
            let shared = &mut found.classes[class];
            shared.members += 1;
            for (degree, (e, _)) in shared.edges.iter_mut().zip(turn.edge) {
                *degree = edges[e].max(*degree);
            }
            found.class.push(class);
            found.turn.push(turn);
        }
        found
    }
}

fn edge_degrees(mesh: &Mesh, space: &Space, cell: usize) -> [usize; 4] {
    space.edge_degrees(mesh, cell)
}

fn outline(mesh: &Mesh, cell: usize) -> Option<Outline> {
    let c = &mesh.cells[cell];
    let mut points = [[0.0; 2]; 8];
    for i in 0..4 {
        // Triangles stay alone.
        let curve = &mesh.edges[c.edges[i]?].curve;
        if matches!(curve, Curve::Polynomial { .. }) {
            return None;
        }
        points[i] = mesh.vertices[c.corners[i]];
        points[4 + i] = curve.point(0.0);
    }
    Some(points)
}

/// Numbers that do not change under similarities and symmetries of the square, rounded; they only narrow the search.
fn invariants(outline: &Outline) -> [i64; 3] {
    let centre: [f64; 2] = std::array::from_fn(|i| outline[..4].iter().map(|x| 0.25 * x[i]).sum());
    let square = |x: &[f64; 2]| (x[0] - centre[0]).powi(2) + (x[1] - centre[1]).powi(2);
    let size: f64 = outline[..4].iter().map(square).sum();
    let relative = |x: &[f64; 2]| square(x) / size;
    let corners: f64 = outline[..4].iter().map(|x| relative(x).powi(2)).sum();
    let middles: f64 = outline[4..].iter().map(relative).sum();
    let spread: f64 = outline[4..].iter().map(|x| relative(x).powi(2)).sum();
    [corners, middles, spread].map(|v| (1e6 * v).round() as i64)
}

/// The similarity that takes one outline to another, if there is one.
fn similarity(first: &Outline, member: &Outline) -> Option<Turn> {
    let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let extent = member.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    for start in 0..8 {
        let mut turn = Turn::of_square(start % 4, start >= 4);
        // As complex numbers: member = factor * first, or factor * conjugate(first).
        let side = if start >= 4 { -1.0 } else { 1.0 };
        let from = |k: usize| {
            let d = minus(first[k], first[0]);
            [d[0], side * d[1]]
        };
        let to = |k: usize| {
            let image = if k < 4 { turn.corner[k] } else { 4 + turn.edge[k - 4].0 };
            minus(member[image], member[turn.corner[0]])
        };
        let (a, b) = (from(2), to(2));
        let square = a[0] * a[0] + a[1] * a[1];
        let factor = [(a[0] * b[0] + a[1] * b[1]) / square, (a[0] * b[1] - a[1] * b[0]) / square];
        let size = b[0].hypot(b[1]);
        let round_off = (1e-13 * size + 16.0 * f64::EPSILON * extent).min(1e-9 * size);
        let matches = (1..8).all(|k| {
            let (a, b) = (from(k), to(k));
            let image = [factor[0] * a[0] - factor[1] * a[1], factor[0] * a[1] + factor[1] * a[0]];
            let miss = minus(image, b);
            miss[0].abs().max(miss[1].abs()) <= round_off
        });
        if matches {
            let length = factor[0].hypot(factor[1]);
            let (cos, sin) = (factor[0] / length, factor[1] / length);
            turn.matrix = [[cos, -side * sin], [sin, side * cos]];
            return Some(turn);
        }
    }
    None
}
