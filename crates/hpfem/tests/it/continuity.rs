//! The field is continuous across every edge however the cells on its two sides are turned.

use crate::common::*;
use hpfem::*;

/// Largest jump of the displacement across the inner edges, relative to its size.
fn jump(mesh: &Mesh, field: &Field) -> f64 {
    let (mut jump, mut size) = (0.0_f64, 0.0_f64);
    for sides in mesh.edge_cells().iter().filter(|s| s.len() == 2) {
        for i in 0..=10 {
            let t = -1.0 + 0.2 * f64::from(i);
            let values = [sides[0], sides[1]].map(|(cell, local)| {
                // The parameter in the edge's own direction is t on both sides.
                let s = if mesh.cells[cell].against[local] { -t } else { t };
                let (xi, eta) = [(s, -1.0), (1.0, s), (s, 1.0), (-1.0, s)][local];
                field.at(cell, xi, eta).unwrap().displacement
            });
            jump = jump.max((values[0][0] - values[1][0]).abs()).max((values[0][1] - values[1][1]).abs());
            size = size.max(values[0][0].abs()).max(values[0][1].abs());
        }
    }
    jump / size
}

/// The jump under a load that excites all modes.
fn jump_under_load(mesh: &Mesh, degrees: Vec<usize>) -> f64 {
    let materials = steel();
    // A load that excites odd and even modes alike.
    let load = vec![vec![traction("all", |p| {
        let [x, z] = p.position;
        [(3.0 * x + z).sin() + x * z * z, (2.0 * z - x).exp() - (5.0 * x).cos()]
    })]];
    let supports = [support("left", Direction::First), support("left", Direction::Second)];
    let problem = BodyProblem { degrees, ..problem(mesh, 1, PLANE_STRAIN, &materials, &supports, &load, None) };
    let body = Body::new(problem).unwrap();
    let state = solved(&body, &[1.0]);
    jump(mesh, &body.field(&state).unwrap())
}

#[test]
fn the_field_is_continuous_over_all_turns_of_both_neighbours() {
    for first in 0..4 {
        for second in 0..4 {
            for shape in [Shape::Straight, Shape::Arcs] {
                let mesh = patch([first, second, (second + 1) % 4, (first + 2) % 4], shape, 0.0);
                for degree in 3..=8 {
                    let jump = jump_under_load(&mesh, vec![degree; 4]);
                    assert!(jump < 1e-12, "turns {first} and {second}, p = {degree}: {jump:.1e}");
                }
            }
        }
    }
}

#[test]
fn the_field_is_continuous_over_all_turns_of_a_triangle_against_quadrilaterals_and_triangles() {
    for first in 0..4 {
        for second in 0..3 {
            for third in 0..3 {
                for shape in [Shape::Straight, Shape::Arcs] {
                    // The two triangles of a quadrilateral: neighbours of each other and of quadrilaterals.
                    let mesh = mixed([first, second, third, (first + 2) % 4], shape, 0.0);
                    for degree in [3, 5, 8] {
                        let jump = jump_under_load(&mesh, vec![degree; 6]);
                        assert!(jump < 1e-12, "turns {first}, {second}, {third}, p = {degree}: {jump:.1e}");
                    }
                    let jump = jump_under_load(&mesh, vec![7, 4, 6, 3, 8, 5]);
                    assert!(jump < 1e-12, "turns {first}, {second}, {third}, mixed degrees: {jump:.1e}");
                }
            }
        }
    }
}

#[test]
fn the_field_is_continuous_on_triangles_alone_in_every_turn() {
    for turn in 0..9 {
        let mesh = patch_of([turn % 3, turn / 3, 1, 2], [true; 4], Shape::Arcs, 0.0);
        for degree in 1..=8 {
            let jump = jump_under_load(&mesh, vec![degree; 8]);
            assert!(jump < 1e-12, "turn {turn}, p = {degree}: {jump:.1e}");
        }
    }
}

#[test]
fn the_field_is_continuous_between_cells_of_different_degree() {
    for turns in TURNS {
        let mesh = patch(turns, Shape::Arcs, 0.0);
        assert!(jump_under_load(&mesh, vec![3, 6, 8, 5]) < 1e-12);
    }
}

#[test]
fn without_the_sign_of_odd_modes_neighbours_that_walk_an_edge_in_opposite_directions_would_not_meet() {
    // The bug that must not be: the same coefficient on both sides of an edge without regard to its direction. Rebuilt here from the
    // mesh's own orientation flags: mode 3 seen from both sides of each inner edge, with and without the sign.
    let mode = |t: f64| shape_functions(3, t).0[3];
    let (mut broken, mut edges) = (0, 0);
    for turn in 0..64 {
        let mesh = patch([0, turn % 4, turn / 4 % 4, turn / 16], Shape::Straight, 0.0);
        for sides in mesh.edge_cells().iter().filter(|s| s.len() == 2) {
            let t = 0.4;
            let local = [sides[0], sides[1]].map(|(cell, e)| {
                let sign = if mesh.cells[cell].against[e] { -1.0 } else { 1.0 };
                (sign * t, sign)
            });
            let [a, b] = local.map(|(s, sign)| sign * mode(s));
            assert!((a - b).abs() < 1e-15);
            let [a, b] = local.map(|(s, _)| mode(s));
            broken += usize::from((a - b).abs() > 0.1 * a.abs());
            edges += 1;
        }
    }
    // Half of all pairs of turns walk their edge in opposite directions.
    assert_eq!((broken, edges), (128, 256));
}
