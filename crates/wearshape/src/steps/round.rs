//! The contact stage of a round body on a flat one of which at least one is given by its cells: the surface that may touch is a little longer
//! than the contact, found from a first guess by solving on it; gap `R - sqrt(R^2 - x^2)` plus that of the scene, conditions on the flat side.

use contact::Status as ContactStatus;
use meshing::{ContactLine, Couple, Cut, Extent, contact_line};
use scene::Fault;

use crate::bodies::Bodies;
use crate::effort::Effort;
use crate::gap_profile;
use crate::ladder::{Ladder, Refusal};
use crate::level::Level;
use crate::load::Load;
use crate::options::Options;
use crate::parts::Parts;
use crate::path_profile::Inside;
use crate::problem::Problem;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::Outcome;
use crate::steps::contact::{Search, on_standing_mesh, solve_level};
use crate::steps::contact_levels::levels;
use crate::steps::ends_scope::contact_alone;
use crate::steps::hertz_trial::hertz_end;
use crate::steps::recover;
use crate::surface::Patch;
use crate::watch::Watch;

/// Length of the surface that may touch over that of the contact, and the range of it that is left as it is.
const CANDIDATE: [f64; 3] = [1.2, 1.5, 2.2];
/// Degree on which the length is found.
const FIRST: usize = 4;
/// Most lengths tried; each may double or halve the one before.
const TRIALS: usize = 24;

/// A round body on a flat one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Round {
    radius: f64,
    /// Where the bodies touch unloaded.
    touch: f64,
    height: f64,
    /// The longest surface that may touch, to each side.
    longest: f64,
    revolved: bool,
}

impl Round {
    /// The round contact of two bodies; none where both are templates, or the contact is another.
    pub(crate) fn of(couple: &Couple) -> Result<Option<Round>, Fault> {
        let [body1, body2] = &couple.bodies;
        if body1.cells.is_none() && body2.cells.is_none() {
            return Ok(None);
        }
        let ContactLine::Circle { centre, radius, angles, internal: true } = contact_line(body1, true)? else {
            return Ok(None);
        };
        // Angles from the z axis, in falling x.
        let x = [angles[1], angles[0]].map(|angle| centre[0] + radius * angle.sin());
        let ContactLine::Line { z, x: under } = contact_line(body2, false)? else { return Ok(None) };
        let (touch, revolved) = (centre[0], couple.is_revolved());
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
    fn guess(&self, couple: &Couple, load: &Load) -> Result<f64, Fault> {
        let end = hertz_end(self.radius, couple, load);
        if end > 0.0 {
            return Ok((CANDIDATE[1] * end).min(self.longest));
        }
        let message = format!("an approach of {} mm does not press body 1 on body 2", load.approach.unwrap_or(0.0));
        Err(Fault::at("load.approach", "wrong-value", message, "give an approach greater than 0"))
    }
}

/// A round contact of a problem.
#[derive(Clone, Copy)]
pub(crate) struct RoundContact<'a> {
    pub problem: &'a Problem,
    pub couple: &'a Couple,
    pub round: Round,
    pub options: &'a Options<'a>,
    pub bodies: &'a Bodies,
}

impl RoundContact<'_> {
    /// Refuses what is not built, before anything is written.
    pub(crate) fn available(&self) -> Result<(), Fault> {
        contact_alone(self.problem, "a round body on a flat one")?;
        if self.problem.load.shear_force != 0.0 {
            let message = "stick and slip is known between the templates half-disc and rectangle only";
            let remedy = "use these templates, or remove load.shear_force";
            return Err(Fault::at("load.shear_force", "not-available", message, remedy));
        }
        self.on_guess(|stage| stage.meshes(1, Cut::Plain).map(|_| ()))
    }

    /// Parts of a level on the first guess, for a forecast.
    pub(crate) fn first_parts(&self, level: Level) -> Result<Parts, Fault> {
        self.on_guess(|stage| Ok(stage.parts(level, Cut::Plain)?.0))
    }

    fn on_guess<T>(&self, act: impl FnOnce(Stage<'_>) -> Result<T, Fault>) -> Result<T, Fault> {
        self.on(self.round.guess(self.couple, &self.problem.load)?, act)
    }

    /// Does something with the stage of a surface that may touch as far as `reach`.
    fn on<T, E: From<Fault>>(&self, reach: f64, act: impl FnOnce(Stage<'_>) -> Result<T, E>) -> Result<T, E> {
        let RoundContact { problem, couple, round, options, bodies } = *self;
        let extent = round.extent(reach);
        let patch = Patch::flat(couple.kinematics, extent.ends(), round.height, problem.sliding.as_ref())?;
        act(Stage { problem, couple, patch: &patch, extent, options, bodies })
    }

    /// Solves the contact, with the fields if they are asked for.
    pub(crate) fn solve(&self, watch: &mut Watch<'_>) -> Result<(Outcome, Effort, Inside), Refusal> {
        let (reach, mut effort) = self.reach()?;
        self.on(reach, |stage| {
            if let Some(surface) = stage.patch.places() {
                let contact = stage.problem.scene.contact.as_ref();
                contact.and_then(|contact| contact.gap.as_ref()).map_or(Ok(()), |gap| gap_profile::covers(gap, surface))?;
            }
            let mut search = Search::default();
            let ladder = Ladder::of(stage.problem, stage.options, Step::Contact).and_beyond(stage.problem);
            let (mut outcome, work, last) = levels(&ladder, watch, &mut |level, expected| {
                search.expected = expected;
                solve_level(stage, level, &mut search)
            })?;
            effort += work;
            let diagnosis = last.and_then(|last| last.diagnosis);
            diagnosis.iter().try_for_each(|diagnosis| diagnosis.report(stage, &mut outcome))?;
            let reported = outcome.reported.take().filter(|_| stage.problem.plan.runs(Step::Fields));
            let Some(reported) = reported else { return Ok((outcome, effort, Inside::default())) };
            (stage.options.begun)(Step::Fields);
            let (fields, work) = effort.timed(Step::Fields, stage.clock(), |_| recover::recover(stage, &reported))?;
            effort += work;
            Ok((outcome, effort, fields))
        })
    }

    /// How far the surface that may touch goes, from a first guess by solving on it.
    fn reach(&self) -> Result<(f64, Effort), Refusal> {
        let RoundContact { problem, couple, round, .. } = *self;
        let mut effort = Effort::default();
        let mut reach = round.guess(couple, &problem.load)?;
        for _ in 0..TRIALS {
            let touched = self.on(reach, |stage| -> Result<_, Fault> {
                let (found, length, work) = on_standing_mesh(stage, problem.level(FIRST))?;
                effort += work;
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
                let to = round.longest;
                return Err(Refusal::Reason(format!(
                    "the contact reaches {touched:.4} mm from the middle; the bodies are round and flat for {to:.4} mm"
                )));
            }
            reach = (CANDIDATE[1] * touched).min(round.longest);
        }
        Ok((reach, effort))
    }
}
