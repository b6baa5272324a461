//! `wearshape study`: error against run time.

use crate::call::{Bench, files};

#[test]
fn a_study_shows_the_error_fall_and_its_estimate_follow() {
    let bench = Bench::new();
    let call = bench.call_with(&["study", "drum-brake-block", "--set", "optimum.functional=uniform", "-o", "out"]);
    assert_eq!(call.code, 0, "{}", call.err);
    let table = bench.read("out/study.csv");
    let rows: Vec<Vec<f64>> = table.lines().skip(1).map(|line| line.split(',').map(|v| v.parse().unwrap()).collect()).collect();
    assert!(table.starts_with("degree,layers,dofs,trace_dofs,seconds_mesh,seconds_assemble,seconds_factor,seconds_interface,"));
    assert_eq!(rows.len(), 7);
    // All but the finest level have a true error; from the third on there is an estimate within a factor 10 of it.
    for pair in rows[..6].windows(2) {
        assert!(pair[1][11] < 0.2 * pair[0][11], "{:?}", pair);
    }
    for row in &rows[2..6] {
        assert!(row[10] < 10.0 * row[11] && row[11] < 10.0 * row[10], "{row:?}");
    }
    assert!(bench.read("out/study.svg").contains("<svg"));
}

fn json(bench: &Bench, file: &str) -> serde_json::Value {
    serde_json::from_str(&bench.read(file)).unwrap()
}

fn study(bench: &Bench, folder: &str) -> serde_json::Value {
    json(bench, &format!("{folder}/study.json"))
}

fn summary(bench: &Bench, folder: &str) -> serde_json::Value {
    json(bench, &format!("{folder}/summary.json"))
}

/// The columns error_estimate and error_true of a study's table.
fn errors(bench: &Bench) -> Vec<[f64; 2]> {
    let row = |line: &str| {
        let numbers: Vec<f64> = line.split(',').map(|v| v.parse().unwrap()).collect();
        [numbers[10], numbers[11]]
    };
    bench.read("out/study.csv").lines().skip(1).map(row).collect()
}

#[test]
fn contacts_and_runs_in_time_can_be_studied() {
    for settings in [["punch-wear", "wear.b=1"], ["hertz-cylinder", "load.force=350"]] {
        let bench = Bench::new();
        let call = bench.call_with(&["study", settings[0], "--set", settings[1], "-o", "out"]);
        assert_eq!(call.code, 0, "{}", call.err);
        let errors = errors(&bench);
        assert!(errors[5][1] < 1e-3 * errors[1][1], "{errors:?}");
        assert!(errors[2..6].iter().all(|[estimate, truth]| *estimate < 10.0 * truth && *truth < 10.0 * estimate), "{errors:?}");
    }
}

#[test]
fn a_study_against_a_finished_run_measures_every_degree_at_its_points() {
    let bench = Bench::new();
    assert_eq!(bench.call_with(&["run", "drum-brake-block", "--set", "mesh.degree=16", "-o", "ref"]).code, 0);
    let call = bench.call_with(&["study", "drum-brake-block", "--reference", "ref", "-o", "out"]);
    assert_eq!(call.code, 0, "{}", call.err);
    let errors = errors(&bench);
    // The finest level has the discretisation of the run, and is nearer to it than its own error: what it is off by is not known.
    assert!(errors[6][1].is_nan() && errors[5][1] > 1e-10 && errors[5][1] < 1e-7, "{errors:?}");
    let study = study(&bench, "out");
    let own = summary(&bench, "ref")["error"]["gap_relative"].clone();
    assert_eq!((&study["truth_error"], &study["levels"][6]["within_truth_error"]), (&own, &true.into()));
    assert_eq!((&study["levels"][6]["error_true"], &study["levels"][5]["within_truth_error"]), (&().into(), &().into()));
    assert!(study["verdict"].as_str().unwrap().contains("1 of them are as near to it ("), "{}", study["verdict"]);
    assert!(call.out.contains(&format!("<{:.0e}", 3.0 * own.as_f64().unwrap())), "{}", call.out);
    // A coarse truth says nothing of finer levels.
    assert_eq!(bench.call_with(&["run", "drum-brake-block", "--set", "accuracy=1e-3", "-q", "-o", "coarse"]).code, 0);
    let call = bench.call_with(&["study", "drum-brake-block", "--reference", "coarse", "-q", "-o", "x"]);
    assert_eq!(call.code, 0, "{}", call.err);
    let levels = self::study(&bench, "x")["levels"].clone();
    assert!((3..7).all(|level| levels[level]["error_true"].is_null()), "{levels}");
    let call = bench.call_with(&["study", "drum-brake-block", "--reference", "nowhere", "-o", "out"]);
    assert_eq!(call.code, 2);
    assert!(call.err.contains("--reference nowhere"), "{}", call.err);
}

#[test]
fn a_study_against_results_of_another_scene_is_refused_by_the_key() {
    let bench = Bench::new();
    let coarse = "--set mesh.degree=4 --set mesh.layers=3 -q";
    assert_eq!(bench.call(&format!("run hertz-cylinder {coarse} -o hertz")).code, 0);
    assert_eq!(bench.call(&format!("run drum-brake-block {coarse} -o drum")).code, 0);
    for (settings, reference, key) in [
        ("", "hertz", "tasks is"),
        ("--set contact.friction=0.2", "drum", "contact.friction is 0.25 there and 0.2 here"),
        ("--set tasks=[contact]", "drum", "tasks is"),
    ] {
        let call = bench.call(&format!("study drum-brake-block {settings} --reference {reference} -q -o x"));
        assert_eq!(call.code, 2, "{settings}: {}", call.err);
        assert!(call.err.contains("results of another scene") && call.err.contains(key), "{settings}: {}", call.err);
        assert!(call.err.contains(&format!("--> --reference {reference}")) && !bench.path("x").exists(), "{}", call.err);
    }
    // How finely it was computed is free.
    let call = bench.call("study drum-brake-block --set accuracy=1e-4 --set title=other --reference drum -q -o x");
    assert_eq!(call.code, 0, "{}", call.err);
}

