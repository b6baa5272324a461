//! A wear rule of one's own, given as a function.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use wear::{
    Counterface, OwnRule, Problem, Regime, RigidMode, Rule, WearError, WearLaw, WearPair, one_percent, optimal_pressure,
    resisted_pressure, wear_rate,
};

use crate::surfaces::{annulus, drum, drum_at, plane_at, punch};

const LAW: WearLaw = WearLaw { factor: 1e-6, speed_exponent: 0.8, pressure_exponent: 1.7 };

/// A power of the pressure as a function.
fn power(pressure: f64, speed: f64) -> [f64; 2] {
    let rate = wear_rate(&LAW, pressure, speed);
    [rate, LAW.pressure_exponent * rate / pressure]
}

/// Nothing wears below p0 = 0.4 MPa. This function is all it takes.
fn threshold(pressure: f64, speed: f64) -> [f64; 2] {
    let (k, p0) = (1e-6, 0.4);
    if pressure > p0 { [k * (pressure - p0) * speed, k * speed] } else { [0.0, 0.0] }
}

/// Ten times the wear for every MPa beyond p1 = 2 MPa.
fn severe(pressure: f64, speed: f64) -> [f64; 2] {
    let (k, p1) = (1e-6, 2.0);
    if pressure <= p1 { [k * pressure * speed, k * speed] } else { [k * (p1 + 10.0 * (pressure - p1)) * speed, 10.0 * k * speed] }
}

#[test]
fn wear_law_with_a_pressure_threshold_shifts_the_clutch_between_the_textbook_cases() {
    let force = 5e4;
    let problem =
        Problem { friction: 0.25, ..Problem::new(annulus(), OwnRule::new(threshold), vec![RigidMode::press_down(force)]) };
    let optimum = optimal_pressure(&problem).unwrap();
    // p = p0 + C/r with int p dS = F.
    let area = problem.surface.area();
    let c = (force - 0.4 * area) / (std::f64::consts::TAU * 100.0);
    for r in [20.0, 55.0, 120.0] {
        let p = optimum.pressure_at(&plane_at(&problem.surface, r));
        assert_relative_eq!(p, 0.4 + c / r, max_relative = 1e-11);
    }
    assert!(optimum.steadiness_residual.unwrap() < 1e-11);
    assert_relative_eq!(optimum.feed.as_ref().unwrap()[0], 1e-6 * 2.5 * c, max_relative = 1e-11);
    let radius = optimum.effective_radius.unwrap();
    assert!(radius > 70.0 && radius < 81.905);
    assert_eq!(one_percent(&problem, &optimum), None);
    // Below the threshold everywhere nothing moves: refused by name.
    let light = Problem { modes: vec![RigidMode::press_down(0.3 * area)], ..problem };
    let refused = optimal_pressure(&light);
    assert!(matches!(refused, Err(WearError::Infeasible { why, .. }) if why.contains("threshold")), "{refused:?}");
}

#[test]
fn a_power_law_given_as_a_function_is_the_built_in_law() {
    // Full contact, then a moment that leaves part of the punch open.
    for moment in [4e3, 16e3] {
        let modes = vec![RigidMode::press_down(1e3), RigidMode::tilt(moment, Vector3::zeros())];
        let problem = Problem::new(punch(), LAW, modes);
        let own = Problem { wear: WearPair::alone(OwnRule::new(power)), ..problem.clone() };
        let (built_in, given) = (optimal_pressure(&problem).unwrap(), optimal_pressure(&own).unwrap());
        assert_eq!(given.regime, built_in.regime);
        assert_eq!(given.character, built_in.character);
        for x in [-30.0, 1.0, 15.0, 30.0] {
            let point = plane_at(&problem.surface, x);
            assert_relative_eq!(built_in.pressure_at(&point), given.pressure_at(&point), max_relative = 1e-9);
        }
        // The cell at the end of contact is integrated for the power of p by the one, for all powers by the other.
        assert_relative_eq!(built_in.wear_volume_rate, given.wear_volume_rate, max_relative = 1e-6);
        assert_relative_eq!(built_in.wear_power, given.wear_power, max_relative = 1e-9);
        assert_relative_eq!(built_in.feed.unwrap()[1], given.feed.unwrap()[1], max_relative = 1e-9);
    }
}

