//! Continuation in the exponent: warm starts along q, and the way round for a Newton iteration that fails from its first guess.

use crate::density::Density;
use crate::reduce::{Task, reduce};
use crate::report::report;
use crate::solve::{Balanced, balance, balance_any};
use crate::stage::{Node, Stage};
use crate::{Optimum, Problem, WearError, Workspace, optimal_pressure_with};

/// Optima of the same problem for several q, each started from the multipliers of the one before. The bends k y of the solution are
/// carried over, which have a finite limit as s -> 1.
pub fn optima_over_q(problem: &Problem, values: &[f64]) -> Vec<Result<Optimum, WearError>> {
    let mut work = Workspace::default();
    let mut case = problem.clone();
    let mut before: Option<(f64, crate::stage::PressureLaw)> = None;
    let mut answers = Vec::with_capacity(values.len());
    for q in values {
        case.q = *q;
        let answer = next(&case, before, &mut work);
        if let Ok(optimum) = &answer {
            before = optimum.k.filter(|k| *k != 0.0).map(|k| (k, optimum.law));
        }
        answers.push(answer);
    }
    answers
}

fn next(problem: &Problem, before: Option<(f64, crate::stage::PressureLaw)>, work: &mut Workspace) -> Result<Optimum, WearError> {
    problem.check()?;
    if let (Task::Density { density: Density::Power { k, speed_power }, s }, Some((old, law))) = (reduce(problem)?, before)
        && k != 0.0
    {
        let mut stage = Stage::new(problem, Density::Power { k, speed_power })?;
        stage.law.y = law.y.map(|y| y * old / k);
        if (k > 0.0 || !stage.open_at_ends())
            && let Ok(balanced) = balance_any(&mut stage, &mut work.nodes)
        {
            return Ok(report(&mut stage, work, &balanced, s));
        }
    }
    optimal_pressure_with(problem, work)
}

/// Reaches the exponent k from 1 (s = 2) or -1 (s = 0, the analytic centre, which exists for every load inside the moment cone) in
/// steps, when the direct iteration has failed.
pub(crate) fn balance_by_continuation(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<Balanced, WearError> {
    let target = stage.law.density;
    let (Density::Power { k, .. } | Density::Mixed { k, .. }) = target else {
        return Err(WearError::NotConverged { iterations: 0, residual: f64::NAN });
    };
    let steps = (3.0 * k.abs().ln().abs()).ceil().clamp(3.0, 24.0) as i32;
    stage.law.y = Default::default();
    let mut last = k.signum();
    for step in 0..=steps {
        let here = k.signum() * k.abs().powf(f64::from(step) / f64::from(steps));
        stage.law.density = if step == steps { target } else { with_exponent(target, k, here) };
        if step > 0 {
            // Towards small k the ends of contact settle, not the bends k y.
            let ratio = if k.abs() > 1.0 { last / here } else { 1.0 };
            stage.law.y = stage.law.y.map(|y| y * ratio);
        }
        last = here;
        let balanced = balance(stage, nodes);
        if step == steps {
            return balanced;
        }
        match balanced {
            // A step that has stalled close to its solution is good enough to go on from.
            Ok(_) | Err(WearError::NotConverged { .. }) => {}
            Err(other) => return Err(other),
        }
    }
    Err(WearError::NotConverged { iterations: 0, residual: f64::NAN })
}

/// The same density with another exponent of f, the share of the speed kept.
fn with_exponent(density: Density, k: f64, here: f64) -> Density {
    match density {
        Density::Power { speed_power, .. } => Density::Power { k: here, speed_power: speed_power * here / k },
        Density::Mixed { log_theta, powers, .. } => Density::Mixed { k: here, log_theta, powers },
        other => other,
    }
}
