//! The contact stage: the bodies as given, pressed together and sliding.

use std::sync::Arc;
use std::time::Instant;

use contact::{ContactOperator, ContactSolution, Pair, Status as ContactStatus};
use scene::{Fault, Gap, Scene};

use crate::fe::bodies::Level;
use crate::fe::diagnosis::Diagnosis;
use crate::fe::free_ends::{FreeEnds, inner, pairs, zones};
use crate::fe::recover::{Moment, Reported};
use crate::fe::rungs::{add_times, rungs};
use crate::fe::sharp_edges;
use crate::fe::stage::{Stage, accuracy, fixed_level, ladder, note, rest};
use crate::fe::template::{Cut, Extent};
use crate::fe::torsion;
use crate::fe::twist::Twist;
use crate::profile::Profile;
use crate::setup::Problem;
use crate::solution::{ContactResult, EnergyResult, Solution, Status};
use crate::solve::{CURVE, Options, Sampling};

/// Degrees after those of the ladder, and how far above the accuracy asked for the estimated error may be to climb on to them.
const BEYOND: [usize; 2] = [18, 20];
const NEARLY: f64 = 10.0;

/// Relative violation of signs below which a solution with its points held in contact is the contact's.
const SIGNS_HOLD: f64 = 1e-9;
/// Relative violation of signs above which that solution is no start for the contact's.
const NEAR: f64 = 1e-3;

/// Result of one level.
pub(super) struct Solved {
    pub(super) energy: f64,
    /// At the samples, to compare levels.
    pub(super) pressure: Vec<f64>,
    /// Torque or angle of a twist, to compare levels.
    pub(super) twist: Option<f64>,
    /// Error of the pressure as the embedded degree tells it, for levels without a ladder below them.
    pub(super) embedded: Option<f64>,
    /// Whether ends of contact lie inside elements because nodes did not settle on them.
    pub(super) unsettled: bool,
    /// Why there is no answer.
    pub(super) refused: Option<String>,
    /// For the fields.
    pub(super) reported: Option<Reported>,
    pub(super) solution: Solution,
}

/// Solves the contact and fills in the solution.
pub(super) fn solve(problem: &Problem, options: Options, solution: &mut Solution) -> Result<Option<Reported>, Fault> {
    let stage = Stage::new(problem)?;
    let mut ends = FreeEnds::default();
    let (mut last, mut diagnosis) = (None, None);
    let reported = climb(stage.scene(), options, solution, |level| {
        let solved = solve_level(stage, level, options, &mut ends, &mut diagnosis)?;
        let statuses = solved.solution.profile.as_ref().map(|profile| &profile.status);
        last = statuses.and_then(|s| Some((level.layers, [*s.first()? == "contact", *s.last()? == "contact"])));
        Ok(solved)
    })?;
    diagnosis.iter().try_for_each(|diagnosis| diagnosis.report(stage, solution))?;
    if let Some((layers, closed)) = last {
        let note = sharp_edges::note(stage, layers, closed)?;
        // The largest value at a point says nothing about an infinite pressure.
        if let Some(contact) = solution.contact.as_mut().filter(|_| note.is_some()) {
            (contact.p_max_MPa, contact.q_max_MPa) = (None, None);
        }
        solution.lints.extend(note);
    }
    Ok(reported)
}

/// Solves level after level until the estimated errors are below the accuracy asked for, and keeps the last one.
pub(super) fn climb(
    scene: &Scene,
    options: Options,
    solution: &mut Solution,
    mut solve_level: impl FnMut(Level) -> Result<Solved, Fault>,
) -> Result<Option<Reported>, Fault> {
    let fixed = fixed_level(scene).is_some();
    let mut solved: Vec<Solved> = Vec::new();
    let mut levels = ladder(scene, options);
    let last = levels.len();
    if !fixed {
        levels.extend(BEYOND.map(|degree| Level::of(scene, degree)));
    }
    for (number, level) in levels.iter().copied().enumerate() {
        // Past the usual degrees only for what is nearly there.
        if number >= last && estimate(&solved).is_none_or(|e| largest(&e) > NEARLY * accuracy(scene)) {
            break;
        }
        if crate::interrupt::asked() {
            solution.status = Status::Interrupted;
            return Ok(None);
        }
        solved.push(solve_level(level)?);
        let refused = solved.last().is_some_and(|s| s.refused.is_some());
        if refused || (!fixed && estimate(&solved).is_some_and(|e| largest(&e) <= accuracy(scene))) {
            break;
        }
    }
    let change = |i: usize| relative_difference(&solved[i - 1].pressure, &solved[i].pressure);
    let estimate = |i: usize| estimate(&solved[..=i]).map(|e| e[1]);
    solution.ladder = rungs(&levels, solved.len(), "pressure", change, estimate);
    Ok(finish(accuracy(scene), solved, fixed, solution))
}

