//! Every entry of data/reference/optimality.json: closed forms and high-precision quadrature.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use serde_json::Value;
use wear::{
    Balance, Character, Functional, LimitSide, Modes, Optimum, Problem, Regime, RigidMode, optimal_pressure, singular_limit,
};

use crate::surfaces::{annulus, drum, drum_at, plane_at, problem, punch};

fn entries() -> Vec<Value> {
    let text = std::fs::read_to_string("../../data/reference/optimality.json").unwrap();
    let json: Value = serde_json::from_str(&text).unwrap();
    json["entries"].as_array().unwrap().clone()
}

pub(crate) fn group(name: &str) -> Vec<Value> {
    let found: Vec<Value> = entries().into_iter().filter(|entry| entry["group"] == name).collect();
    assert!(!found.is_empty());
    found
}

pub(crate) fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key} in {value}"))
}

pub(crate) fn list(value: &Value, key: &str) -> Vec<f64> {
    value[key].as_array().unwrap_or_else(|| panic!("{key}")).iter().map(|v| v.as_f64().unwrap()).collect()
}

pub(crate) fn functional(value: &Value) -> Functional {
    match value["functional"].as_str().unwrap() {
        "W" => Functional::WearVolume,
        "DF" => Functional::FrictionPower,
        "Dw" => Functional::WearPower,
        other => panic!("{other}"),
    }
}

/// Relative comparison with the entry named on failure.
pub(crate) fn same(id: &Value, what: &str, got: f64, wanted: f64, rtol: f64) {
    let error = (got - wanted).abs() / wanted.abs().max(f64::MIN_POSITIVE);
    assert!(error <= rtol, "{id} {what}: got {got:e}, wanted {wanted:e}, relative error {error:.1e} > {rtol:.0e}");
}

fn powers(id: &Value, optimum: &Optimum, outputs: &Value, rtol: f64) {
    same(id, "W", optimum.wear_volume_rate, number(outputs, "W"), rtol);
    same(id, "D_F", optimum.friction_power, number(outputs, "DF"), rtol);
    same(id, "D_w", optimum.wear_power, number(outputs, "Dw"), rtol);
    if let Some(value) = outputs["J_q"].as_f64() {
        same(id, "J", optimum.objective.unwrap(), value, rtol);
        same(id, "lambda", optimum.multipliers[0], number(outputs, "lambda_F"), rtol);
    }
}

#[test]
fn drum_pressures_powers_and_multipliers_for_every_q_and_both_balances() {
    for entry in group("drum") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let (a, b, q) = (number(inputs, "a"), number(inputs, "b"), number(inputs, "q"));
        let mut problem: Problem =
            problem(drum(), functional(inputs), q, a, b, vec![RigidMode::press_down(number(inputs, "F0"))]);
        if inputs["normalisation"] == "paper" {
            problem.balance = Balance::Paper;
        }
        let optimum = optimal_pressure(&problem).unwrap();
        for (degrees, p) in list(outputs, "alpha_deg").iter().zip(list(outputs, "p")) {
            same(id, "p", optimum.pressure_at(&drum_at(&problem.surface, *degrees)), p, rtol);
        }
        same(id, "int p", optimum.normal_force, number(outputs, "int_p_dS"), rtol);
        let vertical: f64 = optimum.points.iter().zip(&optimum.pressure).map(|(pt, p)| pt.weight * pt.normal.z * p).sum();
        same(id, "int p cos", vertical, number(outputs, "int_p_cos_dS"), rtol);
        powers(id, &optimum, outputs, rtol);
    }
}

#[test]
fn annulus_pressures_powers_and_multipliers() {
    let all = group("annulus_7.5").into_iter().chain(group("annulus_DF"));
    for entry in all.filter(|entry| entry["outputs"]["exponent"].is_number()) {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let (a, b, q) = (number(inputs, "a"), number(inputs, "b"), number(inputs, "q"));
        let problem = problem(annulus(), functional(inputs), q, a, b, vec![RigidMode::press_down(number(inputs, "F0"))]);
        let optimum = optimal_pressure(&problem).unwrap();
        for (r, log_p) in list(outputs, "r").iter().zip(list(outputs, "log_p")) {
            let got = optimum.log_pressure_at(&plane_at(&problem.surface, *r));
            assert!((got - log_p).abs() <= rtol * log_p.abs().max(1.0) * 10.0, "{id} log p({r}) {got} {log_p}");
        }
        powers(id, &optimum, outputs, rtol);
        same(id, "torque", optimum.torque.unwrap(), number(outputs, "torque"), rtol);
    }
}

