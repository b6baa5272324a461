//! The contact stage of a round body on a flat one of which at least one is given by its cells: the surface that may touch is a little longer
//! than the contact, found from a first guess by solving on it; gap `R - sqrt(R^2 - x^2)` plus that of the scene, conditions on the flat side.

use contact::Status as ContactStatus;
use scene::{Fault, Kinematics, Scene, Task};

use crate::fe::bodies::{Level, kinematics};
use crate::fe::contact::{climb, on_standing_mesh, solve_level};
use crate::fe::free_ends::FreeEnds;
use crate::fe::hertz_trial::hertz_end;
use crate::fe::recover;
use crate::fe::stage::Stage;
use crate::fe::template::Extent;
use crate::given::{ContactLine, contact_line, given};
use crate::setup::Problem;
use crate::solution::{Solution, Status};
use crate::solve::Options;
use crate::surface::Patch;

/// Length of the surface that may touch over that of the contact, and the range of it that is left as it is.
const CANDIDATE: [f64; 3] = [1.2, 1.5, 2.2];
/// Degree on which the length is found.
const FIRST: usize = 4;
/// Most lengths tried; each may double or halve the one before.
const TRIALS: usize = 24;

/// A round body on a flat one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Round {
    radius: f64,
    /// Where the bodies touch unloaded.
    touch: f64,
    height: f64,
    /// The longest surface that may touch, to each side.
    longest: f64,
    revolved: bool,
}

impl Round {
    /// The round contact of a scene; none where both bodies are templates, or the contact is another.
    pub(super) fn of(scene: &Scene) -> Result<Option<Round>, Fault> {
        let (Some(body1), Some(body2)) = (&scene.body1, &scene.body2) else { return Ok(None) };
        let Some(edges) = scene.contact.as_ref().and_then(|contact| contact.edges.as_ref()) else { return Ok(None) };
        if given("body1", body1)?.is_none() && given("body2", body2)?.is_none() {
            return Ok(None);
        }
        let ContactLine::Circle { centre, radius, angles, internal: true } = contact_line("body1", body1, &edges[0], true)?
        else {
            return Ok(None);
        };
        // Angles from the z axis, in falling x.
        let x = [angles[1], angles[0]].map(|angle| centre[0] + radius * angle.sin());
        let ContactLine::Line { z, x: under } = contact_line("body2", body2, &edges[1], false)? else { return Ok(None) };
        let (touch, revolved) = (centre[0], scene.kinematics == Some(Kinematics::Axisymmetric));
        let sides = [[touch - x[0], x[1] - touch], [touch - under[0], under[1] - touch]];
        let longest =
            sides.iter().flat_map(|side| if revolved { &side[1..] } else { &side[..] }).fold(0.7 * radius, |m, s| m.min(*s));
        Ok(Some(Round { radius, touch, height: z, longest: 0.98 * longest, revolved }))
    }

    /// The surface that may touch, as far as `reach` from the first point.
    fn extent(&self, reach: f64) -> Extent {
        let from = if self.revolved { self.touch } else { self.touch - reach };
        Extent::Round { x: [from, self.touch + reach], touch: self.touch, radius: self.radius }
    }

    /// A first guess of how far the surface that may touch goes.
    fn guess(&self, scene: &Scene) -> Result<f64, Fault> {
        let mut materials = [Vec::new(), Vec::new()];
        for (own, (key, body)) in materials.iter_mut().zip([("body1", &scene.body1), ("body2", &scene.body2)]) {
            let Some(body) = body else { continue };
            own.extend(given(key, body)?.map_or_else(|| body.material.into_iter().collect(), |given| given.materials));
        }
        let load = scene.load.clone().unwrap_or_default();
        let end = hertz_end(self.radius, [&materials[0], &materials[1]], &load, kinematics(scene));
        if end > 0.0 {
            return Ok((CANDIDATE[1] * end).min(self.longest));
        }
        let message = format!("an approach of {} mm does not press body 1 on body 2", load.approach.map_or(0.0, |a| a.0));
        Err(Fault::at("load.approach", "wrong-value", message, "give an approach greater than 0"))
    }
}

