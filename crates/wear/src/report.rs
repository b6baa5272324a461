//! From a balanced density to the full answer.

use nalgebra::Vector3;

use crate::character::{character, regime};
use crate::density::Density;
use crate::extremes::extremes;
use crate::objective::{multiplier_factor, terms};
use crate::recession::Recession;
use crate::reduce::wearing;
use crate::solve::Balanced;
use crate::stage::{Node, Stage};
use crate::steady::{congruence, gap_rate, steadiness};
use crate::workspace::{Vectors, Workspace};
use crate::{Counterface, Functional, Optimum, Problem, Regime, RigidMotion, Shape, log_wear_rate, wear_rate};

/// The answer for a balanced stage whose nodes are in the workspace; its vectors come from the workspace too.
pub(crate) fn report(stage: &mut Stage<'_>, work: &mut Workspace, balanced: &Balanced, s: f64) -> Optimum {
    let problem = stage.problem;
    stage.law.log_scale = balanced.log_scale;
    let recession = mean_recession(stage);
    let stage = &*stage;
    let Workspace { nodes, rates, gap, spare } = work;
    let Vectors { mut points, mut pressure, mut log_pressure, mut multipliers, mut feed, mut resultants } = std::mem::take(spare);
    fill(&mut points, nodes.iter().map(|node| node.point));
    fill(&mut log_pressure, nodes.iter().map(|node| stage.law.log_pressure(node)));
    fill(&mut pressure, log_pressure.iter().map(|log| log.exp()));
    let rate_at = |(node, log): (&Node, &f64)| match stage.law.density {
        Density::Rule { rule } if *log > f64::NEG_INFINITY => [rule(log.exp(), node.point.sliding_speed)[0], 0.0],
        _ => [0, 1].map(|i| rate(problem, i, *log, node)),
    };
    fill(rates, nodes.iter().zip(&log_pressure).map(rate_at));
    fill(gap, nodes.iter().zip(rates.iter()).map(|(node, rate)| gap_rate(problem, &recession, node, rate)));
    let integral = |value: &dyn Fn(usize, &Node) -> f64| -> f64 {
        nodes.iter().enumerate().map(|(i, node)| node.point.weight * value(i, node)).sum()
    };
    let normal_force = integral(&|i, _| pressure[i]);
    let swept = integral(&|i, node| pressure[i] * node.point.sliding_speed);
    let p_mean = normal_force / problem.surface.area();
    let (p_min, p_max) = extremes(stage, nodes, &pressure);
    let terms = terms(problem, &points, &log_pressure);
    let factor = multiplier_factor(stage, nodes, &log_pressure, gap, terms);
    let gauge = stage.law.gauge_multipliers();
    let lambda = |count: usize| gauge.into_iter().take(count).map(|lambda| lambda * factor.unwrap_or(0.0));
    fill(&mut multipliers, lambda(if factor.is_some() { stage.law.count } else { 0 }));
    let share = feed_share(problem).filter(|_| factor.is_some());
    fill(&mut feed, multipliers.iter().map(|value| value * share.unwrap_or(0.0)));
    let carried = |motion: RigidMotion| integral(&|i, node| pressure[i] * motion.force_weight(&node.point, stage.law.friction));
    fill(&mut resultants, problem.modes.iter().map(|mode| carried(mode.motion)));
    let turning = turning(problem);
    Optimum {
        s: Some(s).filter(|s| !s.is_nan()),
        k: exponent(&stage.law.density),
        character: character(stage, nodes, s),
        regime: regime(stage, s, p_max, p_mean),
        limit_measure: Vec::new(),
        feed: share.map(|_| feed),
        multipliers,
        objective: terms.map(|terms| terms[0] + terms[1]),
        wear_volume_rate: integral(&|i, _| rates[i][0] + rates[i][1]),
        friction_power: problem.friction * swept,
        wear_power: integral(&|i, _| pressure[i] * (rates[i][0] + rates[i][1])),
        p_min,
        p_max,
        p_mean,
        normal_force,
        resultants,
        torque: turning.map(|omega| problem.friction * swept / omega),
        effective_radius: turning.map(|omega| swept / omega / pressing(problem, normal_force)),
        steadiness_residual: steadiness(stage, nodes, gap),
        congruence_residual: congruence(problem, nodes, rates),
        iterations: balanced.iterations,
        balance_residual: balanced.residual,
        points,
        pressure,
        log_pressure,
        law: stage.law,
    }
}

