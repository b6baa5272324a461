//! The schedule of a run in time as scenes: each piece is the scene with its own load and sliding.

use scene::{Fault, Schedule};
use shapeopt::Interval;

use crate::freedom::freedoms;
use crate::setup::Problem;
use crate::surface::Patch;

/// The loads that occur, and which acts when.
pub(super) struct Pieces {
    /// Scenes of the different loads.
    pub(super) scenes: Vec<Problem>,
    /// The pieces in their order.
    pub(super) intervals: Vec<Interval>,
}

impl Pieces {
    /// The pieces of a scene; without a schedule the scene itself for ever.
    pub(super) fn of(problem: &Problem) -> Result<Pieces, Fault> {
        let Some(schedule) = &problem.scene.schedule else {
            let intervals = vec![Interval { stage: 0, duration: f64::INFINITY }];
            return Ok(Pieces { scenes: vec![problem.clone()], intervals });
        };
        let times: Vec<f64> = schedule.time.iter().flatten().map(|time| time.0).collect();
        let mut known: Vec<[f64; 3]> = Vec::new();
        let mut pieces = Pieces { scenes: Vec::new(), intervals: Vec::new() };
        for piece in 0..times.len() {
            let factors = factors(schedule, piece);
            let stage = match known.iter().position(|other| *other == factors) {
                Some(stage) => stage,
                None => {
                    known.push(factors);
                    pieces.scenes.push(under(problem, factors)?);
                    known.len() - 1
                }
            };
            let end = times.get(piece + 1).copied().unwrap_or(f64::INFINITY);
            pieces.intervals.push(Interval { stage, duration: end - times[piece] });
        }
        Ok(pieces)
    }
}

/// Factors on force, moment and speed of a piece.
fn factors(schedule: &Schedule, piece: usize) -> [f64; 3] {
    [&schedule.force, &schedule.moment, &schedule.speed]
        .map(|list| list.as_ref().and_then(|list| list.get(piece)).copied().unwrap_or(1.0))
}

/// The scene under its factors.
fn under(problem: &Problem, [force, moment, speed]: [f64; 3]) -> Result<Problem, Fault> {
    let mut problem = problem.clone();
    if let Some(load) = &mut problem.scene.load {
        load.force.iter_mut().for_each(|f| f.0 *= force);
        load.moment.iter_mut().for_each(|m| m.0 *= moment);
    }
    if let Some(sliding) = &mut problem.scene.sliding {
        sliding.omega.iter_mut().for_each(|omega| omega.0 *= speed);
        sliding.speed.iter_mut().for_each(|v| v.0 *= speed);
    }
    problem.patch = Patch::of(&problem.scene)?;
    problem.freedoms = freedoms(&problem.scene, problem.patch.as_ref())?;
    Ok(problem)
}
