//! Ladders end where they should, and report their best level.

use super::*;

fn ladder(accuracy: f64) -> Ladder {
    Ladder {
        step: Step::Contact,
        levels: Vec::new(),
        usual: 0,
        accuracy: Some(accuracy),
        beside: None,
        unordered: Cell::default(),
    }
}

#[allow(clippy::trivially_copy_pass_by_ref)]
fn distance(a: &f64, b: &f64) -> [f64; 1] {
    [(a - b).abs()]
}

#[test]
fn levels_worse_than_those_before_are_not_reported() {
    let falling = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
    let wild: Vec<f64> = falling.into_iter().chain([0.3]).collect();
    let (count, [error]) = best(&ladder(1e-9), &wild, &distance).expect("levels enough");
    assert!(count == 5 && error < 1e-5, "{count}: {error:e}");
    // In round-off the estimate is what levels differ by.
    let lost: Vec<f64> = falling.into_iter().chain([3e-7, -2e-7, 4e-7]).collect();
    let (_, [error]) = best(&ladder(1e-9), &lost, &distance).expect("levels enough");
    assert!((1e-7..2e-6).contains(&error), "{error:e}");
}

/// The gaps of `clutch-hot` by degree, whose differences fall by .16, .19, .06 and .46: the estimate is less than a digit above the error, and hardly below.
#[test]
fn a_difference_that_is_small_by_chance_is_not_the_error() {
    let changes = [1.262e-2, 2.058e-3, 3.952e-4, 2.196e-5, 1.0e-5, 1.7e-6];
    let levels: Vec<f64> = (0..=changes.len()).map(|from| changes[from..].iter().sum()).collect();
    for (count, truth) in levels.iter().enumerate().skip(3).take(3) {
        let [error] = errors(&levels[..=count], &distance).expect("levels enough");
        assert!(*truth < 1.5 * error && error < 10.0 * truth, "{count}: {truth:e} {error:e}");
    }
    // One that grew before tells no fall.
    let [error] = errors(&[0.0, 1e-4, 3e-4, 3.1e-4], &distance).expect("levels enough");
    assert!((1e-5..2e-5).contains(&error), "{error:e}");
}

#[test]
fn a_ladder_that_falls_reports_its_last_level() {
    let falling = [1e-2, 1e-3, 1e-4, 1e-5];
    assert_eq!(best(&ladder(1e-9), &falling, &distance).map(|(count, _)| count), Some(4));
    assert_eq!(best(&ladder(1e-9), &falling[..2], &distance), None);
}

#[test]
fn the_third_level_expects_others_by_how_far_the_first_two_are_apart() {
    let levels: Vec<Level> = (4..=16).step_by(2).map(|degree| Level::of(degree, false)).collect();
    let ladder = Ladder { usual: 7, levels, ..ladder(1e-5) };
    assert!(ladder.expects_more(&[0.0], &distance) && ladder.expects_more(&[0.0, 0.1], &distance));
    assert!(!ladder.expects_more(&[0.0, 1e-3], &distance));
}

#[test]
fn climbing_ends_where_differences_no_longer_fall() {
    assert!(!idle(&[1e-2, 1e-3, 1e-4]));
    assert!(!idle(&[1e-2, 1e-3, 2e-3, 1e-4, 3e-4]));
    assert!(idle(&[1e-2, 1e-3, 1e-4, 2e-4, 3e-4]));
    // A fall that slows down goes on; one that was fast and ends does not.
    assert!(!idle(&[1e-2, 1e-3, 1e-4, 5e-5]));
    assert!(!idle(&[1e-2, 6e-3, 4e-3, 3.5e-3]));
    assert!(idle(&[8e-6, 6.2e-7, 6e-8, 5.3e-8]));
}

#[test]
fn further_degrees_are_climbed_where_they_are_nearly_there_or_as_errors_fall() {
    let levels: Vec<Level> = (4..=20).step_by(2).map(|degree| Level::of(degree, false)).collect();
    let ladder = Ladder { usual: 7, levels, ..ladder(1e-9) };
    assert!(ladder.goes_beyond(7, [9e-9, 0.8]) && ladder.goes_beyond(7, [2e-8, 0.2]));
    assert!(!ladder.goes_beyond(7, [2e-8, 0.3]) && !ladder.goes_beyond(8, [2e-8, 0.2]));
}

/// Levels of a run in time, whose steps leave 2e-8 whatever the degree: four levels find that, the fifth shows it, and no more are solved.
#[test]
fn climbing_ends_at_the_first_level_that_shows_that_finer_ones_gain_nothing() {
    let levels: Vec<Level> = (4..=20).step_by(2).map(|degree| Level::of(degree, false)).collect();
    let ladder = Ladder { usual: levels.len(), levels, ..ladder(1.6e-10) };
    let left_by_steps = |degree: usize| 2e-8 * (degree as f64).cos();
    let mut count = 0;
    let solve = |level: Level, _: &[f64], _: &mut Watch<'_>| {
        count += 1;
        Ok(ControlFlow::Continue(1e-1 * 10.0_f64.powi(-(level.degree as i32)) + left_by_steps(level.degree)))
    };
    let climbed = climb(&ladder, Vec::new(), solve, distance, &mut |_| ControlFlow::Continue(()));
    let solved = climbed.unwrap_or_else(|_| Climbed { solved: Vec::new(), stopped: true }).solved;
    let (reported, [error]) = best(&ladder, &solved, &distance).expect("levels enough");
    let truth = solved[reported - 1].abs();
    assert_eq!(count, 5, "{solved:?}");
    assert!(truth < 2.0 * error && error < 1e-7, "{truth:e} {error:e}");
}
