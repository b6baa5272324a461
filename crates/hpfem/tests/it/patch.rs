//! Patch tests: a body of constant strain comes out exactly wherever the space holds the linear field.
//!
//! The blended map of a cell with straight or polynomial edges of degree `d` is a polynomial of degree `d` in each direction, so every
//! linear field is in the tensor space of degree `p >= d` and, constant stress making the integrand of the load a polynomial, comes out to
//! round-off. The same holds in a triangle and its complete polynomials. An arc is no polynomial of its angle: there the linear field is approximated, exponentially in `p`.

use crate::common::*;
use hpfem::*;

/// Stress error of the constant stress `s = [xx, zz, xz]` loaded on all edges of a floating body.
fn error(mesh: &Mesh, degree: usize, kinematics: Kinematics, s: [f64; 3]) -> f64 {
    let materials = steel();
    let load = vec![vec![traction("all", move |p| {
        let n = p.outward;
        [s[0] * n[0] + s[2] * n[1], s[2] * n[0] + s[1] * n[1]]
    })]];
    let body = Body::new(problem(mesh, degree, kinematics, &materials, &[], &load, Some("left"))).unwrap();
    assert_eq!(body.interface.rigid_motions.len(), 3);
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    let yy = if matches!(kinematics, Kinematics::PlaneStrain { .. }) { 0.3 * (s[0] + s[1]) } else { 0.0 };
    stress_error(&field, mesh, |_| [s[0], s[1], s[2], yy])
}

const STATES: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, -0.7, 1.0]];

/// Quadrilaterals in all turns, and triangles among them.
fn meshes(shape: Shape) -> impl Iterator<Item = ([usize; 4], Mesh)> {
    let mixed = TURNS[4..].iter().map(move |t| (*t, mixed(*t, shape, 0.0)));
    TURNS.iter().map(move |t| (*t, patch(*t, shape, 0.0))).chain(mixed)
}

#[test]
fn constant_stress_is_exact_on_straight_distorted_turned_cells() {
    for (turns, mesh) in meshes(Shape::Straight) {
        for degree in 1..=8 {
            for (state, kinematics) in STATES.iter().zip([PLANE_STRESS, PLANE_STRAIN, PLANE_STRAIN]) {
                let e = error(&mesh, degree, kinematics, *state);
                assert!(e < 3e-12, "turns {turns:?}, p = {degree}: {e:.1e}");
            }
        }
    }
}

#[test]
fn constant_stress_is_exact_on_polynomial_curved_turned_cells() {
    for shape in [2, 3, 4] {
        for (turns, mesh) in meshes(Shape::Polynomial(shape)) {
            for degree in shape..=8 {
                let e = error(&mesh, degree, PLANE_STRESS, STATES[2]);
                assert!(e < 3e-12, "turns {turns:?}, edges of degree {shape}, p = {degree}: {e:.1e}");
            }
            assert!(error(&mesh, shape - 1, PLANE_STRESS, STATES[2]) > 1e-6, "edges of degree {shape} need p >= {shape}");
        }
    }
}

#[test]
fn constant_stress_converges_exponentially_on_exact_arcs() {
    for turns in TURNS {
        let mesh = patch(turns, Shape::Arcs, 0.0);
        let errors: Vec<f64> = (1..=11).map(|p| error(&mesh, p, PLANE_STRAIN, STATES[2])).collect();
        assert!(errors[10] < 3e-11, "turns {turns:?}: {errors:.1?}");
        for p in 2..9 {
            assert!(errors[p + 1] < 0.35 * errors[p - 1], "turns {turns:?}: {errors:?}");
        }
    }
}

#[test]
fn an_axisymmetric_body_takes_uniform_axial_tension_and_all_round_pressure_exactly() {
    // Constant stress fields of a body of revolution: s_rr = s_hoop, s_zz; u_r and u_z linear in r and z.
    for left in [0.0, 1.0] {
        for turns in TURNS {
            let mesh = patch(turns, Shape::Straight, left);
            let materials = steel();
            for degree in [1, 2, 5] {
                let load = vec![vec![traction("all", |p| [-2.0 * p.outward[0], 3.0 * p.outward[1]])]];
                let body =
                    Body::new(problem(&mesh, degree, Kinematics::Axisymmetric, &materials, &[], &load, Some("right"))).unwrap();
                let field = body.field(&solved(&body, &[1.0])).unwrap();
                let e = stress_error(&field, &mesh, |_| [-2.0, 3.0, 0.0, -2.0]);
                assert!(e < 1e-11, "left {left}, turns {turns:?}, p = {degree}: {e:.1e}");
            }
        }
    }
}
