//! A contact as plain matrices: the same digits as the bodies it was taken from, the same answers as by hand, wrong input refused by name.

use crate::cattaneo_mindlin::{FRICTION, NORMAL, SHEAR, bodies, gap, hertz, push};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact::faer::{Mat, mat};
use contact::*;

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, v| most.max(v.abs()))
}

fn sum(a: &[f64], b: &[f64], factor: f64) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + factor * b).collect()
}

/// Solves a load by the bodies and by their matrices, from the same slip before, and compares all that both give.
fn compare(operator: &ContactOperator<'_>, load: &ContactLoad) -> (ContactSolution, MatrixSolution) {
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let by_bodies = operator.solve(&gap, load, None).unwrap();
    let (contact, unloaded) = operator.matrices(load).unwrap();
    let friction = match load.friction.clone() {
        Friction::Coulomb { coefficient, slip_before } => {
            Friction::Coulomb { coefficient, slip_before: sum(&slip_before, &unloaded.slip, -1.0) }
        }
        other => other,
    };
    let plain = contact.solve(&sum(&gap, &unloaded.opening, 1.0), &unloaded.forces, &friction, None).unwrap();
    assert_eq!(plain.status, by_bodies.status);
    assert_eq!(plain.states, by_bodies.states);
    assert_eq!((plain.iterations, plain.took_over), (by_bodies.iterations, by_bodies.took_over));
    let both = [
        (&plain.pressure, &by_bodies.pressure),
        (&plain.shear, &by_bodies.shear),
        (&plain.opening, &by_bodies.opening),
        (&plain.nodal_force, &by_bodies.nodal_force),
    ];
    for (a, b) in both {
        assert!(largest(&sum(a, b, -1.0)) <= 1e-11 * largest(b));
    }
    assert!(plain.balance < 1e-12 && plain.complementarity < 1e-10);
    assert!(largest(&sum(&sum(&plain.slip, &unloaded.slip, 1.0), &by_bodies.slip, -1.0)) <= 1e-9 * largest(&by_bodies.slip));
    (by_bodies, plain)
}

#[test]
fn matrices_of_two_bodies_give_the_digits_of_the_bodies() {
    let a = hertz(NORMAL).0;
    let bodies = bodies(&[0.22 * a, a], 1.3, 6, 2);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let none = vec![0.0; operator.points().len()];

    let press = ContactLoad { friction: Friction::None, ..push(NORMAL, 0.0, &[]) };
    let (pressed, plain) = compare(&operator, &press);
    assert_eq!(pressed.pressure, plain.pressure);
    let moved =
        ContactLoad { motions: [Motion::Free { resultant: 0.0 }, Motion::Prescribed { value: -1e-3 }, Motion::FREE], ..press };
    assert_eq!(compare(&operator, &moved).1.motions.len(), 1);

    let (_, sheared) = compare(&operator, &push(NORMAL, SHEAR, &pressed.slip));
    assert_abs_diff_eq!(sheared.nodal_shear.iter().sum::<f64>(), -SHEAR, epsilon = 1e-9);
    assert!([ContactState::Open, ContactState::Stick, ContactState::Backward].iter().all(|state| sheared.states.contains(state)));
    compare(&operator, &push(NORMAL, 0.9 * FRICTION * NORMAL, &none));

    let held = [Motion::Prescribed { value: 0.0 }, Motion::Free { resultant: -NORMAL }, Motion::FREE];
    let slide = ContactLoad { motions: held, friction: Friction::None, ..push(NORMAL, 0.0, &[]) };
    compare(&operator, &slide.sliding(FRICTION, vec![1.0; none.len()]));
}

#[test]
fn a_system_for_wear_is_that_of_the_bodies() {
    let bodies = bodies(&[hertz(NORMAL).0], 1.3, 4, 0);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let load =
        ContactLoad { friction: Friction::None, ..push(NORMAL, 0.0, &[]) }.sliding(0.2, vec![-1.0; operator.points().len()]);
    let (contact, unloaded) = operator.matrices(&load).unwrap();
    let (plain, whole) = (contact.system(&unloaded.forces, &load.friction).unwrap(), operator.system(&load).unwrap());
    assert_eq!((&plain.compliance, &plain.balance), (&whole.compliance, &whole.balance));
    assert_eq!((&plain.load, plain.symmetric), (&whole.load, false));
}

