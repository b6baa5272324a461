//! Numbers an engineer wants: sensitivities, durability, a wear law of one's own, sweeps, and the examples.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use proptest::prelude::*;
use wear::{
    Functional, Modes, Optimum, Parameter, Problem, Regime, RigidMode, Surface, WearError, WearLaw, WearPair, Workspace,
    distance_to_depth, optima_over_q, optimal_pressure, optimal_pressure_with, sensitivity, steady_pressure_of_rule,
    time_to_depth,
};

use crate::surfaces::{annulus, drum, plane_at, punch};

#[path = "../../examples/clutch_torque.rs"]
#[allow(dead_code)]
mod clutch_torque;
#[path = "../../examples/pinned_shoe.rs"]
#[allow(dead_code)]
mod pinned_shoe;
#[path = "../../examples/punch_beyond_kern.rs"]
#[allow(dead_code)]
mod punch_beyond_kern;

#[test]
fn example_clutch_torque() {
    clutch_torque::main().unwrap();
    let [new, worn] = clutch_torque::effective_radii(1.0, 1.0).unwrap();
    assert_relative_eq!(new, 81.904761904761, max_relative = 1e-12);
    assert_relative_eq!(worn, 70.0, max_relative = 1e-12);
}

#[test]
fn example_pinned_shoe() {
    pinned_shoe::main().unwrap();
    let torque = |omega| pinned_shoe::shoe(omega, 1.0, 2279.1 * 212.0).unwrap().torque.unwrap();
    assert_relative_eq!(torque(10.0) + torque(-10.0), 527.8e3, max_relative = 2e-4);
}

#[test]
fn example_punch_beyond_the_kern() {
    punch_beyond_kern::main().unwrap();
    let area = |e| punch_beyond_kern::punch(1.0, e).unwrap().points.iter().map(|p| p.weight).sum::<f64>();
    assert_relative_eq!(area(20.0), 10.0 * 3.0 * 10.0, max_relative = 1e-9);
    assert!(matches!(punch_beyond_kern::punch(1.0, 30.0), Err(WearError::Infeasible { .. })));
}

/// Problem of one wearing body whose data are the arguments.
struct Data {
    surface: Surface,
    functional: Functional,
    q: f64,
    mode_kind: Modes,
    friction: f64,
    a: f64,
    b: f64,
    log_beta: f64,
    resultants: Vec<f64>,
}

impl Data {
    fn problem(&self) -> Problem {
        let beta = self.log_beta.exp();
        let mut modes = vec![RigidMode::press_down(self.resultants[0])];
        if self.resultants.len() > 1 {
            modes.push(RigidMode::tilt(self.resultants[1], Vector3::zeros()));
        }
        Problem {
            wear: WearPair::from_beta([beta, 0.0], self.friction, [self.a; 2], [self.b; 2]).unwrap(),
            friction: self.friction,
            functional: self.functional,
            q: self.q,
            mode_kind: self.mode_kind,
            ..Problem::new(self.surface.clone(), WearLaw::NONE, modes)
        }
    }

