//! The answer: a pressure with everything that is to be said about it.

use nalgebra::Vector3;

use crate::density::Density;
use crate::ratio;
use crate::reduce::{Task, reduce};
use crate::report::{report, singular_report};
use crate::singular::{LimitSide, limit};
use crate::solve::balance_any;
use crate::stage::{PressureLaw, Stage};
use crate::{Problem, SurfacePoint, WearError, Workspace};

/// Second-order character of a stationary pressure, said only where it is proved ("What is said about an answer" in README).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Character {
    /// Global minimum of the functional.
    Minimum,
    /// Global maximum of the functional.
    Maximum,
    /// The functional has the same value for every admissible pressure.
    Indifferent,
    /// Stationary; nothing more is proved, or there is no functional behind it (kinematic modes with psi != phi).
    Stationary,
}

/// What kind of solution it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime {
    /// Pressure on the whole surface, no concentration.
    Regular,
    /// Pressure concentrated because s is close to 1.
    NearSingular,
    /// Forces on points or lines instead of a pressure: see `limit_measure`.
    Singular,
    /// p = 0 on a part of the surface.
    PartialContact,
    /// No admissible pressure exists.
    Infeasible,
    /// More than one stationary pressure; the one with the least functional is given.
    Several,
}

/// A concentrated force of a singular solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointForce {
    /// Where, in mm. In plane scenes a line along y, on a ring a circle through this point.
    pub position: Vector3<f64>,
    /// Normal force there in N.
    pub force: f64,
}

/// Optimal pressure and what follows from it.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// Quadrature points (of a list of points: the points themselves), weights in mm^2.
    pub points: Vec<SurfacePoint>,
    /// Pressure at the points in MPa; zero where there is no contact, and everywhere when the regime is singular.
    pub pressure: Vec<f64>,
    /// Natural logarithm of the pressure in MPa: usable where the pressure itself overflows or vanishes.
    pub log_pressure: Vec<f64>,
    /// s = e q; `None` where the bodies have different ones.
    pub s: Option<f64>,
    /// k = 1/(s - 1).
    pub k: Option<f64>,
    /// Second-order character.
    pub character: Character,
    /// Regime.
    pub regime: Regime,
    /// Concentrated forces of a singular solution.
    pub limit_measure: Vec<PointForce>,
    /// Multiplier of each mode, dJ/dF_k (for `Steady` the feed itself).
    pub multipliers: Vec<f64>,
    /// Rigid velocity of wear in each mode, mm/s or rad/s, where the state is steady.
    pub feed: Option<Vec<f64>>,
    /// Value of the functional with its q; `None` where it is not defined (q = 0, uniform).
    pub objective: Option<f64>,
    /// int sum_i w_i' dS in mm^3/s.
    pub wear_volume_rate: f64,
    /// int mu p v dS in mW (N mm/s).
    pub friction_power: f64,
    /// int p sum_i w_i' dS in mW.
    pub wear_power: f64,
    /// Smallest pressure in MPa.
    pub p_min: f64,
    /// Largest pressure in MPa.
    pub p_max: f64,
    /// Mean pressure int p dS / area in MPa.
    pub p_mean: f64,
    /// int p dS in N.
    pub normal_force: f64,
    /// Resultants actually carried by the modes, friction included as in the balance of forces: int psi_k p dS.
    pub resultants: Vec<f64>,
    /// Friction torque about the axis of rotation in N mm, where body 2 turns.
    pub torque: Option<f64>,
    /// Torque over mu times the pressing force in mm.
    pub effective_radius: Option<f64>,
    /// ||w' - rigid part|| / ||w'|| over the surface; zero in a steady state.
    pub steadiness_residual: Option<f64>,
    /// Spread of w1'/w2' over the surface relative to its mean, equation (7); `None` unless both bodies wear.
    pub congruence_residual: Option<f64>,
    /// Newton iterations.
    pub iterations: usize,
    /// Relative residual of the balance.
    pub balance_residual: f64,
    pub(crate) law: PressureLaw,
}

impl Optimum {
    /// log p at any point of the same surface, from the closed form of the solution.
    pub fn log_pressure_at(&self, point: &SurfacePoint) -> f64 {
        if self.regime == Regime::Singular {
            return f64::NEG_INFINITY;
        }
        self.law.log_pressure(&self.law.node(*point))
    }

    /// Pressure in MPa at any point of the same surface.
    pub fn pressure_at(&self, point: &SurfacePoint) -> f64 {
        self.log_pressure_at(point).exp()
    }

