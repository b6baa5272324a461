//! Certificates of the steady state: is the wear a rigid motion, and do the two bodies keep their shapes?

use nalgebra::{DMatrix, DVector};

use crate::mode::MAX_MODES;
use crate::pressure_law::Node;
use crate::recession::Recession;
use crate::stage::Stage;
use crate::{Counterface, Problem, Shape, SurfacePoint};

/// Rate at which the gap grows at a node: body 1 alone on a fresh plate, the sum on a ring, body 1 plus body 2's mean along the track
/// on a revolving counter-face.
pub(crate) fn gap_rate(problem: &Problem, recession: &Recession, node: &Node, rates: &[f64; 2]) -> f64 {
    match problem.counterface {
        Counterface::Fresh => rates[0],
        Counterface::Congruent => rates[0] + rates[1],
        // A full ring covers its tracks.
        Counterface::Revolving if matches!(problem.surface.shape(), Shape::Annulus { .. }) => rates[0] + rates[1],
        Counterface::Revolving => rates[0] + recession.at(&node.point),
    }
}

/// Places along a surface that is pressed in part at which it is looked whether the rest opens.
const PLACES: usize = 201;

/// ||w' - projection on the closing velocities|| / ||w'|| in the area norm, closing where nothing presses counting too; `None` when nothing wears. `gap` is
/// the gap rate w'.
pub(crate) fn steadiness(stage: &Stage<'_>, nodes: &[Node], gap: &[f64], recession: &Recession) -> Option<f64> {
    let count = stage.law.count;
    let largest = gap.iter().copied().fold(0.0, f64::max);
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let closing = |node: &Node, k: usize| stage.law.modes[k].motion.closing(&node.point) / stage.law.scale[k];
    // Unused modes keep a unit diagonal.
    let mut gram = DMatrix::<f64>::identity(MAX_MODES, MAX_MODES);
    let mut side = DVector::<f64>::zeros(MAX_MODES);
    gram.view_mut((0, 0), (count, count)).fill(0.0);
    let mut square = 0.0;
    // Outside the contact the gap may open: only the worn part has to be rigid.
    let touching = || nodes.iter().zip(gap).filter(|(node, _)| node.f > 0.0);
    for (node, rate) in touching() {
        let (w, weight) = (rate / largest, node.point.weight);
        square += weight * w * w;
        for i in 0..count {
            side[i] += weight * w * closing(node, i);
            for j in 0..count {
                gram[(i, j)] += weight * closing(node, i) * closing(node, j);
            }
        }
    }
    let rigid = gram.lu().solve(&side)?;
    let mut rest = 0.0;
    for (node, rate) in touching() {
        let fit: f64 = (0..count).map(|k| rigid[k] * closing(node, k)).sum();
        rest += node.point.weight * (rate / largest - fit).powi(2);
    }
    // Body 2 recedes beside the contact too where it revolves.
    let recedes = |point: &SurfacePoint| gap_rate(stage.problem, recession, &stage.law.node(*point), &[0.0; 2]) / largest;
    Some(((rest + closing_beside(stage, &rigid, &recedes)) / square).sqrt())
}

/// Square of the rate at which what carries nothing closes as the worn part moves like `rigid` and body 2 `recedes` there, over its area.
fn closing_beside(stage: &Stage<'_>, rigid: &DVector<f64>, recedes: &dyn Fn(&SurfacePoint) -> f64) -> f64 {
    let points = stage.problem.surface.sample(PLACES);
    let beside = points.iter().filter(|point| stage.law.node(**point).log_h == f64::NEG_INFINITY);
    let closing = |point: &SurfacePoint| -> f64 {
        let mode = |k: usize| rigid[k] * stage.law.modes[k].motion.closing(point) / stage.law.scale[k];
        (0..stage.law.count).map(mode).sum()
    };
    beside.map(|point| point.weight * (closing(point) - recedes(point)).max(0.0).powi(2)).sum()
}

/// Standard deviation over mean of body 1's share w1'/(w1' + w2') over the surface, equation (7); `None` unless both bodies wear.
pub(crate) fn congruence(problem: &Problem, nodes: &[Node], rates: &[[f64; 2]]) -> Option<f64> {
    if !(problem.wear.wears(0) && problem.wear.wears(1)) {
        return None;
    }
    let shares = || {
        nodes
            .iter()
            .zip(rates)
            .filter(|(_, rate)| rate[0] + rate[1] > 0.0)
            .map(|(node, rate)| (node.point.weight, rate[0] / (rate[0] + rate[1])))
    };
    let area: f64 = shares().map(|(weight, _)| weight).sum();
    let mean: f64 = shares().map(|(weight, share)| weight * share).sum::<f64>() / area;
    let variance: f64 = shares().map(|(weight, share)| weight * (share - mean).powi(2)).sum::<f64>() / area;
    Some(variance.sqrt() / mean)
}
