//! The contact stage: the bodies as given, pressed together and sliding.

use std::sync::Arc;

use contact::{
    ContactOperator, ContactSolution, FreeEnds, Status as ContactStatus, inner_places, piecewise_linear, without_slivers,
};
use meshing::{BodyLoad, Cut};
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::heat_result::HeatResult;
use crate::ladder::{Ladder, Refusal};
use crate::level::Level;
use crate::profile::Profile;
use crate::solution::Status;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::{Answer, Outcome, Own, Told};
use crate::steps::contact_hot::{self, HotFound, HotSearch};
use crate::steps::contact_levels::{Aside, Solved, imbalance, levels};
use crate::steps::contact_result::{lost, result};
use crate::steps::diagnosis::Diagnosis;
use crate::steps::free_ends::{NO_START, Positioned, SIGNS_HOLD, misplaced, nearer, node_tolerance, position};
use crate::steps::heat::branched::refuse;
use crate::steps::heat::contact::HotContact;
use crate::steps::hertz_trial::short_contact;
use crate::steps::many_ends::{ManyEnds, are_looked_for};
use crate::steps::reported::{Moment, Reported};
use crate::steps::start_gap::{start_gap, start_gaps};
use crate::steps::twist::Twist;
use crate::steps::{all_around, sharp_edges, torsion};
use crate::watch::Watch;
use crate::words::PointStatus;

/// Degree from which on a hot contact that is lost is not looked for on a finer mesh.
const LOST: usize = 8;
/// Samples of the pressure for the comparison of levels, over the inner 95 % of the contact.
const SAMPLES: usize = 191;

/// Solves the contact.
pub(crate) fn solve(stage: Stage<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort), Refusal> {
    let mut ladder = Ladder::of(stage.problem, stage.options, Step::Contact).and_beyond(stage.problem);
    let mut effort = Effort::default();
    let mut hot = HotSearch::default();
    let (search, mut outcome, last) = loop {
        let mut search = Search { hot, ..Search::default() };
        let (outcome, work, last) = levels(&ladder, watch, &mut |level, expected| {
            search.expected = expected;
            solve_level(stage, level, &mut search)
        })?;
        // What is lost on a coarse mesh may be there on a finer one.
        let coarse = search.is_lost && !outcome.stopped && ladder.levels.first().is_some_and(|level| level.degree < LOST);
        effort += work;
        match ladder.finer().filter(|_| coarse) {
            Some(finer) => (ladder, hot) = (finer, search.hot.once_more()),
            None => break (search, outcome, last),
        }
    };
    let diagnosis = last.and_then(|last| last.diagnosis);
    diagnosis.iter().try_for_each(|diagnosis| diagnosis.report(stage, &mut outcome))?;
    if let Some(Diagnosis { level, hot: Some((reduced, _)), found, .. }) = &diagnosis {
        refuse(stage, (*level, &search.ends), &mut outcome, &mut effort)?;
        let is_answer = !matches!(outcome.ended, Some((Status::Refused, _)));
        outcome.remarks.extend(search.hot.note(found, reduced.pair()?.trace().length()).filter(|_| is_answer));
    }
    if let Some((Diagnosis { level, .. }, profile)) = diagnosis.zip(outcome.told.as_ref().map(|told| &told.profile)) {
        let is_closed = |status: Option<&PointStatus>| status == Some(&PointStatus::Contact);
        let closed = [is_closed(profile.status.first()), is_closed(profile.status.last())];
        let edges = sharp_edges::edges(stage, closed)?;
        let note = sharp_edges::note(stage, level.layers, &edges);
        // The largest value at a point says nothing about an infinite pressure.
        if let Some(contact) = outcome.contact.as_mut().filter(|_| note.is_some()) {
            (contact.p_max, contact.q_max) = (None, None);
        }
        let told = outcome.contact.as_ref().is_some_and(|contact| contact.p_max.is_some());
        // Where it sticks, another exponent stands at the edge.
        let unbounded = sharp_edges::unbounded(&edges).filter(|_| told && stage.problem.load.shear_force == 0.0);
        outcome.remarks.extend(note.into_iter().chain(unbounded));
        all_around::refuse_full(stage, &mut outcome);
    }
    Ok((outcome, effort))
}

/// What one level leaves to the next: its ends of contact.
#[derive(Default)]
pub(crate) struct Search {
    ends: FreeEnds,
    /// Error of the pressure that is expected of the level, once that can be told.
    pub(crate) expected: Option<f64>,
    /// Number of levels whose nodes did not settle on the ends.
    lost: usize,
    /// Whether the hot contact of the last level was lost on its way from the cold bodies.
    is_lost: bool,
    /// What the hot contact of the last level leaves, with heat alone.
    hot: HotSearch,
    /// Bodies of the last levels, the latest first: one of them is reported, but for a level that comes out worse. Those of all levels are large.
    latest: [Option<Arc<Reduced>>; 2],
}

