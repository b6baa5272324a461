//! The shape stage: levels of rising degree until the gap is accurate enough, then the round trip.

use std::ops::ControlFlow;
use std::sync::Arc;

use contact::{ContactPoint, Pair, maximum};
use hpfem::InterfaceState;
use nalgebra::DMatrix;
use scene::{Balance, Fault};
use shapeopt::{GapCurve, Measure, Shape, SurfacePlace, closing, difference_of_gaps};

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::freedom::Role;
use crate::heat_result::{HEAT_ALIKE, HeatResult};
use crate::ladder::{Climbed, Ladder, Refusal, climb, missed};
use crate::level::Level;
use crate::machined::{Machined, SurfacePoint};
use crate::problem::Problem;
use crate::results::{ErrorResult, ShapeResult};
use crate::solution::Status;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::{Answer, Outcome, Own, Told};
use crate::steps::heat::following::Following;
use crate::steps::hot_shape::{self, HotShape};
use crate::steps::reported::{Moment, Reported};
use crate::steps::round_off::least_error;
use crate::steps::shaper::{Shaper, unanswered};
use crate::steps::{pressure, rigid_coordinates, round_trip, tolerance, torsion};
use crate::watch::Watch;

/// Samples of the gap for the comparison of levels.
const SAMPLES: usize = 201;
/// The same on a fixed discretisation, whose few layers may leave an error that stands up only near the ends.
const CLOSER: usize = 801;

/// One solved level.
struct Solved<'a> {
    level: Level,
    reduced: Arc<Reduced>,
    shape: Shape,
    gaps: Vec<f64>,
    /// Closing velocities of the rigid modes at the samples.
    closing: DMatrix<f64>,
    effort: Effort,
    /// The bodies and the heat of the wanted pressure, of a scene with heat, unless more levels were expected.
    hot: Option<HotShape<'a>>,
}

/// Largest gap over the largest displacement that is round-off.
pub(crate) const FLAT: f64 = 1e-11;

impl Solved<'_> {
    /// Whether nothing is to be taken off: the gap is round-off.
    fn is_flat(&self, measure: Measure) -> bool {
        let largest = |values: &mut dyn Iterator<Item = &f64>| values.fold(0.0_f64, |most, value| most.max(value.abs()));
        let states = [Some(&self.shape.shaped), self.shape.counter.as_ref()].into_iter().flatten();
        let moved = largest(&mut states.flat_map(|state| &state.unknowns));
        measure == Measure::Largest && largest(&mut self.gaps.iter()) <= FLAT * moved
    }
}

/// What stages before the shape leave to it.
pub(crate) struct Before<'a> {
    /// Shapes solved for to find the force of a prescribed approach.
    pub passes: usize,
    /// How the error of the pressure was estimated.
    pub how: &'a str,
}

