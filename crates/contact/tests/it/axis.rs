//! Surfaces that begin and end on the axis of revolution.

use contact::{ContactLoad, ContactOperator, Pair, Status};
use hpfem::*;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

/// A unit ball, kept from its southern to its northern pole, with a force along the axis on all of it.
fn ball(up: f64) -> Body {
    let s = FRAC_1_SQRT_2;
    let rim = [[0.0, -1.0], [0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [s, -s], [s, s]];
    let inside = [[0.5, 0.0], [0.0, -0.5], [0.4, -0.4], [0.0, 0.5], [0.4, 0.4]];
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let cells = [[1, 7, 8, 6], [7, 0, 4, 8], [8, 4, 3, 6], [1, 6, 10, 9], [6, 3, 5, 10], [9, 10, 5, 2]].map(quad);
    let outline = [[0, 4], [4, 3], [3, 5], [5, 2]];
    let arc = |k: usize| {
        let [from, to] = [k as f64 - 2.0, k as f64 - 1.0].map(|f| f * FRAC_PI_4);
        Curve::Arc { centre: [0.0; 2], radius: 1.0, from, to }
    };
    let curves: Vec<([usize; 2], Curve)> = outline.iter().enumerate().map(|(k, ends)| (*ends, arc(k))).collect();
    let mesh = Mesh::new([&rim[..], &inside].concat(), &cells, &curves, &outline.map(|ends| (ends, "s"))).unwrap();
    let problem = BodyProblem::new(mesh, 6, Kinematics::Axisymmetric).material(Material::isotropic(100.0, 0.3).unwrap());
    Body::new(problem.keep("s").load("weight", BodyForce::new(move |_| [0.0, up]))).unwrap()
}

/// Pressed on a plane below it has the pressures that it has on one above, walked the other way. (At the pole where the surface ends the pressure was infinite.)
#[test]
fn a_ball_presses_with_the_end_of_its_surface_as_with_its_beginning() {
    let [below, above] = [-1.0, 1.0].map(|up: f64| {
        let body = ball(up);
        let operator = ContactOperator::new(&Pair::new(&body.interface, None).unwrap(), false).unwrap();
        let gap: Vec<f64> = operator.points().iter().map(|p| 1.0 - up * p.position[1]).collect();
        let found = operator.solve(&gap, &ContactLoad::factors(&[1.0], &[]), None).unwrap();
        assert_eq!(found.status, Status::Converged);
        found.pressure
    });
    assert!(
        below[0] > 1.0 && below.iter().zip(above.iter().rev()).all(|(a, b)| (a - b).abs() < 1e-9 * below[0]),
        "{below:?} {above:?}"
    );
}
