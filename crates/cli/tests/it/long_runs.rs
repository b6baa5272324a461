//! Runs that once took minutes: they end soon, and what they leave undone is said.

use crate::call::Bench;

/// A block on a plate as wide as it, without lateral contraction: the pressure is uniform.
const WORN_FREE: &str = r#"
title = "A block held at its approach"
units = "N-mm"
kinematics = "plane-strain"
thickness = 1
tasks = ["wear"]
body1.material = { young = 210000, poisson = 0 }
body1.geometry.rectangle = { x = [-30, 30], z = [100, 200] }
body1.support = { top = ["x"] }
body2.material = { young = 210000, poisson = 0 }
body2.geometry.rectangle = { x = [-30, 30], z = [0, 100] }
body2.support = { bottom = ["x", "z"] }
contact = { edges = ["bottom", "top"], friction = 0, gap = 0 }
sliding = { speed = 5 }
load = { edge = "top", as = "rigid", approach = 0.01, tilt = 0 }
wear = { k = [1e-6, 0], a = 1, b = 0.5, until = 3000 }
"#;

/// Under a prescribed approach `p' = -(c k v) p^b` with `c = p0 / approach`. With b = 1/2 the contact is worn free at `p0^(1/2) / (c k v / 2)`.
#[test]
fn a_contact_that_has_worn_itself_free_takes_few_steps_to_the_end_time() {
    let bench = Bench::new();
    bench.file("free.toml", WORN_FREE);
    let call = bench.call("run free.toml -q");
    assert_eq!(call.code, 0, "{}", call.err);
    let wear = &bench.summary("free")["wear"];
    assert_eq!((wear["status"].as_str(), wear["time_s"].as_f64()), (Some("time-reached"), Some(3000.0)));
    assert!(wear["steps"].as_u64().unwrap() < 200, "{wear}");
    assert!((wear["depth_um"].as_f64().unwrap() - 10.0).abs() < 1e-5, "what was closed is worn away: {wear}");
    assert!(wear["to_1_percent"].is_null(), "no steady pressure is left to come near to");
    // Until half of the closing is worn off: p = p0 / 2 after (1 - 2^(-1/2)) of the time to the end.
    let (pressure, approach): (f64, f64) = (10.5, 0.01);
    let free = 2.0 * approach / (1e-6 * 5.0 * pressure.sqrt());
    let half = (1.0 - 0.5_f64.sqrt()) * free;
    let call = bench.call(&format!("run free.toml -q --set wear.until={half} -o out/half"));
    assert_eq!(call.code, 0, "{}", call.err);
    let wear = &bench.summary("half")["wear"];
    let depth = wear["depth_um"].as_f64().unwrap();
    let error = wear["run_in_error"].as_f64().unwrap();
    assert!((depth / 5.0 - 1.0).abs() < 1e-6 && error < 1e-6, "depth {depth} um, said to be accurate to {error:e}");
}

#[test]
fn the_time_of_a_run_in_is_as_accurate_as_asked_for_and_printed_with_its_error() {
    let bench = Bench::new();
    let call = bench.call("run punch-wear");
    assert_eq!(call.code, 0, "{}", call.err);
    let wear = &bench.summary("punch-wear")["wear"];
    let error = wear["run_in_error"].as_f64().unwrap();
    assert!(error > 0.0 && error <= 1e-6, "{error:e}");
    assert!(call.out.contains("after 2.369 +- ") && call.out.contains("e-6 s"), "{}", call.out);
    assert!(bench.read("out/punch-wear/report.html").contains("error of that time"));
}

/// The gap is told as accurate to 2.1e-8, the time to 9.2e-9.
#[test]
fn a_time_less_accurate_than_asked_for_is_said() {
    let bench = Bench::new();
    let call = bench.call("run trapezoidal-punch -q --set tasks=[wear] --set accuracy=1e-9");
    let summary = bench.summary("trapezoidal-punch");
    let error = summary["wear"]["run_in_error"].as_f64().unwrap();
    assert_eq!((call.code, error > 1e-9), (1, true), "{error:e}: {}", summary["verdict"]);
    let notes = summary["lints"].as_array().unwrap();
    let note = notes.iter().find(|note| note["code"] == "time-less-accurate").unwrap()["message"].as_str().unwrap();
    assert!(note.contains("time to 1 % of the steady pressure is accurate to"), "{note}");
}

const ROUGH: &str = r#"
title = "A rigidly guided block on a rough surface"
units = "N-mm"
kinematics = "plane-strain"
thickness = 1
tasks = ["contact"]
body1.material = { young = 210000, poisson = 0.3 }
body1.geometry.rectangle = { x = [-30, 30], z = [100, 200] }
body1.support = { top = ["x"] }
body2.material = { young = 210000, poisson = 0.3 }
body2.geometry.rectangle = { x = [-60, 60], z = [0, 100] }
body2.support = { bottom = ["x", "z"] }
sliding = { speed = 5 }
load = { edge = "top", as = "rigid", force = 1000, moment = 0, about = [0, 100] }
[contact]
edges = ["bottom", "top"]
friction = 0
"#;
/// Heights at 41 places from -30 to 30 mm.
const HEIGHTS: [f64; 41] = [
    3.1848, 1.3489, 0.2049, 0.0826, 4.0664, 4.5638, 3.0332, 3.6475, 2.7181, 4.6754, 4.0793, 0.0137, 4.2870, 0.1679, 3.6483,
    0.8783, 4.3159, 2.7073, 1.4986, 2.1134, 0.1416, 0.6214, 3.3531, 3.2359, 3.0769, 1.9184, 4.9860, 4.9042, 3.4277, 3.2523,
    3.4422, 1.9446, 0.6755, 3.6074, 2.6268, 1.5512, 2.4292, 4.4474, 4.6702, 1.7890, 2.8576,
];

#[test]
fn a_rough_gap_with_many_ends_of_contact_takes_few_meshes_and_says_what_it_misses() {
    let bench = Bench::new();
    let places: Vec<f64> = (0..41).map(|i| 1.5 * f64::from(i) - 30.0).collect();
    bench.file("rough.toml", &format!("{ROUGH}gap = {{ s_mm = {places:?}, gap_um = {HEIGHTS:?} }}\n"));
    let call = bench.call("run rough.toml -q");
    let summary = bench.summary("rough");
    let solves = summary["counters"]["contact_solves"].as_u64().unwrap();
    // Some ten on each of five levels, each on a mesh of its own; it was thousands on meshes that grew without end.
    assert!(solves <= 60, "{solves} contact solves");
    assert_eq!(call.code, 1, "{}", call.err);
    assert_eq!(summary["status"], "accuracy-missed", "{summary}");
    assert!(summary["error"]["how"].as_str().unwrap().contains("ends of contact"), "{}", summary["error"]);
}