fn largest(errors: &[f64]) -> f64 {
    errors.iter().copied().fold(0.0, f64::max)
}

/// Estimated relative errors of the energy, of the pressure (L2 over the inner 95 % of the contact), and of a twist (0 without one).
fn estimate(solved: &[Solved]) -> Option<[f64; 3]> {
    let [.., a, b, c] = solved else { return None };
    let energy = |x: &Solved, y: &Solved| ((x.energy - y.energy) / y.energy).abs();
    let pressure = |x: &Solved, y: &Solved| relative_difference(&x.pressure, &y.pressure);
    let twist = |x: &Solved, y: &Solved| x.twist.zip(y.twist).map(|(x, y)| if x == y { 0.0 } else { ((x - y) / y).abs() });
    let twist = twist(a, b).zip(twist(b, c)).map_or(0.0, |(older, newer)| rest(older, newer));
    Some([rest(energy(a, b), energy(b, c)), rest(pressure(a, b), pressure(b, c)), twist])
}

/// `|x - y| / |y|` in the Euclidean norm.
fn relative_difference(x: &[f64], y: &[f64]) -> f64 {
    let square = |f: &dyn Fn(usize) -> f64| (0..y.len()).map(|i| f(i).powi(2)).sum::<f64>();
    (square(&|i| x[i] - y[i]) / square(&|i| y[i])).sqrt()
}

fn finish(accuracy: f64, mut solved: Vec<Solved>, fixed: bool, solution: &mut Solution) -> Option<Reported> {
    let errors = estimate(&solved);
    let levels = solved.len();
    let times: Vec<_> = solved.iter().map(|s| s.solution.times.clone()).collect();
    let total = |f: &dyn Fn(&Solved) -> usize| solved.iter().map(f).sum::<usize>();
    let factorisations = total(&|s| s.solution.counters.factorisations);
    let solves = total(&|s| s.solution.counters.contact_solves);
    let Solved { solution: last, refused, reported, embedded, unsettled, .. } = solved.pop()?;
    add_times(&times, &mut solution.times);
    let checks = solution.counters.check_solves;
    let before = solution.counters.factorisations;
    solution.counters = last.counters;
    solution.counters.factorisations = factorisations + before;
    solution.counters.contact_solves = solves;
    solution.counters.check_solves = checks;
    solution.contact = last.contact;
    solution.interface = last.interface;
    solution.energy = last.energy;
    solution.reactions = last.reactions;
    solution.profile = last.profile;
    solution.curve = last.curve;
    if let Some(reason) = refused {
        solution.status = Status::Refused;
        solution.reason = Some(reason);
        return None;
    }
    let Some([energy, pressure, twist]) = errors else {
        if let (true, Some(embedded)) = (fixed, embedded) {
            let result = solution.error.get_or_insert_default();
            result.pressure_relative = Some(embedded);
            result.how =
                "pressure of the contact: what its highest degree on each edge adds; energy: not estimated below degree 5".into();
        }
        return reported;
    };
    let result = solution.error.get_or_insert_default();
    result.energy_relative = Some(energy);
    result.pressure_relative = Some(pressure);
    result.twist_relative = Some(twist).filter(|twist| *twist > 0.0);
    result.how = format!("energy and pressure of the contact: rest of the series of {levels} degrees");
    if unsettled {
        result.how += "; nodes did not settle on the ends of contact, which lie inside elements";
    }
    let worst = largest(&[energy, pressure, twist]);
    if !fixed && worst > accuracy {
        solution.status = Status::AccuracyMissed;
        solution.reason = Some(format!("the contact is accurate to {worst:.1e}, not to the {accuracy:.0e} asked for"));
    }
    reported
}

