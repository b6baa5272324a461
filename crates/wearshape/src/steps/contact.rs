//! The contact stage: the bodies as given, pressed together and sliding.

use std::ops::ControlFlow;
use std::sync::Arc;

use contact::{ContactOperator, ContactSolution, Pair, Status as ContactStatus};
use meshing::{Cut, Extent};
use scene::{Fault, Gap};

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::ladder::{Climbed, Ladder, Refusal, climb, errors, largest, missed, rungs};
use crate::level::Level;
use crate::plan::Step;
use crate::solution::{ContactResult, ErrorResult, InterfaceResult, Status};
use crate::stage::Stage;
use crate::steps::answer::{Answer, Outcome, Own, Told};
use crate::steps::diagnosis::Diagnosis;
use crate::steps::free_ends::{FreeEnds, inner, pairs, zones};
use crate::steps::recover::{Moment, Reported};
use crate::steps::twist::Twist;
use crate::steps::{sharp_edges, torsion};
use crate::watch::Watch;

/// Relative violation of signs below which a solution with its points held in contact is the contact's.
const SIGNS_HOLD: f64 = 1e-9;
/// Relative violation of signs above which that solution is no start for the contact's.
const NEAR: f64 = 1e-3;

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
    /// Why there is no answer.
    pub refused: Option<String>,
    /// For the fields.
    pub reported: Option<Reported>,
    pub effort: Effort,
}

/// Solves the contact.
pub(crate) fn solve(stage: Stage<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort), Refusal> {
    let mut search = Search::default();
    let ladder = Ladder::of(stage.problem, stage.options).and_beyond(stage.problem);
    let (mut outcome, effort) = levels(&ladder, watch, |level| solve_level(stage, level, &mut search))?;
    search.report(stage, &mut outcome)?;
    if let Some((level, profile)) = search.last.zip(outcome.told.as_ref().map(|told| &told.profile)) {
        let is_closed = |status: Option<&&'static str>| status.is_some_and(|status| *status == "contact");
        let closed = [is_closed(profile.status.first()), is_closed(profile.status.last())];
        let note = sharp_edges::note(stage, level.layers, closed)?;
        // The largest value at a point says nothing about an infinite pressure.
        if let Some(contact) = outcome.contact.as_mut().filter(|_| note.is_some()) {
            (contact.p_max, contact.q_max) = (None, None);
        }
        outcome.remarks.extend(note);
    }
    Ok((outcome, effort))
}

/// Solves level after level until the estimated errors are below the accuracy asked for, and reports the last one.
pub(crate) fn levels(
    ladder: &Ladder,
    watch: &mut Watch<'_>,
    mut solve_level: impl FnMut(Level) -> Result<Solved, Refusal>,
) -> Result<(Outcome, Effort), Refusal> {
    let solve = |level: Level, _: &[Solved], _: &mut Watch<'_>| {
        let solved = solve_level(level)?;
        Ok(if solved.refused.is_some() { ControlFlow::Break(Some(solved)) } else { ControlFlow::Continue(solved) })
    };
    let Climbed { solved, stopped } = climb((ladder, Step::Contact), Vec::new(), solve, distance, watch)?;
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
    let rungs = rungs(&degrees, &solved, ("pressure", 1), distance);
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

/// What one level leaves to the next: its ends of contact, and the diagnosis that is made if it is the last.
#[derive(Default)]
pub(crate) struct Search {
    ends: FreeEnds,
    diagnosis: Option<Diagnosis>,
    last: Option<Level>,
}

impl Search {
    /// What the last contact rests on.
    pub(crate) fn report(&self, stage: Stage<'_>, outcome: &mut Outcome) -> Result<(), Fault> {
        if let Some((diagnosis, contact)) = self.diagnosis.as_ref().zip(outcome.contact.as_mut()) {
            let (uniqueness, interface) = diagnosis.made(stage)?;
            contact.uniqueness = uniqueness;
            outcome.interface = interface;
        }
        Ok(())
    }
}

/// Bodies of a level, the contact found on them, and its start gap.
struct Found {
    reduced: Arc<Reduced>,
    found: ContactSolution,
    /// Whether nodes did not settle on the ends of contact.
    unsettled: bool,
}

