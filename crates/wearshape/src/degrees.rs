//! Degrees of the cells of a level: as many as the nearest place asks for where the fields are not smooth.
//!
//! A function that is analytic but for a place at the distance d from a cell of the size h is approximated on it like rho^-p, with
//! `rho = z + sqrt(z^2 - 1)`, `z = 1 + 2 d / h` (the ellipse of Bernstein through that place; Trefethen, Approximation Theory and Approximation
//! Practice, theorem 8.2). Cells beside the layers have d / h about [`RATIO`] and the degree of the level, p_0; elsewhere the same error takes
//! `p = p_0 ln rho_0 / ln rho`.
//!
//! A curved cell has a rotation as a rigid body among its functions only as far as these reach its curve: on an arc of the half angle a, the part of cosine and sine
//! beyond the degree p is `a^(p + 1) / (2^p (p + 1)!)` (the remainder of Chebyshev's interpolation).

use hpfem::{Cell, Mesh};
use meshing::{CONTACT, RATIO};

use crate::level::Level;

/// Least degree that follows from a distance, for the bending of slender cells.
const LEAST: usize = 4;
/// The same on the contact surface, where forces at points stand for pressures of one degree less than the cell has.
const LEAST_IN_CONTACT: usize = 6;
/// Part of a rotation that may not be among the functions of a curved cell: a shoe that turns about a pin does so thousands of times as far as it deforms.
const RIGID: f64 = 1e-12;
/// Degrees beyond the rule, for the constants it leaves out: with one the errors of a level are those of the same degree in all its cells.
const SPARE: usize = 1;
/// Places on each edge of a cell from which distances are measured beside its corners, from -1 to 1.
const PLACES: [f64; 3] = [-0.5, 0.0, 0.5];
/// Sine of the angle between two edges of one line, at most.
const STRAIGHT: f64 = 1e-6;

/// The degrees of the cells of body 1 and body 2; that of the level on a level that is even. Cells that face each other on the contact surface have the same
/// one, the higher of both, so that contact stays nodal. Where the surfaces do not lie `together`, ends of contact may come to lie anywhere on them: the
/// cells there have that of the level, and the distances of the others are measured from every corner on it.
pub(crate) fn degrees(meshes: [&Mesh; 2], level: Level, together: bool) -> [Vec<usize>; 2] {
    if level.even {
        return meshes.map(|mesh| mesh.cells.iter().map(|cell| level.degree_in(cell.layer)).collect());
    }
    let mut degrees = meshes.map(|mesh| by_distance(mesh, level, !together));
    let [first, second] = meshes.map(contact_cells);
    if together && first.len() == second.len() {
        for (a, b) in first.into_iter().zip(second) {
            let least = LEAST_IN_CONTACT.min(level.degree_in(meshes[0].cells[a].layer));
            let higher = degrees[0][a].max(degrees[1][b]).max(least);
            (degrees[0][a], degrees[1][b]) = (higher, higher);
        }
    } else {
        for (body, cells) in [first, second].into_iter().enumerate() {
            cells.into_iter().for_each(|c| degrees[body][c] = level.degree_in(meshes[body].cells[c].layer));
        }
    }
    degrees
}

/// The degrees that the cells of one body need, whose ends of contact may lie `anywhere` on the contact surface or not.
fn by_distance(mesh: &Mesh, level: Level, anywhere: bool) -> Vec<usize> {
    let mut rough = rough_vertices(mesh);
    let contact = if anywhere { mesh.boundary(CONTACT).unwrap_or_default() } else { Vec::new() };
    contact.into_iter().flat_map(|e| mesh.edges[e].vertices).for_each(|v| rough[v] = true);
    let places: Vec<[f64; 2]> = mesh.vertices.iter().zip(&rough).filter(|(_, rough)| **rough).map(|(x, _)| *x).collect();
    let degree = |cell: &Cell| {
        let highest = level.degree_in(cell.layer);
        if highest <= LEAST || cell.vertices().iter().any(|v| rough[*v]) {
            return highest;
        }
        // A distance that is the ratio itself but for round-off takes no degree more.
        let needed = level.degree as f64 * rate(RATIO) / rate(distance(mesh, cell, &places)) * (1.0 - 1e-9);
        let curved = cell.sides().map(|(_, e)| for_rotation(mesh, e)).fold(LEAST, usize::max);
        highest.min((needed.ceil() as usize + SPARE).max(curved))
    };
    mesh.cells.iter().map(degree).collect()
}

/// `ln rho` for a distance over the size of a cell.
fn rate(distance: f64) -> f64 {
    let z = 1.0 + 2.0 * distance;
    (z + (z * z - 1.0).sqrt()).ln()
}

