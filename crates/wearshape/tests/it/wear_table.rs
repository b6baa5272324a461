//! A wear rule from a table of measured wear factors, from the scene: Archard's where the factor does not change, the steady state of its rates, the run
//! in time that ends there, and what does not go with it.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Options, Problem, Solution, Status, solve};

fn text(name: &str, rule: &str) -> String {
    let text = scene::builtin(name).unwrap().text;
    let line = text.lines().find(|line| line.starts_with("wear = ")).unwrap();
    let until = if name == "punch-wear" { ", until = \"steady\"" } else { "" };
    text.replace(line, &format!("wear = {{ {rule}{until} }}"))
}

fn read(name: &str, rule: &str, settings: &[&str]) -> Result<Problem, scene::Fault> {
    let settings: Vec<String> = settings.iter().map(ToString::to_string).collect();
    Problem::new(&Document::read(name, &text(name, rule), &settings)?, &|_| Err("no file".into()))
}

fn solved(name: &str, rule: &str, settings: &[&str]) -> Solution {
    let problem = read(name, rule, settings).unwrap();
    solve(&problem, &Options::default(), &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// Factors that double with the pressure: wear by distance on 1e-10 p^2 at the rows.
const GROWING: &str = "table = [[\"1 MPa\", \"1e-7 mm^3/(N m)\"], [2, 2e-10], [4, 4e-10], [8, 8e-10]]";

#[test]
fn a_factor_that_does_not_change_is_archards() {
    let settings = ["tasks=[\"pressure\",\"shape\"]", "accuracy=1e-6"];
    let [table, archard] = ["table = [[1, 2e-10], [3, 2e-10], [9, 2e-10]]", "k = [2e-10, 0], a = 1, b = 1"]
        .map(|rule| solved("drum-brake-block", rule, &settings));
    let [one, other] = [&table, &archard].map(|solution| solution.curve.as_ref().unwrap());
    for ((p, wanted), (gap, cold)) in one.pressure.iter().zip(&other.pressure).zip(one.gap.iter().zip(&other.gap)) {
        assert!((p / wanted - 1.0).abs() < 1e-10, "{p} {wanted}");
        assert!((gap - cold).abs() < 1e-8, "{gap} {cold}");
    }
    let result = table.pressure.unwrap();
    assert_eq!(result.wear_rule, Some("from a table"));
    let volume = archard.pressure.unwrap().wear_volume_rate.unwrap();
    assert!((result.wear_volume_rate.unwrap() / volume - 1.0).abs() < 1e-10);
}

#[test]
fn the_steady_pressure_on_a_drum_wears_by_the_cosine() {
    // The guided shoe recedes rigidly: the rate along the normal is V cos(alpha), and with w' = W(p) v of the table V follows from the force.
    let solution = solved("drum-brake-block", GROWING, &["tasks=[\"pressure\"]"]);
    let curve = solution.curve.unwrap();
    let middle = curve.wear_rate[curve.s.iter().position(|s| s.abs() < 1e-9).unwrap()];
    let mut force = 0.0;
    for i in 0..curve.s.len() {
        let alpha = curve.s[i] / 200.0;
        assert!((curve.wear_rate[i] / (middle * alpha.cos()) - 1.0).abs() < 1e-9);
        let step = |j: usize| curve.s.get(j).copied().unwrap_or(curve.s[i]);
        force += 10.0 * curve.pressure[i] * alpha.cos() * 0.5 * (step(i + 1) - if i == 0 { curve.s[0] } else { curve.s[i - 1] });
    }
    // Trapezoids over the rows.
    assert!((force / 1e4 - 1.0).abs() < 1e-5, "{force}");
}

#[test]
fn the_run_in_time_ends_at_the_uniform_pressure_of_a_punch() {
    let settings = ["contact={edges=[\"bottom\",\"top\"],friction=0,gap=0}", "accuracy=1e-3"];
    let solution = solved("punch-wear", "table = [[0.5, 1e-6], [1, 4e-6], [2, 1e-5]]", &settings);
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    let (profile, mean) = (solution.profile.unwrap(), 1000.0 / 600.0);
    for p in &profile.pressure {
        assert!((p / mean - 1.0).abs() < 3e-3, "{p}");
    }
}

#[test]
fn pressures_beyond_the_table_are_told() {
    let told = |rule: &str| {
        let solution = solved("drum-brake-block", rule, &["tasks=[\"pressure\"]"]);
        solution.remarks.iter().any(|note| note.code == "beyond-wear-table")
    };
    assert!(told("table = [[1, 1e-10], [4, 3e-10]]"));
    assert!(!told(GROWING));
}

#[test]
fn the_resolved_scene_is_the_same_problem() {
    let problem = read("drum-brake-block", GROWING, &[]).unwrap();
    let again = Problem::new(&Document::read("again", &problem.resolved(), &[]).unwrap(), &|_| Err("no file".into())).unwrap();
    assert_eq!(problem.resolved(), again.resolved());
    assert!(problem.resolved().contains("[2.0, 0.0000000002], "), "{}", problem.resolved());
}

#[test]
fn what_no_rule_goes_through_is_refused_with_its_row() {
    for (rule, settings, key) in [
        ("table = []", &[][..], "wear.table"),
        ("table = [[1, 1e-10], [1, 2e-10]]", &[], "wear.table.1"),
        ("table = [[1, 1e-10], [2, 0.4e-10]]", &[], "wear.table.1"),
        ("table = [[1, 0], [2, 0]]", &[], "wear.table.1"),
        ("table = [[-1, 1e-10], [2, 2e-10]]", &[], "wear.table.0"),
        ("table = [[1, 1e-10]], k = 1e-10", &[], "wear.k"),
        ("table = [[1, 1e-10]], b = 2", &[], "wear.b"),
        ("table = [[1, 1e-10]], threshold = 1", &[], "wear.threshold"),
        ("table = [[1, 1e-10]]", &["optimum.functional=wear-power"], "optimum.functional"),
        ("table = [[1, 1e-10]]", &["sliding.reversing={share=0.5}"], "sliding.reversing"),
    ] {
        let fault = read("drum-brake-block", rule, settings).unwrap_err();
        assert_eq!(fault.key.as_deref(), Some(key), "{rule}: {}", fault.message);
    }
}
