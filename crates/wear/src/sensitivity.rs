//! Derivatives of the answer with respect to the data, by differentiating the stationarity condition and the balance.
//!
//! With p = C f^k (v/v_ref)^(-A), f = lambda . phi: d log p = dk log f + k df/f - dA log(v/v_ref), and d lambda follows from
//! int psi_j p d log p dS + int d psi_j p dS = dF_j.

use nalgebra::{DMatrix, DVector};

use crate::density::Density;
use crate::report::{pressing, turning};
use crate::{Balance, Functional, Modes, Optimum, Problem, RigidMotion, SurfacePoint, wear_rate};

/// A datum of the problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// Friction coefficient mu, also in beta mu^b where the factors are made of it.
    Friction,
    /// Pressure exponent b of both bodies, at constant beta or k.
    PressureExponent,
    /// Speed exponent a of both bodies.
    SpeedExponent,
    /// Natural logarithm of the wear factors of both bodies.
    LogWearFactor,
    /// Resultant of the mode with this index: force or moment.
    Resultant(usize),
}

/// Derivatives of an optimum with respect to one parameter. What is zero for `LogWearFactor` does not depend on beta: pressure,
/// friction power, torque and effective radius.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// d log p at the points of the optimum.
    pub log_pressure: Vec<f64>,
    /// Of the wear volume rate.
    pub wear_volume_rate: f64,
    /// Of the friction power.
    pub friction_power: f64,
    /// Of the wear power.
    pub wear_power: f64,
    /// Of the torque.
    pub torque: Option<f64>,
    /// Of the effective radius.
    pub effective_radius: Option<f64>,
    /// Of the feed of each mode; the time to a depth is depth/feed, so its logarithm has minus the derivative of log feed.
    pub feed: Option<Vec<f64>>,
}

/// Derivatives of `optimum`, the answer to `problem`. `None` where p is not a power of f and v by one common rule (two bodies with
/// different exponents, revolving counter-face, pressure cap) or there is no density.
pub fn sensitivity(problem: &Problem, optimum: &Optimum, parameter: Parameter) -> Option<Sensitivity> {
    let Density::Power { k, .. } = optimum.law.density else {
        return None;
    };
    let count = problem.modes.len();
    if optimum.law.absolute || optimum.points.is_empty() || (k == 0.0 && count > 1) {
        return None;
    }
    let (dk, da) = exponent_changes(problem, k, parameter);
    let gauge = optimum.law.gauge_multipliers();
    let d_psi = |k: usize, point: &SurfacePoint| match (parameter, problem.balance, problem.modes[k].motion) {
        (Parameter::Friction, Balance::Equilibrium, motion) if problem.shear_in_balance => {
            -point.drag.dot(&motion.displacement(&point.position))
        }
        _ => 0.0,
    };
    let psi = |k: usize, point: &SurfacePoint| match (problem.balance, problem.modes[k].motion) {
        (Balance::Paper, RigidMotion::Translation { .. }) => 1.0,
        (Balance::Paper, motion) => motion.closing(point),
        (_, motion) => motion.force_weight(point, optimum.law.friction),
    };
    let associated = problem.mode_kind == Modes::Associated;
    let phi = |k: usize, point: &SurfacePoint| {
        if associated { psi(k, point) } else { problem.modes[k].motion.closing(point) }
    };
    // Known part of d log p, then the matrix for the change of the multipliers (k = 0: of the common factor).
    let known: Vec<f64> = optimum
        .points
        .iter()
        .map(|point| {
            let f: f64 = (0..count).map(|i| gauge[i] * phi(i, point)).sum();
            if f <= 0.0 {
                return 0.0;
            }
            let bent: f64 = if associated { (0..count).map(|i| gauge[i] * d_psi(i, point)).sum() } else { 0.0 };
            let speed = if da == 0.0 { 0.0 } else { da * (point.sliding_speed / optimum.law.reference_speed).ln() };
            dk * f.ln() + k * bent / f - speed
        })
        .collect();
    let reach = |i: usize, point: &SurfacePoint| {
        let f: f64 = (0..count).map(|i| gauge[i] * phi(i, point)).sum();
        if f <= 0.0 {
            0.0
        } else if k == 0.0 {
            1.0
        } else {
            k * phi(i, point) / f
        }
    };
    let mut matrix = DMatrix::<f64>::zeros(count, count);
    let mut side = DVector::<f64>::from_fn(count, |j, _| f64::from(u8::from(parameter == Parameter::Resultant(j))));
    for ((point, p), known) in optimum.points.iter().zip(&optimum.pressure).zip(&known) {
        for j in 0..count {
            let share = point.weight * p * psi(j, point);
            side[j] -= point.weight * p * d_psi(j, point) + share * known;
            for l in 0..count {
                matrix[(j, l)] += share * reach(l, point);
            }
        }
    }
    let change = matrix.lu().solve(&side)?;
    let log_pressure: Vec<f64> = optimum
        .points
        .iter()
        .zip(&known)
        .map(|(point, known)| known + (0..count).map(|l| reach(l, point) * change[l]).sum::<f64>())
        .collect();
    Some(assemble(problem, optimum, parameter, log_pressure, |i| if k == 0.0 { 0.0 } else { change[i] }))
}

