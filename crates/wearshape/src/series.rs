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

/// Rest of a series over its last difference, from the ratio of its last two.
pub(crate) fn share(ratio: f64) -> f64 {
    let ratio = slowed(ratio);
    ratio / (1.0 - ratio)
}

/// The ratio of the differences to come.
fn slowed(ratio: f64) -> f64 {
    ratio.clamp(0.0, SLOWEST).powf(0.75)
}
