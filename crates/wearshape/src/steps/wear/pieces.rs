//! The schedule of a run in time as problems: each piece is the problem under its own load and sliding.

use shapeopt::Interval;

use crate::problem::Problem;
use crate::turns_result::TurnsResult;

/// The loads that occur, and which acts when.
pub(super) struct Pieces {
    /// The problem under each of the different loads.
    pub problems: Vec<Problem>,
    /// The pieces in their order.
    pub intervals: Vec<Interval>,
    /// Shares of the time of loads that act by turns, over which the run averages; none where one acts after the other.
    pub shares: Option<Vec<f64>>,
    /// How many pieces make a cycle, where cycles are resolved one by one.
    pub cycle: Option<usize>,
    /// What is said of reversals that repeat; none without them.
    pub turns: Option<TurnsResult>,
}

impl Pieces {
    /// What a mean over cycles leaves out of the gap, over its size.
    pub(super) fn left_out(&self) -> f64 {
        self.turns.as_ref().filter(|turns| turns.averaged).and_then(|turns| turns.ripple).unwrap_or(0.0)
    }

    /// The pieces of a problem, each once; without a schedule the problem itself for ever.
    pub(super) fn of(problem: &Problem) -> Pieces {
        let mut pieces = Pieces { problems: Vec::new(), intervals: Vec::new(), shares: None, cycle: None, turns: None };
        if problem.pieces.is_empty() {
            pieces.problems.push(problem.clone());
            pieces.intervals.push(Interval { stage: 0, duration: f64::INFINITY });
            return pieces;
        }
        let mut known: Vec<[f64; 3]> = Vec::new();
        let end = problem.cycles.map_or(f64::INFINITY, |cycles| cycles.period);
        for (number, piece) in problem.pieces.iter().enumerate() {
            let stage = known.iter().position(|other| *other == piece.factors).unwrap_or_else(|| {
                known.push(piece.factors);
                pieces.problems.push(problem.under(piece.factors));
                known.len() - 1
            });
            let end = problem.pieces.get(number + 1).map_or(end, |next| next.time);
            pieces.intervals.push(Interval { stage, duration: end - piece.time });
        }
        pieces
    }

    /// A motion that goes forward and backward by turns, in cycles short against wear.
    pub(super) fn both_ways(problem: &Problem, share: f64) -> Pieces {
        let problems = vec![problem.clone(), problem.under([1.0, 1.0, -1.0])];
        let intervals = vec![Interval { stage: 0, duration: f64::INFINITY }];
        Pieces { problems, intervals, shares: Some(vec![share, 1.0 - share]), cycle: None, turns: None }
    }

    /// The mean over a cycle of these pieces.
    pub(super) fn averaged(&self) -> Pieces {
        let whole: f64 = self.intervals.iter().map(|piece| piece.duration).sum();
        let part =
            |stage: usize| self.intervals.iter().filter(|piece| piece.stage == stage).map(|piece| piece.duration / whole).sum();
        Pieces {
            problems: self.problems.clone(),
            intervals: vec![Interval { stage: 0, duration: f64::INFINITY }],
            shares: Some((0..self.problems.len()).map(part).collect()),
            cycle: None,
            turns: None,
        }
    }

    /// These pieces so many times, one cycle after the other.
    pub(super) fn repeated(self, count: usize) -> Pieces {
        Pieces { intervals: self.intervals.repeat(count), cycle: Some(self.intervals.len()), ..self }
    }
}
