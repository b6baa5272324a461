//! Sweeps: grids, rows that fail, resuming.

use crate::call::Bench;

#[test]
fn a_grid_has_a_row_for_each_point_and_the_numbers_of_single_runs() {
    let bench = Bench::new();
    let call = bench.call(
        "sweep annular-punch --set tasks=[pressure] --over wear.b=1.05:2:3 --over optimum.functional=wear-volume,wear-power -q",
    );
    assert_eq!(call.code, 0, "{}", call.err);
    let text = bench.read("out/annular-punch-sweep/sweep.jsonl");
    let rows: Vec<serde_json::Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(rows.len(), 6);
    assert_eq!((&rows[2]["wear.b"], &rows[2]["optimum.functional"]), (&1.525.into(), &"wear-volume".into()));
    // Annulus, a = 1: the table w_r of the paper, first and last row (benchmarks: 0.379085, 0.952920).
    let rate = |row: usize| rows[row]["pressure.wear_volume_rate_mm3_per_s"].as_f64().unwrap();
    approx::assert_relative_eq!(rate(0) / rate(1), 0.379085, max_relative = 2e-6);
    approx::assert_relative_eq!(rate(4) / rate(5), 0.952920, max_relative = 2e-6);
    let table = bench.read("out/annular-punch-sweep/sweep.csv");
    assert_eq!(table.lines().count(), 7);
    assert!(table.starts_with("wear.b,optimum.functional,status,verdict,"), "{table}");
}

#[test]
fn failures_are_kept_as_rows() {
    let bench = Bench::new();
    let call = bench.call("sweep translating-punch --set tasks=[pressure] --over load.moment=0,40_kN_mm,many --json");
    assert_eq!(call.code, 1, "{}{}", call.out, call.err);
    let summary: serde_json::Value = serde_json::from_str(&call.out).unwrap();
    assert_eq!((&summary["points"], &summary["failed"]), (&3.into(), &2.into()));
    let text = bench.read("out/translating-punch-sweep/sweep.jsonl");
    let status: Vec<String> = text
        .lines()
        .map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap()["status"].as_str().unwrap().to_string())
        .collect();
    assert_eq!(status, ["ok", "refused", "invalid"]);
}

#[test]
fn the_number_of_threads_does_not_change_a_byte() {
    let bench = Bench::new();
    for (folder, threads) in [("a", 1), ("b", 2)] {
        let args = format!(
            "sweep drum-brake-block --set tasks=[pressure] --over contact.friction=0:1:150 -q --threads {threads} -o {folder}"
        );
        assert_eq!(bench.call(&args).code, 0);
    }
    for name in ["sweep.csv", "sweep.jsonl", "summary.json", "scene.resolved.toml"] {
        assert!(bench.read(&format!("a/{name}")) == bench.read(&format!("b/{name}")), "{name} differs");
    }
}

#[test]
fn an_interrupted_sweep_is_resumed_to_the_same_bytes() {
    let bench = Bench::new();
    let args = "sweep drum-brake-block --set tasks=[pressure] --over contact.friction=0:1:150 -q -o x";
    assert_eq!(bench.call(args).code, 0);
    let whole = bench.read("x/sweep.jsonl");
    let csv = bench.read("x/sweep.csv");
    // The state after a kill: 70 whole rows and a torn one.
    let torn: String = whole.lines().take(70).map(|line| format!("{line}\n")).collect::<String>() + "{\"contact.fr";
    std::fs::create_dir(bench.path("x.partial")).unwrap();
    std::fs::copy(bench.path("x/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
    bench.file("x.partial/sweep.jsonl", &torn);
    assert_eq!(bench.call(&format!("{args} --resume")).code, 0);
    assert!(bench.read("x/sweep.jsonl") == whole, "the rows differ");
    assert!(bench.read("x/sweep.csv") == csv, "the table differs");
}

#[test]
fn a_wrong_grid_is_refused() {
    let bench = Bench::new();
    for over in ["wear.b", "=1,2", "wear.b=1:2:0", "wear.b=1:2:x", "wear.b=1,,2"] {
        let call = bench.call(&format!("sweep annular-punch --over {over}"));
        assert_eq!(call.code, 2, "{over}");
        assert!(call.err.contains("--over") && call.err.contains("remedy: "), "{over}: {}", call.err);
    }
}
