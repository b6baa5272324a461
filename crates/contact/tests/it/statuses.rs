//! Problems without an answer, and problems that look hard, are told apart by name.

use crate::common::drum::Drum;
use crate::common::punch::Punch;
use crate::common::wedge;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact::*;

fn drum(friction: f64, drag: f64, force: f64) -> ContactSolution {
    let drum = Drum::new(6, 4, [210e3; 2]);
    let (shoe, ring) = drum.bodies();
    let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    let load = ContactLoad::factors(&[force], &[]).sliding(friction, vec![drag; n]);
    operator.solve(&vec![0.0; n], &load, None).unwrap()
}

/// Punch with a rigid top edge; `[t_x, t_z, theta]`.
fn punch(free: [bool; 3], motions: [Motion; 3], friction: f64) -> ContactSolution {
    let punch = Punch::translating(6, 4, free);
    let (body, plate) = punch.bodies();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    let load = ContactLoad { motions, ..ContactLoad::factors(&[], &[]).sliding(friction, vec![1.0; n]) };
    operator.solve(&vec![0.0; n], &load, None).unwrap()
}

#[test]
fn a_load_that_pulls_has_no_balance() {
    assert_eq!(drum(0.0, -1.0, -1.0).status, Status::NoBalance);
    assert_eq!(drum(0.3, -1.0, -1.0).status, Status::NoBalance);
}

#[test]
fn a_moment_beyond_the_edge_of_the_punch_has_no_balance() {
    let load = |moment| [Motion::FREE, Motion::Free { resultant: -1000.0 }, Motion::Free { resultant: moment }];
    let inside = punch([false, true, true], load(-1000.0 * 29.0), 0.0);
    println!("{} {}", inside.status, inside.iterations);
    assert_eq!(inside.status, Status::Converged);
    assert_relative_eq!(inside.moment, 1000.0 * 29.0, max_relative = 1e-9);
    assert_eq!(punch([false, true, true], load(-1000.0 * 31.0), 0.0).status, Status::NoBalance);
}

#[test]
fn a_punch_held_off_the_plate_has_no_contact() {
    let held = |value| [Motion::FREE, Motion::Prescribed { value }, Motion::FREE];
    let off = punch([false, true, false], held(1e-3), 0.0);
    assert_eq!(off.status, Status::NoContact);
    assert!(off.opening.iter().all(|w| (w - 1e-3).abs() < 1e-15) && off.force == [0.0, 0.0]);
    assert_eq!(punch([false, true, false], held(-1e-3), 0.0).status, Status::ClosedEverywhere);
}

#[test]
fn prescribed_approach_gives_back_the_force_that_causes_it() {
    let free = punch([false, true, false], [Motion::FREE, Motion::Free { resultant: -1000.0 }, Motion::FREE], 0.25);
    let value = free.coordinates[0][0];
    let held = punch([false, true, false], [Motion::FREE, Motion::Prescribed { value }, Motion::FREE], 0.25);
    assert_relative_eq!(held.force[1], 1000.0, max_relative = 1e-10);
    // A spring carries its share: F = F_contact + k (z - rest), with the rest position chosen so that the contact carries half.
    let stiffness = 500.0 / value.abs();
    let half = punch([false, true, false], [Motion::FREE, Motion::Sprung { stiffness, rest: 2.0 * value }, Motion::FREE], 0.25);
    assert_relative_eq!(
        half.coordinates[0][0],
        value * 2.0 * stiffness / (stiffness + 1000.0 / value.abs()),
        max_relative = 1e-9
    );
}

#[test]
fn tilted_punch_opens_on_one_side_and_the_guide_takes_the_moment_of_the_shear() {
    let load = [Motion::FREE, Motion::Free { resultant: -1000.0 }, Motion::Free { resultant: 0.0 }];
    let punch_body = Punch::translating(6, 4, [false, true, true]);
    let (body, plate) = punch_body.bodies();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    let mut given = ContactLoad { motions: load, ..ContactLoad::factors(&[], &[]).sliding(0.25, vec![1.0; n]) };
    let whole = operator.solve(&vec![0.0; n], &given, None).unwrap();
    given.moment = MomentBalance::Pressure;
    let guided = operator.solve(&vec![0.0; n], &given, None).unwrap();
    let pressure_moment =
        |s: &ContactSolution| -> f64 { operator.points().iter().zip(&s.nodal_force).map(|(p, f)| p.position[0] * f).sum() };
    // About (0, 200): x f_z - (z - 200) f_x vanishes for the whole traction; for the guided one only the pressure's part does.
    assert_abs_diff_eq!(pressure_moment(&whole) + 100.0 * whole.force[0], 0.0, epsilon = 1e-7);
    assert_abs_diff_eq!(pressure_moment(&guided), 0.0, epsilon = 1e-7);
    assert_eq!(whole.status, Status::Converged);
}

