//! `wearshape study`: error against run time.

use crate::call::Bench;

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
    // The finest level has the discretisation of the run: what is left is the order of the sums.
    assert!(errors[6][1] < 1e-12 && errors[5][1] > 1e-10 && errors[5][1] < 1e-7, "{errors:?}");
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
    assert!(call.err.contains("tasks=[pressure,shape]"), "{}", call.err);
}
