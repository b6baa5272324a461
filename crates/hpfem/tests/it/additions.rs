//! Body forces, pins and elastic foundations.

use crate::classics::rectangle;
use crate::common::*;
use crate::exact::Exact;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use hpfem::*;

/// `u_x = c sin(a x + b z)`, `u_z = c e^(d x) cos(e z)` in plane strain with lambda = mu = 1 (E = 2.5, nu = 0.25), no symmetry.
struct Manufactured;

impl Manufactured {
    /// First and second derivatives of the two components: `[x, z, xx, xz, zz]`.
    fn derivatives([x, z]: [f64; 2]) -> [[f64; 5]; 2] {
        let (a, b, d, e) = (1.3, -0.8, 0.6, 1.7);
        let (s, c) = (a * x + b * z).sin_cos();
        let (g, sz, cz) = ((d * x).exp(), (e * z).sin(), (e * z).cos());
        [
            [a * c, b * c, -a * a * s, -a * b * s, -b * b * s],
            [d * g * cz, -e * g * sz, d * d * g * cz, -d * e * g * sz, -e * e * g * cz],
        ]
    }

    fn stress(x: [f64; 2]) -> [f64; 4] {
        let [u, w] = Self::derivatives(x);
        let trace = u[0] + w[1];
        [trace + 2.0 * u[0], trace + 2.0 * w[1], u[1] + w[0], trace]
    }

    /// `-div sigma`.
    fn force(x: [f64; 2]) -> [f64; 2] {
        let [u, w] = Self::derivatives(x);
        [-(3.0 * u[2] + w[3] + u[4] + w[3]), -(3.0 * w[4] + u[3] + u[3] + w[2])]
    }
}

#[test]
fn a_manufactured_solution_with_body_force_converges_exponentially_on_turned_curved_cells() {
    let materials = [Material::isotropic(2.5, 0.25).unwrap()];
    let meshes = TURNS.iter().map(|t| patch(*t, Shape::Arcs, 0.0)).chain([mixed(TURNS[6], Shape::Arcs, 0.0)]);
    for mesh in meshes {
        let errors: Vec<f64> = [2, 4, 6, 8, 10, 12]
            .iter()
            .map(|p| {
                let pull = traction("all", |q| {
                    let ([x, z, t, _], n) = (Manufactured::stress(q.position), q.outward);
                    [x * n[0] + t * n[1], t * n[0] + z * n[1]]
                });
                let problem = problem(&mesh, *p, PLANE_STRAIN, &materials, &[], &[], Some("top"));
                let body = Body::new(problem.load("0", pull).load("0", BodyForce::new(Manufactured::force))).unwrap();
                stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, Manufactured::stress)
            })
            .collect();
        assert!(errors[5] < 1e-7, "{errors:?}");
        assert!((errors[0] / errors[5]).ln() / 10.0 > 2.5_f64.ln(), "{errors:?}");
    }
}

#[test]
fn a_hanging_bar_has_the_stress_energy_and_reaction_of_its_weight() {
    // Hanging from the top, nu = 0: s_zz = w (z - z_0), U = w^2 L^3 A / (6 E).
    let mesh = rectangle([0.0, 1.5], [-1.0, 2.0]);
    let materials = [Material::isotropic(1000.0, 0.0).unwrap()];
    let supports = [support("top", Direction::First), support("top", Direction::Second)];
    for kept in [None, Some("bottom"), Some("right")] {
        for degree in [2, 5] {
            let problem = problem(&mesh, degree, PLANE_STRESS, &materials, &supports, &[], kept);
            let body = Body::new(problem.load("0", BodyForce::weight(2.0, [0.0, -2.0]))).unwrap();
            let state = solved(&body, &[1.0]);
            let field = body.field(&state).unwrap();
            assert!(stress_error(&field, &mesh, |x| [0.0, 4.0 * (x[1] + 1.0), 0.0, 0.0]) < 1e-11);
            assert_relative_eq!(body.interface.reaction(1, &state)[1], 4.0 * 4.5 * 0.7, max_relative = 1e-11);
            let energy = 16.0 * 27.0 * 1.5 * 0.7 / 6000.0;
            assert_relative_eq!(body.interface.strain_energy(&state), energy, max_relative = 1e-11);
        }
    }
}