/// Solves a level; where contact ends inside the surface, with element nodes on its ends, from those of the last level.
/// The diagnosis is left to be made if the level is the last.
pub(super) fn solve_level(
    stage: Stage<'_>,
    level: Level,
    options: Options,
    ends: &mut FreeEnds,
    diagnosis: &mut Option<Diagnosis>,
) -> Result<Solved, Fault> {
    let mut solution = Solution::default();
    let mut trial = None;
    if ends.places.is_empty() {
        let (found, length) = on_standing_mesh(stage, level, &mut solution)?;
        *ends = FreeEnds::of(&found, length);
        trial = Some(found);
    }
    let positioned = if ends.places.is_empty() { None } else { ends.position(stage, level, &mut solution)? };
    let mut unsettled = false;
    let (reduced, held) = match positioned {
        Some(positioned) => {
            *ends = positioned.ends;
            positioned.reduced.count(&mut solution.counters);
            (positioned.reduced, Some(positioned.held))
        }
        None => {
            unsettled = !ends.places.is_empty();
            *ends = FreeEnds::default();
            (stage.reduced(level, Cut::Plain, &mut solution)?, None)
        }
    };
    let start = Instant::now();
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, stage.friction() > 0.0)?;
    note(&mut solution, "interface", start);
    let start = Instant::now();
    let gap: Vec<f64> = operator.points().iter().map(|p| start_gap(stage, &pair, p.arc)).collect();
    let load = stage.contact_load(operator.points());
    let found = match (trial, held) {
        (Some(found), None) => found,
        // Every sign is right but for round-off at the ends.
        (_, Some(mut held)) if held.complementarity < SIGNS_HOLD => {
            held.pressure.iter_mut().for_each(|p| *p = p.max(0.0));
            held
        }
        (_, held) => {
            solution.counters.contact_solves += 1;
            let near = held.as_ref().filter(|held| held.complementarity < NEAR);
            operator.solve(&gap, &load, near).map_err(unsolved)?
        }
    };
    note(&mut solution, "contact", start);
    let states = [Some(&found.shaped), found.counter.as_ref()];
    let energy = [
        pair.shaped.strain_energy(&found.shaped),
        pair.counter.zip(found.counter.as_ref()).map_or(0.0, |(body, state)| body.strain_energy(state)),
    ];
    solution.energy = Some(EnergyResult { body1_Nmm: Some(energy[0]), body2_Nmm: Some(energy[1]) });
    solution.reactions = reduced.reactions(states);
    let mut contact = result(stage, &pair, &operator, &found);
    if !ends.places.is_empty() {
        contact.ends_mm = ends.arcs(pair.trace().length()).iter().map(|arc| stage.start(&pair) + arc).collect();
    }
    let start = stage.start(&pair);
    let twist = match stage.turned_pair(level, &ends.places, &mut solution)? {
        Some(reduced) => Twist::new(stage.scene(), &reduced.pair()?, &found)?,
        None => None,
    };
    twist.iter().for_each(|twist| twist.report(&mut contact, start));
    let embedded = match stage.fixed_level() {
        Some(_) => operator.embedded_difference(&gap, &load, &found).map_err(unsolved)?,
        None => None,
    };
    solution.contact = Some(contact);
    let length = pair.trace().length();
    let zones = if ends.places.is_empty() { zones(&found, length) } else { pairs(&ends.arcs(length)) };
    let pressure = inner(&zones, length).iter().map(|arc| pressure_at(&pair, &operator, &found.pressure, *arc)).collect();
    let own = stage.profile(&pair, operator.points(), &found.pressure, states);
    let sampled = |sampling: Sampling<'_>| -> Profile {
        let points = stage.sample(&pair, sampling);
        let pressure: Vec<f64> = points.iter().map(|p| pressure_at(&pair, &operator, &found.pressure, p.arc)).collect();
        let mut profile = stage.profile(&pair, &points, &pressure, states);
        let arcs: Vec<f64> = operator.points().iter().map(|p| p.arc).collect();
        for (row, point) in points.iter().enumerate() {
            profile.gap[row] = 1e3 * start_gap(stage, &pair, point.arc);
            profile.opening[row] = 1e3 * linear(&arcs, &found.opening, point.arc).max(0.0);
        }
        profile
    };
    let mut profile = match options.sample {
        Some(sampling) => sampled(sampling),
        None => own,
    };
    if options.sample.is_none() {
        profile.gap = gap.iter().map(|g| 1e3 * g).collect();
        profile.opening = found.opening.iter().map(|g| 1e3 * g).collect();
        profile.status = found.closed.iter().map(|closed| if *closed { "contact" } else { "open" }).collect();
    }
    let mut curve = sampled(CURVE);
    twist.iter().for_each(|twist| [&mut profile, &mut curve].into_iter().for_each(|p| twist.fill(&operator, p, start)));
    solution.profile = Some(profile);
    solution.curve = Some(curve);
    let refused = (!found.status.is_solved() || found.status == ContactStatus::NoContact).then(|| found.status.to_string());
    let refused = refused.or_else(|| twist.as_ref().and_then(|twist| twist.refused.clone()));
    let reported = found.counter.clone().map(|counter| {
        let states = [stage.held(&pair, &found.shaped), counter];
        let around = match &twist {
            Some(twist) => twist.last.shear.clone(),
            None => torsion::around(stage, operator.points(), &found.pressure),
        };
        Reported { level, ends: ends.places.clone(), moments: vec![Moment { time_s: 0.0, name: "", states, around }] }
    });
    let twist = twist.map(|twist| twist.answer);
    *diagnosis = Some(Diagnosis { reduced: Arc::clone(&reduced), found });
    Ok(Solved { energy: energy[0] + energy[1], pressure, twist, embedded, unsettled, refused, reported, solution })
}

