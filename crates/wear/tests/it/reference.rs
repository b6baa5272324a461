//! Every entry of data/reference/optimality.json: closed forms and high-precision quadrature.

use approx::assert_relative_eq;
use serde_json::Value;
use wear::{Balance, Functional, Optimum, Problem, RigidMode, optimal_pressure};

use crate::surfaces::{annulus, drum, drum_at, plane_at, problem, punch};

fn entries() -> Vec<Value> {
    let text = std::fs::read_to_string("../../data/reference/optimality.json").unwrap();
    let json: Value = serde_json::from_str(&text).unwrap();
    json["entries"].as_array().unwrap().clone()
}

fn group(name: &str) -> Vec<Value> {
    let found: Vec<Value> = entries()
        .into_iter()
        .filter(|entry| entry["group"] == name)
        .collect();
    assert!(!found.is_empty());
    found
}

fn number(value: &Value, key: &str) -> f64 {
    value[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key} in {value}"))
}

fn list(value: &Value, key: &str) -> Vec<f64> {
    value[key]
        .as_array()
        .unwrap_or_else(|| panic!("{key}"))
        .iter()
        .map(|v| v.as_f64().unwrap())
        .collect()
}

fn functional(value: &Value) -> Functional {
    match value["functional"].as_str().unwrap() {
        "W" => Functional::WearVolume,
        "DF" => Functional::FrictionPower,
        "Dw" => Functional::WearPower,
        other => panic!("{other}"),
    }
}

/// Relative comparison with the entry named on failure.
fn same(id: &Value, what: &str, got: f64, wanted: f64, rtol: f64) {
    let error = (got - wanted).abs() / wanted.abs().max(f64::MIN_POSITIVE);
    assert!(
        error <= rtol,
        "{id} {what}: got {got:e}, wanted {wanted:e}, relative error {error:.1e} > {rtol:.0e}"
    );
}

fn powers(id: &Value, optimum: &Optimum, outputs: &Value, rtol: f64) {
    same(
        id,
        "W",
        optimum.wear_volume_rate,
        number(outputs, "W"),
        rtol,
    );
    same(
        id,
        "D_F",
        optimum.friction_power,
        number(outputs, "DF"),
        rtol,
    );
    same(id, "D_w", optimum.wear_power, number(outputs, "Dw"), rtol);
    if let Some(value) = outputs["J_q"].as_f64() {
        same(id, "J", optimum.objective.unwrap(), value, rtol);
        same(
            id,
            "lambda",
            optimum.multipliers[0],
            number(outputs, "lambda_F"),
            rtol,
        );
    }
}

#[test]
fn drum_pressures_powers_and_multipliers_for_every_q_and_both_balances() {
    for entry in group("drum") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let (a, b, q) = (
            number(inputs, "a"),
            number(inputs, "b"),
            number(inputs, "q"),
        );
        let mut problem: Problem = problem(
            drum(),
            functional(inputs),
            q,
            a,
            b,
            vec![RigidMode::press_down(number(inputs, "F0"))],
        );
        if inputs["normalisation"] == "paper" {
            problem.balance = Balance::Paper;
        }
        let optimum = optimal_pressure(&problem).unwrap();
        for (degrees, p) in list(outputs, "alpha_deg").iter().zip(list(outputs, "p")) {
            same(
                id,
                "p",
                optimum.pressure_at(&drum_at(&problem.surface, *degrees)),
                p,
                rtol,
            );
        }
        same(
            id,
            "int p",
            optimum.normal_force,
            number(outputs, "int_p_dS"),
            rtol,
        );
        let vertical: f64 = optimum
            .points
            .iter()
            .zip(&optimum.pressure)
            .map(|(pt, p)| pt.weight * pt.normal.z * p)
            .sum();
        same(
            id,
            "int p cos",
            vertical,
            number(outputs, "int_p_cos_dS"),
            rtol,
        );
        powers(id, &optimum, outputs, rtol);
    }
}

#[test]
fn annulus_pressures_powers_and_multipliers() {
    let all = group("annulus_7.5").into_iter().chain(group("annulus_DF"));
    for entry in all.filter(|entry| entry["outputs"]["exponent"].is_number()) {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let (a, b, q) = (
            number(inputs, "a"),
            number(inputs, "b"),
            number(inputs, "q"),
        );
        let problem = problem(
            annulus(),
            functional(inputs),
            q,
            a,
            b,
            vec![RigidMode::press_down(number(inputs, "F0"))],
        );
        let optimum = optimal_pressure(&problem).unwrap();
        for (r, log_p) in list(outputs, "r").iter().zip(list(outputs, "log_p")) {
            let got = optimum.log_pressure_at(&plane_at(&problem.surface, *r));
            assert!(
                (got - log_p).abs() <= rtol * log_p.abs().max(1.0) * 10.0,
                "{id} log p({r}) {got} {log_p}"
            );
        }
        powers(id, &optimum, outputs, rtol);
        same(
            id,
            "torque",
            optimum.torque.unwrap(),
            number(outputs, "torque"),
            rtol,
        );
    }
}

#[test]
fn punch_under_force_and_moment() {
    for entry in group("punch") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let modes = vec![
            RigidMode::press_down(number(inputs, "F0")),
            RigidMode::tilt(number(inputs, "M0"), nalgebra::Vector3::zeros()),
        ];
        let problem = problem(
            punch(),
            Functional::WearPower,
            1.0,
            1.0,
            number(inputs, "b"),
            modes,
        );
        let optimum = optimal_pressure(&problem).unwrap();
        for (x, p) in list(outputs, "x").iter().zip(list(outputs, "p")) {
            same(
                id,
                "p",
                optimum.pressure_at(&plane_at(&problem.surface, *x)),
                p,
                rtol,
            );
        }
        assert_relative_eq!(
            optimum.multipliers[0],
            number(outputs, "lambda_F"),
            max_relative = rtol
        );
        assert_relative_eq!(
            optimum.multipliers[1],
            number(outputs, "lambda_M"),
            max_relative = rtol,
            epsilon = 1e-18
        );
        let feed = optimum.feed.unwrap();
        same(
            id,
            "V_F",
            feed[0],
            number(outputs, "rigid_velocity_F"),
            rtol,
        );
        same(
            id,
            "W",
            optimum.wear_volume_rate,
            number(outputs, "W"),
            rtol,
        );
        same(id, "D_w", optimum.wear_power, number(outputs, "Dw"), rtol);
        assert!(optimum.steadiness_residual.unwrap() < 1e-12);
    }
}