/// Two points, coupled.
fn springs() -> Mat<f64> {
    mat![[2.0, 0.5], [0.5, 1.0]]
}

#[test]
fn a_compliance_and_its_inverse_as_a_stiffness_are_one_contact() {
    let compliance = springs();
    let determinant = 2.0 - 0.25;
    let stiffness = mat![[1.0 / determinant, -0.5 / determinant], [-0.5 / determinant, 2.0 / determinant]];
    let weights = [0.5, 2.0];
    let one = MatrixContact::from_compliance(&compliance, &weights, &Motions::none(2)).unwrap();
    let two = MatrixContact::from_stiffness(&stiffness, &weights, &Motions::none(2)).unwrap();
    let [a, b] = [one, two].map(|contact| contact.solve(&[-1.0, -0.1], &[], &Friction::None, None).unwrap());
    // By hand: the first point alone carries 1 / 2 and lifts the second by 1 / 4, which opens it.
    assert_eq!(a.states, [ContactState::Stick, ContactState::Open]);
    assert_relative_eq!(a.pressure[0], 1.0, max_relative = 1e-14);
    assert_relative_eq!(a.opening[1], 0.15, max_relative = 1e-14);
    assert_relative_eq!(b.pressure[0], 1.0, max_relative = 1e-14);
    assert!(a.slip.is_empty() && b.slip.is_empty());
}

/// One point on a normal and a tangential spring of 1 and 4, pushed together by 3 and along by 2: it sticks up to the friction 2 / 3 and slips
/// below, when a spring of 10 on the shift takes the rest.
#[test]
fn one_point_sticks_and_slips_by_hand() {
    let compliance = mat![[1.0, 0.0], [0.0, 4.0]];
    let stiffness = mat![[0.0, 0.0], [0.0, 10.0]];
    let motions = Motions { opening: mat![[-1.0, 0.0]], slip: mat![[0.0, 1.0]], stiffness };
    let contact = MatrixContact::from_compliance(&compliance, &[1.0], &motions).unwrap();
    assert!(contact.has_shear() && contact.points() == 1);
    let solve = |coefficient| {
        let friction = Friction::Coulomb { coefficient, slip_before: vec![0.0] };
        contact.solve(&[0.0], &[3.0, 2.0], &friction, None).unwrap()
    };
    // Stick: slip 4 sigma + y = 0 and 10 y = 2 + sigma, so sigma = -2 / 41.
    let stuck = solve(0.5);
    assert_eq!(stuck.states, [ContactState::Stick]);
    assert_relative_eq!(stuck.nodal_shear[0], -2.0 / 41.0, max_relative = 1e-13);
    assert_relative_eq!(stuck.motions[1], 8.0 / 41.0, max_relative = 1e-13);
    // Slip at 0.01: sigma = -0.03, y = 0.197, slip 0.077.
    let slipping = solve(0.01);
    assert_eq!(slipping.states, [ContactState::Backward]);
    assert_relative_eq!(slipping.nodal_shear[0], -0.03, max_relative = 1e-13);
    assert_relative_eq!(slipping.slip[0], 0.077, max_relative = 1e-12);
    let friction = Friction::Coulomb { coefficient: 0.01, slip_before: vec![0.0] };
    let warm = contact.solve(&[0.0], &[3.0, 2.0], &friction, Some(&slipping)).unwrap();
    assert_eq!((warm.nodal_shear[0], warm.iterations), (slipping.nodal_shear[0], 1));
}

#[test]
fn a_load_that_pulls_has_no_balance() {
    let motions = Motions::free(mat![[-1.0], [-1.0]], Mat::zeros(2, 1));
    let contact = MatrixContact::from_compliance(&springs(), &[1.0; 2], &motions).unwrap();
    assert_eq!(contact.solve(&[0.0; 2], &[-1.0], &Friction::None, None).unwrap().status, Status::NoBalance);
}

