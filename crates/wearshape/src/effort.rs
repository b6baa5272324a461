//! What computing took: counters of the summary, and seconds by stage as the caller's clock has them.

use std::ops::AddAssign;

use serde::Serialize;

use crate::step::Step;

/// Seconds since any fixed moment. The library has no clock of its own: who wants to know the seconds brings one.
pub type Clock = fn() -> f64;

/// `summary.counters`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Counters {
    /// Cells assembled.
    pub cells: usize,
    /// Unknowns of both bodies.
    pub dofs: usize,
    /// Unknowns of the contact traces.
    pub trace_dofs: usize,
    /// Factorisations, those of problems of temperature and of twist among them.
    pub factorisations: usize,
    /// Contact solves.
    pub contact_solves: usize,
    /// Contact solves of the round trip.
    pub check_solves: usize,
    /// Wear steps.
    pub wear_steps: usize,
    /// Back substitutions into the inside of a body.
    pub back_substitutions: usize,
}

/// Work that was done.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Effort {
    /// Sizes of the last discretisation, and counts of all work.
    pub counters: Counters,
    /// Seconds of each stage, in the order in which they came first.
    pub seconds: Vec<(Step, f64)>,
}

impl Effort {
    /// Does a part of a stage and adds its seconds.
    pub fn timed<T>(&mut self, step: Step, clock: Clock, work: impl FnOnce(&mut Effort) -> T) -> T {
        let start = clock();
        let result = work(self);
        self.add_seconds(step, clock() - start);
        result
    }

    /// Adds seconds to those of a stage.
    pub fn add_seconds(&mut self, step: Step, seconds: f64) {
        match self.seconds.iter_mut().find(|(known, _)| *known == step) {
            Some((_, total)) => *total += seconds,
            None => self.seconds.push((step, seconds)),
        }
    }

    /// The same without the sizes of its discretisation: work beside the level that is reported.
    pub fn aside(mut self) -> Effort {
        (self.counters.cells, self.counters.dofs, self.counters.trace_dofs) = (0, 0, 0);
        self
    }
}

impl AddAssign for Effort {
    /// Counts and seconds add up; of sizes the later ones stand.
    fn add_assign(&mut self, later: Effort) {
        let (all, new) = (&mut self.counters, &later.counters);
        if new.cells > 0 {
            (all.cells, all.dofs, all.trace_dofs) = (new.cells, new.dofs, new.trace_dofs);
        }
        all.factorisations += new.factorisations;
        all.contact_solves += new.contact_solves;
        all.check_solves += new.check_solves;
        all.wear_steps += new.wear_steps;
        all.back_substitutions += new.back_substitutions;
        for (step, seconds) in later.seconds {
            self.add_seconds(step, seconds);
        }
    }
}
