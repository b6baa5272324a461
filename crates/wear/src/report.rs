//! From a balanced density to the full answer.

use nalgebra::Vector3;

use crate::balance::Balanced;
use crate::character::{character, regime};
use crate::density::Density;
use crate::extremes::extremes;
use crate::objective::{multiplier_factor, terms};
use crate::pressure_law::Node;
use crate::recession::Recession;
use crate::reduce::wearing_powers;
use crate::stage::Stage;
use crate::steady::{congruence, gap_rate, steadiness};
use crate::{Counterface, Functional, Optimum, Problem, RigidMotion, Shape, SurfacePoint};

/// The answer for a balanced stage and its nodes.
pub(crate) fn report(stage: &mut Stage<'_>, nodes: &[Node], balanced: &Balanced, s: f64) -> Optimum {
    let problem = stage.problem;
    stage.law.log_scale = balanced.log_scale;
    let recession = mean_recession(stage);
    let stage = &*stage;
    let points: Vec<SurfacePoint> = nodes.iter().map(|node| node.point).collect();
    let log_pressure: Vec<f64> = nodes.iter().map(|node| stage.law.log_pressure(node)).collect();
    let pressure: Vec<f64> = log_pressure.iter().map(|log| log.exp()).collect();
    let rates: Vec<[f64; 2]> = nodes.iter().zip(&log_pressure).map(|(node, log)| rates(stage, *log, node)).collect();
    let gap: Vec<f64> = nodes.iter().zip(&rates).map(|(node, rate)| gap_rate(problem, &recession, node, rate)).collect();
    let integral = |value: &dyn Fn(usize, &Node) -> f64| -> f64 {
        nodes.iter().enumerate().map(|(i, node)| node.point.weight * value(i, node)).sum()
    };
    let normal_force = integral(&|i, _| pressure[i]);
    let swept = integral(&|i, node| pressure[i] * node.point.sliding_speed);
    let p_mean = normal_force / problem.surface.area();
    let extremes = extremes(stage, nodes, &pressure);
    let terms = terms(problem, &points, &log_pressure);
    let (multipliers, feed) = multipliers(stage, multiplier_factor(stage, nodes, &log_pressure, &gap, terms));
    // Where the pressure is held down, what wears there is no rigid motion.
    let feed = feed.filter(|_| nodes.iter().all(|node| node.excess <= 0.0));
    let carried = |motion: RigidMotion| integral(&|i, node| pressure[i] * motion.force_weight(&node.point, stage.law.friction));
    let turning = turning(problem);
    Optimum {
        s: Some(s).filter(|s| !s.is_nan()),
        k: exponent(&stage.law.density),
        character: character(stage, nodes, s),
        regime: regime(stage, s, extremes.high, p_mean),
        limit_measure: Vec::new(),
        feed,
        multipliers,
        objective: terms.map(|terms| terms[0] + terms[1]),
        wear_volume_rate: integral(&|i, _| rates[i][0] + rates[i][1]),
        friction_power: problem.friction * swept,
        wear_power: integral(&|i, _| pressure[i] * (rates[i][0] + rates[i][1])),
        p_min: extremes.low,
        p_max: extremes.high,
        p_mean,
        normal_force,
        resultants: problem.modes.iter().map(|mode| carried(mode.motion)).collect(),
        torque: turning.map(|omega| problem.friction * swept / omega),
        effective_radius: turning.map(|omega| swept / omega / pressing(problem, normal_force)),
        steadiness_residual: steadiness(stage, nodes, &gap, &recession),
        congruence_residual: congruence(problem, nodes, &rates),
        iterations: balanced.iterations,
        balance_residual: balanced.residual,
        points,
        pressure,
        log_pressure,
        highest: extremes.highest,
        law: stage.law.clone(),
    }
}

/// The multipliers, none without a factor between those of the law's gauge and dJ/dF_k, and the feed where the state is steady.
fn multipliers(stage: &Stage<'_>, factor: Option<f64>) -> (Vec<f64>, Option<Vec<f64>>) {
    let Some(factor) = factor else { return (Vec::new(), None) };
    let gauge = stage.law.gauge_multipliers();
    let multipliers: Vec<f64> = gauge.iter().take(stage.law.count).map(|lambda| lambda * factor).collect();
    let feed = feed_share(stage.problem).map(|share| multipliers.iter().map(|value| value * share).collect());
    (multipliers, feed)
}

/// Body 2's mean wear along its tracks under the present pressure.
fn mean_recession(stage: &mut Stage<'_>) -> Recession {
    let problem = stage.problem;
    if matches!(stage.law.density, Density::Receding { .. }) {
        return stage.law.recession;
    }
    let mut recession = Recession::none(&problem.surface);
    if problem.counterface == Counterface::Revolving && problem.wear.wears(1) {
        recession = if matches!(problem.surface.shape(), Shape::Annulus { .. }) { recession } else { stage.measured_recession() };
    }
    recession
}

/// Wear rates of both bodies at a node.
fn rates(stage: &Stage<'_>, log_pressure: f64, node: &Node) -> [f64; 2] {
    [0, 1].map(|i| rate(stage.problem, i, log_pressure, node))
}

/// Wear rate of a body at a node, also where p itself overflows.
fn rate(problem: &Problem, i: usize, log_pressure: f64, node: &Node) -> f64 {
    let rule = &problem.wear.rules[i];
    if !problem.wear.wears(i) {
        return 0.0;
    }
    if log_pressure.abs() < 700.0 {
        return rule.rate(log_pressure.exp(), node.point.sliding_speed);
    }
    rule.log_rate(log_pressure, node.point.sliding_speed).exp()
}

fn exponent(density: &Density) -> Option<f64> {
    match density {
        Density::Power { k, .. } | Density::Mixed { k, .. } => Some(*k),
        Density::Receding { m, .. } => Some(1.0 / m),
        Density::Exponential | Density::BangBang { .. } | Density::Given(_) | Density::Sum { .. } => None,
    }
}

/// Angular velocity where body 2 only turns.
pub(crate) fn turning(problem: &Problem) -> Option<f64> {
    let motion = problem.surface.motion();
    let omega = motion.angular_velocity.norm();
    (omega > 0.0 && motion.velocity == Vector3::zeros()).then_some(omega)
}

/// Force the load presses with: the resultant of the translation, else int p dS.
pub(crate) fn pressing(problem: &Problem, normal_force: f64) -> f64 {
    problem
        .modes
        .iter()
        .find(|mode| matches!(mode.motion, RigidMotion::Translation { .. }))
        .map_or(normal_force, |mode| mode.resultant)
}

/// Rigid velocity of wear over multiplier: 1 in the steady state, 1/(b+1) for the wear power with q = 1 and b1 = b2.
fn feed_share(problem: &Problem) -> Option<f64> {
    if problem.functional == Functional::Steady {
        return Some(1.0);
    }
    let first = wearing_powers(problem).next().map_or(problem.wear.powers()[0], |(_, law)| law);
    let b = first.pressure_exponent;
    let same = wearing_powers(problem).all(|(_, law)| law.pressure_exponent == b);
    let powers = !problem.wear.has_other();
    let velocity = problem.functional == Functional::WearPower && problem.q == 1.0 && same && powers && problem.p_max.is_none();
    velocity.then(|| 1.0 / (b + 1.0))
}
