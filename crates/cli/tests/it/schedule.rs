//! Load and speed that change with time: against closed forms, and what is refused.

use approx::assert_relative_eq;

use crate::call::Bench;

/// Two columns of the same width, guided at their sides: the pressure is uniform, F / (width t), whatever wears.
///
/// ```text
///    | F |
///   o|   |o   z = 20
///   o|___|o   z = 10
///   o|   |o
///    /////    z = 0
/// ```
const COLUMNS: &str = r#"
title = "Two columns"
units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["wear"]
mesh = { degree = 5, layers = 1 }
body1.material = { young = "2 GPa", poisson = 0.3 }
body1.geometry.rectangle = { x = [-10, 10], z = [10, 20] }
body1.support = { left = ["x"], right = ["x"] }
body2.material = { young = "2 GPa", poisson = 0.3 }
body2.geometry.rectangle = { x = [-10, 10], z = [0, 10] }
body2.support = { left = ["x"], right = ["x"], bottom = ["z"] }
contact = { edges = ["bottom", "top"], friction = 0.3, shear = false, gap = 0 }
sliding = { speed = 20 }
load = { edge = "top", as = "pressure", force = "1 kN" }
wear = { k = [3e-8, 1e-8], a = 1.2, b = 1.5, counterface = "congruent", until = "300 s" }
schedule = { time = [0, "100 s", "150 s", "4 min"], force = [1, 0.5, 2, 1], speed = [1, -1, 1, 0.25] }
"#;
const WIDTH: f64 = 20.0;
const THICKNESS: f64 = 10.0;

#[test]
fn under_a_uniform_pressure_the_depth_is_the_integral_of_the_rate() {
    let bench = Bench::new();
    bench.file("columns.toml", COLUMNS);
    let call = bench.call("run columns.toml -q");
    assert_eq!(call.code, 0, "{}", call.err);
    let wear = &bench.summary("columns")["wear"];
    let number = |key: &str| wear[key].as_f64().unwrap();
    assert_eq!((wear["status"].as_str(), number("time_s")), (Some("time-reached"), 300.0));
    let pieces = [(100.0, 1.0, 1.0), (50.0, 0.5, 1.0), (90.0, 2.0, 1.0), (60.0, 1.0, 0.25)];
    let pressure = 1000.0 / (WIDTH * THICKNESS);
    let integral = |k: f64| -> f64 {
        pieces.iter().map(|(t, f, v): &(f64, f64, f64)| t * k * (f * pressure).powf(1.5) * (v * 20.0).powf(1.2)).sum()
    };
    assert_relative_eq!(number("depth_um"), 1e3 * integral(3e-8), max_relative = 1e-9);
    assert_relative_eq!(number("volume_mm3"), WIDTH * THICKNESS * integral(4e-8), max_relative = 1e-9);
    assert_relative_eq!(number("distance_mm"), 20.0 * (240.0 + 0.25 * 60.0), max_relative = 1e-12);
    let table = bench.read("out/columns/history.csv");
    let column = |row: &str, k: usize| row.split(',').nth(k).unwrap().parse::<f64>().unwrap();
    let times: Vec<f64> = table.lines().skip(1).map(|row| column(row, 1)).collect();
    assert!([100.0, 150.0, 240.0].iter().all(|end| times.contains(end)), "a step ends where a piece ends: {times:?}");
    let last = table.lines().last().unwrap();
    assert_eq!(column(last, 12), 3.0, "{last}");
    assert_relative_eq!(column(last, 4), pressure, max_relative = 1e-9);
}

#[test]
fn wear_beyond_a_tenth_of_the_body_is_noted_and_less_is_not() {
    let bench = Bench::new();
    bench.file("columns.toml", COLUMNS);
    let pressure: f64 = 1000.0 / (WIDTH * THICKNESS);
    // The shaped column is 10 mm high: this factor wears 1 mm off it in 200 s, evenly.
    let factor = 1.0 / (200.0 * pressure.powf(1.5) * 20.0_f64.powf(1.2));
    let lints = |part: f64| {
        let k = part * factor;
        let args = ["run", "columns.toml", "-q", "--set", "wear.until=200", "--set", "schedule.force=[1,1,1,1]"];
        let sets = format!("wear.k=[{k},0]");
        let call = bench.call_with(&[&args[..], &["--set", "schedule.speed=[1,1,1,1]", "--set", &sets]].concat());
        assert_eq!(call.code, 0, "{}", call.err);
        bench.summary("columns")["lints"].clone()
    };
    assert_eq!(lints(0.99), serde_json::json!([]));
    let noted = lints(1.01);
    assert_eq!(noted[0]["code"], "wear-beyond-body", "{noted}");
    let message = noted[0]["message"].as_str().unwrap();
    assert!(message.contains("1.01 mm off body 1") && message.contains("thickness of 10 mm (up to "), "{message}");
    assert!(bench.read("out/columns/report.html").contains("wear-beyond-body"));
}

