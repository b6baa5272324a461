//! Accuracy by levels: degree after degree until the differences of successive ones say that it is enough.

use std::cell::Cell;
use std::ops::ControlFlow;

use crate::fixed;
use crate::level::Level;
use crate::options::Options;
use crate::problem::Problem;
pub(crate) use crate::refusal::Refusal;
use crate::series::{SLOWEST, is_chance, rest, rest_after};
use crate::solution::Rung;
use crate::step::Step;
use crate::watch::{Event, Watch};

/// First degree of the ladder.
pub(crate) const FIRST: usize = 4;
/// First and last degree of the ladder, and its step.
const DEGREES: [usize; 3] = [FIRST, 16, 2];
/// Degrees after those, and how far above the accuracy asked for the estimated error may be to climb on to them, unless they reach it as errors fall.
const BEYOND: [usize; 2] = [18, 20];
const NEARLY: f64 = 10.0;
/// Digits that are there before each level gains one more, about, before errors tell: five after the three levels that tell an error.
const BEFORE: f64 = 3.0;
/// The same as a ratio of errors.
const GAIN: f64 = 0.03;
/// Successive levels without a smaller difference after which finer ones are of no use: round-off, or something that degrees do not mend.
const IDLE: usize = 2;
/// A level that is so many times farther away than the one before it was, after a steady fall, is the wrong one of both.
const WILD: f64 = 100.0;

/// Levels from which an error can be estimated: every solve climbs them, or all that there are.
pub(crate) const LEAST: usize = 3;

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
    /// The level beside a fixed one that tells its error.
    beside: Option<Level>,
    /// Of levels whose differences fall in no order the number of the last ones of which the largest is the error; a level may tell.
    unordered: Cell<Option<usize>>,
}

impl Ladder {
    /// The levels of a problem: the fixed one, or until the accuracy is reached.
    pub(crate) fn of(problem: &Problem, options: &Options<'_>, step: Step) -> Ladder {
        let levels = levels(problem, options, step);
        let accuracy = problem.wanted.fixed.is_none().then_some(problem.wanted.accuracy);
        let beside = problem.wanted.fixed.filter(|_| step != Step::Evolution && !options.alone).map(fixed::beside);
        Ladder { step, usual: levels.len(), levels, accuracy, beside, unordered: Cell::default() }
    }

    /// Says that differences of levels fall in no order, if they do: the error is the largest of so many of the last ones.
    pub(crate) fn unordered(&self, of: Option<usize>) {
        self.unordered.set(self.unordered.get().max(of));
    }