#[test]
fn punch_under_force_and_moment() {
    for entry in group("punch") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let modes =
            vec![RigidMode::press_down(number(inputs, "F0")), RigidMode::tilt(number(inputs, "M0"), nalgebra::Vector3::zeros())];
        let problem = problem(punch(), Functional::WearPower, 1.0, 1.0, number(inputs, "b"), modes);
        let optimum = optimal_pressure(&problem).unwrap();
        for (x, p) in list(outputs, "x").iter().zip(list(outputs, "p")) {
            same(id, "p", optimum.pressure_at(&plane_at(&problem.surface, *x)), p, rtol);
        }
        assert_relative_eq!(optimum.multipliers[0], number(outputs, "lambda_F"), max_relative = rtol);
        assert_relative_eq!(optimum.multipliers[1], number(outputs, "lambda_M"), max_relative = rtol, epsilon = 1e-18);
        let feed = optimum.feed.unwrap();
        same(id, "V_F", feed[0], number(outputs, "rigid_velocity_F"), rtol);
        same(id, "W", optimum.wear_volume_rate, number(outputs, "W"), rtol);
        same(id, "D_w", optimum.wear_power, number(outputs, "Dw"), rtol);
        assert!(optimum.steadiness_residual.unwrap() < 1e-12);
    }
}

pub(crate) fn force_and_moment(inputs: &Value) -> Vec<RigidMode> {
    vec![RigidMode::press_down(number(inputs, "F0")), RigidMode::tilt(number(inputs, "M0"), Vector3::zeros())]
}

/// W with b = 1 has s = q: the functional through which any s is asked for.
fn by_s(inputs: &Value, s: f64) -> Problem {
    problem(punch(), Functional::WearVolume, s, 1.0, 1.0, force_and_moment(inputs))
}

fn read_s(inputs: &Value) -> f64 {
    inputs["s"].as_f64().unwrap_or(1.0)
}

#[test]
fn drum_limits_are_uniform_pressure_cosine_and_concentrated_forces() {
    let force = || vec![RigidMode::press_down(10_000.0)];
    for entry in group("drum_limits") {
        let (id, outputs) = (&entry["id"], &entry["outputs"]);
        let rtol = number(&entry, "rtol").max(4e-15);
        match id.as_str().unwrap() {
            "drum_limit_q_inf_equilibrium" => {
                let mut case = problem(drum(), Functional::WearVolume, f64::INFINITY, 1.0, 0.5, force());
                let p = optimal_pressure(&case).unwrap().p_max;
                same(id, "p", p, number(outputs, "p_uniform_equilibrium"), rtol);
                case.balance = Balance::Paper;
                let p = optimal_pressure(&case).unwrap().p_max;
                same(id, "p paper", p, number(outputs, "p_uniform_paper_norm"), rtol);
            }
            "drum_steady_b1_pivoted_shoe" => {
                let case = problem(drum(), Functional::WearPower, 1.0, 1.0, 1.0, force());
                let optimum = optimal_pressure(&case).unwrap();
                same(id, "p_max", optimum.p_max, number(outputs, "p_max"), rtol);
                same(id, "k", optimum.k.unwrap(), number(outputs, "exponent"), rtol);
            }
            "drum_singular_s_to_1" => {
                let mut case = problem(drum(), Functional::FrictionPower, 1.0, 1.0, 1.0, force());
                case.friction = 0.0;
                let above = singular_limit(&case, 1.0, LimitSide::Above).unwrap();
                assert_eq!(above.len(), 1);
                same(id, "centre", above[0].force, number(outputs, "center_line_force_s1plus_mu0"), 1e-14);
                assert!(above[0].position.x.abs() < 1e-4);
                let below = singular_limit(&case, 1.0, LimitSide::Below).unwrap();
                assert_eq!(below.len(), 2);
                for atom in &below {
                    same(id, "edge", atom.force, number(outputs, "edge_forces_each_s1minus_mu0"), 1e-13);
                }
                case.friction = 0.25;
                case.mode_kind = Modes::Associated;
                let above = singular_limit(&case, 1.0, LimitSide::Above).unwrap();
                let angle = above[0].position.x.atan2(above[0].position.z).to_degrees();
                same(id, "angle", angle, number(outputs, "peak_angle_deg_associated_mu025"), 1e-7);
                same(id, "peak", above[0].force, number(outputs, "peak_line_force_associated_mu025"), 1e-13);
                let below = singular_limit(&case, 1.0, LimitSide::Below).unwrap();
                assert_eq!(below.len(), 1);
                let angle = below[0].position.x.atan2(below[0].position.z).to_degrees();
                same(id, "edge angle", angle, number(outputs, "edge_angle_deg_associated_s1minus"), 1e-13);
                same(id, "edge", below[0].force, number(outputs, "edge_line_force_associated_s1minus"), 1e-13);
                let edges: f64 = number(outputs, "edge_forces_each_s1minus_mu0");
                same(id, "D_F max", 0.25 * 500.0 * 2.0 * edges, number(outputs, "DF_max"), 1e-14);
            }
            other => panic!("{other}"),
        }
    }
}