/// Solves a level; where contact ends inside the surface, with element nodes on its ends, from those of the last level.
/// The diagnosis is left to be made if the level is the last.
pub(crate) fn solve_level(stage: Stage<'_>, level: Level, search: &mut Search) -> Result<Solved, Refusal> {
    let mut effort = Effort::default();
    let Found { reduced, found, unsettled } = find(stage, level, &mut search.ends, &mut effort)?;
    let ends = &search.ends;
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, stage.friction() > 0.0)?;
    let gap = start_gaps(stage, &pair, &operator);
    let (start, length) = (stage.start(&pair), pair.trace().length());
    let twist = match stage.turned_pair(level, &ends.places)? {
        Some((reduced, work)) => {
            effort += work;
            Twist::new(stage.problem, &reduced.pair()?, &found)?
        }
        None => None,
    };
    let mut contact = result(stage, &pair, &operator, &found);
    if !ends.places.is_empty() {
        contact.ends = ends.arcs(length).iter().map(|arc| start + arc).collect();
    }
    twist.iter().for_each(|twist| twist.report(&mut contact, start));
    let embedded = match stage.problem.wanted.fixed {
        Some(_) => operator.embedded_difference(&gap, &stage.contact_load(operator.points()), &found).map_err(unsolved)?,
        None => None,
    };
    let zones = if ends.places.is_empty() { zones(&found, length) } else { pairs(&ends.arcs(length)) };
    let pressure = inner(&zones, length).iter().map(|arc| pressure_at(&pair, &operator, &found.pressure, *arc)).collect();
    let mut told = told(stage, &reduced, (&pair, &operator), (&gap, &found));
    if let Some(twist) = &twist {
        [&mut told.profile, &mut told.curve].into_iter().for_each(|profile| twist.fill(&operator, profile, start));
    }
    let refused = (!found.status.is_solved() || found.status == ContactStatus::NoContact).then(|| found.status.to_string());
    let refused = refused.or_else(|| twist.as_ref().and_then(|twist| twist.refused.clone()));
    let reported = found.counter.clone().map(|counter| {
        let states = [stage.held(&pair, &found.shaped), counter];
        let around = match &twist {
            Some(twist) => twist.last.shear.clone(),
            None => torsion::around(stage, operator.points(), &found.pressure),
        };
        Reported { level, ends: ends.places.clone(), moments: vec![Moment { time: 0.0, name: "", states, around }] }
    });
    let twist = twist.map(|twist| twist.answer);
    search.last = Some(level);
    search.diagnosis = Some(Diagnosis { reduced: Arc::clone(&reduced), found });
    Ok(Solved { contact, interface: None, told, pressure, twist, embedded, unsettled, refused, reported, effort })
}

/// Energies, reactions and columns of a solved contact.
fn told(
    stage: Stage<'_>,
    reduced: &Reduced,
    (pair, operator): (&Pair<'_>, &ContactOperator<'_>),
    (gap, found): (&[f64], &ContactSolution),
) -> Told {
    let arcs: Vec<f64> = operator.points().iter().map(|p| p.arc).collect();
    let between = |point: &contact::ContactPoint| {
        let pressure = pressure_at(pair, operator, &found.pressure, point.arc);
        [pressure, start_gap(stage, pair, point.arc), linear(&arcs, &found.opening, point.arc).max(0.0)]
    };
    let own =
        Own { points: operator.points(), pressure: &found.pressure, gap, opening: &found.opening, closed: Some(&found.closed) };
    let states = [Some(&found.shaped), found.counter.as_ref()];
    Answer { stage, reduced, pair, states, own, between: &between }.told()
}

/// Positions nodes on the ends of contact, if there are any inside the surface, and solves.
fn find(stage: Stage<'_>, level: Level, ends: &mut FreeEnds, effort: &mut Effort) -> Result<Found, Fault> {
    let mut trial = None;
    if ends.places.is_empty() {
        let (found, length, work) = on_standing_mesh(stage, level)?;
        *effort += work;
        *ends = FreeEnds::of(&found, length);
        trial = Some(found);
    }
    let positioned = if ends.places.is_empty() { None } else { ends.position(stage, level, effort)? };
    let mut unsettled = false;
    let (reduced, held) = match positioned {
        Some(positioned) => {
            *ends = positioned.ends;
            *effort += positioned.reduced.sizes();
            (positioned.reduced, Some(positioned.held))
        }
        None => {
            unsettled = !ends.places.is_empty();
            *ends = FreeEnds::default();
            let (reduced, work) = stage.reduced(level, Cut::Plain)?;
            *effort += work;
            (reduced, None)
        }
    };
    let pair = reduced.pair()?;
    let operator = effort.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, stage.friction() > 0.0))?;
    let found = effort.timed(Step::Contact, stage.clock(), |effort| match (trial, held) {
        (Some(found), None) => Ok(found),
        // Every sign is right but for round-off at the ends.
        (_, Some(mut held)) if held.complementarity < SIGNS_HOLD => {
            held.pressure.iter_mut().for_each(|p| *p = p.max(0.0));
            Ok(held)
        }
        (_, held) => {
            effort.counters.contact_solves += 1;
            let near = held.as_ref().filter(|held| held.complementarity < NEAR);
            let gap = start_gaps(stage, &pair, &operator);
            operator.solve(&gap, &stage.contact_load(operator.points()), near).map_err(unsolved)
        }
    })?;
    drop(operator);
    Ok(Found { reduced, found, unsettled })
}

