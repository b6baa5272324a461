//! Two wearing bodies under every kind of counter-face, from scene to summary.

use approx::assert_relative_eq;

use crate::call::Bench;

/// Runs a scene with body 2 wearing half as fast as body 1, and returns `summary.wear` with the worn volumes of both bodies.
fn worn(bench: &Bench, scene: &str, args: &str) -> (serde_json::Value, [f64; 2]) {
    let fixed = "--set tasks=[wear] --set mesh={degree=4,layers=2} --set wear.beta=[2e-4,1e-4]";
    let call = bench.call(&format!("run {scene} -q {fixed} {args}"));
    assert_eq!(call.code, 0, "{scene} {args}: {}", call.err);
    let table = bench.read(&format!("out/{scene}/history.csv"));
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let last: Vec<f64> = table.lines().last().unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    let volume = |name: &str| last[names.iter().position(|other| *other == name).unwrap()];
    (bench.summary(scene)["wear"].clone(), [volume("volume1_mm3"), volume("volume2_mm3")])
}

#[test]
fn a_congruent_counterface_adds_its_wear_and_a_fresh_one_does_not() {
    let bench = Bench::new();
    let (fresh, volumes) = worn(&bench, "punch-wear", "--set wear.counterface=fresh");
    assert_relative_eq!(volumes[1], 0.5 * volumes[0], max_relative = 1e-12);
    let (congruent, _) = worn(&bench, "punch-wear", "--set wear.counterface=congruent");
    // Both surfaces wear by the same rule: 1.5 times the rate is the same run in 1 / 1.5 of the time.
    for key in ["time_s", "distance_mm", "depth_um"] {
        let near = |wear: &serde_json::Value| wear["to_1_percent"][key].as_f64().unwrap();
        assert_relative_eq!(near(&fresh), 1.5 * near(&congruent), max_relative = 1e-6);
    }
    assert!(fresh["steady"] == true && congruent["steady"] == true);
    assert!(fresh["run_in_distance_mm"].as_array().unwrap().len() > 1 && fresh["explicit_step_limit_s"].as_f64().unwrap() > 0.0);
    assert!(fresh["lyapunov_increase"].is_null(), "with shear on the bodies there is no Lyapunov function");
    let (frictionless, _) = worn(&bench, "punch-wear", "--set contact.shear=false");
    assert!(frictionless["lyapunov_increase"].as_f64().unwrap() <= 1e-12, "{frictionless}");
}

#[test]
fn a_revolving_counterface_needs_a_closed_track() {
    let bench = Bench::new();
    let (drum, volumes) = worn(&bench, "drum-brake-block", "--set wear.counterface=revolving");
    assert!(drum["steady"] == true);
    assert_relative_eq!(volumes[1], 0.5 * volumes[0], max_relative = 1e-12);
    for scene in ["annular-punch", "punch-wear"] {
        let call = bench.call(&format!("check {scene} --set tasks=[wear] --set wear.counterface=revolving"));
        assert_eq!(call.code, 2, "{scene}");
        assert!(call.err.contains("closed track") && call.err.contains("congruent"), "{}", call.err);
    }
}

/// Without a track there is no mean of body 2's wear along it, for the pressure as for a run in time.
#[test]
fn a_revolving_counter_face_needs_a_track_for_the_pressure_too() {
    let bench = Bench::new();
    let set = ["--set", "wear={k=[1e-9,1e-9],a=1,b=1}", "--set", "wear.counterface=revolving"];
    let call = bench.call_with(&[&["run", "translating-punch"][..], &set].concat());
    assert_eq!(call.code, 2, "{}", call.out);
    assert!(call.err.contains("closed track") && call.err.contains("remedy: write \"fresh\""), "{}", call.err);
    let call = bench.call_with(&[&["run", "disc-pad", "-q"][..], &set].concat());
    assert_eq!(call.code, 0, "{}", call.err);
}
