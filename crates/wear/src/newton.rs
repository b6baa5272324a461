//! Newton's method for the multipliers.

use nalgebra::{DMatrix, DVector};

use crate::cells::{cut_short, whole};
use crate::pressure_law::{ModeValues, Node};
use crate::singular;
use crate::stage::Stage;
use crate::sums::sums;
use crate::why::{BEYOND_THE_EDGE, ON_THE_EDGE, SELF_LOCKING};
use crate::{Modes, WearError};

const ITERATIONS: usize = 100;
const TOLERANCE: f64 = 1e-14;
/// Iterations after which it is worth asking whether the load can be carried at all.
const DOUBT: usize = 4;

/// Newton on the reduced residuals with the convex dual (associated modes) or the residual itself as merit.
pub(crate) fn newton(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, k: f64) -> Result<(usize, f64), WearError> {
    let free: Vec<usize> = (0..stage.law.count).filter(|j| *j != stage.law.pivot).collect();
    let associated = stage.problem.mode_kind == Modes::Associated || stage.symmetric(nodes);
    let mut last = f64::INFINITY;
    let mut earlier = f64::INFINITY;
    for iteration in 0..ITERATIONS {
        whole(nodes)?;
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
        if iteration == DOUBT && last > 1e-6 && !singular::carries(stage) {
            return Err(not_carried(stage));
        }
        let Some(step) = here.jacobian.clone().lu().solve(&(-&here.residual)) else {
            break;
        };
        let search = Search { free: &free, k, associated, here: &here, step: &step };
        if !search.advance(stage, nodes) {
            break;
        }
        if stage.may_lack_function(k) && stage.closeness(nodes) < 1e-7 {
            break;
        }
    }
    if last <= 1e-11 { Ok((ITERATIONS, last)) } else { Err(failure(stage, nodes, k, last)) }
}

/// A Newton step and where it starts.
struct Search<'a> {
    free: &'a [usize],
    k: f64,
    /// Whether the dual falls towards the solution.
    associated: bool,
    here: &'a Evaluation,
    step: &'a DVector<f64>,
}

impl Search<'_> {
    /// Goes along the step, halved until the merit falls; without such a length stays where it was and says so.
    fn advance(&self, stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> bool {
        let (k, here, step) = (self.k, self.here, self.step);
        let slope = here.residual.dot(step) * k.signum();
        let start = stage.law.y;
        let mut length = if k < 0.0 { stage.longest_step(nodes, self.free, step.as_slice()) } else { 1.0 };
        for _ in 0..40 {
            for (row, j) in self.free.iter().enumerate() {
                stage.law.y[*j] = start[*j] + length * step[row];
            }
            let closes = k > 0.0 || !stage.open_at_ends();
            if closes {
                stage.collect(nodes);
            }
            if cut_short(nodes) {
                return true;
            }
            if closes && (k > 0.0 || nodes.iter().all(|node| node.f > 0.0)) {
                let there = evaluate(stage, nodes, self.free, k);
                let closer = there.size < (1.0 - 1e-4 * length) * here.size;
                // The dual decides while it can be told apart from its rounding, then the residual.
                let settled = (there.dual - here.dual).abs() <= 1e-11 * (1.0 + here.dual.abs());
                let descends = there.dual <= here.dual + 1e-4 * length * slope.min(0.0);
                if there.size.is_finite() && if self.associated { descends || settled && closer } else { closer } {
                    return true;
                }
            }
            length *= 0.5;
        }
        stage.law.y = start;
        stage.collect(nodes);
        false
    }
}

/// No pressure at all carries the load.
pub(crate) fn not_carried(stage: &Stage<'_>) -> WearError {
    stage.infeasible(if stage.bends() { SELF_LOCKING } else { BEYOND_THE_EDGE })
}

/// Why the iteration has ended away from a solution.
fn failure(stage: &Stage<'_>, nodes: &[Node], k: f64, residual: f64) -> WearError {
    if !singular::carries(stage) {
        return not_carried(stage);
    }
    if stage.may_lack_function(k) && stage.closeness(nodes) < 1e-3 {
        return stage.infeasible(ON_THE_EDGE);
    }
    let ratio = stage.closeness(nodes);
    if k < 0.0 && ratio < 1e-9 {
        return WearError::Unresolved { ratio };
    }
    WearError::NotConverged { iterations: ITERATIONS, residual }
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
    pub(crate) fn may_lack_function(&self, k: f64) -> bool {
        let limit = if self.problem.surface.outer_range().is_some() { -2.0 } else { -1.0 };
        k < 0.0 && k > limit
    }

    /// Smallest over largest f.
    pub(crate) fn closeness(&self, nodes: &[Node]) -> f64 {
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