/// Bodies of a level, the contact found on them, and its start gap.
struct Found<'a> {
    reduced: Arc<Reduced>,
    found: ContactSolution,
    /// The level that they are of.
    level: Level,
    /// Whether nodes did not settle on the ends of contact.
    unsettled: bool,
    /// The bodies as problems of temperature, and the contact with its heat.
    hot: Option<HotContact<'a>>,
}

/// Solves a level; where contact ends inside the surface, with element nodes on its ends, from those of the last level, which `search` leaves
/// from one level to the next.
pub(crate) fn solve_level(stage: Stage<'_>, level: Level, search: &mut Search) -> Result<(Solved, Aside), Refusal> {
    let mut effort = Effort::default();
    search.latest[1] = search.latest[0].take();
    let Found { reduced, found, level, unsettled, hot } = find(stage, level, search, &mut effort)?;
    let ends = search.ends.clone();
    let pair = reduced.pair()?;
    let operator = reduced.factorised(&pair, stage.friction() > 0.0, None)?;
    let gap = start_gaps(stage, &operator);
    let (start, length) = (stage.start(&pair), pair.trace().length());
    let twist = match stage.turned_pair(level, &ends.places)? {
        Some((reduced, work)) => {
            effort += work;
            Twist::new(stage.problem, &reduced.pair()?, &found)?
        }
        None => None,
    };
    search.is_lost = hot.as_ref().is_some_and(|hot| hot.lost().is_some());
    let mut contact = if search.is_lost { lost(&found) } else { result(stage, &pair, &operator, &found) };
    if !ends.places.is_empty() {
        contact.ends = ends.arcs(length).iter().map(|arc| start + arc).collect();
    }
    twist.iter().for_each(|twist| twist.report(&mut contact, start));
    let at = At { stage, operator: &operator, found: &found, hot: hot.as_ref() };
    let embedded = at.embedded(&gap)?;
    let zones = if ends.places.is_empty() { without_slivers(&found.zones, length) } else { ends.zones(length) };
    let pressure = at.compared(inner_places(&zones, length, SAMPLES), length);
    let mut told = told(stage, &reduced, &operator, &gap, &found);
    // Of a contact that there is not, nothing is told.
    let warm = hot.as_ref().filter(|_| found.status.is_solved());
    let heat = warm.map(|hot| hot.tell(&operator, &mut told, &mut search.hot.speeds)).transpose()?;
    if let Some(twist) = &twist {
        [&mut told.profile, &mut told.curve].into_iter().for_each(|profile| twist.fill(&operator, profile, start));
    }
    let refused = at.refused(heat.as_ref(), twist.as_ref());
    let reported = at.reported(level, &ends, twist.as_ref());
    let twist = twist.map(|twist| twist.told);
    let inside = if unsettled { FreeEnds::of(&found, length).places.len() } else { ends.places.len() };
    let many = ManyEnds::of(inside, level, &effort);
    let solved = Solved {
        contact,
        imbalance: imbalance_of(stage, &told, &found, length),
        interface: None,
        told,
        pressure,
        twist,
        embedded,
        unsettled,
        many,
        shifted: 0.0,
        misplaced: misplaced(&ends, ends.zones(2.0).iter().map(|[from, to]| to - from).sum()),
        heat,
        refused,
        reported,
        effort,
    };
    let hot = hot.as_ref().map(|hot| (Arc::clone(&reduced), hot.load()));
    let diagnosis = Diagnosis { level, ends: ends.places, reduced: Arc::downgrade(&reduced), found, hot };
    search.latest[0] = Some(reduced);
    Ok((solved, Aside { diagnosis: Some(diagnosis), ..Aside::default() }))
}

/// A contact found on its bodies.
struct At<'a> {
    stage: Stage<'a>,
    operator: &'a ContactOperator<'a>,
    found: &'a ContactSolution,
    hot: Option<&'a HotContact<'a>>,
}

