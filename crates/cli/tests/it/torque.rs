//! The friction torque of runs in time.

use approx::assert_relative_eq;
use serde_json::Value;

use crate::call::Bench;

fn columns(bench: &Bench, run: &str) -> Vec<(String, Vec<f64>)> {
    let table = bench.read(&format!("{run}/history.csv"));
    let names = table.lines().next().unwrap().split(',');
    let value = |row: &str, k: usize| row.split(',').nth(k).unwrap().parse().unwrap();
    names.enumerate().map(|(k, name)| (name.to_string(), table.lines().skip(1).map(|row| value(row, k)).collect())).collect()
}

fn column(bench: &Bench, run: &str, name: &str) -> Vec<f64> {
    columns(bench, run).into_iter().find(|(known, _)| known == name).unwrap().1
}

/// From the edges of a flat punch, where the outer one has the longer lever, to the pressure p ~ 1/r of the worn one.
#[test]
fn a_ring_that_wears_in_ends_at_the_torque_of_the_steady_pressure() {
    let bench = Bench::new();
    let args = ["run", "annular-punch", "-q", "-o", "ring", "--set", "accuracy=1e-3", "--set", "tasks=[\"pressure\",\"wear\"]"];
    let call = bench.call_with(&args);
    assert_eq!(call.code, 0, "{}", call.err);
    let torque = column(&bench, "ring", "torque_Nmm");
    let summary: Value = serde_json::from_str(&bench.read("ring/summary.json")).unwrap();
    assert_relative_eq!(*torque.last().unwrap(), summary["pressure"]["torque_Nmm"].as_f64().unwrap(), max_relative = 1e-9);
    assert!(torque[0] > 1.1 * torque.last().unwrap(), "{torque:?}");
}

#[test]
fn torque_follows_the_force_of_the_schedule_and_not_the_speed() {
    let bench = Bench::new();
    let schedule = "schedule={ time = [0, 1, 2, 3], force = [1, 2, 2, 2], speed = [1, 1, 3, 3] }";
    let args = ["run", "annular-punch", "-q", "-o", "ring", "--set", "accuracy=1e-3", "--set", "tasks=[\"wear\"]"];
    let call = bench.call_with(&[&args[..], &["--set", schedule, "--set", "wear.until=3"]].concat());
    assert_eq!(call.code, 0, "{}", call.err);
    let [time, piece] = ["time_s", "piece"].map(|name| column(&bench, "ring", name));
    let torque = column(&bench, "ring", "torque_Nmm");
    let at = |t: f64| time.iter().position(|time| *time == t).unwrap();
    let (before, after) = (at(1.0), at(1.0) + 1);
    assert_eq!((piece[before], piece[after]), (0.0, 1.0));
    // What is added to the force acts as on a flat ring, as the whole force did at the start.
    assert_relative_eq!(torque[after], torque[before] + torque[0], max_relative = 1e-4);
    assert_relative_eq!(torque[at(2.0) + 1], torque[at(2.0)], max_relative = 1e-3);
}

#[test]
fn where_nothing_turns_there_is_no_torque() {
    let bench = Bench::new();
    let args = ["run", "punch-wear", "-q", "-o", "punch", "--set", "accuracy=1e-2", "--set", "wear.until=1"];
    assert_eq!(bench.call_with(&args).code, 0);
    assert!(columns(&bench, "punch").iter().all(|(name, _)| !name.starts_with("torque")));
}
