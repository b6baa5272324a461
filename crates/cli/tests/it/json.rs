//! `--json`: one document on stdout, whatever happens.

use crate::call::Bench;

fn document(text: &str) -> serde_json::Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error} in {text}"))
}

#[test]
fn a_run_prints_its_summary_and_nothing_else() {
    let bench = Bench::new();
    let call = bench.call("run pivoted-shoe --json");
    assert_eq!(call.code, 0, "{}", call.err);
    assert_eq!(document(&call.out), bench.summary("pivoted-shoe"));
    assert!(call.err.is_empty(), "{}", call.err);
    for args in ["run disc-pad --json --dry-run", "check disc-pad --json", "sweep disc-pad --json --dry-run --over wear.b=1,2"] {
        let call = bench.call(args);
        assert!(call.code == 0 && document(&call.out).is_object(), "{args}: {}", call.out);
    }
}

#[test]
fn an_invalid_scene_prints_its_error() {
    let bench = Bench::new();
    bench.file("scene.toml", "units = \"N-mm\"\nthicknes = 3\n");
    for command in ["run", "check"] {
        let call = bench.call(&format!("{command} scene.toml --json"));
        assert_eq!(call.code, 2);
        let error = &document(&call.out)["error"];
        assert_eq!(error["code"], "unknown-key");
        assert_eq!(error["file"], "scene.toml");
        assert_eq!(error["line"], 2);
        assert!(error["message"].as_str().unwrap().contains("thicknes"));
        assert!(error["remedy"].as_str().unwrap().contains("thickness"));
    }
}

#[test]
fn a_wrong_flag_prints_its_error() {
    let bench = Bench::new();
    for args in
        ["run drum-brake-block --json --set thickness=-1", "run --json --nonsense", "run drum-brake-block --json --sample 1"]
    {
        let call = bench.call(args);
        assert_eq!(call.code, 2, "{args}");
        assert!(document(&call.out)["error"]["message"].is_string(), "{args}");
    }
}

#[test]
fn absent_numbers_are_absent_keys() {
    let bench = Bench::new();
    assert_eq!(bench.call("run translating-punch --set tasks=[pressure] -q").code, 0);
    let text = bench.read("out/translating-punch/summary.json");
    assert!(!text.contains("null"), "{text}");
    let summary = bench.summary("translating-punch");
    for stage in ["contact", "shape", "wear", "energy", "reactions"] {
        assert!(summary.get(stage).is_none(), "{stage}");
    }
    for key in [
        "schema_version",
        "version",
        "scene",
        "scene_sha256",
        "status",
        "verdict",
        "stages",
        "counters",
        "unused_keys",
        "lints",
        "pressure",
        "error",
    ] {
        assert!(summary.get(key).is_some(), "{key}");
    }
}

#[test]
fn a_load_without_balance_is_an_answer_with_exit_1() {
    let bench = Bench::new();
    let call = bench.call("run translating-punch --set tasks=[pressure] --set load.moment=40_kN_mm --json");
    assert_eq!(call.code, 1, "{}{}", call.out, call.err);
    let summary = bench.summary("translating-punch");
    assert_eq!((&summary["status"], &summary["pressure"]["regime"]), (&"refused".into(), &"infeasible".into()));
    assert_eq!(document(&call.out), summary);
}
