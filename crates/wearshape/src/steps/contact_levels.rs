//! Contact level by level until its estimated errors are below the accuracy asked for.

use std::ops::ControlFlow;

use crate::effort::Effort;
use crate::fixed;
use crate::heat_result::HeatResult;
use crate::ladder::{Climbed, Ladder, Refusal, best, climb, expected, largest, missed};
use crate::level::Level;
use crate::results::{ContactResult, EnergyResult, ErrorResult, InterfaceResult, Reaction};
use crate::solution::{Rung, Status};
use crate::steps::answer::{Outcome, Told};
use crate::steps::diagnosis::Diagnosis;
use crate::steps::ends_error;
use crate::steps::many_ends::ManyEnds;
use crate::steps::reported::Reported;
use crate::steps::twist::Turned;
use crate::watch::Watch;

/// Levels whose differences are believed when they say that the accuracy is out of reach; with nodes on more ends than usual further ones are dear.
const BELIEVED: usize = 5;
const OUT_OF_REACH: &str = "finer levels do not reach the accuracy";
/// Error of the ends of a contact that a shear force has moved, over how far. Under 100 times the load of `cattaneo-mindlin`, which moves it by .018 mm, they lie
/// between the same points as the ends of the pressure there, 3e-3 mm apart.
const MOVED: f64 = 0.2;
/// Error of a contact over the imbalance of its forces.
const ROUND_OFF: f64 = 2.0;

/// Result of one level.
pub(crate) struct Solved {
    pub contact: ContactResult,
    /// Condition of the system, where it is worked out on every level.
    pub interface: Option<InterfaceResult>,
    pub told: Told,
    /// At the samples, to compare levels.
    pub pressure: Vec<f64>,
    /// Torques or angles of a twist, to compare levels.
    pub twist: Option<Turned>,
    /// Error of the pressure as the embedded degree tells it, for levels without a ladder below them.
    pub embedded: Option<f64>,
    /// Whether ends of contact lie inside elements because nodes did not settle on them.
    pub unsettled: bool,
    /// Of a contact with more ends inside its surface than usual.
    pub many: Option<ManyEnds>,
    /// How far nodes are from the ends of contact, over the length of the contact; about that much the pressure is off by.
    pub misplaced: f64,
    /// How far a shear force has moved the contact from the nodes on its ends, mm.
    pub shifted: f64,
    /// How far the forces on body 2 are from balance, relative: what round-off has made of its equations.
    pub imbalance: f64,
    /// Frictional heat.
    pub heat: Option<HeatResult>,
    /// Why there is no answer.
    pub refused: Option<String>,
    /// For the fields.
    pub reported: Option<Reported>,
    pub effort: Effort,
}

/// What is needed of a level beside its result if it is the reported one.
#[derive(Default)]
pub(crate) struct Aside {
    /// Where its element nodes stand on ends of contact.
    pub nodes: Vec<f64>,
    /// The diagnosis to be made of it.
    pub diagnosis: Option<Diagnosis>,
}

/// Solves level after level until the estimated errors are below the accuracy asked for; reports the last one, or the best where finer ones come out
/// worse, with what `solve_level` gave beside it. That is asked for a level and the error of the pressure which is expected of it, once that can be told.
pub(crate) fn levels(
    ladder: &Ladder,
    watch: &mut Watch<'_>,
    solve_level: &mut dyn FnMut(Level, Option<f64>) -> Result<(Solved, Aside), Refusal>,
) -> Result<(Outcome, Effort, Option<Aside>), Refusal> {
    let mut effort = Effort::default();
    let apart = |(x, _): &(Solved, Aside), (y, _): &(Solved, Aside)| distance(x, y);
    let solve = |level: Level, before: &[(Solved, Aside)], _: &mut Watch<'_>| {
        let last = before.last().map(|(last, _)| last).filter(|last| last.many.is_some() && !last.unsettled);
        if last.is_some() && before.len() >= BELIEVED && !ladder.promises(before, &apart) {
            return Err(Refusal::Reason(OUT_OF_REACH.into()));
        }
        let solved = solve_level(level, expected(before, &apart, 1).filter(|_| !ladder.is_fixed()))?;
        Ok(match &solved.0.refused {
            Some(reason) if ladder.can_do_without(before) => return Err(Refusal::Reason(reason.clone())),
            None if !solved.0.many.is_some_and(|many| many.crowded) => ControlFlow::Continue(solved),
            _ => ControlFlow::Break(Some(solved)),
        })
    };
    let Climbed { solved, mut stopped } = climb(ladder, Vec::new(), solve, apart, watch)?;
    // A level beside that cannot be meshed or solved tells nothing.
    let refused = solved.iter().any(|(level, _)| level.refused.is_some());
    let beside = if refused { None } else { ladder.beside(&mut stopped, watch) };
    let beside = beside.and_then(|level| solve_level(level, None).ok());
    let beside = beside.map(|(level, _)| level).filter(|level| level.refused.is_none());
    beside.iter().for_each(|level| effort += level.effort.clone());
    let (solved, others): (Vec<Solved>, Vec<Aside>) = solved.into_iter().unzip();
    solved.iter().for_each(|level| effort += level.effort.clone());
    let (outcome, reported) = finish(ladder, solved, beside);
    Ok((Outcome { stopped, ..outcome }, effort, others.into_iter().nth(reported)))
}

