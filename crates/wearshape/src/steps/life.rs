//! How long a layer of body 1 lasts.
//!
//! Steady wear is the same at all times, so that a layer of thickness h lasts h / w at the place where body 1 recedes fastest, by w along its normal: the life
//! of a shape that starts worn in. A run in time from another start adds its running-in: it lasts until the layer is gone within the run, or, from its steady
//! end on, by the rate that stays. A wear factor between k (1 - e) and k (1 + e) gives a life between t / (1 + e) and t / (1 - e), since all rates are
//! proportional to k and the pressures do not depend on it.

use std::f64::consts::TAU;

use scene::Functional;
use shapeopt::{Evolution, WearState};
use wear::{Regime, SurfacePoint};

use crate::life_result::LifeResult;
use crate::problem::{Problem, Wearable};

/// Seconds of an hour.
const HOUR: f64 = 3600.0;

/// What wears steadily: the largest recession of body 1 (mm/s), the mean sliding speed (mm/s), and the friction power (mW).
pub(super) struct Steady {
    pub fastest: f64,
    pub speed: f64,
    pub friction_power: f64,
}

/// The life of what may wear off; none where it is not asked for. The points of a curve find what lies between those of the integrals.
pub(super) fn of(problem: &Problem, optimum: &wear::Optimum, curve: &[SurfacePoint]) -> Option<LifeResult> {
    problem.wear.wearable.filter(|_| problem.optimum.functional == Functional::Steady)?;
    let rule = &problem.wear.laws.as_ref().ok()?.rules[0];
    if optimum.regime == Regime::Singular {
        return None;
    }
    let rate = |point: &SurfacePoint| rule.rate(optimum.pressure_at(point), point.sliding_speed);
    let fastest = optimum.points.iter().chain(curve).map(rate).fold(0.0, f64::max);
    let sum = |value: fn(&SurfacePoint) -> f64| optimum.points.iter().map(|point| point.weight * value(point)).sum::<f64>();
    let speed = sum(|point| point.sliding_speed) / sum(|_| 1.0);
    lasting(problem, Steady { fastest, speed, friction_power: optimum.friction_power })
}

/// The life of what may wear off under steady wear; none where it is not asked for, or nothing wears.
pub(super) fn lasting(problem: &Problem, Steady { fastest, speed, friction_power }: Steady) -> Option<LifeResult> {
    let wearable = problem.wear.wearable?;
    let seconds = Some(wearable.thickness / fastest).filter(|seconds| seconds.is_finite())?;
    let [revolutions, cycles] = turns(problem, seconds);
    let hours = seconds / HOUR;
    Some(LifeResult {
        hours,
        distance: 1e-6 * speed * seconds,
        revolutions,
        cycles,
        friction_work: Some(1e-9 * friction_power * seconds),
        hours_between: between(wearable, hours),
    })
}

/// The life of what may wear off in a run in time, its running-in counted; none where it is not asked for, or the run ends before either its layer is gone or
/// its wear is steady.
pub(super) fn of_run(problem: &Problem, evolution: &Evolution<'_>, states: &[WearState]) -> Option<LifeResult> {
    let wearable = problem.wear.wearable?;
    let [seconds, distance] = evolution.worn_off(states, wearable.thickness)?;
    let [revolutions, cycles] = turns(problem, seconds);
    let hours = seconds / HOUR;
    let (distance, hours_between) = (1e-6 * distance, between(wearable, hours));
    Some(LifeResult { hours, distance, revolutions, cycles, friction_work: None, hours_between })
}

/// Turns of body 2, and cycles of a motion to and fro.
fn turns(problem: &Problem, seconds: f64) -> [Option<f64>; 2] {
    let sliding = problem.sliding.as_ref();
    let frequency = sliding.and_then(|sliding| sliding.cycle.as_ref()).and_then(|cycle| cycle.frequency);
    let omega = sliding.and_then(|sliding| sliding.omega);
    [omega.map(|omega| omega.0.abs() * seconds / TAU), frequency.map(|frequency| frequency.0 * seconds)]
}

fn between(wearable: Wearable, hours: f64) -> Option<[f64; 2]> {
    wearable.spread.map(|spread| [hours / (1.0 + spread), hours / (1.0 - spread)])
}