    /// The stationarity function f = sum_k lambda_k phi_k at a point, in the gauge of the multipliers; negative where the gap opens.
    pub fn force_function_at(&self, point: &SurfacePoint) -> f64 {
        self.multipliers.iter().zip(&self.law.modes).map(|(lambda, mode)| lambda * mode.motion.closing(point)).sum()
    }
}

/// Optimal pressure of a problem: the stationary pressure of its functional, the steady state, or the limit where there is no pressure.
///
/// Where several pressures are stationary the one with the smallest functional is returned, with the regime `Several`.
pub fn optimal_pressure(problem: &Problem) -> Result<Optimum, WearError> {
    optimal_pressure_with(problem, &mut Workspace::default())
}

/// The same with memory of the caller, for sweeps.
pub fn optimal_pressure_with(problem: &Problem, work: &mut Workspace) -> Result<Optimum, WearError> {
    problem.check()?;
    if let Task::Density { density, s } = reduce(problem)? {
        return solve(problem, density, s, work);
    }
    let mut all = stationary_pressures(problem)?;
    let several = all.len() > 1;
    let value = |optimum: &Optimum| optimum.objective.unwrap_or(f64::INFINITY);
    all.sort_by(|a, b| value(a).total_cmp(&value(b)));
    let mut best = all.swap_remove(0);
    if several {
        best.regime = Regime::Several;
    }
    Ok(best)
}

/// All stationary pressures found: more than one is possible for the wear volume with b < 1, s > 1 and a1 != a2.
pub fn stationary_pressures(problem: &Problem) -> Result<Vec<Optimum>, WearError> {
    problem.check()?;
    let mut work = Workspace::default();
    match reduce(problem)? {
        Task::Density { density, s } => Ok(vec![solve(problem, density, s, &mut work)?]),
        Task::Ratio(ratio) => {
            let mut found = Vec::new();
            for delta in ratio::roots(problem, &ratio)? {
                let (mut stage, balanced) = ratio::at(problem, &ratio, delta, &mut work.nodes)?;
                let s = if ratio.s[0] == ratio.s[1] { ratio.s[0] } else { f64::NAN };
                found.push(report(&mut stage, &mut work, &balanced, s));
            }
            if found.is_empty() {
                return Err(WearError::NotConverged { iterations: 0, residual: f64::NAN });
            }
            Ok(found)
        }
        Task::Linear { speed_power } => Ok(vec![linear(problem, speed_power, &mut work)?]),
        Task::Revolving => {
            let front = problem.wear.laws[0];
            if front.factor == 0.0 {
                return Err(WearError::NoWear {
                    functional: "steady with a revolving counterface",
                    remedy: "body 1 must wear: body 2's mean wear is uniform along its track whatever the pressure",
                });
            }
            let tracked = matches!(problem.surface.shape(), crate::Shape::Sector { .. });
            if problem.surface.track_area().is_none() && !tracked {
                return Err(WearError::OutOfRange {
                    name: "track area of the revolving counterface",
                    value: f64::NAN,
                    wanted: "given for a surface that is neither arc nor sector",
                });
            }
            let density =
                Density::Receding { log_weight: front.factor.ln(), power: front.speed_exponent, m: front.pressure_exponent };
            Ok(vec![solve(problem, density, front.pressure_exponent + 1.0, &mut work)?])
        }
    }
}

fn solve(problem: &Problem, density: Density, s: f64, work: &mut Workspace) -> Result<Optimum, WearError> {
    let mut stage = Stage::new(problem, density)?;
    let balanced = balance_any(&mut stage, &mut work.nodes)?;
    Ok(report(&mut stage, work, &balanced, s))
}

/// s = 1: concentrated forces, or, where g is the pivot mode itself (no place is preferred), the common limit of both sides.
fn linear(problem: &Problem, speed_power: f64, work: &mut Workspace) -> Result<Optimum, WearError> {
    let stage = Stage::new(problem, Density::BangBang { speed_power })?;
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    problem.surface.survey(&mut |point| {
        let cost = (point.sliding_speed / stage.law.reference_speed).powf(speed_power);
        let ratio = cost / stage.law.mode_values(point).phi[stage.law.pivot];
        (low, high) = (low.min(ratio), high.max(ratio));
    });
    if low > 0.0 && high - low <= 1e-13 * high {
        return solve(problem, Density::Exponential, 1.0, work);
    }
    if problem.p_max.is_some() {
        return solve(problem, Density::BangBang { speed_power }, 1.0, work);
    }
    let limit = limit(&stage, speed_power, LimitSide::Above)?;
    Ok(singular_report(&stage, &limit, 1.0))
}