/// How far two levels are apart: relative differences of the energies (0 with heat, whose strains the work of the loads does not know), of the pressure
/// (L2 over the inner 95 % of the contact), and of a twist (0 without one). With heat the ends of contact move the pressure by as much as themselves,
/// over its length, and levels may agree by chance in one of both.
fn distance(x: &Solved, y: &Solved) -> [f64; 3] {
    let hot = y.heat.is_some();
    let energy = if hot { 0.0 } else { apart(&x.told.energy, &y.told.energy) };
    let ends = if hot { ends_error::apart(&x.contact.ends, &y.contact.ends) } else { 0.0 };
    let pressure = relative_difference(&x.pressure, &y.pressure).max(ends);
    [energy, pressure, x.twist.as_ref().zip(y.twist.as_ref()).map_or(0.0, |(x, y)| x.apart(y))]
}

/// Differences of the energies of both bodies over the sum of these: the energy that an end of contact a little off gives to one body it takes from the
/// other, so that a level may have the sum right by chance.
fn apart(x: &EnergyResult, y: &EnergyResult) -> f64 {
    let body = |x: Option<f64>, y: Option<f64>| (x.unwrap_or(0.0) - y.unwrap_or(0.0)).abs();
    (body(x.body1, y.body1) + body(x.body2, y.body2)) / y.total().abs()
}

/// `|x - y| / |y|` in the Euclidean norm.
fn relative_difference(x: &[f64], y: &[f64]) -> f64 {
    let square = |f: &dyn Fn(usize) -> f64| (0..y.len()).map(|i| f(i).powi(2)).sum::<f64>();
    (square(&|i| x[i] - y[i]) / square(&|i| y[i])).sqrt()
}

/// How far the supports of body 2 are from carrying the contact force along x and z and its moment about the origin, each as far as given, relative.
pub(crate) fn imbalance(reactions: &[(String, Reaction)], force: [Option<f64>; 2], moment: Option<[f64; 2]>) -> f64 {
    let total = |of: fn(&Reaction) -> Option<f64>| -> Option<f64> {
        reactions.iter().filter(|(name, _)| name.starts_with("body2.")).map(|(_, reaction)| of(reaction)).sum()
    };
    let size = force.iter().flatten().fold(0.0, |most: f64, f| most.max(f.abs()));
    let off = |carried: Option<f64>, needed: Option<f64>, size: f64| match carried.zip(needed) {
        Some((carried, needed)) if size > 0.0 => (carried - needed).abs() / size,
        _ => 0.0,
    };
    let along = [off(total(|r| r.x), force[0], size), off(total(|r| r.z), force[1], size)];
    let turning = moment.map_or(0.0, |[moment, arm]| off(total(|r| r.moment), Some(moment), moment.abs().max(size * arm)));
    largest(&[along[0], along[1], turning])
}

