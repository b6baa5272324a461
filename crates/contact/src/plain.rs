//! A gap and a load brought to plain numbers, and its solution: all that a contact solve is once the bodies are matrices.

use crate::checked::listed;
use crate::coulomb::{ContactState, Coulomb, Outcome, Sheared};
use crate::ending::{Ending, Warm};
use crate::error::Error;
use crate::following::Followed;
use crate::growth::{Family, grown};
use crate::lcp::{Answer, BALANCED, Complementarity, Point};
use crate::load::Friction;
use crate::matrices::Matrices;
use crate::products::transposed_times;
use crate::status::Status;
use crate::verdict;
use faer::{Mat, Side};
use std::borrow::Cow;

/// What a load does before any contact force acts.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Unloaded {
    /// Opening at the points.
    pub opening: Vec<f64>,
    /// Slip at the points.
    pub slip: Vec<f64>,
    /// Force (or moment) along each motion.
    pub forces: Vec<f64>,
}

/// How the coordinates are held.
pub(crate) struct Held {
    /// `coordinates x coordinates`.
    pub(crate) stiffness: Mat<f64>,
    /// The coordinates that are not prescribed.
    pub(crate) free: Vec<usize>,
    /// Of all coordinates, those that the shear of steady sliding does no work along.
    pub(crate) guided: Vec<bool>,
}

/// A load brought to the form of the complementarity problem.
pub(crate) struct Plain<'m> {
    pub(crate) matrices: &'m Matrices,
    pub(crate) problem: Complementarity<'m>,
    pub(crate) slide: Vec<f64>,
    /// Slip of the unloaded contact.
    pub(crate) slip: Vec<f64>,
    /// Slip by the free coordinates.
    pub(crate) sliding: Option<Mat<f64>>,
    /// The motions of the free coordinates that neither pressure nor spring resists.
    idle: Vec<Vec<f64>>,
}

impl<'m> Plain<'m> {
    pub(crate) fn new(matrices: &'m Matrices, friction: &Friction, unloaded: Unloaded, held: &Held) -> Result<Plain<'m>, Error> {
        let n = matrices.points();
        let (slide, active) = matrices.slide(friction)?;
        let (compliance, balance) = matrices.sliding(&slide, active, &held.guided);
        let free = &held.free;
        let pick = |m: &Mat<f64>| Mat::from_fn(n, free.len(), |i, j| m[(i, free[j])]);
        let (influence, balance) = (pick(&matrices.influence), pick(&balance));
        let sliding = matrices.shear_influence.as_ref().map(pick);
        let mut stiffness = Mat::from_fn(free.len(), free.len(), |i, j| held.stiffness[(free[i], free[j])]);
        let held_by_shear = sliding.as_ref().filter(|_| matches!(friction, Friction::Coulomb { .. }));
        let idle = pin_idle_motions(&influence, held_by_shear, &mut stiffness, &matrices.normal);
        let problem = Complementarity {
            compliance,
            influence,
            balance,
            stiffness,
            opening: unloaded.opening,
            load: free.iter().map(|j| unloaded.forces[*j]).collect(),
            symmetric: !active,
        };
        Ok(Plain { matrices, problem, slide, slip: unloaded.slip, sliding, idle })
    }

    /// Adds what load cases do that follow the nodal normal forces; the problem is no longer symmetric.
    pub(crate) fn follow(&mut self, followed: &Followed, free: &[usize]) {
        *self.problem.compliance.to_mut() += &followed.opening;
        for (j, coordinate) in free.iter().enumerate() {
            for i in 0..self.matrices.points() {
                self.problem.balance[(i, j)] += followed.forces[(i, *coordinate)];
            }
        }
        self.problem.symmetric = false;
    }

    /// The problem without shear; motions that only shear resists are held by a spring.
    fn without_shear(&self) -> Complementarity<'_> {
        let problem = &self.problem;
        let mut stiffness = problem.stiffness.clone();
        pin_idle_motions(&problem.influence, None, &mut stiffness, &problem.compliance);
        Complementarity {
            compliance: Cow::Borrowed(&*problem.compliance),
            influence: problem.influence.clone(),
            balance: problem.influence.clone(),
            stiffness,
            opening: problem.opening.clone(),
            load: problem.load.clone(),
            symmetric: true,
        }
    }

