//! Contact level by level until its estimated errors are below the accuracy asked for.

use std::ops::ControlFlow;

use crate::effort::Effort;
use crate::ladder::{Climbed, Ladder, Refusal, climb, errors, largest, missed, rungs};
use crate::level::Level;
use crate::results::{ContactResult, ErrorResult, InterfaceResult};
use crate::solution::Status;
use crate::steps::answer::{Outcome, Told};
use crate::steps::reported::Reported;
use crate::watch::Watch;

/// Result of one level.
pub(crate) struct Solved {
    pub contact: ContactResult,
    /// Condition of the system, where it is worked out on every level.
    pub interface: Option<InterfaceResult>,
    pub told: Told,
    /// At the samples, to compare levels.
    pub pressure: Vec<f64>,
    /// Torque or angle of a twist, to compare levels.
    pub twist: Option<f64>,
    /// Error of the pressure as the embedded degree tells it, for levels without a ladder below them.
    pub embedded: Option<f64>,
    /// Whether ends of contact lie inside elements because nodes did not settle on them.
    pub unsettled: bool,
    /// Number of ends of contact inside the surface, where they are so many that the next level would have too many unknowns on it.
    pub crowded: Option<usize>,
    /// Why there is no answer.
    pub refused: Option<String>,
    /// For the fields.
    pub reported: Option<Reported>,
    pub effort: Effort,
}

/// Solves level after level until the estimated errors are below the accuracy asked for, and reports the last one.
pub(crate) fn levels(
    ladder: &Ladder,
    watch: &mut Watch<'_>,
    mut solve_level: impl FnMut(Level) -> Result<Solved, Refusal>,
) -> Result<(Outcome, Effort), Refusal> {
    let solve = |level: Level, _: &[Solved], _: &mut Watch<'_>| {
        let solved = solve_level(level)?;
        let last = solved.refused.is_some() || solved.crowded.is_some();
        Ok(if last { ControlFlow::Break(Some(solved)) } else { ControlFlow::Continue(solved) })
    };
    let Climbed { solved, stopped } = climb(ladder, Vec::new(), solve, distance, watch)?;
    let mut effort = Effort::default();
    solved.iter().for_each(|level| effort += level.effort.clone());
    Ok((Outcome { stopped, ..finish(ladder, solved) }, effort))
}

/// How far two levels are apart: relative differences of the energy, of the pressure (L2 over the inner 95 % of the contact), and of a twist
/// (0 without one).
fn distance(x: &Solved, y: &Solved) -> [f64; 3] {
    let relative = |x: f64, y: f64| if x == y { 0.0 } else { ((x - y) / y).abs() };
    let [first, second] = [x, y].map(|level| level.told.energy.total());
    let energy = ((first - second) / second).abs();
    [energy, relative_difference(&x.pressure, &y.pressure), x.twist.zip(y.twist).map_or(0.0, |(x, y)| relative(x, y))]
}

/// `|x - y| / |y|` in the Euclidean norm.
fn relative_difference(x: &[f64], y: &[f64]) -> f64 {
    let square = |f: &dyn Fn(usize) -> f64| (0..y.len()).map(|i| f(i).powi(2)).sum::<f64>();
    (square(&|i| x[i] - y[i]) / square(&|i| y[i])).sqrt()
}

fn finish(ladder: &Ladder, mut solved: Vec<Solved>) -> Outcome {
    let degrees: Vec<usize> = ladder.levels.iter().map(|level| level.degree).collect();
    let rungs = rungs(&degrees, &solved, "pressure", 1, distance);
    let found = errors(&solved, &distance);
    let levels = solved.len();
    let Some(last) = solved.pop() else { return Outcome::default() };
    let mut outcome = Outcome {
        contact: Some(last.contact),
        interface: last.interface,
        told: Some(last.told),
        ladder: rungs,
        ..Outcome::default()
    };
    if let Some(reason) = last.refused {
        outcome.ended = Some((Status::Refused, reason));
        return outcome;
    }
    outcome.reported = last.reported;
    outcome.error = match found {
        None => embedded(last.embedded.filter(|_| ladder.is_fixed())),
        Some([energy, pressure, twist]) => ErrorResult {
            energy_relative: Some(energy),
            pressure_relative: Some(pressure),
            twist_relative: last.twist.map(|_| twist),
            how: format!("energy and pressure of the contact: rest of the series of {levels} degrees"),
            ..ErrorResult::default()
        },
    };
    let Some(found) = found else { return outcome };
    if last.unsettled {
        outcome.error.how += "; nodes did not settle on the ends of contact, which lie inside elements";
    }
    if let Some(ends) = last.crowded {
        outcome.error.how +=
            &format!("; with {ends} ends of contact inside the surface finer levels are left out: a smoother gap has fewer");
    }
    let worst = largest(&found[..if last.twist.is_some() { 3 } else { 2 }]);
    if let Some(accuracy) = ladder.missed(worst) {
        outcome.ended = Some((Status::AccuracyMissed, missed("contact", worst, accuracy)));
    }
    outcome
}

/// The error of a fixed discretisation without coarser ones.
fn embedded(pressure: Option<f64>) -> ErrorResult {
    let how = "pressure of the contact: what its highest degree on each edge adds; energy: not estimated below degree 5";
    match pressure {
        Some(_) => ErrorResult { pressure_relative: pressure, how: how.into(), ..ErrorResult::default() },
        None => ErrorResult::default(),
    }
}
