//! What a sweep keeps of its points: short lists, good folders, the files that its axes name, curves and reasons.

use serde_json::Value;

use crate::call::Bench;

fn rows(bench: &Bench, folder: &str) -> Vec<Value> {
    bench.read(&format!("{folder}/sweep.jsonl")).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn summary(bench: &Bench, folder: &str) -> Value {
    serde_json::from_str(&bench.read(&format!("{folder}/summary.json"))).unwrap()
}

#[test]
fn rows_have_the_numbers_of_short_lists() {
    let bench = Bench::new();
    let mesh = "--set mesh.degree=4 --set check=false";
    let call = bench.call(&format!("sweep hertz-cylinder {mesh} --over load.force=30_kN,35_kN -q -o x"));
    assert_eq!(call.code, 0, "{}", call.err);
    assert_eq!(bench.call(&format!("run hertz-cylinder {mesh} --set load.force=35_kN -q -o one")).code, 0);
    let (rows, one) = (rows(&bench, "x"), summary(&bench, "one"));
    for place in 0..2 {
        assert!(one["contact"]["ends_mm"][place].is_number());
        assert_eq!(rows[1][format!("contact.ends_mm.{place}")], one["contact"]["ends_mm"][place], "{place}");
    }
    assert!(rows[1]["contact.ends_mm.2"].is_null());
    let table = bench.read("x/sweep.csv");
    let header = table.lines().next().unwrap();
    assert!(header.contains(",contact.ends_mm.0,contact.ends_mm.1,"), "{header}");
}

#[test]
fn a_sweep_without_any_answer_leaves_a_good_one_alone() {
    let bench = Bench::new();
    let sweep = |moments: &str| {
        let call = bench.call(&format!("sweep translating-punch --set tasks=[pressure] --over load.moment={moments} -o x"));
        (call.code, call.out, call.err)
    };
    // One point with an answer makes it a good one.
    assert_eq!(sweep("0,40_kN_mm").0, 1);
    let (code, out, err) = sweep("40_kN_mm,50_kN_mm");
    assert!(code == 1 && err.contains("x keeps the sweep of before") && out.contains("x.failed (sweep.csv"), "{out}{err}");
    assert_eq!((&summary(&bench, "x")["failed"], &summary(&bench, "x.failed")["failed"]), (&1.into(), &2.into()));
    assert_eq!(sweep("0").0, 0);
    assert_eq!(summary(&bench, "x")["verdict"], "1 point, 0 without an answer.");
    // Where there is none, it takes the place.
    let call = bench.call("sweep translating-punch --set tasks=[pressure] --over load.moment=40_kN_mm -q -o y");
    assert!(call.code == 1 && summary(&bench, "y")["failed"] == 1 && !bench.path("y.failed").exists());
}

#[test]
fn a_sweep_over_files_is_not_resumed_with_others() {
    let bench = Bench::new();
    let rows_of = |height: &str| format!("s_mm,gap_um\n-110,{height}\n0,0\n110,{height}\n");
    for (name, height) in [("a.csv", "1"), ("b.csv", "2"), ("c.csv", "3")] {
        bench.file(name, &rows_of(height));
    }
    let args = "sweep drum-brake-block --set tasks=[contact] --set mesh.degree=4 --over contact.gap=a.csv,\"b.csv\",{rows=\"c.csv\"} -q -o x";
    let call = bench.call(args);
    let first = rows(&bench, "x");
    assert!(call.code < 2 && first[0]["status"] == "ok" && first[1]["status"] == "ok", "{first:?}");
    let scene = bench.read("x/scene.resolved.toml");
    for name in ["a.csv", "b.csv", "c.csv"] {
        let line = format!("\n# \"{name}\" has sha256 {}\n", crate::call::sha256(&bench.read(name)));
        assert!(scene.contains(&line), "{line}{scene}");
    }
    let partial = || {
        let row = bench.read("x/sweep.jsonl").lines().next().unwrap().to_string() + "\n";
        bench.file("x.partial/sweep.jsonl", &row);
        bench.file("x.partial/scene.resolved.toml", &scene);
    };
    partial();
    for name in ["b.csv", "c.csv"] {
        let kept = bench.read(name);
        bench.file(name, &rows_of("7"));
        let call = bench.call(&format!("{args} --resume"));
        assert!(call.code == 2 && call.err.contains(&format!("\"{name}\" has sha256")), "{}", call.err);
        bench.file(name, &kept);
    }
    assert!(bench.call(&format!("{args} --resume")).code < 2);
    assert_eq!(rows(&bench, "x"), first);
    // The page is built again from a folder with such lines.
    let page = bench.read("x/report.html");
    assert_eq!(bench.call("report x").code, 0);
    assert_eq!(bench.read("x/report.html"), page);
}

#[test]
fn the_page_draws_points_with_an_answer_and_says_why_others_have_none() {
    let bench = Bench::new();
    let args = "sweep translating-punch --set tasks=[pressure] --over load.moment=0:40_kN_mm:60 -q -o x";
    assert_eq!(bench.call(args).code, 1);
    let rows = rows(&bench, "x");
    let answered = rows.iter().filter(|row| row["status"] == "ok").count();
    assert!((15..50).contains(&answered), "{answered}");
    let mut points: Vec<usize> =
        bench.read("x/curves.csv").lines().skip(1).map(|row| row.split(',').next().unwrap().parse().unwrap()).collect();
    points.dedup();
    assert!(points.len() == 12 && points[0] == 0 && points[11] + 4 > answered && points[11] < answered, "{points:?}");
    let page = bench.read("x/report.html");
    let reason = rows[answered]["verdict"].as_str().unwrap();
    assert!(page.contains("<h3>Without an answer</h3>") && page.contains(&reason.replace('>', "&gt;")), "{reason}");
    assert!(!bench.path("x/curves.csv.new").exists());
    assert_eq!(bench.call("report x").code, 0);
    assert_eq!(bench.read("x/report.html"), page);
}

#[test]
fn long_values_of_an_axis_stand_above_the_charts() {
    let bench = Bench::new();
    let over = "body1.material={young=\"5 GPa\",poisson=0.3},{young=\"50 GPa\",poisson=0.3}";
    let mesh = ["--set", "mesh.degree=4", "--set", "check=false", "-q"];
    let page = |over: &str, folder: &str| {
        let call = bench.call_with(&[&["sweep", "drum-brake-block", "--over", over, "-o", folder], &mesh[..]].concat());
        assert_eq!(call.code, 0, "{}", call.err);
        bench.read(&format!("{folder}/report.html"))
    };
    assert!(page(over, "x").contains("\"names_above\":true"));
    assert!(!page("body1.material.young=5 GPa,50 GPa", "y").contains("\"names_above\":true"));
}
