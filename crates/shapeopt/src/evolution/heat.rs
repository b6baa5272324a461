//! Frictional heat that bends the bodies: which points conduct it, and whether the contact bears it.
//!
//! The temperature is that of the present pressure, so that the opening by heat is a part of the compliance. Through a conductance heat crosses where
//! the surfaces touch alone, and what they do there decides whether they touch. Points in contact conduct. A point that opens ceases to, unless it closes
//! again for that: it stands for imperfect contact (Barber 1978), which neither presses nor is open, and goes on conducting.

use crate::acting::{Acting, Conducting};
use crate::evolution::{Evolution, change_approach};
use crate::evolution_status::EvolutionStatus;
use crate::implicit_stage::Contact;
use crate::rigid_wear::RigidWear;
use crate::turns::load;
use crate::wear_state::WearState;
use crate::wear_step::{Trial, try_step};
use std::borrow::Cow;
use std::sync::Arc;

/// Contacts kept whose points conduct otherwise.
const KEPT: usize = 4;
/// Part of the force that moves in a jump, and how often the way to it is halved.
const JUMP: f64 = 0.05;
const HALVINGS: usize = 20;
/// Jumps after which a contact is taken to jump for ever.
const MOST_JUMPS: usize = 30;

/// The points under pressure.
fn closed(state: &WearState) -> Vec<bool> {
    state.pressure.iter().map(|p| *p > 0.0).collect()
}

/// Adds points to those that conduct, where any do not all the time; whether there is a new one among them.
fn more(conducting: &mut [bool], points: &[usize]) -> bool {
    let before = conducting.iter().filter(|conducts| **conducts).count();
    points.iter().for_each(|point| conducting.get_mut(*point).into_iter().for_each(|conducts| *conducts = true));
    conducting.iter().filter(|conducts| **conducts).count() > before
}

