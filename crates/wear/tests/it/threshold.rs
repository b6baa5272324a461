//! The wear rule with a threshold pressure: closed forms, and the least of its functionals by exchange of force between points.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use proptest::prelude::*;
use wear::{
    Character, Functional, OwnRule, Problem, Regime, RigidMode, Rule, Surface, SurfacePoint, ThresholdLaw, WearError, WearLaw,
    WearPair, functional_value, one_percent, optimal_pressure, resisted_pressure,
};

use crate::surfaces::{annulus, drum, drum_at, plane_at, punch};

const FACTOR: f64 = 1e-6;
const P0: f64 = 0.4;

fn above(b: f64) -> ThresholdLaw {
    ThresholdLaw { law: WearLaw { factor: FACTOR, speed_exponent: 1.0, pressure_exponent: b }, threshold: P0 }
}

#[test]
fn rate_slope_inverse_and_potential_of_a_point_by_hand() {
    // p = 0.9, v = 5, b = 2: w' = 1e-6 * 0.25 * 5, slope 1e-6 * 2 * 0.5 * 5, potential 1e-6 * 0.125/3 * 5.
    let rule = Rule::from(above(2.0));
    let (p, v) = (0.9, 5.0);
    assert_relative_eq!(rule.rate(p, v), 1.25e-6, max_relative = 1e-14);
    assert_relative_eq!(rule.slope(p, v), 5e-6, max_relative = 1e-14);
    assert_relative_eq!(rule.potential(p, v), 0.625e-6 / 3.0, max_relative = 1e-14);
    assert_relative_eq!(rule.inverse(1.25e-6, v), p, max_relative = 1e-14);
    for p in [0.0, 0.1, P0] {
        assert_eq!((rule.rate(p, v), rule.slope(p, v), rule.potential(p, v)), (0.0, 0.0, 0.0));
    }
    assert_eq!(rule.inverse(0.0, v), 0.0);
    // An implicit step: stiffness p + step w'(p) = target, above and below the threshold.
    for p in [0.2, 1.3] {
        let local = rule.at(v);
        let (found, slope) = resisted_pressure(1e-5, 3.0, &[&local], 1e-5 * p + 3.0 * local.rate(p));
        assert_relative_eq!(found, p, max_relative = 1e-13);
        assert_relative_eq!(slope, 1.0 / (1e-5 + 3.0 * local.slope(p)), max_relative = 1e-12);
    }
}

#[test]
fn the_steady_pressure_of_a_clutch_is_the_threshold_and_the_textbook_hyperbola() {
    // p = p0 + C/r with int p dS = F; the same as the rule given as a function.
    let force = 5e4;
    let problem = Problem { friction: 0.25, ..Problem::new(annulus(), above(1.0), vec![RigidMode::press_down(force)]) };
    let optimum = optimal_pressure(&problem).unwrap();
    let c = (force - P0 * problem.surface.area()) / (std::f64::consts::TAU * 100.0);
    for r in [20.0, 55.0, 120.0] {
        assert_relative_eq!(optimum.pressure_at(&plane_at(&problem.surface, r)), P0 + c / r, max_relative = 1e-11);
    }
    assert_eq!((optimum.character, optimum.regime), (Character::Minimum, Regime::Regular));
    assert_eq!((optimum.s, optimum.k), (None, None));
    assert!(optimum.steadiness_residual.unwrap() < 1e-11);
    assert_relative_eq!(optimum.feed.as_ref().unwrap()[0], FACTOR * 2.5 * c, max_relative = 1e-11);
    assert_eq!(one_percent(&problem, &optimum), None);
    let own = OwnRule::new(|p, v| if p > P0 { [FACTOR * (p - P0) * v, FACTOR * v] } else { [0.0; 2] });
    let given = optimal_pressure(&Problem { wear: WearPair::alone(own), ..problem.clone() }).unwrap();
    assert_relative_eq!(given.wear_power, optimum.wear_power, max_relative = 1e-10);
    // Below the threshold nothing moves: refused by name.
    let light = Problem { modes: vec![RigidMode::press_down(0.3 * problem.surface.area())], ..problem };
    let refused = optimal_pressure(&light);
    assert!(matches!(refused, Err(WearError::Infeasible { why, .. }) if why.contains("threshold")), "{refused:?}");
}