#[test]
fn a_threshold_ends_the_contact_of_a_tilted_punch_with_a_jump_of_the_pressure() {
    // p = p0 + c (x + 10) on -10 < x < 30 carries F = t (p0 l + c l^2/2) and M = F x_mean.
    let (p0, c, l, t) = (0.4, 0.05, 40.0, 10.0);
    let force = t * (p0 * l + 0.5 * c * l * l);
    let moment = t * (p0 * l * 10.0 + 0.5 * c * l * l * (30.0 - l / 3.0));
    let problem = Problem::new(
        punch(),
        OwnRule::new(threshold),
        vec![RigidMode::press_down(force), RigidMode::tilt(moment, Vector3::zeros())],
    );
    let optimum = optimal_pressure(&problem).unwrap();
    assert_eq!(optimum.regime, Regime::PartialContact);
    for x in [-9.9, 0.0, 30.0] {
        assert_relative_eq!(optimum.pressure_at(&plane_at(&problem.surface, x)), p0 + c * (x + 10.0), max_relative = 1e-8);
    }
    assert_eq!(optimum.pressure_at(&plane_at(&problem.surface, -10.1)), 0.0);
}

#[test]
fn a_rule_with_a_bend_balances_its_load() {
    let problem = Problem { friction: 0.25, ..Problem::new(drum(), OwnRule::new(severe), vec![RigidMode::press_down(4e3)]) };
    let optimum = optimal_pressure(&problem).unwrap();
    // w' ~ cos: the same rule inverted by hand, with the force by a fine midpoint rule.
    let feed = optimum.feed.as_ref().unwrap()[0];
    let at = |degrees: f64| {
        let w = feed * degrees.to_radians().cos() / (1e-6 * 500.0);
        if w <= 2.0 { w } else { 2.0 + (w - 2.0) / 10.0 }
    };
    assert!(at(0.0) > 2.0 && at(30.0) < 2.0);
    for degrees in [-30.0, -7.0, 0.0, 22.0] {
        assert_relative_eq!(optimum.pressure_at(&drum_at(&problem.surface, degrees)), at(degrees), max_relative = 1e-11);
    }
    let count = 200_000;
    let force = |i: usize| {
        let degrees = -30.0 + 60.0 * (i as f64 + 0.5) / count as f64;
        at(degrees) * degrees.to_radians().cos() * 2000.0 * 60_f64.to_radians() / count as f64
    };
    // Friction along the surface cancels: sin is odd.
    assert_relative_eq!((0..count).map(force).sum::<f64>(), 4e3, max_relative = 1e-8);
}