    /// Estimated errors of the last of at least three levels.
    pub(crate) fn errors<T, const N: usize>(&self, solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N]) -> Option<[f64; N]> {
        let [.., _, _, _] = solved else { return None };
        let Some(count) = self.unordered.get() else { return errors(solved, distance) };
        let last = solved[solved.len().saturating_sub(count + 1)..].windows(2).map(|pair| distance(&pair[0], &pair[1]));
        last.reduce(|most, next| std::array::from_fn(|k| most[k].max(next[k])))
    }

    /// The same from the next level on, if enough are left to tell an error.
    pub(crate) fn finer(&self) -> Option<Ladder> {
        let next = || Ladder { levels: self.levels[1..].to_vec(), usual: self.usual - 1, ..self.clone() };
        (!self.is_fixed() && self.usual > LEAST).then(next)
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
                self.beside = None;
            }
        }
        self
    }

    /// The levels that are expected to be solved, before anything is: all of a fixed discretisation.
    pub(crate) fn expected(mut self) -> Vec<Level> {
        if self.accuracy.is_some() {
            self.levels.truncate(1 + self.left(0, None));
        }
        self.levels
    }

    /// Levels expected after this one, from the errors before it: the last one and the ratio at which they fall.
    fn left(&self, number: usize, errors: Option<[f64; 2]>) -> usize {
        let last = self.usual.max(number + 1) - 1;
        let Some(accuracy) = self.accuracy else { return last - number + usize::from(self.beside.is_some()) };
        let more = match errors {
            Some([error, ratio]) => ((accuracy / error).ln() / ratio.ln()).ceil().max(1.0) as usize - 1,
            None => ((-accuracy.log10() - BEFORE - 1e-9).ceil().max(2.0) as usize).saturating_sub(number),
        };
        more.min(last - number)
    }

    /// Whether the level that follows those `solved` is hardly the last one.
    pub(crate) fn expects_more<T, const N: usize>(&self, solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N]) -> bool {
        let Some(accuracy) = self.accuracy.filter(|_| solved.len() + 1 < self.levels.len()) else { return false };
        match falls(solved, distance) {
            Some([error, ratio]) => error * ratio > NEARLY * accuracy,
            // The third level, whose error is two gains below the difference of those before it.
            None => match solved {
                [first, second] => largest(&distance(first, second)) * GAIN * GAIN > accuracy,
                _ => solved.len() + 1 < LEAST,
            },
        }
    }

    /// Whether the levels from this one on are worth climbing, by the last error and the ratio at which errors fall.
    fn goes_beyond(&self, number: usize, [error, ratio]: [f64; 2]) -> bool {
        let there = error * ratio.powi((self.levels.len() - number) as i32);
        self.accuracy.is_some_and(|accuracy| error <= NEARLY * accuracy || there <= accuracy)
    }

    /// The accuracy that a ladder with these estimated errors has missed, if it has.
    pub(crate) fn missed(&self, error: f64) -> Option<f64> {
        self.accuracy.filter(|accuracy| error > *accuracy)
    }

    /// Whether finer levels are still to reach the accuracy, as the differences of those solved fall.
    pub(crate) fn promises<T, const N: usize>(&self, solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N]) -> bool {
        let Some(([error, ratio], accuracy)) = falls(solved, distance).zip(self.accuracy) else { return true };
        let left = self.levels.len().saturating_sub(solved.len());
        error * ratio.powi(left as i32) <= accuracy
    }

    /// Whether further levels are no use after such changes from level to level. Where these have no order, small ones count once the large ones before
    /// them are no longer among the last.
    fn is_stuck(&self, changes: &[f64]) -> bool {
        let waits =
            self.unordered.get().is_some() && self.accuracy.zip(changes.last()).is_some_and(|(accuracy, last)| *last <= accuracy);
        self.accuracy.is_some() && !waits && idle(changes)
    }

    /// Whether the discretisation is fixed.
    pub(crate) fn is_fixed(&self) -> bool {
        self.accuracy.is_none()
    }

    /// Whether a level that fails is given up for those `solved` before it, which tell their error.
    pub(crate) fn can_do_without<T>(&self, solved: &[T]) -> bool {
        self.accuracy.is_some() && solved.len() > 2
    }

    /// What solved levels say about the error of their quantity number `which`, called `quantity`.
    pub(crate) fn rungs<T, const N: usize>(
        &self,
        solved: &[T],
        (quantity, which): (&'static str, usize),
        distance: impl Fn(&T, &T) -> [f64; N],
    ) -> Vec<Rung> {
        let rung = |(i, level): (usize, &Level)| Rung {
            quantity,
            degree: level.degree,
            change: (i > 0).then(|| distance(&solved[i - 1], &solved[i])[which]),
            estimate: self.errors(&solved[..=i], &distance).map(|errors| errors[which]),
        };
        self.levels.iter().take(solved.len()).enumerate().map(rung).collect()
    }

    /// The level beside a fixed one, told to the watcher, unless a solve is `stopped` or this stops it.
    pub(crate) fn beside(&self, stopped: &mut bool, watch: &mut Watch<'_>) -> Option<Level> {
        let level = self.beside.filter(|_| !*stopped)?;
        let event = Event::Level { step: self.step, degree: level.degree, layers: level.layers, left: 0 };
        *stopped = watch(event).is_break();
        (!*stopped).then_some(level)
    }

    /// The level to report of a gap, and its estimated error: by the series of levels, or on a fixed discretisation by the level beside it.
    pub(crate) fn to_report<'s, T>(
        &self,
        solved: &'s [T],
        beside: Option<&T>,
        distance: &impl Fn(&T, &T) -> [f64; 1],
    ) -> (Option<&'s T>, Option<f64>) {
        match best(self, solved, distance) {
            Some((count, [error])) => (solved.get(count - 1), Some(error)),
            None => (solved.last(), solved.last().zip(beside).map(|(last, beside)| fixed::error(distance(last, beside)[0]))),
        }
    }

    /// What tells the estimated error of so many solved levels.
    pub(crate) fn told_by(&self, levels: usize) -> String {
        match self.beside {
            Some(Level { degree, layers, .. }) => format!("difference from degree {degree} with {layers} layers"),
            None if self.unordered.get().is_some() => format!("largest difference of the last of {levels} degrees"),
            None => format!("rest of the series of {levels} degrees"),
        }
    }

    /// Estimated error of the gap of the last of three levels of a run in time on a fixed discretisation.
    pub(crate) fn error_in_time<T>(&self, solved: &[T], distance: &impl Fn(&T, &T) -> f64) -> Option<f64> {
        let (fixed, [a, b, c]) = (self.levels.last()?, solved) else { return None };
        Some(match self.unordered.get() {
            Some(1) => distance(b, c),
            Some(_) => distance(a, b).max(distance(b, c)),
            None => fixed::error_in_time(*fixed, distance(a, b), distance(b, c)),
        })
    }
}

