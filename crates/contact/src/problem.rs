//! A contact problem in one piece.

use crate::error::Error;
use crate::load::ContactLoad;
use crate::operator::ContactOperator;
use crate::pair::Pair;
use crate::solution::ContactSolution;

/// Bodies, gap and load of one contact.
pub struct ContactProblem<'a> {
    /// The bodies.
    pub pair: Pair<'a>,
    /// Gap at the points of the pair, positive open.
    pub gap: Vec<f64>,
    /// Everything else that acts.
    pub load: ContactLoad,
}

/// Solves one contact. For several gaps or loads of the same bodies make a [`ContactOperator`] once.
///
/// # Errors
/// As [`ContactOperator::new`] and [`ContactOperator::solve`].
pub fn solve(problem: &ContactProblem<'_>) -> Result<ContactSolution, Error> {
    ContactOperator::new(&problem.pair, problem.load.has_friction())?.solve(&problem.gap, &problem.load, None)
}
