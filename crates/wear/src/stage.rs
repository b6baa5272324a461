//! The balance in numbers: what the solver works on.

use crate::density::Density;
use crate::mode::MAX_MODES;
use crate::pressure_law::{Node, PressureLaw};
use crate::quadrature::{Rule, graded, jacobi};
use crate::recession::Recession;
use crate::why::{Why, none};
use crate::{Problem, RigidMode, RigidMotion, WearError};

/// What the solver works on.
#[derive(Clone, Debug)]
pub(crate) struct Stage<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) law: PressureLaw,
    /// Gauss-Jacobi rule, or a graded one, for cells that end where f = 0.
    pub(crate) front_rule: Option<Rule>,
    /// Whether the density only leads to another one.
    pub(crate) on_the_way: bool,
    /// Nodes made for absolute laws so far.
    pub(crate) made: usize,
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
            side: 1.0,
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
        let reference = if law.density.falls_with_speed() { low } else { speeds.1 };
        law.reference_speed = if reference > 0.0 { reference } else { 1.0 };
        law.pivot = pivot(problem, &law)?;
        for k in 0..count {
            law.ratio[k] = law.resultant(k) / law.resultant(law.pivot);
        }
        let exponent = law.density.front_exponent();
        let ends = count > 1 || smallest <= 0.0;
        let front_rule = if matches!(law.density, Density::Given(_)) {
            ends.then(graded)
        } else {
            (ends && exponent > 0.0 && exponent <= 6.0).then(|| jacobi(exponent - 1.0))
        };
        Ok(Self { problem, law, front_rule, on_the_way: false, made: 0 })
    }

    /// True when f <= 0 somewhere among the ends and coarse points of the surface.
    pub(crate) fn open_at_ends(&self) -> bool {
        let mut open = false;
        self.problem.surface.survey(&mut |point| {
            open |= self.law.force_function(point, &self.law.mode_values(point)).0 <= 0.0;
        });
        open
    }

    /// True when psi differs from phi somewhere: friction bends the balance.
    pub(crate) fn bends(&self) -> bool {
        let mut bends = false;
        self.problem.surface.survey(&mut |point| {
            let values = self.law.mode_values(point);
            bends |= (0..self.law.count).any(|k| (values.phi[k] - values.psi[k]).abs() > 1e-14);
        });
        bends
    }

    /// The load is not carried, and why.
    pub(crate) fn infeasible(&self, why: Why) -> WearError {
        infeasible(self.problem, why)
    }

    /// True when psi = phi at every node: the stationary pressure is a true extremum (or the modes are associated).
    pub(crate) fn symmetric(&self, nodes: &[Node]) -> bool {
        let same = |node: &Node, k: usize| (node.modes.phi[k] - node.modes.psi[k]).abs() <= 1e-14;
        nodes.iter().all(|node| (0..self.law.count).all(|k| same(node, k)))
    }
}

/// The load of a problem is not carried, and why.
fn infeasible(problem: &Problem, Why { kind, words }: Why) -> WearError {
    WearError::Infeasible { modes: problem.modes.clone(), kind, why: words }
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
        return Err(infeasible(problem, none("no force presses the bodies together")));
    }
    Ok(chosen)
}
