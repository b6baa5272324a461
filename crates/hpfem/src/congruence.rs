//! Cells of one shape.
//!
//! Plane stiffness does not change when a cell is moved, turned, mirrored or scaled, so congruent and similar cells of one material and
//! degree share their condensed matrix. Shapes are compared to round-off: the corners and the middles of the edges, which determine lines and
//! arcs with their parameter, must go over into each other by a similarity of the plane. Triangles share if they are straight: their
//! points of quadrature prefer one corner, which makes no difference then.

use crate::basis::BoundaryModes;
use crate::curve::Curve;
use crate::kinematics::Kinematics;
use crate::material::Material;
use crate::mesh::{CELL_EDGES, Mesh};
use crate::problem::BodyProblem;
use crate::space::Space;
use std::collections::HashMap;

/// Classes with the same numbers ([`invariants`]) that a cell is compared with, the last ones: cells that all differ a little cost no square of their number.
const COMPARED: usize = 32;

/// Cells that share one condensed matrix, and how each lies in the plane compared with the first of them.
#[derive(Clone)]
pub(crate) struct Congruence {
    pub(crate) classes: Vec<Class>,
    /// Class of each cell.
    pub(crate) class: Vec<usize>,
    /// How each cell lies compared with the first of its class.
    pub(crate) turn: Vec<Turn>,
}

/// The cells of one shape, material and degree.
#[derive(Clone)]
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
    /// Lengths of the member over those of the first cell.
    pub(crate) scale: f64,
}

impl Turn {
    /// The member is the first cell itself.
    pub(crate) const NONE: Turn = Turn {
        corner: [0, 1, 2, 3],
        edge: [(0, false), (1, false), (2, false), (3, false)],
        matrix: [[1.0, 0.0], [0.0, 1.0]],
        scale: 1.0,
    };

    /// For each boundary mode of a cell, corners first, the place of its mode in the matrix of its class, and its sign.
    pub(crate) fn sources(&self, boundary: &BoundaryModes, against: [bool; 4], edges: [usize; 4]) -> Vec<(usize, f64)> {
        let mut sources = vec![(0, 1.0); boundary.len()];
        let mut start = boundary.corners;
        for i in 0..4 {
            if i < boundary.corners {
                sources[self.corner[i]].0 = i;
            }
            let (e, reversed) = self.edge[i];
            for (m, source) in sources[boundary.edge(e)].iter_mut().enumerate() {
                let odd = m % 2 == 1;
                *source = (start + m, if odd && reversed != against[e] { -1.0 } else { 1.0 });
            }
            start += edges[i] - 1;
        }
        sources
    }

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

    /// The symmetry of the triangle that takes corner 0 to `start` and keeps or reverses the sense of walking.
    fn of_triangle(start: usize, mirrored: bool) -> Turn {
        let [a, b, c] = std::array::from_fn(|i| if mirrored { start + 3 - i } else { start + i } % 3);
        let mut turn = Turn { corner: [a, b, c, c], ..Turn::NONE };
        for (e, ends) in TRIANGLE_EDGES {
            let image = ends.map(|v| turn.corner[v]);
            for (other, ends) in TRIANGLE_EDGES {
                if ends == image || [ends[1], ends[0]] == image {
                    turn.edge[e] = (other, ends != image);
                }
            }
        }
        turn
    }
}

/// Edges of a triangle and their ends.
const TRIANGLE_EDGES: [(usize, [usize; 2]); 3] = [(0, [0, 1]), (1, [1, 2]), (3, [0, 2])];

/// The points that tell a cell's shape.
struct Outline {
    /// Corners, then middles of the edges; in a triangle the last corner comes twice and the centre stands for the edge it lacks.
    points: [[f64; 2]; 8],
    triangle: bool,
}

impl Congruence {
    /// The classes of the cells of a problem.
    pub(crate) fn of(problem: &BodyProblem, space: &Space) -> Congruence {
        if problem.kinematics.is_revolved() {
            // The radius tells cells apart.
            return Congruence::none(&problem.mesh, space);
        }
        Congruence::of_plane_cells(&problem.mesh, space, &problem.materials, problem.kinematics)
    }

    /// Every cell in a class of its own.
    pub(crate) fn none(mesh: &Mesh, space: &Space) -> Congruence {
        let class = |c| Class { first: c, members: 1, edges: edge_degrees(mesh, space, c) };
        let cells = mesh.cells.len();
        Congruence { classes: (0..cells).map(class).collect(), class: (0..cells).collect(), turn: vec![Turn::NONE; cells] }
    }

