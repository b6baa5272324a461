//! A wear rule given as a function: it is the scene's own law where it is the same law, and what it cannot serve is refused.

use std::ops::ControlFlow;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use wearshape::{Bodies, Document, Options, OwnRule, Problem, Solution, Status, solve};

#[path = "../../examples/own_rule.rs"]
#[allow(dead_code, unreachable_pub)]
mod example;

fn without_threshold(pressure: f64, sliding_speed: f64) -> [f64; 2] {
    example::above(0.0, pressure, sliding_speed)
}

fn problem(text: &str) -> Problem {
    Problem::new(&Document::read("own-rule", text, &[]).unwrap(), &|_| Err("no file".into())).unwrap()
}

/// Largest difference of a column from that of another solution, over its largest value.
fn apart(a: &Solution, b: &Solution, column: fn(&wearshape::Profile) -> &Vec<f64>) -> f64 {
    let [a, b] = [a, b].map(|solution| column(solution.curve.as_ref().unwrap()));
    assert_eq!(a.len(), b.len());
    let largest = a.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
}

#[test]
fn the_example_runs() {
    example::main().unwrap();
}

#[test]
fn the_scenes_own_law_as_a_function_gives_its_pressure_gap_and_wear_rate() {
    let bodies = Bodies::default();
    let plain = example::scene().unwrap();
    let given = plain.with_wear_rule(OwnRule::new(without_threshold)).unwrap();
    let [plain, given] = [plain, given].map(|problem| example::solved(&problem, &bodies).unwrap());
    assert_eq!(given.status, Status::Ok);
    assert!(apart(&plain, &given, |profile| &profile.pressure) < 1e-9);
    assert!(apart(&plain, &given, |profile| &profile.gap) < 1e-9);
    assert!(apart(&plain, &given, |profile| &profile.wear_rate) < 1e-9);
    let [plain, given] = [plain, given].map(|solution| solution.pressure.unwrap());
    assert_relative_eq!(plain.feed.unwrap().force.unwrap(), given.feed.unwrap().force.unwrap(), max_relative = 1e-9);
    assert_relative_eq!(plain.wear_power.unwrap(), given.wear_power.unwrap(), max_relative = 1e-9);
    assert_relative_eq!(plain.torque.unwrap(), given.torque.unwrap(), max_relative = 1e-9);
    // What is said of powers alone is not said.
    assert_eq!((given.s, given.k), (None, None));
    assert_eq!([plain.wear_rule, given.wear_rule], [None, Some("given as a function")]);
}

#[test]
fn a_threshold_that_vanishes_gives_the_law_without_it_and_a_high_one_a_uniform_pressure() {
    let text = example::SCENE.replace(r#"["pressure", "shape"]"#, r#"["pressure"]"#);
    let plain = problem(&text);
    let pressure = |rule| example::solved(&plain.with_wear_rule(rule).unwrap(), &Bodies::default()).unwrap();
    let without = example::solved(&plain, &Bodies::default()).unwrap();
    let [small, smaller, high, higher] =
        [1e-3, 1e-6, 4.9, 5.1].map(|threshold| OwnRule::new(move |p, v| example::above(threshold, p, v)));
    let column = |profile: &wearshape::Profile| -> Vec<f64> { profile.pressure.clone() };
    let far = apart(&without, &pressure(small), |profile| &profile.pressure);
    let near = apart(&without, &pressure(smaller), |profile| &profile.pressure);
    assert!(far < 1e-3 && near < 1.1e-3 * far, "{far} {near}");
    // p -> F/(t 2 R sin 30 deg) = 5 MPa.
    for value in column(pressure(high).curve.as_ref().unwrap()) {
        assert_abs_diff_eq!(value, 5.0, epsilon = 0.11);
    }
    let refused = pressure(higher);
    assert_eq!(refused.status, Status::Refused);
    assert!(refused.reason.unwrap().contains("threshold"));
}

#[test]
fn what_a_rule_cannot_serve_is_refused_with_its_key() {
    let cases = [
        ("tasks = [\"pressure\", \"shape\"]", "tasks = [\"pressure\", \"wear\"]", "tasks"),
        ("tasks = [\"pressure\", \"shape\"]", "tasks = [\"contact\"]", "tasks"),
        ("kinematics", "optimum = { functional = \"wear-power\", q = 2 }\nkinematics", "optimum.functional"),
    ];
    for (old, new, key) in cases {
        let fault = problem(&example::SCENE.replace(old, new)).with_wear_rule(OwnRule::new(example::rule)).unwrap_err();
        assert_eq!(fault.key.as_deref(), Some(key), "{}", fault.message);
    }
}

#[test]
fn problems_are_equal_by_their_rules_and_say_so_where_they_are_written() {
    let plain = example::scene().unwrap();
    let rule = OwnRule::new(example::rule);
    let given = plain.with_wear_rule(rule.clone()).unwrap();
    assert_eq!(given, plain.with_wear_rule(rule).unwrap());
    assert_ne!(given, plain);
    assert_ne!(given, plain.with_wear_rule(OwnRule::new(without_threshold)).unwrap());
    assert!(given.resolved().contains("given as a function"));
}

#[test]
fn the_force_of_an_approach_and_the_running_in_of_a_tolerance_follow_from_the_rule() {
    let load = r#"{ edge = "top", as = "rigid", approach = 0.01 }"#;
    let text = example::SCENE.replace(r#"{ edge = "top", as = "pressure", force = "10 kN" }"#, load).replace("1e-6\n", "1e-4\n");
    let plain = problem(&text);
    let given = plain.with_wear_rule(OwnRule::new(without_threshold)).unwrap();
    let options = Options { machining: true, ..Options::default() };
    let bodies = Bodies::default();
    let [plain, given] =
        [plain, given].map(|problem| solve(&problem, &options, &bodies, &mut |_| ControlFlow::Continue(())).unwrap());
    let force = |solution: &Solution| solution.pressure.as_ref().unwrap().force.unwrap();
    assert_relative_eq!(force(&plain), force(&given), max_relative = 1e-9);
    let [plain, given] = [plain, given].map(|solution| solution.shape.unwrap().tolerance);
    assert!(!plain.is_empty() && plain.len() == given.len());
    for (plain, given) in plain.iter().zip(&given) {
        assert_relative_eq!(plain.run_in_distance.unwrap(), given.run_in_distance.unwrap(), max_relative = 1e-6);
    }
    assert_relative_eq!(plain[0].pressure_change_relative, given[0].pressure_change_relative, max_relative = 1e-6);
}
