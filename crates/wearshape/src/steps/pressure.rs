//! The optimal pressure on a surface known without a mesh.

use std::f64::consts::TAU;

use hpfem::CellGrid;
use nalgebra::Vector3;
use scene::{Balance, Fault, Modes};
use wear::{Regime, Rule, Shape, SurfacePoint, WearError};

use crate::brake::{BrakeResult, brake};
use crate::faults::wrong_wear;
use crate::freedom::{Freedom, Role};
use crate::functional::kind;
use crate::options::{Options, Sampling};
use crate::problem::{Optimum, Problem};
use crate::profile::Profile;
use crate::results::{ByRole, ErrorResult, PointForce, PressureResult};
use crate::solution::{PressureMap, Status};
use crate::step::Step;
use crate::steps::{life, sensitivity};
use crate::surface::Patch;
use crate::words::{self, PointStatus};

/// The optimal pressure with its columns.
pub(crate) struct Found {
    /// How it ended, where it did not end well.
    pub ended: Option<(Status, String)>,
    pub result: PressureResult,
    pub profile: Option<Profile>,
    pub curve: Option<Profile>,
    pub map: Option<PressureMap>,
    pub error: Option<ErrorResult>,
    /// Body 1 as a brake, where a pin or a roller guides it.
    pub brake: Option<BrakeResult>,
}

/// Solves for the optimal pressure.
pub(crate) fn solve(problem: &Problem, options: &Options<'_>) -> Result<Found, Fault> {
    let Some(patch) = &problem.patch else { return Err(not_known()) };
    let wear = wear_problem(problem)?;
    let mut found = Found {
        ended: None,
        result: description(&problem.optimum),
        profile: None,
        curve: None,
        map: None,
        error: None,
        brake: None,
    };
    match wear::optimal_pressure(&wear) {
        Ok(optimum) => {
            describe(&mut found.result, &optimum, &problem.freedoms, wear.wear.active);
            let infinite = optimum.regime != Regime::Singular && infinite_at(patch, &optimum).is_some();
            if infinite {
                // What integration points near that place have is no number of the pressure.
                (found.result.p_max, found.result.p_max_at) = (None, None);
            }
            found.result.wear_rule = wear.wear.rules.iter().find_map(Rule::word);
            depths(&mut found.result, &optimum, patch);
            let at_points: Vec<f64> = optimum.points.iter().map(|point| optimum.pressure_at(point)).collect();
            found.brake = brake(problem, &optimum.points, &at_points);
            found.result.life = life::of(problem, &optimum, &patch.sample(401));
            if options.machining {
                found.result.sensitivity = sensitivity::of(problem, &wear, &optimum);
                if infinite {
                    found.result.sensitivity.iter_mut().for_each(|entry| entry.p_max_percent = None);
                }
                found.map = map(patch, &optimum);
            }
            let points = match options.sample {
                Some(Sampling::Even(count)) => patch.sample(count),
                _ => patch.towards_x(optimum.points.clone()),
            };
            found.profile = Some(profile(problem, patch, &optimum, points));
            found.curve = Some(profile(problem, patch, &optimum, patch.sample(401)));
            found.error = Some(ErrorResult {
                pressure_relative: Some(optimum.balance_residual.max(f64::EPSILON)),
                how: "closed form of the pressure; residual of the balance".into(),
                ..ErrorResult::default()
            });
        }
        Err(error) => {
            let status = match error {
                WearError::NotConverged { .. } => Status::NotConverged,
                _ => Status::Refused,
            };
            if let WearError::Infeasible { .. } = error {
                found.result.regime = Some(words::Regime::Infeasible);
            }
            found.ended = Some((status, error.to_string()));
        }
    }
    Ok(found)
}

/// Places of the surface at which a pressure is looked at.
const SAMPLES: usize = 201;

/// A place of the surface, an end or one in its middle, where a pressure is infinite; none of most.
pub(crate) fn infinite_at(patch: &Patch, optimum: &wear::Optimum) -> Option<SurfacePoint> {
    patch.surface.sample(SAMPLES).into_iter().find(|point| !optimum.pressure_at(point).is_finite())
}

fn not_known() -> Fault {
    let message = "the contact surface of this geometry is not known before it is meshed, so it has no optimal pressure yet";
    Fault::at("tasks", "not-available", message, "ask for tasks = [\"contact\"]")
}

/// Why a problem has no optimal pressure, as far as that takes a fraction of a millisecond: all of it along a line; of an area whether any pressure carries
/// the load.
pub(crate) fn unanswered(problem: &Problem) -> Option<String> {
    let known = !problem.plan.runs(Step::Force) && problem.reversing.is_none();
    let asked = problem.plan.runs(Step::Pressure) && known;
    let wear = if asked { wear_problem(problem).ok() } else { None }?;
    let on_a_line = matches!(wear.surface.shape(), Shape::Strip { .. } | Shape::Arc { .. } | Shape::Annulus { .. });
    let found = if on_a_line { wear::optimal_pressure(&wear).map(|_| ()) } else { wear::carried(&wear) };
    found.err().map(|error| error.to_string())
}

