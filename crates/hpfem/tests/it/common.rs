//! Meshes and solvers that many tests share.

use hpfem::*;
use std::f64::consts::PI;

pub(crate) const PLANE_STRAIN: Kinematics = Kinematics::PlaneStrain { thickness: 1.3 };
pub(crate) const PLANE_STRESS: Kinematics = Kinematics::PlaneStress { thickness: 0.7 };

/// How the inner and outer edges of [`patch`] run.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    /// Straight edges, distorted cells.
    Straight,
    /// Circular arcs.
    Arcs,
    /// Polynomial edges of the given degree.
    Polynomial(usize),
}

/// Four cells around a point, all distorted, on about `[1, 3] x [0, 2]` (moved by `left` along the first axis); cell `i` has its
/// corners turned by `turns[i]` places.
///
/// ```text
///   6 --- 7 --- 8      boundaries: bottom, right, top, left; "all" is everything
///   | c2  | c3  |
///   3 --- 4 --- 5
///   | c0  | c1  |
///   0 --- 1 --- 2
/// ```
pub(crate) fn patch(turns: [usize; 4], shape: Shape, left: f64) -> Mesh {
    patch_of(turns, [false; 4], shape, left)
}

/// The same with cells c1 and c2 cut into two triangles each, along 1-5 and 3-7; `turns` are taken modulo 3 in a triangle.
pub(crate) fn mixed(turns: [usize; 4], shape: Shape, left: f64) -> Mesh {
    patch_of(turns, [false, true, true, false], shape, left)
}

/// The patch with those quadrilaterals cut into two triangles that `split` says; the second of the two is turned by one more.
pub(crate) fn patch_of(turns: [usize; 4], split: [bool; 4], shape: Shape, left: f64) -> Mesh {
    let vertices: Vec<[f64; 2]> =
        [[1.0, 0.1], [2.1, 0.0], [3.0, -0.1], [1.0, 1.2], [1.85, 0.9], [2.9, 1.1], [1.0, 2.0], [2.2, 2.1], [3.1, 1.9]]
            .map(|[x, z]| [x - left, z])
            .to_vec();
    let corners = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]];
    let cell = |corners| Quad { corners, material: 0, layer: 0 };
    let mut quads = Vec::new();
    let mut diagonals = Vec::new();
    for ((c, turn), split) in corners.iter().zip(turns).zip(split) {
        if split {
            let triangle = |k: [usize; 3], turn: usize| {
                let [a, b, c] = std::array::from_fn(|i| k[(i + turn) % 3]);
                cell([a, b, c, c])
            };
            quads.extend([triangle([c[0], c[1], c[2]], turn), triangle([c[0], c[2], c[3]], turn + 1)]);
            diagonals.push([c[0], c[2]]);
        } else {
            quads.push(cell(std::array::from_fn(|i| c[(i + turn) % 4])));
        }
    }
    let outer = [[0, 1, 0], [1, 2, 0], [2, 5, 1], [5, 8, 1], [7, 8, 2], [6, 7, 2], [0, 3, 3], [3, 6, 3]];
    let inner = [[1, 4], [4, 7], [3, 4], [4, 5]];
    let all: Vec<[usize; 2]> = outer.iter().map(|[a, b, _]| [*a, *b]).chain(inner).chain(diagonals).collect();
    let curves: Vec<([usize; 2], Curve)> = all
        .iter()
        .enumerate()
        // The edges on the left stay straight: they may lie on the axis.
        .filter(|(i, _)| shape != Shape::Straight && *i != 6 && *i != 7)
        .map(|(i, e)| {
            (*e, bowed(vertices[e[0]], vertices[e[1]], if i < 12 { 0.12 } else { 0.03 } * (1.0 + i as f64).sin(), shape))
        })
        .collect();
    let names = ["bottom", "right", "top", "left"];
    let mut named: Vec<([usize; 2], &str)> = outer.iter().map(|[a, b, n]| ([*a, *b], names[*n])).collect();
    named.extend(outer.iter().map(|[a, b, _]| ([*a, *b], "all")));
    Mesh::new(vertices, &quads, &curves, &named).unwrap()
}