    /// Solves, from an earlier solution if there is one; `family` makes the same problem with other coefficients of friction.
    pub(crate) fn solve(&self, friction: &Friction, warm: Option<Warm<'_>>, family: &Family<'_>) -> Result<Ending, Error> {
        let coefficient = match friction {
            Friction::Coulomb { coefficient, slip_before } => {
                return Ok(self.step(&self.coulomb(*coefficient, slip_before)?, warm));
            }
            Friction::Sliding { coefficient, .. } => *coefficient,
            Friction::None => 0.0,
        };
        let mut answer = self.problem.solve(warm.as_ref().map(|w| (&w.point, w.closed)));
        if !answer.settled && !self.problem.symmetric {
            answer = grown(family, coefficient).unwrap_or(answer);
        }
        Ok(self.judged(answer))
    }

    /// The ending of a solve without stick and slip, with its status.
    pub(crate) fn judged(&self, answer: Answer) -> Ending {
        let status = verdict::status(&self.problem, &self.matrices.normal, &answer);
        self.carried(self.ending(answer, status))
    }

    /// The same without a balance where the spring of an idle motion carries part of the load; the drag alone a guide takes.
    fn carried(&self, ending: Ending) -> Ending {
        let (problem, point) = (&self.problem, &ending.point);
        let pushed = transposed_times(&problem.balance, &point.force);
        let force: f64 = point.force.iter().map(|f| f.abs()).sum();
        let carries = |motion: &Vec<f64>| {
            let along = |what: &[f64], part: fn(f64) -> f64| motion.iter().zip(what).map(|(m, w)| part(m * w)).sum::<f64>();
            let least = BALANCED * (force + along(&problem.load, f64::abs) + along(&pushed, f64::abs));
            let load = along(&problem.load, |part| part);
            load.abs() > least && (load + along(&pushed, |part| part)).abs() > least
        };
        match ending.status.is_solved() && self.idle.iter().any(carries) {
            true => Ending { status: Status::NoBalance, balance: 1.0, ..ending },
            false => ending,
        }
    }

    /// The ending of a solve without stick and slip.
    pub(crate) fn ending(&self, answer: Answer, status: Status) -> Ending {
        let problem = &self.problem;
        let complementarity = problem.complementarity(&answer.point, &answer.opening);
        let balance = problem.relative_imbalance(&answer.point);
        let shear = answer.point.force.iter().zip(&self.slide).map(|(f, s)| f * s).collect();
        let states = answer.active.iter().zip(&self.slide).map(|(closed, slide)| match (closed, *slide) {
            (false, _) => ContactState::Open,
            (true, s) if s > 0.0 => ContactState::Forward,
            (true, s) if s < 0.0 => ContactState::Backward,
            _ => ContactState::Stick,
        });
        Ending {
            status,
            states: states.collect(),
            point: answer.point,
            shear,
            opening: answer.opening,
            complementarity,
            balance,
            iterations: answer.factorisations,
            took_over: answer.pivoted,
        }
    }

