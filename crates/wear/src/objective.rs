//! Values of the functionals (11)-(13), in logarithms, and the multipliers that follow from Euler's identity.

use crate::density::Density;
use crate::pressure_law::Node;
use crate::stage::Stage;
use crate::{Functional, Problem, SurfacePoint};

/// log of the local term X_i.
fn log_term(problem: &Problem, i: usize, log_pressure: f64, speed: f64) -> f64 {
    let rule = &problem.wear.rules[i];
    match &problem.functional {
        Functional::WearVolume => rule.log_rate(log_pressure, speed),
        Functional::WearPower | Functional::Steady => rule.log_rate(log_pressure, speed) + log_pressure,
        Functional::FrictionPower if i == 0 => problem.friction.ln() + log_pressure + speed.ln(),
        Functional::Own(functional) if i == 0 && log_pressure > f64::NEG_INFINITY => {
            functional.at(log_pressure.exp(), speed, problem.friction)[0].ln()
        }
        Functional::FrictionPower | Functional::Own(_) | Functional::Uniform => f64::NEG_INFINITY,
    }
}

/// J_i = (int X_i^q dS)^(1/q) of both bodies, the maxima for q = inf; `None` where J is not defined (q = 0, uniform, steady).
pub(crate) fn terms(problem: &Problem, points: &[SurfacePoint], log_pressure: &[f64]) -> Option<[f64; 2]> {
    let own = matches!(problem.functional, Functional::Own(_));
    let q = if own { 1.0 } else { problem.q };
    if q == 0.0 || matches!(problem.functional, Functional::Uniform | Functional::Steady) {
        return None;
    }
    if !problem.wear.active && !own && problem.functional != Functional::FrictionPower {
        return Some([0.0; 2]);
    }
    Some([0, 1].map(|i| {
        let logs = || {
            points
                .iter()
                .zip(log_pressure)
                .map(move |(point, log)| (log_term(problem, i, *log, point.sliding_speed), point.weight))
        };
        let largest = logs().map(|term| term.0).fold(f64::NEG_INFINITY, f64::max);
        if largest == f64::NEG_INFINITY || q == f64::INFINITY {
            return largest.exp();
        }
        let shift = logs().map(|term| q * term.0).fold(f64::NEG_INFINITY, f64::max);
        if q == f64::NEG_INFINITY || shift == f64::INFINITY {
            return logs().map(|term| term.0).fold(f64::INFINITY, f64::min).exp();
        }
        let sum: f64 = logs().map(|(log, weight)| weight * (q * log - shift).exp()).sum();
        ((sum.ln() + shift) / q).exp()
    }))
}

/// Value of the functional for any pressure: J of (11)-(13), or the plain power for q = 1; int X dS of a functional of one's own. `None` for q = 0, uniform and steady.
pub fn functional_value(problem: &Problem, points: &[SurfacePoint], pressure: &[f64]) -> Option<f64> {
    let logs: Vec<f64> = pressure.iter().map(|p| p.ln()).collect();
    terms(problem, points, &logs).map(|terms| terms[0] + terms[1])
}

/// Multipliers lambda_k = dJ/dF_k over those of the law's gauge. From sum_i e_i J_i = lambda . int phi p over the points below the
/// cap; for the steady state, where they are the feed itself, from lambda . int phi p = int p (rate of the gap).
pub(crate) fn multiplier_factor(
    stage: &Stage<'_>,
    nodes: &[Node],
    log_pressure: &[f64],
    gap: &[f64],
    terms: Option<[f64; 2]>,
) -> Option<f64> {
    let problem = stage.problem;
    let steady = problem.functional == Functional::Steady;
    if matches!(problem.functional, Functional::Own(_)) {
        // dX/dp = f itself.
        return Some(stage.law.log_scale.exp());
    }
    if steady && matches!(stage.law.density, Density::Sum { .. } | Density::Receding { .. } | Density::Given(_)) {
        return Some(if problem.wear.active { stage.law.log_scale.exp() } else { 0.0 });
    }
    if matches!(stage.law.density, Density::Given(_)) {
        // dX/dp = f, and J = (int X dS)^(1/q).
        let of = |[first, second]: [f64; 2]| ((1.0 - problem.q) * (first + second).ln() + stage.law.log_scale).exp() / problem.q;
        return terms.map(of);
    }
    if let Density::BangBang { speed_power } = stage.law.density {
        return terms.map(|terms| switched(stage, (nodes, log_pressure), speed_power, terms));
    }
    let free = || nodes.iter().zip(log_pressure).enumerate().filter(|(_, (node, _))| node.excess < 0.0);
    // In the limit s -> 1 where g is the pivot mode itself f is that mode.
    let is_cost = matches!(stage.law.density, Density::Exponential);
    let by_modes = |node: &Node| stage.law.force_function(&node.point, &node.modes).0.max(0.0);
    let force = |node: &Node| if is_cost { node.modes.phi[stage.law.pivot] } else { by_modes(node) };
    let work: f64 = free().map(|(_, (node, log))| node.point.weight * force(node) * log.exp()).sum();
    if steady {
        let power: f64 = free().map(|(i, (node, log))| node.point.weight * log.exp() * gap[i]).sum();
        return Some(power / work);
    }
    terms.map(|terms| euler(problem, nodes, log_pressure, terms) / work)
}

/// At s = 1 under a cap dJ/dp = sum_i e_i J_i^(1-q) X_i^q / p does not depend on p: the places that press are those where it is below lambda . phi, in the gauge
/// of the law those where v^speed_power is below f times the common factor.
fn switched(stage: &Stage<'_>, (nodes, log_pressure): (&[Node], &[f64]), speed_power: f64, terms: [f64; 2]) -> f64 {
    let problem = stage.problem;
    let pressed = nodes.iter().zip(log_pressure).find(|(_, log)| log.is_finite());
    let slope = |(node, log): (&Node, &f64)| -> f64 {
        let speed = node.point.sliding_speed;
        let of = |i: usize| {
            let e = problem.functional.pressure_power(problem.wear.powers()[i].pressure_exponent);
            e * ((1.0 - problem.q) * terms[i].ln() + problem.q * log_term(problem, i, *log, speed) - log).exp()
        };
        let slope: f64 = (0..2).filter(|i| terms[*i] > 0.0).map(of).sum();
        slope / if speed_power == 0.0 { 1.0 } else { (speed / stage.law.reference_speed).powf(speed_power) }
    };
    pressed.map_or(0.0, slope) * stage.law.log_scale.exp()
}

/// sum_i e_i J_i, of which only the points below the cap count.
fn euler(problem: &Problem, nodes: &[Node], log_pressure: &[f64], terms: [f64; 2]) -> f64 {
    let q = problem.q;
    (0..2)
        .filter(|i| terms[*i] > 0.0)
        .map(|i| {
            let e = problem.functional.pressure_power(problem.wear.powers()[i].pressure_exponent);
            let capped = nodes.iter().any(|node| node.excess >= 0.0);
            if !capped || q.is_infinite() {
                return e * terms[i];
            }
            let log_norm = q * terms[i].ln();
            let below: f64 = nodes
                .iter()
                .zip(log_pressure)
                .filter(|(node, _)| node.excess < 0.0)
                .map(|(node, log)| {
                    let term = log_term(problem, i, *log, node.point.sliding_speed);
                    node.point.weight * (q * term - log_norm).exp()
                })
                .sum();
            e * terms[i] * below
        })
        .sum()
}
