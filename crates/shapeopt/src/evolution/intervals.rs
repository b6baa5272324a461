//! From one interval of the schedule to the next.

use crate::evolution::{Evolution, change_approach};
use crate::implicit_stage::Contact;
use crate::wear_state::WearState;

impl Evolution<'_> {
    /// Number and start of the interval after the one of a state, if that is over.
    pub(super) fn next_interval(&self, state: &WearState) -> Option<(usize, f64)> {
        let end = state.interval_start + self.problem.schedule[state.interval].duration;
        let over = state.interval + 1 < self.problem.schedule.len() && state.time >= end;
        over.then_some((state.interval + 1, end))
    }

    /// Moves on to the interval that acts at the state's time; a new load changes the pressure at once.
    pub(super) fn enter_interval(&self, state: &mut WearState) {
        let mut entered = false;
        while let Some(next) = self.next_interval(state) {
            (state.interval, state.interval_start) = next;
            entered = true;
        }
        if !entered {
            return;
        }
        let acting = self.load(state);
        let start = Contact::of(state);
        if let Some(solved) = acting.load.solve_anyhow(&state.gap, &start) {
            state.newton_iterations += solved.iterations;
            change_approach(state, &solved.contact.coordinates);
            self.take_contact(state, solved.contact);
            self.conduct(state);
        }
        state.next_step = state.next_step.min(self.first_step(state));
    }
}