impl At<'_> {
    /// Pressures by which levels are compared, at these places on a surface of this length.
    fn compared(&self, places: Vec<f64>, length: f64) -> Vec<f64> {
        let places = self.stage.off_corners(places, length);
        places.iter().map(|arc| self.operator.pressure_at(&self.found.pressure, *arc)).collect()
    }

    /// Error of the pressure as the embedded degree tells it, on a fixed discretisation.
    fn embedded(&self, gap: &[f64]) -> Result<Option<f64>, Fault> {
        if self.stage.problem.wanted.fixed.is_none() {
            return Ok(None);
        }
        let load = self.hot.map_or_else(|| self.stage.contact_load(self.operator.points()), HotContact::load);
        self.operator.embedded_difference(gap, &load, self.found).map_err(unsolved)
    }

    /// Why there is no answer.
    fn refused(&self, heat: Option<&HeatResult>, twist: Option<&Twist>) -> Option<String> {
        let status = &self.found.status;
        let refused = (!status.is_solved() || *status == ContactStatus::NoContact)
            .then(|| self.hot.and_then(HotContact::lost).unwrap_or_else(|| status.to_string()));
        refused.or_else(|| heat?.beyond_critical()).or_else(|| twist?.refused.clone())
    }

    /// What the fields need.
    fn reported(&self, level: Level, ends: &FreeEnds, twist: Option<&Twist>) -> Option<Reported> {
        let around = match twist {
            Some(twist) => twist.last.shear.clone(),
            None => torsion::around(self.stage, self.operator.points(), &self.found.pressure),
        };
        let states = [self.stage.held(self.operator.pair(), &self.found.shaped), self.found.counter.clone()?];
        let heat = self.hot.map(HotContact::heat);
        Some(Reported { level, ends: ends.places.clone(), heat, moments: vec![Moment { time: 0.0, name: "", states, around }] })
    }
}

/// How far the supports of body 2 are from carrying a contact on a surface of this length; 0 where they carry its weight as well.
fn imbalance_of(stage: Stage<'_>, told: &Told, found: &ContactSolution, length: f64) -> f64 {
    if stage.couple.bodies[1].loads.iter().any(BodyLoad::has_resultant) {
        return 0.0;
    }
    match stage.couple.is_revolved() {
        true => imbalance(&told.reactions, [None, Some(found.force[1])], None),
        false => imbalance(&told.reactions, found.force.map(Some), Some([found.moment, 0.1 * length])),
    }
}

/// Energies, reactions and columns of a solved contact.
fn told(stage: Stage<'_>, reduced: &Reduced, operator: &ContactOperator<'_>, gap: &[f64], found: &ContactSolution) -> Told {
    let pair = operator.pair();
    let arcs: Vec<f64> = operator.points().iter().map(|p| p.arc).collect();
    let between = |point: &contact::ContactPoint| {
        let pressure = operator.pressure_at(&found.pressure, point.arc);
        [pressure, start_gap(stage, pair, point.arc), piecewise_linear(&arcs, &found.opening, point.arc).max(0.0)]
    };
    let own =
        Own { points: operator.points(), pressure: &found.pressure, gap, opening: &found.opening, closed: Some(&found.closed) };
    let states = [Some(&found.shaped), found.counter.as_ref()];
    let mut told = Answer { stage, reduced, pair, states, own, between: &between }.told();
    if !found.status.is_solved() {
        // What a search came to that found no contact is no result.
        [&mut told.profile, &mut told.curve].into_iter().for_each(Profile::withdraw);
        (told.energy, told.reactions, told.brake) = Default::default();
    }
    told
}

/// Share of half the surface up to which a contact by the formula of Hertz is too short to be found on a mesh that knows nothing of it.
const SHORT: f64 = 0.1;

/// Trial ends of a short contact of two circles that touch; none of other contacts.
fn short_ends(stage: Stage<'_>) -> FreeEnds {
    let (Some((end, touch)), Some([from, to])) = (short_contact(stage, SHORT), stage.patch.places()) else {
        return FreeEnds::default();
    };
    let half = 0.5 * (to - from);
    FreeEnds::near([touch - end, touch + end].map(|place| (place - 0.5 * (from + to)) / half).to_vec())
}

/// The contact on bodies with nodes on its ends.
fn held_on<'a>(stage: Stage<'a>, level: Level, positioned: Positioned<'a>, effort: &mut Effort) -> Result<Found<'a>, Fault> {
    let Positioned { reduced, held, .. } = positioned;
    *effort += reduced.sizes();
    let found = signed(stage, &reduced, Some(held), effort)?;
    Ok(Found { reduced, found, level, unsettled: false, hot: None })
}

/// The contact on bodies; a solution with its points held in contact is that if its signs are right but for round-off at the ends, else a start.
fn signed(
    stage: Stage<'_>,
    reduced: &Reduced,
    held: Option<ContactSolution>,
    effort: &mut Effort,
) -> Result<ContactSolution, Fault> {
    let held = match held {
        Some(mut held) if held.complementarity < SIGNS_HOLD => {
            held.pressure.iter_mut().for_each(|p| *p = p.max(0.0));
            return Ok(held);
        }
        held => held,
    };
    let pair = reduced.pair()?;
    (stage.options.begun)(Step::Contact);
    let near = held.filter(|held| held.complementarity < NO_START);
    let operator = effort.timed(Step::Interface, stage.clock(), |_| match near {
        Some(_) => reduced.factorised(&pair, stage.friction() > 0.0, None),
        None => reduced.operator(&pair, stage.friction() > 0.0),
    })?;
    effort.timed(Step::Contact, stage.clock(), |effort| {
        effort.counters.contact_solves += 1;
        let (gap, load) = (start_gaps(stage, &operator), stage.contact_load(operator.points()));
        let found = match &near {
            Some(near) => operator.held_on(&near.closed).released(&gap, &load, near),
            None => operator.solve(&gap, &load, None),
        };
        found.map_err(unsolved)
    })
}

