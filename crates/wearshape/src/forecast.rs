//! What a run will take: the sizes of its levels by meshing them, and about how long by timing the first ones.

use hpfem::Sizes;
use scene::Fault;
use serde::Serialize;

use crate::bodies::Bodies;
use crate::faults::in_names_of;
use crate::fixed;
use crate::heat::{Heat, Meets};
use crate::ladder::Ladder;
use crate::level::Level;
use crate::options::Options;
use crate::problem::Problem;
use crate::scope::Scope;
use crate::step::Step;

/// How often the first level is computed to see how fast the machine is: the fastest counts.
const TIMES: usize = 2;
/// Seconds of a computation that need no second look: what it takes once, such as tables and memory, is a small part of them.
const LONG: f64 = 0.005;
/// Multiplications that take as long as what a cell takes besides those of its matrix and its elimination, about: they tell the time of a level of degree 12
/// from that of degree 4 to within two thirds for the bodies of the built-in scenes.
const BESIDE: f64 = 2e5;
/// Meshes that find the ends of contact on one level, about.
const ENDS: f64 = 6.0;
/// What temperatures take besides displacements on a level with heat, and what the influence of the heat at all its points takes, in multiples of the
/// level without heat, about: of the built-in scenes with heat.
const WARM: f64 = 1.0;
const INFLUENCE: f64 = 1.5;

/// One level of the ladder before it is computed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Forecast {
    /// Degree of the cells.
    pub degree: usize,
    /// Layers around singular points.
    pub layers: usize,
    /// Cells of both bodies.
    pub cells: usize,
    /// Unknowns of both bodies.
    pub dofs: usize,
    /// Unknowns of both contact traces.
    pub trace_dofs: usize,
    /// Points of the contact surface.
    pub contact_points: usize,
    /// Memory of both eliminations; with frictional heat that of the temperatures and of the responses to the heat of each contact point too.
    pub memory_bytes: u64,
    /// Seconds until this level is done, those before it and the proof included, about.
    pub about_seconds: f64,
}

/// A level, the seconds that its meshes and sizes took, and the sizes of its bodies.
type Sized = (Level, f64, [Sizes; 2]);

impl Problem {
    /// The levels that a solve is expected to climb, by meshing them, none where the pressure alone is asked for; about how long by timing the first one
    /// with the clock of the options, which are also told of every mesh and elimination. More levels follow where errors fall slower than is usual.
    ///
    /// # Errors
    /// What is not built, or cannot be meshed or held.
    pub fn forecast(&self, options: &Options<'_>) -> Result<Vec<Forecast>, Fault> {
        self.forecast_on(options, &Bodies::default())
    }

    /// [`Problem::forecast`] on meshes that [`Problem::available_on`] left to the same `bodies`.
    ///
    /// # Errors
    /// Those of [`Problem::forecast`].
    pub fn forecast_on(&self, options: &Options<'_>, bodies: &Bodies) -> Result<Vec<Forecast>, Fault> {
        forecast(self, options, bodies).map_err(|fault| in_names_of(self.couple.as_ref(), fault))
    }
}

fn forecast(problem: &Problem, options: &Options<'_>, bodies: &Bodies) -> Result<Vec<Forecast>, Fault> {
    if !problem.plan.runs(Step::Mesh) {
        return Ok(Vec::new());
    }
    let clock = options.clock;
    let scope = Scope::of(problem, options, bodies)?;
    scope.available()?;
    let passes = if matches!(scope, Scope::HalfDisc(..)) { ENDS } else { 1.0 };
    let proof = problem.plan.runs(Step::RoundTrip);
    let contact = problem.plan.runs(Step::Contact) || problem.plan.runs(Step::Evolution);
    let [warm, influence] = if problem.heat.is_some() { [WARM, INFLUENCE] } else { [0.0; 2] };
    let in_time = problem.plan.runs(Step::Evolution) && !problem.plan.runs(Step::Contact) && !problem.plan.runs(Step::Shape);
    let step = if in_time { Step::Evolution } else { Step::Shape };
    let beside = problem.wanted.fixed.filter(|_| !in_time && !options.alone).map(fixed::beside);
    let mut sized: Vec<Sized> = Vec::new();
    for level in beside.into_iter().chain(Ladder::of(problem, options, step).expected()) {
        let start = clock();
        let sizes = scope.sizes(level)?;
        sized.push((level, clock() - start, sizes));
    }
    let rate = rate(&scope, &sized, options)?;
    let mut before = 0.0;
    let mut found = Vec::new();
    for (number, (level, meshing, bodies)) in sized.iter().enumerate() {
        let operations = (1.0 + warm) * total(bodies, contact);
        before += passes * (meshing + operations / rate);
        // The proof is one more level of two degrees more, like the next one, with a contact solve on each.
        let proved = if proof {
            let finer = finer(&scope, &sized, number)?;
            meshing + ((1.0 + warm + influence) * finer + total(bodies, true) - total(bodies, false)) / rate
        } else {
            0.0
        };
        // The factors on the speed of the reported level.
        let limits = influence * total(bodies, true) / rate;
        let sum = |of: fn(&Sizes) -> usize| bodies.iter().map(of).sum();
        found.push(Forecast {
            degree: level.degree,
            layers: level.layers,
            cells: sum(|size| size.cells),
            dofs: sum(|size| size.unknowns),
            trace_dofs: sum(|size| size.kept_unknowns),
            contact_points: bodies.iter().map(|size| size.points).max().unwrap_or(0),
            memory_bytes: memory(problem.heat.as_ref(), bodies),
            about_seconds: before + limits + proved,
        });
    }
    // Other levels of a fixed discretisation serve its error estimate; the last one is the run.
    if problem.wanted.fixed.is_some() {
        found.drain(..found.len().saturating_sub(1));
    }
    Ok(found)
}

