//! The shape stage: levels of rising degree until the gap is accurate enough, then the round trip.

use std::ops::ControlFlow;
use std::sync::Arc;

use contact::{ContactLoad, ContactPoint, Motion, Pair};
use hpfem::InterfaceState;
use nalgebra::{DMatrix, Vector3};
use scene::{Balance, Fault};
use shapeopt::{GapCurve, Integration, Measure, RigidPart, Shape, ShapeProblem, SurfacePlace, closing, difference_of_gaps, solve_shape};

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::freedom::Role;
use crate::ladder::{Climbed, Ladder, Refusal, climb, errors, missed, rungs};
use crate::level::Level;
use crate::machined::{Machined, SurfacePoint};
use crate::plan::Step;
use crate::problem::Problem;
use crate::solution::{ShapeResult, Status};
use crate::stage::Stage;
use crate::steps::{approach, pressure, round_trip, tolerance, torsion};
use crate::steps::answer::{Answer, Outcome, Own, Told};
use crate::steps::pressure_ends::pressure_ends;
use crate::steps::recover::{Moment, Reported};
use crate::watch::Watch;

/// Samples of the gap for the comparison of levels.
const SAMPLES: usize = 201;

/// One solved level.
struct Solved {
    level: Level,
    reduced: Arc<Reduced>,
    shape: Shape,
    gaps: Vec<f64>,
    /// Closing velocities of the rigid modes at the samples.
    closing: DMatrix<f64>,
    effort: Effort,
}

/// What stages before the shape leave to it.
pub struct Before<'a> {
    /// Shapes solved for to find the force of a prescribed approach.
    pub passes: usize,
    /// How the error of the pressure was estimated.
    pub how: &'a str,
}

/// Solves for the shape.
pub fn solve(stage: Stage<'_>, before: &Before<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort), Refusal> {
    let optimum = optimal(stage.problem)?;
    unanswered(stage, &optimum)?;
    let carried = balanced(stage.problem, &optimum);
    let stage = match &carried {
        Some(problem) => stage.with(problem)?,
        None => stage,
    };
    let shaper = Shaper::new(stage, &optimum);
    let ladder = Ladder::of(stage.problem, stage.options);
    let measure = stage.problem.measure();
    let distance = |a: &Solved, b: &Solved| [difference_of_gaps(&a.gaps, &b.gaps, &b.closing, measure)];
    let solve = |level, _: &[Solved], _: &mut Watch<'_>| shaper.level(level).map(ControlFlow::Continue).map_err(Refusal::Fault);
    let Climbed { solved, stopped } = climb((&ladder, Step::Shape), Vec::new(), solve, distance, watch)?;
    let mut effort = Effort::default();
    solved.iter().for_each(|level| effort += level.effort.clone());
    let degrees: Vec<usize> = ladder.levels.iter().map(|level| level.degree).collect();
    let mut outcome = Outcome { stopped, ladder: rungs(&degrees, &solved, ("gap", 0), distance), ..Outcome::default() };
    let error = errors(&solved, &distance).map(|[error]| error);
    if let Some(last) = solved.last() {
        estimated(&mut outcome, (&ladder, solved.len()), (measure, error), before.how);
        let work = shaper.report(last, before.passes, &mut outcome)?;
        effort += work;
    }
    Ok((outcome, effort))
}

/// The optimal pressure of a problem.
pub fn optimal(problem: &Problem) -> Result<wear::Optimum, Refusal> {
    pressure::optimum(problem, &pressure::wear_problem(problem)?).map_err(|error| Refusal::Reason(error.to_string()))
}

/// The error of the gap, and whether it is small enough.
fn estimated(
    outcome: &mut Outcome,
    (ladder, levels): (&Ladder, usize),
    (measure, error): (Measure, Option<f64>),
    closed: &str,
) {
    let of = if measure == Measure::Crown { "gap relative to its crown" } else { "gap" };
    outcome.error.gap_relative = error;
    outcome.error.how = match error {
        Some(_) => format!("{of}: rest of the series of {levels} degrees; pressure: {closed}"),
        None => format!("gap: not estimated below degree 5; pressure: {closed}"),
    };
    if let Some((error, accuracy)) = error.and_then(|error| Some((error, ladder.missed(error)?))) {
        outcome.ended = Some((Status::AccuracyMissed, missed("gap", error, accuracy)));
    }
}

/// The problem under the force that the pressure really carries, where that is not the load (`optimum.balance = "paper"` on an arc): bodies out
/// of balance have no shape.
fn balanced(problem: &Problem, optimum: &wear::Optimum) -> Option<Problem> {
    let push = problem.freedoms.iter().position(|freedom| freedom.role == Role::Force);
    let push = push.filter(|_| problem.optimum.balance == Balance::Paper)?;
    Some(problem.with_force(optimum.resultants[push]))
}

