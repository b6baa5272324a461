//! `wearshape diff`: what two folders of results differ in, with the exit codes of diff(1).

use crate::call::Bench;

fn diff(bench: &Bench, args: &str) -> (i32, serde_json::Value) {
    let call = bench.call(&format!("diff {args} --json"));
    (call.code, serde_json::from_str(&call.out).unwrap_or_else(|error| panic!("{error}: {}{}", call.out, call.err)))
}

fn entry<'a>(found: &'a serde_json::Value, key: &str) -> &'a serde_json::Value {
    found["summary"].as_array().unwrap().iter().find(|entry| entry["key"] == key).unwrap()
}

#[test]
fn the_same_run_twice_is_the_same_and_another_load_is_not() {
    let bench = Bench::new();
    let scene = "run drum-brake-block --set mesh.degree=6 -q";
    for (name, force) in [("a", "10_kN"), ("b", "10_kN"), ("c", "10.1_kN")] {
        assert_eq!(bench.call(&format!("{scene} --set load.force={force} -o {name}")).code, 0);
    }
    let (code, found) = diff(&bench, "a b");
    assert_eq!((code, &found["same"], &found["scene"]), (0, &true.into(), &serde_json::json!([])));
    assert_eq!(found["contact"]["gap_um"]["largest"], 0.0);
    assert!(bench.call("diff a b").out.contains("the results are the same within 0e0"));
    // Pressure, and so the shape, are proportional to the load.
    let (code, found) = diff(&bench, "a c --tolerance 1e-3");
    assert_eq!((code, &found["same"]), (1, &false.into()));
    assert_eq!(found["scene"][0]["key"], "load.force");
    let relative = |value: &serde_json::Value| value.as_f64().unwrap();
    approx::assert_relative_eq!(relative(&entry(&found, "pressure.p_max_MPa")["relative"]), 0.1 / 10.1, max_relative = 1e-9);
    approx::assert_relative_eq!(relative(&found["contact"]["pressure_MPa"]["largest_relative"]), 0.01, max_relative = 1e-9);
    approx::assert_relative_eq!(relative(&found["contact"]["pressure_MPa"]["l2_relative"]), 0.01, max_relative = 1e-9);
    assert!(entry(&found, "counters.dofs")["result"] == false);
    assert_eq!(diff(&bench, "a c --tolerance 0.1").0, 0);
    let text = bench.call("diff a c").out;
    assert!(text.contains("load.force: 10000.0 | 10100.0") && text.contains("the results differ by more than 0e0"), "{text}");
}

#[test]
fn gaps_on_other_points_are_compared_over_s_without_their_rigid_part() {
    let bench = Bench::new();
    for (name, set) in [("a", "--sample 401"), ("b", "--sample 301")] {
        assert_eq!(bench.call(&format!("run drum-brake-block --set mesh.degree=8 -q {set} -o {name}")).code, 0);
    }
    let (_, found) = diff(&bench, "a b");
    let of = |column: &str, key: &str| found["contact"][column][key].as_f64().unwrap();
    assert_eq!(found["contact"]["interpolated"], true);
    // Pressure is smooth. The gap has corners of infinite slope at its ends: there, and only there, points matter.
    assert!(of("pressure_MPa", "largest_relative") < 1e-8, "{}", found["contact"]);
    let gap = of("gap_um", "largest_relative");
    assert!(gap > 0.0 && gap < 3.0 * of("gap_um", "interpolation_relative") && gap < 3e-3, "{}", found["contact"]);
    assert!(of("gap_um", "l2_relative") < 0.3 * gap, "{}", found["contact"]);
}

#[test]
fn what_is_no_folder_of_results_cannot_be_compared() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q -o a").code, 0);
    for args in ["diff a nowhere", "diff nowhere a", "diff a a --tolerance nan", "diff a a --tolerance=-1", "diff a"] {
        let call = bench.call(args);
        assert!(call.code == 2 && !call.err.is_empty() && call.out.is_empty(), "{args}: {} {}", call.code, call.err);
    }
    bench.file("b/summary.json", "{");
    let call = bench.call("diff a b");
    assert!(call.code == 2 && call.err.contains("summary.json is damaged"), "{}", call.err);
}

#[test]
fn only_runs_can_be_compared() {
    let bench = Bench::new();
    for args in [
        "run disc-pad -q -o run",
        "sweep disc-pad --over contact.friction=.1,.2 -q -o sweep",
        "reproduce fig19 -q -o figure",
        "study hertz-cylinder -q -o study",
    ] {
        assert_eq!(bench.call(args).code, 0, "{args}");
    }
    for (folder, what) in [("study", "a study"), ("sweep", "a sweep"), ("figure", "a figure of the paper")] {
        for args in [format!("run {folder}"), format!("{folder} run"), format!("{folder} {folder}")] {
            let call = bench.call(&format!("diff {args}"));
            assert_eq!(call.code, 2, "{args}: {}", call.out);
            assert!(call.err.contains(&format!("{folder} holds {what}")), "{args}: {}", call.err);
        }
    }
}