/// Solves for the shape.
pub(crate) fn solve(stage: Stage<'_>, before: &Before<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort), Refusal> {
    let optimum = optimal(stage.problem)?;
    unanswered(stage, &optimum)?;
    let carried = balanced(stage.problem, &optimum);
    let stage = match &carried {
        Some(problem) => stage.with(problem)?,
        None => stage,
    };
    let shaper = Shaper::new(stage, &optimum);
    let ladder = Ladder::of(stage.problem, stage.options, Step::Shape).and_beyond(stage.problem);
    let measure = stage.problem.measure();
    // Of gaps that are round-off the difference is as large as they are.
    let are_flat = |levels: [&Solved<'_>; 2]| levels.into_iter().all(|level| level.is_flat(measure));
    let distance = |a: &Solved<'_>, b: &Solved<'_>| match are_flat([a, b]) {
        true => [0.0],
        false => [difference_of_gaps(&a.gaps, &b.gaps, &b.closing, measure)],
    };
    let solve = |level, before: &[Solved<'_>], _: &mut Watch<'_>| {
        let left = ladder.expects_more(before, &distance);
        shaper.level(level, left).map(ControlFlow::Continue).map_err(Refusal::Fault)
    };
    let Climbed { solved, mut stopped } = climb(&ladder, Vec::new(), solve, distance, watch)?;
    // A level beside that cannot be meshed or solved tells nothing.
    let beside = ladder.beside(&mut stopped, watch).and_then(|level| shaper.level(level, true).ok());
    let mut effort = Effort::default();
    beside.iter().chain(&solved).for_each(|level| effort += level.effort.clone());
    let mut outcome = Outcome { stopped, ladder: ladder.rungs(&solved, ("gap", 0), distance), ..Outcome::default() };
    let (last, error) = ladder.to_report(&solved, beside.as_ref(), &distance);
    // A level that was hardly to be the last one has not kept its heat.
    let cold = last.filter(|last| last.hot.is_none() && stage.problem.heat.is_some());
    let again = cold.map(|last| shaper.level(last.level, false)).transpose()?;
    again.iter().for_each(|level| effort += level.effort.clone());
    let last = again.as_ref().or(last);
    outcome.tell(error.filter(|_| ladder.is_fixed()));
    if let Some(last) = last {
        outcome.error = error_of_gap(error, measure, &ladder.told_by(solved.len()), before.how);
        let work = shaper.report(last, before.passes, &mut outcome)?;
        effort += work;
        let least = if last.is_flat(measure) { 0.0 } else { least_error(&last.shape, measure, &outcome) };
        if error.is_some_and(|error| error < least) {
            outcome.error = error_of_gap(Some(least), measure, "round-off through the condition", before.how);
        }
        let missed_by = error.and_then(|error| Some((error.max(least), ladder.missed(error.max(least))?)));
        let miss = missed_by.map(|(error, accuracy)| (Status::AccuracyMissed, missed("gap", error, accuracy)));
        outcome.ended = outcome.ended.take().or(miss);
    }
    Ok((outcome, effort))
}

/// The optimal pressure of a problem.
pub(crate) fn optimal(problem: &Problem) -> Result<wear::Optimum, Refusal> {
    wear::optimal_pressure(&pressure::wear_problem(problem)?).map_err(|error| Refusal::Reason(error.to_string()))
}

/// The estimated error of the gap, and what told it; `pressure` says how that of the pressure was found.
fn error_of_gap(error: Option<f64>, measure: Measure, told_by: &str, pressure: &str) -> ErrorResult {
    let of = if measure == Measure::Crown { "gap relative to its crown" } else { "gap" };
    let how = match error {
        Some(_) => format!("{of}: {told_by}; pressure: {pressure}"),
        None => format!("gap: not estimated; pressure: {pressure}"),
    };
    ErrorResult { gap_relative: error, how, ..ErrorResult::default() }
}

/// The error of a gap that is as good as nothing and whose proof fails: round-off hides it, and how far it is off is not known.
fn hidden(error: &ErrorResult) -> ErrorResult {
    error_of_gap(None, Measure::Largest, "", error.how.split_once("; pressure: ").map_or("", |(_, how)| how))
}

/// The problem under the force that the pressure really carries, where that is not the load (`optimum.balance = "paper"` on an arc): bodies out
/// of balance have no shape.
fn balanced(problem: &Problem, optimum: &wear::Optimum) -> Option<Problem> {
    let push = problem.freedoms.iter().position(|freedom| freedom.role == Role::Force);
    let push = push.filter(|_| problem.optimum.balance == Balance::Paper)?;
    Some(problem.with_force(optimum.resultants[push]))
}

impl<'a> Shaper<'a> {
    /// Arc lengths at which levels are compared.
    fn samples(&self, pair: &Pair<'_>) -> Vec<f64> {
        let count = if self.stage.problem.wanted.fixed.is_some() { CLOSER } else { SAMPLES };
        let length = pair.trace().length();
        (0..count).map(|i| length * i as f64 / (count - 1) as f64).collect()
    }

    /// Solves one level, after which others are expected to be `left` or not.
    fn level(&self, level: Level, left: bool) -> Result<Solved<'a>, Fault> {
        let (reduced, hot, mut effort) = match HotShape::new(self, level, left)? {
            Some((hot, reduced, effort)) => (Arc::new(reduced), Some(hot), effort),
            None => {
                let (reduced, effort) = self.stage.reduced_at(level, &self.nodes)?;
                (reduced, None, effort)
            }
        };
        let pair = reduced.pair()?;
        (self.stage.options.begun)(Step::Shape);
        let shape = effort.timed(Step::Shape, self.stage.clock(), |_| self.shape(&pair))?;
        let arcs = self.samples(&pair);
        let gaps: Vec<f64> = arcs.iter().map(|arc| shape.gap(&pair, &pair.at_arc(*arc))).collect();
        let mut modes = DMatrix::zeros(arcs.len(), pair.shaped.rigid_modes.ncols());
        for (row, arc) in arcs.iter().enumerate() {
            for (k, phi) in closing(&pair, &pair.at_arc(*arc)).into_iter().enumerate() {
                modes[(row, k)] = phi;
            }
        }
        let hot = hot.filter(|_| !left);
        Ok(Solved { level, reduced, shape, gaps, closing: modes, effort, hot })
    }

    /// Everything that is reported of a level, with its proof.
    fn report(&self, solved: &Solved<'a>, passes: usize, outcome: &mut Outcome) -> Result<Effort, Fault> {
        let Solved { reduced, shape, gaps, .. } = solved;
        let (stage, pair) = (self.stage, reduced.pair()?);
        let (arcs, gap) = (self.samples(&pair), |arc: f64| shape.gap(&pair, &pair.at_arc(arc)));
        let [highest, most] = maximum(&arcs, gaps, &gap);
        let [least, depth] = maximum(&arcs, &gaps.iter().map(|gap| -gap).collect::<Vec<_>>(), &|arc| -gap(arc));
        let lowest = match stage.problem.measure() {
            Measure::Largest => 0.0,
            Measure::Crown => -depth,
        };
        let [rigid, turned] = rigid_part(stage, &pair, shape);
        let mut result = ShapeResult {
            iterations: passes + 1,
            gap_max: Some(1e3 * most),
            gap_where: Some(stage.start(&pair) + highest),
            gap_least_where: Some(stage.start(&pair) + least),
            crown: Some(1e3 * (most - lowest)),
            rigid,
            turned,
            flat: solved.is_flat(stage.problem.measure()),
            ..ShapeResult::default()
        };
        let (mut told, mut effort) = (self.told(reduced, &pair, shape), Effort::default());
        let following = self.heated(solved, (&mut told, &mut effort), outcome)?;
        // Beyond the critical speed no proof can succeed, and nobody is to machine the shape.
        let lost = outcome.heat.as_ref().and_then(HeatResult::beyond_critical);
        let machining = stage.options.machining && lost.is_none();
        outcome.machined = machining.then(|| self.machined(&pair, shape));
        // Heat that is not there, as that of a run that was stopped, tells no tolerance.
        if machining && following.is_some() == solved.hot.is_some() {
            let bodies = following.as_ref().map_or(reduced, |following| &following.reduced);
            result.tolerance = tolerance::of(self, bodies, following.as_ref())?;
        }
        if stage.problem.plan.runs(Step::RoundTrip) && !outcome.stopped && lost.is_none() {
            let start = stage.clock()();
            (stage.options.begun)(Step::RoundTrip);
            let curve = GapCurve::of(shape, &pair);
            let same = round_trip::same(self, following.as_ref(), reduced, shape)?;
            result.roundtrip_same = Some(same.miss);
            outcome.interface = same.interface;
            let independent = round_trip::independent(self, solved.level, &curve, &mut told)?;
            result.roundtrip_independent = Some(independent.miss);
            // A proof that fails says more than an estimate that is missed: the estimate is then not to be believed either.
            let disproof = disproved([same.miss, independent.miss], outcome.error.gap_relative, !self.ends.is_empty());
            result.proof_failed = disproof.is_some();
            if result.proof_failed && result.flat {
                (result.flat, outcome.error) = (false, hidden(&outcome.error));
            }
            outcome.ended = disproof.or(outcome.ended.take());
            // Its meshes and factorisations are counted, its seconds are those of the proof.
            effort.counters.factorisations = independent.effort.counters.factorisations;
            effort.counters.check_solves = 2;
            effort.add_seconds(Step::RoundTrip, stage.clock()() - start);
        }
        outcome.ended = lost.map(|reason| (Status::Refused, reason)).or(outcome.ended.take());
        outcome.shape = Some(result);
        outcome.told = Some(told);
        outcome.reported = self.reported(solved, &pair);
        Ok(effort)
    }

    /// Temperatures and powers of a shape with heat, into its columns and as numbers, with the factors on its speed; returns the bodies bent by heat
    /// that follows the pressure.
    fn heated(
        &self,
        solved: &Solved<'a>,
        (told, effort): (&mut Told, &mut Effort),
        outcome: &mut Outcome,
    ) -> Result<Option<Following<'a>>, Fault> {
        let Some(hot) = &solved.hot else { return Ok(None) };
        let start = self.stage.clock()();
        let pair = solved.reduced.pair()?;
        let mut result = hot.tell(self, &pair, told)?;
        let mut following = None;
        if !outcome.stopped {
            let own = hot.following(&solved.reduced);
            let bears = hot_shape::bears(self, &own, |point| solved.shape.gap(&pair, point))?;
            result.take_speeds(&bears.speeds, bears.smooth.as_ref().map(|smooth| (smooth, HEAT_ALIKE)));
            (result.growth, result.from_cold) = (bears.growth, bears.from_cold);
            following = Some(own);
        }
        outcome.heat = Some(result);
        effort.add_seconds(Step::Heat, self.stage.clock()() - start);
        Ok(following)
    }

    /// Energies, reactions and columns of the shape.
    fn told(&self, reduced: &Reduced, pair: &Pair<'_>, shape: &Shape) -> Told {
        let between = |point: &ContactPoint| [self.pressure(&SurfacePlace::from(point), Some(pair)), shape.gap(pair, point), 0.0];
        let points = pair.points();
        let pressure: Vec<f64> = points.iter().map(|p| self.pressure(&SurfacePlace::from(p), Some(pair))).collect();
        let gap: Vec<f64> = points.iter().map(|p| shape.gap(pair, p)).collect();
        let opening = vec![0.0; points.len()];
        let own = Own { points: &points, pressure: &pressure, gap: &gap, opening: &opening, closed: None };
        Answer { stage: self.stage, reduced, pair, states: states(shape), own, between: &between }.told()
    }

    /// The surface to machine into body 1.
    fn machined(&self, pair: &Pair<'_>, shape: &Shape) -> Machined {
        let (start, length) = (self.stage.start(pair), pair.trace().length());
        let gap = GapCurve::of(shape, pair);
        let surface = |s: f64| {
            let point = pair.at_arc((s - start).clamp(0.0, length));
            SurfacePoint { s, nominal: point.position, normal: point.normal, gap: gap.at(point.arc) }
        };
        Machined::new(surface, [start, start + length])
    }

    /// What fields and twist need of the last level.
    fn reported(&self, last: &Solved<'a>, pair: &Pair<'_>) -> Option<Reported> {
        let points = pair.points();
        let pressure: Vec<f64> = points.iter().map(|p| self.pressure(&SurfacePlace::from(p), Some(pair))).collect();
        let around = torsion::around(self.stage, &points, &pressure);
        let counter = last.shape.counter.clone()?;
        let moments = vec![Moment { time: 0.0, name: "", states: [last.shape.shaped.clone(), counter], around }];
        Some(Reported {
            level: last.level,
            ends: self.nodes.clone(),
            heat: last.hot.as_ref().map(|hot| hot.heat.clone()),
            moments,
        })
    }
}

