//! Full contact without a gap, against a converged high-order computation of the same bodies.

use crate::common::at_arc;
use crate::common::drum::{Drum, HALF_ANGLE, RADIUS};
use crate::common::punch::Punch;
use approx::assert_relative_eq;
use contact::{ContactLoad, ContactOperator, Motion, Pair, Status};

/// Pressure at angles in degrees from the vertical, and the force, for `10 kN` on the shoe and the drum turning anti-clockwise.
fn drum_pressures(friction: f64, degree: usize, layers: usize, angles: &[f64]) -> (Vec<f64>, [f64; 2]) {
    let drum = Drum::new(degree, layers, [210e3; 2]);
    let (shoe, ring) = drum.bodies();
    let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
    let operator = ContactOperator::new(&pair, friction > 0.0).unwrap();
    let n = operator.points().len();
    let load = ContactLoad::factors(&[1.0], &[]).sliding(friction, vec![-1.0; n]);
    let solution = operator.solve(&vec![0.0; n], &load, None).unwrap();
    println!("{} points {} {:?}", solution.status, n, solution.iterations);
    println!("complementarity {:.2e} balance {:.2e}", solution.complementarity, solution.balance);
    assert_eq!(solution.status, Status::ClosedEverywhere);
    let pressure = angles.iter().map(|a| at_arc(&operator, &solution.pressure, RADIUS * (a.to_radians() + HALF_ANGLE))).collect();
    (pressure, solution.force)
}

#[test]
fn block_shoe_without_friction_has_the_reference_pressure() {
    let (pressure, force) = drum_pressures(0.0, 12, 10, &[0.0, 15.0, 22.5, 28.5]);
    println!("{pressure:.8?} {force:?}");
    for (p, reference) in pressure.iter().zip([5.2365658, 4.7995967, 4.45938, 5.38058]) {
        assert_relative_eq!(*p, reference, max_relative = 1e-5);
    }
    assert_relative_eq!(force[1], 10000.0, max_relative = 1e-10);
}

#[test]
fn sliding_block_shoe_has_the_reference_pressure_and_force() {
    let (pressure, force) = drum_pressures(0.25, 12, 10, &[-28.5, -15.0, 0.0, 15.0, 28.5]);
    println!("{pressure:.8?} {force:?}");
    for (p, reference) in pressure.iter().zip([5.66864, 4.588661, 5.2266841, 5.007868, 5.08098]) {
        assert_relative_eq!(*p, reference, max_relative = 1e-5);
    }
    assert_relative_eq!(force[0], -2491.92, max_relative = 1e-5);
    assert_relative_eq!(force[1], 10000.0, max_relative = 1e-10);
}

fn punch_pressures(friction: f64, at: &[f64]) -> (Vec<f64>, f64) {
    let punch = Punch::translating(12, 10, [false, true, false]);
    let (body, plate) = punch.bodies();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, friction > 0.0).unwrap();
    let n = operator.points().len();
    let mut load = ContactLoad::factors(&[], &[]).sliding(friction, vec![1.0; n]);
    load.motions[1] = Motion::Free { resultant: -1000.0 };
    let solution = operator.solve(&vec![0.0; n], &load, None).unwrap();
    println!("{} {}", solution.status, solution.iterations);
    assert!(solution.status.is_solved());
    let pressure = at.iter().map(|x| at_arc(&operator, &solution.pressure, x + 30.0)).collect();
    (pressure, -solution.coordinates[0][0])
}

#[test]
fn guided_punch_without_friction_has_the_reference_pressure_and_approach() {
    let (pressure, approach) = punch_pressures(0.0, &[0.0]);
    println!("{pressure:.8?} {approach:.12e}");
    assert_relative_eq!(pressure[0], 1.457778, max_relative = 1e-5);
    assert_relative_eq!(approach, 1.31025687e-3, max_relative = 1e-7);
}

#[test]
fn sliding_guided_punch_has_the_reference_pressure() {
    let (pressure, _) = punch_pressures(0.25, &[-28.5, 0.0, 28.5]);
    println!("{pressure:.8?}");
    for (p, reference) in pressure.iter().zip([4.29700, 1.4242307, 0.5811075]) {
        assert_relative_eq!(*p, reference, max_relative = 1e-5);
    }
}

#[test]
fn annular_punch_has_the_reference_pressure() {
    let punch = Punch::annular(16, 10);
    let (body, disc) = punch.bodies();
    let pair = Pair::new(&body.interface, Some(&disc.interface)).unwrap();
    let operator = ContactOperator::new(&pair, false).unwrap();
    let gap = vec![0.0; operator.points().len()];
    let solution = operator.solve(&gap, &ContactLoad::factors(&[1.0], &[]), None).unwrap();
    assert_eq!(solution.status, Status::ClosedEverywhere);
    for (r, reference) in [(22.5, 119.197), (70.0, 97.9175), (107.5, 94.743)] {
        let p = at_arc(&operator, &solution.pressure, r - 20.0);
        println!("{r} {p:.8}");
        assert_relative_eq!(p, reference, max_relative = 1e-5);
    }
}
