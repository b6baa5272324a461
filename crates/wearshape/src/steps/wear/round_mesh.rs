//! Where the contact surface of a round body that wears is cut: the end of contact moves from that of the start to that of the end, and the
//! cells under it are about as long as a part of its distance from the middle.

use crate::stage::Stage;

/// Ratio of successive break points.
const GROWTH: f64 = 1.3;
/// Length of the surface that may touch over that of the contact at the end.
pub(super) const CANDIDATE: f64 = 1.2;

/// Break points from the middle (mm), the last of them at the end of contact after the run.
pub(super) fn breaks(start: f64, end: f64) -> Vec<f64> {
    let first = start.min(end);
    let count = ((end / first).ln() / GROWTH.ln() * (1.0 - 1e-9)).ceil().max(0.0) as usize;
    let mut breaks = vec![0.5 * first];
    breaks.extend((0..count).map(|i| first * (end / first).powf(i as f64 / count as f64)));
    breaks.push(end);
    breaks
}

/// The same places from -1 to 1 along a surface that reaches as far as `reach` from the middle.
pub(super) fn along(stage: Stage<'_>, breaks: &[f64], reach: f64) -> Vec<f64> {
    let part = breaks.iter().map(|x| x / reach);
    if stage.couple.is_revolved() { part.map(|part| 2.0 * part - 1.0).collect() } else { part.collect() }
}