/// ```text
///        G
///     ___|___
///    |       | <- F        F / G = (tan a + mu) / (1 - mu tan a)
///    |    __-
///    |_-- a                NAFEMS, Benchmark tests for contact, CGS-4: tan a = 0.1, mu = 0.3: 0.412371
/// ```
#[test]
fn wedge_needs_the_force_of_the_closed_form_and_jams_beyond_it() {
    let push = |slope: f64, friction: f64| {
        let (wedge, plane) = wedge::bodies(slope);
        let pair = Pair::new(&wedge, Some(&plane)).unwrap();
        let operator = ContactOperator::new(&pair, true).unwrap();
        let n = operator.points().len();
        // The plane moves towards -x relative to the wedge pushed along +x.
        let mut load = ContactLoad::factors(&[], &[]).sliding(friction, vec![-1.0; n]);
        load.motions = [Motion::Prescribed { value: 0.0 }, Motion::Free { resultant: -1500.0 }, Motion::FREE];
        operator.solve(&vec![0.0; n], &load, None).unwrap()
    };
    let solution = push(0.1, 0.3);
    assert!(solution.status.is_solved(), "{}", solution.status);
    assert_relative_eq!(-solution.force[0] / solution.force[1], 0.4 / 0.97, max_relative = 1e-12);
    assert!(push(0.6, 1.0).status.is_solved());
    assert_eq!(push(0.6, 2.0).status, Status::Jammed);
}

#[test]
fn friction_up_to_two_is_solved_or_refused_by_name_on_the_drum() {
    let drum = Drum::new(6, 4, [210e3; 2]);
    let (shoe, ring) = drum.bodies();
    let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    for tenths in 0..=20 {
        for drag in [-1.0, 1.0] {
            let friction = 0.1 * f64::from(tenths);
            let load = ContactLoad::factors(&[1.0], &[]).sliding(friction, vec![drag; n]);
            let solution = operator.solve(&vec![0.0; n], &load, None).unwrap();
            assert!(!matches!(solution.status, Status::IterationLimit { .. }), "mu {friction}: {}", solution.status);
            if solution.status.is_solved() {
                assert!(solution.complementarity < 1e-10 && solution.balance < 1e-10);
                assert!(solution.iterations <= 30 && !solution.took_over);
            }
        }
    }
}

