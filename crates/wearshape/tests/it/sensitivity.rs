//! What 1 % more of a given number does: the key of each entry, put into the scene, does it.

use std::ops::ControlFlow;

use approx::assert_abs_diff_eq;
use wearshape::{Bodies, Document, Options, PressureResult, Problem, solve};

fn problem(name: &str, settings: &[String]) -> Problem {
    let text = scene::builtin(name).unwrap().text;
    let settings = [&["tasks=[\"pressure\"]".to_string()], settings].concat();
    Problem::new(&Document::read(name, text, &settings).unwrap(), &|_| Err("no file".into())).unwrap()
}

fn pressure(problem: &Problem, machining: bool) -> PressureResult {
    let options = Options { machining, ..Options::default() };
    solve(problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap().pressure.unwrap()
}

/// The number at a key; of both bodies the first.
fn number(problem: &Problem, key: &str) -> f64 {
    let scene = serde_json::to_value(problem.scene()).unwrap();
    let value = scene.pointer(&format!("/{}", key.replace('.', "/"))).unwrap_or_else(|| panic!("no {key}"));
    value.as_f64().or_else(|| value.get(0)?.as_f64()).unwrap_or_else(|| panic!("{key} = {value}"))
}

/// Keys of all entries, each compared with solves of the scene with this number changed.
fn checked(name: &str, settings: &[String]) -> Vec<String> {
    let base = problem(name, settings);
    let found = pressure(&base, true).sensitivity;
    for entry in &found {
        let step = 1e-3;
        let value = number(&base, &entry.given);
        let with = |factor: f64| {
            let changed = format!("{}={:e}", entry.given, value * factor);
            pressure(&problem(name, &[settings, &[changed]].concat()), false)
        };
        let [more, less] = [with(1.0 + step), with(1.0 - step)];
        let percent = |of: fn(&PressureResult) -> Option<f64>| (of(&more).unwrap() / of(&less).unwrap()).ln() / (2.0 * step);
        // The wear rate is a volume over an area, the torque a power over a speed.
        let area = if entry.given.ends_with("width") || entry.given == "thickness" { 1.0 } else { 0.0 };
        let speed = if entry.given.starts_with("sliding") { 1.0 } else { 0.0 };
        let close = |found: Option<f64>, wanted: f64| {
            assert!((found.unwrap() - wanted).abs() < 1e-4, "{name} {}: {found:?} {wanted}", entry.given);
        };
        close(entry.wear_rate_percent, percent(|result| result.wear_volume_rate) - area);
        close(entry.torque_percent, percent(|result| result.friction_power) - speed);
        close(entry.p_max_percent, percent(|result| result.p_max));
    }
    found.into_iter().map(|entry| entry.given).collect()
}

#[test]
fn every_entry_is_what_its_key_does_to_the_scene() {
    let common = |force: &[&str], sliding: &str, last: &[&str]| -> Vec<String> {
        let middle = ["contact.friction", "wear.beta.0", "wear.b", "wear.a", sliding];
        [force, &middle, last].concat().into_iter().map(String::from).collect()
    };
    assert_eq!(checked("drum-brake-block", &[]), common(&["load.force"], "sliding.omega", &["thickness"]));
    assert_eq!(checked("pinned-shoe", &[]), common(&["load.force"], "sliding.omega", &["surface.pinned-shoe.width"]));
    let moments = ["load.force", "load.moment", "load.moment_y"];
    assert_eq!(checked("rectangular-punch", &[]), common(&moments, "sliding.speed", &[]));
    let capped = ["optimum.functional=\"wear-power\"".into(), "optimum.q=1".into(), "optimum.p_max=5.2".into()];
    assert_eq!(checked("drum-brake-block", &capped), common(&["load.force"], "sliding.omega", &["thickness", "optimum.p_max"]));
}

#[test]
fn numbers_of_two_bodies_are_told_apart_where_they_differ() {
    let two = |b: &str| -> Vec<String> { vec!["wear.k=[1e-8,2e-8]".into(), "wear.a=[1,1.5]".into(), format!("wear.b={b}")] };
    let keys = checked("annular-punch", &two("1.2"));
    let expected = ["load.force", "contact.friction", "wear.k.0", "wear.k.1", "wear.b", "wear.a.0", "wear.a.1", "sliding.omega"];
    assert_eq!(keys, expected);
    let keys = checked("annular-punch", &two("[1.2,0.8]"));
    assert!(keys.contains(&"wear.b.0".to_string()) && keys.contains(&"wear.b.1".to_string()), "{keys:?}");
}

#[test]
fn nothing_is_said_without_being_asked_by_an_own_rule_or_under_a_prescribed_approach() {
    let base = problem("drum-brake-block", &[]);
    assert_eq!(pressure(&base, false).sensitivity, []);
    let own = base.with_wear_rule(wearshape::OwnRule::new(|pressure, speed| [1e-6 * pressure * speed, 1e-6 * speed])).unwrap();
    assert_eq!(pressure(&own, true).sensitivity, []);
    let json = serde_json::to_value(pressure(&own, true)).unwrap();
    assert_eq!(json.get("sensitivity"), None);
    assert_abs_diff_eq!(json["p_mean_MPa"].as_f64().unwrap(), 5.0, epsilon = 0.5);
    // Here every number changes the force too.
    let load = "load={ edge = \"top\", as = \"rigid\", approach = 0.01 }".to_string();
    let approached = pressure(&problem("translating-punch", &[load, "accuracy=1e-2".into(), "tasks=[\"shape\"]".into()]), true);
    assert!(approached.p_mean.unwrap() > 0.0);
    assert_eq!(approached.sensitivity, []);
}
