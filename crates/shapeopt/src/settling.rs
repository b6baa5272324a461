//! When a run has come within a given part of its steady state, and what it has cost until then.

use crate::wear_state::WearState;

/// Time, distance and wear until the pressure stays within a part of the steady one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Settling {
    /// Deviation `||p - p_end|| / ||p_end||` in the area norm.
    pub deviation: f64,
    /// Time, s.
    pub time: f64,
    /// Sliding distance, mm.
    pub distance: f64,
    /// Largest depth worn off body 1, mm.
    pub depth: f64,
    /// Volumes worn off the bodies, mm^3.
    pub volume: [f64; 2],
}

/// The moment after which the pressure of a run that ended steady stays within `deviation` of its last pressure; between two states the
/// deviation is taken to fall exponentially. `None` if the run never comes that close before its last state or is empty.
pub fn settling(states: &[WearState], weights: &[f64], deviation: f64) -> Option<Settling> {
    let end = states.last()?;
    let norm = |difference: &dyn Fn(usize) -> f64| -> f64 {
        (0..weights.len()).map(|i| weights[i] * difference(i).powi(2)).sum::<f64>().sqrt()
    };
    let size = norm(&|i| end.pressure[i]);
    let distance = |state: &WearState| norm(&|i| state.pressure[i] - end.pressure[i]) / size;
    let inside = states.iter().rposition(|s| distance(s) > deviation).map_or(0, |last| last + 1);
    if inside + 1 >= states.len() && inside > 0 {
        return None;
    }
    let after = &states[inside];
    let before = &states[inside.saturating_sub(1)];
    let (d0, d1) = (distance(before), distance(after));
    let part = if inside == 0 || d1 == 0.0 { 1.0 } else { (d0 / deviation).ln() / (d0 / d1).ln() };
    let between = |a: f64, b: f64| a + part * (b - a);
    Some(Settling {
        deviation,
        time: between(before.time, after.time),
        distance: between(before.distance, after.distance),
        depth: between(before.depth, after.depth),
        volume: std::array::from_fn(|i| between(before.volume[i], after.volume[i])),
    })
}