    /// Finds the classes of plane cells with straight and circular edges; a cell of a material with directions only joins a class from
    /// which it differs by a turn that its moduli do not see.
    pub(crate) fn of_plane_cells(mesh: &Mesh, space: &Space, materials: &[Material], kinematics: Kinematics) -> Congruence {
        let mut found = Congruence { classes: Vec::new(), class: Vec::new(), turn: Vec::new() };
        let mut outlines: Vec<Option<Outline>> = Vec::new();
        let mut buckets: HashMap<[i64; 8], Vec<usize>> = HashMap::new();
        for (c, cell) in mesh.cells.iter().enumerate() {
            let edges = edge_degrees(mesh, space, c);
            let mut outline = outline(mesh, c);
            let mut hit = None;
            if let Some(outline) = &outline {
                let [a, b, d, least, most] = invariants(outline);
                let (degree, triangle) = (space.cell_degree[c] as i64, i64::from(outline.triangle));
                let key = [a, b, d, least, most, cell.material as i64, degree, triangle];
                let bucket = buckets.entry(key).or_default();
                let material = &materials[cell.material];
                let sees = |turn: &Turn| !material.is_isotropic(kinematics) && !material.is_alike_after(turn.matrix);
                hit = bucket
                    .iter()
                    .rev()
                    .take(COMPARED)
                    .find_map(|k| similarity(outlines[*k].as_ref()?, outline, sees).map(|turn| (*k, turn)));
                if hit.is_none() {
                    bucket.push(found.classes.len());
                }
            }
            let (class, turn) = hit.unwrap_or_else(|| {
                outlines.push(outline.take());
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
    let triangle = c.is_triangle();
    let corners = c.corners.map(|v| mesh.vertices[v]);
    let mut points = [centre(&corners[..c.vertices().len()]); 8];
    points[..4].copy_from_slice(&corners);
    for (local, e) in c.sides() {
        let curve = &mesh.edges[e].curve;
        // Ends and middle determine these two kinds of curves alone.
        if !matches!(curve, Curve::Line { .. } | Curve::Arc { .. }) || triangle && !curve.is_straight() {
            return None;
        }
        points[4 + local] = curve.point(0.0);
    }
    Some(Outline { points, triangle })
}

fn centre(corners: &[[f64; 2]]) -> [f64; 2] {
    std::array::from_fn(|i| corners.iter().map(|x| x[i]).sum::<f64>() / corners.len() as f64)
}

/// Numbers that do not change under similarities and symmetries of the cell, rounded; they only narrow the search. The shortest and the longest side tell cells
/// that are nearly squares apart, which have the other numbers in common.
fn invariants(outline: &Outline) -> [i64; 5] {
    let corners = &outline.points[..if outline.triangle { 3 } else { 4 }];
    let middles = &outline.points[4..];
    let centre = centre(corners);
    let square = |x: &[f64; 2]| (x[0] - centre[0]).powi(2) + (x[1] - centre[1]).powi(2);
    let size: f64 = corners.iter().map(square).sum();
    let relative = |x: &[f64; 2]| square(x) / size;
    let apart: f64 = corners.iter().map(|x| relative(x).powi(2)).sum();
    let middle: f64 = middles.iter().map(relative).sum();
    let spread: f64 = middles.iter().map(|x| relative(x).powi(2)).sum();
    let sides = (0..corners.len()).map(|k| {
        let ([a, b], [c, d]) = (corners[k], corners[(k + 1) % corners.len()]);
        (c - a).hypot(d - b) / size.sqrt()
    });
    let [least, most] = sides.fold([f64::INFINITY, 0.0], |[least, most], side| [least.min(side), f64::max(most, side)]);
    [apart, middle, spread, least, most].map(|v| (1e6 * v).round() as i64)
}

/// A similarity that takes one outline to another and that the material does not see, if there is one.
fn similarity(first: &Outline, member: &Outline, sees: impl Fn(&Turn) -> bool) -> Option<Turn> {
    let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let corners = if first.triangle { 3 } else { 4 };
    let of_cell = if first.triangle { Turn::of_triangle } else { Turn::of_square };
    let (first, member) = (&first.points, &member.points);
    let extent = member.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    for start in 0..2 * corners {
        let mirrored = start >= corners;
        let mut turn = of_cell(start % corners, mirrored);
        // As complex numbers: member = factor * first, or factor * conjugate(first).
        let side = if mirrored { -1.0 } else { 1.0 };
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
            turn.scale = length;
            if !sees(&turn) {
                return Some(turn);
            }
        }
    }
    None
}
