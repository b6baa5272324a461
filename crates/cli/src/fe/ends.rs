//! The contact stage of a half-disc on a rectangle: the end of contact (and of stick) is an unknown, and an element node stands on it.
//!
//! Conditions stand on the flat side: normal along z, gap `R - sqrt(R^2 - x^2)`. First the normal load is applied without friction, then
//! the shear force with Coulomb friction (Cattaneo 1938, Mindlin 1949). The formulas of Hertz give the trial ends only.

use std::time::Instant;

use contact::{
    ContactLoad, ContactOperator, ContactPoint, ContactSolution, ContactState, Friction, Motion, Pair, Start,
    Status as ContactStatus, position_nodes,
};
use hpfem::{Body, Kinematics};
use scene::{Fault, Scene};

use crate::fe::bodies::{BodyParts, Level, kinematics};
use crate::fe::contact::{Solved, climb, unsolved};
use crate::fe::diagnosis;
use crate::fe::ends_profile::Rows;
use crate::fe::half_disc::Couple;
use crate::fe::hertz_trial::hertz_end;
use crate::fe::recover::{self, Moment, Reported};
use crate::fe::stage::{Parts, note};
use crate::fe::torsion;
use crate::fe::twist::Twist;
use crate::setup::{Problem, turns};
use crate::solution::{EnergyResult, Solution, Status};
use crate::solve::{CURVE, Options};

/// Samples of the pressure for the comparison of levels, over the inner 95 % of the contact.
const SAMPLES: usize = 191;
/// Accuracy of the ends relative to the length of contact, of contact alone and with the ends of stick, whose residual is less smooth.
const TOLERANCES: [f64; 2] = [1e-10, 1e-8];
/// Kind of fault of a contact that does not fit the bodies.
const TOO_LONG: &str = "contact-too-long";

/// A scene of two such bodies.
pub(super) struct Setting<'a> {
    pub(super) scene: &'a Scene,
    pub(super) couple: &'a Couple,
    /// Coefficient of friction, and the shear force on body 1 along x.
    pub(super) friction: f64,
    pub(super) shear: f64,
}

/// Solves the contact and fills in the solution.
pub(super) fn solve(problem: &Problem, couple: &Couple, options: Options, solution: &mut Solution) -> Result<(), Fault> {
    let setting = Setting::new(&problem.scene, couple);
    let done = setting.trial().and_then(|mut nodes| {
        let (mut stick, mut sought) = (None, setting.shear != 0.0);
        let reported = climb(&problem.scene, options, solution, |level| {
            let mut work = Solution::default();
            let mut found = setting.position(level, &nodes, stick, sought, &mut work)?;
            // Where stick does not end alike on both sides no one place is its end: only the contact's own end is sought from then on.
            if found.is_none() && sought {
                sought = false;
                found = setting.position(level, &nodes, stick, sought, &mut work)?;
            }
            nodes = found.ok_or_else(|| unsettled(&nodes))?;
            let solved = setting.result(level, &nodes, sought, options, work)?;
            stick = Twist::node(solved.solution.contact.as_ref());
            Ok(solved)
        })?;
        Ok((reported, nodes))
    });
    match done {
        Ok((Some(reported), nodes)) if problem.plan.runs("field recovery") => {
            crate::solve::timed(solution, "field recovery", |solution| {
                recover::recover_ends(&setting, &reported, &nodes, solution)
            })
        }
        Ok(_) => Ok(()),
        Err(fault) if fault.code == TOO_LONG => {
            solution.status = Status::Refused;
            solution.reason = Some(fault.message);
            Ok(())
        }
        Err(fault) => Err(fault),
    }
}

/// Both load steps on the bodies of one mesh.
struct Steps {
    points: Vec<ContactPoint>,
    pressed: ContactSolution,
    sheared: Option<ContactSolution>,
}

