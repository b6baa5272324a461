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
fn a_resumed_sweep_says_which_points_it_took_over_and_counts_its_own() {
    let bench = Bench::new();
    let args = ["sweep", "drum-brake-block", "--set", "tasks=[pressure]", "--over", "contact.friction=0:1:15", "-o", "x"];
    let whole = bench.call_with(&args);
    assert!(whole.code == 0 && whole.out.contains("\n15 points, 0 without an answer"), "{}{}", whole.out, whole.err);
    let json = |name: &str| serde_json::from_str::<serde_json::Value>(&bench.read(&format!("x/{name}"))).unwrap();
    assert_eq!((&json("summary.json")["counters"]["points"], &json("timing.json")["points"]), (&().into(), &15.into()));
    let rows: String = bench.read("x/sweep.jsonl").lines().take(9).map(|line| format!("{line}\n")).collect();
    bench.file("x.partial/sweep.jsonl", &rows);
    std::fs::copy(bench.path("x/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
    let call = bench.call_with(&[&args[..], &["--resume"]].concat());
    assert!(
        call.code == 0 && call.out.contains("\n15 points (9 of them from before), 0 without an answer"),
        "{}{}",
        call.out,
        call.err
    );
    assert_eq!((&json("summary.json")["counters"]["points"], &json("timing.json")["points"]), (&6.into(), &6.into()));
}

#[test]
fn a_resumed_sweep_has_the_same_curves_and_page() {
    let bench = Bench::new();
    let args = "sweep drum-brake-block --set tasks=[pressure] --over contact.friction=0:1:150 -q";
    assert_eq!(bench.call(&format!("{args} -o whole")).code, 0);
    let rows: String = bench.read("whole/sweep.jsonl").lines().take(70).map(|line| format!("{line}\n")).collect();
    bench.file("x.partial/sweep.jsonl", &rows);
    let curves = bench.read("whole/curves.csv");
    bench.file("x.partial/curves.csv", &curves[..curves.len() * 3 / 4]);
    std::fs::copy(bench.path("whole/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
    let call = bench.call(&format!("{args} -o x --resume"));
    assert_eq!(call.code, 0, "{}", call.err);
    for name in ["sweep.jsonl", "sweep.csv", "curves.csv", "report.html"] {
        assert!(bench.bytes(&format!("x/{name}")) == bench.bytes(&format!("whole/{name}")), "{name} differs");
    }
}

#[test]
fn a_wrong_grid_is_refused() {
    let bench = Bench::new();
    for over in ["wear.b", "=1,2", "wear.b=1:2:0", "wear.b=1:2:x", "wear.b=1,,2", "load.force=1kN:2MN:3", "load.force=1:2kN:0"] {
        let call = bench.call(&format!("sweep annular-punch --over {over}"));
        assert_eq!(call.code, 2, "{over}");
        assert!(call.err.contains("--over") && call.err.contains("remedy: "), "{over}: {}", call.err);
    }
    for (over, message) in [
        ("load.force=1e400:2:3", "`1e400:2:3` has an end that is not finite"),
        ("load.force=1:2:0", "`1:2:0` has no values"),
        ("foo.bar=a,b", "unknown key `foo`"),
    ] {
        let call = bench.call(&format!("sweep annular-punch --over {over}"));
        assert!(call.err.starts_with(&format!("error: {message}\n--> --over {over}\n")), "{}", call.err);
    }
    // A wrong --set beside it keeps its own name.
    let call = bench.call("sweep annular-punch --set foo.bar=a --over wear.b=1,2");
    assert!(call.err.contains("--> --set foo.bar=a\n"), "{}", call.err);
}

/// A value that is no number is none in its units either; its point is told as invalid.
#[test]
fn a_value_that_is_no_number_has_an_empty_cell_in_base_units() {
    let bench = Bench::new();
    let args = ["sweep", "drum-brake-block", "--set", "tasks=[pressure]", "--over", "load.force=1 kN,nan", "-q", "-o", "x"];
    assert_eq!(bench.call_with(&args).code, 1, "a point is invalid");
    let table = bench.read("x/sweep.csv");
    let rows: Vec<&str> = table.lines().collect();
    assert!(rows[1].starts_with("1 kN,1000,ok,") && rows[2].starts_with("nan,,invalid,"), "{table}");
    assert!(!bench.read("x/sweep.jsonl").contains("null"));
}

#[test]
fn a_range_has_units_like_a_single_value() {
    let bench = Bench::new();
    let sweep = |over: &str, name: &str| {
        let call = bench.call(&format!("sweep drum-brake-block --set tasks=[pressure] --over {over} -q -o {name}"));
        assert_eq!(call.code, 0, "{over}: {}", call.err);
        let rows = bench.read(&format!("{name}/sweep.jsonl"));
        let peak = |row: &str| serde_json::from_str::<serde_json::Value>(row).unwrap()["pressure.p_max_MPa"].as_f64().unwrap();
        rows.lines().map(peak).collect::<Vec<f64>>()
    };
    let bare = sweep("load.force=1000:3000:3", "bare");
    assert_eq!(bare.len(), 3);
    assert!((bare[2] / bare[0] - 3.0).abs() < 1e-12);
    for (number, over) in ["load.force=1kN:3kN:3", "load.force=1:3kN:3", "load.force=1e-3MN:3e-3MN:3"].iter().enumerate() {
        assert_eq!(sweep(over, &format!("with-{number}")), bare, "{over}");
    }
}

/// Three discretisations (degree 6, a finer one beside it and the proof's 8) of two bodies: six factorisations, however many points.
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
    assert_eq!(summary["counters"]["factorisations"], 6);
    assert_eq!(summary["counters"]["factorisations_saved"], 42);
    let text = bench.read("threads-1/sweep.jsonl");
    let rows: Vec<serde_json::Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(rows.len(), 8);
    for (row, force, friction, functional) in [(0, "1e4", "0", "steady"), (7, "2e4", ".25", "uniform")] {
        let sets = format!("--set load.force={force} --set contact.friction={friction} --set optimum.functional={functional}");
        assert_eq!(bench.call(&format!("run {fixed} {sets} -o single-{row}")).code, 0);
        let single: serde_json::Value = serde_json::from_str(&bench.read(&format!("single-{row}/summary.json"))).unwrap();
        assert_eq!(single["counters"]["factorisations"], 6);
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

#[test]
fn a_scene_that_is_edited_during_its_sweep_changes_no_row() {
    let bench = Bench::new();
    assert_eq!(bench.call("new annular-punch s.toml").code, 0);
    bench.file("gap.csv", "s_mm,gap_um\n20,0\n120,1\n");
    let mut child = bench.start("sweep s.toml --set tasks=[pressure] --over wear.b=1.05:2:4000 --threads 1 -q -o x");
    while !bench.path("x.partial/sweep.jsonl").exists() {
        assert_eq!(child.try_wait().unwrap(), None, "it was over before the scene could be edited");
        std::thread::sleep(std::time::Duration::from_micros(200));
    }
    bench.file("s.toml", "rubbish");
    assert_eq!(child.wait().unwrap().code(), Some(0));
    let rows = bench.read("x/sweep.jsonl");
    assert!(rows.lines().count() == 4000 && rows.lines().all(|row| row.contains("\"status\":\"ok\"")));
}

#[cfg(unix)]
#[test]
fn sweeps_and_studies_read_a_scene_from_a_pipe() {
    let bench = Bench::new();
    let call = bench.shell("\"$0\" new disc-pad | \"$0\" sweep /dev/stdin --over contact.friction=.1,.2,.3 -q -o x");
    assert_eq!(call.code, 0, "{}", call.err);
    assert_eq!(bench.read("x/sweep.csv").lines().count(), 4);
    let call = bench.shell("\"$0\" new drum-brake-block | \"$0\" study /dev/stdin --set optimum.functional=uniform -q -o y");
    assert_eq!(call.code, 0, "{}", call.err);
}

#[test]
fn points_are_counted_before_any_is_made() {
    let bench = Bench::new();
    for over in [
        "--over wear.b=1:2:18446744073709551615",
        "--over wear.b=1:2:1000000000",
        "--over wear.b=1:2:10000 --over contact.friction=0:1:10000",
        "--over wear.b=1:2:99999999999999999999999",
    ] {
        let call = bench.call(&format!("sweep annular-punch {over} --dry-run"));
        assert!(
            call.code == 2 && call.err.contains("--over") && call.err.contains("remedy: "),
            "{over}: {} {}",
            call.code,
            call.err
        );
    }
    let call = bench.call("sweep annular-punch --over wear.b=1:2:10000000 --dry-run");
    assert!(call.code == 0 && call.out.starts_with("10000000 points"), "{}{}", call.out, call.err);
}

/// A limit on the size of files stands for the kill between the opening of a file and its writing.
#[cfg(unix)]
#[test]
fn finished_rows_are_never_written_again() {
    let bench = Bench::new();
    let args = "sweep annular-punch --set tasks=[pressure] --over wear.b=1.05:2:192 -q";
    assert_eq!(bench.call(&format!("{args} -o whole")).code, 0);
    let whole = bench.read("whole/sweep.jsonl");
    let rows: String = whole.lines().take(128).map(|row| format!("{row}\n")).collect();
    bench.file("x.partial/sweep.jsonl", &(rows.clone() + "{\"wear.b\": 1."));
    std::fs::copy(bench.path("whole/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
    let call = bench.shell(&format!("trap '' XFSZ; ulimit -f 8; exec \"$0\" {args} -o x --resume"));
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(bench.read("x.partial/sweep.jsonl").starts_with(&rows), "finished rows are gone");
    assert_eq!(bench.call(&format!("{args} -o x --resume")).code, 0);
    assert!(bench.read("x/sweep.jsonl") == whole);
}

#[test]
fn a_sweep_shows_its_points_with_the_axes_as_they_were_typed() {
    let bench = Bench::new();
    let sets = "sweep drum-brake-block --set mesh.degree=4 --set check=false";
    let call = bench.call(&format!("{sets} --over load.force=5_kN,.1e5,many --over contact.friction=0,.25 -o x"));
    assert_eq!(call.code, 1, "{}", call.err);
    let lines: Vec<&str> = call.out.lines().collect();
    assert!(lines[0].contains("force  friction  p max MPa  gap max um") && lines[0].ends_with("status"), "{}", call.out);
    assert!(lines[2].trim_start().starts_with("5 kN") && lines[3].trim_start().starts_with(".1e5"), "{}", call.out);
    assert!(lines[..7].iter().all(|line| line.chars().count() <= 80), "{}", call.out);
    assert!(call.out.contains("no answer at many, 0: ") && call.out.contains("6 points, 2 without an answer"), "{}", call.out);
    // The table has them as typed, and beside it in base units.
    let table = bench.read("x/sweep.csv");
    assert!(table.starts_with("load.force,load.force.base,contact.friction,status,"), "{table}");
    assert!(
        table.contains("\n5 kN,5000,.25,ok,") && table.contains("\n.1e5,10000,0,ok,") && table.contains("\nmany,,0,invalid,")
    );
    let page = bench.read("x/report.html");
    for word in ["contact pressure by force, friction", "gap by force, friction", ">5 kN, .25<", "<td class=\"number\">.1e5</td>"]
    {
        assert!(page.contains(word), "{word}");
    }
    for word in ["src=", "http://", "https://", "@import", "url("] {
        assert!(!page.replace("http://www.w3.org/2000/svg", "").contains(word), "the page contains {word}");
    }
    assert!(bench.call(&format!("{sets} --over load.force=1e4 -q")).out.is_empty());
}

#[test]
fn a_sweep_with_sample_keeps_the_curves_of_every_point() {
    let bench = Bench::new();
    let args = "sweep annular-punch --set tasks=[pressure] --over wear.b=1.05:2:20 -q";
    assert_eq!(bench.call(&format!("{args} --sample 11 -o x")).code, 0);
    let curves = bench.read("x/curves.csv");
    assert_eq!(curves.lines().count(), 1 + 20 * 11);
    assert!(curves.starts_with("point,s_mm,x_mm,y_mm,z_mm,pressure_MPa,"), "{curves}");
    // The rows of a point are those of a run of it.
    assert_eq!(bench.call("run annular-punch --set tasks=[pressure] --set wear.b=1.05 --sample 11 -q -o first").code, 0);
    let column = |table: &str, name: &str| -> Vec<String> {
        let at = table.lines().next().unwrap().split(',').position(|known| known == name).unwrap();
        table.lines().skip(1).map(|row| row.split(',').nth(at).unwrap().to_string()).collect()
    };
    assert_eq!(column(&curves, "pressure_MPa")[..11], column(&bench.read("first/contact.csv"), "pressure_MPa"));
    // Without it those that are drawn, twelve at most.
    assert_eq!(bench.call(&format!("{args} -o y")).code, 0);
    let mut points = column(&bench.read("y/curves.csv"), "point");
    points.dedup();
    assert!(points.len() == 12 && points[0] == "0" && points[11] == "19", "{points:?}");
}

#[test]
fn curves_of_a_sweep_with_heat_have_the_temperatures_of_single_runs() {
    let bench = Bench::new();
    let mesh = ["--set", "tasks=[shape]", "--set", "mesh.degree=4", "--set", "check=false", "-q"];
    let over = ["sweep", "drum-brake-hot", "-o", "x", "--over", "sliding.omega=1,2", "--over", "heat.reference=20,30"];
    let call = bench.call_with(&[&over[..], &mesh].concat());
    assert_eq!(call.code, 0, "{}", call.err);
    let table = bench.read("x/curves.csv");
    let header: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    assert!(header.ends_with(&["sliding.omega", "heat.reference", "temperature1_degC", "temperature2_degC"]), "{header:?}");
    let hottest = |point: &str| {
        let rows = table.lines().skip(1).map(|row| row.split(',').collect::<Vec<_>>());
        let own = rows.filter(|row| row[0] == point).map(|row| row[row.len() - 2].parse::<f64>().unwrap());
        own.fold(0.0, f64::max)
    };
    // Temperatures above the surroundings of 20 degC go with the speed.
    approx::assert_relative_eq!((hottest("2") - 20.0) / (hottest("0") - 20.0), 2.0, max_relative = 1e-9);
    let page = bench.read("x/report.html");
    assert!(page.contains("temperature of body 1") && page.contains("temperature of body 2"));
}
