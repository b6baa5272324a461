//! The balance sum over the nodes of psi_k p = F_k for densities known up to a factor.

use crate::WearError;
use crate::cells::whole;
use crate::density::Density;
use crate::newton::newton;
use crate::pressure_law::Node;
use crate::stage::Stage;
use crate::sums::sums;
use crate::why::{ALL_CLOSED, AT_THE_AXIS, SELF_LOCKING, none};

/// Multipliers found: the stage holds y; log p = log_scale + log h at every node.
pub(crate) struct Balanced {
    pub(crate) log_scale: f64,
    pub(crate) iterations: usize,
    pub(crate) residual: f64,
}

/// Largest part of a resultant that an answer may miss; what ends with less has a smaller one of its own.
const MISSED: f64 = 1e-6;

/// Refuses nodes whose pressure does not carry the load.
pub(crate) fn carried(stage: &Stage<'_>, nodes: &[Node], balanced: &Balanced) -> Result<(), WearError> {
    let total = sums(stage, nodes);
    let log_factor = total.shift + if stage.law.absolute { 0.0 } else { balanced.log_scale };
    let missed = |k: usize| {
        let terms = nodes.iter().map(|node| node.modes.psi[k].abs() * (node.log_h + node.point.weight.ln() - total.shift).exp());
        let (load, force) = (stage.law.resultant(k), total.force[k] * log_factor.exp());
        (force - load).abs() / (load.abs() + terms.sum::<f64>() * log_factor.exp())
    };
    let residual = (0..stage.law.count).map(missed).fold(0.0, f64::max);
    if residual > MISSED { Err(WearError::NotConverged { iterations: balanced.iterations, residual }) } else { Ok(()) }
}

/// Solves the balance for a density known up to a factor (`Power`, `Mixed`, `Exponential`).
pub(crate) fn balance(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<Balanced, WearError> {
    stage.collect(nodes);
    whole(nodes)?;
    let k = match stage.law.density {
        Density::Power { k, .. } | Density::Mixed { k, .. } => k,
        Density::Exponential | Density::BangBang { .. } | Density::Given(_) | Density::Receding { .. } | Density::Sum { .. } => {
            f64::INFINITY
        }
    };
    if nodes.iter().all(|node| node.log_h == f64::NEG_INFINITY) {
        return Err(stage.infeasible(none("no point of the surface closes under the load")));
    }
    if k < 0.0 && (stage.open_at_ends() || nodes.iter().any(|node| node.f <= 0.0)) {
        return Err(stage.infeasible(ALL_CLOSED));
    }
    let (iterations, residual) = if stage.law.count == 1 { (0, 0.0) } else { newton(stage, nodes, k)? };
    whole(nodes)?;
    if let Density::Power { speed_power, .. } = stage.law.density
        && speed_power >= 2.0
        && stage.problem.surface.reaches_axis()
    {
        return Err(stage.infeasible(AT_THE_AXIS));
    }
    let total = sums(stage, nodes);
    let pivot = stage.law.pivot;
    let factor = stage.law.resultant(pivot) / total.force[pivot];
    if !(factor > 0.0 && factor.is_finite()) {
        return Err(stage.infeasible(SELF_LOCKING));
    }
    Ok(Balanced { log_scale: factor.ln() - total.shift, iterations, residual })
}