impl<'a> Evolution<'a> {
    /// What acts in a state.
    pub(super) fn load(&self, state: &WearState) -> Arc<Acting<'a>> {
        let stage = self.stage(state);
        self.conducting(stage, &state.conducting).unwrap_or_else(|| Arc::clone(&self.acting[stage]))
    }

    /// A step from a state while the points conduct that touch in it, and which these are.
    pub(super) fn trial(&self, state: &WearState, step: f64) -> Option<(Trial, Vec<bool>)> {
        let mut points = state.conducting.clone();
        loop {
            let acting = self.conducting(self.stage(state), &points)?;
            let tried = try_step(&acting.load, self.problem.scheme, state, step, self.severity(state));
            let touched = match &tried {
                Ok(trial) => (0..points.len()).filter(|i| trial.contact.pressure[*i] > 0.0).collect(),
                Err(unsettled) => unsettled.points.clone(),
            };
            if !more(&mut points, &touched) {
                return tried.ok().map(|trial| (trial, points));
            }
        }
    }

    /// The load of a stage while these points conduct; none where both surfaces are held at a temperature that meets itself.
    fn conducting(&self, stage: usize, points: &[bool]) -> Option<Arc<Acting<'a>>> {
        let heated = self.problem.stages[stage].heated.as_ref().filter(|_| !points.is_empty());
        let Some(heated) = heated else { return Some(Arc::clone(&self.acting[stage])) };
        let same = |known: &&Conducting<'_>| known.stage == stage && known.points == points;
        if let Some(known) = self.kept.borrow().iter().find(same) {
            return Some(Arc::clone(&known.acting));
        }
        let system = heated.on(points).ok()?;
        let rigid = RigidWear::new(&system);
        let load = load(self.problem, &self.problem.stages[stage], Cow::Owned(system));
        let acting = Arc::new(Acting { load, rigid });
        let mut kept = self.kept.borrow_mut();
        if kept.len() >= KEPT {
            kept.remove(0);
        }
        kept.push(Conducting { stage, points: points.to_vec(), acting: Arc::clone(&acting) });
        Some(acting)
    }

    /// Whether a stage's contact hangs on which points conduct.
    fn conducts(&self, stage: usize) -> bool {
        self.problem.stages[stage].heated.as_ref().is_some_and(contact::HeatedSystem::conducts)
    }

    /// Solves the contact on the gap of a state, from its pressure, while the points conduct that touch; false where there is none.
    fn settle(&self, state: &mut WearState) -> bool {
        let stage = self.stage(state);
        let mut points = state.conducting.clone();
        while let Some(acting) = self.conducting(stage, &points) {
            let (touched, solved) = match acting.load.solve(&state.gap, 0.0, &Contact::of(state)) {
                Ok(solved) => ((0..points.len()).filter(|i| solved.contact.pressure[*i] > 0.0).collect(), Some(solved)),
                Err(unsettled) => (unsettled.points, None),
            };
            if more(&mut points, &touched) {
                continue;
            }
            let Some(solved) = solved else { return false };
            (state.pressure, state.opening) = (solved.contact.pressure, solved.contact.opening);
            (state.coordinates, state.conducting) = (solved.contact.coordinates, points);
            return true;
        }
        false
    }

    /// Lets the points conduct that touch at the start, and those that touch for that.
    pub(super) fn conduct_at_first(&self, state: &mut WearState) {
        if !self.conducts(self.stage(state)) {
            return;
        }
        state.conducting = closed(state);
        if self.settle(state) {
            self.take_contact(state, Contact::of(state));
            self.conduct(state);
        }
    }

    /// Points that have opened cease to conduct, unless one of them closes again for that; the pressure follows at once.
    pub(super) fn conduct(&self, state: &mut WearState) {
        let stage = self.stage(state);
        let points = closed(state);
        if !self.conducts(stage) || points == state.conducting {
            return;
        }
        let Some(acting) = self.conducting(stage, &points) else { return };
        let Ok(solved) = acting.load.solve(&state.gap, 0.0, &Contact::of(state)) else { return };
        state.newton_iterations += solved.iterations;
        if solved.contact.pressure.iter().zip(&points).all(|(p, conducts)| *conducts || *p == 0.0) {
            state.conducting = points;
            change_approach(state, &solved.contact.coordinates);
            self.take_contact(state, solved.contact);
        }
    }

    /// No step leads on from a state: without heat each would.
    pub(super) fn stuck(&self, state: &WearState, step: f64) -> EvolutionStatus {
        match self.problem.stages[self.stage(state)].heated {
            // Steps that grow without a bound wear nothing more.
            Some(_) | None if step.is_infinite() && self.left(state).is_some() => EvolutionStatus::Unreached { time: state.time },
            Some(_) => EvolutionStatus::Unstable { time: state.time },
            None => EvolutionStatus::Stuck { time: state.time, step },
        }
    }

    /// Whether heat lets deviations of the pressure grow in a state, or the contact jumps again and again; counts the jump from the state before.
    pub(super) fn unstable(&self, from: Option<&WearState>, state: &mut WearState) -> Option<EvolutionStatus> {
        self.problem.stages[self.stage(state)].heated.as_ref()?;
        let from = from.filter(|from| from.interval == state.interval);
        state.jumps += usize::from(from.is_some_and(|from| self.jumps(from, state)));
        let now = closed(state);
        let known = |from: &WearState| from.conducting == state.conducting && closed(from) == now;
        let regular = from.is_some_and(known) || self.load(state).load.system.is_regular(&now);
        (!regular || state.jumps > MOST_JUMPS).then_some(EvolutionStatus::Unstable { time: state.time })
    }

    /// Part of the force that two pressures carry at different places.
    fn moved(&self, a: &[f64], b: &[f64]) -> f64 {
        let weights: Vec<f64> = self.problem.points.iter().map(|point| point.weight).collect();
        let apart: f64 = weights.iter().zip(a).zip(b).map(|((w, a), b)| w * (a - b).abs()).sum();
        0.5 * apart / weights.iter().zip(b).map(|(w, b)| w * b).sum::<f64>()
    }

    /// Whether the pressure jumps somewhere on the way from the gap of one state to that of the next: halved again and again, the way keeps a part on
    /// which much of the force moves.
    fn jumps(&self, from: &WearState, to: &WearState) -> bool {
        let (mut from, mut to) = (from.clone(), to.clone());
        for _ in 0..HALVINGS {
            if self.moved(&from.pressure, &to.pressure) < JUMP {
                return false;
            }
            let mut middle = from.clone();
            middle.gap = from.gap.iter().zip(&to.gap).map(|(a, b)| 0.5 * (a + b)).collect();
            if !self.settle(&mut middle) {
                return true;
            }
            let [before, after] = [&from, &to].map(|end| self.moved(&end.pressure, &middle.pressure));
            *(if before > after { &mut to } else { &mut from }) = middle;
        }
        true
    }
}