/// The levels that a step may climb: the fixed one, of a contact and in time those up to it, or those of the usual degrees.
pub(crate) fn levels(problem: &Problem, options: &Options<'_>, step: Step) -> Vec<Level> {
    let [first, last, by] = DEGREES;
    match problem.wanted.fixed {
        Some(level) if step == Step::Evolution && !options.alone => fixed::levels_of_wear(level),
        Some(level) if step == Step::Contact && !options.alone => fixed::levels_of_contact(level),
        Some(level) => vec![level],
        None => (first..=last).step_by(by).map(|degree| problem.level(degree)).collect(),
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

/// Solves level after level until it is enough, or until one cannot be meshed or solved and those before it have an estimate; `solve` is given the
/// levels before and ends the ladder by `Break`, with its level or, where the watcher cut that short, without. `distance` is how far two levels
/// are apart, one relative number a quantity. Levels that are `known` are not solved again.
pub(crate) fn climb<T, const N: usize>(
    ladder: &Ladder,
    known: Vec<T>,
    mut solve: impl FnMut(Level, &[T], &mut Watch<'_>) -> Result<ControlFlow<Option<T>, T>, Refusal>,
    distance: impl Fn(&T, &T) -> [f64; N],
    watch: &mut Watch<'_>,
) -> Result<Climbed<T>, Refusal> {
    let mut solved = known;
    for (number, level) in ladder.levels.iter().copied().enumerate().skip(solved.len()) {
        let fall = falls(&solved, &distance);
        if number >= ladder.usual && !fall.is_some_and(|fall| ladder.goes_beyond(number, fall)) {
            break;
        }
        let left = ladder.left(number, fall);
        if watch(Event::Level { step: ladder.step, degree: level.degree, layers: level.layers, left }).is_break() {
            return Ok(Climbed { solved, stopped: true });
        }
        let next = match solve(level, &solved, watch) {
            // More accuracy must not lose the answer that is there.
            Err(_) if ladder.can_do_without(&solved) => break,
            next => next?,
        };
        let (level, more) = match next {
            ControlFlow::Continue(level) => (level, true),
            ControlFlow::Break(Some(level)) => (level, false),
            ControlFlow::Break(None) => return Ok(Climbed { solved, stopped: true }),
        };
        solved.push(level);
        let error = ladder.errors(&solved, &distance).map(|errors| largest(&errors));
        let enough = ladder.accuracy.zip(error).is_some_and(|(accuracy, error)| error <= accuracy);
        if !more || enough || ladder.is_stuck(&changes(&solved, &distance)) {
            break;
        }
    }
    Ok(Climbed { solved, stopped: false })
}

/// Largest difference of each level from the one before it.
fn changes<T, const N: usize>(solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N]) -> Vec<f64> {
    solved.windows(2).map(|pair| largest(&distance(&pair[0], &pair[1]))).collect()
}

/// Whether differences of successive levels that fell before no longer do.
fn idle(changes: &[f64]) -> bool {
    let (before, last) = changes.split_at(changes.len().saturating_sub(IDLE));
    let least = before.iter().copied().fold(f64::INFINITY, f64::min);
    before.len() > 2 && last.iter().all(|change| *change >= least) || broken_off(changes)
}

/// Whether a series of differences that fell fast has come to its end: the last one falls hardly at all, and is more than all that the ones before it
/// had left to come. What is there then is no error of the discretisation that finer levels take away.
fn broken_off(changes: &[f64]) -> bool {
    let [.., a, b, c, last] = *changes else { return false };
    a > b && b > c && !is_chance(a, b, c) && last >= SLOWEST * c && last > rest(b, c)
}

/// The levels of a ladder up to the one to report, with its estimated errors: the last one, or where finer ones came out worse the one with the
/// smallest error that these leave credible. `None` from fewer than three levels.
pub(crate) fn best<T, const N: usize>(
    ladder: &Ladder,
    solved: &[T],
    distance: &impl Fn(&T, &T) -> [f64; N],
) -> Option<(usize, [f64; N])> {
    let last = ladder.errors(solved, distance)?;
    let ended = (solved.len(), last);
    if ladder.missed(largest(&last)).is_none() {
        return Some(ended);
    }
    let changes = changes(solved, distance);
    let of = |count: usize| {
        let errors = ladder.errors(&solved[..count], distance)?;
        Some(credible(solved, &changes, count, errors, distance))
    };
    let all = (3..=solved.len()).filter_map(|count| Some((count, of(count)?)));
    let best = all.min_by(|(_, a), (_, b)| largest(a).total_cmp(&largest(b)));
    best.or(Some(ended))
}

/// Estimated errors of the level number `count` after what finer ones say of it: it is as far away as the nearest of them, unless
/// a steady fall up to it shows that these are wrong.
fn credible<T, const N: usize>(
    solved: &[T],
    changes: &[f64],
    count: usize,
    errors: [f64; N],
    distance: &impl Fn(&T, &T) -> [f64; N],
) -> [f64; N] {
    let apart = solved[count..].iter().map(|finer| distance(&solved[count - 1], finer));
    let Some(nearest) = apart.min_by(|a, b| largest(a).total_cmp(&largest(b))) else { return errors };
    let fell = &changes[count.saturating_sub(4)..count - 1];
    let steadily = fell.len() > 2 && fell.windows(2).all(|pair| pair[1] < pair[0]);
    if steadily && largest(&nearest) > WILD * fell[fell.len() - 1] {
        return errors;
    }
    std::array::from_fn(|k| errors[k].max(nearest[k]))
}

/// The largest of several errors.
pub(crate) fn largest(errors: &[f64]) -> f64 {
    errors.iter().copied().fold(0.0, f64::max)
}

/// Estimated errors of the last of at least three levels.
pub(crate) fn errors<T, const N: usize>(solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N]) -> Option<[f64; N]> {
    let [.., a, b, c] = solved else { return None };
    let (older, newer) = (distance(a, b), distance(b, c));
    let before = solved.len().checked_sub(4).map(|first| distance(&solved[first], a));
    Some(std::array::from_fn(|k| rest_after(before.map(|before| before[k]), older[k], newer[k])))
}

/// The estimated error of the last of at least three levels, and the ratio at which differences fall.
fn falls<T, const N: usize>(solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N]) -> Option<[f64; 2]> {
    let [.., a, b, c] = solved else { return None };
    let [older, newer] = [distance(a, b), distance(b, c)].map(|distances| largest(&distances));
    let error = largest(&errors(solved, distance)?);
    Some([error, ratio(older, newer)])
}

/// Ratio of successive differences; those of nothing, or that grow, tell none.
fn ratio(older: f64, newer: f64) -> f64 {
    if older > 0.0 { (newer / older).clamp(1e-3, SLOWEST) } else { SLOWEST }
}

/// Error of quantity number `which` that is to be expected of the level after those solved, as its errors fall.
pub(crate) fn expected<T, const N: usize>(solved: &[T], distance: &impl Fn(&T, &T) -> [f64; N], which: usize) -> Option<f64> {
    let [.., a, b, c] = solved else { return None };
    let [older, newer] = [distance(a, b), distance(b, c)].map(|distances| distances[which]);
    errors(solved, distance).map(|errors| errors[which] * ratio(older, newer))
}

/// The sentence of an accuracy that was missed.
pub(crate) fn missed(what: &str, error: f64, accuracy: f64) -> String {
    format!("the {what} is accurate to {error:.1e}, not to the {accuracy:.0e} asked for")
}

#[cfg(test)]
mod tests;