#[test]
fn wedge_jams_from_the_friction_of_the_closed_form_on_and_not_before() {
    // F / G grows beyond all bounds at mu = 1 / tan a.
    let slope = 0.6;
    let (wedge, plane) = wedge::bodies(slope);
    let pair = Pair::new(&wedge, Some(&plane)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    for friction in [0.0, 0.5, 1.0, 1.5, 1.6, 1.66, 1.67, 1.7, 1.8, 2.0] {
        let mut load = ContactLoad::factors(&[], &[]).sliding(friction, vec![-1.0; n]);
        load.motions = [Motion::Prescribed { value: 0.0 }, Motion::Free { resultant: -1500.0 }, Motion::FREE];
        let solution = operator.solve(&vec![0.0; n], &load, None).unwrap();
        println!("mu {friction}: {}", solution.status);
        if friction * slope < 1.0 {
            assert!(solution.status.is_solved());
            let force = -solution.force[0] / solution.force[1];
            assert_relative_eq!(force, (slope + friction) / (1.0 - friction * slope), max_relative = 1e-8);
        } else {
            assert_eq!(solution.status, Status::Jammed);
        }
    }
}

#[test]
fn loads_from_tiny_to_huge_give_the_same_pressure_per_load() {
    let unit = drum(0.25, -1.0, 1.0);
    for force in [1e-12, 1e-6, 1e6, 1e12] {
        let scaled = drum(0.25, -1.0, force);
        assert_eq!(scaled.status, unit.status);
        for (p, q) in scaled.pressure.iter().zip(&unit.pressure) {
            assert_relative_eq!(p / force, *q, max_relative = 1e-9);
        }
    }
    // Bit for bit for powers of two.
    let scaled = drum(0.25, -1.0, 2.0_f64.powi(-40));
    for (p, q) in scaled.pressure.iter().zip(&unit.pressure) {
        assert_eq!(p.to_bits(), (q * 2.0_f64.powi(-40)).to_bits());
    }
}

#[test]
fn stiffness_ratios_and_unequal_degrees_do_not_make_the_pressure_oscillate() {
    let pressures = |young: [f64; 2], degrees: [usize; 2]| {
        let drum = Drum::new(8, 4, young);
        let (shoe, ring) = drum.bodies_of_degrees(degrees);
        let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
        let operator = ContactOperator::new(&pair, false).unwrap();
        let n = operator.points().len();
        let solution = operator.solve(&vec![0.0; n], &ContactLoad::factors(&[1.0], &[]), None).unwrap();
        assert!(solution.status.is_solved(), "{young:?} {degrees:?} {}", solution.status);
        let inner: Vec<f64> =
            (0..n).filter(|i| (operator.points()[*i].arc - 104.72).abs() < 85.0).map(|i| solution.pressure[i]).collect();
        // Total variation of the half where the pressure falls monotonically, per its fall.
        let middle = inner.len() / 2;
        let half = &inner[middle..];
        let variation: f64 = half.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
        let fall = half.iter().copied().fold(f64::MIN, f64::max) - half.iter().copied().fold(f64::MAX, f64::min);
        println!("{young:?} {degrees:?}: {} points, variation/fall {:.3}", n, variation / fall);
        variation / fall
    };
    for ratio in [1e-6, 1.0, 1e6] {
        for degrees in [[8, 8], [12, 5], [5, 12]] {
            // Monotone but for the rise towards the end of contact.
            assert!(pressures([210e3 * ratio, 210e3], degrees) < 1.2);
        }
    }
}

/// Shear turns the punch until the whole surface touches, and the points beside the last open ones carry forces of round-off: their signs
/// decide nothing, and the solver does not go round in circles over them.
#[test]
fn forces_of_round_off_do_not_keep_the_solver_from_an_answer() {
    for (degree, friction) in [(6, 0.25), (12, 0.3), (14, 0.25), (17, 0.2), (18, 0.2)] {
        let punch = Punch::translating(degree, degree, [false, true, true]);
        let (body, plate) = punch.bodies();
        let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
        let operator = ContactOperator::new(&pair, true).unwrap();
        let n = operator.points().len();
        let motions = [Motion::FREE, Motion::Free { resultant: -1000.0 }, Motion::Free { resultant: -1000.0 * 20.0 }];
        let load = ContactLoad { motions, ..ContactLoad::factors(&[], &[]).sliding(friction, vec![1.0; n]) };
        let first = operator.solve(&vec![0.0; n], &load, None).unwrap();
        // What round-off has left open beside a point under pressure is closed exactly.
        let touches = |i: usize| first.pressure.get(i).is_some_and(|p| *p > 0.0);
        let beside = |i: usize| first.opening[i] > 0.0 && (touches(i.wrapping_sub(1)) || touches(i + 1));
        let gap: Vec<f64> = (0..n).map(|i| if beside(i) { -first.opening[i] } else { 0.0 }).collect();
        let again = operator.solve(&gap, &load, None).unwrap();
        println!("degree {degree}, friction {friction}: {} systems, {}", again.iterations, again.status);
        assert!(first.status.is_solved() && again.status.is_solved(), "{} {}", first.status, again.status);
        assert!(again.iterations <= 30, "{}", again.iterations);
        let largest = first.pressure.iter().copied().fold(0.0, f64::max);
        let inner = (0..n).filter(|i| operator.points()[*i].weight > 1e-3);
        let change = inner.map(|i| (again.pressure[i] - first.pressure[i]).abs()).fold(0.0, f64::max);
        assert!(change < 1e-6 * largest, "{change}");
    }
}
