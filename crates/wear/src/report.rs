//! From a balanced density to the full answer.

use nalgebra::Vector3;

use crate::character::{character, regime};
use crate::density::Density;
use crate::extremes::extremes;
use crate::objective::{multipliers, terms};
use crate::recession::Recession;
use crate::reduce::wearing;
use crate::solve::Balanced;
use crate::stage::{Node, Stage};
use crate::steady::{congruence, gap_rate, steadiness};
use crate::{
    Counterface, Functional, Optimum, Problem, Regime, RigidMotion, Shape, SurfacePoint,
    log_wear_rate, wear_rate,
};

/// The answer for a balanced stage whose `nodes` belong to it.
pub(crate) fn report(
    stage: &mut Stage<'_>,
    nodes: &[Node],
    balanced: &Balanced,
    s: f64,
) -> Optimum {
    let problem = stage.problem;
    stage.law.log_scale = balanced.log_scale;
    let recession = mean_recession(stage);
    let stage = &*stage;
    let log_pressure: Vec<f64> = nodes
        .iter()
        .map(|node| stage.law.log_pressure(node))
        .collect();
    let pressure: Vec<f64> = log_pressure.iter().map(|log| log.exp()).collect();
    let rates: Vec<[f64; 2]> = nodes
        .iter()
        .zip(&log_pressure)
        .map(|(node, log)| [0, 1].map(|i| rate(problem, i, *log, node)))
        .collect();
    let gap: Vec<f64> = nodes
        .iter()
        .zip(&rates)
        .map(|(node, rate)| gap_rate(problem, &recession, node, rate))
        .collect();
    let integral = |value: &dyn Fn(usize, &Node) -> f64| -> f64 {
        nodes
            .iter()
            .enumerate()
            .map(|(i, node)| node.point.weight * value(i, node))
            .sum()
    };
    let normal_force = integral(&|i, _| pressure[i]);
    let swept = integral(&|i, node| pressure[i] * node.point.sliding_speed);
    let p_mean = normal_force / problem.surface.area();
    let (p_min, p_max) = extremes(stage, nodes, &pressure);
    let points: Vec<SurfacePoint> = nodes.iter().map(|node| node.point).collect();
    let terms = terms(problem, &points, &log_pressure);
    let lambda = multipliers(stage, nodes, &log_pressure, &gap, terms);
    let turning = turning(problem);
    Optimum {
        points,
        s: Some(s).filter(|s| !s.is_nan()),
        k: exponent(&stage.law.density),
        character: character(stage, nodes, s),
        regime: regime(stage, s, p_max, p_mean),
        limit_measure: Vec::new(),
        feed: feed(problem, lambda.as_deref()),
        multipliers: lambda.unwrap_or_default(),
        objective: terms.map(|terms| terms[0] + terms[1]),
        wear_volume_rate: integral(&|i, _| rates[i][0] + rates[i][1]),
        friction_power: problem.friction * swept,
        wear_power: integral(&|i, _| pressure[i] * (rates[i][0] + rates[i][1])),
        p_min,
        p_max,
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
        torque: turning.map(|omega| problem.friction * swept / omega),
        effective_radius: turning.map(|omega| swept / omega / pressing(problem, normal_force)),
        steadiness_residual: steadiness(stage, &recession, nodes, &rates),
        congruence_residual: congruence(problem, nodes, &rates),
        iterations: balanced.iterations,
        balance_residual: balanced.residual,
        pressure,
        log_pressure,
        law: stage.law,
    }
}

/// Body 2's mean wear along its tracks under the present pressure.
fn mean_recession(stage: &mut Stage<'_>) -> Recession {
    let problem = stage.problem;
    if matches!(stage.law.density, Density::Receding { .. }) {
        return stage.law.recession;
    }
    let mut recession = Recession::none(&problem.surface);
    if problem.counterface == Counterface::Revolving && problem.wear.wears(1) {
        recession = if matches!(problem.surface.shape(), Shape::Annulus { .. }) {
            recession
        } else {
            stage.measured_recession()
        };
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

/// Rigid velocities of wear: the multipliers themselves in the steady state, lambda/(b+1) for the wear power with q = 1 and b1 = b2.
fn feed(problem: &Problem, lambda: Option<&[f64]>) -> Option<Vec<f64>> {
    let lambda = lambda?;
    if problem.functional == Functional::Steady {
        return Some(lambda.to_vec());
    }
    let laws = wearing(problem);
    let b = laws
        .first()
        .map_or(problem.wear.laws[0].pressure_exponent, |(_, law)| {
            law.pressure_exponent
        });
    let same = laws.iter().all(|(_, law)| law.pressure_exponent == b);
    (problem.functional == Functional::WearPower
        && problem.q == 1.0
        && same
        && problem.p_max.is_none())
    .then(|| lambda.iter().map(|value| value / (b + 1.0)).collect())
}

/// A problem without pressure: forces on points or lines.
pub(crate) fn singular_report(
    stage: &Stage<'_>,
    limit: &crate::singular::Limit,
    s: f64,
) -> Optimum {
    let problem = stage.problem;
    let normal_force: f64 = limit.atoms.iter().map(|atom| atom.1).sum();
    let swept: f64 = limit
        .atoms
        .iter()
        .map(|(point, force)| point.sliding_speed * force)
        .sum();
    // Powers of p other than the first are not defined on concentrated forces.
    let linear = |power: f64, value: f64| if power == 1.0 { value } else { f64::NAN };
    let wear: f64 = (0..2)
        .filter(|i| problem.wear.wears(*i))
        .map(|i| {
            let law = &problem.wear.laws[i];
            let sum = limit
                .atoms
                .iter()
                .map(|(p, force)| law.factor * force * p.sliding_speed.powf(law.speed_exponent));
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
            .map(|(point, force)| crate::PointForce {
                position: point.position,
                force: *force,
            })
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
            .map(|mode| {
                limit
                    .atoms
                    .iter()
                    .map(|(p, force)| force * mode.motion.force_weight(p, stage.law.friction))
                    .sum()
            })
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
