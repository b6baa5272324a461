//! Which of the three kinds of contact two bodies have: a surface known beforehand, a round body on a flat one, a half-disc on a rectangle.

use hpfem::{Mesh, Sizes};
use meshing::{Cut, HalfDiscOnFlat};
use scene::Fault;

use crate::bodies::Bodies;
use crate::effort::Effort;
use crate::faults::in_names_of;
use crate::ladder::{LEAST, Refusal, levels};
use crate::level::Level;
use crate::options::Options;
use crate::parts::Parts;
use crate::path_profile::Inside;
use crate::problem::Problem;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::Outcome;
use crate::steps::ends_setting::Setting;
use crate::steps::round::{Round, RoundContact};
use crate::steps::wear::RoundWear;
use crate::steps::{ends, ends_scope, paths, pressure, recover};
use crate::watch::Watch;

/// A contact, ready to be solved.
pub(crate) enum Scope<'a> {
    /// On a surface known without a mesh.
    Known(Stage<'a>),
    /// A round body on a flat one of which at least one is given by its cells.
    Round(RoundContact<'a>),
    /// A half-disc on a rectangle.
    HalfDisc(Setting<'a>),
    /// The same that wears in time.
    RoundWear(RoundWear<'a>),
}

impl<'a> Scope<'a> {
    /// The contact of a problem.
    pub(crate) fn of(problem: &'a Problem, options: &'a Options<'a>, bodies: &'a Bodies) -> Result<Scope<'a>, Fault> {
        let Some(couple) = &problem.couple else { return Stage::new(problem, options, bodies).map(Scope::Known) };
        if let Some(disc) = HalfDiscOnFlat::of(couple)? {
            if problem.plan.runs(Step::Evolution) {
                return Ok(Scope::RoundWear(RoundWear { problem, couple, disc, options, bodies }));
            }
            return Ok(Scope::HalfDisc(Setting::new(problem, couple, disc, options)));
        }
        match Round::of(couple)? {
            Some(round) => Ok(Scope::Round(RoundContact { problem, couple, round, options, bodies })),
            None => Stage::new(problem, options, bodies).map(Scope::Known),
        }
    }

    /// Refuses what is not built yet.
    pub(crate) fn available(&self) -> Result<(), Fault> {
        match self {
            Scope::HalfDisc(setting) => ends_scope::available(setting),
            Scope::Round(round) => round.available(),
            Scope::RoundWear(round) => round.available(),
            Scope::Known(_) => Ok(()),
        }
    }

    /// Refuses bodies that cannot be meshed, held or loaded on the levels that every solve of a problem climbs.
    fn sound(&self, problem: &Problem, options: &Options<'_>) -> Result<(), Fault> {
        let mirror = match self {
            Scope::HalfDisc(setting) => setting.mirror(),
            Scope::Round(_) | Scope::RoundWear(_) | Scope::Known(_) => None,
        };
        let sized = |parts: &Parts| parts.sizes().and_then(|_| paths::check(problem, parts, mirror));
        let step = if problem.plan.runs(Step::Contact) { Step::Contact } else { Step::Shape };
        let levels = levels(problem, options, step);
        let Some(level) = levels.iter().take(LEAST).next_back().copied() else { return Ok(()) };
        match self {
            // A contact too long for the bodies is an answer.
            Scope::HalfDisc(setting) => match setting.trial().and_then(|trial| setting.parts(level, &trial)) {
                Ok((parts, _)) => sized(&parts),
                Err(Refusal::Fault(fault)) => Err(fault),
                Err(Refusal::Reason(_) | Refusal::TooCoarse(_)) => Ok(()),
            },
            Scope::Round(_) | Scope::RoundWear(_) => sized(&self.parts(level)?),
            Scope::Known(stage) => {
                self.sizes(level)?;
                if !problem.paths.is_empty() {
                    paths::check(problem, &self.parts(level)?, mirror)?;
                }
                if problem.plan.runs(Step::RoundTrip) { stage.meshes(level.layers, Cut::Shifted).map(|_| ()) } else { Ok(()) }
            }
        }
    }

    /// Meshes, supports and loads of a level, on first guesses of the ends of a round contact.
    pub(crate) fn parts(&self, level: Level) -> Result<Parts, Fault> {
        match self {
            Scope::Known(stage) => Ok(stage.parts(level, Cut::Plain)?.0),
            Scope::Round(round) => round.first_parts(level),
            Scope::RoundWear(round) => round.first_parts(level),
            Scope::HalfDisc(setting) => {
                let parts = setting.trial().and_then(|trial| setting.parts(level, &trial));
                parts.map(|(parts, _)| parts).map_err(|refusal| match refusal {
                    Refusal::Fault(fault) => fault,
                    Refusal::Reason(reason) | Refusal::TooCoarse(reason) => {
                        Fault::at("load.force", "contact-too-long", reason, "press less")
                    }
                })
            }
        }
    }

    /// Sizes of both bodies on a level, which are kept where no load changes them.
    pub(crate) fn sizes(&self, level: Level) -> Result<[Sizes; 2], Fault> {
        let find = || self.parts(level)?.sizes();
        match self {
            Scope::Known(stage) if !stage.facing() => stage.bodies.sizes(stage.couple, level, find),
            Scope::Known(_) | Scope::Round(_) | Scope::HalfDisc(_) | Scope::RoundWear(_) => find(),
        }
    }

    /// Solves a contact that is not on a known surface, with the fields if they are asked for; `None` for one that is.
    pub(crate) fn solve(&self, watch: &mut Watch<'_>) -> Result<Option<(Outcome, Effort, Inside)>, Refusal> {
        let setting = match self {
            Scope::Known(_) => return Ok(None),
            Scope::Round(round) => return round.solve(watch).map(Some),
            Scope::RoundWear(round) => return round.solve(watch).map(Some),
            Scope::HalfDisc(setting) => setting,
        };
        let (outcome, mut effort, nodes) = ends::solve(setting, watch)?;
        let reported = outcome.reported.as_ref().filter(|_| setting.problem.plan.runs(Step::Fields));
        let Some(reported) = reported else { return Ok(Some((outcome, effort, Inside::default()))) };
        let clock = setting.options.clock;
        (setting.options.begun)(Step::Fields);
        let (fields, work) = effort.timed(Step::Fields, clock, |_| recover::recover_ends(setting, reported, &nodes))?;
        effort += work;
        Ok(Some((outcome, effort, fields)))
    }
}

impl Problem {
    /// Refuses what is not built yet, and bodies that cannot be meshed, held or loaded: what [`solve`](crate::solve()) would refuse on its way
    /// to its first estimate of the error, so that nothing need be written for it.
    ///
    /// # Errors
    /// What is to be mended, with what to write instead.
    pub fn available(&self) -> Result<(), Fault> {
        self.available_on(&Bodies::default())
    }

    /// Why [`solve`](crate::solve()) ends without an answer, where the pressure shows it without a mesh and within a millisecond: along a line whatever
    /// keeps it from having an optimal pressure; on an area that no pressure, or none up to `optimum.p_max`, carries the load. Most of what has no answer
    /// shows that only when it is solved.
    pub fn unanswered(&self) -> Option<String> {
        pressure::unanswered(self)
    }

    /// [`Problem::available`] that leaves the meshes it made to a solve on the same `bodies`: cells that are given take long to match.
    ///
    /// # Errors
    /// Those of [`Problem::available`].
    pub fn available_on(&self, bodies: &Bodies) -> Result<(), Fault> {
        if self.plan.runs(Step::Pressure) {
            pressure::wear_problem(self)?;
        }
        if !self.plan.runs(Step::Mesh) {
            return Ok(());
        }
        let options = Options::default();
        let sound = || {
            let scope = Scope::of(self, &options, bodies)?;
            scope.available()?;
            scope.sound(self, &options)
        };
        sound().map_err(|fault| in_names_of(self.couple.as_ref(), fault))
    }

    /// The meshes of both bodies at the fixed discretisation, or with the layers of degree 8.
    ///
    /// # Errors
    /// Where there are no bodies on a known surface, or they cannot be meshed.
    pub fn meshes(&self) -> Result<[Mesh; 2], Fault> {
        let (options, bodies) = (Options::default(), Bodies::default());
        let layers = self.wanted.fixed.map_or(8, |level| level.layers);
        Stage::new(self, &options, &bodies)?.meshes(layers, Cut::Plain)
    }
}
