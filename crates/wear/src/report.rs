//! From a balanced density to the full answer.

use nalgebra::{DMatrix, DVector, Vector3};

use crate::density::Density;
use crate::reduce::{Task, reduce};
use crate::solve::{Balanced, balance};
use crate::stage::{Node, Stage};
use crate::{
    Character, Counterface, Functional, Modes, Optimum, Problem, Regime, RigidMotion, WearError,
    log_wear_rate, wear_rate,
};

pub(crate) fn optimum(problem: &Problem) -> Result<Optimum, WearError> {
    problem.check()?;
    let mut nodes = Vec::new();
    match reduce(problem)? {
        Task::Density { density, s } => {
            let mut stage = Stage::new(problem, density)?;
            let balanced = balance(&mut stage, &mut nodes)?;
            Ok(report(&mut stage, &nodes, &balanced, s))
        }
        _ => Err(WearError::NotConverged {
            iterations: 0,
            residual: f64::NAN,
        }),
    }
}

fn report(stage: &mut Stage<'_>, nodes: &[Node], balanced: &Balanced, s: f64) -> Optimum {
    let problem = stage.problem;
    stage.law.log_scale = balanced.log_scale;
    let stage = &*stage;
    let log_pressure: Vec<f64> = nodes
        .iter()
        .map(|node| balanced.log_scale + node.log_h)
        .collect();
    let pressure: Vec<f64> = log_pressure.iter().map(|log| log.exp()).collect();
    let integral = |value: &dyn Fn(usize, &Node) -> f64| -> f64 {
        nodes
            .iter()
            .enumerate()
            .map(|(i, node)| node.point.weight * value(i, node))
            .sum()
    };
    let rates: Vec<[f64; 2]> = nodes
        .iter()
        .zip(&log_pressure)
        .map(|(node, log)| {
            [0, 1].map(|i| {
                if problem.wear.wears(i) {
                    rate(problem, i, *log, node)
                } else {
                    0.0
                }
            })
        })
        .collect();
    let normal_force = integral(&|i, _| pressure[i]);
    let friction_power =
        problem.friction * integral(&|i, node| pressure[i] * node.point.sliding_speed);
    let wear_power = integral(&|i, _| pressure[i] * (rates[i][0] + rates[i][1]));
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    for value in &pressure {
        (low, high) = (low.min(*value), high.max(*value));
    }
    problem.surface.survey(&mut |point| {
        let value = (balanced.log_scale + stage.law.node(*point).log_h).exp();
        (low, high) = (low.min(value), high.max(value));
    });
    let partial = problem.functional != Functional::Uniform && low == 0.0 && s > 1.0;
    let p_mean = normal_force / problem.surface.area();
    let near = (s - 1.0).abs() <= 0.05 + 1e-12 && high >= 1.5 * p_mean || high >= 10.0 * p_mean;
    let regime = match (partial, near) {
        (true, _) => Regime::PartialContact,
        (false, true) => Regime::NearSingular,
        _ => Regime::Regular,
    };
    let symmetric = problem.mode_kind == Modes::Associated || stage.symmetric(nodes);
    let character = match problem.functional {
        _ if !symmetric => Character::Stationary,
        _ if s > 1.0 => Character::Minimum,
        _ => Character::Maximum,
    };
    let objective = objective(problem, nodes, &log_pressure);
    let (multipliers, feed) = multipliers(stage, nodes, &log_pressure, &rates, objective);
    let turning = problem.surface.motion().angular_velocity.norm();
    let pressing = problem
        .modes
        .iter()
        .find(|mode| matches!(mode.motion, RigidMotion::Translation { .. }))
        .map_or(normal_force, |mode| mode.resultant);
    let swept = integral(&|i, node| pressure[i] * node.point.sliding_speed);
    let turns = turning > 0.0 && problem.surface.motion().velocity == Vector3::zeros();
    Optimum {
        points: nodes.iter().map(|node| node.point).collect(),
        s: Some(s).filter(|s| !s.is_nan()),
        k: match stage.law.density {
            Density::Power { k, .. } | Density::Mixed { k, .. } => Some(k),
            Density::Sum { .. } => None,
        },
        character,
        regime,
        limit_measure: Vec::new(),
        multipliers,
        feed,
        objective,
        wear_volume_rate: integral(&|i, _| rates[i][0] + rates[i][1]),
        friction_power,
        wear_power,
        p_min: low,
        p_max: high,
        p_mean,
        normal_force,
        resultants: problem
            .modes
            .iter()
            .map(|mode| {
                integral(&|i, node| {
                    pressure[i] * mode.motion.force_weight(&node.point, stage.law.friction)
                })
            })
            .collect(),
        torque: turns.then(|| friction_power / turning),
        effective_radius: turns.then(|| swept / turning / pressing),
        steadiness_residual: steadiness(stage, nodes, &rates),
        congruence_residual: congruence(problem, nodes, &rates),
        iterations: balanced.iterations,
        balance_residual: balanced.residual,
        pressure,
        log_pressure,
        law: stage.law,
    }
}

