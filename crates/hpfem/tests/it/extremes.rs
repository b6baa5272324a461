//! Near-incompressible material, the highest degree, and scaling.

use crate::common::*;
use crate::exact::Exact;
use hpfem::*;

#[test]
fn near_incompressible_plane_strain_does_not_lock_from_degree_four_on() {
    let mesh = patch([0, 1, 2, 3], Shape::Straight, 0.0);
    let energy_norm_error = |nu: f64, p: usize| {
        // A pressure of order one, a volume strain of order 1 - 2 nu: the displacement error shows locking.
        let exact = Exact { kinematics: PLANE_STRAIN, material: Material::isotropic(1.0, nu).unwrap() };
        let materials = [exact.material];
        let load = vec![vec![traction("all", move |q| exact.traction(q))]];
        let body = Body::new(problem(&mesh, p, PLANE_STRAIN, &materials, &[], &load, Some("right"))).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        let (mut error, mut size) = (0.0_f64, 0.0_f64);
        for cell in 0..4 {
            for (xi, eta) in sample_points() {
                let x = field.position(cell, xi, eta);
                // Shear strain: free of the rigid motion and of the pressure.
                let shear = |x: [f64; 2]| exact.stress(x)[2] * 2.0 * (1.0 + nu);
                let g = field.at(cell, xi, eta).unwrap().gradient;
                error = error.max((g[0][1] + g[1][0] - shear(x)).abs());
                size = size.max(shear(x).abs());
            }
        }
        error / size
    };
    for p in 4..=8 {
        let (soft, hard) = (energy_norm_error(0.3, p), energy_norm_error(0.49999, p));
        assert!(hard < 30.0 * soft, "p = {p}: {hard:.1e} against {soft:.1e}");
    }
    assert!(energy_norm_error(0.49999, 12) < 1e-8);
}

#[test]
fn the_highest_degree_works_and_is_as_accurate_as_round_off_allows() {
    let mesh = patch([3, 2, 0, 1], Shape::Arcs, 0.0);
    for kinematics in [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric, Kinematics::Torsion] {
        let exact = Exact { kinematics, material: Material::isotropic(1.0, 0.3).unwrap() };
        let materials = [exact.material];
        let load = vec![vec![traction("all", move |q| exact.traction(q))]];
        for p in [16, 20, MAX_DEGREE] {
            let body = Body::new(problem(&mesh, p, kinematics, &materials, &[], &load, Some("right"))).unwrap();
            let field = body.field(&solved(&body, &[1.0])).unwrap();
            let e = stress_error(&field, &mesh, |x| exact.stress(x));
            assert!(e < 1e-10, "{kinematics:?}, p = {p}: {e:.1e}");
        }
    }
}

#[test]
fn twenty_graded_layers_of_high_degree_stay_solvable() {
    let mesh = crate::classics::rectangle([0.0, 1.0], [0.0, 1.0]);
    let mesh = mesh.refined_towards(&[0], 0.15, 20).unwrap();
    let materials = steel();
    let supports = [support("left", Direction::First), support("bottom", Direction::Second)];
    let load = [vec![traction("top", |p| p.outward), traction("right", |p| p.outward.map(|n| 2.0 * n))]];
    let body = Body::new(problem(&mesh, 12, PLANE_STRESS, &materials, &supports, &load, None)).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    let e = stress_error(&field, &mesh, |_| [2.0, 1.0, 0.0, 0.0]);
    assert!(e < 1e-8, "{e:.1e}");
}

#[test]
fn cells_of_aspect_ten_thousand_stay_accurate() {
    let mesh = crate::classics::rectangle([0.0, 1e4], [0.0, 1.0]);
    let materials = steel();
    let supports = [support("left", Direction::First), support("bottom", Direction::Second)];
    let load = [vec![traction("top", |p| p.outward), traction("right", |p| p.outward.map(|n| 2.0 * n))]];
    for p in [1, 4, 8] {
        let body = Body::new(problem(&mesh, p, PLANE_STRESS, &materials, &supports, &load, None)).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        let e = stress_error(&field, &mesh, |_| [2.0, 1.0, 0.0, 0.0]);
        assert!(e < 1e-6, "p = {p}: {e:.1e}");
    }
}

/// Kept unknowns of the patch under a load, all lengths multiplied by `length`, the load by `load`, the modulus by `modulus`.
fn scaled(kinematics: Kinematics, length: f64, load: f64, modulus: f64, held: bool) -> Vec<f64> {
    let body = scaled_body(kinematics, [length, load, modulus], held).unwrap();
    // Nothing balances the load of the body that floats.
    assert!(held || matches!(body.solve(&[("0", 1.0)]), Err(Error::Unbalanced { .. })));
    afloat(&body, &[1.0]).unknowns
}

