//! Newton's method for the multipliers: sum over the nodes of psi_k p = F_k.

use nalgebra::{DMatrix, DVector};

use crate::absolute::balance_absolute;
use crate::continuation::balance_by_continuation;
use crate::density::Density;
use crate::singular;
use crate::stage::{ModeValues, Node, Stage};
use crate::{MAX_MODES, Modes, WearError};

const ITERATIONS: usize = 100;
const TOLERANCE: f64 = 1e-14;

/// Multipliers found: the stage holds y; log p = log_scale + log h at every node.
pub(crate) struct Balanced {
    pub(crate) log_scale: f64,
    pub(crate) iterations: usize,
    pub(crate) residual: f64,
}

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

/// Solves the balance for any density, under the pressure cap if there is one.
pub(crate) fn balance_any(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<Balanced, WearError> {
    let cap = stage.problem.p_max.map_or(f64::INFINITY, f64::ln);
    let several = stage.law.count > 1;
    match stage.law.density {
        Density::Power { k: target, speed_power } if several && (0.0..0.05).contains(&target) => {
            // Fronts jump for k = 0: come from k = 1 so that they start close to their places.
            let mut k = 1.0;
            // Until a front has appeared: in full contact the last equation does not see y.
            while k > target.max(1e-8) {
                let mut softer = Stage::new(stage.problem, Density::Power { k, speed_power })?;
                softer.law.y = stage.law.y;
                match balance(&mut softer, nodes) {
                    Ok(_) | Err(WearError::NotConverged { .. }) => stage.law.y = softer.law.y,
                    Err(other) => return Err(other),
                }
                if k < 0.05 && softer.open_at_ends() {
                    break;
                }
                k *= 0.3;
            }
            if target > 0.0 && !stage.open_at_ends() {
                let balanced = balance(stage, nodes)?;
                return capped(stage, nodes, balanced, cap);
            }
            stage.law.log_cap = cap;
            balance_absolute(stage, nodes)
        }
        Density::Sum { .. } | Density::Receding { .. } | Density::BangBang { .. } | Density::Rule { .. } => {
            stage.law.log_cap = cap;
            balance_absolute(stage, nodes)
        }
        _ => {
            let balanced = match balance(stage, nodes) {
                Err(WearError::NotConverged { .. }) if several => return second_way(stage, nodes, cap),
                other => other?,
            };
            capped(stage, nodes, balanced, cap)
        }
    }
}

/// When the iteration has stalled: differences of the exact residuals in place of the Jacobian, whose integrand f^(k-1) is not resolved
/// where the end of contact runs along a line of points, then continuation from a tame exponent.
fn second_way(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, cap: f64) -> Result<Balanced, WearError> {
    let stalled = stage.law.y;
    stage.law.log_cap = cap;
    if let Ok(balanced) = balance_absolute(stage, nodes) {
        return Ok(balanced);
    }
    stage.law.absolute = false;
    stage.law.log_cap = f64::INFINITY;
    stage.law.log_scale = 0.0;
    stage.law.y = stalled;
    let balanced = balance_by_continuation(stage, nodes)?;
    capped(stage, nodes, balanced, cap)
}

/// The balanced state itself where it stays below the cap, else the state under the cap.
fn capped(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, balanced: Balanced, cap: f64) -> Result<Balanced, WearError> {
    let largest = nodes.iter().map(|node| node.log_h).fold(f64::NEG_INFINITY, f64::max);
    stage.law.log_scale = balanced.log_scale;
    if balanced.log_scale + largest <= cap {
        return Ok(balanced);
    }
    stage.law.log_cap = cap;
    balance_absolute(stage, nodes)
}

/// Solves the balance for a density known up to a factor (`Power`, `Mixed`, `Exponential`).
pub(crate) fn balance(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<Balanced, WearError> {
    stage.collect(nodes);
    let k = match stage.law.density {
        Density::Power { k, .. } | Density::Mixed { k, .. } => k,
        _ => f64::INFINITY,
    };
    if nodes.iter().all(|node| node.log_h == f64::NEG_INFINITY) {
        return Err(infeasible(stage, "no point of the surface closes under the load"));
    }
    if k < 0.0 && (stage.open_at_ends() || nodes.iter().any(|node| node.f <= 0.0)) {
        let why = "with s < 1 the stationary pressure needs a load that closes every point of the surface";
        return Err(infeasible(stage, why));
    }
    let (iterations, residual) = if stage.law.count == 1 { (0, 0.0) } else { newton(stage, nodes, k)? };
    if let Density::Power { speed_power, .. } = stage.law.density
        && speed_power >= 2.0
        && stage.problem.surface.reaches_axis()
    {
        return Err(infeasible(stage, "the pressure is not integrable at the axis of rotation"));
    }
    let total = sums(stage, nodes);
    let pivot = stage.law.pivot;
    let factor = stage.law.resultant(pivot) / total.force[pivot];
    if !(factor > 0.0 && factor.is_finite()) {
        return Err(infeasible(stage, "the friction carries the load: self-locking"));
    }
    Ok(Balanced { log_scale: factor.ln() - total.shift, iterations, residual })
}

pub(crate) fn infeasible(stage: &Stage<'_>, why: &'static str) -> WearError {
    WearError::Infeasible { resultants: stage.problem.modes.iter().map(|mode| mode.resultant).collect(), why }
}

/// Newton on the reduced residuals with the convex dual (associated modes) or the residual itself as merit.
fn newton(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, k: f64) -> Result<(usize, f64), WearError> {
    let free: Vec<usize> = (0..stage.law.count).filter(|j| *j != stage.law.pivot).collect();
    let associated = stage.problem.mode_kind == Modes::Associated || stage.symmetric(nodes);
    let mut last = f64::INFINITY;
    let mut earlier = f64::INFINITY;
    for iteration in 0..ITERATIONS {
        let here = evaluate(stage, nodes, &free, k);
        last = here.size;
        if iteration % 8 == 7 {
            // Less than a halving in eight iterations close to the solution is no Newton iteration any more.
            if last < 1e-2 && last > 0.5 * earlier {
                break;
            }
            earlier = last;
        }
        if here.size <= TOLERANCE {
            return Ok((iteration, here.size));
        }
        let Some(step) = here.jacobian.clone().lu().solve(&(-&here.residual)) else {
            break;
        };
        let slope = here.residual.dot(&step) * k.signum();
        let start = stage.law.y;
        let mut length = if k < 0.0 { stage.longest_step(nodes, &free, step.as_slice()) } else { 1.0 };
        let mut accepted = false;
        for _ in 0..40 {
            for (row, j) in free.iter().enumerate() {
                stage.law.y[*j] = start[*j] + length * step[row];
            }
            let closes = k > 0.0 || !stage.open_at_ends();
            if closes {
                stage.collect(nodes);
            }
            if closes && (k > 0.0 || nodes.iter().all(|node| node.f > 0.0)) {
                let there = evaluate(stage, nodes, &free, k);
                let closer = there.size < (1.0 - 1e-4 * length) * here.size;
                // The dual decides while it can be told apart from its rounding, then the residual.
                let settled = (there.dual - here.dual).abs() <= 1e-11 * (1.0 + here.dual.abs());
                let descends = there.dual <= here.dual + 1e-4 * length * slope.min(0.0);
                if there.size.is_finite() && if associated { descends || settled && closer } else { closer } {
                    accepted = true;
                    break;
                }
            }
            length *= 0.5;
        }
        if !accepted {
            stage.law.y = start;
            stage.collect(nodes);
            break;
        }
        if stage.may_lack_function(k) && stage.closeness(nodes) < 1e-7 {
            break;
        }
    }
    if last <= 1e-11 {
        return Ok((ITERATIONS, last));
    }
    if !singular::carries(stage) {
        return Err(infeasible(stage, "the moment is at or beyond the edge of the surface"));
    }
    if stage.may_lack_function(k) && stage.closeness(nodes) < 1e-3 {
        let why = "with s < 1 no stationary pressure carries this moment (its limit has a force on the edge)";
        return Err(infeasible(stage, why));
    }
    let ratio = stage.closeness(nodes);
    if k < 0.0 && ratio < 1e-9 {
        return Err(WearError::Unresolved { ratio });
    }
    Err(WearError::NotConverged { iterations: ITERATIONS, residual: last })
}

struct Evaluation {
    residual: DVector<f64>,
    jacobian: DMatrix<f64>,
    /// Residual relative to the sum of absolute terms.
    size: f64,
    /// sign(k) log(int f h) / s', which falls towards the solution (associated modes).
    dual: f64,
}

fn evaluate(stage: &Stage<'_>, nodes: &[Node], free: &[usize], k: f64) -> Evaluation {
    let total = sums(stage, nodes);
    let n = free.len();
    let mut residual = DVector::<f64>::zeros(n);
    let mut absolute = DVector::<f64>::zeros(n);
    let mut jacobian = DMatrix::zeros(n, n);
    for node in nodes.iter().filter(|node| node.f > 0.0) {
        let share = (node.log_h + node.point.weight.ln() - total.shift).exp() / total.energy;
        for (row, j) in free.iter().enumerate() {
            let psi = stage.law.reduced(&node.modes.psi, *j) * share;
            residual[row] += psi;
            absolute[row] += psi.abs();
            for (column, l) in free.iter().enumerate() {
                jacobian[(row, column)] += psi * node.slope * stage.law.reduced(&node.modes.phi, *l) / node.f;
            }
        }
    }
    let relative = |row: usize| residual[row].abs() / absolute[row];
    let size = if total.energy > 0.0 && nodes.len() > n {
        (0..n).map(relative).map(|v| if v.is_nan() { f64::INFINITY } else { v }).fold(0.0, f64::max)
    } else {
        f64::INFINITY
    };
    // The limit k -> inf (`Exponential`) has the dual log int f h itself.
    let dual =
        if k.is_finite() { k.signum() * (total.energy.ln() + total.shift) / (k + 1.0) } else { total.energy.ln() + total.shift };
    Evaluation { residual, jacobian, size, dual }
}

impl Stage<'_> {
    /// Nine tenths of the step to the first point where f = 0, at most 1: f is linear in y.
    fn longest_step(&self, nodes: &[Node], free: &[usize], step: &[f64]) -> f64 {
        let mut longest: f64 = 1.0;
        let mut limit = |f: f64, modes: &ModeValues| {
            let change: f64 = free.iter().zip(step).map(|(j, dy)| dy * self.law.reduced(&modes.phi, *j)).sum();
            if change < 0.0 {
                longest = longest.min(-0.9 * f / change);
            }
        };
        nodes.iter().for_each(|node| limit(node.f, &node.modes));
        self.problem.surface.survey(&mut |point| {
            let modes = self.law.mode_values(point);
            limit(self.law.force_function(point, &modes).0, &modes);
        });
        longest
    }

    /// True where f^k stays integrable as f -> 0 at the border, so that moments exist which no function carries: k > -1 on a line,
    /// k > -2 at the corner of an area.
    fn may_lack_function(&self, k: f64) -> bool {
        let limit = if self.problem.surface.outer_range().is_some() { -2.0 } else { -1.0 };
        k < 0.0 && k > limit
    }

    /// Smallest over largest f.
    fn closeness(&self, nodes: &[Node]) -> f64 {
        let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
        for node in nodes {
            (low, high) = (low.min(node.f), high.max(node.f));
        }
        self.problem.surface.survey(&mut |point| {
            low = low.min(self.law.force_function(point, &self.law.mode_values(point)).0);
        });
        low / high
    }
}
