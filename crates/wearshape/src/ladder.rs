//! Accuracy by levels: degree after degree until the differences of successive ones say that it is enough.

use std::ops::ControlFlow;

use scene::Fault;

use crate::level::Level;
use crate::options::Options;
use crate::problem::Problem;
use crate::solution::Rung;
use crate::step::Step;
use crate::watch::{Event, Watch};

/// First and last degree of the ladder, and its step.
const DEGREES: [usize; 3] = [4, 16, 2];
/// Degrees after those, and how far above the accuracy asked for the estimated error may be to climb on to them.
const BEYOND: [usize; 2] = [18, 20];
const NEARLY: f64 = 10.0;
/// Digits that a level gains, about, before errors tell.
const DIGITS: f64 = 1.5;

/// Levels from which an error can be estimated: every solve climbs them, or all that there are.
pub(crate) const LEAST: usize = 3;

/// Why a step has no result.
pub(crate) enum Refusal {
    /// The scene has no answer: a sentence for the summary.
    Reason(String),
    /// The user's to mend.
    Fault(Fault),
}

impl From<Fault> for Refusal {
    fn from(fault: Fault) -> Refusal {
        Refusal::Fault(fault)
    }
}

/// The levels to solve.
#[derive(Debug, Clone)]
pub(crate) struct Ladder {
    /// The step that climbs.
    step: Step,
    /// The levels, coarsest first.
    pub levels: Vec<Level>,
    /// How many of them are solved however far the error is.
    usual: usize,
    /// Relative error at which it is enough; none on a fixed discretisation, whose levels are all solved.
    accuracy: Option<f64>,
}

impl Ladder {
    /// The levels of a problem: up to the fixed one, or until the accuracy is reached.
    pub(crate) fn of(problem: &Problem, options: &Options<'_>, step: Step) -> Ladder {
        let levels = levels(problem, options);
        let accuracy = problem.wanted.fixed.is_none().then_some(problem.wanted.accuracy);
        Ladder { step, usual: levels.len(), levels, accuracy }
    }

    /// The same with further degrees for what is nearly there.
    pub(crate) fn and_beyond(mut self, problem: &Problem) -> Ladder {
        if self.accuracy.is_some() {
            self.levels.extend(BEYOND.map(|degree| problem.level(degree)));
        }
        self
    }

    /// The same for a quantity that is to be more accurate by a factor; of a fixed discretisation the last level alone.
    pub(crate) fn closer(mut self, share: f64) -> Ladder {
        match &mut self.accuracy {
            Some(accuracy) => *accuracy *= share,
            None => {
                self.levels = self.levels.split_off(self.levels.len().saturating_sub(1));
                self.usual = self.levels.len();
            }
        }
        self
    }

    /// Levels expected after this one, from the errors before it: the last one and the ratio at which they fall.
    fn left(&self, number: usize, errors: Option<[f64; 2]>) -> usize {
        let last = self.usual.max(number + 1) - 1;
        let Some(accuracy) = self.accuracy else { return last - number };
        let more = match errors {
            Some([error, ratio]) => ((accuracy / error).ln() / ratio.ln()).ceil().max(1.0) as usize - 1,
            // Three levels tell an error, and each further one gains about a digit and a half.
            None => ((-accuracy.log10() / DIGITS).round().max(2.0) as usize).saturating_sub(number),
        };
        more.min(last - number)
    }

    /// The accuracy that a ladder with these estimated errors has missed, if it has.
    pub(crate) fn missed(&self, error: f64) -> Option<f64> {
        self.accuracy.filter(|accuracy| error > *accuracy)
    }

    /// Whether the discretisation is fixed.
    pub(crate) fn is_fixed(&self) -> bool {
        self.accuracy.is_none()
    }
}

/// The levels that a problem may climb: up to the fixed one, or those of the usual degrees.
pub(crate) fn levels(problem: &Problem, options: &Options<'_>) -> Vec<Level> {
    let [first, last, step] = DEGREES;
    match problem.wanted.fixed {
        Some(level) if options.alone => vec![level],
        None => (first..=last).step_by(step).map(|degree| problem.level(degree)).collect(),
        Some(level) => {
            let below = [4, 2, 0].into_iter().filter(|down| level.degree > *down);
            below.map(|down| Level { degree: level.degree - down, ..level }).collect()
        }
    }
}

/// The levels that were solved.
#[derive(Debug)]
pub(crate) struct Climbed<T> {
    /// Those known before and the new ones, coarsest first.
    pub solved: Vec<T>,
    /// Whether the watcher ended it.
    pub stopped: bool,
}