fn scaled_body(kinematics: Kinematics, [length, load, modulus]: [f64; 3], held: bool) -> Result<Body, Error> {
    let mesh = patch([1, 3, 0, 2], Shape::Arcs, 0.0);
    let names = ["bottom", "right", "top", "left"];
    let vertices = mesh.vertices.iter().map(|x| x.map(|v| v * length)).collect();
    let quads: Vec<Quad> = mesh.cells.iter().map(|c| Quad { corners: c.corners, material: 0, layer: 0 }).collect();
    let curves: Vec<([usize; 2], Curve)> = mesh
        .edges
        .iter()
        .map(|e| {
            let curve = match e.curve {
                Curve::Line { start, end } => Curve::Line { start: start.map(|v| v * length), end: end.map(|v| v * length) },
                Curve::Arc { centre, radius, from, to } => {
                    Curve::Arc { centre: centre.map(|v| v * length), radius: radius * length, from, to }
                }
                other => other,
            };
            (e.vertices, curve)
        })
        .collect();
    let mut named = Vec::new();
    for name in names {
        named.extend(mesh.boundary(name).unwrap().iter().map(|e| (mesh.edges[*e].vertices, name)));
    }
    let mesh = Mesh::new(vertices, &quads, &curves, &named).unwrap();
    let materials = [Material::isotropic(3.0 * modulus, 0.25).unwrap()];
    let supports = [support("bottom", Direction::First), support("bottom", Direction::Second)];
    let cases = [vec![traction("top", move |p| {
        let x = p.position[0] / length;
        [load * x, load * (1.0 - x * x)]
    })]];
    let supports = if held { &supports[..] } else { &[] };
    Body::new(problem(&mesh, 7, kinematics, &materials, supports, &cases, Some("right")))
}

#[test]
fn results_scale_bit_for_bit_with_powers_of_two() {
    let two = |k: i32| 2.0_f64.powi(k);
    for kinematics in [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric] {
        let base = scaled(kinematics, 1.0, 1.0, 1.0, true);
        for (l, f, e) in [(20, 0, 0), (-20, 0, 0), (0, 40, 0), (0, -40, 0), (0, 0, 30), (-13, 17, -9), (7, 0, 0), (0, 0, 1)] {
            let other = scaled(kinematics, two(l), two(f), two(e), true);
            let expected: Vec<f64> = base.iter().map(|u| u * two(l + f - e)).collect();
            assert!(other == expected, "{kinematics:?}, lengths 2^{l}, loads 2^{f}, modulus 2^{e}");
        }
    }
}

#[test]
fn a_floating_body_scales_too() {
    let two = |k: i32| 2.0_f64.powi(k);
    let base = scaled(PLANE_STRESS, 1.0, 1.0, 1.0, false);
    for (l, f, e) in [(20, 0, 0), (0, -40, 0), (-13, 17, -9), (7, 0, 0), (0, 0, 1)] {
        let other = scaled(PLANE_STRESS, two(l), two(f), two(e), false);
        let largest = base.iter().fold(0.0_f64, |m, u| m.max(u.abs()));
        for (a, b) in other.iter().zip(&base) {
            assert!((a - b * two(l + f - e)).abs() < 1e-12 * largest * two(l + f - e));
        }
    }
}

/// Displacements below all numbers were zero, and with them the stress.
#[test]
fn a_modulus_that_numbers_are_not_enough_for_is_refused_by_name() {
    for (length, modulus) in [(1e-150, 1e200), (1e-10, 1e300), (1e20, 1e-300)] {
        match scaled_body(PLANE_STRAIN, [length, 1.0, modulus], true) {
            Err(Error::OutOfRange { quantity, .. }) => {
                assert_eq!(quantity, "the size of the mesh over the stiffness of material 0");
            }
            other => unreachable!("{length:e} mm, {modulus:e} MPa: {:?}", other.err()),
        }
    }
    // As long as all is a number, it is right.
    let base = scaled(PLANE_STRESS, 1.0, 1.0, 1.0, true);
    let largest = base.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    for (length, modulus) in [(1e-150, 1e100), (1e-100, 1e200), (1e100, 1e100), (1.0, 1e290)] {
        for (u, wanted) in scaled(PLANE_STRESS, length, 1.0, modulus, true).iter().zip(&base) {
            assert!((u / length * modulus - wanted).abs() < 1e-11 * largest, "{length:e} mm, {modulus:e} MPa");
        }
    }
}
