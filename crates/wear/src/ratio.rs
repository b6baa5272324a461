//! Two wearing bodies with different exponents and q != 1: the ratio of the two terms of the stationarity condition (17).
//!
//! With X_i = c_i v^(a_i) p^(e_i) and A_i = int X_i^q dS the condition reads sum_i Q_i p^(s_i - 1) = f with
//! Q_i = e_i (c_i v^(a_i))^q A_i^((1-q)/q); only delta = log Q_2/Q_1 (without v) matters, and it solves
//! delta = log(e_2/e_1) + q log(c_2/c_1) + ((1-q)/q) log(A_2/A_1)(delta).

use crate::balance::Balanced;
use crate::bracket::Bracket;
use crate::density::Density;
use crate::pressure_law::Node;
use crate::reduce::Ratio;
use crate::solve::balance_any;
use crate::stage::Stage;
use crate::{Functional, Problem, WearError};

const SCAN: usize = 200;

/// All roots delta found, each with its stage and balance left to be recomputed by `at`.
pub(crate) fn roots(problem: &Problem, ratio: &Ratio) -> Result<Vec<f64>, WearError> {
    let mut nodes = Vec::new();
    let mut defect = |delta: f64| -> Result<f64, WearError> {
        let (stage, _) = at(problem, ratio, delta, &mut nodes)?;
        Ok(delta - target(&stage, ratio, &nodes))
    };
    let [lo, hi] = bracket(problem, ratio, &mut defect)?;
    if lo == hi {
        return Ok(vec![lo]);
    }
    let b = problem.wear.powers().map(|law| law.pressure_exponent);
    let several = problem.functional == Functional::WearVolume && b[0].min(b[1]) < 1.0 && ratio.m[0] > 0.0;
    let count = if several { SCAN } else { 1 };
    let mut found = Vec::new();
    let (mut a, mut fa) = (lo, defect(lo)?);
    for i in 1..=count {
        let b = lo + (hi - lo) * i as f64 / count as f64;
        let fb = defect(b)?;
        if fa == 0.0 {
            found.push(a);
        } else if (fa > 0.0) != (fb > 0.0) && fb != 0.0 {
            found.push(refine([a, b], [fa, fb], &mut defect)?);
        } else if i == count && fb == 0.0 {
            found.push(b);
        }
        (a, fa) = (b, fb);
    }
    Ok(found)
}

/// The balanced pressure for a given ratio.
pub(crate) fn at<'a>(
    problem: &'a Problem,
    ratio: &Ratio,
    delta: f64,
    nodes: &mut Vec<Node>,
) -> Result<(Stage<'a>, Balanced), WearError> {
    let mut stage = Stage::new(problem, ratio.density(delta))?;
    let balanced = balance_any(&mut stage, nodes)?;
    stage.law.log_scale = balanced.log_scale;
    Ok((stage, balanced))
}

/// base + ((1-q)/q) (log A_2 - log A_1), the factors c_i cancelled into `base`.
fn target(stage: &Stage<'_>, ratio: &Ratio, nodes: &[Node]) -> f64 {
    let q = stage.problem.q;
    let norm = |i: usize| {
        let log = |node: &Node| {
            let speed = node.point.sliding_speed.ln();
            let speed = if ratio.powers[i] == 0.0 { 0.0 } else { ratio.powers[i] * speed };
            speed + ratio.s[i] * stage.law.log_pressure(node)
        };
        let shift = nodes.iter().map(log).fold(f64::NEG_INFINITY, f64::max);
        let sum: f64 = nodes.iter().map(|node| node.point.weight * (log(node) - shift).exp()).sum();
        shift + sum.ln()
    };
    let laws = stage.problem.wear.powers();
    let factor = q * (laws[1].factor.ln() - laws[0].factor.ln());
    ratio.base + (1.0 - q) / q * (norm(1) - norm(0) + factor)
}

/// For b1 = b2 log(A_2/A_1) lies between the extremes of (a2 - a1) q log v (3.2); otherwise outward from the value at one pressure.
fn bracket(
    problem: &Problem,
    ratio: &Ratio,
    defect: &mut dyn FnMut(f64) -> Result<f64, WearError>,
) -> Result<[f64; 2], WearError> {
    let q = problem.q;
    let mut speeds = (f64::INFINITY, 0.0_f64);
    problem.surface.survey(&mut |point| {
        speeds = (speeds.0.min(point.sliding_speed), speeds.1.max(point.sliding_speed));
    });
    let laws = problem.wear.powers();
    let centre = ratio.base + (1.0 - q) * (laws[1].factor.ln() - laws[0].factor.ln());
    if matches!(ratio.density(0.0), Density::Mixed { .. }) && speeds.0 > 0.0 {
        let ends = [speeds.0, speeds.1].map(|v| centre + (1.0 - q) / q * (ratio.powers[1] - ratio.powers[0]) * v.ln());
        let margin = 1e-12 * (1.0 + ends[0].abs().max(ends[1].abs()));
        let (lo, hi) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        return Ok(if lo == hi { [lo, lo] } else { [lo - margin, hi + margin] });
    }
    let start = centre;
    let value = defect(start)?;
    if value == 0.0 {
        return Ok([start, start]);
    }
    let mut step = 0.5;
    let mut end = start;
    for _ in 0..40 {
        end -= step * value.signum();
        if (defect(end)? > 0.0) != (value > 0.0) {
            return Ok([start.min(end), start.max(end)]);
        }
        step *= 2.0;
    }
    Err(WearError::NotConverged { iterations: 40, residual: value })
}

fn refine(ends: [f64; 2], values: [f64; 2], defect: &mut dyn FnMut(f64) -> Result<f64, WearError>) -> Result<f64, WearError> {
    let mut root = Bracket { a: ends[0], value_a: values[0], b: ends[1], value_b: values[1] };
    for _ in 0..100 {
        if root.value_b == 0.0 || (root.b - root.a).abs() <= 1e-15 * root.b.abs().max(1.0) {
            break;
        }
        let c = root.next();
        let moved = (c - root.b).abs();
        root.take(c, defect(c)?);
        if moved <= 1e-15 * root.b.abs().max(1.0) {
            break;
        }
    }
    Ok(root.b)
}