    fn shifted(&self, parameter: Parameter, step: f64) -> Optimum {
        let mut data = Data { surface: self.surface.clone(), resultants: self.resultants.clone(), ..*self };
        match parameter {
            Parameter::Friction => data.friction += step,
            Parameter::PressureExponent => data.b += step,
            Parameter::SpeedExponent => data.a += step,
            Parameter::LogWearFactor => data.log_beta += step,
            Parameter::Resultant(i) => data.resultants[i] += step,
        }
        optimal_pressure(&data.problem()).unwrap()
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sensitivities_match_central_differences(
        which in 0..4_usize, place in 0..3_usize, associated in any::<bool>(), friction in 0.1..0.5_f64, a in 0.3..1.5_f64, b in 0.4..2.0_f64, q in 1.3..2.5_f64, share in -0.07..0.07_f64,
    ) {
        let functional = [Functional::WearVolume, Functional::WearPower, Functional::FrictionPower, Functional::Steady][which];
        // Away from s = 1, where the pressure runs off.
        let s = functional.pressure_power(b) * q;
        prop_assume!((s - 1.0).abs() > 0.25);
        let surface = [annulus(), drum(), punch()][place].clone();
        let mut resultants = vec![900.0];
        if place == 2 {
            resultants.push(900.0 * 30.0 * share);
        }
        let mode_kind = if associated { Modes::Associated } else { Modes::Kinematic };
        let data = Data { surface, functional, q, mode_kind, friction, a, b, log_beta: -9.0, resultants };
        let problem = data.problem();
        let optimum = optimal_pressure(&problem).unwrap();
        let mut parameters = vec![Parameter::Friction, Parameter::PressureExponent, Parameter::SpeedExponent, Parameter::LogWearFactor, Parameter::Resultant(0)];
        if place == 2 {
            parameters.push(Parameter::Resultant(1));
        }
        for parameter in parameters {
            let step = match parameter {
                Parameter::Resultant(0) => 0.03,
                Parameter::Resultant(_) => 1.0,
                _ => 2e-5,
            };
            let got = sensitivity(&problem, &optimum, parameter).unwrap();
            let (plus, minus) = (data.shifted(parameter, step), data.shifted(parameter, -step));
            let check = |what: &str, got: f64, value: &dyn Fn(&Optimum) -> f64| {
                let slope = (value(&plus) - value(&minus)) / (2.0 * step);
                let noise = 1e-10 * value(&optimum).abs() / step;
                assert!((got - slope).abs() <= 1e-6 * slope.abs() + noise, "{parameter:?} {what}: {got:e} {slope:e} {functional:?} {place}");
            };
            check("W", got.wear_volume_rate, &|o| o.wear_volume_rate);
            check("D_F", got.friction_power, &|o| o.friction_power);
            check("D_w", got.wear_power, &|o| o.wear_power);
            if let Some(torque) = got.torque {
                check("torque", torque, &|o| o.torque.unwrap());
                check("radius", got.effective_radius.unwrap(), &|o| o.effective_radius.unwrap());
            }
            if let Some(feed) = &got.feed {
                check("V_F", feed[0], &|o| o.feed.as_ref().unwrap()[0]);
                if place == 2 {
                    let scale = optimum.feed.as_ref().unwrap()[0];
                    check("V_M", feed[1], &|o| o.feed.as_ref().unwrap()[1] + 1e-3 * scale);
                }
            }
            for index in [0, optimum.points.len() / 2, optimum.points.len() - 1] {
                let point = optimum.points[index];
                check("log p", got.log_pressure[index], &|o| o.log_pressure_at(&point));
            }
            if parameter == Parameter::LogWearFactor {
                prop_assert!(got.log_pressure.iter().all(|value| *value == 0.0));
                prop_assert_eq!(got.friction_power, 0.0);
            }
        }
    }
}

#[test]
fn time_and_distance_to_a_depth_follow_from_the_feed() {
    let problem = Problem {
        friction: 0.25,
        ..Problem::new(annulus(), WearLaw::from_beta(2e-8, 0.25, 1.0, 1.2), vec![RigidMode::press_down(5e3)])
    };
    let optimum = optimal_pressure(&problem).unwrap();
    let feed = optimum.feed.as_ref().unwrap()[0];
    let point = plane_at(&problem.surface, 50.0);
    assert_relative_eq!(time_to_depth(&problem, &optimum, &point, 0.3).unwrap(), 0.3 / feed, max_relative = 1e-12);
    let distance = distance_to_depth(&problem, &optimum, &point, 0.3).unwrap();
    assert_relative_eq!(distance, 2.5 * 50.0 * 0.3 / feed, max_relative = 1e-12);
    let idle = Problem { wear: WearPair::archard([0.0, 1e-8], [1.0; 2], [1.2; 2]), ..problem.clone() };
    assert_eq!(time_to_depth(&idle, &optimum, &point, 0.3), None);
}

/// A wear law of one's own, with a threshold: nothing wears below p0 = 0.4 MPa. This function and the call of
/// `steady_pressure_of_rule` are all it takes.
fn threshold_rule(pressure: f64, speed: f64) -> [f64; 2] {
    let (k, p0) = (1e-6, 0.4);
    if pressure > p0 { [k * (pressure - p0) * speed, k * speed] } else { [0.0, 0.0] }
}

#[test]
fn wear_law_with_a_pressure_threshold_shifts_the_clutch_between_the_textbook_cases() {
    let force = 5e4;
    let problem = Problem { friction: 0.25, ..Problem::new(annulus(), WearLaw::NONE, vec![RigidMode::press_down(force)]) };
    let optimum = steady_pressure_of_rule(&problem, threshold_rule).unwrap();
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
    // Below the threshold everywhere nothing moves: refused by name.
    let light = Problem { modes: vec![RigidMode::press_down(0.3 * area)], ..problem };
    assert!(matches!(steady_pressure_of_rule(&light, threshold_rule), Err(WearError::Infeasible { .. })));
}

#[test]
fn a_power_law_given_as_a_function_is_the_built_in_law() {
    fn archard(pressure: f64, speed: f64) -> [f64; 2] {
        let law = WearLaw { factor: 1e-6, speed_exponent: 0.8, pressure_exponent: 1.7 };
        [wear::wear_rate(&law, pressure, speed), wear::wear_rate_slope(&law, pressure, speed)]
    }
    let law = WearLaw { factor: 1e-6, speed_exponent: 0.8, pressure_exponent: 1.7 };
    let modes = vec![RigidMode::press_down(1e3), RigidMode::tilt(4e3, Vector3::zeros())];
    let problem = Problem::new(punch(), law, modes);
    let (built_in, given) = (optimal_pressure(&problem).unwrap(), steady_pressure_of_rule(&problem, archard).unwrap());
    for x in [-30.0, 1.0, 30.0] {
        let point = plane_at(&problem.surface, x);
        assert_relative_eq!(built_in.pressure_at(&point), given.pressure_at(&point), max_relative = 1e-9);
    }
}

#[test]
fn continuation_in_q_meets_the_single_solutions_on_both_sides_of_the_singular_one() {
    let modes = vec![RigidMode::press_down(1e3), RigidMode::tilt(7e3, Vector3::zeros())];
    let problem = Problem {
        functional: Functional::WearVolume,
        ..Problem::new(punch(), WearLaw { factor: 1e-6, speed_exponent: 1.0, pressure_exponent: 1.0 }, modes)
    };
    let values = [3.0, 2.0, 1.4, 1.1, 1.01, 1.0001, 1.0, 0.9999, 0.99, 0.9, 0.5, 0.1];
    let swept = optima_over_q(&problem, &values);
    for (q, swept) in values.iter().zip(&swept) {
        let single = optimal_pressure(&Problem { q: *q, ..problem.clone() }).unwrap();
        let swept = swept.as_ref().unwrap();
        for x in [-30.0, 0.0, 30.0] {
            let point = plane_at(&problem.surface, x);
            assert_relative_eq!(swept.pressure_at(&point), single.pressure_at(&point), max_relative = 1e-9, epsilon = 1e-12);
        }
    }
    let iterations: usize = swept.iter().map(|optimum| optimum.as_ref().unwrap().iterations).sum();
    assert!(iterations <= 12 * 8, "{iterations}");
}

#[test]
fn a_sweep_reuses_its_memory() {
    let mut problem = Problem::new(annulus(), WearLaw::from_beta(2e-4, 0.25, 1.0, 0.8), vec![RigidMode::press_down(1e6)]);
    problem.functional = Functional::WearPower;
    let mut work = Workspace::default();
    let first = optimal_pressure_with(&problem, &mut work).unwrap();
    let place = first.pressure.as_ptr();
    work.recycle(first);
    for q in [1.0, 1.2, 2.0] {
        problem.q = q;
        let optimum = optimal_pressure_with(&problem, &mut work).unwrap();
        assert_eq!(optimum.pressure.as_ptr(), place);
        assert_eq!(optimum.regime, Regime::Regular);
        work.recycle(optimum);
    }
}
