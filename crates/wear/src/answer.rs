//! The answer: a pressure with everything that is to be said about it.

use nalgebra::Vector3;

use crate::SurfacePoint;
use crate::pressure_law::PressureLaw;

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
    /// A place of the largest pressure.
    pub highest: SurfacePoint,
    pub(crate) law: PressureLaw,
}

impl Optimum {
    /// log p at any point of the same surface, from the closed form of the solution.
    pub fn log_pressure_at(&self, point: &SurfacePoint) -> f64 {
        if self.regime == Regime::Singular {
            return f64::NEG_INFINITY;
        }
        let node = self.law.node(*point);
        if self.law.is_round_off(&node) { f64::NEG_INFINITY } else { self.law.log_pressure(&node) }
    }

    /// Whether the closed form has a pressure at a point, however little it is: its ends are where this changes.
    pub fn presses_at(&self, point: &SurfacePoint) -> bool {
        self.regime != Regime::Singular && self.law.node(*point).log_h > f64::NEG_INFINITY
    }

    /// Whether the largest admissible pressure holds the closed form down at a point: where this changes the pressure has a kink.
    pub fn is_capped_at(&self, point: &SurfacePoint) -> bool {
        self.regime != Regime::Singular && self.law.node(*point).excess > 0.0
    }

    /// Pressure in MPa at any point of the same surface.
    pub fn pressure_at(&self, point: &SurfacePoint) -> f64 {
        self.log_pressure_at(point).exp()
    }
}