fn rate(problem: &Problem, i: usize, log_pressure: f64, node: &Node) -> f64 {
    let law = &problem.wear.laws[i];
    if log_pressure.abs() < 700.0 {
        return wear_rate(law, log_pressure.exp(), node.point.sliding_speed);
    }
    log_wear_rate(law, log_pressure, node.point.sliding_speed.ln()).exp()
}

/// log of the local term X_i and its factor, `None` for a body that does not contribute.
fn log_term(problem: &Problem, i: usize, log_pressure: f64, log_speed: f64) -> f64 {
    let law = &problem.wear.laws[i];
    match problem.functional {
        Functional::WearVolume => log_wear_rate(law, log_pressure, log_speed),
        Functional::WearPower | Functional::Steady => {
            log_wear_rate(law, log_pressure, log_speed) + log_pressure
        }
        Functional::FrictionPower if i == 0 => problem.friction.ln() + log_pressure + log_speed,
        _ => f64::NEG_INFINITY,
    }
}

/// J of equations (11)-(13): sum_i (int X_i^q dS)^(1/q), the maxima for q = inf, `None` for q = 0 and uniform.
fn objective(problem: &Problem, nodes: &[Node], log_pressure: &[f64]) -> Option<f64> {
    if problem.functional == Functional::Uniform || problem.functional == Functional::Steady {
        return None;
    }
    if !problem.wear.active && problem.functional != Functional::FrictionPower {
        return Some(0.0).filter(|_| problem.q != 0.0);
    }
    objective_terms(problem, nodes, log_pressure).map(|terms| terms[0] + terms[1])
}

pub(crate) fn objective_terms(
    problem: &Problem,
    nodes: &[Node],
    log_pressure: &[f64],
) -> Option<[f64; 2]> {
    let q = problem.q;
    if q == 0.0 {
        return None;
    }
    Some([0, 1].map(|i| {
        let logs = || {
            nodes.iter().zip(log_pressure).map(|(node, log)| {
                (
                    log_term(problem, i, *log, node.point.sliding_speed.ln()),
                    node.point.weight,
                )
            })
        };
        let largest = logs().map(|term| term.0).fold(f64::NEG_INFINITY, f64::max);
        if largest == f64::NEG_INFINITY || q == f64::INFINITY {
            return largest.exp();
        }
        let shift = logs()
            .map(|term| q * term.0)
            .fold(f64::NEG_INFINITY, f64::max);
        if q == f64::NEG_INFINITY || shift == f64::INFINITY {
            return logs()
                .map(|term| term.0)
                .fold(f64::INFINITY, f64::min)
                .exp();
        }
        let sum: f64 = logs()
            .map(|(log, weight)| weight * (q * log - shift).exp())
            .sum();
        ((sum.ln() + shift) / q).exp()
    }))
}

