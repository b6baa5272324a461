//! Numbers an engineer wants: sensitivities, and the examples.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use proptest::prelude::*;
use wear::{
    Functional, Modes, Optimum, Parameter, Problem, RigidMode, Surface, WearError, WearLaw, WearPair, optimal_pressure,
    sensitivity,
};

use crate::surfaces::{annulus, drum, punch};

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