/// What is reported, and of which level.
fn finish(ladder: &Ladder, mut solved: Vec<Solved>, beside: Option<Solved>) -> (Outcome, usize) {
    let rungs = ladder.rungs(&solved, ("pressure", 1), distance);
    let levels = solved.len();
    let (count, found) = match solved.last().zip(beside.as_ref()) {
        Some((last, beside)) => (levels, Some(distance(last, beside).map(fixed::error))),
        None => best(ladder, &solved, &distance).map_or((levels, None), |(count, errors)| (count, Some(errors))),
    };
    solved.truncate(count);
    let ends_off = |of: fn(&ContactResult) -> &[f64]| {
        let ends: Vec<&[f64]> = solved.iter().map(|level| of(&level.contact)).collect();
        let misplaced = solved.last().map_or(0.0, |last| last.misplaced);
        let shifted = solved.last().map_or(0.0, |last| MOVED * last.shifted);
        ends_error::of(&ends, beside.as_ref().map(|beside| of(&beside.contact)), misplaced).map(|error| error.max(shifted))
    };
    let ends_off = [ends_off(|contact| &contact.ends), ends_off(|contact| &contact.stick_ends)];
    let Some(last) = solved.pop() else { return Default::default() };
    let other = beside.as_ref().or(solved.last());
    let p_max_off = last.contact.p_max.zip(other.and_then(|other| other.contact.p_max)).map(|(p, other)| ((p - other) / p).abs());
    // Displacements are off by about what equilibrium is off by, and no series of levels tells that.
    let found = found.map(|errors| errors.map(|error| error.max(ROUND_OFF * last.imbalance)));
    // Levels may have their nodes equally far from the ends, which their differences do not tell either.
    let found = found.map(|[energy, pressure, twist]| [energy, pressure.max(last.misplaced), twist]);
    let mut outcome = report(ladder, last, found, rungs);
    if count < levels {
        outcome.error.how += &format!("; the best of them is reported, of degree {}", ladder.levels[count - 1].degree);
    }
    if found.is_some() && outcome.told.is_some() && !matches!(outcome.ended, Some((Status::Refused, _))) {
        [outcome.error.ends, outcome.error.stick_ends] = ends_off;
        outcome.error.p_max_relative = p_max_off;
    }
    outcome.tell(found.filter(|_| ladder.is_fixed()).map(|[_, pressure, _]| pressure));
    (outcome, count - 1)
}

/// What is reported of a level with these estimated errors.
fn report(ladder: &Ladder, mut last: Solved, found: Option<[f64; 3]>, rungs: Vec<Rung>) -> Outcome {
    let levels = rungs.len();
    let hot = last.heat.is_some();
    if hot {
        // The work of the loads is no strain energy where there are thermal strains.
        last.told.energy = EnergyResult::default();
    }
    let mut outcome = Outcome {
        contact: Some(last.contact),
        interface: last.interface,
        told: Some(last.told),
        heat: last.heat,
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
            energy_relative: Some(energy).filter(|_| !hot),
            pressure_relative: Some(pressure),
            twist_relative: last.twist.as_ref().map(|_| twist),
            how: format!("{}pressure of the contact: {}", if hot { "" } else { "energy and " }, ladder.told_by(levels)),
            ..ErrorResult::default()
        },
    };
    let Some(found) = found else {
        if let Some(many) = last.many.filter(|many| many.crowded && !ladder.is_fixed()) {
            let reason = format!("the error of the contact is not known: {}", many.words());
            outcome.ended = Some((Status::AccuracyMissed, reason));
        }
        return outcome;
    };
    if last.unsettled {
        outcome.error.how += "; nodes did not settle on the ends of contact, which lie inside elements";
    }
    let worst = largest(&found[..if last.twist.is_some() { 3 } else { 2 }]);
    if let Some(accuracy) = ladder.missed(worst) {
        let why = last.many.map(|many| format!("; {}", many.words())).unwrap_or_default();
        outcome.error.how += &why;
        outcome.ended = Some((Status::AccuracyMissed, missed("contact", worst, accuracy) + &why));
    }
    outcome
}

/// The error of a fixed discretisation by itself.
fn embedded(pressure: Option<f64>) -> ErrorResult {
    let how = "pressure of the contact: what its highest degree on each edge adds; energy: not estimated";
    match pressure {
        Some(_) => ErrorResult { pressure_relative: pressure, how: how.into(), ..ErrorResult::default() },
        None => ErrorResult::default(),
    }
}
