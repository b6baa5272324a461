//! The optimal pressure on a surface known without a mesh.

use scene::{Balance, Fault, Functional, Modes, Pair, Scene};
use wear::{Counterface, Optimum, Regime, SurfacePoint, WearError, WearPair};

use crate::freedom::{Freedom, Role};
use crate::profile::Profile;
use crate::setup::{self, Problem};
use crate::solution::{ByRole, ErrorResult, PointForce, PressureResult, Solution, Status};
use crate::solve::{Options, Sampling};
use crate::surface::Patch;

/// Solves for the optimal pressure and fills in the profile.
pub(super) fn solve(problem: &Problem, options: Options, solution: &mut Solution) -> Result<(), Fault> {
    let Some(patch) = &problem.patch else {
        let message = "the contact surface of this geometry is not known before it is meshed, so it has no optimal pressure yet";
        return Err(Fault::at("tasks", "not-available", message, "ask for tasks = [\"contact\"]"));
    };
    let wear = wear_problem(&problem.scene, patch, &problem.freedoms)
        .map_err(|error| Fault::at("wear", "wrong-value", error.to_string(), "mend the numbers in the message"))?;
    let mut result = description(&problem.scene);
    match wear::optimal_pressure(&wear) {
        Ok(optimum) => {
            describe(&mut result, &optimum, &problem.freedoms, wear.wear.active);
            let points = match options.sample {
                Some(Sampling::Even(count)) => patch.sample(count),
                _ => patch.towards_x(optimum.points.clone()),
            };
            solution.profile = Some(profile(&wear, patch, &optimum, points));
            solution.curve = Some(profile(&wear, patch, &optimum, patch.sample(401)));
            solution.error = Some(ErrorResult {
                pressure_relative: Some(optimum.balance_residual.max(f64::EPSILON)),
                how: "closed form of the pressure; residual of the balance".into(),
                ..ErrorResult::default()
            });
        }
        Err(error) => {
            solution.status = match error {
                WearError::NotConverged { .. } => Status::NotConverged,
                _ => Status::Refused,
            };
            if let WearError::Infeasible { .. } = error {
                result.regime = "infeasible".into();
            }
            solution.reason = Some(error.to_string());
        }
    }
    solution.pressure = Some(result);
    Ok(())
}

/// The scene in the words of the theory.
pub(crate) fn wear_problem(scene: &Scene, patch: &Patch, freedoms: &[Freedom]) -> Result<wear::Problem, WearError> {
    let contact = scene.contact.as_ref();
    let friction = contact.and_then(|contact| contact.friction).unwrap_or(0.0);
    let optimum = scene.optimum.clone().unwrap_or_default();
    let functional = setup::kind(optimum.functional.unwrap_or(Functional::Steady));
    Ok(wear::Problem {
        surface: patch.surface.clone(),
        wear: wear_pair(scene, friction)?,
        friction,
        shear_in_balance: contact.and_then(|contact| contact.shear).unwrap_or(true),
        modes: freedoms.iter().map(|freedom| freedom.mode).collect(),
        functional,
        q: optimum.q.unwrap_or(1.0),
        balance: match optimum.balance {
            Some(Balance::Paper) => wear::Balance::Paper,
            _ => wear::Balance::Equilibrium,
        },
        mode_kind: match optimum.modes {
            Some(Modes::Associated) => wear::Modes::Associated,
            _ => wear::Modes::Kinematic,
        },
        counterface: match scene.wear.as_ref().and_then(|wear| wear.counterface) {
            Some(scene::Counterface::Congruent) => Counterface::Congruent,
            Some(scene::Counterface::Revolving) => Counterface::Revolving,
            _ => Counterface::Fresh,
        },
        p_max: optimum.p_max.map(|cap| cap.0),
    })
}

/// The wear rules of both bodies.
pub(crate) fn wear_pair(scene: &Scene, friction: f64) -> Result<WearPair, WearError> {
    let Some(rule) = &scene.wear else {
        return Ok(WearPair::archard([0.0; 2], [1.0; 2], [1.0; 2]));
    };
    let pair = |given: Option<Pair<f64>>| match given {
        Some(Pair::Two(values)) => values,
        Some(Pair::One(value)) => [value, value],
        None => [1.0, 1.0],
    };
    let factors = |given: Pair<scene::WearFactor>| match given {
        Pair::Two(values) => values.map(|factor| factor.value),
        Pair::One(factor) => [factor.value, 0.0],
    };
    let (a, b) = (pair(rule.a), pair(rule.b));
    match (rule.k, rule.beta) {
        (Some(k), _) => Ok(WearPair::archard(factors(k), a, b)),
        (None, Some(beta)) => WearPair::from_beta(factors(beta), friction, a, b),
        (None, None) => Ok(WearPair::archard([0.0; 2], a, b)),
    }
}