/// How far a cell is from the nearest of some places, or from the centre of an edge of its own, over its size.
fn distance(mesh: &Mesh, cell: &Cell, places: &[[f64; 2]]) -> f64 {
    let squared = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2);
    let corners = cell.vertices();
    let pairs = corners.iter().flat_map(|a| corners.iter().map(|b| squared(mesh.vertices[*a], mesh.vertices[*b])));
    let size = pairs.fold(0.0, f64::max).sqrt();
    let inner = cell.sides().flat_map(|(_, e)| PLACES.map(|t| mesh.edges[e].curve.point(t)));
    let outline = corners.iter().map(|v| mesh.vertices[*v]).chain(inner);
    let nearest = outline.flat_map(|x| places.iter().map(move |y| squared(x, *y))).fold(f64::INFINITY, f64::min).sqrt();
    let radius = |e: usize| mesh.edges[e].curve.length() / turn(mesh, e);
    cell.sides().map(|(_, e)| radius(e)).fold(nearest, f64::min) / size
}

/// The angle (rad) by which an edge turns from its start to its end; zero of a straight one.
fn turn(mesh: &Mesh, edge: usize) -> f64 {
    let curve = &mesh.edges[edge].curve;
    if curve.is_straight() {
        return 0.0;
    }
    let [from, to] = [-1.0, 1.0].map(|t| curve.derivative(t));
    (from[0] * to[1] - from[1] * to[0]).atan2(from[0] * to[0] + from[1] * to[1]).abs()
}

/// The degree that rotations of an edge need.
fn for_rotation(mesh: &Mesh, edge: usize) -> usize {
    let half = 0.5 * turn(mesh, edge);
    let (mut degree, mut left) = (1, 0.25 * half * half);
    while left > RIGID && degree < hpfem::MAX_DEGREE {
        degree += 1;
        left *= 0.5 * half / (degree + 1) as f64;
    }
    degree
}

/// The cells on the contact surface, in the order of the edges of body 1 along it, closed or not.
fn contact_cells(mesh: &Mesh) -> Vec<usize> {
    let Ok(path) = mesh.path(CONTACT) else { return Vec::new() };
    let beside = mesh.edge_cells();
    let ends = |(e, against): &(usize, bool)| mesh.edges[*e].vertices[usize::from(*against)];
    let closed = path
        .first()
        .zip(path.last())
        .is_some_and(|(first, (e, against))| path.len() > 1 && ends(first) == mesh.edges[*e].vertices[usize::from(!*against)]);
    let mut cells: Vec<usize> = path.iter().filter_map(|(e, _)| Some(beside[*e].first()?.0)).collect();
    // Both bodies lie on the left of a path that closes, and walk it in opposite directions.
    if closed && walks_clockwise(mesh, &path) {
        cells.reverse();
    }
    cells
}

/// Whether a closed path goes around its inside clockwise.
fn walks_clockwise(mesh: &Mesh, path: &[(usize, bool)]) -> bool {
    let area = |(e, against): &(usize, bool)| {
        let [a, b] = mesh.edges[*e].vertices.map(|v| mesh.vertices[v]);
        let twice = a[0] * b[1] - a[1] * b[0];
        if *against { -twice } else { twice }
    };
    path.iter().map(area).sum::<f64>() < 0.0
}

/// Whether the fields may not be smooth at each vertex: layers surround it, or the outline has a corner there or another name or material.
fn rough_vertices(mesh: &Mesh) -> Vec<bool> {
    let mut layers: Vec<Option<[usize; 2]>> = vec![None; mesh.vertices.len()];
    for cell in &mesh.cells {
        for v in cell.vertices() {
            let [least, most] = layers[*v].unwrap_or([cell.layer; 2]);
            layers[*v] = Some([least.min(cell.layer), most.max(cell.layer)]);
        }
    }
    let mut outline: Vec<Vec<(usize, usize)>> = vec![Vec::new(); mesh.vertices.len()];
    for (e, cells) in mesh.edge_cells().iter().enumerate() {
        if let [(cell, _)] = cells[..] {
            mesh.edges[e].vertices.iter().for_each(|v| outline[*v].push((e, cell)));
        }
    }
    let surrounded = |v: usize| layers[v].is_some_and(|[least, most]| least == most && most > 0);
    (0..mesh.vertices.len()).map(|v| surrounded(v) || breaks(mesh, v, &outline[v])).collect()
}