#[test]
fn matrices_that_do_not_fit_are_refused_by_name() {
    let refused = |compliance: Mat<f64>, weights: &[f64], motions: Motions| {
        MatrixContact::from_compliance(&compliance, weights, &motions).unwrap_err()
    };
    let error = refused(Mat::identity(3, 3), &[1.0; 2], Motions::none(2));
    assert_eq!(error, Error::Shape { name: "compliance", wanted: [2, 2], given: [3, 3] });
    assert_eq!(error.to_string(), "the compliance must be 2 x 2; it is 3 x 3");
    let error = refused(mat![[1.0, 0.1], [0.2, 1.0]], &[1.0; 2], Motions::none(2));
    assert_eq!(error, Error::NotSymmetric { name: "compliance", row: 1, column: 0, below: 0.2, above: 0.1 });
    let error = refused(mat![[1.0, f64::NAN], [0.2, 1.0]], &[1.0; 2], Motions::none(2));
    assert_eq!(error, Error::NotFinite { name: "compliance", row: 0, column: 1 });
    let error = refused(mat![[1.0, 0.0], [0.0, -1.0]], &[1.0; 2], Motions::none(2));
    assert_eq!(error, Error::NotPositive { name: "compliance", place: 1, value: -1.0 });
    let error = refused(springs(), &[1.0, 0.0], Motions::none(2));
    assert_eq!(error, Error::NotPositive { name: "weights", place: 1, value: 0.0 });
    let error = refused(springs(), &[1.0; 2], Motions::none(3));
    assert_eq!(error, Error::Shape { name: "opening by the motions", wanted: [2, 0], given: [3, 0] });
    let error = refused(springs(), &[1.0; 2], Motions::free(Mat::zeros(2, 1), Mat::zeros(2, 2)));
    assert_eq!(error, Error::Shape { name: "slip by the motions", wanted: [2, 1], given: [2, 2] });
    let error = refused(springs(), &[1.0; 2], Motions { stiffness: Mat::zeros(1, 1), ..Motions::none(2) });
    assert_eq!(error, Error::Shape { name: "stiffness of the motions", wanted: [0, 0], given: [1, 1] });
    let error = MatrixContact::from_stiffness(&mat![[1.0, 2.0], [2.0, 1.0]], &[1.0; 2], &Motions::none(2)).unwrap_err();
    assert_eq!(error, Error::NotDefinite);
}

#[test]
fn gaps_forces_and_friction_that_do_not_fit_are_refused_by_name() {
    let motions = Motions::free(mat![[-1.0], [-1.0]], Mat::zeros(2, 1));
    let contact = MatrixContact::from_compliance(&springs(), &[1.0; 2], &motions).unwrap();
    let refused = |gap: &[f64], forces: &[f64], friction: Friction| contact.solve(gap, forces, &friction, None).unwrap_err();
    assert_eq!(refused(&[0.0], &[1.0], Friction::None), Error::Gap { given: 1, points: 2 });
    let error = refused(&[0.0; 2], &[], Friction::None);
    assert_eq!(error, Error::Shape { name: "forces along the motions", wanted: [1, 1], given: [0, 1] });
    let error = refused(&[0.0; 2], &[f64::INFINITY], Friction::None);
    assert_eq!(error, Error::NotFinite { name: "forces along the motions", row: 0, column: 0 });
    let coulomb = Friction::Coulomb { coefficient: 0.1, slip_before: vec![0.0; 2] };
    assert_eq!(refused(&[0.0; 2], &[1.0], coulomb), Error::ShearNotPrepared);
    let sliding = Friction::Sliding { coefficient: 0.1, drag: vec![1.0; 3] };
    assert_eq!(refused(&[0.0; 2], &[1.0], sliding), Error::Drag { coefficient: 0.1, given: 3, points: 2 });
    let other = MatrixContact::from_compliance(&mat![[1.0]], &[1.0], &Motions::none(1)).unwrap();
    let earlier = other.solve(&[-1.0], &[], &Friction::None, None).unwrap();
    let error = contact.solve(&[0.0; 2], &[1.0], &Friction::None, Some(&earlier)).unwrap_err();
    assert_eq!(error, Error::Shape { name: "earlier solution", wanted: [2, 1], given: [1, 1] });
}