#[test]
fn the_steady_pressure_of_a_drum_and_of_a_tilted_punch_in_closed_form() {
    // Drum, b = 1/2: p = p0 + C cos^2, F = t R (p0 int cos + C int cos^3) over 60 degrees.
    let problem = Problem { friction: 0.25, ..Problem::new(drum(), above(0.5), vec![RigidMode::press_down(4e3)]) };
    let optimum = optimal_pressure(&problem).unwrap();
    let c = (4e3 / 2000.0 - P0) / (2.0 * (0.5 - 0.125 / 3.0));
    for degrees in [-30.0, -7.0, 0.0, 22.0] {
        let p = P0 + c * f64::to_radians(degrees).cos().powi(2);
        assert_relative_eq!(optimum.pressure_at(&drum_at(&problem.surface, degrees)), p, max_relative = 1e-10);
    }
    // Punch: p = p0 + c (x + 10) on -10 < x < 30, open beyond.
    let (c, l, t) = (0.05, 40.0, 10.0);
    let force = t * (P0 * l + 0.5 * c * l * l);
    let moment = t * (P0 * l * 10.0 + 0.5 * c * l * l * (30.0 - l / 3.0));
    let modes = vec![RigidMode::press_down(force), RigidMode::tilt(moment, Vector3::zeros())];
    let problem = Problem::new(punch(), above(1.0), modes);
    let optimum = optimal_pressure(&problem).unwrap();
    assert_eq!(optimum.regime, Regime::PartialContact);
    for x in [-9.9, 0.0, 30.0] {
        assert_relative_eq!(optimum.pressure_at(&plane_at(&problem.surface, x)), P0 + c * (x + 10.0), max_relative = 1e-8);
    }
    assert_eq!(optimum.pressure_at(&plane_at(&problem.surface, -10.1)), 0.0);
}

#[test]
fn the_least_wear_power_of_a_clutch_stays_at_the_threshold_where_it_slides_fast() {
    // b = q = 1: X = k p (p - p0) v, X' = k (2 p - p0) v, so that p = max(p0, (lambda/(k v) + p0)/2): a kink at r* with lambda = k omega r* p0.
    let (inner, outer, end) = (20.0, 120.0, 90.0);
    let excess = |r: f64| 0.5 * P0 * (end / r - 1.0);
    // int (end/r - 1) r dr from 20 to 90.
    let force =
        std::f64::consts::TAU * (P0 * 0.5 * (outer * outer - inner * inner) + 0.5 * P0 * 0.5 * (end - inner) * (end - inner));
    let problem = Problem {
        functional: Functional::WearPower,
        friction: 0.25,
        ..Problem::new(annulus(), above(1.0), vec![RigidMode::press_down(force)])
    };
    let optimum = optimal_pressure(&problem).unwrap();
    assert_eq!(optimum.character, Character::Minimum);
    for r in [20.0, 55.0, 80.0, 89.0] {
        assert_relative_eq!(optimum.pressure_at(&plane_at(&problem.surface, r)), P0 + excess(r), max_relative = 1e-7);
    }
    for r in [91.0, 120.0] {
        assert_relative_eq!(optimum.pressure_at(&plane_at(&problem.surface, r)), P0, max_relative = 1e-12);
    }
    assert_relative_eq!(optimum.multipliers[0], FACTOR * 2.5 * end * P0, max_relative = 1e-7);
    assert_eq!(optimum.feed, None);
}

#[test]
fn the_multiplier_is_the_change_of_the_functional_with_the_force() {
    for (functional, b, q) in
        [(Functional::WearVolume, 1.0, 2.0), (Functional::WearPower, 1.5, 0.8), (Functional::WearVolume, 2.0, 30.0)]
    {
        let at = |force: f64| {
            let base = Problem::new(annulus(), above(b), vec![RigidMode::press_down(force)]);
            optimal_pressure(&Problem { functional: functional.clone(), q, ..base }).unwrap()
        };
        let (optimum, h) = (at(5e4), 5.0);
        let slope = (at(5e4 + h).objective.unwrap() - at(5e4 - h).objective.unwrap()) / (2.0 * h);
        assert_relative_eq!(optimum.multipliers[0], slope, max_relative = 1e-6);
    }
}