#[test]
fn a_scene_in_one_piece_is_the_scene_without_a_schedule_and_a_reversed_one_its_mirror_image() {
    let bench = Bench::new();
    let wear = |folder: &str, args: &str| {
        let fixed = "--set mesh={degree=4,layers=2} --set wear.until=20_s";
        let call = bench.call(&format!("run punch-wear -q -o {folder} {fixed} {args}"));
        assert_eq!(call.code, 0, "{}", call.err);
        bench.read(&format!("{folder}/contact.csv"))
    };
    let plain = wear("plain", "");
    assert_eq!(wear("one", "--set schedule={time=[0],force=[1]}"), plain);
    let split = wear("split", "--set schedule.time=[0,10] --set schedule.force=[1,1]");
    let column = |table: &str, k: usize| -> Vec<f64> {
        table.lines().skip(1).map(|row| row.split(',').nth(k).unwrap().parse().unwrap()).collect()
    };
    let (pressure, gap) = (8, 11);
    for (a, b) in column(&split, gap).iter().zip(column(&plain, gap)) {
        assert_relative_eq!(*a, b, epsilon = 1e-4);
    }
    // Backwards: the picture in a mirror, with the shear still along the sliding.
    let back = wear("back", "--set schedule.time=[0] --set schedule.speed=[-1]");
    let mirrored = |k: usize| column(&back, k).into_iter().rev().collect::<Vec<f64>>();
    for (k, tolerance) in [(pressure, 1e-7), (gap, 1e-5), (10, 1e-7), (13, 1e-7)] {
        let scale = column(&plain, k).iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        for (a, b) in mirrored(k).iter().zip(column(&plain, k)) {
            assert_relative_eq!(*a, b, epsilon = tolerance * scale);
        }
    }
    let (ahead, reversed) = (column(&plain, gap), column(&back, gap));
    let skew = ahead.iter().zip(&reversed).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    let largest = ahead.iter().copied().fold(0.0, f64::max);
    assert!(skew > 0.3 * largest, "the friction makes the shape skew: {skew} of {largest}");
}

#[test]
fn a_moment_that_comes_and_goes_is_carried() {
    let bench = Bench::new();
    let call = bench.call(
        "run punch-wear -q -o x --set mesh={degree=4,layers=2} --set wear.until=2 --set load.moment=2_kN_mm \
         --set schedule={time=[0,1],moment=[0,1]}",
    );
    assert_eq!(call.code, 0, "{}", call.err);
    let table = bench.read("x/contact.csv");
    let moment: f64 = table
        .lines()
        .skip(1)
        .map(|row| {
            let cells: Vec<f64> = row.split(',').take(9).map(|cell| cell.parse().unwrap()).collect();
            cells[1] * cells[7] * cells[8]
        })
        .sum();
    assert_relative_eq!(moment, 2000.0, max_relative = 1e-6);
}

#[test]
fn schedules_that_make_no_sense_are_refused_in_their_place() {
    let bench = Bench::new();
    let good = "schedule = { time = [0, \"100 s\", \"150 s\", \"4 min\"], force = [1, 0.5, 2, 1], speed = [1, -1, 1, 0.25] }";
    assert!(COLUMNS.contains(good));
    for (bad, message, remedy) in [
        ("schedule = { force = [1, 2] }", "`schedule.time` is missing", "time = [0"),
        ("schedule = { time = [0, 1] }", "nothing changes", "force = "),
        ("schedule = { time = [1, 2], force = [1, 2] }", "begins at 1 s", "at 0"),
        ("schedule = { time = [0, 2, 2], force = [1, 2, 1] }", "do not increase", "ascending"),
        ("schedule = { time = [0, 2], force = [1, 2, 1] }", "3 numbers for 2 pieces", "2 numbers"),
        ("schedule = { time = [0, 2], force = [1, 0] }", "does not press", "greater than 0"),
        ("schedule = { time = [0, 2], speed = [1, 0] }", "stops the sliding", "standstill"),
        ("schedule = { time = [0, 2], moment = [1, 0] }", "load.moment", "give load.moment"),
        ("schedule = { time = [0, \"2 mm\"], force = [1, 2] }", "does not measure a time", "ms"),
        ("schedule = { time = [0, 2], forces = [1, 2] }", "unknown key `forces`", "did you mean `force`?"),
    ] {
        bench.file("bad.toml", &COLUMNS.replace(good, bad));
        let call = bench.call("check bad.toml");
        assert_eq!(call.code, 2, "{bad}: {}", call.out);
        assert!(call.err.contains(message) && call.err.contains(remedy), "{bad}: {}", call.err);
        assert!(call.err.contains("bad.toml:"), "{bad}: {}", call.err);
    }
}

#[test]
fn rates_near_the_smallest_number_only_take_longer_and_below_it_nothing_wears() {
    let bench = Bench::new();
    let wear = |friction: f64| {
        let sets = "--set contact.shear=false --set mesh.degree=4 --set output.report=false";
        let call = bench.call(&format!("run punch-wear {sets} --set contact.friction={friction:e} -q"));
        // A run without an answer stands beside the good one.
        (call.code, bench.summary(if call.code == 1 { "punch-wear.failed" } else { "punch-wear" }))
    };
    let (of, times): (Vec<_>, Vec<_>) =
        [0.25, 1e-100].map(wear).map(|(_, s)| (s["wear"]["depth_um"].as_f64(), s["wear"]["time_s"].as_f64())).into_iter().unzip();
    // w' ~ mu^2 with b = 2.
    assert_relative_eq!(times[1].unwrap() / times[0].unwrap(), 0.25e100 * 0.25e100, max_relative = 1e-4);
    assert_relative_eq!(of[1].unwrap(), of[0].unwrap(), max_relative = 1e-4);
    let (code, summary) = wear(1e-300);
    assert_eq!((code, summary["status"].as_str()), (1, Some("refused")));
    assert!(summary["verdict"].as_str().unwrap().contains("nothing wears in a finite time"), "{}", summary["verdict"]);
}