/// dk and dA of p = C f^k v^(-A).
fn exponent_changes(problem: &Problem, k: f64, parameter: Parameter) -> (f64, f64) {
    let law = if problem.wear.laws[0].factor > 0.0 { problem.wear.laws[0] } else { problem.wear.laws[1] };
    let (q, e) = match problem.functional {
        Functional::WearVolume => (problem.q, law.pressure_exponent),
        Functional::WearPower => (problem.q, law.pressure_exponent + 1.0),
        Functional::Steady => (1.0, law.pressure_exponent + 1.0),
        Functional::FrictionPower | Functional::Uniform => return (0.0, 0.0),
    };
    let a = law.speed_exponent;
    match parameter {
        Parameter::PressureExponent if q.is_infinite() => (0.0, -a / (e * e)),
        Parameter::PressureExponent => (-k * k * q, -a * q * q * k * k),
        Parameter::SpeedExponent if q.is_infinite() => (0.0, 1.0 / e),
        Parameter::SpeedExponent => (0.0, q * k),
        _ => (0.0, 0.0),
    }
}

/// Change of the logarithm of body i's wear rate at fixed pressure.
fn rate_change(problem: &Problem, i: usize, parameter: Parameter, log_pressure: f64, log_speed: f64) -> f64 {
    let law = &problem.wear.laws[i];
    let driven = problem.wear.friction_driven;
    match parameter {
        Parameter::Friction if driven => law.pressure_exponent / problem.friction,
        Parameter::PressureExponent => log_pressure + if driven { problem.friction.ln() } else { 0.0 },
        Parameter::SpeedExponent => log_speed,
        Parameter::LogWearFactor => 1.0,
        _ => 0.0,
    }
}

fn assemble(
    problem: &Problem,
    optimum: &Optimum,
    parameter: Parameter,
    log_pressure: Vec<f64>,
    change: impl Fn(usize) -> f64,
) -> Sensitivity {
    let (mut volume, mut power, mut swept, mut d_swept) = (0.0, 0.0, 0.0, 0.0);
    for (index, point) in optimum.points.iter().enumerate() {
        let (p, change) = (optimum.pressure[index], log_pressure[index]);
        if p == 0.0 {
            continue;
        }
        swept += point.weight * p * point.sliding_speed;
        d_swept += point.weight * p * point.sliding_speed * change;
        for i in (0..2).filter(|i| problem.wear.wears(*i)) {
            let law = &problem.wear.laws[i];
            let rate = point.weight * wear_rate(law, p, point.sliding_speed);
            let own = rate_change(problem, i, parameter, p.ln(), point.sliding_speed.ln());
            let total = own + law.pressure_exponent * change;
            volume += rate * total;
            power += rate * p * (total + change);
        }
    }
    let own = if parameter == Parameter::Friction { swept } else { 0.0 };
    let friction_power = own + problem.friction * d_swept;
    let force = pressing(problem, optimum.normal_force);
    let first = problem.modes.iter().position(|mode| matches!(mode.motion, RigidMotion::Translation { .. }));
    let d_force = match (first, parameter) {
        (Some(first), Parameter::Resultant(i)) => f64::from(u8::from(i == first)),
        (Some(_), _) => 0.0,
        (None, _) => {
            let terms = optimum.points.iter().zip(&optimum.pressure).zip(&log_pressure);
            terms.map(|((point, p), change)| point.weight * p * change).sum()
        }
    };
    let omega = turning(problem);
    // Feed V = lambda sum_i bt_i v_ref^(a_i) C^(b_i): lambda changes, and the factor at fixed C.
    let reference = optimum.law.reference_speed.ln();
    let gauge = optimum.law.gauge_multipliers();
    let feed = optimum.feed.as_ref().map(|feed| {
        let active = (0..2).find(|i| problem.wear.wears(*i)).unwrap_or(0);
        let own = rate_change(problem, active, parameter, optimum.law.log_scale, reference);
        (0..feed.len())
            .map(|i| {
                let factor = feed_factor(feed, &gauge);
                change(i) * factor + feed[i] * own
            })
            .collect()
    });
    Sensitivity {
        log_pressure,
        wear_volume_rate: volume,
        friction_power,
        wear_power: power,
        torque: omega.map(|omega| friction_power / omega),
        effective_radius: omega.map(|omega| (d_swept - swept * d_force / force) / omega / force),
        feed,
    }
}

/// Feed over gauge multiplier, the same for every mode.
fn feed_factor(feed: &[f64], gauge: &[f64]) -> f64 {
    let largest = (0..feed.len()).max_by(|i, j| gauge[*i].abs().total_cmp(&gauge[*j].abs())).unwrap_or(0);
    feed[largest] / gauge[largest]
}
