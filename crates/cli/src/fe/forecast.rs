//! What a run will take: the sizes of its levels by meshing them, and about how long by timing the first ones.

use std::time::Instant;

use hpfem::Sizes;
use scene::Fault;
use serde::Serialize;

use crate::fe::bodies::Level;
use crate::fe::stage::{Parts, Stage, fixed_level, ladder};
use crate::fe::template::Cut;
use crate::fe::{available, ends, half_disc, round};
use crate::setup::Problem;
use crate::solution::Solution;
use crate::solve::Options;

/// Degrees that are computed to see how fast the machine is, and how often: the fastest counts.
const TIMED: [usize; 2] = [6, 8];
const TIMES: usize = 3;
/// Meshes that find the ends of contact on one level, about.
const ENDS: f64 = 6.0;

/// One level of the ladder before it is computed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Forecast {
    /// Degree of the cells.
    pub(crate) degree: usize,
    /// Layers around singular points.
    pub(crate) layers: usize,
    /// Cells of both bodies.
    pub(crate) cells: usize,
    /// Unknowns of both bodies.
    pub(crate) dofs: usize,
    /// Unknowns of both contact traces.
    pub(crate) trace_dofs: usize,
    /// Points of the contact surface.
    pub(crate) contact_points: usize,
    /// Memory of both eliminations.
    pub(crate) memory_bytes: u64,
    /// Seconds until this level is done, those before it and the proof included, about.
    pub(crate) about_seconds: f64,
}

/// All levels that the run of a scene may climb to.
pub(crate) fn forecast(problem: &Problem) -> Result<Vec<Forecast>, Fault> {
    available(problem)?;
    let couple = half_disc::Couple::of(&problem.scene)?;
    let round = round::Round::of(&problem.scene)?;
    let parts = |level: Level| match &couple {
        Some(couple) => {
            let setting = ends::Setting::new(&problem.scene, couple);
            setting.parts(level, &setting.trial()?, &mut Solution::default())
        }
        None => match round {
            Some(round) => round::first_parts(problem, &round, level),
            None => Stage::new(problem)?.parts(level, Cut::Plain, &mut Solution::default()),
        },
    };
    let mut rate = 0.0_f64;
    for degree in TIMED {
        let level = parts(Level::of(&problem.scene, degree))?;
        let operations: f64 = sizes(&level)?.iter().map(|size| size.operations).sum();
        for _ in 0..TIMES {
            let start = Instant::now();
            level.interfaces(&mut Solution::default())?;
            rate = rate.max(operations / start.elapsed().as_secs_f64());
        }
    }
    let passes = if couple.is_some() { ENDS } else { 1.0 };
    let proof = problem.plan.runs("round trip");
    let mut before = 0.0;
    let mut found = Vec::new();
    for level in ladder(&problem.scene, Options::default()) {
        let (start, level_parts) = (Instant::now(), parts(level)?);
        let meshing = start.elapsed().as_secs_f64();
        let bodies = sizes(&level_parts)?;
        let contact = problem.plan.runs("contact") || problem.plan.runs("evolution");
        let operations = total(&bodies, contact);
        before += passes * (meshing + operations / rate);
        // The proof is one more level of two degrees more, with a contact solve on each.
        let proved = if proof {
            let finer = Level { degree: (level.degree + 2).min(hpfem::MAX_DEGREE), ..level };
            meshing + (total(&sizes(&parts(finer)?)?, true) + total(&bodies, true) - total(&bodies, false)) / rate
        } else {
            0.0
        };
        let sum = |of: fn(&Sizes) -> usize| bodies.iter().map(of).sum();
        found.push(Forecast {
            degree: level.degree,
            layers: level.layers,
            cells: sum(|size| size.cells),
            dofs: sum(|size| size.unknowns),
            trace_dofs: sum(|size| size.kept_unknowns),
            contact_points: bodies.iter().map(|size| size.points).max().unwrap_or(0),
            memory_bytes: bodies.iter().map(|size| size.bytes).sum(),
            about_seconds: before + proved,
        });
    }
    // The coarser levels of a fixed discretisation serve its error estimate; the last one is the run.
    if fixed_level(&problem.scene).is_some() {
        found.drain(..found.len().saturating_sub(1));
    }
    Ok(found)
}

fn sizes(parts: &Parts) -> Result<[Sizes; 2], Fault> {
    Ok([parts.parts[0].sizes("body1")?, parts.parts[1].sizes("body2")?])
}

/// Multiplications of a level: both bodies, both traces solved with, and for a contact the responses at its points and a solve on them.
fn total(bodies: &[Sizes; 2], contact: bool) -> f64 {
    let one = |size: &Sizes| {
        let (kept, points) = (size.kept_unknowns as f64, size.points as f64);
        let responses = if contact { points * kept * kept + points.powi(3) } else { 0.0 };
        size.operations + kept.powi(3) / 3.0 + responses
    };
    bodies.iter().map(one).sum()
}