/// Multiplications of the level of the proof, two degrees above a level: those of the next one, of the last level about.
fn finer(scope: &Scope<'_>, sized: &[Sized], number: usize) -> Result<f64, Fault> {
    let (level, _, bodies) = &sized[number];
    let [coarser, next] = [number.checked_sub(1), Some(number + 1)].map(|k| sized.get(k?));
    match (coarser, next) {
        (_, Some((next, _, bodies))) if next.degree == level.degree + 2 => Ok(total(bodies, true)),
        // They grow from level to level about alike.
        (Some((coarser, _, before)), None) if coarser.degree + 2 == level.degree => {
            Ok(total(bodies, true).powi(2) / total(before, true))
        }
        _ => {
            let degree = (level.degree + 2).min(hpfem::MAX_DEGREE);
            Ok(total(&scope.sizes(Level { degree, ..*level })?, true))
        }
    }
}

/// Multiplications a second of this machine by the first of the levels; infinite by a clock that stands.
fn rate(scope: &Scope<'_>, sized: &[Sized], options: &Options<'_>) -> Result<f64, Fault> {
    let Some((level, _, sizes)) = sized.first() else { return Ok(f64::INFINITY) };
    let clock = options.clock;
    let parts = scope.parts(*level)?;
    (options.begun)(Step::Factor);
    let mut least = f64::INFINITY;
    for _ in 0..TIMES {
        let start = clock();
        parts.interfaces(clock)?;
        least = least.min(clock() - start);
        if least > LONG {
            break;
        }
    }
    Ok(sizes.iter().map(of_body).sum::<f64>() / least)
}

/// Multiplications of meshing, assembling and eliminating a body.
fn of_body(size: &Sizes) -> f64 {
    size.operations + BESIDE * size.cells as f64
}

/// Memory of both eliminations, and of the temperatures of bodies that have a field of them.
fn memory(heat: Option<&Heat>, bodies: &[Sizes; 2]) -> u64 {
    let warm = match heat.map(|heat| heat.meets) {
        None => &bodies[..0],
        Some(Meets::Congruent) => &bodies[..],
        Some(Meets::Revolving(_) | Meets::Fresh(_)) => &bodies[..1],
    };
    // A temperature has one component: a quarter of the matrices.
    let temperatures: u64 = warm.iter().map(|size| size.bytes / 4).sum();
    let cells: u64 = warm.iter().map(Sizes::for_heat_bytes).sum();
    let responses = warm.iter().map(|size| size.heated_bytes(size.points)).max();
    bodies.iter().map(|size| size.bytes).sum::<u64>() + temperatures + cells + responses.unwrap_or(0)
}

/// Multiplications of a level: both bodies, both traces solved with, and for a contact the responses at its points and a solve on them.
fn total(bodies: &[Sizes; 2], contact: bool) -> f64 {
    let one = |size: &Sizes| {
        let (kept, points) = (size.kept_unknowns as f64, size.points as f64);
        let responses = if contact { points * kept * kept + points.powi(3) } else { 0.0 };
        of_body(size) + kept.powi(3) / 3.0 + responses
    };
    bodies.iter().map(one).sum()
}