impl<'a> Setting<'a> {
    pub(super) fn new(scene: &'a Scene, couple: &'a Couple) -> Setting<'a> {
        let contact = scene.contact.as_ref().filter(|contact| contact.shear.unwrap_or(true));
        let friction = contact.and_then(|contact| contact.friction).unwrap_or(0.0);
        let shear = scene.load.as_ref().and_then(|load| load.shear_force).map_or(0.0, |force| force.0);
        Setting { scene, couple, friction, shear }
    }

    pub(super) fn revolved(&self) -> bool {
        kinematics(self.scene).is_revolved()
    }

    /// How often the meshed part is contained in the scene.
    pub(super) fn copies(&self) -> f64 {
        if self.couple.whole || self.revolved() { 1.0 } else { 2.0 }
    }

    fn force(&self) -> f64 {
        self.scene.load.as_ref().and_then(|load| load.force).map_or(0.0, |force| force.0)
    }

    /// Trial ends between half-planes or half-spaces (Johnson 1985, sec. 4.2, 7.2): of contact, and before it of stick.
    pub(super) fn trial(&self) -> Result<Vec<f64>, Fault> {
        let materials =
            [&self.scene.body1, &self.scene.body2].map(|body| body.iter().filter_map(|b| b.material).collect::<Vec<_>>());
        let load = self.scene.load.clone().unwrap_or_default();
        let approach = load.approach.map(|a| a.0);
        let force = self.force();
        let end = hertz_end(self.couple.radius, [&materials[0], &materials[1]], &load, kinematics(self.scene));
        if end <= 0.0 || end.is_nan() {
            let message = format!("an approach of {} mm does not press body 1 on body 2", approach.unwrap_or(0.0));
            return Err(Fault::at("load.approach", "wrong-value", message, "give an approach greater than 0"));
        }
        if self.shear == 0.0 {
            return Ok(vec![end]);
        }
        let carried = self.shear.abs() / (self.friction * force);
        if approach.is_none() && carried >= 1.0 {
            let message =
                format!("the shear force {} N is more than friction carries, {} N", self.shear.abs(), self.friction * force);
            return Err(Fault::at("load.shear_force", TOO_LONG, message, "give a smaller shear force"));
        }
        let stick = (1.0 - carried.min(0.9)).sqrt();
        Ok(vec![stick * end, end])
    }

    /// Bodies with element nodes on the given ends.
    pub(super) fn parts(&self, level: Level, nodes: &[f64], work: &mut Solution) -> Result<Parts, Fault> {
        self.parts_in(level, nodes, kinematics(self.scene), work)
    }

    fn parts_in(&self, level: Level, nodes: &[f64], kinematics: Kinematics, work: &mut Solution) -> Result<Parts, Fault> {
        let start = Instant::now();
        let (end, longest) = (nodes[nodes.len() - 1], self.couple.longest());
        if nodes.len() > 1 && nodes[0] <= 0.0 {
            let message = "the zone of stick shrinks to nothing: friction hardly carries the shear force";
            return Err(Fault::at("load.shear_force", TOO_LONG, message, "give a smaller shear force"));
        }
        if end.is_nan() || end > longest || end <= 0.0 {
            let message =
                format!("the contact reaches {end:.4} mm from the middle, over the {longest:.4} mm that the bodies allow");
            return Err(Fault::at("load.force", TOO_LONG, message, "press less, or make the bodies larger"));
        }
        let [disc, block] = self.couple.meshes(nodes, level.layers.div_ceil(2))?;
        let parts = [
            BodyParts::new(self.scene, true, disc, level, kinematics)?,
            BodyParts::new(self.scene, false, block, level, kinematics)?,
        ];
        note(work, "mesh", start);
        Ok(Parts { parts, facing: true })
    }

    /// The load before any shear.
    fn press(&self) -> ContactLoad {
        let load = self.scene.load.clone().unwrap_or_default();
        let rigid = load.kind == Some(scene::LoadKind::Rigid);
        let cases = if rigid { vec![] } else { vec![self.force() / self.copies(), 0.0, 0.0, 0.0] };
        let mut press = ContactLoad::factors(&cases, &[]);
        if rigid {
            press.motions[1] = match load.approach {
                Some(approach) => Motion::Prescribed { value: -approach.0 },
                None => Motion::Free { resultant: -self.force() / self.copies() },
            };
        }
        press
    }

    /// The load with its shear, from the slip of the first step.
    fn push(&self, slip_before: &[f64]) -> ContactLoad {
        let mut push = self.press();
        push.motions[0] = Motion::Free { resultant: self.shear };
        push.friction = Friction::Coulomb { coefficient: self.friction, slip_before: slip_before.to_vec() };
        push
    }

    /// Distance from the middle, or radius, of a point.
    pub(super) fn distance(&self, point: &ContactPoint) -> f64 {
        (point.position[0] - self.couple.middle).abs()
    }

    /// States of the points between given ends of stick and contact.
    fn states(&self, points: &[ContactPoint], nodes: &[f64]) -> Vec<ContactState> {
        let slip = if self.shear > 0.0 { ContactState::Backward } else { ContactState::Forward };
        points
            .iter()
            .map(|point| match self.distance(point) / (1.0 + 1e-9) {
                x if x > nodes[nodes.len() - 1] => ContactState::Open,
                x if x > nodes[0] => slip,
                _ => ContactState::Stick,
            })
            .collect()
    }

    /// Moves element nodes onto the ends: there the pressure vanishes, and where stick is `sought`, the shear that sticking takes is just its
    /// limit. A node where the stick of a twist ended at the last level stays there; one of a stick that is not sought keeps its part of the
    /// contact. `None` where that does not settle.
    fn position(
        &self,
        level: Level,
        start: &[f64],
        stick: Option<f64>,
        sought: bool,
        work: &mut Solution,
    ) -> Result<Option<Vec<f64>>, Fault> {
        let end = start[start.len() - 1];
        let moving = if sought { start } else { &start[start.len() - 1..] };
        let part = (self.shear != 0.0 && !sought).then(|| start[0] / end);
        let tolerance = TOLERANCES[usize::from(sought)];
        let start = Start { places: moving, jacobian: None, tolerance, share: 0.0 };
        let with_stick = |moving: &[f64]| {
            let kept = part.map(|part| part * moving[0]);
            stick.into_iter().chain(kept).chain(moving.iter().copied()).collect::<Vec<f64>>()
        };
        let nodes = position_nodes(start, |moving| -> Result<_, Fault> {
            let nodes = &with_stick(moving);
            let parts = self.parts(level, nodes, work)?;
            let bodies = parts.reduce(work)?;
            let steps = self.held_steps(&bodies, nodes, sought, work)?;
            let at = |x: f64| {
                let far = |i: &usize| (steps.points[*i].position[0] - self.couple.middle - x).abs();
                (0..steps.points.len()).min_by(|i, j| far(i).total_cmp(&far(j))).unwrap_or(0)
            };
            let end = steps.pressed.pressure[at(nodes[nodes.len() - 1])];
            Ok((
                match &steps.sheared {
                    Some(sheared) => {
                        // Finite bodies shift the stick zone as a whole a little: its half length is that of both sides' mean.
                        let excess = |i: usize| sheared.shear[i].abs() - self.friction * sheared.pressure[i];
                        vec![0.5 * (excess(at(nodes[0])) + excess(at(-nodes[0]))), end]
                    }
                    None => vec![end],
                },
                (),
            ))
        })?;
        Ok(nodes.found.then(|| with_stick(&nodes.refined)))
    }

    /// Both load steps, or the first alone, with the states of all points given by the ends.
    fn held_steps(&self, bodies: &[Body<'_>; 2], nodes: &[f64], both: bool, work: &mut Solution) -> Result<Steps, Fault> {
        let start = Instant::now();
        let pair = facing(bodies)?;
        let operator = self.operator(&pair)?;
        note(work, "interface", start);
        let start = Instant::now();
        let points = operator.points().to_vec();
        let gap: Vec<f64> = points.iter().map(|p| self.couple.gap(p.position[0])).collect();
        let states = self.states(&points, nodes);
        let closed: Vec<bool> = states.iter().map(|s| *s != ContactState::Open).collect();
        let pressed = operator.solve_on(&gap, &self.press(), &closed).and_then(solvable).map_err(unsolved)?;
        let sheared = if !both {
            None
        } else {
            let load = self.push(&pressed.slip);
            Some(operator.solve_states(&gap, &load, &states).and_then(solvable).map_err(unsolved)?)
        };
        work.counters.contact_solves += 1 + usize::from(sheared.is_some());
        note(work, "contact", start);
        Ok(Steps { points, pressed, sheared })
    }

    fn operator<'p>(&self, pair: &Pair<'p>) -> Result<ContactOperator<'p>, Fault> {
        ContactOperator::new(pair, self.shear != 0.0)
            .map_err(|error| Fault::at("body1.support", "not-held", error.to_string(), "support the bodies"))
    }

    /// The contact with its conditions of sign on the positioned mesh, and everything that is reported.
    fn result(&self, level: Level, nodes: &[f64], sought: bool, options: Options, mut work: Solution) -> Result<Solved, Fault> {
        let parts = self.parts(level, nodes, &mut work)?;
        let bodies = parts.reduce(&mut work)?;
        let held = self.held_steps(&bodies, nodes, sought, &mut work)?;
        let pair = facing(&bodies)?;
        let operator = self.operator(&pair)?;
        let start = Instant::now();
        let gap: Vec<f64> = held.points.iter().map(|p| self.couple.gap(p.position[0])).collect();
        let pressed = operator.solve(&gap, &self.press(), Some(&held.pressed)).map_err(unsolved)?;
        let (found, load) = if self.shear == 0.0 {
            (pressed, self.press())
        } else {
            let push = self.push(&pressed.slip);
            (operator.solve(&gap, &push, held.sheared.as_ref()).map_err(unsolved)?, push)
        };
        let embedded = operator.embedded_difference(&gap, &load, &found).map_err(unsolved)?;
        work.interface = diagnosis::interface(&operator, &gap, &load, &found)?;
        work.counters.contact_solves += 1 + usize::from(self.shear != 0.0);
        note(&mut work, "contact", start);
        let copies = self.copies();
        let states = [Some(&found.shaped), found.counter.as_ref()];
        let energy = [0, 1].map(|body| {
            let operator = [Some(pair.shaped), pair.counter][body];
            copies * operator.zip(states[body]).map_or(0.0, |(operator, state)| operator.strain_energy(state))
        });
        work.energy = Some(EnergyResult { body1_Nmm: Some(energy[0]), body2_Nmm: Some(energy[1]) });
        work.reactions = parts.reactions(&bodies, states);
        if copies > 1.0 {
            for (_, reaction) in &mut work.reactions {
                let z = reaction.z_N.map(|z| copies * z);
                reaction.x_N = Some(0.0);
                reaction.moment_Nmm = z.map(|z| self.couple.middle * z);
                reaction.z_N = z;
            }
        }
        let turned = match turns(self.scene).is_empty() {
            true => None,
            false => Some(self.parts_in(level, nodes, Kinematics::Torsion, &mut work)?),
        };
        let turned = turned.as_ref().map(|parts| parts.reduce(&mut work)).transpose()?;
        let turned = turned.as_ref().map(facing).transpose()?;
        let twist = turned.as_ref().map(|pair| Twist::new(self.scene, pair, &found)).transpose()?.flatten();
        let rows = Rows { setting: self, pair: &pair, operator: &operator, found: &found, gap: &gap, nodes, stick_node: sought };
        let end = nodes[nodes.len() - 1];
        let pressure = (0..SAMPLES).map(|i| rows.pressure_at(0.95 * end * i as f64 / (SAMPLES - 1) as f64)).collect();
        let mut contact = rows.contact_result();
        let mut profiles = [options.sample.map_or_else(|| rows.own(), |sampling| rows.sampled(sampling)), rows.sampled(CURVE)];
        if let (Some(twist), Some(pair)) = (&twist, &turned) {
            twist.report(&mut contact, 0.0);
            for profile in &mut profiles {
                twist.fill(&operator, profile, 0.0);
                let at: Vec<ContactPoint> = profile.s.iter().map(|s| pair.at_arc(*s)).collect();
                torsion::write(pair, &twist.last.shear, &at, profile);
            }
        }
        work.contact = Some(contact);
        let [profile, curve] = profiles;
        (work.profile, work.curve) = (Some(profile), Some(curve));
        let solved = found.status.is_solved() && found.status != ContactStatus::NoContact;
        let refused = (!solved).then(|| found.status.to_string());
        let refused = refused.or_else(|| twist.as_ref().and_then(|twist| twist.refused.clone()));
        let reported = found.counter.clone().map(|counter| {
            let states = [found.shaped.clone(), counter];
            Reported { level, ends: Vec::new(), moments: vec![Moment { time_s: 0.0, name: "", states, around: Vec::new() }] }
        });
        let twist = twist.map(|twist| twist.answer);
        Ok(Solved {
            energy: energy[0] + energy[1],
            pressure,
            twist,
            embedded,
            unsettled: false,
            refused,
            reported,
            solution: work,
        })
    }
}

/// The end of contact runs away from its trial place.
fn unsettled(nodes: &[f64]) -> Fault {
    let message = format!("no end of contact settles near {:.4} mm from the middle", nodes[nodes.len() - 1]);
    Fault::at("load.force", TOO_LONG, message, "press less, or make the bodies larger")
}

/// Pairs the two bodies of a level across their gap.
fn facing<'b>(bodies: &'b [Body<'_>; 2]) -> Result<Pair<'b>, Fault> {
    Pair::facing(&bodies[0].interface, &bodies[1].interface).map_err(unsolved)
}

fn solvable(solution: Option<ContactSolution>) -> Result<ContactSolution, contact::Error> {
    solution.ok_or(contact::Error::Singular)
}
