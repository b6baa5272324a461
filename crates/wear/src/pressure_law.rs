//! A pressure as a function of position: mode values at a point, the function f = lambda . phi, and the density there.

use crate::density::Density;
use crate::mode::MAX_MODES;
use crate::recession::Recession;
use crate::{Balance, Modes, RigidMode, RigidMotion, SurfacePoint};

/// What is left of a sum that vanishes, over the size of its terms: an element node on the end of a pressure is there up to the round-off of its
/// coordinates.
const ROUND_OFF: f64 = 1e-12;

/// Values of the modes at a point, each divided by its scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ModeValues {
    pub(crate) phi: [f64; MAX_MODES],
    pub(crate) psi: [f64; MAX_MODES],
}

/// A quadrature node with the density there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) point: SurfacePoint,
    pub(crate) modes: ModeValues,
    /// f in the law's gauge; <= 0 outside the contact.
    pub(crate) f: f64,
    /// log of the density up to a factor, -inf where there is none.
    pub(crate) log_h: f64,
    /// d log h / d log f.
    pub(crate) slope: f64,
    /// Distance of the uncapped density from the cap, as a logarithm; -inf without a cap.
    pub(crate) excess: f64,
    /// Inner and outer parameter, where the surface has them.
    pub(crate) parameter: [f64; 2],
}

/// A pressure as a function of position: f = side phi_p + sum_j y_j (phi_j - ratio_j phi_p) with modes divided by their scales, so that
/// lambda . F stays fixed whatever y, and log p = log_scale + log h(f, v).
#[derive(Clone, Debug)]
pub(crate) struct PressureLaw {
    pub(crate) density: Density,
    pub(crate) modes: [RigidMode; MAX_MODES],
    pub(crate) count: usize,
    pub(crate) friction: f64,
    pub(crate) balance: Balance,
    pub(crate) mode_kind: Modes,
    pub(crate) scale: [f64; MAX_MODES],
    pub(crate) ratio: [f64; MAX_MODES],
    pub(crate) pivot: usize,
    /// Sign of lambda . F: 1, or -1 where friction bends the balance so far that kinematic multipliers stand against the load.
    pub(crate) side: f64,
    pub(crate) y: [f64; MAX_MODES],
    pub(crate) reference_speed: f64,
    /// Common factor: of the pressure (`scale_free` densities) or of f.
    pub(crate) log_scale: f64,
    /// Whether `node` applies the factor and the cap.
    pub(crate) absolute: bool,
    /// log of the largest admissible pressure.
    pub(crate) log_cap: f64,
    /// Mean wear of a revolving counter-face along its tracks.
    pub(crate) recession: Recession,
}

impl PressureLaw {
    /// Prescribed resultant of a mode in the scaled modes.
    pub(crate) fn resultant(&self, k: usize) -> f64 {
        self.modes[k].resultant / self.scale[k]
    }

    pub(crate) fn mode_values(&self, point: &SurfacePoint) -> ModeValues {
        let mut values = ModeValues { phi: [0.0; MAX_MODES], psi: [0.0; MAX_MODES] };
        for (k, mode) in self.modes[..self.count].iter().enumerate() {
            let phi = mode.motion.closing(point);
            let psi = match (self.balance, mode.motion) {
                (Balance::Equilibrium, motion) => motion.force_weight(point, self.friction),
                (Balance::Paper, RigidMotion::Translation { .. }) => 1.0,
                (Balance::Paper, RigidMotion::Rotation { .. } | RigidMotion::Expansion) => phi,
            };
            values.phi[k] = if self.mode_kind == Modes::Associated { psi } else { phi } / self.scale[k];
            values.psi[k] = psi / self.scale[k];
        }
        values
    }

    /// phi_j - ratio_j phi_p.
    pub(crate) fn reduced(&self, values: &[f64; MAX_MODES], j: usize) -> f64 {
        values[j] - self.ratio[j] * values[self.pivot]
    }

    /// f and log f at a point; the logarithm keeps full accuracy where f is the pivot mode plus a small correction.
    pub(crate) fn force_function(&self, point: &SurfacePoint, values: &ModeValues) -> (f64, f64) {
        let base = self.side * values.phi[self.pivot];
        let mut correction = 0.0;
        for j in (0..self.count).filter(|j| *j != self.pivot) {
            correction += self.y[j] * self.reduced(&values.phi, j);
        }
        let f = base + correction;
        if f <= 0.0 {
            return (f, f64::NEG_INFINITY);
        }
        let near = base > 0.0 && correction.abs() < 0.5 * base;
        (f, if near { self.log_base(point, base) + (correction / base).ln_1p() } else { f.ln() })
    }