#[test]
fn pins_hold_a_balanced_body_without_reaction() {
    let exact = Exact { kinematics: PLANE_STRESS, material: Material::isotropic(1.7, 0.28).unwrap() };
    let mesh = patch([0, 1, 2, 3], Shape::Arcs, 0.0);
    let pin = |vertex, direction| Pin { vertex, direction };
    let pins = vec![pin(0, Direction::First), pin(0, Direction::Second), pin(6, Direction::First)];
    let body = Body::new(BodyProblem { pins, ..exact.loaded(&mesh, 12) }).unwrap();
    assert!(body.interface.rigid_motions.is_empty());
    let state = solved(&body, &[1.0]);
    for number in 0..3 {
        for value in body.interface.reaction(number, &state) {
            assert_abs_diff_eq!(value, 0.0, epsilon = 1e-10);
        }
    }
    assert!(stress_error(&body.field(&state).unwrap(), &mesh, |x| exact.stress(x)) < 5e-9);
    // The displacement is the exact one plus the rigid motion that takes the pinned points back.
    let field = body.field(&state).unwrap();
    let origin = exact.displacement(mesh.vertices[0]);
    let turn = (exact.displacement(mesh.vertices[6])[0] - origin[0]) / (mesh.vertices[6][1] - mesh.vertices[0][1]);
    for (xi, eta) in sample_points() {
        let (x, u) = (field.position(2, xi, eta), field.at(2, xi, eta).unwrap().displacement);
        let e = exact.displacement(x);
        let rigid = [turn * (x[1] - mesh.vertices[0][1]), -turn * (x[0] - mesh.vertices[0][0])];
        for k in 0..2 {
            assert_abs_diff_eq!(u[k], e[k] - origin[k] - rigid[k], epsilon = 1e-8);
        }
    }
}

#[test]
fn a_foundation_is_a_spring_along_the_normal_and_the_tangent() {
    // A block pressed by s sinks s / k_n plus its own compression s h / E (nu = 0), and slides t / k_t under shear.
    let mesh = rectangle([0.0, 2.0], [0.0, 1.0]);
    let materials = [Material::isotropic(1000.0, 0.0).unwrap()];
    let supports = [support("left", Direction::First)];
    let load = [vec![traction("top", |_| [0.0, -3.0])]];
    for kept in [None, Some("top"), Some("bottom")] {
        let problem = problem(&mesh, 4, PLANE_STRESS, &materials, &supports, &load, kept);
        let body = Body::new(problem.foundation(Foundation::new("bottom", 50.0, 0.0))).unwrap();
        assert!(body.interface.rigid_motions.is_empty());
        let state = solved(&body, &[1.0]);
        let field = body.field(&state).unwrap();
        assert_relative_eq!(field.at(0, 0.3, -1.0).unwrap().displacement[1], -3.0 / 50.0, max_relative = 1e-11);
        assert_relative_eq!(field.at(0, 0.3, 1.0).unwrap().displacement[1], -3.0 / 50.0 - 3.0 / 1000.0, max_relative = 1e-11);
    }
    let pull = [vec![traction("bottom", |_| [1.0, 0.0])]];
    let problem = problem(&mesh, 3, PLANE_STRESS, &materials, &[], &pull, None);
    let body = Body::new(problem.foundation(Foundation::new("bottom", 50.0, 20.0))).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    assert_relative_eq!(field.at(0, 0.3, -1.0).unwrap().displacement[0], 1.0 / 20.0, max_relative = 1e-11);
}

#[test]
fn additions_that_cannot_be_are_refused() {
    let mesh = rectangle([0.0, 2.0], [0.0, 1.0]);
    let materials = steel();
    let problem = || problem(&mesh, 2, PLANE_STRESS, &materials, &[], &[], Some("top"));
    let fault = |problem| Body::new(problem).err().unwrap();
    let pin = |vertex, direction| BodyProblem { pins: vec![Pin { vertex, direction }], ..problem() };
    let beyond = fault(pin(99, Direction::First));
    assert_eq!(beyond.to_string(), "a pin names vertex 99, but there are 4 in all, counted from 0");
    let along = fault(pin(2, Direction::Normal)).to_string();
    assert!(along.contains("the pin at vertex 2") && !along.contains("boundary"), "{along}");
    let soft = |boundary, normal| problem().foundation(Foundation::new(boundary, normal, 0.0));
    assert!(matches!(fault(soft("bottom", -1.0)), Error::OutOfRange { .. }));
    assert!(matches!(fault(soft("soil", 1.0)), Error::NoSuchBoundary { .. }));
    // A load belongs to a case by its name; a case that is not there cannot act.
    let body = Body::new(problem().load("weight", BodyForce::new(|_| [0.0; 2]))).unwrap();
    assert!(matches!(body.solve(&[("wind", 1.0)]), Err(Error::NoSuchLoadCase { .. })));
    let twice = BodyProblem { load_cases: vec![LoadCase::new("weight"), LoadCase::new("weight")], ..problem() };
    assert!(matches!(fault(twice), Error::DuplicateLoadCase { .. }));
}
