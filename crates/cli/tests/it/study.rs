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

#[test]
fn a_study_of_a_scene_without_a_shape_says_what_to_ask_for() {
    let bench = Bench::new();
    let call = bench.call_with(&["study", "disc-pad", "-o", "out"]);
    assert_eq!(call.code, 2);
    assert!(call.err.contains("tasks=[pressure,shape]"), "{}", call.err);
}
