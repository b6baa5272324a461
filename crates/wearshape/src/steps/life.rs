//! How long a layer of body 1 lasts under the steady wear.
//!
//! Steady wear is the same at all times, so that a layer of thickness h lasts h / w at the place where body 1 recedes fastest, by w along its normal. The
//! run-in before it is left out: a shape that starts worn in has none. A wear factor between k (1 - e) and k (1 + e) gives a life between h / (w (1 + e))
//! and h / (w (1 - e)), since w is proportional to k and the steady pressure does not depend on it.

use std::f64::consts::TAU;

use scene::Functional;
use wear::{Regime, SurfacePoint};

use crate::problem::Problem;
use crate::results::LifeResult;

/// Seconds of an hour.
const HOUR: f64 = 3600.0;

/// The life of what may wear off; none where it is not asked for. The points of a curve find what lies between those of the integrals.
pub(super) fn of(problem: &Problem, optimum: &wear::Optimum, curve: &[SurfacePoint]) -> Option<LifeResult> {
    let wearable = problem.wear.wearable.filter(|_| problem.optimum.functional == Functional::Steady)?;
    let rule = &problem.wear.laws.as_ref().ok()?.rules[0];
    if optimum.regime == Regime::Singular {
        return None;
    }
    let rate = |point: &SurfacePoint| rule.rate(optimum.pressure_at(point), point.sliding_speed);
    let fastest = optimum.points.iter().chain(curve).map(rate).fold(0.0, f64::max);
    let seconds = Some(wearable.thickness / fastest).filter(|seconds| seconds.is_finite())?;
    let sum = |value: fn(&SurfacePoint) -> f64| optimum.points.iter().map(|point| point.weight * value(point)).sum::<f64>();
    let speed = sum(|point| point.sliding_speed) / sum(|_| 1.0);
    let omega = problem.sliding.as_ref().and_then(|sliding| sliding.omega);
    let hours = seconds / HOUR;
    Some(LifeResult {
        hours,
        distance: 1e-6 * speed * seconds,
        revolutions: omega.map(|omega| omega.0.abs() * seconds / TAU),
        friction_work: 1e-9 * optimum.friction_power * seconds,
        hours_between: wearable.spread.map(|spread| [hours / (1.0 + spread), hours / (1.0 - spread)]),
    })
}