#[test]
fn rate_slope_inverse_and_potential_belong_together() {
    let (built_in, own) = (Rule::from(LAW), Rule::from(OwnRule::new(power)));
    let (v, h) = (5.0, 1e-5);
    for rule in [&built_in, &own, &OwnRule::new(severe).into(), &OwnRule::new(threshold).into()] {
        assert_eq!((rule.rate(0.0, v), rule.potential(0.0, v), rule.inverse(0.0, v)), (0.0, 0.0, 0.0));
        for p in [0.7, 1.3, 3.1] {
            let slope = (rule.rate(p + h, v) - rule.rate(p - h, v)) / (2.0 * h);
            assert_relative_eq!(rule.slope(p, v), slope, max_relative = 1e-8);
            assert_relative_eq!(rule.inverse(rule.rate(p, v), v), p, max_relative = 1e-13);
        }
    }
    for p in [1e-3, 0.7, 3.1] {
        assert_relative_eq!(built_in.rate(p, v), own.rate(p, v), max_relative = 1e-15);
        assert_relative_eq!(built_in.slope(p, v), own.slope(p, v), max_relative = 1e-14);
        assert_relative_eq!(built_in.potential(p, v), own.potential(p, v), max_relative = 1e-13);
        assert_relative_eq!(built_in.inverse(p * 1e-6, v), own.inverse(p * 1e-6, v), max_relative = 1e-13);
        // One implicit step: stiffness p + step (w_1' + w_2') = target.
        let [first, second] = [built_in.at(v), own.at(v)];
        let target = 1e-5 * p + 3.0 * (first.rate(p) + second.rate(p));
        for rules in [[&first, &first], [&second, &first], [&second, &second]] {
            let (found, slope) = resisted_pressure(1e-5, 3.0, &rules, target);
            assert_relative_eq!(found, p, max_relative = 1e-13);
            assert_relative_eq!(slope, 1.0 / (1e-5 + 6.0 * first.slope(p)), max_relative = 1e-12);
        }
    }
    // Up to its threshold a rule says nothing of the pressure: the inverse is its end.
    assert_relative_eq!(Rule::from(OwnRule::new(threshold)).inverse(1e-20, v), 0.4, max_relative = 1e-12);
}

/// Exponents 1 and 2 have a closed form, of any size of its terms.
#[test]
fn a_step_of_linear_and_quadratic_wear_has_its_pressure_to_round_off() {
    let law =
        |factor: f64, pressure_exponent: f64| Rule::from(WearLaw { factor, speed_exponent: 1.0, pressure_exponent }).at(1.0);
    for (stiffness, step) in [(1e-5, 3.0), (1e-5, 1e12), (1e3, 1e-9), (1e-150, 1.0)] {
        for [first, second] in
            [[law(1e-6, 2.0), law(3e-7, 1.0)], [law(1e-6, 2.0), law(1e-120, 2.0)], [law(0.0, 1.0), law(1e-6, 2.0)]]
        {
            for p in [1e-60, 1e-3, 0.7, 1e5, 1e60] {
                let target = stiffness * p + step * (first.rate(p) + second.rate(p));
                let (found, slope) = resisted_pressure(stiffness, step, &[&first, &second], target);
                assert_relative_eq!(found, p, max_relative = 1e-14);
                assert_relative_eq!(slope, 1.0 / (stiffness + step * (first.slope(p) + second.slope(p))), max_relative = 1e-14);
            }
        }
    }
}

#[test]
fn two_bodies_that_wear_by_functions_share_the_rigid_wear() {
    let other = WearLaw { factor: 3e-7, speed_exponent: 1.0, pressure_exponent: 0.6 };
    let own = OwnRule::new(move |p, v| [wear_rate(&other, p, v), 0.6 * wear_rate(&other, p, v) / p]);
    let mut problem = Problem { friction: 0.25, ..Problem::new(annulus(), LAW, vec![RigidMode::press_down(5e4)]) };
    problem.counterface = Counterface::Congruent;
    problem.wear.rules[1] = other.into();
    let expected = optimal_pressure(&problem).unwrap();
    for rules in [[LAW.into(), own.clone().into()], [OwnRule::new(power).into(), own.into()]] {
        problem.wear.rules = rules;
        let found = optimal_pressure(&problem).unwrap();
        for r in [20.0, 55.0, 120.0] {
            let point = plane_at(&problem.surface, r);
            assert_relative_eq!(found.pressure_at(&point), expected.pressure_at(&point), max_relative = 1e-11);
        }
        assert_relative_eq!(found.feed.unwrap()[0], expected.feed.as_ref().unwrap()[0], max_relative = 1e-11);
        assert_relative_eq!(found.wear_volume_rate, expected.wear_volume_rate, max_relative = 1e-11);
    }
    // Along the track of a drum the mean of body 2 would have to be known first.
    let drum = Problem { surface: drum(), counterface: Counterface::Revolving, ..problem };
    assert!(matches!(optimal_pressure(&drum), Err(WearError::OwnRule { .. })));
}
