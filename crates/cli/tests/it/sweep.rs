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

/// Four discretisations (degrees 2, 4, 6 and the proof's 8) of two bodies: eight factorisations, however many points.
#[test]
fn a_sweep_factors_each_level_once_and_has_the_numbers_of_single_runs() {
    let bench = Bench::new();
    let fixed = "drum-brake-block --set mesh.degree=6 -q";
    let over = "--over load.force=1e4,2e4 --over contact.friction=0,.25 --over optimum.functional=steady,uniform";
    for threads in [1, 2] {
        let call = bench.call(&format!("sweep {fixed} {over} --threads {threads} -o threads-{threads}"));
        assert_eq!(call.code, 0, "{}", call.err);
    }
    for name in ["sweep.csv", "sweep.jsonl", "summary.json"] {
        assert!(bench.read(&format!("threads-1/{name}")) == bench.read(&format!("threads-2/{name}")), "{name} differs");
    }
    let summary: serde_json::Value = serde_json::from_str(&bench.read("threads-1/summary.json")).unwrap();
    assert_eq!(summary["counters"]["factorisations"], 8);
    assert_eq!(summary["counters"]["factorisations_saved"], 56);
    let text = bench.read("threads-1/sweep.jsonl");
    let rows: Vec<serde_json::Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(rows.len(), 8);
    for (row, force, friction, functional) in [(0, "1e4", "0", "steady"), (7, "2e4", ".25", "uniform")] {
        let sets = format!("--set load.force={force} --set contact.friction={friction} --set optimum.functional={functional}");
        assert_eq!(bench.call(&format!("run {fixed} {sets} -o single-{row}")).code, 0);
        let single: serde_json::Value = serde_json::from_str(&bench.read(&format!("single-{row}/summary.json"))).unwrap();
        assert_eq!(single["counters"]["factorisations"], 8);
        for key in ["gap_max_um", "gap_where_mm", "rigid_mm", "roundtrip_same", "roundtrip_independent"] {
            assert_eq!(rows[row][format!("shape.{key}")], single["shape"][key], "{key}");
        }
        assert_eq!(rows[row]["energy.body1_Nmm"], single["energy"]["body1_Nmm"]);
        assert_eq!(rows[row]["reactions.body2.inner.x_N"], single["reactions"]["body2.inner"]["x_N"]);
    }
}

#[test]
fn a_sweep_over_bodies_factors_each_of_them() {
    let bench = Bench::new();
    let sets = "--set mesh.degree=4 --set check=false -q";
    let call =
        bench.call(&format!("sweep drum-brake-block {sets} --over body1.material.young=1e5,2e5 --over contact.friction=0,.25"));
    assert_eq!(call.code, 0, "{}", call.err);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("out/drum-brake-block-sweep/summary.json")).unwrap();
    // Degrees 2 and 4 of two bodies for two moduli.
    assert_eq!(summary["counters"]["factorisations"], 8);
    assert_eq!(summary["counters"]["factorisations_saved"], 8);
}

/// Prescribed and free rotation, and friction with its twisting, are other bodies or other responses of the same ones.
#[test]
fn elastic_sweeps_resume_to_the_same_rows() {
    let bench = Bench::new();
    let args = "sweep annular-punch --set mesh.degree=4 --over contact.friction=0,.1,.2,.3 --over wear.b=.8,1,1.2 -q -o x";
    assert_eq!(bench.call(args).code, 0);
    let whole = bench.read("x/sweep.jsonl");
    let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
    // Degrees 2, 4, the proof's 6, and the twist of degree 4, of two bodies.
    assert_eq!(summary["counters"]["factorisations"], 8);
    let torn: String = whole.lines().take(5).map(|line| format!("{line}\n")).collect::<String>() + "{\"contact.fr";
    std::fs::create_dir(bench.path("x.partial")).unwrap();
    std::fs::copy(bench.path("x/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
    bench.file("x.partial/sweep.jsonl", &torn);
    assert_eq!(bench.call(&format!("{args} --resume")).code, 0);
    assert!(bench.read("x/sweep.jsonl") == whole, "the rows differ");
}

#[test]
fn a_sweep_is_not_resumed_with_another_scene_and_its_rows_stay() {
    let bench = Bench::new();
    let args = "sweep translating-punch --set tasks=[pressure] --over load.moment=0,1_kN_mm -q -o x";
    assert_eq!(bench.call(args).code, 0);
    std::fs::rename(bench.path("x"), bench.path("x.partial")).unwrap();
    let rows = bench.read("x.partial/sweep.jsonl");
    for other in ["--set wear.b=2.5", "--over wear.b=1,2"] {
        let call = bench.call(&format!("{args} --resume {other}"));
        assert_eq!(call.code, 2, "{other}: {}", call.err);
        assert!(call.err.contains("another scene") && call.err.contains("leave out --resume"), "{}", call.err);
        assert_eq!(bench.read("x.partial/sweep.jsonl"), rows, "{other}");
    }
    let call = bench.call(&format!("{args} --resume"));
    assert_eq!(call.code, 0, "{}", call.err);
    assert_eq!(bench.read("x/sweep.jsonl"), rows);
}

#[test]
fn the_resolved_scene_of_a_sweep_runs_beside_its_mesh() {
    let bench = Bench::new();
    std::fs::create_dir(bench.path("meshes")).unwrap();
    for name in ["lining.toml", "lining.msh"] {
        let path = format!("{}/../../data/meshes/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::copy(path, bench.path("meshes").join(name)).unwrap();
    }
    let call = bench.call("sweep meshes/lining.toml --set tasks=[pressure] --over contact.friction=.3,.4 -q -o x");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(bench.bytes("x/body1.msh") == bench.bytes("meshes/lining.msh"));
    let call = bench.call("run x/scene.resolved.toml -q -o first");
    assert_eq!(call.code, 0, "{}", call.err);
    let row: serde_json::Value = serde_json::from_str(bench.read("x/sweep.jsonl").lines().next().unwrap()).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&bench.read("first/summary.json")).unwrap();
    assert_eq!(row["pressure.p_max_MPa"], summary["pressure"]["p_max_MPa"]);
}