/// The contact on the standing mesh of a level, and the length of its surface.
pub(crate) fn on_standing_mesh(stage: Stage<'_>, level: Level) -> Result<(ContactSolution, f64, Effort), Fault> {
    let (reduced, mut effort) = stage.reduced(level, Cut::Plain)?;
    let pair = reduced.pair()?;
    let operator = effort.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, stage.friction() > 0.0))?;
    let gap = start_gaps(stage, &pair, &operator);
    effort.counters.contact_solves += 1;
    let found = effort.timed(Step::Contact, stage.clock(), |_| {
        operator.solve(&gap, &stage.contact_load(operator.points()), None).map_err(unsolved)
    })?;
    Ok((found, pair.trace().length(), effort))
}

pub(crate) fn unsolved(error: contact::Error) -> Fault {
    Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load")
}

/// The start gaps of the problem at the contact points.
pub(crate) fn start_gaps(stage: Stage<'_>, pair: &Pair<'_>, operator: &ContactOperator<'_>) -> Vec<f64> {
    operator.points().iter().map(|p| start_gap(stage, pair, p.arc)).collect()
}

/// The start gap of the problem at an arc length.
pub(crate) fn start_gap(stage: Stage<'_>, pair: &Pair<'_>, arc: f64) -> f64 {
    gap_at(stage, stage.start(pair) + arc)
}

/// The start gap of the problem at a surface coordinate.
pub(crate) fn gap_at(stage: Stage<'_>, s: f64) -> f64 {
    let given = match &stage.problem.gap {
        Gap::Profile { s: known, gap } => linear(known, gap, s) * 1e-3,
        _ => 0.0,
    };
    match stage.extent {
        Extent::Round { radius, .. } => given + s * s / (radius + ((radius - s) * (radius + s)).max(0.0).sqrt()),
        _ => given,
    }
}

/// Pressure between the points: the polynomial through the points of the edge, or straight lines on an edge that is partly open.
pub(crate) fn pressure_at(pair: &Pair<'_>, operator: &ContactOperator<'_>, pressure: &[f64], arc: f64) -> f64 {
    let (edge, _) = pair.trace().locate(arc);
    let range = operator.edge_points(edge);
    if pressure[range.clone()].contains(&0.0) {
        let arcs: Vec<f64> = operator.points()[range.clone()].iter().map(|p| p.arc).collect();
        return linear(&arcs, &pressure[range], arc);
    }
    operator.value_at(pressure, arc)
}

/// Piecewise linear interpolation in ascending points.
pub(crate) fn linear(points: &[f64], values: &[f64], s: f64) -> f64 {
    let after = points.partition_point(|p| *p < s).clamp(1, points.len() - 1);
    let (a, b) = (points[after - 1], points[after]);
    let t = ((s - a) / (b - a)).clamp(0.0, 1.0);
    (1.0 - t) * values[after - 1] + t * values[after]
}

fn result(stage: Stage<'_>, pair: &Pair<'_>, operator: &ContactOperator<'_>, found: &ContactSolution) -> ContactResult {
    let start = stage.start(pair);
    let about = stage.about();
    let points = operator.points();
    let moment =
        points.iter().zip(&found.nodal_force).map(|(p, force)| (p.position[0] - about) * force * p.normal[1]).sum::<f64>();
    let [_, tz, theta] = motions(pair, found);
    let edge_exponents = sharp_edges::exponents(pair, operator, found);
    let singular = !edge_exponents.is_empty();
    let largest = found.pressure.iter().copied().fold(0.0, f64::max);
    let shear = found.shear.iter().map(|q| q.abs()).fold(0.0, f64::max);
    ContactResult {
        status: word(&found.status).into(),
        force: Some(found.force[1]),
        moment: Some(moment),
        approach: tz.map(|z| -z),
        tilt: theta.map(|t| -t),
        ends: zones(found, pair.trace().length()).iter().flatten().map(|arc| start + arc).collect(),
        // At a sharp corner the pressure is infinite: its exponent says more than the largest nodal value.
        p_max: Some(largest).filter(|_| edge_exponents.is_empty()),
        edge_exponents,
        stick_ends: Vec::new(),
        q_max: Some(shear).filter(|_| !singular),
        twist: None,
        uniqueness: None,
        complementarity: Some(found.complementarity),
        iterations: Some(found.iterations),
    }
}

/// Motions of the rigid edge: t_x, t_z, theta, as far as it is there.
fn motions(pair: &Pair<'_>, found: &ContactSolution) -> [Option<f64>; 3] {
    let frame = pair.shaped.frame;
    frame.map(|unknown| unknown.map(|u| found.shaped.unknowns[u]))
}

/// The status in the summary's word.
pub(crate) fn word(status: &ContactStatus) -> &'static str {
    match status {
        ContactStatus::Converged => "converged",
        ContactStatus::ClosedEverywhere => "closed-everywhere",
        ContactStatus::NoContact => "no-contact",
        ContactStatus::NoBalance => "no-balance",
        ContactStatus::Jammed => "jammed",
        ContactStatus::NotUnique => "not-unique",
        _ => "iteration-limit",
    }
}
