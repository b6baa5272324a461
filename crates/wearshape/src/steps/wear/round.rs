//! A ball or cylinder on a flat that wears in time: the end of contact moves outwards, over a surface that may touch as far as it will come.

use hpfem::Kinematics;
use meshing::{CANDIDATE as LONGEST, Couple, Cut, Extent, HalfDiscOnFlat};
use scene::Fault;
use wear::Shape;

use crate::bodies::Bodies;
use crate::effort::Effort;
use crate::faults::wrong_wear;
use crate::ladder::{Ladder, Refusal};
use crate::level::Level;
use crate::options::Options;
use crate::parts::Parts;
use crate::path_profile::Inside;
use crate::problem::{End, Problem};
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::Outcome;
use crate::steps::hertz_trial::hertz_end;
use crate::steps::recover;
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::rigid_scar::RigidScar;
use crate::steps::wear::rough::{self, FOUND, TRIALS};
use crate::steps::wear::round_mesh::{CANDIDATE, along, breaks};
use crate::steps::wear::{solve_at, track};
use crate::surface::Patch;
use crate::watch::Watch;

/// Half a scar over the radius of its track, and the whole one over its stroke, beyond which the speed is no longer one.
const NEAR: f64 = 0.2;

/// A ball or cylinder on a flat, and how long it wears.
#[derive(Clone)]
pub(crate) struct RoundWear<'a> {
    pub problem: &'a Problem,
    pub couple: &'a Couple,
    pub disc: HalfDiscOnFlat,
    pub options: &'a Options<'a>,
    pub bodies: &'a Bodies,
}

/// Makes a refusal of a key, a message and a remedy.
type Refuse<'a> = dyn Fn(&str, &str, &str) -> Result<(), Fault> + 'a;

impl<'a> RoundWear<'a> {
    /// Refuses what is not built, before anything is written.
    pub(crate) fn available(&self) -> Result<(), Fault> {
        let problem = self.problem;
        let refuse = |key: &str, message: &str, remedy: &str| Err(Fault::at(key, "not-available", message, remedy));
        if [Step::Pressure, Step::Contact, Step::Shape].iter().any(|step| problem.plan.runs(*step)) {
            let message =
                "a round contact that wears has the task wear alone: the pressure of its start is the first of its curves";
            return refuse("tasks", message, "write tasks = [\"wear\"]");
        }
        if problem.wear.until.is_none() {
            let message = "a ball or cylinder is worn for ever: its scar grows, and no pressure is steady";
            return refuse("wear.until", message, "give a time, as in wear.until = \"10 h\"");
        }
        let cycle = problem.sliding.as_ref().is_some_and(|sliding| sliding.cycle.is_some());
        if problem.reversing.is_some() || (cycle && problem.friction.shear() > 0.0) {
            let message = "the reversals of a round contact are not averaged: its friction bends the pressure to one side";
            if problem.friction.shear() == 0.0 {
                let message = "without shear on the bodies a round contact wears alike in both senses";
                return refuse("sliding.reversing", message, "leave `sliding.reversing` out");
            }
            let key = if cycle { "sliding.cycle" } else { "sliding.reversing" };
            let remedy =
                "write contact.shear = false, which takes the friction off the bodies, and leave `sliding.reversing` out";
            return refuse(key, message, remedy);
        }
        if !problem.pieces.is_empty() {
            return refuse("schedule", "a round contact wears under one load and speed so far", "leave out `schedule`");
        }
        if problem.load.force.is_none() {
            return refuse("load.approach", "a round contact wears under a force so far", "give load.force instead");
        }
        if problem.load.shear_force != 0.0 {
            return refuse(
                "load.shear_force",
                "a body that slides neither sticks nor carries another shear force",
                "leave it out",
            );
        }
        if !problem.gap.is_none() {
            return refuse("contact.gap", "a profile on a half-disc is not known yet", "write gap = 0");
        }
        if self.couple.is_revolved() && problem.friction.shear() > 0.0 {
            let message = "the shear of a ball that slides has no symmetry about its axis";
            return refuse(
                "contact.shear",
                message,
                "write contact.shear = false, which takes it off the bodies and keeps it in power and wear",
            );
        }
        track::available(problem, self.couple, &refuse)?;
        let end = self.guess()?;
        self.fits(end)?;
        self.fits_track(end, &refuse)?;
        self.on(&self.nodes(end), |stage, ends| stage.meshes(1, Cut::Ends(ends)).map(|_| ()))
    }

