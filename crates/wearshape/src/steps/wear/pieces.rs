//! The schedule of a run in time as problems: each piece is the problem under its own load and sliding.

use shapeopt::Interval;

use crate::problem::Problem;

/// The loads that occur, and which acts when.
pub(super) struct Pieces {
    /// The problem under each of the different loads.
    pub problems: Vec<Problem>,
    /// The pieces in their order.
    pub intervals: Vec<Interval>,
}

impl Pieces {
    /// The pieces of a problem; without a schedule the problem itself for ever.
    pub(super) fn of(problem: &Problem) -> Pieces {
        if problem.pieces.is_empty() {
            let intervals = vec![Interval { stage: 0, duration: f64::INFINITY }];
            return Pieces { problems: vec![problem.clone()], intervals };
        }
        let mut known: Vec<[f64; 3]> = Vec::new();
        let mut pieces = Pieces { problems: Vec::new(), intervals: Vec::new() };
        for (number, piece) in problem.pieces.iter().enumerate() {
            let stage = known.iter().position(|other| *other == piece.factors).unwrap_or_else(|| {
                known.push(piece.factors);
                pieces.problems.push(problem.under(piece.factors));
                known.len() - 1
            });
            let end = problem.pieces.get(number + 1).map_or(f64::INFINITY, |next| next.time);
            pieces.intervals.push(Interval { stage, duration: end - piece.time });
        }
        pieces
    }
}
