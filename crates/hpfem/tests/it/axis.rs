//! Kept boundaries and edges that meet the axis of revolution, or would cross it.

use hpfem::*;
use std::f64::consts::{PI, TAU};

/// A unit ball from its southern to its northern pole; the angles of its arcs are turned by so much.
fn ball(turned: f64) -> Mesh {
    let triangle = |a, b| Quad { corners: [0, a, b, b], material: 0, layer: 0 };
    let arc = |from: f64, to: f64| Curve::Arc { centre: [0.0; 2], radius: 1.0, from: from + turned, to: to + turned };
    let curves = [([1, 2], arc(-0.5 * PI, 0.0)), ([2, 3], arc(0.0, 0.5 * PI))];
    let vertices = vec![[0.0, 0.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
    Mesh::new(vertices, &[triangle(1, 2), triangle(2, 3)], &curves, &[([1, 2], "s"), ([2, 3], "s")]).unwrap()
}

#[test]
fn a_kept_boundary_from_pole_to_pole_has_the_same_weights_from_both_ends() {
    for turned in [0.0, -TAU, TAU] {
        let problem =
            BodyProblem::new(ball(turned), 6, Kinematics::Axisymmetric).material(Material::isotropic(1.0, 0.3).unwrap());
        let body = Body::new(problem.keep("s")).unwrap();
        let weights: Vec<f64> = body.interface.trace.points.iter().map(|point| point.weight).collect();
        // (The last pole had 7e-18, or -2e-17 where the angles were turned.)
        assert!(weights.iter().zip(weights.iter().rev()).all(|(a, b)| *a > 1e-3 && (a / b - 1.0).abs() < 1e-12), "{weights:?}");
        assert!((weights.iter().sum::<f64>() / (4.0 * PI) - 1.0).abs() < 1e-8);
        assert!(InterfaceOperator::from_parts(body.interface.into_parts()).is_ok());
    }
}

#[test]
fn a_curved_edge_that_crosses_the_axis_is_refused_and_one_that_touches_it_is_not() {
    let with_waist = |depth: f64| {
        let waist = Curve::interpolated(2, move |t| [0.3 - (0.3 + depth) * (1.0 - t * t), 0.5 + 0.5 * t]);
        let corners = vec![[0.3, 0.0], [1.0, 0.0], [1.0, 1.0], [0.3, 1.0]];
        let cell = Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 };
        let mesh = Mesh::new(corners, &[cell], &[([0, 3], waist)], &[([0, 1], "bottom")]).unwrap();
        let problem = BodyProblem::new(mesh, 4, Kinematics::Axisymmetric).material(Material::isotropic(1.0, 0.3).unwrap());
        Body::new(problem.roller("bottom"))
    };
    assert!(with_waist(-0.05).is_ok());
    for depth in [1e-4, 0.01, 0.1] {
        let Err(Error::OutOfRange { quantity, value, .. }) = with_waist(depth) else { panic!("{depth} is accepted") };
        assert!(quantity.contains("radius of edge") && (value / depth + 1.0).abs() < 1e-9, "{quantity} {value}");
    }
}

#[test]
fn a_force_on_the_axis_that_moves_nothing_is_refused() {
    let force = |at: [f64; 2], force: [f64; 2]| {
        let corners = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let cell = Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 };
        let mesh = Mesh::new(corners, &[cell], &[], &[([0, 1], "bottom")]).unwrap();
        let problem = BodyProblem::new(mesh, 4, Kinematics::Axisymmetric).material(Material::isotropic(1.0, 0.3).unwrap());
        Body::new(problem.roller("bottom").load("point", PointForce::new(at, force)))
    };
    assert!(force([0.0, 0.5], [0.0, 1.0]).is_ok() && force([0.5, 0.5], [1.0, 0.0]).is_ok());
    assert!(matches!(force([0.0, 0.5], [1.0, 0.0]), Err(Error::NoMeaning { .. })));
}
