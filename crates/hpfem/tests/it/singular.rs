//! Singular points and their exponents, found from geometry, supports and loads.

use crate::common::*;
use crate::lshape::l_shape;
use approx::assert_abs_diff_eq;
use hpfem::*;
use std::f64::consts::PI;

fn exponent(degrees: f64, faces: [Face; 2], kinematics: Kinematics, nu: f64) -> f64 {
    let sector = Sector { angle: degrees.to_radians(), constants: Constants { young: 1.0, poisson: nu } };
    corner_exponent(&[sector], Some(faces), kinematics)
}

#[test]
fn exponents_of_free_wedges_are_those_of_williams() {
    // Roots of sin(l w) = +- l sin w, Szabo and Babuska 1991, table 9.1.
    for (angle, value) in [(270.0, 0.544483736782464), (300.0, 0.512221400), (315.0, 0.505009698), (360.0, 0.5)] {
        assert_abs_diff_eq!(exponent(angle, [Face::Free; 2], PLANE_STRAIN, 0.3), value, epsilon = 1e-6);
    }
    for angle in [60.0, 90.0, 150.0] {
        assert_eq!(exponent(angle, [Face::Free; 2], PLANE_STRAIN, 0.3), 1.0);
    }
}

#[test]
fn exponents_of_mixed_and_fixed_wedges_satisfy_their_equations() {
    for (kinematics, nu) in [(PLANE_STRESS, 0.3), (PLANE_STRAIN, 0.3), (PLANE_STRAIN, 0.45)] {
        let kappa = if kinematics == PLANE_STRESS { (3.0 - nu) / (1.0 + nu) } else { 3.0 - 4.0 * nu };
        let w: f64 = 0.5 * PI;
        // Fixed and free at a right angle: kappa sin^2(l w) = (kappa + 1)^2 / 4 - l^2 sin^2 w.
        let l = exponent(90.0, [Face::Fixed, Face::Free], kinematics, nu);
        assert!(l > 0.5 && l < 1.0);
        let rest = kappa * (l * w).sin().powi(2) - (0.25 * (kappa + 1.0) * (kappa + 1.0) - l * l * w.sin().powi(2));
        assert_abs_diff_eq!(rest, 0.0, epsilon = 1e-9);
        assert_abs_diff_eq!(exponent(90.0, [Face::Free, Face::Fixed], kinematics, nu), l, epsilon = 1e-14);
        // Fixed on both faces: sin(l w) = +- l sin(w) / kappa.
        let l = exponent(270.0, [Face::Fixed; 2], kinematics, nu);
        let (w, ratio) = (1.5 * PI, l / kappa * (1.5 * PI).sin());
        assert!(((l * w).sin().abs() - ratio.abs()).abs() < 1e-9);
        // A change from fixed to free on a straight boundary: 1/2 + i ln(kappa) / (2 pi).
        assert_abs_diff_eq!(exponent(180.0, [Face::Fixed, Face::Free], kinematics, nu), 0.5, epsilon = 1e-8);
    }
}

#[test]
fn rollers_are_mirrors() {
    // A wedge on a roller is half of the symmetric mode of the wedge twice as wide; 135 degrees against a roller is the opening mode
    // of the L.
    let roller = Face::Held(0.5 * PI);
    assert_abs_diff_eq!(exponent(135.0, [roller, Face::Free], PLANE_STRAIN, 0.3), 0.544483736782464, epsilon = 1e-9);
    // Held along the face instead: the antisymmetric mode.
    assert_abs_diff_eq!(exponent(135.0, [Face::Held(0.0), Face::Free], PLANE_STRAIN, 0.3), 0.908529189, epsilon = 1e-8);
    assert_abs_diff_eq!(exponent(90.0, [roller; 2], PLANE_STRAIN, 0.3), 1.0, epsilon = 1e-9);
}

#[test]
fn torsion_has_the_exponents_of_antiplane_shear() {
    assert_abs_diff_eq!(exponent(270.0, [Face::Free; 2], Kinematics::Torsion, 0.3), 2.0 / 3.0, epsilon = 1e-9);
    assert_abs_diff_eq!(exponent(135.0, [Face::Fixed, Face::Free], Kinematics::Torsion, 0.3), 2.0 / 3.0, epsilon = 1e-9);
}

