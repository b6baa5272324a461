//! The error of a shape that no finer level takes away: round-off, as large as the condition of what the shape rests on makes it.

use shapeopt::{Measure, Shape};

use crate::steps::answer::Outcome;

/// Least error of a reported gap, relative to what its error is measured by: what round-off leaves in its rigid part, and the spacing of numbers
/// times the condition of the contact on it (where the proof has told that) times the largest displacement.
pub(crate) fn least_error(shape: &Shape, measure: Measure, outcome: &Outcome) -> f64 {
    let size = outcome.shape.as_ref().and_then(|result| match measure {
        Measure::Largest => result.gap_max,
        Measure::Crown => result.crown,
    });
    let Some(size) = size.filter(|size| *size > 0.0) else { return 0.0 };
    let displacements = outcome.told.iter().flat_map(|told| told.profile.normal_displacement.iter().flatten());
    let moved = displacements.filter(|u| u.is_finite()).fold(0.0_f64, |most, u| most.max(u.abs()));
    let condition = outcome.interface.as_ref().map_or(0.0, |interface| interface.condition);
    // Displacements and gaps are told in um.
    (1e3 * shape.round_off + f64::EPSILON * condition * moved) / size
}
