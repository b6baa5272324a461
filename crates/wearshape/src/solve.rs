//! Runs the stages of the plan and puts the solution together.

use scene::Fault;

use crate::bodies::Bodies;
use crate::effort::Effort;
use crate::faults::in_names_of;
use crate::hindsight;
use crate::ladder::Refusal;
use crate::machining;
use crate::options::Options;
use crate::path_profile::Inside;
use crate::problem::Problem;
use crate::results::{EnergyResult, ErrorResult};
use crate::scope::Scope;
use crate::solution::{AsMachined, Solution, Status};
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::Outcome;
use crate::steps::reported::Reported;
use crate::steps::shape::Before;
use crate::steps::{approach, contact, pressure, recover, reversing, shape, torsion, wear};
use crate::watch::Watch;

/// Computes everything the plan lists. What has no answer is a solution with its status; an `Err` is the user's to mend. `bodies` keeps what
/// was factorised for problems with the same bodies; `watch` is told what happens, and ends the solve by `Break`.
///
/// # Errors
/// What the user has to mend in the scene, as far as only solving shows it.
pub fn solve(problem: &Problem, options: &Options<'_>, bodies: &Bodies, watch: &mut Watch<'_>) -> Result<Solution, Fault> {
    let mut solution = Solution::default();
    match stages(Given { problem, options, bodies }, watch, &mut solution) {
        Ok(()) => {}
        Err(Refusal::Reason(reason) | Refusal::TooCoarse(reason)) => {
            (solution.status, solution.reason) = (Status::Refused, Some(reason))
        }
        Err(Refusal::Fault(fault)) => return Err(in_names_of(problem.couple.as_ref(), fault)),
    }
    if let Some(couple) = &problem.couple {
        let bodies = solution.fields.iter_mut().flat_map(|frame| frame.bodies.iter_mut().zip(&couple.bodies));
        bodies.for_each(|(field, body)| field.materials.clone_from(&body.materials));
    }
    let after = hindsight::remarks(problem, &solution);
    solution.remarks.extend(after);
    Ok(solution)
}

/// A problem with the caller's options and bodies.
#[derive(Clone, Copy)]
struct Given<'a> {
    problem: &'a Problem,
    options: &'a Options<'a>,
    bodies: &'a Bodies,
}

/// The force of a prescribed approach, the optimal pressure, and what takes elastic bodies.
fn stages(given: Given<'_>, watch: &mut Watch<'_>, solution: &mut Solution) -> Result<(), Refusal> {
    let Given { problem, options, bodies } = given;
    let mut known = None;
    if problem.plan.runs(Step::Force) {
        let (found, effort) = approach::force(Stage::new(problem, options, bodies)?, watch)?;
        solution.effort += effort;
        if found.stopped {
            solution.status = Status::Interrupted;
            return Ok(());
        }
        known = Some(found);
    }
    let problem = known.as_ref().map_or(problem, |found| &found.problem);
    if problem.plan.runs(Step::Pressure) && problem.reversing.is_none() {
        let mut effort = Effort::default();
        let found = effort.timed(Step::Pressure, options.clock, |_| pressure::solve(problem, options))?;
        solution.effort += effort;
        solution.take_pressure(found);
        solution.without_pressure = solution.status == Status::Refused;
    }
    if let Some((found, error)) = known.as_ref().zip(solution.error.as_mut()) {
        // The pressure is as accurate as the force; without an estimate nothing is said.
        error.pressure_relative = found.error.map(|of_force| of_force.max(f64::EPSILON));
        error.how = "force of the approach, rest of the series of degrees".into();
    }
    if solution.status != Status::Refused && problem.plan.runs(Step::Mesh) {
        elastic(Given { problem, ..given }, known.as_ref().map_or(0, |found| found.passes), watch, solution)?;
    }
    Ok(())
}