/// The contact on the standing mesh of a level, and the length of its surface.
pub(super) fn on_standing_mesh(stage: Stage<'_>, level: Level, solution: &mut Solution) -> Result<(ContactSolution, f64), Fault> {
    let reduced = stage.reduced(level, Cut::Plain, solution)?;
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, stage.friction() > 0.0)?;
    let gap: Vec<f64> = operator.points().iter().map(|p| start_gap(stage, &pair, p.arc)).collect();
    solution.counters.contact_solves += 1;
    let found = operator.solve(&gap, &stage.contact_load(operator.points()), None).map_err(unsolved)?;
    Ok((found, pair.trace().length()))
}

pub(super) fn unsolved(error: contact::Error) -> Fault {
    Fault::at("contact", "no-contact", error.to_string(), "check the contact and its load")
}

/// The start gap of the scene at an arc length.
pub(super) fn start_gap(stage: Stage<'_>, pair: &Pair<'_>, arc: f64) -> f64 {
    gap_at(stage, stage.start(pair) + arc)
}

/// The start gap of the scene at a surface coordinate.
pub(super) fn gap_at(stage: Stage<'_>, s: f64) -> f64 {
    let given = match stage.scene().contact.as_ref().and_then(|c| c.gap.as_ref()) {
        Some(Gap::Profile { s: known, gap }) => linear(known, gap, s) * 1e-3,
        _ => 0.0,
    };
    match stage.extent {
        Extent::Round { radius, .. } => given + s * s / (radius + ((radius - s) * (radius + s)).max(0.0).sqrt()),
        _ => given,
    }
}

/// Pressure between the points: the polynomial through the points of the edge, or straight lines on an edge that is partly open.
pub(super) fn pressure_at(pair: &Pair<'_>, operator: &ContactOperator<'_>, pressure: &[f64], arc: f64) -> f64 {
    let (edge, _) = pair.trace().locate(arc);
    let range = operator.edge_points(edge);
    if pressure[range.clone()].contains(&0.0) {
        let arcs: Vec<f64> = operator.points()[range.clone()].iter().map(|p| p.arc).collect();
        return linear(&arcs, &pressure[range], arc);
    }
    operator.value_at(pressure, arc)
}

/// Piecewise linear interpolation in ascending points.
pub(super) fn linear(points: &[f64], values: &[f64], s: f64) -> f64 {
    let after = points.partition_point(|p| *p < s).clamp(1, points.len() - 1);
    let (a, b) = (points[after - 1], points[after]);
    let t = ((s - a) / (b - a)).clamp(0.0, 1.0);
    (1.0 - t) * values[after - 1] + t * values[after]
}

fn result(stage: Stage<'_>, pair: &Pair<'_>, operator: &ContactOperator<'_>, found: &ContactSolution) -> ContactResult {
    let start = stage.start(pair);
    let about = stage.scene().load.as_ref().and_then(|l| l.about).map_or(0.0, |about| about[0].0);
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
        force_N: Some(found.force[1]),
        moment_Nmm: Some(moment),
        approach_mm: tz.map(|z| -z),
        tilt_rad: theta.map(|t| -t),
        ends_mm: zones(found, pair.trace().length()).iter().flatten().map(|arc| start + arc).collect(),
        // At a sharp corner the pressure is infinite: its exponent says more than the largest nodal value.
        p_max_MPa: Some(largest).filter(|_| edge_exponents.is_empty()),
        edge_exponents,
        stick_ends_mm: Vec::new(),
        q_max_MPa: Some(shear).filter(|_| !singular),
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
pub(super) fn word(status: &ContactStatus) -> &'static str {
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