    /// Refuses a scar that is not short against its track or its stroke.
    fn fits_track(&self, end: f64, refuse: &Refuse<'_>) -> Result<(), Fault> {
        if let Some(stroke) = self.problem.stroke() {
            if end > 0.5 * NEAR * stroke {
                let message =
                    format!("the scar would reach {end:.4} mm from the middle, and the stroke is {stroke} mm from end to end");
                return refuse(
                    "sliding.cycle.stroke",
                    &message,
                    "give a stroke much longer than the scar, or end the run earlier",
                );
            }
        } else if let Some(track) = self.problem.track().filter(|track| end > NEAR * track) {
            let message = format!(
                "the scar would reach {end:.4} mm from the middle, and the track is a circle of {track:.4} mm about the axis"
            );
            return refuse("sliding.track_radius", &message, "give a track much longer than the scar, or end the run earlier");
        }
        Ok(())
    }

    /// Refuses a scar longer than the bodies.
    fn fits(&self, end: f64) -> Result<(), Fault> {
        let longest = LONGEST / CANDIDATE * self.disc.longest();
        if end <= longest {
            return Ok(());
        }
        let message = format!("the scar would reach {end:.4} mm from the middle, over the {longest:.4} mm that the bodies allow");
        Err(Fault::at("wear.until", "contact-too-long", message, "end the run earlier, press less, or give larger bodies"))
    }

    /// Sliding speed (mm/s); on a revolving disc that of its track.
    fn speed(&self) -> Result<f64, Fault> {
        let example = "write sliding = { speed = \"100 mm/s\" }";
        let Some(sliding) = &self.problem.sliding else {
            return Err(Fault::at("sliding", "missing", "wear needs sliding".to_string(), example));
        };
        let (key, speed) = match (sliding.speed, sliding.omega, sliding.track_radius) {
            (Some(speed), None, _) => ("sliding.speed", speed.0),
            (None, Some(omega), Some(track)) => ("sliding.omega", omega.0 * track.0),
            (None, _, _) => {
                let message =
                    "a ball or cylinder slides along a flat at one speed: `sliding.omega` alone does not say it".to_string();
                let remedy = "write sliding = { speed = \"100 mm/s\" }, or omega with the track_radius of a ball on a disc";
                return Err(Fault::at("sliding.omega", "wrong-key", message, remedy));
            }
            (Some(_), Some(_), _) => {
                let message = "both `sliding.speed` and `sliding.omega` are given".to_string();
                return Err(Fault::at("sliding.omega", "two-alternatives", message, "keep one of them"));
            }
        };
        if speed == 0.0 || !speed.is_finite() {
            let message = format!("{key} = {speed}: nothing slides");
            return Err(Fault::at(key, "wrong-value", message, example));
        }
        Ok(speed)
    }

    /// Half the width of contact at the start.
    fn start(&self) -> f64 {
        hertz_end(self.disc.radius, self.couple, &self.problem.load)
    }

    /// A first guess of the end of contact after the run.
    fn guess(&self) -> Result<f64, Fault> {
        let Problem { wear, load, .. } = self.problem;
        let laws = wear.laws.as_ref().map_err(wrong_wear)?;
        let rigid = RigidScar {
            radius: self.disc.radius,
            kinematics: self.couple.kinematics,
            force: load.force.unwrap_or(0.0),
            speed: self.speed()?.abs(),
            laws,
            counterface: wear.counterface,
        };
        Ok(rigid.at(wear.until.unwrap_or(End::Time(0.0)), self.start()))
    }

    fn nodes(&self, end: f64) -> Vec<f64> {
        let wear = &self.problem.wear;
        breaks(self.start(), end, wear.exponents == [1.0] && !wear.own_rule)
    }

