//! The shape stage: levels of rising degree until the gap is accurate enough, then the round trip.

use std::sync::Arc;
use std::time::Instant;

use contact::{ContactLoad, ContactPoint, Motion, Pair};
use hpfem::InterfaceState;
use nalgebra::{DMatrix, Vector3};
use scene::{Balance, Fault};
use shapeopt::{GapCurve, Integration, RigidPart, Shape, ShapeProblem, SurfacePlace, closing, solve_shape};

use crate::fe::approach;
use crate::fe::bodies::Level;
use crate::fe::gap_difference::{Measure, difference_of_gaps};
use crate::fe::operators::Reduced;
use crate::fe::pressure_ends::pressure_ends;
use crate::fe::recover::{Moment, Reported};
use crate::fe::round_trip;
use crate::fe::rungs::{add_times, rungs};
use crate::fe::stage::{Stage, note, rest};
use crate::fe::tolerance;
use crate::fe::torsion;
use crate::freedom::Role;
use crate::machined::{Machined, SurfacePoint};
use crate::profile::Profile;
use crate::setup::Problem;
use crate::solution::{EnergyResult, ShapeResult, Solution, Status};
use crate::solve::{CURVE, Options};

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
    /// Counters and times.
    solution: Solution,
}

/// Solves for the shape and fills in the solution.
pub(super) fn solve(problem: &Problem, options: Options, solution: &mut Solution) -> Result<Option<Reported>, Fault> {
    let stage = Stage::new(problem)?;
    let wear = crate::solve::pressure::wear_problem(&problem.scene, stage.patch, &problem.freedoms)
        .map_err(|error| Fault::at("wear", "wrong-value", error.to_string(), "mend the numbers in the message"))?;
    let optimum = match wear::optimal_pressure(&wear) {
        Ok(optimum) => optimum,
        Err(error) => {
            solution.status = Status::Refused;
            solution.reason = Some(error.to_string());
            return Ok(None);
        }
    };
    if let Some(reason) = unanswered(stage, &optimum) {
        solution.status = Status::Refused;
        solution.reason = Some(reason);
        return Ok(None);
    }
    let carried = balanced(problem, &optimum)?;
    let stage = match &carried {
        Some(problem) => Stage::new(problem)?,
        None => stage,
    };
    let shaper = Shaper::new(stage, &optimum);
    let fixed = stage.fixed_level().is_some();
    let mut solved: Vec<Solved> = Vec::new();
    for level in stage.ladder(options) {
        if crate::interrupt::asked() {
            solution.status = Status::Interrupted;
            return Ok(None);
        }
        solved.push(shaper.level(level)?);
        if !fixed && estimate(&solved, Measure::of(stage.scene())).is_some_and(|error| error <= stage.accuracy()) {
            break;
        }
    }
    finish(&shaper, solved, fixed, options, solution)
}

/// The problem under the force that the pressure really carries, where that is not the load (`optimum.balance = "paper"` on an arc): bodies out
/// of balance have no shape.
fn balanced(problem: &Problem, optimum: &wear::Optimum) -> Result<Option<Problem>, Fault> {
    let paper = problem.scene.optimum.as_ref().and_then(|optimum| optimum.balance) == Some(Balance::Paper);
    let push = problem.freedoms.iter().position(|freedom| freedom.role == Role::Force);
    match push.filter(|_| paper) {
        Some(push) => approach::with_force(problem, optimum.resultants[push]).map(Some),
        None => Ok(None),
    }
}

/// Why a wanted pressure has no shape: it is infinite somewhere.
pub(super) fn unanswered(stage: Stage<'_>, optimum: &wear::Optimum) -> Option<String> {
    let points = stage.patch.surface.sample(SAMPLES);
    let point = points.iter().find(|point| !optimum.pressure_at(point).is_finite())?;
    let [x, z] = [point.position.x, point.position.z];
    Some(format!(
        "the wanted pressure is infinite at x = {x}, z = {z}, and no shape has it; leave a hole or a cap there (optimum.p_max)"
    ))
}

/// Estimated `max |dg|` of the last level over the size of the gap, after the best rigid part is taken out of each difference.
fn estimate(solved: &[Solved], measure: Measure) -> Option<f64> {
    let difference = |a: &Solved, b: &Solved| difference_of_gaps(&a.gaps, &b.gaps, &b.closing, measure);
    let [.., a, b, c] = solved else { return None };
    Some(rest(difference(a, b), difference(b, c)))
}