/// A wanted pressure that is infinite somewhere has no shape.
pub fn unanswered(stage: Stage<'_>, optimum: &wear::Optimum) -> Result<(), Refusal> {
    let points = stage.patch.surface.sample(SAMPLES);
    let Some(point) = points.iter().find(|point| !optimum.pressure_at(point).is_finite()) else { return Ok(()) };
    let [x, z] = [point.position.x, point.position.z];
    Err(Refusal::Reason(format!(
        "the wanted pressure is infinite at x = {x}, z = {z}, and no shape has it; leave a hole or a cap there (optimum.p_max)"
    )))
}

/// The wanted tractions and the shape they ask for.
pub struct Shaper<'a> {
    pub stage: Stage<'a>,
    pub optimum: &'a wear::Optimum,
    /// Ends of the wanted pressure inside the surface.
    ends: Vec<f64>,
    feed: Vec<f64>,
}

impl<'a> Shaper<'a> {
    pub fn new(stage: Stage<'a>, optimum: &'a wear::Optimum) -> Shaper<'a> {
        Shaper { stage, optimum, ends: pressure_ends(stage, optimum), feed: optimum.feed.clone().unwrap_or_default() }
    }

    /// Solves one level.
    fn level(&self, level: Level) -> Result<Solved, Fault> {
        let (reduced, mut effort) = self.stage.reduced_at(level, &self.ends)?;
        let pair = reduced.pair()?;
        let shape = effort.timed(Step::Shape, self.stage.clock(), |_| self.shape(&pair))?;
        let arcs = samples(&pair);
        let gaps: Vec<f64> = arcs.iter().map(|arc| shape.gap(&pair, &pair.at_arc(*arc))).collect();
        let mut modes = DMatrix::zeros(SAMPLES, pair.shaped.rigid_modes.ncols());
        for (row, arc) in arcs.iter().enumerate() {
            for (k, phi) in closing(&pair, &pair.at_arc(*arc)).into_iter().enumerate() {
                modes[(row, k)] = phi;
            }
        }
        Ok(Solved { level, reduced, shape, gaps, closing: modes, effort })
    }

    /// Everything that is reported of a level, with its proof.
    fn report(&self, solved: &Solved, passes: usize, outcome: &mut Outcome) -> Result<Effort, Fault> {
        let Solved { reduced, shape, gaps, .. } = solved;
        let (stage, pair) = (self.stage, reduced.pair()?);
        let most = (0..gaps.len()).max_by(|a, b| gaps[*a].total_cmp(&gaps[*b])).unwrap_or(0);
        let lowest = match stage.problem.measure() {
            Measure::Largest => 0.0,
            Measure::Crown => gaps.iter().copied().fold(f64::INFINITY, f64::min),
        };
        let mut result = ShapeResult {
            iterations: passes + 1,
            gap_max_um: Some(1e3 * gaps[most]),
            gap_where_mm: Some(stage.start(&pair) + samples(&pair)[most]),
            crown_um: Some(1e3 * (gaps[most] - lowest)),
            rigid_mm: shape.rigid.first().copied(),
            roundtrip_same: None,
            roundtrip_independent: None,
            tolerance: if stage.options.machining { tolerance::of(self, reduced)? } else { Vec::new() },
        };
        outcome.machined = stage.options.machining.then(|| self.machined(&pair, shape));
        let mut told = self.told(reduced, &pair, shape);
        let mut effort = Effort::default();
        if stage.problem.plan.runs(Step::RoundTrip) && !outcome.stopped {
            let start = stage.clock()();
            let curve = GapCurve::of(shape, &pair);
            let (same, interface) = round_trip::same(self, reduced, shape)?;
            result.roundtrip_same = Some(same);
            outcome.interface = interface;
            let (independent, work) = round_trip::independent(self, solved.level, &curve, &mut told)?;
            result.roundtrip_independent = Some(independent);
            // Its meshes and factorisations are counted, its seconds are those of the proof.
            effort.counters.factorisations = work.counters.factorisations;
            effort.counters.check_solves = 2;
            effort.add_seconds(Step::RoundTrip, stage.clock()() - start);
        }
        outcome.shape = Some(result);
        outcome.told = Some(told);
        outcome.reported = self.reported(solved, &pair);
        Ok(effort)
    }

    /// Energies, reactions and columns of the shape.
    fn told(&self, reduced: &Reduced, pair: &Pair<'_>, shape: &Shape) -> Told {
        let place = |p: &ContactPoint| SurfacePlace { position: p.position, normal: p.normal };
        let between = |point: &ContactPoint| [self.pressure(&place(point)), shape.gap(pair, point), 0.0];
        let points = pair.points();
        let pressure: Vec<f64> = points.iter().map(|p| self.pressure(&place(p))).collect();
        let gap: Vec<f64> = points.iter().map(|p| shape.gap(pair, p)).collect();
        let opening = vec![0.0; points.len()];
        let own = Own { points: &points, pressure: &pressure, gap: &gap, opening: &opening, closed: None };
        Answer { stage: self.stage, reduced, pair, states: states(shape), own, between: &between }.told()
    }

    /// The surface to machine into body 1.
    fn machined(&self, pair: &Pair<'_>, shape: &Shape) -> Machined {
        let (start, length) = (self.stage.start(pair), pair.shaped.trace.length());
        let gap = GapCurve::of(shape, pair);
        let surface = |s: f64| {
            let point = pair.at_arc((s - start).clamp(0.0, length));
            SurfacePoint { s, nominal: point.position, normal: point.normal, gap: gap.at(point.arc) }
        };
        Machined::new(surface, [start, start + length])
    }

    /// What fields and twist need of the last level.
    fn reported(&self, last: &Solved, pair: &Pair<'_>) -> Option<Reported> {
        let place = |p: &ContactPoint| SurfacePlace { position: p.position, normal: p.normal };
        let points = pair.points();
        let pressure: Vec<f64> = points.iter().map(|p| self.pressure(&place(p))).collect();
        let around = torsion::around(self.stage, &points, &pressure);
        let counter = last.shape.counter.clone()?;
        let moments = vec![Moment { time_s: 0.0, name: "", states: [last.shape.shaped.clone(), counter], around }];
        Some(Reported { level: last.level, ends: self.ends.clone(), moments })
    }

    /// Wanted pressure at a place.
    pub fn pressure(&self, place: &SurfacePlace) -> f64 {
        self.optimum.pressure_at(&self.stage.surface_point(place.position, place.normal, 0.0))
    }

    /// Pressure and shear along the tangent at a place.
    fn traction(&self, place: &SurfacePlace) -> [f64; 2] {
        let point = self.stage.surface_point(place.position, place.normal, 0.0);
        let pressure = self.optimum.pressure_at(&point);
        let tangent = Vector3::new(place.normal[1], 0.0, -place.normal[0]);
        [pressure, self.stage.friction() * pressure * point.drag.dot(&tangent)]
    }

    /// The shape on a pair of bodies.
    pub fn shape(&self, pair: &Pair<'_>) -> Result<Shape, Fault> {
        let load = &self.stage.problem.load;
        if !self.stage.rigid_prescribed() {
            return self.smallest(pair);
        }
        let fed = self.fed()?;
        let about = self.stage.about();
        let turned = match (load.approach, load.tilt) {
            // A rotation that nothing prescribes is that of the smallest shape.
            (Some(_), None) => approach::motion(pair, &self.smallest(pair)?.rigid, about)[1],
            (_, tilt) => tilt.unwrap_or(0.0),
        };
        let motion = [load.approach.unwrap_or(0.0) + fed[0], turned + fed[1]];
        self.with_rigid_part(pair, RigidPart::Prescribed(approach::coordinates(pair, motion, about)))
    }

    /// Worn approach and turning after `approach_time`.
    fn fed(&self) -> Result<[f64; 2], Fault> {
        let time = self.stage.problem.load.approach_time.unwrap_or(0.0);
        if time != 0.0 && self.feed.is_empty() {
            let message = "approach_time needs the feed of wear, and the multipliers of this functional are no velocities";
            let remedy = "use optimum.functional = \"steady\", or \"wear-power\" with q = 1 and equal b, with wear";
            return Err(Fault::at("load.approach_time", "no-feed", message, remedy));
        }
        Ok([0, 1].map(|k| self.feed.get(k).copied().unwrap_or(0.0) * time))
    }

    /// Adds the worn motions to those that a contact load prescribes.
    pub fn add_feed(&self, load: &mut ContactLoad) {
        for (k, fed) in self.fed().unwrap_or_default().into_iter().enumerate() {
            if let Motion::Prescribed { value } = &mut load.motions[k + 1] {
                *value -= fed;
            }
        }
    }

    /// The shape with its smallest rigid part; a prescribed rotation is kept.
    pub fn smallest(&self, pair: &Pair<'_>) -> Result<Shape, Fault> {
        let about = self.stage.about();
        let rigid = match self.stage.turned() {
            0.0 => RigidPart::Smallest,
            tilt => RigidPart::SmallestAlong {
                start: approach::coordinates(pair, [0.0, tilt], about),
                direction: approach::coordinates(pair, [1.0, 0.0], about),
            },
        };
        self.with_rigid_part(pair, rigid)
    }

    fn with_rigid_part(&self, pair: &Pair<'_>, rigid: RigidPart) -> Result<Shape, Fault> {
        solve_shape(&ShapeProblem {
            pair: *pair,
            traction: &|place| self.traction(place),
            cases_shaped: &self.stage.cases(),
            cases_counter: &[],
            gauge: self.stage.gauge(pair),
            rigid,
            integration: Integration::Lobatto,
        })
        .map_err(|error| Fault::at("load", "no-closing", error.to_string(), "press body 1 on body 2"))
    }
}

/// Arc lengths at which levels are compared.
fn samples(pair: &Pair<'_>) -> Vec<f64> {
    let length = pair.trace().length();
    (0..SAMPLES).map(|i| length * i as f64 / (SAMPLES - 1) as f64).collect()
}

fn states(shape: &Shape) -> [Option<&InterfaceState>; 2] {
    [Some(&shape.shaped), shape.counter.as_ref()]
}