    /// Does something with the stage of a surface cut at these distances (mm) from the middle, and with its cuts from -1 to 1.
    fn on<T, E: From<Fault>>(&self, nodes: &[f64], act: impl FnOnce(Stage<'_>, &[f64]) -> Result<T, E>) -> Result<T, E> {
        let RoundWear { problem, couple, disc, options, bodies } = self;
        let end = nodes[nodes.len() - 1];
        self.fits(end)?;
        let reach = CANDIDATE * end;
        let from = if couple.is_revolved() { disc.middle } else { disc.middle - reach };
        let extent = Extent::Round { x: [from, disc.middle + reach], touch: disc.middle, radius: disc.radius };
        let patch = self.patch(extent.ends())?;
        let stage = Stage { problem, couple, patch: &patch, extent, options, bodies };
        act(stage, &along(stage, nodes, reach))
    }

    /// The flat side, which slides along x at one speed.
    fn patch(&self, x: [f64; 2]) -> Result<Patch, Fault> {
        let shape = match self.couple.kinematics {
            Kinematics::PlaneStress { thickness } | Kinematics::PlaneStrain { thickness } => {
                Shape::Strip { x, z: self.disc.height, thickness }
            }
            Kinematics::Axisymmetric | Kinematics::Torsion | Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => {
                Shape::Annulus { radii: x }
            }
        };
        Patch::along_x(shape, self.speed()?)
    }

    /// Parts of a level on the first guess, for a forecast.
    pub(crate) fn first_parts(&self, level: Level) -> Result<Parts, Fault> {
        self.on(&self.nodes(self.guess()?), |stage, ends| Ok(stage.parts(level, Cut::Ends(ends))?.0))
    }

    /// Runs the wear in time, with the fields if they are asked for.
    pub(crate) fn solve(&self, watch: &mut Watch<'_>) -> Result<(Outcome, Effort, Inside), Refusal> {
        let (end, mut effort) = self.end()?;
        self.on(&self.nodes(end), |stage, ends| {
            let ladder = Ladder::of(stage.problem, stage.options, Step::Evolution);
            let (mut outcome, work) = solve_at(stage, &Pieces::of(stage.problem), (&ladder, ends), watch)?;
            effort += work;
            let reported = outcome.reported.take().filter(|_| stage.problem.plan.runs(Step::Fields) && !outcome.stopped);
            let Some(reported) = reported else { return Ok((outcome, effort, Inside::default())) };
            (stage.options.begun)(Step::Fields);
            let (fields, work) = effort.timed(Step::Fields, stage.clock(), |_| recover::recover(stage, &reported))?;
            effort += work;
            Ok((outcome, effort, fields))
        })
    }

    /// Where the contact ends after the run, from the first guess by running on it.
    fn end(&self) -> Result<(f64, Effort), Refusal> {
        let mut effort = Effort::default();
        let mut end = self.guess()?;
        for _ in 0..TRIALS {
            let found = self.on(&self.nodes(end), |stage, ends| trial(stage, ends, &mut effort))?;
            let change = (found / end - 1.0).abs();
            end = found;
            if change <= FOUND * self.problem.wanted.accuracy {
                break;
            }
        }
        Ok((end, effort))
    }
}

/// Half the width of the contact at the end of a rough run.
fn trial(stage: Stage<'_>, ends: &[f64], effort: &mut Effort) -> Result<f64, Refusal> {
    let [from, to] = rough::run(stage, &Pieces::of(stage.problem), ends, effort)?.end;
    Ok(if stage.couple.is_revolved() { to } else { 0.5 * (to - from) })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use scene::{Document, builtin};
    use shapeopt::{Evolution, EvolutionStatus, Scheme, WearProblem};

    use super::*;
    use crate::steps::wear::problem::{Loads, wear_problem};
    use crate::steps::wear::ran::MOST_STEPS;
    use crate::steps::wear::rough::FIRST;

    /// On the same operators explicit steps below their stability bound come to the same gap as implicit ones.
    #[test]
    fn an_explicit_run_below_its_bound_agrees() {
        let set = ["tasks=[wear]", "sliding.speed=10", "wear.k=1e-7", "wear.until=5", "accuracy=1e-4"].map(String::from);
        let document = Document::read("scene", builtin("hertz-sphere").unwrap().text, &set).unwrap();
        let problem = Problem::new(&document, &|_| Err("no file".into())).unwrap();
        let (options, bodies) = (Options::default(), Bodies::default());
        let couple = problem.couple.as_ref().unwrap();
        let disc = HalfDiscOnFlat::of(couple).unwrap().unwrap();
        let round = RoundWear { problem: &problem, couple, disc, options: &options, bodies: &bodies };
        let end = round.guess().unwrap();
        assert!(end > 1.1 * round.start(), "the end of contact moves: {end}");
        let found = round.on(&round.nodes(end), |stage, ends| -> Result<(), Refusal> {
            let (reduced, _) = stage.made(problem.level(FIRST), Cut::Ends(ends))?;
            let pair = reduced.pair()?;
            let operator = reduced.operator(&pair, false)?;
            let load = stage.contact_load(operator.points());
            let implicit =
                wear_problem(Loads { stages: &[stage], loads: &[load], begun: None }, &Pieces::of(&problem), &operator, 0.0)?;
            let explicit = WearProblem { scheme: Scheme::Explicit, ..implicit.clone() };
            let [implicit, explicit] = [&implicit, &explicit].map(|problem| {
                let mut evolution = Evolution::new(problem).unwrap();
                evolution.by_ref().take(MOST_STEPS).for_each(drop);
                assert_eq!(*evolution.status(), EvolutionStatus::TimeReached);
                evolution.state().clone()
            });
            assert!((implicit.depth / explicit.depth - 1.0).abs() < 2e-3, "{} {}", implicit.depth, explicit.depth);
            let apart = implicit.worn.iter().zip(&explicit.worn).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // Euler's steps are of first order: they are off by no more than one of them.
            assert!(apart < implicit.depth / explicit.step as f64, "{apart} of {}", implicit.depth);
            Ok(())
        });
        assert!(found.is_ok());
    }
}