fn description(scene: &Scene) -> PressureResult {
    let optimum = scene.optimum.clone().unwrap_or_default();
    let word = |value: Option<serde_json::Value>| value.and_then(|value| value.as_str().map(str::to_string)).unwrap_or_default();
    let functional = optimum.functional.unwrap_or(Functional::Steady);
    PressureResult {
        functional: word(serde_json::to_value(functional).ok()),
        q: Some(optimum.q.unwrap_or(1.0)),
        balance: word(serde_json::to_value(optimum.balance).ok()),
        modes: word(serde_json::to_value(optimum.modes).ok()),
        ..PressureResult::default()
    }
}

fn by_role(values: &[f64], freedoms: &[Freedom]) -> ByRole {
    let mut all = ByRole::default();
    for (value, freedom) in values.iter().zip(freedoms) {
        let slot = match freedom.role {
            Role::Force => &mut all.force,
            Role::Moment => &mut all.moment,
            Role::MomentY => &mut all.moment_y,
            Role::SideForce => &mut all.side_force,
        };
        *slot = Some(*value).filter(|value| value.is_finite());
    }
    all
}

fn describe(result: &mut PressureResult, optimum: &Optimum, freedoms: &[Freedom], active: bool) {
    result.s = optimum.s;
    result.k = optimum.k;
    result.character = format!("{:?}", optimum.character).to_lowercase();
    result.regime = match optimum.regime {
        Regime::Regular => "regular",
        Regime::NearSingular => "near-singular",
        Regime::Singular => "singular",
        Regime::PartialContact => "partial-contact",
        Regime::Infeasible => "infeasible",
        Regime::Several => "several",
    }
    .into();
    let atoms = optimum.limit_measure.iter();
    result.limit_measure = atoms
        .map(|atom| PointForce { x_mm: atom.position.x, y_mm: atom.position.y, z_mm: atom.position.z, force_N: atom.force })
        .collect();
    result.multipliers = by_role(&optimum.multipliers, freedoms);
    result.feed = optimum.feed.as_ref().map(|feed| by_role(feed, freedoms));
    let spread = optimum.regime != Regime::Singular;
    result.p_min_MPa = Some(optimum.p_min).filter(|_| spread);
    result.p_max_MPa = Some(optimum.p_max).filter(|_| spread);
    result.p_mean_MPa = Some(optimum.p_mean).filter(|_| spread);
    let carried = by_role(&optimum.resultants, freedoms);
    result.force_N = carried.force;
    result.moment_Nmm = carried.moment;
    result.normal_force_N = Some(optimum.normal_force);
    result.wear_volume_rate_mm3_per_s = Some(optimum.wear_volume_rate);
    result.friction_power_mW = Some(optimum.friction_power);
    result.wear_power_mW = Some(optimum.wear_power);
    result.torque_Nmm = optimum.torque;
    result.effective_radius_mm = optimum.effective_radius;
    result.steadiness_residual = optimum.steadiness_residual.filter(|_| active);
    result.congruence_residual = optimum.congruence_residual;
}

fn profile(problem: &wear::Problem, patch: &Patch, optimum: &Optimum, points: Vec<SurfacePoint>) -> Profile {
    let s = points.iter().map(|point| patch.place(point)).collect();
    let mut profile = Profile::new(s, &points);
    if optimum.regime == Regime::Singular {
        return profile;
    }
    let shear = if problem.shear_in_balance { problem.friction } else { 0.0 };
    for (row, point) in points.iter().enumerate() {
        let pressure = optimum.pressure_at(point);
        profile.pressure[row] = pressure;
        profile.shear[row] = shear * pressure;
        let worn = (0..2).filter(|body| problem.wear.wears(*body));
        let rate: f64 = worn.map(|body| wear::wear_rate(&problem.wear.laws[body], pressure, point.sliding_speed)).sum();
        profile.wear_rate[row] = 1e3 * rate;
        profile.status[row] = if pressure > 0.0 { "contact" } else { "open" };
    }
    profile
}