/// Multipliers from Euler's identity sum_i e_i J_i = lambda . int phi p, and the feed where the state is steady.
fn multipliers(
    stage: &Stage<'_>,
    nodes: &[Node],
    log_pressure: &[f64],
    rates: &[[f64; 2]],
    objective: Option<f64>,
) -> (Vec<f64>, Option<Vec<f64>>) {
    let problem = stage.problem;
    let gauge = stage.law.gauge_multipliers();
    let count = stage.law.count;
    // lambda_gauge . int phi p = int f p.
    let work: f64 = nodes
        .iter()
        .zip(log_pressure)
        .map(|(node, log)| node.point.weight * node.f.max(0.0) * log.exp())
        .sum();
    let scaled = |value: f64| -> Vec<f64> {
        gauge[..count]
            .iter()
            .map(|lambda| lambda * value / work)
            .collect()
    };
    if problem.functional == Functional::Steady {
        let body = |i: usize| {
            if problem.counterface == Counterface::Fresh {
                rates[i][0]
            } else {
                rates[i][0] + rates[i][1]
            }
        };
        let power: f64 = nodes
            .iter()
            .enumerate()
            .map(|(i, node)| node.point.weight * log_pressure[i].exp() * body(i))
            .sum();
        let velocity = scaled(power);
        return (velocity.clone(), Some(velocity));
    }
    let Some(value) = objective else {
        return (Vec::new(), None);
    };
    let b = problem.wear.laws.map(|law| law.pressure_exponent);
    let terms = objective_terms(problem, nodes, log_pressure).unwrap_or([value, 0.0]);
    let euler = if value == 0.0 {
        0.0
    } else {
        (0..2)
            .map(|i| problem.functional.pressure_power(b[i]) * terms[i])
            .sum()
    };
    let lambda = scaled(euler);
    let same_b = b[0] == b[1] || (0..2).any(|i| problem.wear.laws[i].factor == 0.0);
    let velocity = problem.functional == Functional::WearPower && problem.q == 1.0 && same_b;
    let wearing = if problem.wear.laws[0].factor > 0.0 {
        b[0]
    } else {
        b[1]
    };
    let feed = velocity.then(|| lambda.iter().map(|value| value / (wearing + 1.0)).collect());
    (lambda, feed)
}

/// Rate at which the gap grows at each node, by the kind of counter-face.
fn gap_rate(problem: &Problem, rates: &[f64; 2]) -> f64 {
    match problem.counterface {
        Counterface::Fresh => rates[0],
        _ => rates[0] + rates[1],
    }
}

/// ||w' - projection on the closing velocities|| / ||w'|| in the area norm.
fn steadiness(stage: &Stage<'_>, nodes: &[Node], rates: &[[f64; 2]]) -> Option<f64> {
    let count = stage.law.count;
    let problem = stage.problem;
    let mut gram = DMatrix::<f64>::zeros(count, count);
    let mut side = DVector::<f64>::zeros(count);
    let mut square = 0.0;
    let largest = rates
        .iter()
        .map(|rate| gap_rate(problem, rate))
        .fold(0.0, f64::max);
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let closing =
        |node: &Node, k: usize| problem.modes[k].motion.closing(&node.point) / stage.law.scale[k];
    for (node, rate) in nodes.iter().zip(rates) {
        let (w, weight) = (gap_rate(problem, rate) / largest, node.point.weight);
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
    for (node, rate) in nodes.iter().zip(rates) {
        let fit: f64 = (0..count).map(|k| rigid[k] * closing(node, k)).sum();
        rest += node.point.weight * (gap_rate(problem, rate) / largest - fit).powi(2);
    }
    Some((rest / square).sqrt())
}

/// Spread of the ratio w1'/w2' over its mean, equation (7).
fn congruence(problem: &Problem, nodes: &[Node], rates: &[[f64; 2]]) -> Option<f64> {
    if !(problem.wear.wears(0) && problem.wear.wears(1)) {
        return None;
    }
    let (mut weight, mut mean, mut square) = (0.0, 0.0, 0.0);
    for (node, rate) in nodes.iter().zip(rates).filter(|(_, rate)| rate[1] > 0.0) {
        let share = rate[0] / (rate[0] + rate[1]);
        weight += node.point.weight;
        mean += node.point.weight * share;
        square += node.point.weight * share * share;
    }
    let mean = mean / weight;
    Some((square / weight - mean * mean).max(0.0).sqrt() / mean)
}