#[test]
fn functionals_that_are_not_convex_above_the_threshold_are_refused() {
    let base = Problem::new(annulus(), above(0.5), vec![RigidMode::press_down(5e4)]);
    for (functional, q) in [(Functional::WearVolume, 2.0), (Functional::WearPower, 1.9), (Functional::WearVolume, f64::INFINITY)]
    {
        let refused = optimal_pressure(&Problem { functional, q, ..base.clone() });
        assert!(matches!(refused, Err(WearError::OwnRule { .. })), "{refused:?}");
    }
    for threshold in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let law = ThresholdLaw { threshold, ..above(1.0) };
        assert!(matches!(
            optimal_pressure(&Problem { wear: WearPair::alone(law), ..base.clone() }),
            Err(WearError::OutOfRange { .. })
        ));
    }
}

/// The least of a sum of convex terms under one force, by exchange between pairs of points: knows nothing of multipliers.
fn by_exchange(term: &dyn Fn(f64, f64) -> f64, points: &[SurfacePoint], force: f64) -> Vec<f64> {
    let area: f64 = points.iter().map(|point| point.weight).sum();
    let mut p = vec![force / area; points.len()];
    for _ in 0..400 {
        for i in 0..p.len() {
            for j in 0..i {
                let [wi, wj] = [points[i].weight, points[j].weight];
                let total = wi * p[i] + wj * p[j];
                let other = |x: f64| ((total - wi * x) / wj).max(0.0);
                let cost = |x: f64| wi * term(x, points[i].sliding_speed) + wj * term(other(x), points[j].sliding_speed);
                let (mut low, mut high) = (0.0, total / wi);
                for _ in 0..90 {
                    let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
                    if cost(a) <= cost(b) { high = b } else { low = a }
                }
                let x = 0.5 * (low + high);
                if cost(x) < cost(p[i]) {
                    (p[i], p[j]) = (x, other(x));
                }
            }
        }
    }
    p
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_optimum_is_the_least_that_exchange_of_force_finds(
        power in any::<bool>(), b in 0.6..2.5_f64, beyond in 0.05..2.0_f64, over in 1.05..4.0_f64,
        speeds in prop::collection::vec(1.0..10.0_f64, 4), weights in prop::collection::vec(0.5..2.0_f64, 4),
    ) {
        let (functional, d) = if power { (Functional::WearPower, 1.0) } else { (Functional::WearVolume, 0.0) };
        let q = (1.0 + beyond) / b;
        let point = |(v, weight): (&f64, &f64)| SurfacePoint {
            position: Vector3::zeros(), normal: Vector3::z(), weight: *weight, sliding_speed: *v, drag: Vector3::x(),
        };
        let points: Vec<SurfacePoint> = speeds.iter().zip(&weights).map(point).collect();
        let force = over * P0 * weights.iter().sum::<f64>();
        let surface = Surface::from_points(points.clone()).unwrap();
        let problem = Problem { functional, q, ..Problem::new(surface, above(b), vec![RigidMode::press_down(force)]) };
        let optimum = optimal_pressure(&problem).unwrap();
        // Without the factor of the wear, so that the terms are numbers of order 1.
        let term = |p: f64, v: f64| (p.powf(d) * (p - P0).max(0.0).powf(b) * v).powf(q);
        let found = by_exchange(&term, &points, force);
        let sum = |p: &[f64]| -> f64 { points.iter().zip(p).map(|(at, p)| at.weight * term(*p, at.sliding_speed)).sum() };
        prop_assert!(sum(&optimum.pressure) <= sum(&found) * (1.0 + 1e-9));
        prop_assert!(sum(&found) <= sum(&optimum.pressure) * (1.0 + 1e-5), "{found:?} {:?}", optimum.pressure);
        let value = functional_value(&problem, &points, &optimum.pressure).unwrap();
        prop_assert!((value / optimum.objective.unwrap() - 1.0).abs() < 1e-10);
    }
}