/// The problem in the words of the theory.
pub(crate) fn wear_problem(problem: &Problem) -> Result<wear::Problem, Fault> {
    let patch = problem.patch.as_ref().ok_or_else(not_known)?;
    let Optimum { functional, q, balance, modes, p_max } = problem.optimum;
    Ok(wear::Problem {
        surface: patch.surface.clone(),
        wear: problem.wear.laws.clone().map_err(|error| wrong_wear(&error))?,
        friction: problem.friction.coefficient,
        shear_in_balance: problem.friction.on_bodies,
        modes: problem.freedoms.iter().map(|freedom| freedom.mode).collect(),
        functional: kind(functional),
        q,
        balance: match balance {
            Balance::Paper => wear::Balance::Paper,
            Balance::Equilibrium => wear::Balance::Equilibrium,
        },
        mode_kind: match modes {
            Modes::Associated => wear::Modes::Associated,
            Modes::Kinematic => wear::Modes::Kinematic,
        },
        counterface: problem.wear.counterface,
        p_max,
    })
}

fn description(optimum: &Optimum) -> PressureResult {
    PressureResult {
        functional: optimum.functional,
        q: Some(optimum.q),
        balance: optimum.balance,
        modes: optimum.modes,
        ..PressureResult::default()
    }
}

pub(crate) fn by_role(values: &[f64], freedoms: &[Freedom]) -> ByRole {
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

fn describe(result: &mut PressureResult, optimum: &wear::Optimum, freedoms: &[Freedom], active: bool) {
    result.s = optimum.s;
    result.k = optimum.k;
    result.character = Some(optimum.character.into());
    result.regime = Some(optimum.regime.into());
    let atoms = optimum.limit_measure.iter();
    result.limit_measure =
        atoms.map(|atom| PointForce { x: atom.position.x, y: atom.position.y, z: atom.position.z, force: atom.force }).collect();
    result.multipliers = by_role(&optimum.multipliers, freedoms);
    result.feed = optimum.feed.as_ref().map(|feed| by_role(feed, freedoms));
    let spread = optimum.regime != Regime::Singular;
    result.p_min = Some(optimum.p_min).filter(|_| spread);
    result.p_max = Some(optimum.p_max).filter(|_| spread);
    let place = optimum.highest.position;
    result.p_max_at = Some([place.x, place.y, place.z]).filter(|_| spread && result.p_max > result.p_min);
    result.p_mean = Some(optimum.p_mean).filter(|_| spread);
    let carried = by_role(&optimum.resultants, freedoms);
    result.force = carried.force;
    result.moment = carried.moment;
    result.normal_force = Some(optimum.normal_force);
    result.wear_volume_rate = Some(optimum.wear_volume_rate);
    result.friction_power = Some(optimum.friction_power);
    result.wear_power = Some(optimum.wear_power);
    result.torque = optimum.torque;
    result.effective_radius = optimum.effective_radius;
    result.steadiness_residual = optimum.steadiness_residual.filter(|_| active);
    result.congruence_residual = optimum.congruence_residual;
}

/// Mean depth worn off both bodies, by time and by sliding distance.
fn depths(result: &mut PressureResult, optimum: &wear::Optimum, patch: &Patch) {
    let rate = optimum.wear_volume_rate / patch.surface.area();
    let sum = |value: fn(&SurfacePoint) -> f64| optimum.points.iter().map(|point| point.weight * value(point)).sum::<f64>();
    let speed = sum(|point| point.sliding_speed) / sum(|_| 1.0);
    if rate > 0.0 && speed > 0.0 {
        result.wear_depth_per_hour = Some(1e3 * 3600.0 * rate);
        result.wear_depth_per_1000_km = Some(1e9 * rate / speed);
    }
}

/// Cells along each side of the map.
const MAP: usize = 48;

/// The pressure over a surface of two dimensions; none of a line.
fn map(patch: &Patch, optimum: &wear::Optimum) -> Option<PressureMap> {
    let surface = &patch.surface;
    let between = |[from, to]: [f64; 2], t: f64| from + (to - from) * t;
    let place = |[s, t]: [f64; 2]| match surface.shape() {
        Shape::Rectangle { x, y } => Some([between(*x, s), between(*y, t)]),
        Shape::Ellipse { semi_axes: [a, b] } => {
            let (sine, cosine) = (TAU * t).sin_cos();
            Some([a * s * cosine, b * s * sine])
        }
        Shape::Sector { radii, angles } => {
            let (sine, cosine) = between(*angles, t).sin_cos();
            Some([between(*radii, s) * cosine, between(*radii, s) * sine])
        }
        Shape::Points(_) | Shape::Arc { .. } | Shape::Strip { .. } | Shape::Annulus { .. } => None,
    };
    let grid = CellGrid { degree: MAP, triangle: false };
    let position = grid.reference().map(|at| place(at.map(|t| 0.5 * (t + 1.0)))).collect::<Option<Vec<_>>>()?;
    if optimum.regime == Regime::Singular {
        return None;
    }
    let pressure = |[x, y]: &[f64; 2]| optimum.pressure_at(&surface.point(Vector3::new(*x, *y, 0.0), Vector3::z(), 0.0));
    Some(PressureMap { grid, pressure: position.iter().map(pressure).collect(), position })
}

fn profile(problem: &Problem, patch: &Patch, optimum: &wear::Optimum, points: Vec<SurfacePoint>) -> Profile {
    let s = points.iter().map(|point| patch.place(point)).collect();
    let mut profile = Profile::new(s, &points);
    if optimum.regime == Regime::Singular {
        return profile;
    }
    for (row, point) in points.iter().enumerate() {
        let pressure = optimum.pressure_at(point);
        profile.pressure[row] = pressure;
        profile.shear[row] = problem.friction.shear() * pressure;
        if let Some(rate) = problem.wear.rate(pressure, point.sliding_speed) {
            profile.wear_rate[row] = 1e3 * rate;
        }
        profile.status[row] = PointStatus::pressed(pressure > 0.0);
    }
    profile
}
