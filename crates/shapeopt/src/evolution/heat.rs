//! Frictional heat that bends the bodies: which points conduct it, and whether the contact bears it.
//!
//! The temperature is that of the present pressure, so that the opening by heat is a part of the compliance. Through a conductance heat crosses where
//! the surfaces touch alone, and what they do there decides whether they touch. Points in contact conduct. A point that opens ceases to, unless it closes
//! again for that: it stands for imperfect contact (Barber 1978), which neither presses nor is open, and goes on conducting.

use crate::evolution::{Acting, Evolution, change_approach};
use crate::evolution_status::EvolutionStatus;
use crate::implicit_stage::Contact;
use crate::rigid_wear::RigidWear;
use crate::turns::load;
use crate::wear_state::WearState;
use std::borrow::Cow;
use std::sync::Arc;

/// Contacts kept whose points conduct otherwise.
const KEPT: usize = 4;

/// A contact of a stage whose points conduct as told.
pub(super) struct Conducting<'a> {
    stage: usize,
    points: Vec<bool>,
    acting: Arc<Acting<'a>>,
}

/// The points under pressure.
fn closed(state: &WearState) -> Vec<bool> {
    state.pressure.iter().map(|p| *p > 0.0).collect()
}

/// Adds points to those that conduct, where any do not all the time; whether there is a new one among them.
pub(super) fn more(conducting: &mut [bool], points: &[usize]) -> bool {
    let before = conducting.iter().filter(|conducts| **conducts).count();
    points.iter().for_each(|point| conducting.iter_mut().nth(*point).into_iter().for_each(|conducts| *conducts = true));
    conducting.iter().filter(|conducts| **conducts).count() > before
}

impl<'a> Evolution<'a> {
    /// The load of a stage while these points conduct; none where both surfaces are held at a temperature that meets itself.
    pub(super) fn conducting(&self, stage: usize, points: &[bool]) -> Option<Arc<Acting<'a>>> {
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

    /// Lets the points conduct that touch at the start, and those that touch for that.
    pub(super) fn conduct_at_first(&self, state: &mut WearState) {
        let stage = self.stage(state);
        if !self.conducts(stage) {
            return;
        }
        let mut points = closed(state);
        while let Some(acting) = self.conducting(stage, &points) {
            let Some(solved) = acting.load.solve_anyhow(&state.gap, &Contact::of(state)) else { return };
            let touched: Vec<usize> = (0..points.len()).filter(|i| solved.contact.pressure[*i] > 0.0).collect();
            if !more(&mut points, &touched) {
                state.conducting = points;
                self.take_contact(state, solved.contact);
                break;
            }
        }
        self.conduct(state);
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

    /// Whether a state has come to a contact on which heat lets deviations of the pressure grow.
    pub(super) fn unstable(&self, from: Option<&WearState>, state: &WearState) -> Option<EvolutionStatus> {
        self.problem.stages[self.stage(state)].heated.as_ref()?;
        let now = closed(state);
        let known = |from: &WearState| {
            from.interval == state.interval && from.conducting == state.conducting && closed(from) == now
        };
        let regular = from.is_some_and(known) || self.load(state).load.system.is_regular(&now);
        (!regular).then_some(EvolutionStatus::Unstable { time: state.time })
    }
}