#[test]
fn two_sectors_of_one_material_are_one_and_stiff_lining_is_none() {
    let half = |young, degrees: f64| Sector { angle: degrees.to_radians(), constants: Constants { young, poisson: 0.3 } };
    let faces = Some([Face::Free; 2]);
    let one = corner_exponent(&[half(1.0, 100.0), half(1.0, 170.0)], faces, PLANE_STRAIN);
    assert_abs_diff_eq!(one, 0.544483736782464, epsilon = 1e-8);
    // Two materials in any unit of the modulus.
    let bonded = |unit: f64| corner_exponent(&[half(unit, 90.0), half(3.0 * unit, 180.0)], faces, PLANE_STRAIN);
    assert_abs_diff_eq!(bonded(1.0), bonded(1e6), epsilon = 1e-9);
    // A quarter far stiffer than the other three: the stiff quarter is a fixed wedge for them.
    let stiff = corner_exponent(&[half(1e9, 90.0), half(1.0, 270.0)], None, PLANE_STRAIN);
    let fixed = exponent(270.0, [Face::Fixed; 2], PLANE_STRAIN, 0.3);
    assert_abs_diff_eq!(stiff, fixed, epsilon = 1e-5);
}

#[test]
fn the_singular_vertices_of_a_mesh_are_found() {
    let materials = steel();
    let at = |mesh: &Mesh, supports: &[Support], loaded: &[&str]| -> Vec<(usize, f64)> {
        let found = singular_vertices(mesh, PLANE_STRAIN, &materials, supports, loaded).unwrap();
        found.iter().map(|s| (s.vertex, (1e6 * s.exponent).round() / 1e6)).collect()
    };
    assert_eq!(at(&l_shape(), &[], &[]), [(0, 0.544484)]);
    let mesh = crate::classics::rectangle([0.0, 1.0], [0.0, 1.0]);
    assert_eq!(at(&mesh, &[], &[]), []);
    // Symmetry planes are not singular, a clamp is at both its ends, a load at its ends.
    assert_eq!(at(&mesh, &[support("left", Direction::First), support("bottom", Direction::Second)], &[]), []);
    let clamp = [support("bottom", Direction::First), support("bottom", Direction::Second)];
    let found = at(&mesh, &clamp, &["right"]);
    assert_eq!(found.iter().map(|f| f.0).collect::<Vec<_>>(), [0, 1, 2]);
    assert!(found[0].1 < 0.8 && found[1].1 == found[0].1 && found[2].1 == 1.0);
    // Vertices on a smooth boundary are not singular; refined meshes have the same singular points.
    let found = at(&l_shape().refined().unwrap(), &[], &[]);
    assert_eq!(found, [(0, 0.544484)]);
}

#[test]
fn uniform_refinement_keeps_shape_names_and_solution() {
    let mesh = patch([0, 1, 2, 3], Shape::Arcs, 0.0);
    let fine = mesh.refined().unwrap().refined().unwrap();
    assert_eq!((fine.cells.len(), fine.boundary("top").unwrap().len()), (64, 8));
    let length = |m: &Mesh| m.boundary("all").unwrap().iter().map(|e| m.edges[*e].curve.length()).sum::<f64>();
    assert_abs_diff_eq!(length(&mesh), length(&fine), epsilon = 1e-12);
}

#[test]
fn angles_that_make_no_corner_have_no_exponent() {
    for degrees in [f64::NAN, -60.0, 0.0, 361.0] {
        assert!(exponent(degrees, [Face::Free; 2], PLANE_STRAIN, 0.3).is_nan(), "{degrees}");
    }
}

/// Two cells side by side; a load ends between them, which is one of many.
#[test]
fn the_end_of_a_load_is_singular_however_many_loads_there_are() {
    let vertices = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, 1.0]];
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let names = [([3, 4], "a"), ([4, 5], "b"), ([0, 1], "c")];
    let mesh = Mesh::new(vertices, &[quad([0, 1, 4, 3]), quad([1, 2, 5, 4])], &[], &names).unwrap();
    for between in [0, 58, 59, 60, 119] {
        let loaded: Vec<&str> = std::iter::once("a").chain(std::iter::repeat_n("c", between)).chain(["b"]).collect();
        let found = singular_vertices(&mesh, PLANE_STRAIN, &[Material::isotropic(1.0, 0.3).unwrap()], &[], &loaded).unwrap();
        assert!(found.iter().any(|singular| singular.vertex == 4), "{between}");
    }
}
