//! Gaps by formula, by smooth profiles, and what is refused.

use serde_json::Value;

use crate::call::Bench;

/// A punch on a plate under a small load, so that the gap stays as it is.
fn scene(contact: &str) -> String {
    format!(
        r#"units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["contact"]
accuracy = 1e-3
contact = {{ edges = ["bottom", "top"], {contact} }}
load = {{ edge = "top", as = "rigid", force = "2 kN", tilt = 0 }}
body1.material = {{ young = "210 GPa", poisson = 0.3 }}
body1.geometry.rectangle = {{ x = [-20, 20], z = [0, 30] }}
body1.support = {{ top = ["x"] }}
body2.material = {{ young = "210 GPa", poisson = 0.3 }}
body2.geometry.rectangle = {{ x = [-40, 40], z = [-40, 0] }}
body2.support = {{ bottom = ["x", "z"] }}
"#
    )
}

/// The columns s_mm and gap_um of contact.csv of a run.
fn gaps(bench: &Bench, contact: &str) -> (Vec<[f64; 2]>, Value) {
    bench.file("punch.toml", &scene(contact));
    let call = bench.call("run punch.toml -q -o punch");
    assert_eq!(call.code, 0, "{contact}: {}{}", call.out, call.err);
    let table = bench.read("punch/contact.csv");
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let column = |name: &str| names.iter().position(|known| *known == name).unwrap();
    let (s, gap) = (column("s_mm"), column("gap_um"));
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        [fields[s].parse().unwrap(), fields[gap].parse().unwrap()]
    };
    (table.lines().skip(1).map(row).collect(), serde_json::from_str(&bench.read("punch/summary.json")).unwrap())
}

