//! The solution under steady sliding that grows from no friction.

use crate::lcp::{Answer, Complementarity};

/// Steps in which the solution is followed from no friction.
pub(crate) const STEPS: usize = 16;

/// Gives the problem of a coefficient of friction to its second argument.
pub(crate) type Family<'f> = dyn Fn(f64, &mut dyn FnMut(&Complementarity<'_>)) + 'f;

/// The answer that grows from no friction to a coefficient, for loads from which a cold start does not settle; `None` where it is lost on the
/// way.
pub(crate) fn grown(family: &Family<'_>, coefficient: f64) -> Option<Answer> {
    let mut last: Option<Answer> = None;
    for k in 0..=STEPS {
        let mut next = None;
        let start = last.as_ref().map(|a| (&a.point, a.active.as_slice()));
        family(coefficient * k as f64 / STEPS as f64, &mut |problem| next = Some(problem.solve(start)));
        last = next.filter(|answer| answer.settled);
        last.as_ref()?;
    }
    last
}
