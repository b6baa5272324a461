//! What a run still found that did not reach its goal, and what would reach it.

use wearshape::{ContactResult, Problem, Solution, Status};

use crate::brief::brief;
use crate::shape_words::taken_off;

/// The lines of a run that was computed but whose goal is not met; none of any other.
pub(crate) fn lines(problem: &Problem, solution: &Solution) -> Vec<String> {
    if !matches!(solution.status, Status::AccuracyMissed | Status::NotConverged) {
        return Vec::new();
    }
    let mut lines = Vec::new();
    lines.extend(help(problem, solution).map(|help| format!("help      {help}")));
    lines.extend(solution.contact.as_ref().map(|contact| format!("contact   {}", touching(contact))));
    lines.extend(taken_off(problem, solution).map(|words| format!("shape     {words}")));
    lines
}

/// Force, pressure, approach and ends of a contact.
fn touching(contact: &ContactResult) -> String {
    let um = |value: f64| format!("approach {} um", brief(1e3 * value));
    let words = [
        contact.force.map(|force| format!("force {} N", brief(force))),
        contact.p_max.map(|peak| format!("at most {} MPa", brief(peak))),
        contact.approach.map(um),
        ends(&contact.ends),
    ];
    words.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// The outermost ends of contact.
fn ends(ends: &[f64]) -> Option<String> {
    let (first, last) = (ends.first()?, ends.last()?);
    (first < last).then(|| format!("from s = {} to {} mm", brief(*first), brief(*last)))
}

/// What reaches the goal.
fn help(problem: &Problem, solution: &Solution) -> Option<String> {
    if solution.status == Status::NotConverged {
        let time = solution.wear.as_ref().and_then(|wear| wear.time)?;
        return (time > 0.0).then(|| format!("to end it where it is: --set wear.until={}", brief(time)));
    }
    let error = error(solution)?;
    let asked = problem.scene().accuracy;
    if asked.is_none_or(|asked| error > asked) {
        // An error as large as the numbers is nothing to be content with, nor is one that its proof does not bear out.
        let proved = solution.shape.as_ref().is_none_or(|shape| !shape.proof_failed);
        let asked_for = (proved && error < 0.5).then(|| above(error))?;
        return Some(format!("the numbers hold to {error:.1e}; to be content with that: --set accuracy={asked_for}"));
    }
    // The gap is as accurate as asked for, but its proof is not.
    asked.map(|asked| format!("a finer mesh may prove it: --set accuracy={:.0e}", 0.1 * asked))
}

/// The estimated error that decides: of the gap, or the largest of a contact.
fn error(solution: &Solution) -> Option<f64> {
    let error = solution.error.as_ref()?;
    let of_contact = [error.energy_relative, error.pressure_relative, error.twist_relative];
    error.gap_relative.or(of_contact.into_iter().flatten().reduce(f64::max))
}

/// The next of 1, 2, 5, 10, ... of its power of ten above an error.
fn above(error: f64) -> String {
    let power = error.log10().floor() as i32;
    let tens = 10.0_f64.powi(power);
    let step = [1, 2, 5].into_iter().find(|step| f64::from(*step) * tens >= error * (1.0 + 1e-9));
    step.map_or_else(|| format!("1e{}", power + 1), |step| format!("{step}e{power}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_accuracy_to_ask_for_is_a_round_one_above_the_error() {
        assert_eq!([2.04e-8, 9.9e-7, 1.1e-3, 3e-4, 0.02].map(above), ["5e-8", "1e-6", "2e-3", "5e-4", "5e-2"]);
    }
}