/// A curve from `a` to `b` whose middle is off the chord by `bow` times its length.
fn bowed(a: [f64; 2], b: [f64; 2], bow: f64, shape: Shape) -> Curve {
    let (dx, dz) = (b[0] - a[0], b[1] - a[1]);
    match shape {
        Shape::Polynomial(degree) => Curve::interpolated(degree, |t| {
            let s = 0.5 * (1.0 + t);
            let off = bow * (1.0 - t * t) * (1.0 + 0.3 * t + 0.2 * t * t);
            let along = if degree > 2 { 0.05 * (1.0 - t * t) } else { 0.0 };
            [a[0] + (s + along) * dx - off * dz, a[1] + (s + along) * dz + off * dx]
        }),
        _ => {
            // Half the opening angle from tan(angle / 2) = 2 bow.
            let half = 2.0 * (2.0 * bow).atan();
            let chord = dx.hypot(dz);
            let radius = 0.5 * chord / half.abs().sin();
            let height = 0.5 * chord / half.tan();
            let centre = [0.5 * (a[0] + b[0]) + height * dz / chord, 0.5 * (a[1] + b[1]) - height * dx / chord];
            let middle = dx.atan2(-dz) + if bow < 0.0 { PI } else { 0.0 };
            Curve::Arc { centre, radius, from: middle + half, to: middle - half }
        }
    }
}

/// Where the cell turns of tests come from: every cell turned alike, and mixed turns.
pub(crate) const TURNS: [[usize; 4]; 7] = [[0; 4], [1; 4], [2; 4], [3; 4], [0, 1, 2, 3], [2, 0, 0, 2], [3, 2, 0, 1]];

pub(crate) fn steel() -> [Material; 1] {
    [Material::isotropic(210e3, 0.3).unwrap()]
}

pub(crate) fn support(boundary: &str, direction: Direction) -> Support {
    Support::hold(boundary, direction)
}

pub(crate) fn traction(boundary: &str, f: impl Fn(&BoundaryPoint) -> [f64; 2] + Send + Sync + 'static) -> EdgeTraction {
    EdgeTraction::new(boundary, f)
}

/// The problem with the usual choices: tensor space, one degree, no rigid edge; load cases are named by their numbers.
pub(crate) fn problem(
    mesh: &Mesh,
    degree: usize,
    kinematics: Kinematics,
    materials: &[Material],
    supports: &[Support],
    load_cases: &[Vec<EdgeTraction>],
    kept: Option<&str>,
) -> BodyProblem {
    BodyProblem {
        materials: materials.to_vec(),
        supports: supports.to_vec(),
        load_cases: load_cases.iter().enumerate().map(|(number, loads)| case(number, loads.clone())).collect(),
        kept: kept.iter().map(|name| name.to_string()).collect(),
        ..BodyProblem::new(mesh.clone(), degree, kinematics)
    }
}

/// A load case named by its number.
pub(crate) fn case<T: Into<Load>>(number: usize, loads: impl IntoIterator<Item = T>) -> LoadCase {
    loads.into_iter().fold(LoadCase::new(number.to_string()), LoadCase::with)
}

/// The body under its load cases with factors in their order.
pub(crate) fn solved(body: &Body, factors: &[f64]) -> InterfaceState {
    let names: Vec<String> = (0..factors.len()).map(|number| number.to_string()).collect();
    let cases: Vec<(&str, f64)> = names.iter().map(String::as_str).zip(factors.iter().copied()).collect();
    body.solve(&cases).unwrap()
}

/// The same where the loads need not balance: what is left of them along the free motions is taken away, and the answer has no part of those.
pub(crate) fn afloat(body: &Body, factors: &[f64]) -> InterfaceState {
    let interface = &body.interface;
    let load = TraceLoad { unknowns: vec![0.0; interface.stiffness.nrows()], ..TraceLoad::default() };
    let factors = interface.factors_in_order(factors);
    let unknowns = interface.solve_one(&interface.right_hand_side(&load, &factors));
    InterfaceState { unknowns, factors, load }
}

/// Reference points spread over a cell, corners included.
pub(crate) fn sample_points() -> impl Iterator<Item = (f64, f64)> {
    let t = [-1.0, -0.62, 0.13, 0.77, 1.0];
    t.into_iter().flat_map(move |x| t.into_iter().map(move |y| (x, y)))
}

/// Largest difference of the stress components from `exact(position)` over all cells, relative to the largest exact one.
pub(crate) fn stress_error(field: &Field, mesh: &Mesh, exact: impl Fn([f64; 2]) -> [f64; 4]) -> f64 {
    let (mut error, mut size) = (0.0_f64, 0.0_f64);
    for cell in 0..mesh.cells.len() {
        for (xi, eta) in sample_points() {
            let value = field.at(cell, xi, eta).unwrap().stress;
            let wanted = exact(field.position(cell, xi, eta));
            for (a, b) in value.iter().zip(wanted) {
                error = error.max((a - b).abs());
                size = size.max(b.abs());
            }
        }
    }
    error / size
}
