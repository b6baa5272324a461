//! Loads that act by turns, in cycles short against wear: one contact for each of them on the same gap, which wears by their mean rate.
//!
//! ```text
//! o_k = g + E_k + A_k W p_k + Psi_k y_k >= 0,   p_k >= 0,   p_k o_k = 0        k: loads
//! dg/dt = sum_k share_k w'_k(p_k)
//! ```
//!
//! In a step the loads meet in the gap alone, so that together they are one system with blocks on its diagonal.

use contact::ContactSystem;
use faer::Mat;
use std::borrow::Cow;

use crate::gap_rate::GapRate;
use crate::implicit_stage::Load;
use crate::wear_problem::{LoadStage, WearProblem};

/// The loads of a problem: each by itself, or all of them in one where they act by turns.
pub(crate) fn loads(problem: &WearProblem) -> Vec<Load<'_>> {
    let together = problem.shares.as_ref().and_then(|shares| {
        let rates = problem.stages.iter().map(|stage| rate(problem, stage));
        let mean = GapRate::mean(rates.zip(shares.iter().copied()).collect())?;
        let systems: Vec<&ContactSystem> = problem.stages.iter().map(|stage| &stage.system).collect();
        Some(Load::new(Cow::Owned(stacked(&systems)), mean, weights(problem).repeat(systems.len())).growing(problem.growing))
    });
    if let Some(load) = together {
        return vec![load];
    }
    problem.stages.iter().map(|stage| load(problem, stage, Cow::Borrowed(&stage.system))).collect()
}

/// The load of a stage with the contact that acts.
pub(crate) fn load<'a>(problem: &'a WearProblem, stage: &LoadStage, system: Cow<'a, ContactSystem>) -> Load<'a> {
    Load::new(system, rate(problem, stage), weights(problem)).growing(problem.growing)
}

fn rate(problem: &WearProblem, stage: &LoadStage) -> GapRate {
    let rate = GapRate::new(&problem.wear, problem.counterface, &stage.speeds, &weights(problem), problem.track_area);
    rate.passing(problem.passing.clone()).opened_by_both(problem.is_opened_by_both().then(|| problem.gap.clone()))
}

fn weights(problem: &WearProblem) -> Vec<f64> {
    problem.points.iter().map(|p| p.weight).collect()
}

/// Systems one after the other, without a tie.
fn stacked(systems: &[&ContactSystem]) -> ContactSystem {
    let blocks = |of: fn(&ContactSystem) -> &Mat<f64>| {
        let [rows, columns] = systems.iter().fold([0; 2], |[r, c], s| [r + of(s).nrows(), c + of(s).ncols()]);
        let mut all = Mat::zeros(rows, columns);
        let (mut row, mut column) = (0, 0);
        for block in systems.iter().map(|system| of(system)) {
            all.submatrix_mut(row, column, block.nrows(), block.ncols()).copy_from(block);
            (row, column) = (row + block.nrows(), column + block.ncols());
        }
        all
    };
    let list = |of: fn(&ContactSystem) -> &Vec<f64>| systems.iter().flat_map(|system| of(system).iter().copied()).collect();
    ContactSystem {
        compliance: blocks(|s| &s.compliance),
        influence: blocks(|s| &s.influence),
        balance: blocks(|s| &s.balance),
        stiffness: blocks(|s| &s.stiffness),
        opening: list(|s| &s.opening),
        load: list(|s| &s.load),
        symmetric: systems.iter().all(|system| system.symmetric),
    }
}

impl WearProblem {
    /// Pressures of a state that act at the contact points by turns, with their shares of the time; of a run under one load after the other the
    /// pressure of the state.
    pub fn pressures<'a>(&'a self, pressure: &'a [f64]) -> impl Iterator<Item = (&'a [f64], f64)> {
        let shares: &[f64] = self.shares.as_deref().unwrap_or(&[1.0]);
        pressure.chunks(self.points.len().max(1)).zip(shares.iter().copied())
    }

    /// The mean of these pressures over the time.
    pub fn mean_pressure(&self, pressure: &[f64]) -> Vec<f64> {
        let mut mean = vec![0.0; self.points.len()];
        for (pressure, share) in self.pressures(pressure) {
            mean.iter_mut().zip(pressure).for_each(|(mean, p)| *mean += share * p);
        }
        mean
    }

    /// Values that a state holds at every contact point for each load: pressures and openings.
    pub fn values(&self) -> usize {
        self.points.len() * self.shares.as_ref().map_or(1, Vec::len)
    }

    /// Rigid coordinates that a state holds in an interval of the schedule.
    pub fn coordinates(&self, interval: usize) -> usize {
        let of = |stage: &LoadStage| stage.system.load.len();
        match &self.shares {
            Some(_) => self.stages.iter().map(of).sum(),
            None => self.schedule.get(interval).and_then(|interval| self.stages.get(interval.stage)).map_or(0, of),
        }
    }

    /// Checks the shares of loads that act by turns.
    pub(crate) fn wrong_shares(&self) -> Option<String> {
        let shares = self.shares.as_ref()?;
        let all: f64 = shares.iter().sum();
        if shares.len() != self.stages.len() {
            return Some(format!("{} shares of the time for {} loads", shares.len(), self.stages.len()));
        }
        if shares.iter().any(|share| !(0.0..=1.0).contains(share)) || (all - 1.0).abs() > 1e-9 {
            return Some(format!("the shares of the time in which the loads act are {shares:?}; they must add up to 1"));
        }
        if self.schedule.len() != 1 || self.passing.is_some() {
            return Some("loads that act by turns are one interval of the schedule, and know no groove".into());
        }
        None
    }
}
