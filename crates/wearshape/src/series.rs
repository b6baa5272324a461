//! What is left of a series of differences between levels that fall nearly like a geometric one.

/// Ratio of successive differences from which on they tell no series that falls.
pub(crate) const SLOWEST: f64 = 0.85;

/// Estimated error of the last of at least three levels from the differences of successive ones, `older` and `newer`: they fall
/// nearly like a geometric series, and since the fall slows down the ratio enters with the power 3/4 (true error over estimate
/// between 0.3 and 1 on the drum in degrees 8 to 14).
pub(crate) fn rest(older: f64, newer: f64) -> f64 {
    if newer == 0.0 {
        return f64::EPSILON;
    }
    let ratio = slowed(newer / older);
    (newer * ratio / (1.0 - ratio)).max(1e-14)
}

/// A fall that quickens by more than this is chance, and the one before it tells more of what is to come.
const QUICKER: f64 = 2.5;
/// The slowest fall that is expected then.
const HALF: f64 = 0.5;
/// The largest difference, relative, that tells how those after it fall: a first level that is farther off is none of their series. The corner of a punch
/// after a short run had .42 and 3.5e-3, by which it was accurate to 1e-4, and then 4.0e-3.
const TELLING: f64 = 0.01;

/// The fastest fall that two differences alone tell: a pad that goes to and fro had .57e-3, 1.1e-5 and .76e-6.
const STEEPEST: f64 = 0.05;

/// The same with the difference `before` those, if there is one: in 33 scenes true errors are 1.5 times the estimated ones at most where a difference is
/// before, and 2.3 times where the last ones are round-off; by the last two alone they are up to 5 times (a clutch, whose differences fall by .19, .06 and .46).
pub(crate) fn rest_after(before: Option<f64>, older: f64, newer: f64) -> f64 {
    let Some(before) = before else { return rest(older.min(TELLING).min(newer / STEEPEST), newer) };
    if is_chance(before, older, newer) { rest(newer / fall(before, older), newer) } else { rest(older, newer) }
}

/// Whether a difference is so small that it hardly goes on the fall of those before it.
pub(crate) fn is_chance(before: f64, older: f64, newer: f64) -> bool {
    fall(before, older) * older > QUICKER * newer
}

fn fall(before: f64, older: f64) -> f64 {
    (older / before).min(HALF)
}

/// Rest of a series over its last difference, from the ratio of its last two.
pub(crate) fn share(ratio: f64) -> f64 {
    let ratio = slowed(ratio);
    ratio / (1.0 - ratio)
}

/// The ratio of the differences to come.
fn slowed(ratio: f64) -> f64 {
    ratio.clamp(0.0, SLOWEST).powf(0.75)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corner of a punch worn for .01 s, degrees 4 to 14: what was told at degree 8 was a fortieth of what came.
    #[test]
    fn a_first_level_that_is_far_off_tells_no_fall() {
        let series = [0.42, 3.5e-3, 4.0e-3, 5.2e-4, 3.3e-5];
        assert!(rest(series[0], series[1]) < series[2] / 30.0);
        assert!(rest_after(None, series[0], series[1]) > 0.5 * series[2]);
        // Near levels tell theirs.
        assert_eq!(rest_after(None, 1e-3, 1e-4), rest(1e-3, 1e-4));
    }

    #[test]
    fn a_difference_that_is_small_by_chance_is_known_by_the_fall_before_it() {
        assert!(is_chance(0.57, 0.24, 2.1e-3));
        // A fall that goes on, down to round-off.
        assert!(!is_chance(1e-3, 1e-5, 1e-7) && !is_chance(1e-5, 1e-7, 1e-9));
    }
}
