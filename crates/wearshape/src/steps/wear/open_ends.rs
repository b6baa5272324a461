//! Ends of contact in which a run ends that is on its way to no known place.

use contact::ContactPoint;

use crate::stage::Stage;

/// Half the surface, less what the layers at its edges resolve.
const INSIDE: f64 = 0.98;
/// Most ends that get nodes: more of them are points that lie open by turns.
const MOST: usize = 8;

/// Ends of a pressure inside the surface, from -1 to 1 along it, halfway between a point that presses and one that does not; none where the run goes
/// on until it is steady, where heat moves them or loads change.
pub(super) fn open_ends(stages: &[Stage<'_>], points: &[ContactPoint], pressure: &[f64], length: f64) -> Vec<f64> {
    let on_the_way = |stage: &Stage<'_>| stage.problem.wear.until.is_some() && stage.problem.heat.is_none() && !stage.ends_move();
    if !matches!(stages, [stage] if on_the_way(stage)) {
        return Vec::new();
    }
    let pairs = points.windows(2).zip(pressure.windows(2)).filter(|(_, p)| (p[0] > 0.0) != (p[1] > 0.0));
    let ends = pairs.map(|(at, _)| (at[0].arc + at[1].arc) / length - 1.0).filter(|end| end.abs() < INSIDE);
    ends.take(MOST).collect()
}