/// Nodes on the ends of contact, from trial ends; where these lead nowhere, or to others than those of the contact (there is tension between them), from
/// ends that are nearer.
fn searched<'a>(
    stage: Stage<'a>,
    level: Level,
    (ends, within): (&FreeEnds, f64),
    effort: &mut Effort,
) -> Result<Option<(FreeEnds, Positioned<'a>)>, Fault> {
    let first = position(stage, level, (ends, within), effort)?;
    let trial = match &first {
        Some((_, positioned)) if positioned.held.complementarity < NO_START => return Ok(first),
        Some((_, Positioned { reduced, .. })) => {
            let found = signed(stage, reduced, None, effort)?;
            FreeEnds::of(&found, reduced.pair()?.trace().length())
        }
        None => ends.clone(),
    };
    let near = if trial.places.is_empty() { None } else { nearer(stage, level, &trial, effort)? };
    let second = near.map_or(Ok(None), |near| position(stage, level, (&near, within), effort))?;
    Ok(second.or(first))
}

/// Positions nodes on the ends of contact, if there are any inside the surface, and solves.
fn find<'a>(stage: Stage<'a>, level: Level, search: &mut Search, effort: &mut Effort) -> Result<Found<'a>, Fault> {
    if stage.problem.heat.is_some()
        && let Some(HotFound { hot, level, unsettled }) =
            contact_hot::find(stage, level, (&mut search.ends, &mut search.hot), effort)?
    {
        return Ok(Found { reduced: hot.reduced(), found: hot.found(), level, unsettled, hot: Some(hot) });
    }
    let within = node_tolerance(stage.accuracy(), search.expected);
    let Search { ends, lost, .. } = search;
    let mut trial = None;
    let short = if ends.places.is_empty() { short_ends(stage) } else { FreeEnds::default() };
    let guessed = if short.places.is_empty() { None } else { position(stage, level, (&short, within), effort)? };
    if let Some((found, positioned)) = guessed {
        *ends = found;
        return held_on(stage, level, positioned, effort);
    }
    if ends.places.is_empty() {
        let (found, length, work) = on_standing_mesh(stage, level)?;
        *effort += work;
        *ends = FreeEnds::of(&found, length);
        trial = Some(found);
    }
    let looked_for = are_looked_for(ends.places.len(), *lost);
    let positioned = if looked_for { searched(stage, level, (ends, within), effort)? } else { None };
    if let Some((at, Positioned { reduced, held, .. })) = positioned {
        *effort += reduced.sizes();
        let tension = held.complementarity >= NO_START;
        let found = signed(stage, &reduced, Some(held), effort)?;
        // Where other points are in contact than those between the nodes, these are not on its ends.
        if !tension || at.bound_as_many(&found, reduced.pair()?.trace().length()) {
            *ends = at;
            return Ok(Found { reduced, found, level, unsettled: false, hot: None });
        }
    }
    *lost += usize::from(looked_for);
    let unsettled = !std::mem::take(ends).places.is_empty();
    let level = if unsettled { level.evenly() } else { level };
    let (reduced, work) = stage.reduced(level, Cut::Plain)?;
    *effort += work;
    let found = match trial.filter(|_| !unsettled) {
        Some(found) => found,
        None => signed(stage, &reduced, None, effort)?,
    };
    Ok(Found { reduced, found, level, unsettled, hot: None })
}

/// The contact on the standing mesh of a level, and the length of its surface.
pub(crate) fn on_standing_mesh(stage: Stage<'_>, level: Level) -> Result<(ContactSolution, f64, Effort), Fault> {
    let (reduced, mut effort) = stage.reduced(level, Cut::Plain)?;
    let pair = reduced.pair()?;
    (stage.options.begun)(Step::Contact);
    let operator = effort.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, stage.friction() > 0.0))?;
    let gap = start_gaps(stage, &operator);
    effort.counters.contact_solves += 1;
    let found = effort.timed(Step::Contact, stage.clock(), |_| {
        operator.solve(&gap, &stage.contact_load(operator.points()), None).map_err(unsolved)
    })?;
    Ok((found, pair.trace().length(), effort))
}
