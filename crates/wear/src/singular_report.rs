//! The answer where there is no pressure: forces on points or lines.

use crate::pressure_law::Node;
use crate::report::{pressing, turning};
use crate::singular::Atoms;
use crate::stage::Stage;
use crate::{Character, Modes, Optimum, PointForce, Regime};

/// Places at which the modes are compared with their balance.
const PLACES: usize = 201;

/// A problem without pressure: forces on points or lines.
pub(crate) fn singular_report(stage: &Stage<'_>, atoms: &Atoms, s: f64) -> Optimum {
    let problem = stage.problem;
    let normal_force: f64 = atoms.iter().map(|atom| atom.1).sum();
    let swept: f64 = atoms.iter().map(|(point, force)| point.sliding_speed * force).sum();
    // Powers of p other than the first are not defined on concentrated forces.
    let linear = |power: f64, value: f64| if power == 1.0 { value } else { f64::NAN };
    let wear: f64 = (0..2)
        .filter(|i| problem.wear.wears(*i))
        .map(|i| {
            let Some(law) = problem.wear.rules[i].power() else { return f64::NAN };
            let sum = atoms.iter().map(|(p, force)| law.factor * force * p.sliding_speed.powf(law.speed_exponent));
            linear(law.pressure_exponent, sum.sum())
        })
        .sum();
    // Under kinematic modes whose balance is not theirs the limit is that of the conditions, and another one may take less.
    let places: Vec<Node> = problem.surface.sample(PLACES).into_iter().map(|point| stage.law.node(point)).collect();
    let least = problem.mode_kind == Modes::Associated || stage.symmetric(&places);
    let turning = turning(problem);
    Optimum {
        points: Vec::new(),
        pressure: Vec::new(),
        log_pressure: Vec::new(),
        s: Some(s),
        k: None,
        character: if least { Character::Minimum } else { Character::Stationary },
        regime: Regime::Singular,
        limit_measure: atoms.iter().map(|(point, force)| PointForce { position: point.position, force: *force }).collect(),
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
            .map(|mode| atoms.iter().map(|(p, force)| force * mode.motion.force_weight(p, stage.law.friction)).sum())
            .collect(),
        torque: turning.map(|omega| problem.friction * swept / omega),
        effective_radius: turning.map(|omega| swept / omega / pressing(problem, normal_force)),
        steadiness_residual: None,
        congruence_residual: None,
        iterations: 0,
        balance_residual: 0.0,
        highest: stage.problem.surface.at(0.0, 0.0),
        law: stage.law.clone(),
    }
}