/// Refuses what is not built, before anything is written.
pub(super) fn available(problem: &Problem, round: &Round) -> Result<(), Fault> {
    let scene = &problem.scene;
    if let Some(task) = scene.tasks.iter().flatten().find(|task| **task != Task::Contact) {
        let task = format!("{task:?}").to_lowercase();
        let message = format!("a round body on a flat one has the task contact, but no {task} yet");
        return Err(Fault::at("tasks", "not-available", message, "write tasks = [\"contact\"]"));
    }
    if scene.load.as_ref().is_some_and(|load| load.shear_force.is_some_and(|force| force.0 != 0.0)) {
        let message = "stick and slip is known between the templates half-disc and rectangle only";
        return Err(Fault::at("load.shear_force", "not-available", message, "use these templates, or remove load.shear_force"));
    }
    with_stage(problem, round, round.guess(scene)?, |stage| stage.meshes(1).map(|_| ()))
}

/// Does something with the stage of a surface that may touch as far as `reach`.
pub(super) fn with_stage<T>(
    problem: &Problem,
    round: &Round,
    reach: f64,
    act: impl FnOnce(Stage<'_>) -> Result<T, Fault>,
) -> Result<T, Fault> {
    let extent = round.extent(reach);
    let patch = Patch::flat(&problem.scene, extent.ends(), round.height)?;
    act(Stage { problem, patch: &patch, extent })
}

/// Parts of a level on the first guess, for a forecast.
pub(super) fn first_parts(problem: &Problem, round: &Round, level: Level) -> Result<crate::fe::stage::Parts, Fault> {
    with_stage(problem, round, round.guess(&problem.scene)?, |stage| {
        stage.parts(level, crate::fe::template::Cut::Plain, &mut Solution::default())
    })
}

/// Solves the contact and fills in the solution.
pub(super) fn solve(problem: &Problem, round: &Round, options: Options, solution: &mut Solution) -> Result<(), Fault> {
    let mut reach = round.guess(&problem.scene)?;
    for _ in 0..TRIALS {
        let touched = with_stage(problem, round, reach, |stage| {
            let (found, length) = on_standing_mesh(stage, Level::of(stage.scene(), FIRST), solution)?;
            if !found.status.is_solved() || found.status == ContactStatus::NoContact {
                return Ok(None);
            }
            let from = if round.revolved { 0.0 } else { -0.5 * length };
            Ok(found.zones.iter().flatten().map(|arc| (from + arc).abs()).reduce(f64::max))
        })?;
        let Some(touched) = touched else { break };
        if (CANDIDATE[0] * touched..=CANDIDATE[2] * touched).contains(&reach) {
            break;
        }
        if touched * CANDIDATE[0] > round.longest {
            solution.status = Status::Refused;
            let to = round.longest;
            solution.reason = Some(format!(
                "the contact reaches {touched:.4} mm from the middle; the bodies are round and flat for {to:.4} mm"
            ));
            return Ok(());
        }
        reach = (CANDIDATE[1] * touched).min(round.longest);
    }
    with_stage(problem, round, reach, |stage| {
        let mut ends = FreeEnds::default();
        let mut diagnosis = None;
        let reported =
            climb(stage.scene(), options, solution, |level| solve_level(stage, level, options, &mut ends, &mut diagnosis))?;
        diagnosis.iter().try_for_each(|diagnosis| diagnosis.report(stage, solution))?;
        match reported {
            Some(reported) if problem.plan.runs("field recovery") => {
                crate::solve::timed(solution, "field recovery", |solution| recover::recover(stage, &reported, solution))
            }
            _ => Ok(()),
        }
    })
}
