//! p-convergence with exact solutions that have no symmetry, on turned, curved cells.

use crate::common::*;
use crate::exact::Exact;
use hpfem::*;

fn error(mesh: &Mesh, degree: usize, exact: &Exact, kept: &str) -> f64 {
    let body = Body::new(exact.loaded(mesh, degree).keep(kept)).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    stress_error(&field, mesh, |x| exact.stress(x))
}

/// On triangles and quadrilaterals, with the axis as an edge and as a corner of triangles.
fn assert_exponential_on_mixed_meshes(kinematics: Kinematics, left: f64, last: f64) {
    let exact = Exact { kinematics, material: Material::isotropic(1.7, 0.28).unwrap() };
    for shape in [Shape::Straight, Shape::Arcs, Shape::Polynomial(3)] {
        for (turns, split) in
            TURNS[3..].iter().zip([[false, true, true, false], [true, false, false, true], [true; 4], [true; 4]])
        {
            let mesh = patch_of(*turns, split, shape, left);
            let errors: Vec<f64> = (1..=12).map(|p| error(&mesh, p, &exact, "right")).collect();
            assert!(errors[11] < last, "turns {turns:?}: {errors:?}");
            let slope = (errors[1] / errors[8]).ln() / 7.0;
            assert!(slope > 2.5_f64.ln(), "slope {slope:.2}, turns {turns:?}: {errors:?}");
        }
    }
}

#[test]
fn every_kinematics_converges_exponentially_on_curved_meshes_of_triangles_and_quadrilaterals() {
    for kinematics in [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric, Kinematics::Torsion] {
        assert_exponential_on_mixed_meshes(kinematics, 0.0, 5e-8);
    }
}

#[test]
fn bodies_of_revolution_converge_exponentially_where_triangles_touch_the_axis() {
    assert_exponential_on_mixed_meshes(Kinematics::Axisymmetric, 1.0, 5e-9);
    assert_exponential_on_mixed_meshes(Kinematics::Torsion, 1.0, 5e-9);
}

fn assert_exponential(kinematics: Kinematics, left: f64, last: f64) {
    let exact = Exact { kinematics, material: Material::isotropic(1.7, 0.28).unwrap() };
    for shape in [Shape::Straight, Shape::Arcs, Shape::Polynomial(3)] {
        for turns in TURNS {
            let mesh = patch(turns, shape, left);
            let errors: Vec<f64> = (1..=12).map(|p| error(&mesh, p, &exact, "right")).collect();
            assert!(errors[11] < last, "turns {turns:?}: {errors:?}");
            // The slope of the logarithm over p = 2..9: at least a factor of 2.5 a degree.
            let slope = (errors[1] / errors[8]).ln() / 7.0;
            assert!(slope > 2.5_f64.ln(), "slope {slope:.2}, turns {turns:?}: {errors:?}");
        }
    }
}

#[test]
fn plane_stress_converges_exponentially_on_turned_curved_cells() {
    assert_exponential(PLANE_STRESS, 0.0, 5e-9);
}

#[test]
fn plane_strain_converges_exponentially_on_turned_curved_cells() {
    assert_exponential(PLANE_STRAIN, 0.0, 5e-9);
}

#[test]
fn axisymmetric_bodies_converge_exponentially_off_and_on_the_axis() {
    assert_exponential(Kinematics::Axisymmetric, 0.0, 5e-9);
    assert_exponential(Kinematics::Axisymmetric, 1.0, 5e-9);
}

#[test]
fn torsion_converges_exponentially_off_and_on_the_axis() {
    assert_exponential(Kinematics::Torsion, 0.0, 5e-9);
    assert_exponential(Kinematics::Torsion, 1.0, 5e-9);
}

#[test]
fn the_trunk_space_converges_exponentially_too() {
    let exact = Exact { kinematics: PLANE_STRESS, material: Material::isotropic(1.7, 0.28).unwrap() };
    for turns in TURNS {
        let mesh = patch(turns, Shape::Straight, 0.0);
        let error = |p: usize| {
            let problem = BodyProblem { space: SpaceKind::Trunk, ..exact.loaded(&mesh, p).keep("right") };
            let body = Body::new(problem).unwrap();
            let field = body.field(&solved(&body, &[1.0])).unwrap();
            (stress_error(&field, &mesh, |x| exact.stress(x)), body.effort.unknowns)
        };
        let (e, unknowns) = error(12);
        assert!(e < 1e-7, "turns {turns:?}: {e:.1e}");
        // Interior modes with i, j >= 2 and i + j <= p: (p - 2)(p - 3) / 2.
        assert_eq!(unknowns, 2 * (9 + 12 * 11 + 4 * 45));
    }
}