#[test]
fn punch_moment_limits_divide_full_from_partial_contact_and_function_from_none() {
    for entry in group("punch_limits").into_iter().filter(|entry| entry["outputs"]["M_max"].is_number()) {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let limit = number(outputs, "M_max");
        let at = |moment: f64| {
            let modes = vec![RigidMode::press_down(number(inputs, "F0")), RigidMode::tilt(moment, Vector3::zeros())];
            let case = problem(punch(), functional(inputs), number(inputs, "q"), 1.0, number(inputs, "b"), modes);
            optimal_pressure(&case)
        };
        let inside = at(limit * (1.0 - 1e-4)).unwrap_or_else(|error| panic!("{id} {error}"));
        assert_eq!(inside.s.unwrap(), number(outputs, "s"));
        same(id, "k", inside.k.unwrap(), number(outputs, "k"), 1e-15);
        assert!(inside.regime != Regime::PartialContact, "{id}");
        let beyond = at(limit * (1.0 + 1e-4));
        if inside.k.unwrap() > 0.0 {
            assert_eq!(beyond.unwrap().regime, Regime::PartialContact, "{id}");
        } else {
            assert!(matches!(beyond, Err(wear::WearError::Infeasible { .. })), "{id} {beyond:?}");
        }
    }
}

#[test]
fn punch_pressure_as_s_tends_to_one_is_the_exponential_and_powers_match_near_it() {
    for entry in group("punch_limits").into_iter().filter(|entry| entry["outputs"]["kappa"].is_number()) {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let case = by_s(inputs, 1.0);
        let optimum = optimal_pressure(&case).unwrap();
        assert_eq!(optimum.character, Character::Indifferent);
        for (x, p) in list(outputs, "x").iter().zip(list(outputs, "p")) {
            same(id, "p", optimum.pressure_at(&plane_at(&case.surface, *x)), p, number(&entry, "rtol"));
        }
    }
    for entry in group("punch_powers") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let case = by_s(inputs, read_s(inputs));
        let optimum = optimal_pressure(&case).unwrap();
        for (x, p) in list(outputs, "x").iter().zip(list(outputs, "p")) {
            same(id, "p", optimum.pressure_at(&plane_at(&case.surface, *x)), p, number(&entry, "rtol"));
        }
        let above = read_s(inputs) > 1.0;
        assert_eq!(optimum.character, if above { Character::Minimum } else { Character::Maximum });
    }
}

#[test]
fn punch_beyond_the_kern_touches_over_the_closed_length() {
    for entry in group("punch_partial") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol").max(1e-12);
        let infinite = inputs["q"] == "inf";
        let case = by_s(inputs, if infinite { f64::INFINITY } else { read_s(inputs) });
        let optimum = optimal_pressure(&case).unwrap_or_else(|error| panic!("{id} {error}"));
        let length = number(outputs, "contact_length");
        let front = 30.0 - length;
        let at = |x: f64| optimum.pressure_at(&plane_at(&case.surface, x));
        if infinite {
            same(id, "p", at(30.0), number(outputs, "p_const"), rtol);
            same(id, "p", at(front + 1e-9), number(outputs, "p_const"), rtol);
            assert_eq!(at(front - 1e-9), 0.0);
        } else {
            let (k, edge) = (number(inputs, "k"), number(outputs, "p_edge"));
            same(id, "p edge", at(30.0), edge, rtol);
            for x in [front + 0.3 * length, 0.0, 20.0] {
                same(id, "p", at(x), edge * ((x - front) / length).powf(k), rtol * 10.0);
            }
            assert_eq!(at(front - 1e-6), 0.0);
        }
        assert_eq!(optimum.regime, Regime::PartialContact, "{id}");
        same(id, "moment", optimum.resultants[1], number(inputs, "M0"), 1e-12);
    }
}

