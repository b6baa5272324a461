//! From a problem to its answer.

use crate::cap::is_too_low;
use crate::density::Density;
use crate::newton::not_carried;
use crate::ratio;
use crate::reduce::{Task, reduce};
use crate::report::report;
use crate::singular::{LimitSide, carries, limit};
use crate::singular_report::singular_report;
use crate::solve::balance_any;
use crate::stage::Stage;
use crate::surface::TRACK;
use crate::why::{ALL_CLOSED, CAPPED, ON_THE_EDGE};
use crate::{Optimum, Problem, Regime, WearError};

/// Optimal pressure of a problem: the stationary pressure of its functional, the steady state, or the limit where there is no pressure.
///
/// Where several pressures are stationary the one with the smallest functional is returned, with the regime `Several`. The steady state under
/// a rule of one's own is that of the whole surface above its threshold: below it nothing moves and wear does not determine the pressure.
///
/// # Errors
/// [`WearError::OutOfRange`] and [`WearError::Modes`] for numbers and modes that make no problem; [`WearError::NoWear`] where no body wears that
/// would determine the pressure; [`WearError::MixedExponents`] and [`WearError::OwnRule`] for what this crate does not answer;
/// [`WearError::Infeasible`] for a load that no pressure carries; [`WearError::Unresolved`] and [`WearError::NotConverged`] where the numbers
/// end.
pub fn optimal_pressure(problem: &Problem) -> Result<Optimum, WearError> {
    problem.check()?;
    if let Task::Density { density, s } = reduce(problem)? {
        return solve(problem, density, s);
    }
    let mut all = stationary_pressures(problem)?;
    let several = all.len() > 1;
    let value = |optimum: &Optimum| optimum.objective.unwrap_or(f64::INFINITY);
    let least = (0..all.len()).min_by(|a, b| value(&all[*a]).total_cmp(&value(&all[*b])));
    let mut best = all.swap_remove(least.unwrap_or(0));
    if several {
        best.regime = Regime::Several;
    }
    Ok(best)
}

/// Refuses a load that no pressure p >= 0 on the surface carries, or none up to `p_max`, without a search for the optimal one: a fraction of a millisecond.
/// What passes may still have no stationary pressure.
///
/// # Errors
/// [`WearError::Infeasible`] for such a load; [`WearError::OutOfRange`] and [`WearError::Modes`] for numbers and modes that make no problem.
pub fn carried(problem: &Problem) -> Result<(), WearError> {
    problem.check()?;
    let stage = Stage::new(problem, Density::BangBang { speed_power: 0.0 })?;
    if is_too_low(&stage) {
        return Err(stage.infeasible(CAPPED));
    }
    if carries(&stage) { Ok(()) } else { Err(not_carried(&stage)) }
}

/// All stationary pressures found: more than one is possible for the wear volume with b < 1, s > 1 and a1 != a2.
///
/// # Errors
/// Those of [`optimal_pressure`].
pub fn stationary_pressures(problem: &Problem) -> Result<Vec<Optimum>, WearError> {
    problem.check()?;
    match reduce(problem)? {
        Task::Density { density, s } => Ok(vec![solve(problem, density, s)?]),
        Task::Ratio(ratio) => {
            let (mut found, mut nodes) = (Vec::new(), Vec::new());
            for delta in ratio::roots(problem, &ratio)? {
                let (mut stage, balanced) = ratio::at(problem, &ratio, delta, &mut nodes)?;
                let s = if ratio.s[0] == ratio.s[1] { ratio.s[0] } else { f64::NAN };
                found.push(report(&mut stage, &nodes, &balanced, s));
            }
            if found.is_empty() {
                return Err(WearError::NotConverged { iterations: 0, residual: f64::NAN });
            }
            Ok(found)
        }
        Task::Linear { speed_power } => Ok(vec![linear(problem, speed_power)?]),
        Task::Revolving => Ok(vec![revolving(problem)?]),
    }
}

/// Body 2 recedes by its mean wear along its tracks.
fn revolving(problem: &Problem) -> Result<Optimum, WearError> {
    let front = problem.wear.powers()[0];
    if front.factor == 0.0 {
        return Err(WearError::NoWear {
            functional: "steady with a revolving counterface",
            remedy: "body 1 must wear: body 2's mean wear is uniform along its track whatever the pressure",
        });
    }
    let tracked = matches!(problem.surface.shape(), crate::Shape::Sector { .. });
    if !tracked && problem.surface.track_area().is_none() {
        let wanted = "given for a surface that is neither arc nor sector";
        return Err(WearError::OutOfRange { name: TRACK, value: f64::NAN, wanted });
    }
    let density = Density::Receding { log_weight: front.factor.ln(), power: front.speed_exponent, m: front.pressure_exponent };
    solve(problem, density, front.pressure_exponent + 1.0)
}

fn solve(problem: &Problem, density: Density, s: f64) -> Result<Optimum, WearError> {
    let mut stage = Stage::new(problem, density)?;
    let mut nodes = Vec::new();
    let balanced = balance_any(&mut stage, &mut nodes)?;
    // The limits of large and of low exponents are one where f > 0 alone.
    if s == f64::NEG_INFINITY && (stage.open_at_ends() || nodes.iter().any(|node| node.f <= 0.0)) {
        return Err(stage.infeasible(if stage.law.count == 1 { ALL_CLOSED } else { ON_THE_EDGE }));
    }
    Ok(report(&mut stage, &nodes, &balanced, s))
}

/// s = 1: concentrated forces, or, where g is the pivot mode itself (no place is preferred), the common limit of both sides.
fn linear(problem: &Problem, speed_power: f64) -> Result<Optimum, WearError> {
    let stage = Stage::new(problem, Density::BangBang { speed_power })?;
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    problem.surface.survey(&mut |point| {
        let cost = (point.sliding_speed / stage.law.reference_speed).powf(speed_power);
        let ratio = cost / stage.law.mode_values(point).phi[stage.law.pivot];
        (low, high) = (low.min(ratio), high.max(ratio));
    });
    if low > 0.0 && high - low <= 1e-13 * high {
        return solve(problem, Density::Exponential, 1.0);
    }
    if problem.p_max.is_some() {
        return solve(problem, Density::BangBang { speed_power }, 1.0);
    }
    let atoms = limit(&stage, speed_power, LimitSide::Above)?;
    Ok(singular_report(&stage, &atoms, 1.0))
}
