//! The balance in numbers: mode values at a point, the function f = lambda . phi, and the density there.

use crate::density::Density;
use crate::quadrature::{Rule, jacobi};
use crate::recession::Recession;
use crate::{Balance, MAX_MODES, Modes, Problem, RigidMode, RigidMotion, SurfacePoint, WearError};

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

/// A pressure as a function of position: f = phi_p + sum_j y_j (phi_j - ratio_j phi_p) with modes divided by their scales, so that
/// lambda . F stays fixed whatever y, and log p = log_scale + log h(f, v).
#[derive(Clone, Copy, Debug)]
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
                (Balance::Paper, _) => phi,
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
        let base = values.phi[self.pivot];
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

    /// log of the pivot mode. For a translation phi = cos(angle between normal and direction), whose logarithm is taken from the sine
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
            _ => log_f += before,
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

    /// Multipliers in the unscaled modes, in the gauge of this law: f = sum_k lambda_k phi_k.
    pub(crate) fn gauge_multipliers(&self) -> [f64; MAX_MODES] {
        let mut lambda = [0.0; MAX_MODES];
        let mut pivot = 1.0;
        for j in (0..self.count).filter(|j| *j != self.pivot) {
            lambda[j] = self.y[j] / self.scale[j];
            pivot -= self.y[j] * self.ratio[j];
        }
        lambda[self.pivot] = pivot / self.scale[self.pivot];
        lambda
    }
}

/// What the solver works on.
#[derive(Clone, Debug)]
pub(crate) struct Stage<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) law: PressureLaw,
    /// Gauss-Jacobi rule for cells that end where f = 0.
    pub(crate) front_rule: Option<Rule>,
}

impl<'a> Stage<'a> {
    pub(crate) fn new(problem: &'a Problem, density: Density) -> Result<Self, WearError> {
        let count = problem.modes.len();
        let mut modes = [RigidMode { motion: RigidMotion::Expansion, resultant: 0.0 }; MAX_MODES];
        modes[..count].copy_from_slice(&problem.modes);
        let mut law = PressureLaw {
            density,
            modes,
            count,
            friction: if problem.shear_in_balance { problem.friction } else { 0.0 },
            balance: problem.balance,
            mode_kind: problem.mode_kind,
            scale: [1.0; MAX_MODES],
            ratio: [0.0; MAX_MODES],
            pivot: 0,
            y: [0.0; MAX_MODES],
            reference_speed: 1.0,
            log_scale: 0.0,
            absolute: false,
            log_cap: f64::INFINITY,
            recession: Recession::none(&problem.surface),
        };
        let mut largest = [0.0_f64; MAX_MODES];
        let mut smallest = f64::INFINITY;
        let mut speeds = (f64::INFINITY, 0.0_f64);
        problem.surface.survey(&mut |point| {
            let values = law.mode_values(point);
            for (most, phi) in largest[..count].iter_mut().zip(values.phi) {
                *most = most.max(phi.abs());
                smallest = smallest.min(phi);
            }
            speeds = (speeds.0.min(point.sliding_speed), speeds.1.max(point.sliding_speed));
        });
        for (k, most) in largest[..count].iter().enumerate() {
            if !(*most > 0.0 && most.is_finite()) {
                return Err(WearError::Modes { count, why: "a mode does not move the surface along its normal" });
            }
            law.scale[k] = *most;
        }
        let low = if speeds.0 > 0.0 { speeds.0 } else { speeds.1 };
        let reference = if density.falls_with_speed() { low } else { speeds.1 };
        law.reference_speed = if reference > 0.0 { reference } else { 1.0 };
        law.pivot = pivot(problem, &law)?;
        for k in 0..count {
            law.ratio[k] = law.resultant(k) / law.resultant(law.pivot);
        }
        let exponent = density.front_exponent();
        let ends = (count > 1 || smallest <= 0.0) && exponent > 0.0 && exponent <= 6.0;
        let front_rule = ends.then(|| jacobi(exponent - 1.0));
        Ok(Self { problem, law, front_rule })
    }

    /// True when f <= 0 somewhere among the ends and coarse points of the surface.
    pub(crate) fn open_at_ends(&self) -> bool {
        let mut open = false;
        self.problem.surface.survey(&mut |point| {
            open |= self.law.force_function(point, &self.law.mode_values(point)).0 <= 0.0;
        });
        open
    }

    /// True when psi = phi at every node: the stationary pressure is a true extremum (or the modes are associated).
    pub(crate) fn symmetric(&self, nodes: &[Node]) -> bool {
        let same = |node: &Node, k: usize| (node.modes.phi[k] - node.modes.psi[k]).abs() <= 1e-14;
        nodes.iter().all(|node| (0..self.law.count).all(|k| same(node, k)))
    }
}

/// The mode whose closing velocity is the starting guess of f: the first translation that presses, else the largest resultant.
fn pivot(problem: &Problem, law: &PressureLaw) -> Result<usize, WearError> {
    let pressing = |k: &usize| {
        let mode = &problem.modes[*k];
        mode.resultant > 0.0 && !matches!(mode.motion, RigidMotion::Rotation { .. })
    };
    let by_size = (0..law.count).max_by(|i, j| law.resultant(*i).abs().total_cmp(&law.resultant(*j).abs())).unwrap_or(0);
    let chosen = (0..law.count).find(pressing).unwrap_or(by_size);
    let translates = problem.modes.iter().any(|mode| matches!(mode.motion, RigidMotion::Translation { .. }));
    if problem.modes[chosen].resultant == 0.0 || (translates && !pressing(&chosen)) {
        let resultants = problem.modes.iter().map(|mode| mode.resultant).collect();
        return Err(WearError::Infeasible { resultants, why: "no force presses the bodies together" });
    }
    Ok(chosen)
}