#[test]
fn ratio_of_wear_volumes_for_eight_pressure_exponents() {
    for entry in group("annulus_7.4") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let b = number(inputs, "b");
        let mut volumes = Vec::new();
        for (which, key) in [(Functional::WearVolume, "minW"), (Functional::WearPower, "minDw")] {
            let case = problem(annulus(), which, 1.0, 1.0, b, vec![RigidMode::press_down(number(inputs, "F0"))]);
            let optimum = optimal_pressure(&case).unwrap();
            for (r, log_p) in list(&outputs[key], "r").iter().zip(list(&outputs[key], "log_p")) {
                let got = optimum.log_pressure_at(&plane_at(&case.surface, *r));
                assert!((got - log_p).abs() <= 10.0 * rtol * log_p.abs().max(1.0), "{id} {key} {r}: {got} {log_p}");
            }
            powers(id, &optimum, &outputs[key], rtol);
            volumes.push(optimum.wear_volume_rate);
        }
        same(id, "w_r", volumes[0] / volumes[1], number(outputs, "w_r"), rtol);
        let printed: f64 = outputs["w_r_printed"].as_str().unwrap().parse().unwrap();
        assert!((volumes[0] / volumes[1] - printed).abs() < 1e-4);
    }
}

#[test]
fn annulus_limits_and_clutch_formulas() {
    for entry in group("annulus_limits") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let force = vec![RigidMode::press_down(number(inputs, "F0"))];
        let steady = problem(annulus(), Functional::WearPower, 1.0, 1.0, 1.4, force.clone());
        let wanted = &outputs["minDw_q1"];
        let optimum = optimal_pressure(&steady).unwrap();
        powers(id, &optimum, wanted, 1e-12);
        let infinite =
            optimal_pressure(&problem(annulus(), Functional::WearVolume, f64::INFINITY, 1.0, 1.4, force.clone())).unwrap();
        let large = optimal_pressure(&problem(annulus(), Functional::WearVolume, 1e6, 1.0, 1.4, force)).unwrap();
        for (i, r) in list(wanted, "r").iter().enumerate() {
            let point = plane_at(&steady.surface, *r);
            same(id, "steady", optimum.pressure_at(&point), list(wanted, "p")[i], 1e-12);
            same(id, "q = inf", infinite.pressure_at(&point), list(wanted, "p")[i], 1e-12);
            same(id, "q = 1e6", large.pressure_at(&point), list(outputs, "W_q1e6_p")[i], 1e-12);
        }
    }
    for entry in group("annulus_DF").into_iter().filter(|entry| entry["id"] == "annulus_clutch_limits") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let force = || vec![RigidMode::press_down(number(inputs, "F0"))];
        let torque = |which, q| optimal_pressure(&problem(annulus(), which, q, 1.0, 1.0, force())).unwrap().torque.unwrap();
        let rtol = number(&entry, "rtol");
        same(id, "uniform wear", torque(Functional::WearPower, 1.0), number(outputs, "torque_uniform_wear_a_b_1"), rtol);
        same(id, "uniform pressure", torque(Functional::WearPower, 0.0), number(outputs, "torque_uniform_pressure"), rtol);
        let least = optimal_pressure(&problem(annulus(), Functional::FrictionPower, 1.0, 1.0, 1.0, force())).unwrap();
        assert_eq!(least.regime, Regime::Singular);
        same(id, "least", least.torque.unwrap(), number(outputs, "torque_min"), rtol);
        let case = problem(annulus(), Functional::FrictionPower, 1.0, 1.0, 1.0, force());
        let most = singular_limit(&case, 1.0, LimitSide::Below).unwrap();
        same(id, "most", 0.25 * most[0].force * most[0].position.x, number(outputs, "torque_max"), rtol);
    }
}

#[test]
fn no_group_of_the_reference_is_left_out() {
    let tested = [
        "drum",
        "drum_limits",
        "punch",
        "punch_limits",
        "punch_partial",
        "punch_powers",
        "annulus_7.4",
        "annulus_7.5",
        "annulus_DF",
        "annulus_limits",
        "two_body_annulus",
        "two_body_general",
        "nonuniqueness",
        "counterface",
        "transient",
    ];
    for entry in entries() {
        let group = entry["group"].as_str().unwrap();
        assert!(tested.contains(&group), "{group}");
    }
}
