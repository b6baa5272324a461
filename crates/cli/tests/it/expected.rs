//! What `check` expects of a run, against the run.

use crate::call::Bench;

fn document(text: &str) -> serde_json::Value {
    serde_json::from_str(text).unwrap()
}

#[test]
fn the_sizes_that_check_expects_are_the_counters_of_the_run() {
    let bench = Bench::new();
    // With a degree that is given only that level stands there, else three for five digits of the accuracy and one for each more.
    for (scene, sets, rows) in [
        ("drum-brake-block", "", 4),
        ("drum-brake-block", "--set accuracy=1e-8", 6),
        ("annular-punch", "--set mesh.degree=6", 1),
        ("translating-punch", "--set mesh={degree=5,layers=3} --set tasks=[contact]", 1),
        ("hertz-cylinder", "--set mesh.degree=6", 1),
        ("drum-brake-hot", "", 3),
        ("clutch-hot", "--set mesh.degree=6", 1),
    ] {
        let plan = document(&bench.call(&format!("check {scene} {sets} --json")).out);
        assert_eq!(document(&bench.call(&format!("run {scene} {sets} --dry-run --json")).out)["stages"], plan["stages"]);
        let call = bench.call(&format!("run {scene} {sets} -q"));
        assert_eq!(call.code, 0, "{scene}: {}", call.err);
        let counters = bench.summary(scene)["counters"].clone();
        let levels = plan["expected"].as_array().unwrap();
        assert_eq!(levels.len(), rows, "{scene}: {levels:?}");
        let level = levels.iter().find(|level| level["dofs"] == counters["dofs"]);
        let level = level.unwrap_or_else(|| panic!("{scene}: {counters} is not in {levels:?}"));
        for key in ["cells", "dofs", "trace_dofs"] {
            assert_eq!(level[key], counters[key], "{scene} {key}");
        }
        if scene != "hertz-cylinder" {
            let rows = bench.read(&format!("out/{scene}/contact.csv")).lines().count() - 1;
            assert_eq!(level["contact_points"], rows, "{scene}");
        }
        let numbers = |key: &str| levels.iter().map(|level| level[key].as_f64().unwrap()).collect::<Vec<f64>>();
        assert!(numbers("memory_bytes").is_sorted() && numbers("memory_bytes")[0] > 0.0, "{scene}: {levels:?}");
        assert!(numbers("about_seconds").iter().all(|seconds| *seconds > 0.0), "{scene}: {levels:?}");
    }
}

#[test]
fn a_scene_without_bodies_has_no_sizes() {
    let bench = Bench::new();
    assert!(document(&bench.call("check disc-pad --json").out).get("expected").is_none());
    let call = bench.call("check drum-brake-block");
    assert!(call.out.contains("contact points") && call.out.contains("about "), "{}", call.out);
}