/// The rigid part of a gap as a motion along its normal (mm) and a turn (rad), positive where they open it, as far as body 1 has these motions; none about
/// a pin.
fn rigid_part(stage: Stage<'_>, pair: &Pair<'_>, shape: &Shape) -> [Option<f64>; 2] {
    if stage.couple.bodies[0].pin().is_some() || shape.rigid.is_empty() {
        return [None, None];
    }
    let [closing, turning] = rigid_coordinates::motion(pair, &shape.rigid, stage.about());
    let turns = pair.shaped.rigid_motions.iter().any(|[.., turn]| *turn != 0.0);
    [Some(-closing), Some(-turning).filter(|_| turns)]
}

/// What a proof may miss at most on the very operators of the shape, relative to the pressure: there it is round-off, unless part of the surface
/// carries nothing. That part touches without a pressure, so that the contact there follows every error of the discretisation.
const SAME: f64 = 1e-6;

/// What a proof on other meshes may miss at least before it counts as failed, and how much larger than that of the gap the error of a
/// pressure may be: a pressure follows the curvature of the gap.
const INDEPENDENT: [f64; 2] = [3e-2, 2e3];

/// The end of a shape whose proof fails: on the same operators, or on independent ones beyond what the error of the gap allows. `partial` is whether
/// part of the surface carries nothing.
fn disproved([same, independent]: [f64; 2], gap: Option<f64>, partial: bool) -> Option<(Status, String)> {
    let by_gap = INDEPENDENT[1] * gap.unwrap_or(0.0);
    let allowed = INDEPENDENT[0].max(by_gap);
    let allowed_same = if partial { SAME.max(by_gap) } else { SAME };
    // A miss that is no number is one too.
    let within = |miss: f64, limit: f64| miss <= limit;
    let (miss, on) = match (!within(same, allowed_same), !within(independent, allowed)) {
        (true, _) => (same, "on the very bodies it was found on"),
        (_, true) => (independent, "on independent meshes"),
        _ => return None,
    };
    let reason =
        format!("the proof fails: a contact solve on this shape gives the pressure back within {} {on}", scene::short(miss));
    Some((Status::AccuracyMissed, reason))
}

fn states(shape: &Shape) -> [Option<&InterfaceState>; 2] {
    [Some(&shape.shaped), shape.counter.as_ref()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_proof_that_misses_ends_as_such() {
        assert_eq!(disproved([1e-9, 1e-4], Some(1e-7), false), None);
        let says = |misses: [f64; 2], words: &str| {
            let end = disproved(misses, Some(1e-7), false);
            assert!(
                end.as_ref().is_some_and(|(status, why)| *status == Status::AccuracyMissed && why.contains(words)),
                "{end:?}"
            );
        };
        says([1e-3, 1e-3], "within 0.001 on the very bodies");
        says([1e-9, 6.6e-2], "on independent meshes");
        // A rough answer was asked for.
        assert_eq!(disproved([1e-9, 6.6e-2], Some(1e-3), false), None);
        assert!(disproved([f64::NAN, 1e-4], Some(1e-7), true).is_some());
        // A surface in full contact, and one of which part carries nothing.
        assert!(disproved([5e-5, 1e-4], Some(3e-5), false).is_some());
        assert_eq!(disproved([5e-5, 1e-4], Some(3e-5), true), None);
        assert!(disproved([1e-3, 1e-4], Some(1e-7), true).is_some());
    }
}
