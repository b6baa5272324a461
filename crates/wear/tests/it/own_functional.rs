//! A functional of one's own, and the table of the built-in ones.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use wear::{
    Character, Functional, Modes, OwnFunctional, OwnRule, Problem, Regime, RigidMode, WearError, WearLaw, WearPair,
    functional_value, one_percent, optimal_pressure, wear_rate,
};

use crate::surfaces::{annulus, drum, drum_at, plane_at, punch};

const LAW: WearLaw = WearLaw { factor: 1e-6, speed_exponent: 0.8, pressure_exponent: 1.7 };

/// p w' of a power law as a density of one's own.
fn wear_power() -> Functional {
    Functional::Own(OwnFunctional::new(|p, v, _| {
        let (b, x) = (LAW.pressure_exponent, p * wear_rate(&LAW, p, v));
        [x, (b + 1.0) * x / p, (b + 1.0) * b * x / (p * p)]
    }))
}

#[test]
fn the_wear_power_as_a_function_has_the_optimum_of_the_built_in_one() {
    // Full contact, then a moment that leaves part of the punch open.
    for moment in [4e3, 16e3] {
        let modes = vec![RigidMode::press_down(1e3), RigidMode::tilt(moment, Vector3::zeros())];
        let built_in = Problem { functional: Functional::WearPower, ..Problem::new(punch(), LAW, modes) };
        let own = Problem { functional: wear_power(), ..built_in.clone() };
        let [expected, found] = [&built_in, &own].map(|problem| optimal_pressure(problem).unwrap());
        assert_eq!((found.regime, found.character), (expected.regime, expected.character));
        for x in [-30.0, 1.0, 15.0, 30.0] {
            let point = plane_at(&built_in.surface, x);
            assert_relative_eq!(expected.pressure_at(&point), found.pressure_at(&point), max_relative = 1e-9);
        }
        assert_relative_eq!(expected.objective.unwrap(), found.objective.unwrap(), max_relative = 1e-9);
        assert_relative_eq!(expected.multipliers[0], found.multipliers[0], max_relative = 1e-9);
        assert_relative_eq!(expected.multipliers[1], found.multipliers[1], max_relative = 1e-9);
        assert_relative_eq!(
            functional_value(&own, &found.points, &found.pressure).unwrap(),
            found.objective.unwrap(),
            max_relative = 1e-12
        );
        assert_eq!(one_percent(&own, &found), None);
    }
}

#[test]
fn the_square_of_the_friction_power_as_a_function_has_the_optimum_of_the_built_in_one() {
    let square = OwnFunctional::new(|p, v, friction| {
        let x = friction * v;
        [(x * p).powi(2), 2.0 * x * x * p, 2.0 * x * x]
    });
    let base = Problem {
        friction: 0.25,
        mode_kind: Modes::Associated,
        ..Problem::new(annulus(), LAW, vec![RigidMode::press_down(1e4)])
    };
    let built_in = Problem { functional: Functional::FrictionPower, q: 2.0, ..base.clone() };
    let own = Problem { functional: Functional::Own(square), ..base };
    let [expected, found] = [&built_in, &own].map(|problem| optimal_pressure(problem).unwrap());
    assert_eq!((found.regime, found.character), (Regime::Regular, Character::Minimum));
    for r in [20.0, 70.0, 120.0] {
        let point = plane_at(&own.surface, r);
        assert_relative_eq!(expected.pressure_at(&point), found.pressure_at(&point), max_relative = 1e-11);
    }
    // J of (12) is the root of the integral.
    assert_relative_eq!(expected.objective.unwrap().powi(2), found.objective.unwrap(), max_relative = 1e-11);
}

#[test]
fn the_multiplier_of_a_functional_that_is_no_power_is_its_change_with_the_force() {
    let both = OwnFunctional::new(|p, v, _| [v * (p + p * p * p), v * (1.0 + 3.0 * p * p), 6.0 * v * p]);
    let at = |force: f64| {
        let problem = Problem {
            functional: Functional::Own(both.clone()),
            ..Problem::new(drum(), LAW, vec![RigidMode::press_down(force)])
        };
        optimal_pressure(&problem).unwrap()
    };
    let (optimum, h) = (at(1e4), 1.0);
    let slope = (at(1e4 + h).objective.unwrap() - at(1e4 - h).objective.unwrap()) / (2.0 * h);
    assert_relative_eq!(optimum.multipliers[0], slope, max_relative = 1e-7);
    // 1 + 3 p^2 = lambda cos/v.
    for degrees in [-30.0, 0.0, 11.0] {
        let p = (((optimum.multipliers[0] / 500.0) * f64::to_radians(degrees).cos() - 1.0) / 3.0).sqrt();
        let problem = Problem::new(drum(), LAW, vec![RigidMode::press_down(1e4)]);
        assert_relative_eq!(optimum.pressure_at(&drum_at(&problem.surface, degrees)), p, max_relative = 1e-10);
    }
}

#[test]
fn what_needs_second_derivatives_of_a_rule_is_refused_by_name_and_uniform_pressure_needs_no_rule() {
    let rule = OwnRule::new(|p, v| [1e-6 * p * v, 1e-6 * v]);
    let problem = Problem { friction: 0.25, ..Problem::new(punch(), rule.clone(), vec![RigidMode::press_down(1e3)]) };
    for functional in [Functional::WearVolume, Functional::WearPower] {
        let refused = optimal_pressure(&Problem { functional: functional.clone(), ..problem.clone() });
        assert!(matches!(refused, Err(WearError::OwnRule { functional: word, .. }) if word == functional.word()), "{refused:?}");
    }
    let uniform = Problem { functional: Functional::Uniform, ..problem.clone() };
    let optimum = optimal_pressure(&uniform).unwrap();
    assert_relative_eq!(optimum.wear_volume_rate, 1e-6 * 1e3 * 5.0, max_relative = 1e-12);
    assert_eq!(one_percent(&uniform, &optimum), None);
    // Rules and functionals are equal to their clones alone.
    assert_eq!(WearPair::alone(rule.clone()), problem.wear);
    assert_ne!(WearPair::alone(OwnRule::new(|p, v| [1e-6 * p * v, 1e-6 * v])), problem.wear);
    assert_ne!(wear_power(), wear_power());
}

#[test]
fn the_table_has_the_exponents_of_the_theory() {
    let (b, q) = (1.7, 0.6);
    let powers = Functional::ALL.map(|functional| (functional.word(), functional.pressure_power(b)));
    assert_eq!(
        powers,
        [("wear-volume", b), ("friction-power", 1.0), ("wear-power", b + 1.0), ("uniform", 1.0), ("steady", b + 1.0)]
    );
    assert_eq!(Functional::WearVolume.s_minus_1(b, q), b.mul_add(q, -1.0));
    assert_eq!(Functional::FrictionPower.s_minus_1(b, q), q - 1.0);
    assert_eq!(Functional::FrictionPower.s_minus_1(b, f64::NEG_INFINITY), f64::NEG_INFINITY);
    assert_eq!((Functional::Steady.s_minus_1(b, q), Functional::Uniform.s_minus_1(b, q)), (b, f64::INFINITY));
    assert!(wear_power().s_minus_1(b, q).is_nan() && wear_power().word() == "own");
    let with_q: Vec<_> = Functional::ALL.iter().filter(|functional| functional.row().needs.q).map(Functional::word).collect();
    assert_eq!(with_q, ["wear-volume", "friction-power", "wear-power"]);
}