/// Reports the last level with the error estimate and the effort of all, and proves it.
fn finish(
    shaper: &Shaper<'_>,
    mut solved: Vec<Solved>,
    fixed: bool,
    options: Options,
    solution: &mut Solution,
) -> Result<Option<Reported>, Fault> {
    let measure = Measure::of(shaper.stage.scene());
    let error = estimate(&solved, measure);
    let accuracy = shaper.stage.accuracy();
    let levels = solved.len();
    let times: Vec<_> = solved.iter().map(|s| s.solution.times.clone()).collect();
    solution.counters.factorisations += solved.iter().map(|s| s.solution.counters.factorisations).sum::<usize>();
    let change = |i: usize| difference_of_gaps(&solved[i - 1].gaps, &solved[i].gaps, &solved[i].closing, measure);
    solution.ladder = rungs(&shaper.stage.ladder(options), levels, "gap", change, |i| estimate(&solved[..=i], measure));
    let Some(last) = solved.pop() else { return Ok(None) };
    add_times(&times, &mut solution.times);
    shaper.report(&last, options, solution)?;
    let result = solution.error.get_or_insert_default();
    result.gap_relative = error;
    let closed = std::mem::take(&mut result.how);
    let of = if measure == Measure::Crown { "gap relative to its crown" } else { "gap" };
    result.how = match error {
        Some(_) => format!("{of}: rest of the series of {levels} degrees; pressure: {closed}"),
        None => format!("gap: not estimated below degree 5; pressure: {closed}"),
    };
    if let (false, Some(error)) = (fixed, error)
        && error > accuracy
    {
        solution.status = Status::AccuracyMissed;
        solution.reason = Some(format!("the gap is accurate to {error:.1e}, not to the {accuracy:.0e} asked for"));
    }
    if shaper.stage.problem.plan.runs("round trip") {
        let start = Instant::now();
        let same = round_trip::same(shaper, &last.reduced, &last.shape, solution)?;
        let curve = GapCurve::of(&last.shape, &last.reduced.pair()?);
        let independent = round_trip::independent(shaper, last.level, &curve, solution)?;
        note(solution, "round trip", start);
        solution.counters.check_solves += 2;
        if let Some(shape) = &mut solution.shape {
            shape.roundtrip_same = Some(same);
            shape.roundtrip_independent = Some(independent);
        }
    }
    shaper.reported(last)
}

/// The wanted tractions and the shape they ask for.
pub(super) struct Shaper<'a> {
    pub(super) stage: Stage<'a>,
    pub(super) optimum: &'a wear::Optimum,
    /// Ends of the wanted pressure inside the surface.
    ends: Vec<f64>,
    feed: Vec<f64>,
}

