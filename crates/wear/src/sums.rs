//! Sums over the nodes.

use crate::mode::MAX_MODES;
use crate::pressure_law::Node;
use crate::stage::Stage;

/// Sums over the nodes, all divided by exp(shift).
pub(crate) struct Sums {
    pub(crate) shift: f64,
    /// int psi_k h.
    pub(crate) force: [f64; MAX_MODES],
    /// int f h.
    pub(crate) energy: f64,
}

pub(crate) fn sums(stage: &Stage<'_>, nodes: &[Node]) -> Sums {
    let shift = nodes.iter().map(|node| node.log_h + node.point.weight.ln()).fold(f64::NEG_INFINITY, f64::max);
    let mut sums = Sums { shift, force: [0.0; MAX_MODES], energy: 0.0 };
    for node in nodes {
        let share = (node.log_h + node.point.weight.ln() - shift).exp();
        for k in 0..stage.law.count {
            sums.force[k] += node.modes.psi[k] * share;
        }
        if node.f > 0.0 {
            sums.energy += node.f * share;
        }
    }
    sums
}