/// Contact, shape and wear as the plan asks, with twist and fields of the last of them; `passes` is what finding the force took.
fn elastic(given: Given<'_>, passes: usize, watch: &mut Watch<'_>, solution: &mut Solution) -> Result<(), Refusal> {
    let Given { problem, options, bodies } = given;
    let scope = Scope::of(problem, options, bodies)?;
    scope.available()?;
    if let Some((outcome, effort, fields)) = scope.solve(watch)? {
        solution.effort += effort;
        solution.take(outcome);
        solution.take_inside(fields);
        return Ok(());
    }
    let stage = Stage::new(problem, options, bodies)?;
    let mut reported: Option<Reported> = None;
    for step in [Step::Contact, Step::Shape, Step::Evolution] {
        if !problem.plan.runs(step) || matches!(solution.status, Status::Refused | Status::Interrupted) {
            continue;
        }
        let (outcome, effort) = match step {
            Step::Contact => contact::solve(stage, watch)?,
            Step::Shape if problem.reversing.is_some() => reversing::solve(stage, watch)?,
            Step::Shape => {
                let how = solution.error.as_ref().map(|error| error.how.clone()).unwrap_or_default();
                shape::solve(stage, &Before { passes, how: &how }, watch)?
            }
            _ => {
                solution.keep_as_machined();
                wear::solve(stage, watch)?
            }
        };
        solution.effort += effort;
        reported = solution.take(outcome);
        machining::compare(problem, step, solution);
    }
    let Some(reported) = reported.filter(|_| solution.status != Status::Interrupted) else { return Ok(()) };
    if let Some(profile) = solution.profile.as_mut().filter(|_| problem.plan.runs(Step::Torsion)) {
        solution.effort += torsion::fill(stage, &reported, (profile, solution.energy.get_or_insert_default()))?;
    }
    if problem.plan.runs(Step::Fields) {
        let mut effort = Effort::default();
        (options.begun)(Step::Fields);
        let (fields, work) = effort.timed(Step::Fields, options.clock, |_| recover::recover(stage, &reported))?;
        effort += work;
        solution.effort += effort;
        solution.take_inside(fields);
    }
    Ok(())
}

impl Solution {
    /// Takes in what an elastic step found; what it does not say stays. Returns what twist and fields need.
    fn take(&mut self, outcome: Outcome) -> Option<Reported> {
        let Outcome {
            ended,
            stopped,
            pressure,
            reversing,
            contact,
            interface,
            shape,
            wear,
            history,
            groove,
            machined,
            told,
            heat,
            error,
            running_in,
            ladder,
            remarks,
            reported,
            resume,
        } = outcome;
        if let Some((status, reason)) = ended {
            (self.status, self.reason) = (status, Some(reason));
        }
        if stopped {
            (self.status, self.reason) = (Status::Interrupted, None);
        }
        self.pressure = pressure.or(self.pressure.take());
        self.reversing = reversing.or(self.reversing.take());
        self.contact = contact.or(self.contact.take());
        self.interface = interface.or(self.interface.take());
        self.shape = shape.or(self.shape.take());
        self.wear = wear.or(self.wear.take());
        self.heat = heat.or(self.heat.take());
        self.machined = machined.or(self.machined.take());
        self.running_in = running_in.or(self.running_in.take());
        self.resume = resume;
        if !history.is_empty() {
            self.history = history;
        }
        if !groove.is_empty() {
            self.groove = groove;
        }
        if let Some(told) = told {
            self.energy = Some(told.energy);
            self.reactions = told.reactions;
            self.brake = told.brake;
            self.profile = Some(told.profile);
            self.curve = Some(told.curve);
        }
        self.ladder = ladder;
        self.remarks.extend(remarks);
        if !error.how.is_empty() {
            self.error.get_or_insert_default().take(error);
        }
        reported
    }

    /// Keeps what a shape gives the bodies, before a run in time says what it ends with.
    fn keep_as_machined(&mut self) {
        let curve = self.curve.clone().filter(|_| self.shape.is_some());
        self.as_machined = curve.map(|curve| AsMachined { curve, brake: self.brake.clone() });
    }

    /// Takes in what was recovered inside the bodies.
    fn take_inside(&mut self, Inside { frames, paths, energy }: Inside) {
        (self.fields, self.paths) = (frames, paths);
        if let Some(EnergyResult { body1, body2, .. }) = energy {
            let twisted = self.energy.take().unwrap_or_default();
            self.energy = Some(EnergyResult { body1, body2, ..twisted });
        }
    }

    /// Takes in the optimal pressure.
    fn take_pressure(&mut self, found: pressure::Found) {
        if let Some((status, reason)) = found.ended {
            (self.status, self.reason) = (status, Some(reason));
        }
        self.pressure = Some(found.result);
        self.brake = found.brake;
        (self.profile, self.curve, self.map, self.error) = (found.profile, found.curve, found.map, found.error);
    }
}

impl ErrorResult {
    /// Takes in the errors of a later step.
    fn take(&mut self, later: ErrorResult) {
        self.gap_relative = later.gap_relative.or(self.gap_relative);
        self.pressure_relative = later.pressure_relative.or(self.pressure_relative);
        self.energy_relative = later.energy_relative.or(self.energy_relative);
        self.twist_relative = later.twist_relative.or(self.twist_relative);
        self.p_max_relative = later.p_max_relative.or(self.p_max_relative);
        self.ends = later.ends.or(self.ends);
        self.stick_ends = later.stick_ends.or(self.stick_ends);
        self.how = later.how;
    }
}