    /// log of the pivot mode's size. For a translation phi = cos(angle between normal and direction), whose logarithm is taken from the sine
    /// so that it stays exact where the cosine is next to 1 and k is large.
    fn log_base(&self, point: &SurfacePoint, base: f64) -> f64 {
        let kinematic = self.mode_kind == Modes::Kinematic || self.friction == 0.0;
        if let RigidMotion::Translation { direction } = self.modes[self.pivot].motion
            && kinematic
            && base > 0.0
        {
            let square = point.normal.cross(&direction).norm_squared();
            if square < 0.25 && (direction.norm_squared() - 1.0).abs() < 1e-15 {
                return 0.5 * (-square).ln_1p() - self.scale[self.pivot].ln();
            }
        }
        base.ln()
    }

    /// The density at a point; in an absolute law log h is log p itself.
    pub(crate) fn node(&self, point: SurfacePoint) -> Node {
        let modes = self.mode_values(&point);
        let (mut f, mut log_f) = self.force_function(&point, &modes);
        let before = if self.density.scale_free() { 0.0 } else { self.log_scale };
        match self.density {
            Density::Exponential if f > f64::NEG_INFINITY => {
                let base = modes.phi[self.pivot];
                log_f = if base > 0.0 { f / base - 1.0 } else { f64::NEG_INFINITY };
                f = base;
            }
            Density::BangBang { speed_power } => {
                let cost = if speed_power == 0.0 { 1.0 } else { (point.sliding_speed / self.reference_speed).powf(speed_power) };
                f = before.exp() * f / cost - 1.0;
                log_f = if f > 0.0 { 0.0 } else { f64::NEG_INFINITY };
            }
            Density::Receding { .. } => {
                f -= self.recession.at(&point) * (-before).exp();
                log_f = if f > 0.0 { before + f.ln() } else { f64::NEG_INFINITY };
            }
            Density::Exponential | Density::Power { .. } | Density::Mixed { .. } | Density::Given(_) | Density::Sum { .. } => {
                log_f += before
            }
        }
        let mut node =
            Node { point, modes, f, log_h: f64::NEG_INFINITY, slope: 0.0, excess: f64::NEG_INFINITY, parameter: [0.0; 2] };
        if log_f == f64::NEG_INFINITY {
            return node;
        }
        // Speeds that differ by rounding alone are equal: with |k| = 1e8 that rounding would show in the pressure.
        let ratio = point.sliding_speed / self.reference_speed;
        let log_ratio = if (ratio - 1.0).abs() <= 1e-15 { 0.0 } else { ratio.ln() };
        (node.log_h, node.slope) = self.density.log_shape(log_f, point.sliding_speed.ln(), log_ratio);
        if self.absolute {
            if self.density.scale_free() {
                node.log_h += self.log_scale;
            }
            if matches!(self.density, Density::BangBang { .. }) {
                node.log_h = self.log_cap;
            } else if self.log_cap < f64::INFINITY {
                node.excess = node.log_h - self.log_cap;
                if node.excess >= 0.0 {
                    (node.log_h, node.slope) = (self.log_cap, 0.0);
                }
            }
        }
        node
    }

    /// log p at a node made by this law.
    pub(crate) fn log_pressure(&self, node: &Node) -> f64 {
        if self.absolute { node.log_h } else { self.log_scale + node.log_h }
    }

    /// Whether f is nothing but round-off at a node: at an end of the pressure, of which a power would make much more.
    pub(crate) fn is_round_off(&self, node: &Node) -> bool {
        let term =
            |j: usize| if j == self.pivot { self.side * node.modes.phi[j] } else { self.y[j] * self.reduced(&node.modes.phi, j) };
        let jumps = matches!(self.density, Density::BangBang { .. });
        !jumps && node.f <= ROUND_OFF * (0..self.count).map(|j| term(j).abs()).sum::<f64>()
    }

    /// Multipliers in the unscaled modes, in the gauge of this law: f = sum_k lambda_k phi_k. In the limit s -> 1 where g is the pivot mode itself that is f,
    /// and the other modes, with which it would be corrected, have none.
    pub(crate) fn gauge_multipliers(&self) -> [f64; MAX_MODES] {
        let mut lambda = [0.0; MAX_MODES];
        if matches!(self.density, Density::Exponential) {
            lambda[self.pivot] = 1.0 / self.scale[self.pivot];
            return lambda;
        }
        let mut pivot = self.side;
        for j in (0..self.count).filter(|j| *j != self.pivot) {
            lambda[j] = self.y[j] / self.scale[j];
            pivot -= self.y[j] * self.ratio[j];
        }
        lambda[self.pivot] = pivot / self.scale[self.pivot];
        lambda
    }
}