impl<'a> Shaper<'a> {
    pub(super) fn new(stage: Stage<'a>, optimum: &'a wear::Optimum) -> Shaper<'a> {
        Shaper { stage, optimum, ends: pressure_ends(stage, optimum), feed: optimum.feed.clone().unwrap_or_default() }
    }

    /// Solves one level.
    fn level(&self, level: Level) -> Result<Solved, Fault> {
        let mut solution = Solution::default();
        let reduced = self.stage.reduced_at(level, &self.ends, &mut solution)?;
        let start = Instant::now();
        let pair = reduced.pair()?;
        let shape = self.shape(&pair)?;
        note(&mut solution, "shape", start);
        let arcs = samples(&pair);
        let gaps: Vec<f64> = arcs.iter().map(|arc| shape.gap(&pair, &pair.at_arc(*arc))).collect();
        let mut modes = DMatrix::zeros(SAMPLES, pair.shaped.rigid_modes.ncols());
        for (row, arc) in arcs.iter().enumerate() {
            for (k, phi) in closing(&pair, &pair.at_arc(*arc)).into_iter().enumerate() {
                modes[(row, k)] = phi;
            }
        }
        Ok(Solved { level, reduced, shape, gaps, closing: modes, solution })
    }

    /// Everything that is reported of a level but its proof.
    fn report(&self, solved: &Solved, options: Options, solution: &mut Solution) -> Result<(), Fault> {
        let Solved { reduced, shape, gaps, .. } = solved;
        let (stage, pair) = (self.stage, reduced.pair()?);
        reduced.count(&mut solution.counters);
        let most = (0..gaps.len()).max_by(|a, b| gaps[*a].total_cmp(&gaps[*b])).unwrap_or(0);
        let lowest = match Measure::of(stage.scene()) {
            Measure::Largest => 0.0,
            Measure::Crown => gaps.iter().copied().fold(f64::INFINITY, f64::min),
        };
        solution.shape = Some(ShapeResult {
            iterations: solution.passes + 1,
            gap_max_um: Some(1e3 * gaps[most]),
            gap_where_mm: Some(stage.start(&pair) + samples(&pair)[most]),
            crown_um: Some(1e3 * (gaps[most] - lowest)),
            rigid_mm: shape.rigid.first().copied(),
            roundtrip_same: None,
            roundtrip_independent: None,
            tolerance: if options.machining { tolerance::of(self, reduced)? } else { Vec::new() },
        });
        solution.energy = Some(EnergyResult {
            body1_Nmm: Some(pair.shaped.strain_energy(&shape.shaped)),
            body2_Nmm: pair.counter.zip(shape.counter.as_ref()).map(|(body, state)| body.strain_energy(state)),
        });
        solution.reactions = reduced.reactions(states(shape));
        let points = options.sample.map_or_else(|| pair.points(), |sampling| stage.sample(&pair, sampling));
        let profile = self.profile(&pair, shape, &points);
        solution.machined = options.machining.then(|| self.machined(&pair, shape));
        solution.profile = Some(profile);
        solution.curve = Some(self.profile(&pair, shape, &stage.sample(&pair, CURVE)));
        Ok(())
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
    fn reported(&self, last: Solved) -> Result<Option<Reported>, Fault> {
        let place = |p: &ContactPoint| SurfacePlace { position: p.position, normal: p.normal };
        let points = last.reduced.pair()?.points();
        let pressure: Vec<f64> = points.iter().map(|p| self.pressure(&place(p))).collect();
        let around = torsion::around(self.stage, &points, &pressure);
        let Shape { shaped, counter, .. } = last.shape;
        Ok(counter.map(|counter| {
            let moments = vec![Moment { time_s: 0.0, name: "", states: [shaped, counter], around }];
            Reported { level: last.level, ends: self.ends.clone(), moments }
        }))
    }

    /// Wanted pressure at a place.
    pub(super) fn pressure(&self, place: &SurfacePlace) -> f64 {
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
    pub(super) fn shape(&self, pair: &Pair<'_>) -> Result<Shape, Fault> {
        let load = self.stage.scene().load.clone().unwrap_or_default();
        if !self.stage.rigid_prescribed() {
            return self.smallest(pair);
        }
        let fed = self.fed()?;
        let about = self.stage.about();
        let turned = match (load.approach, load.tilt) {
            // A rotation that nothing prescribes is that of the smallest shape.
            (Some(_), None) => approach::motion(pair, &self.smallest(pair)?.rigid, about)[1],
            (_, tilt) => tilt.map_or(0.0, |t| t.0),
        };
        let motion = [load.approach.map_or(0.0, |a| a.0) + fed[0], turned + fed[1]];
        self.with_rigid_part(pair, RigidPart::Prescribed(approach::coordinates(pair, motion, about)))
    }

    /// Worn approach and turning after `approach_time`.
    fn fed(&self) -> Result<[f64; 2], Fault> {
        let load = self.stage.scene().load.as_ref();
        let time = load.and_then(|load| load.approach_time).map_or(0.0, |t| t.0);
        if time != 0.0 && self.feed.is_empty() {
            let message = "approach_time needs the feed of wear, and the multipliers of this functional are no velocities";
            let remedy = "use optimum.functional = \"steady\", or \"wear-power\" with q = 1 and equal b, with wear";
            return Err(Fault::at("load.approach_time", "no-feed", message, remedy));
        }
        Ok([0, 1].map(|k| self.feed.get(k).copied().unwrap_or(0.0) * time))
    }

    /// Adds the worn motions to those that a contact load prescribes.
    pub(super) fn add_feed(&self, load: &mut ContactLoad) {
        for (k, fed) in self.fed().unwrap_or_default().into_iter().enumerate() {
            if let Motion::Prescribed { value } = &mut load.motions[k + 1] {
                *value -= fed;
            }
        }
    }

    /// The shape with its smallest rigid part; a prescribed rotation is kept.
    pub(super) fn smallest(&self, pair: &Pair<'_>) -> Result<Shape, Fault> {
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

    fn profile(&self, pair: &Pair<'_>, shape: &Shape, points: &[ContactPoint]) -> Profile {
        let pressure: Vec<f64> =
            points.iter().map(|p| self.pressure(&SurfacePlace { position: p.position, normal: p.normal })).collect();
        let mut profile = self.stage.profile(pair, points, &pressure, states(shape));
        for (row, point) in points.iter().enumerate() {
            profile.gap[row] = 1e3 * shape.gap(pair, point);
            profile.opening[row] = 0.0;
        }
        profile
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
