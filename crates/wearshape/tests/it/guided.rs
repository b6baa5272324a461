//! A punch that a guide at its side holds along x, and so elastically against tilting: its shape carries the moment of the load.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Options, Problem, ShapeResult, Status, solve};

fn shape(settings: &[&str]) -> ShapeResult {
    let text = scene::builtin("translating-punch").unwrap().text;
    let settings: Vec<String> = ["body1.support={left=[\"x\"]}"].iter().chain(settings).map(|s| s.to_string()).collect();
    let problem = Problem::new(&Document::read("guided", text, &settings).unwrap(), &|_| Err("no file".into())).unwrap();
    let solution = solve(&problem, &Options::default(), &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap();
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    solution.shape.unwrap()
}

#[test]
fn the_moment_on_a_guided_punch_is_in_its_shape_and_the_proof_gives_the_pressure_back() {
    let mut gaps = Vec::new();
    for settings in
        [&[][..], &["load.moment=50000"], &["load.moment=-50000"], &["load.tilt=0"], &["load.tilt=1e-5"], &["load.approach=0.01"]]
    {
        let shape = shape(settings);
        assert!(shape.roundtrip_same.unwrap() < 1e-8, "{settings:?}: {:?}", shape.roundtrip_same);
        assert!(shape.roundtrip_independent.unwrap() < 1e-4, "{settings:?}: {:?}", shape.roundtrip_independent);
        gaps.push(shape.gap_max.unwrap());
    }
    // What the moment bends is seen in the gap, and differs from the tilt held at zero.
    assert!((gaps[1] / gaps[0] - 1.0).abs() > 0.2 && (gaps[1] / gaps[2] - 1.0).abs() > 0.02, "{gaps:?}");
    assert!((gaps[3] / gaps[0] - 1.0).abs() > 1e-3, "{gaps:?}");
}