    /// What shear adds.
    pub(crate) fn coulomb(&self, coefficient: f64, slip_before: &[f64]) -> Result<Coulomb<'_>, Error> {
        let n = self.matrices.points();
        let (Some(by_shear), Some(tangential), Some(influence)) =
            (&self.matrices.normal_by_shear, &self.matrices.tangential, &self.sliding)
        else {
            return Err(Error::ShearNotPrepared);
        };
        if !(coefficient >= 0.0 && coefficient.is_finite() && slip_before.len() == n) {
            return Err(Error::Drag { coefficient, given: slip_before.len(), points: n });
        }
        listed("slip before", slip_before, n)?;
        Ok(Coulomb {
            normal: &self.problem,
            by_shear,
            tangential,
            influence,
            slip: self.slip.iter().zip(slip_before).map(|(s, b)| s - b).collect(),
            coefficient,
        })
    }

    /// One load step with stick and slip, from the states of an earlier solution or from a frictionless contact that sticks.
    fn step(&self, coulomb: &Coulomb<'_>, warm: Option<Warm<'_>>) -> Ending {
        let n = self.matrices.points();
        let (start, near) = match warm {
            Some(w) => (w.states.to_vec(), Sheared { point: w.point, shear: w.shear.to_vec() }),
            None => {
                let frictionless = self.without_shear().solve(None);
                let closed = if frictionless.settled { frictionless.active } else { vec![true; n] };
                let state = |c: &bool| if *c { ContactState::Stick } else { ContactState::Open };
                (closed.iter().map(state).collect(), Sheared { point: frictionless.point, shear: vec![0.0; n] })
            }
        };
        let outcome = coulomb.solve(&start, &near);
        let status = verdict::sheared_status(coulomb, &outcome);
        self.carried(self.sheared(coulomb, outcome, status))
    }

    /// The ending of a load step; nothing carries where there is no outcome.
    pub(crate) fn sheared(&self, coulomb: &Coulomb<'_>, outcome: Outcome, status: Status) -> Ending {
        let n = self.matrices.points();
        let at = outcome.at.unwrap_or_else(|| Sheared {
            point: Point { force: vec![0.0; n], coordinates: vec![0.0; self.problem.load.len()] },
            shear: vec![0.0; n],
        });
        let (opening, _) = coulomb.gaps(&at);
        Ending {
            status,
            states: outcome.states,
            complementarity: coulomb.normal.complementarity(&at.point, &opening),
            balance: coulomb.relative_imbalance(&at),
            point: at.point,
            shear: at.shear,
            opening,
            iterations: outcome.steps,
            took_over: false,
        }
    }
}

/// Rigid motions without any normal trace (an arc turning about its centre) would make the problem singular: a spring holds them, which
/// carries nothing if the load has no part along them. Gives these motions.
fn pin_idle_motions(
    influence: &Mat<f64>,
    held_by_shear: Option<&Mat<f64>>,
    stiffness: &mut Mat<f64>,
    compliance: &Mat<f64>,
) -> Vec<Vec<f64>> {
    let shear = |k: usize, i: usize| held_by_shear.map_or(0.0, |s| s[(k, i)]);
    let (n, m) = (influence.nrows(), influence.ncols());
    let mut idle = Vec::new();
    if m == 0 || n == 0 {
        return idle;
    }
    let scale: Vec<f64> =
        (0..m).map(|j| (0..n).map(|i| influence[(i, j)].abs().max(shear(i, j).abs())).fold(0.0, f64::max)).collect();
    let typical = (0..n).map(|i| compliance[(i, i)]).fold(0.0, f64::max);
    let unit: Vec<f64> = scale.iter().map(|s| if *s > 0.0 { *s } else { 1.0 }).collect();
    let gram = Mat::from_fn(m, m, |i, j| {
        let product: f64 =
            (0..n).map(|k| (influence[(k, i)] * influence[(k, j)] + shear(k, i) * shear(k, j)) / unit[i] / unit[j]).sum();
        product + stiffness[(i, j)] * typical / (unit[i] * unit[j])
    });
    let Ok(eigen) = gram.self_adjoint_eigen(Side::Lower) else { return idle };
    for k in 0..m {
        if eigen.S()[k] > 1e-18 * n as f64 {
            continue;
        }
        for i in 0..m {
            for j in 0..m {
                stiffness[(i, j)] += eigen.U()[(i, k)] * eigen.U()[(j, k)] * unit[i] * unit[j] / typical;
            }
        }
        idle.push((0..m).map(|i| eigen.U()[(i, k)] / unit[i]).collect());
    }
    idle
}