/// Waves as short as roughness are no shape that cells could follow.
#[test]
fn waves_that_no_cells_follow_are_refused() {
    let bench = Bench::new();
    bench.file("punch.toml", &scene(r#"gap = { cosine = { amplitude = "1 um", wavelength = "0.9 mm" } }"#));
    let call = bench.check_and_run("punch.toml");
    assert_eq!(call.code, 2, "{}", call.out);
    assert!(call.err.contains("44 waves on a surface of 40 mm") && call.err.contains("contact.roughness"), "{}", call.err);
}

/// So many ends of contact that nodes on all of them leave no room for finer levels: cells as long as the waves serve, and the error is told.
#[test]
fn a_contact_of_too_many_ends_says_its_error_and_why_it_is_large() {
    let bench = Bench::new();
    bench.file("punch.toml", &scene(r#"gap = { cosine = { amplitude = "1 um", wavelength = "2.5 mm" } }"#));
    let call = bench.call("run punch.toml -o punch");
    assert_eq!(call.code, 1, "{}{}", call.out, call.err);
    let said = call.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("accurate to") && said.contains("it has 32 ends of contact inside the surface"), "{said}");
    let summary: Value = serde_json::from_str(&bench.read("punch/summary.json")).unwrap();
    assert!(summary["error"]["pressure_relative"].as_f64().unwrap() > 1e-3);
}

#[test]
fn a_sum_of_formulas_is_the_gap_of_the_contact_and_its_resolved_scene_gives_it_again() {
    let bench = Bench::new();
    let given = r#"gap = { crown = "10 um", tilt = "0.1 mrad", cosine = { amplitude = "1 um", wavelength = "20 mm" } }"#;
    let (rows, _) = gaps(&bench, given);
    for [s, gap] in &rows {
        let wave = 1.0 - (std::f64::consts::TAU * s / 20.0).cos();
        let expected = 10.0 * (s / 20.0).powi(2) + 1e3 * 1e-4_f64.tan() * (s + 20.0) + wave;
        assert!((gap - expected).abs() < 1e-10, "{s}: {gap} {expected}");
    }
    let first = bench.read("punch/contact.csv");
    std::fs::copy(bench.path("punch/scene.resolved.toml"), bench.path("again.toml")).unwrap();
    assert_eq!(bench.call("run again.toml -q -o again").code, 0);
    assert_eq!(bench.read("again/contact.csv"), first);
}

#[test]
fn rows_of_a_parabola_give_the_contact_of_the_crown_and_smoothing_says_what_it_left() {
    let bench = Bench::new();
    let (_, crown) = gaps(&bench, r#"gap = { crown = "10 um" }"#);
    let rows: String = (0..=40).map(|i| i - 20).map(|s| format!("{s},{}\n", 0.025 * f64::from(s * s))).collect();
    bench.file("gap.csv", &format!("s_mm,gap_um\n{rows}"));
    let (_, same) = gaps(&bench, r#"gap = "gap.csv""#);
    let p_max = |summary: &Value| summary["contact"]["p_max_MPa"].as_f64().unwrap();
    assert!((p_max(&same) / p_max(&crown) - 1.0).abs() < 1e-10, "{} {}", p_max(&same), p_max(&crown));
    let rough: String = (0..=40)
        .map(|i| i - 20)
        .map(|s| format!("{s},{}\n", 0.025 * f64::from(s * s) + 0.5 * f64::from((s * s * 7) % 3)))
        .collect();
    bench.file("rough.csv", &format!("s_mm,gap_um\n{rough}"));
    let (_, smooth) = gaps(&bench, r#"gap = { profile = "rough.csv", smooth = "0.5 um" }"#);
    let note = smooth["lints"].as_array().unwrap().iter().find(|note| note["code"] == "smoothed-gap").unwrap();
    assert!(note["message"].as_str().unwrap().contains("0.5 um from them"), "{note}");
    assert!((p_max(&smooth) / p_max(&crown) - 1.0).abs() < 0.1);
}

/// Sixty-one rows with the noise of a gauge, taken as they are: contact on single rows, which is found in cells of their own, in a time that is bounded. The
/// note gives the deviation to smooth them by, and smoothed by that they are the crown they were measured on.
#[test]
fn noise_of_measured_rows_is_told_and_its_contact_comes_to_an_end() {
    let bench = Bench::new();
    let (_, crown) = gaps(&bench, r#"gap = { crown = "10 um" }"#);
    let mut state = 12345_u64;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1u64 << 31) as f64 - 0.5
    };
    let row = |s: f64, noise: f64| format!("{s},{}\n", 0.3 + 0.025 * s * s + 0.6 * noise);
    let rows: String = (0..=60).map(|i| f64::from(i - 30) / 1.5).map(|s| row(s, noise())).collect();
    bench.file("noisy.csv", &format!("s_mm,gap_um\n{rows}"));
    bench.file("noisy.toml", &scene(r#"gap = "noisy.csv""#));
    let call = bench.call("run noisy.toml -q -o noisy");
    let summary: Value = serde_json::from_str(&bench.read("noisy/summary.json")).unwrap();
    assert_eq!(call.code, 0, "{}", call.err);
    assert_eq!(summary["status"], "ok", "{summary}");
    assert!(summary["error"]["pressure_relative"].as_f64().unwrap() < 1e-3, "{summary}");
    assert!(summary["counters"]["contact_solves"].as_u64().unwrap() < 80, "{summary}");
    let message =
        summary["lints"].as_array().unwrap().iter().find(|note| note["code"] == "noisy-gap").unwrap()["message"].clone();
    // The deviation of .6 times an even distribution is .6/sqrt(12) = .17.
    let smooth = message.as_str().unwrap().split("smooth = \"").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
    let smooth: f64 = smooth.parse().unwrap();
    assert!((smooth / 0.17 - 1.0).abs() < 0.2, "{message}");
    let (_, smooth) = gaps(&bench, &format!("gap = {{ profile = \"noisy.csv\", smooth = \"{smooth} um\" }}"));
    let p_max = |summary: &Value| summary["contact"]["p_max_MPa"].as_f64().unwrap();
    assert!((p_max(&smooth) / p_max(&crown) - 1.0).abs() < 0.1, "{} {}", p_max(&smooth), p_max(&crown));
}

/// A punch that is free to tilt turns until its gap leans no more: it touches as without the lean, on few points of a coarse mesh or on one, whose moment
/// is round-off.
#[test]
fn a_lean_that_a_free_tilt_takes_back_changes_nothing_of_the_contact() {
    let bench = Bench::new();
    let p_max = |gap: &str, force: &str| {
        let args =
            ["run", "translating-punch", "-q", "--force", "-o", "out", "--set", "tasks=[contact]", "--set", "accuracy=1e-4"];
        let set = [format!("contact.gap={gap}"), format!("load.force={force}")];
        let call = bench.call_with(&args.into_iter().chain(["--set", &set[0], "--set", &set[1]]).collect::<Vec<_>>());
        assert_eq!(call.code, 0, "{gap}: {}{}", call.out, call.err);
        let summary: Value = serde_json::from_str(&bench.read("out/summary.json")).unwrap();
        summary["contact"]["p_max_MPa"].as_f64().unwrap()
    };
    for (crown, tilt, force) in [("50 um", "0.03 mrad", "1 kN"), ("10 um", "0.05 mrad", "200 N")] {
        let level = p_max(&format!("{{crown=\"{crown}\"}}"), force);
        let leaning = p_max(&format!("{{crown=\"{crown}\",tilt=\"{tilt}\"}}"), force);
        assert!((leaning / level - 1.0).abs() < 1e-4, "{crown} {tilt}: {leaning} {level}");
    }
    p_max(r#"{crown="10 um",tilt="0.1 mrad",cosine={amplitude="1 um",wavelength="20 mm"}}"#, "1 kN");
}

/// Waves inside the bush, whose cells are small and far from all corners: levels with few degrees there would agree with each other and not with the gap.
#[test]
fn the_error_told_of_a_wavy_bush_is_no_smaller_than_what_another_degree_finds() {
    let bench = Bench::new();
    let found = |more: &[&str]| {
        let gap = "contact.gap={cosine={amplitude=\"0.3 um\",wavelength=\"2 mm\"}}";
        let args = ["run", "bushing", "-q", "--force", "-o", "out", "--set", "accuracy=1e-2", "--set", gap];
        bench.call_with(&[&args[..], more].concat());
        let summary: Value = serde_json::from_str(&bench.read("out/summary.json")).unwrap();
        let number = |value: &Value| value.as_f64().unwrap();
        [number(&summary["contact"]["p_max_MPa"]), number(&summary["error"]["pressure_relative"])]
    };
    let [p, error] = found(&[]);
    let [finer, _] = found(&["--set", "mesh.degree=14"]);
    assert!((p / finer - 1.0).abs() < error, "{p} {finer} {error}");
}

/// The waves of a gap are followed where they are shorter than the cells of the bodies alone, and where bodies touch on their tops alone.
#[test]
fn a_wavy_surface_touches_in_zones_that_are_found_to_the_accuracy_asked_for() {
    let bench = Bench::new();
    let touched = |scene: &str, amplitude: &str, accuracy: &str| {
        let set = format!(
            "--set tasks=[contact] --set accuracy={accuracy} --set contact.gap.cosine={{amplitude={amplitude},wavelength=20}}"
        );
        let call = bench.call(&format!("run {scene} {set} -q -o wavy"));
        assert_eq!(call.code, 0, "{scene} {amplitude}: {}{}", call.out, call.err);
        let summary: Value = serde_json::from_str(&bench.read("wavy/summary.json")).unwrap();
        let ends = summary["contact"]["ends_mm"].as_array().unwrap();
        ends.iter().map(|end| end.as_f64().unwrap()).collect::<Vec<f64>>()
    };
    assert_eq!(touched("drum-brake-block", "1e-4", "1e-4").len(), 2);
    // Two ends next to an end of the surface, two next to each other.
    assert_eq!(touched("drum-brake-ring", "1e-3", "1e-2").len(), 6);
    let [rough, fine] = ["1e-3", "1e-4"].map(|accuracy| touched("reciprocating-pad", "5e-3", accuracy));
    assert_eq!(fine.len(), 6);
    for (rough, fine) in rough.iter().zip(&fine) {
        assert!((rough - fine).abs() < 1e-3 * 40.0, "{rough} {fine}");
    }
}

#[test]
fn gaps_without_sense_are_refused_with_a_remedy() {
    let bench = Bench::new();
    bench.file("short.csv", "s_mm,gap_um\n-20,1\n-10,0\n10,1\n");
    for (contact, says) in [
        ("gap = {}", "empty table"),
        ("gap = { crown = \"-1 um\" }", "is negative"),
        ("gap = { tilt = \"20 deg\" }", "no small angle"),
        ("gap = { cosine = { amplitude = \"1 um\", wavelength = 0 } }", "zero wavelength"),
        ("gap = { cosine = { amplitude = \"-1 um\", wavelength = 3 } }", "is negative"),
        ("gap = { cosine = { amplitude = \"1 um\" } }", "wavelength"),
        ("gap = { crow = 3 }", "crow"),
        ("gap = { crown = 0.01, s_mm = [0, 1], gap_um = [0, 1] }", "profile ="),
        ("gap = { smooth = \"2 um\" }", "there is none"),
        ("gap = { profile = \"short.csv\", smooth = \"-2 um\" }", "negative residual"),
        ("gap = { profile = \"short.csv\", crown = \"1 um\" }", "covers 30 mm of the contact surface of 40 mm"),
        ("gap = { profile = \"none.csv\" }", "cannot read the gap profile none.csv"),
        ("clearance = \"50 um\"", "is no arc"),
    ] {
        bench.file("bad.toml", &scene(contact));
        let call = bench.check_and_run("bad.toml");
        assert_eq!(call.code, 2, "{contact}: {}{}", call.out, call.err);
        assert!(call.err.contains(says), "{contact}: {}", call.err);
    }
    for (set, says) in [
        ("contact.clearance=-1_um", "interference"),
        ("contact.clearance=30", "no clearance of a radius"),
        ("body2.geometry.ring.outer=26", "the arcs cross"),
        ("body2.geometry.ring.outer=24", "drawn with two radii"),
        ("body2.geometry.ring.centre=[1,0]", "do not touch"),
    ] {
        let call = bench.check_and_run(&format!("bushing --set {}", set.replace('_', "")));
        assert_eq!(call.code, 2, "{set}: {}{}", call.out, call.err);
        assert!(call.err.contains(says), "{set}: {}", call.err);
    }
    for (set, says) in
        [("body2.geometry.ring.centre=[1,0]", "cross or lie apart"), ("body2.geometry.ring.centre=[0,3]", "cross or lie apart")]
    {
        let call = bench.check_and_run(&format!("knee --set {set}"));
        assert_eq!(call.code, 2, "{set}: {}{}", call.out, call.err);
        assert!(call.err.contains(says), "{set}: {}", call.err);
    }
    let round = bench.check_and_run("hertz-cylinder --set contact.gap={crown=0.01}");
    assert!(round.code == 2 && round.err.contains("counted from the ends"), "{}", round.err);
}

/// On the first levels such a punch touches in one point, which holds no tilt: that is a contact all the same. Between half-planes a crown of 20 um over 60 mm
/// has the radius 22.5 m, and Hertz the largest pressure 12.19 MPa.
#[test]
fn a_crowned_punch_that_may_tilt_has_an_answer_at_every_degree() {
    let bench = Bench::new();
    for degree in [4, 5, 6, 8, 10] {
        let mesh = format!("mesh.degree={degree}");
        let set =
            ["--set", "tasks=[contact]", "--set", "contact.gap={crown='20 um'}", "--set", &mesh, "--set", "contact.friction=0"];
        let call = bench.call_with(&[&["run", "translating-punch", "-q", "-o", "x"][..], &set].concat());
        assert_eq!(call.code, 0, "{degree}: {} {}", call.out, call.err);
        let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
        let peak = summary["contact"]["p_max_MPa"].as_f64().unwrap();
        // The coarsest mesh has cells longer than the contact.
        let within = if degree < 8 { 0.25 } else { 0.03 };
        assert!((peak / 12.19 - 1.0).abs() < within, "{degree}: {peak}");
    }
}