#[test]
fn a_study_of_a_scene_without_a_shape_says_what_to_ask_for() {
    let bench = Bench::new();
    let call = bench.call_with(&["study", "disc-pad", "-o", "out"]);
    assert_eq!(call.code, 2);
    // A surface alone has no shape whatever its tasks are.
    assert!(call.err.contains("remedy: give body1 and body2") && !call.err.contains("--set"), "{}", call.err);
    let call = bench.call("study annular-punch --set tasks=[pressure] -o out");
    assert!(call.code == 2 && call.err.contains("--set tasks=[pressure,shape]"), "{}", call.err);
}

#[test]
fn a_study_does_not_take_the_place_of_its_reference() {
    let bench = Bench::new();
    let run = bench.call("run drum-brake-block --set mesh={degree=4,layers=3} -q -o truth");
    assert_eq!(run.code, 0, "{}", run.err);
    let before = files(&bench.path("truth"));
    for (folder, options) in [("truth", ""), ("x/../truth/", ""), ("./truth", "--dry-run")] {
        std::fs::create_dir_all(bench.path("x")).unwrap();
        let call = bench.call(&format!("study drum-brake-block --reference truth -o {folder} {options}"));
        assert_eq!(call.code, 2, "{folder}: {}{}", call.out, call.err);
        assert!(call.err.contains("is the folder of --reference") && call.err.contains("--> -o "), "{}", call.err);
        assert!(call.err.contains("remedy: give another folder: -o DIR"), "{}", call.err);
        assert!(files(&bench.path("truth")) == before && !bench.path("truth.partial").exists(), "{folder}");
    }
}

#[test]
fn a_study_of_a_scene_without_an_answer_ends_like_a_run_of_it() {
    let bench = Bench::new();
    let bushing = ["bushing", "--set", "contact.friction=20"];
    let soft = ["body1.material={young=\"600 GPa\",poisson=0}", "body2.material={young=\"50 MPa\",poisson=0.3}"];
    let cam = ["cam", "--set", soft[0], "--set", soft[1]];
    for scene in [&bushing[..], &cam] {
        let [run, call] = ["run", "study"].map(|command| bench.call_with(&[&[command], scene, &["-o", "x"]].concat()));
        assert_eq!((run.code, call.code), (1, 1), "{}{}", call.out, call.err);
        assert!(!call.err.contains("-->") && call.out.contains("at degree 16: "), "{}{}", call.out, call.err);
        let summary = summary(&bench, "x");
        assert_eq!((&summary["status"], &summary["levels"]), (&"refused".into(), &serde_json::json!([])));
    }
    // It leaves a good study alone, and with --json is one document.
    let good = "study bushing --json -o y";
    let call = bench.call(good);
    assert!(call.code == 0 && summary(&bench, "y")["status"] == "ok", "{}{}", call.out, call.err);
    let call = bench.call_with(&[&["study", "--json", "-o", "y"], &bushing[..]].concat());
    let said: serde_json::Value = serde_json::from_str(&call.out).unwrap();
    assert_eq!((call.code, &said["status"]), (1, &"refused".into()));
    assert!(summary(&bench, "y")["status"] == "ok" && summary(&bench, "y.failed") == said);
}

#[test]
fn a_study_says_what_it_does_not_use() {
    let bench = Bench::new();
    let fixed = include_str!("../../../../data/scenes/drum-brake-block.toml").replace("accuracy = 1e-6 ", "mesh.degree = 8 ");
    bench.file("fixed.toml", &fixed);
    let call = bench.call("study fixed.toml --sample=11 --resume -o x");
    assert_eq!(call.code, 0, "{}", call.err);
    for words in ["mesh.degree = 8 is not used", "the degrees 4 to 16", "--sample is not used", "--resume is not used"] {
        assert!(call.err.contains(words), "{}", call.err);
    }
    let plain = bench.call("study drum-brake-block -o y");
    assert!(plain.code == 0 && !plain.err.contains("is not used"), "{}", plain.err);
    let errors = |folder: &str| {
        study(&bench, folder)["levels"].as_array().unwrap().iter().map(|level| level["error_true"].clone()).collect::<Vec<_>>()
    };
    assert_eq!(errors("x"), errors("y"));
}

#[test]
fn the_documents_of_a_study_are_whole() {
    let bench = Bench::new();
    let call = bench.call("study drum-brake-block --dry-run --json -o x");
    let said: serde_json::Value = serde_json::from_str(&call.out).unwrap();
    assert_eq!(said["degrees"], serde_json::json!([4, 6, 8, 10, 12, 14, 16]));
    assert_eq!((&said["scene"], &said["folder"]), (&"drum-brake-block".into(), &"x".into()));
    let call = bench.call("study drum-brake-block --set mesh.layers=2 --json -o x");
    assert_eq!(call.code, 0, "{}", call.err);
    let level = &study(&bench, "x")["levels"][0];
    assert_eq!((&level["degree"], &level["layers"]), (&4.into(), &2.into()));
    assert!(level["dofs"].is_u64() && level["trace_dofs"].is_u64(), "{level}");
    assert!(!call.out.contains("-0.0"), "{}", call.out);
}
