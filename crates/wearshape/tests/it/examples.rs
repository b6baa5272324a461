//! The examples of the crate with their numbers pinned.
#![allow(unreachable_pub)]

#[path = "../../examples/drum.rs"]
mod drum;
#[path = "../../examples/progress_and_stop.rs"]
mod progress_and_stop;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use wearshape::Status;

use crate::common::digits;

/// The steady pressure is p ~ cos^2: 60/11 MPa in the middle, 45/11 MPa at +-30 deg.
#[test]
fn the_drum_has_its_pressure_and_gap() {
    let solution = drum::solved(3).unwrap();
    let profile = solution.profile.unwrap();
    for (found, known) in profile.pressure.iter().zip([45.0 / 11.0, 60.0 / 11.0, 45.0 / 11.0]) {
        assert_relative_eq!(*found, known, max_relative = 1e-12);
    }
    assert!(solution.error.unwrap().gap_relative.unwrap() < 1e-6);
    // The same gap asked for to 1e-9, in um.
    for (found, known) in profile.gap.iter().zip([1.0107682645, 0.1771136839, 1.0863580086]) {
        assert_abs_diff_eq!(*found, known, epsilon = 1e-6);
    }
}

#[test]
fn a_run_that_was_stopped_in_the_middle_of_a_level_ends_as_the_undisturbed_one() {
    let [whole, stopped, resumed] = progress_and_stop::runs().unwrap();
    let left = stopped.resume.unwrap();
    assert_eq!(stopped.status, Status::Interrupted);
    assert!(!left.finished.is_empty() && left.finished.len() < 3 && left.states.len() > 3, "stopped between levels");
    assert_eq!(whole.status, Status::Ok);
    assert!(whole.wear.as_ref().unwrap().steady && whole.history[0].1.len() > 10);
    assert!(digits(&whole) == digits(&resumed), "the resumed run is another one");
}