fn fill<T>(vector: &mut Vec<T>, values: impl Iterator<Item = T>) {
    vector.clear();
    vector.extend(values);
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

/// Wear rate of a body at a node, also where p itself overflows.
fn rate(problem: &Problem, i: usize, log_pressure: f64, node: &Node) -> f64 {
    let law = &problem.wear.laws[i];
    if !problem.wear.wears(i) {
        return 0.0;
    }
    if log_pressure.abs() < 700.0 {
        return wear_rate(law, log_pressure.exp(), node.point.sliding_speed);
    }
    log_wear_rate(law, log_pressure, node.point.sliding_speed.ln()).exp()
}

fn exponent(density: &Density) -> Option<f64> {
    match density {
        Density::Power { k, .. } | Density::Mixed { k, .. } => Some(*k),
        Density::Receding { m, .. } => Some(1.0 / m),
        _ => None,
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
    let first = wearing(problem).next().map_or(problem.wear.laws[0], |(_, law)| law);
    let b = first.pressure_exponent;
    let same = wearing(problem).all(|(_, law)| law.pressure_exponent == b);
    let velocity = problem.functional == Functional::WearPower && problem.q == 1.0 && same && problem.p_max.is_none();
    velocity.then(|| 1.0 / (b + 1.0))
}

/// A problem without pressure: forces on points or lines.
pub(crate) fn singular_report(stage: &Stage<'_>, limit: &crate::singular::Limit, s: f64) -> Optimum {
    let problem = stage.problem;
    let normal_force: f64 = limit.atoms.iter().map(|atom| atom.1).sum();
    let swept: f64 = limit.atoms.iter().map(|(point, force)| point.sliding_speed * force).sum();
    // Powers of p other than the first are not defined on concentrated forces.
    let linear = |power: f64, value: f64| if power == 1.0 { value } else { f64::NAN };
    let wear: f64 = (0..2)
        .filter(|i| problem.wear.wears(*i))
        .map(|i| {
            let law = &problem.wear.laws[i];
            let sum = limit.atoms.iter().map(|(p, force)| law.factor * force * p.sliding_speed.powf(law.speed_exponent));
            linear(law.pressure_exponent, sum.sum())
        })
        .sum();
    let turning = turning(problem);
    Optimum {
        points: Vec::new(),
        pressure: Vec::new(),
        log_pressure: Vec::new(),
        s: Some(s),
        k: None,
        character: crate::Character::Minimum,
        regime: Regime::Singular,
        limit_measure: limit
            .atoms
            .iter()
            .map(|(point, force)| crate::PointForce { position: point.position, force: *force })
            .collect(),
        multipliers: Vec::new(),
        feed: None,
        objective: None,
        wear_volume_rate: wear,
        friction_power: problem.friction * swept,
        wear_power: f64::NAN,
        p_min: 0.0,
        p_max: f64::INFINITY,
        p_mean: normal_force / problem.surface.area(),
        normal_force,
        resultants: problem
            .modes
            .iter()
            .map(|mode| limit.atoms.iter().map(|(p, force)| force * mode.motion.force_weight(p, stage.law.friction)).sum())
            .collect(),
        torque: turning.map(|omega| problem.friction * swept / omega),
        effective_radius: turning.map(|omega| swept / omega / pressing(problem, normal_force)),
        steadiness_residual: None,
        congruence_residual: None,
        iterations: 0,
        balance_residual: 0.0,
        law: stage.law,
    }
}
