//! The start gap of a problem.

use contact::{ContactOperator, Pair};
use meshing::Extent;

use crate::stage::Stage;

/// The start gaps of the problem at the contact points (mm).
pub(crate) fn start_gaps(stage: Stage<'_>, operator: &ContactOperator<'_>) -> Vec<f64> {
    operator.points().iter().map(|p| start_gap(stage, operator.pair(), p.arc)).collect()
}

/// The start gap of the problem at an arc length (mm).
pub(crate) fn start_gap(stage: Stage<'_>, pair: &Pair<'_>, arc: f64) -> f64 {
    gap_at(stage, stage.start(pair) + arc)
}

/// The same at a surface coordinate: what the scene gives, and on a round body `R - sqrt(R^2 - s^2)`, without cancellation.
fn gap_at(stage: Stage<'_>, s: f64) -> f64 {
    let given = stage.problem.gap.at(s);
    match stage.extent {
        Extent::Round { radius, .. } => given + s * s / (radius + ((radius - s) * (radius + s)).max(0.0).sqrt()),
        _ => given,
    }
}
