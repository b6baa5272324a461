//! A wear rule of one's own in the wear in time and in the tolerances: the built-in power law as a function gives its numbers.

use crate::closed_form::{gap_for, half_plane, points, problem, rule};
use approx::assert_relative_eq;
use shapeopt::{Evolution, WearProblem, WearState, tolerances};
use wear::{Counterface, OwnRule, WearLaw, WearPair};

const MODULUS: f64 = 115e3;
const FACTOR: f64 = 1e-7;

/// `k p^b v` as a function.
fn own(factor: f64, b: f64) -> OwnRule {
    let law = WearLaw { factor, speed_exponent: 1.0, pressure_exponent: b };
    OwnRule::new(move |pressure, speed| {
        let rate = wear::wear_rate(&law, pressure, speed);
        [rate, b * rate / pressure]
    })
}

fn ended(problem: &WearProblem) -> (WearState, Vec<f64>) {
    let mut evolution = Evolution::new(problem).unwrap();
    evolution.by_ref().for_each(drop);
    let times = evolution.run_in().unwrap().times;
    (evolution.state().clone(), times)
}

/// A wedge on a half-plane, which opens at its start and ends in full contact.
#[test]
fn a_power_law_as_a_function_wears_as_the_built_in_law_in_time() {
    for b in [0.5, 1.0, 2.0] {
        let points = points(40);
        let system = half_plane(&points, None, MODULUS);
        let gap: Vec<f64> = points.iter().map(|p| 4e-6 * (p.position.x + 30.0)).collect();
        let built_in = problem(points.clone(), system.clone(), rule(FACTOR, b), gap.clone());
        let given = problem(points, system, WearPair::alone(own(FACTOR, b)), gap);
        let [(expected, times), (found, own_times)] = [&built_in, &given].map(ended);
        assert_eq!((found.step, found.rejected), (expected.step, expected.rejected));
        assert_relative_eq!(found.time, expected.time, max_relative = 1e-6);
        assert_relative_eq!(found.depth, expected.depth, max_relative = 1e-6);
        assert_relative_eq!(found.lyapunov, expected.lyapunov, max_relative = 1e-6);
        assert!(found.lyapunov_increase < 1e-12);
        for (a, b) in found.pressure.iter().zip(&expected.pressure) {
            assert_relative_eq!(*a, *b, max_relative = 1e-7);
        }
        for (a, b) in own_times.iter().zip(&times) {
            assert_relative_eq!(*a, *b, max_relative = 1e-6);
        }
    }
}

/// Body 1 by a function, body 2 by a power law and the other way round, on the same points and along a closed track.
#[test]
fn two_bodies_may_wear_by_different_kinds_of_rules() {
    for counterface in [Counterface::Congruent, Counterface::Revolving] {
        let points = points(20);
        let system = half_plane(&points, None, MODULUS);
        let gap: Vec<f64> = points.iter().map(|p| 1e-6 * (p.position.x + 30.0)).collect();
        let power = WearPair::archard([FACTOR, 0.5 * FACTOR], [1.0; 2], [2.0, 0.7]);
        let run = |wear: WearPair| {
            let mut run = WearProblem::new(points.clone(), wear, counterface, gap.clone(), system.clone());
            run.track_area = Some(2000.0);
            ended(&run).0
        };
        let expected = run(power.clone());
        let [first, second] = power.rules.clone();
        let own_first = WearPair { rules: [own(FACTOR, 2.0).into(), second], ..power.clone() };
        let own_second = WearPair { rules: [first, own(0.5 * FACTOR, 0.7).into()], ..power };
        for wear in [own_first, own_second] {
            let found = run(wear);
            for body in 0..2 {
                assert_relative_eq!(found.volume[body], expected.volume[body], max_relative = 1e-6);
            }
            assert_relative_eq!(found.recession, expected.recession, max_relative = 1e-6);
            for (a, b) in found.pressure.iter().zip(&expected.pressure) {
                assert_relative_eq!(*a, *b, max_relative = 1e-7);
            }
        }
    }
}

#[test]
fn a_power_law_as_a_function_has_the_tolerances_of_the_built_in_law() {
    let points = points(40);
    let system = half_plane(&points, None, MODULUS);
    let gap = gap_for(&system, &points, |_| 5.0 / 3.0);
    let errors: Vec<Vec<f64>> =
        [10.0, 5.0].iter().map(|length| points.iter().map(|p| 1e-6 * (p.position.x / length).cos()).collect()).collect();
    let pressure = vec![5.0 / 3.0; points.len()];
    let of =
        |wear: WearPair| tolerances(&problem(points.clone(), system.clone(), wear, gap.clone()), &pressure, &errors).unwrap();
    for (found, expected) in of(WearPair::alone(own(FACTOR, 1.7))).iter().zip(&of(rule(FACTOR, 1.7))) {
        assert_eq!(found.change, expected.change);
        assert_relative_eq!(found.run_in_distance.unwrap(), expected.run_in_distance.unwrap(), max_relative = 1e-12);
    }
}