/// Whether an outline is not smooth at a vertex, from its edges there, each with its cell.
fn breaks(mesh: &Mesh, vertex: usize, outline: &[(usize, usize)]) -> bool {
    let leaves = |e: usize| {
        let edge = &mesh.edges[e];
        let forward = edge.vertices[0] == vertex;
        let d = if forward { edge.curve.derivative(-1.0) } else { edge.curve.derivative(1.0).map(|d| -d) };
        d.map(|v| v / d[0].hypot(d[1]))
    };
    match *outline {
        [] => false,
        [(a, first), (b, second)] => {
            let ([x, y], [u, w]) = (leaves(a), leaves(b));
            let bent = x * u + y * w > 0.0 || (x * w - y * u).abs() > STRAIGHT;
            bent || mesh.edges[a].tags != mesh.edges[b].tags || mesh.cells[first].material != mesh.cells[second].material
        }
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hpfem::Quad;

    /// A square of `N` by `N` cells of the size 1 from a corner, its cells numbered along x, or backwards from the other end; its lower side is the contact surface.
    fn square(from: [f64; 2], backwards: bool) -> Mesh {
        const N: usize = 7;
        let flip = |i: usize, last: usize| if backwards { last - i } else { i };
        let number = |i: usize, j: usize| flip(i + (N + 1) * j, (N + 1) * (N + 1) - 1);
        let mut vertices = vec![[0.0; 2]; (N + 1) * (N + 1)];
        (0..=N).for_each(|j| (0..=N).for_each(|i| vertices[number(i, j)] = [from[0] + i as f64, from[1] + j as f64]));
        let corners = |i: usize, j: usize| [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
        let mut quads = vec![Quad { corners: [0; 4], material: 0, layer: 0 }; N * N];
        (0..N).for_each(|j| (0..N).for_each(|i| quads[flip(i + N * j, N * N - 1)].corners = corners(i, j)));
        let contact: Vec<([usize; 2], &str)> = (0..N).map(|i| ([number(i, 0), number(i + 1, 0)], CONTACT)).collect();
        Mesh::new(vertices, &quads, &[], &contact).expect("a mesh")
    }

    #[test]
    fn cells_at_corners_keep_the_degree_of_the_level_and_those_far_from_all_need_fewer() {
        let level = Level { degree: 14, layers: 0, slow: false, even: false };
        let found = by_distance(&square([0.0; 2], false), level, false);
        let (corner, beside, middle) = (found[0], found[1], found[24]);
        assert_eq!(corner, 14);
        // A corner at d = h / sqrt 2, and at 3 h.
        assert!(beside < corner && middle < beside && middle >= LEAST, "{found:?}");
        let wanted = 14.0 * rate(0.25) / rate(3.0);
        assert!(middle as f64 >= wanted && (middle as f64) < wanted + 2.0, "{middle}, not {wanted}");
    }

    #[test]
    fn cells_at_a_contact_whose_ends_may_lie_anywhere_keep_the_degree_of_the_level() {
        let level = Level { degree: 14, layers: 0, slow: false, even: false };
        let (first, second) = (square([0.0; 2], false), square([0.0, -7.0], true));
        let [above, below] = degrees([&first, &second], level, false);
        assert!(above[..7].iter().all(|degree| *degree == 14) && below[42..].iter().all(|degree| *degree == 14));
        // The next row is a cell away from the surface, and the one after it two.
        let next = (14.0 * rate(0.25) / rate(1.0 / 2.0_f64.sqrt())).ceil() as usize;
        assert!((next..next + 2).contains(&above[10]) && above[17] < above[10], "{above:?}");
    }

    #[test]
    fn a_rotation_of_an_arc_is_among_the_functions_of_its_degree() {
        let [a, b] = [-0.26_f64, 0.26].map(|angle| [angle.sin(), angle.cos()]);
        let quads = [Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 }];
        let arc = hpfem::Curve::interpolated(16, |t| [(0.26 * t).sin(), (0.26 * t).cos()]);
        let mesh = Mesh::new(vec![[-0.3, 0.0], [0.3, 0.0], b, a], &quads, &[([3, 2], arc)], &[]).expect("a mesh");
        let found: Vec<usize> = (0..4).map(|e| for_rotation(&mesh, e)).collect();
        // 0.26^9 / (2^8 9!) = 5.9e-14, and 4.0e-12 with one degree less.
        assert_eq!(found.iter().max(), Some(&8), "{found:?}");
        assert_eq!(found.iter().filter(|degree| **degree == 1).count(), 3);
    }

    #[test]
    fn degrees_do_not_depend_on_the_numbers_of_cells_and_vertices() {
        let level = Level { degree: 12, layers: 0, slow: false, even: false };
        let [there, mut back] = [false, true].map(|backwards| by_distance(&square([0.0; 2], backwards), level, false));
        back.reverse();
        assert_eq!(there, back);
    }

    #[test]
    fn cells_that_face_each_other_have_one_degree_on_the_contact_surface() {
        let level = Level { degree: 12, layers: 0, slow: false, even: false };
        let (first, second) = (square([0.0; 2], false), square([0.0, -7.0], true));
        let degrees = degrees([&first, &second], level, true);
        let [a, b] = [&first, &second].map(contact_cells);
        assert_eq!(a.len(), 7);
        assert!(a.iter().zip(&b).all(|(a, b)| degrees[0][*a] == degrees[1][*b] && degrees[0][*a] >= LEAST_IN_CONTACT));
    }
}