/// Solves level after level until it is enough, or until one cannot be meshed or solved and those before it have an estimate; `solve` is given the levels before and ends the ladder by `Break`, with its level or, where the
/// watcher cut that short, without. `distance` is how far two levels are apart, one relative number a quantity. Levels that are `known` are not
/// solved again.
pub(crate) fn climb<T, const N: usize>(
    ladder: &Ladder,
    known: Vec<T>,
    mut solve: impl FnMut(Level, &[T], &mut Watch<'_>) -> Result<ControlFlow<Option<T>, T>, Refusal>,
    distance: impl Fn(&T, &T) -> [f64; N],
    watch: &mut Watch<'_>,
) -> Result<Climbed<T>, Refusal> {
    let mut solved = known;
    for (number, level) in ladder.levels.iter().copied().enumerate().skip(solved.len()) {
        let error = errors(&solved, &distance).map(|errors| largest(&errors));
        if number >= ladder.usual && !ladder.accuracy.zip(error).is_some_and(|(accuracy, error)| error <= NEARLY * accuracy) {
            break;
        }
        let left = ladder.left(number, falls(&solved, &distance));
        if watch(Event::Level { step: ladder.step, degree: level.degree, layers: level.layers, left }).is_break() {
            return Ok(Climbed { solved, stopped: true });
        }
        let found = match solve(level, &solved, watch) {
            Err(Refusal::Fault(_)) if solved.len() >= LEAST => break,
            found => found?,
        };
        let (level, more) = match found {
            ControlFlow::Continue(level) => (level, true),
            ControlFlow::Break(Some(level)) => (level, false),
            ControlFlow::Break(None) => return Ok(Climbed { solved, stopped: true }),
        };
        solved.push(level);
        let error = errors(&solved, &distance).map(|errors| largest(&errors));
        if !more || ladder.accuracy.zip(error).is_some_and(|(accuracy, error)| error <= accuracy) {
            break;
        }
    }
    Ok(Climbed { solved, stopped: false })
}

/// The largest of several errors.
pub(crate) fn largest(errors: &[f64]) -> f64 {
    errors.iter().copied().fold(0.0, f64::max)
}

/// Estimated errors of the last of at least three levels.
pub(crate) fn errors<T, const N: usize>(solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N]) -> Option<[f64; N]> {
    let [.., a, b, c] = solved else { return None };
    let (older, newer) = (distance(a, b), distance(b, c));
    Some(std::array::from_fn(|k| rest(older[k], newer[k])))
}

/// The estimated error of the last of at least three levels, and the ratio at which differences fall.
fn falls<T, const N: usize>(solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N]) -> Option<[f64; 2]> {
    let [.., a, b, c] = solved else { return None };
    let [older, newer] = [distance(a, b), distance(b, c)].map(|distances| largest(&distances));
    let error = largest(&errors(solved, distance)?);
    // Differences of nothing, or that grow, tell no ratio.
    let ratio = if older > 0.0 { (newer / older).clamp(1e-3, 0.85) } else { 0.85 };
    Some([error, ratio])
}

/// Estimated error of the last of at least three levels from the differences of successive ones, `older` and `newer`: they fall
/// nearly like a geometric series, and since the fall slows down the ratio enters with the power 3/4 (true error over estimate
/// between 0.3 and 1 on the drum in degrees 8 to 14).
pub(crate) fn rest(older: f64, newer: f64) -> f64 {
    if newer == 0.0 {
        return f64::EPSILON;
    }
    let ratio = (newer / older).clamp(0.0, 0.85).powf(0.75);
    (newer * ratio / (1.0 - ratio)).max(1e-14)
}

/// What solved levels say about the error of their quantity number `which`, called `quantity`.
pub(crate) fn rungs<T, const N: usize>(
    degrees: &[usize],
    solved: &[T],
    quantity: &'static str,
    which: usize,
    distance: impl Fn(&T, &T) -> [f64; N],
) -> Vec<Rung> {
    let rung = |(i, degree): (usize, &usize)| Rung {
        quantity,
        degree: *degree,
        change: (i > 0).then(|| distance(&solved[i - 1], &solved[i])[which]),
        estimate: errors(&solved[..=i], &distance).map(|errors| errors[which]),
    };
    degrees.iter().take(solved.len()).enumerate().map(rung).collect()
}

/// The sentence of an accuracy that was missed.
pub(crate) fn missed(what: &str, error: f64, accuracy: f64) -> String {
    format!("the {what} is accurate to {error:.1e}, not to the {accuracy:.0e} asked for")
}
