//! Seconds are the caller's.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

use wearshape::{Bodies, Options, Solution, Step, solve};

use crate::common::{digits, scene, solved};

#[test]
fn without_a_clock_every_stage_took_no_time() {
    let solution = solved(&scene("annular-punch", &["mesh.degree=4", "tasks=[pressure,contact,shape,wear]", "wear.until=1"]));
    let steps: Vec<Step> = solution.effort.seconds.iter().map(|(step, _)| *step).collect();
    for step in [Step::Pressure, Step::Mesh, Step::Factor, Step::Contact, Step::Shape, Step::RoundTrip, Step::Evolution] {
        assert!(steps.contains(&step), "{step:?} is not among {steps:?}");
    }
    assert!(solution.effort.seconds.iter().all(|(_, seconds)| *seconds == 0.0), "{:?}", solution.effort.seconds);
    assert!(solution.effort.counters.factorisations > 0);
}

/// A clock that goes on by a second whenever it is looked at.
fn ticking() -> f64 {
    static LOOKS: AtomicUsize = AtomicUsize::new(0);
    LOOKS.fetch_add(1, Ordering::Relaxed) as f64
}

#[test]
fn a_clock_changes_seconds_and_nothing_else() {
    let problem = scene("drum-brake-block", &["mesh.degree=4"]);
    let options = Options { clock: ticking, ..Options::default() };
    let timed: Solution = solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap();
    assert!(timed.effort.seconds.iter().all(|(_, seconds)| *seconds >= 1.0), "{:?}", timed.effort.seconds);
    let standing = solved(&problem);
    assert_eq!(timed.effort.counters, standing.effort.counters);
    assert!(digits(&timed) == digits(&standing));
}
