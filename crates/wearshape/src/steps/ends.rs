//! The contact stage of a half-disc on a rectangle: the end of contact (and of stick) is an unknown, and an element node stands on it.
//!
//! Conditions stand on the flat side: normal along z, gap `R - sqrt(R^2 - x^2)`. First the normal load is applied without friction, then
//! the shear force with Coulomb friction (Cattaneo 1938, Mindlin 1949). The formulas of Hertz give the trial ends only.

use std::sync::Arc;

use contact::{
    ContactLoad, ContactOperator, ContactPoint, ContactSolution, ContactState, FreeEnds, Friction, HeldContact, Motion, Pair,
    Status as ContactStatus, UnitResponses,
};
use hpfem::{Body, InterfaceState};
use scene::Fault;

use crate::bodies;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::ladder::{Ladder, Refusal};
use crate::level::Level;
use crate::options::CURVE;
use crate::parts::Parts;
use crate::results::{EnergyResult, Reaction};
use crate::step::Step;
use crate::steps::answer::{Outcome, Told};
use crate::steps::contact_levels::{Aside, Solved, imbalance, levels};
use crate::steps::ends_profile::{Rows, shift};
use crate::steps::ends_setting::Setting;
use crate::steps::free_ends::{misplaced, node_tolerance};
use crate::steps::reported::{Moment, Reported};
use crate::steps::twist::Twist;
use crate::steps::{diagnosis, torsion};
use crate::watch::Watch;

/// Samples of the pressure for the comparison of levels, over the inner 95 % of the contact.
const SAMPLES: usize = 191;
/// The largest shift of the zone of stick as a whole, over the half length of the contact, with which one place is told as its end on both sides.
const MOST_SHIFT: f64 = 3e-3;
/// Share of the longest contact over which places are counted, so that no place that can be meshed is near 1.
const ROOM: f64 = 0.1;

/// Solves the contact; the nodes on the ends of the reported level are left for the fields.
pub(crate) fn solve(setting: &Setting<'_>, watch: &mut Watch<'_>) -> Result<(Outcome, Effort, Vec<f64>), Refusal> {
    let mut trial = Trial::new(setting, setting.trial()?, setting.shear != 0.0);
    let ladder = Ladder::of(setting.problem, setting.options, Step::Contact).and_beyond(setting.problem);
    let (outcome, effort, reported) = levels(&ladder, watch, &mut |level, expected| {
        let mut work = Effort::default();
        trial.within = node_tolerance(setting.problem.wanted.accuracy, expected);
        let mut found = setting.position(level, &trial, &mut work)?;
        // Where stick does not end alike on both sides no one place is its end: only the contact's own end is sought from then on.
        if found.is_none() && trial.sought {
            let nodes = std::mem::take(&mut trial.nodes);
            trial =
                Trial { sticks: std::mem::take(&mut trial.sticks), within: trial.within, ..Trial::new(setting, nodes, false) };
            found = setting.position(level, &trial, &mut work)?;
        }
        let (ends, positioned) = found.ok_or_else(|| unsettled(&trial.nodes))?;
        (trial.nodes, trial.ends) = (positioned.nodes.clone(), ends);
        let solved = setting.result(level, &trial, positioned, work)?;
        trial.sticks = solved.twist.as_ref().map_or_else(Vec::new, |twist| twist.nodes(&solved.contact.ends));
        trial.shift = 0.5 * solved.contact.stick_ends.iter().sum::<f64>();
        Ok((solved, Aside { nodes: trial.nodes.clone(), diagnosis: None }))
    })?;
    Ok((outcome, effort, reported.unwrap_or_default().nodes))
}

/// Where the ends are looked for.
struct Trial {
    /// The nodes of the last mesh, from the middle: of stick where there is a shear force, then of contact.
    nodes: Vec<f64>,
    /// Those that are moved, as shares of the surface.
    ends: FreeEnds,
    /// Where the stick of a twist ended at the last level, after all its steps.
    sticks: Vec<f64>,
    /// How far the zone of stick was shifted as a whole at the last level (mm).
    shift: f64,
    /// Whether the end of stick is looked for too.
    sought: bool,
    /// Accuracy to which the ends are wanted, over their largest distance.
    within: f64,
    /// End of stick over that of contact, where only the latter is moved.
    part: Option<f64>,
}

impl Trial {
    /// A search that starts from trial nodes.
    fn new(setting: &Setting<'_>, nodes: Vec<f64>, sought: bool) -> Trial {
        let end = nodes[nodes.len() - 1];
        let moving = if sought { &nodes[..] } else { &nodes[nodes.len() - 1..] };
        let ends = FreeEnds::near(moving.iter().map(|x| x / setting.room()).collect());
        let part = (setting.shear != 0.0 && !sought).then(|| nodes[0] / end);
        Trial { nodes, ends, sticks: Vec::new(), shift: 0.0, sought, within: 0.0, part }
    }

    /// All nodes, given the places of those that are moved: nodes where the stick of a twist ended at the last level stay there; one of a stick that
    /// is not sought keeps its part of the contact.
    fn nodes_at(&self, moving: &[f64]) -> Vec<f64> {
        let kept = self.part.map(|part| part * moving[0]);
        self.sticks.iter().copied().chain(kept).chain(moving.iter().copied()).collect()
    }
}

/// Bodies with nodes on the ends, and the load steps on them with the points between the ends held in contact.
struct Positioned {
    nodes: Vec<f64>,
    parts: Parts,
    bodies: [Body; 2],
    held: Steps,
}

/// Both load steps on the bodies of one mesh.
struct Steps {
    unit: Arc<UnitResponses>,
    points: Vec<ContactPoint>,
    pressed: ContactSolution,
    sheared: Option<ContactSolution>,
}

impl Setting<'_> {
    /// The load before any shear.
    fn press(&self) -> ContactLoad {
        let rigid = self.couple.has_rigid_edge();
        let cases = if rigid { vec![] } else { vec![self.force() / self.copies(), 0.0, 0.0, 0.0] };
        let mut press = ContactLoad::factors(&cases, &[]);
        if rigid {
            press.motions[1] = match self.problem.load.approach {
                Some(approach) => Motion::Prescribed { value: -approach },
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

    /// States of the points between given ends of stick, shifted as a whole, and of contact. The nodes on the ends are the points nearest to them, and the
    /// others stand before or after them in order: distances do not tell points apart that lie closer than round-off of the lengths.
    fn states(&self, points: &[ContactPoint], nodes: &[f64], shift: f64) -> Vec<ContactState> {
        let slip = if self.shear > 0.0 { ContactState::Backward } else { ContactState::Forward };
        let within = |node: f64, shift: f64| {
            let [one, other] = [-node, node].map(|x| self.nearest(points, x + shift));
            one.min(other)..=one.max(other)
        };
        let (stick, contact) = (within(nodes[0], shift), within(nodes[nodes.len() - 1], 0.0));
        (0..points.len())
            .map(|i| match (stick.contains(&i), contact.contains(&i)) {
                (true, _) => ContactState::Stick,
                (false, true) => slip,
                (false, false) => ContactState::Open,
            })
            .collect()
    }

    /// The point nearest to a place, from the middle.
    fn nearest(&self, points: &[ContactPoint], x: f64) -> usize {
        let far = |i: &usize| (points[*i].position[0] - self.disc.middle - x).abs();
        (0..points.len()).min_by(|i, j| far(i).total_cmp(&far(j))).unwrap_or(0)
    }

    /// The length of which places are shares.
    fn room(&self) -> f64 {
        self.disc.longest() / ROOM
    }

    /// Moves element nodes onto the ends: there the pressure vanishes, and where stick is sought, the shear that sticking takes is just its
    /// limit. `None` where that does not settle.
    fn position(&self, level: Level, trial: &Trial, work: &mut Effort) -> Result<Option<(FreeEnds, Positioned)>, Refusal> {
        let found = trial.ends.position(trial.within, |places| -> Result<_, Refusal> {
            let moving: Vec<f64> = places.iter().map(|t| t * self.room()).collect();
            let nodes = trial.nodes_at(&moving);
            let (parts, effort) = self.parts(level, &nodes)?;
            (self.options.begun)(Step::Factor);
            let (bodies, reduced) = parts.reduce(self.options.clock)?;
            *work += effort;
            *work += reduced;
            let held = self.held_steps(&bodies, &nodes, trial.sought, work)?;
            let residuals = self.residuals(&held, &nodes);
            Ok(Some((residuals, Positioned { nodes, parts, bodies, held })))
        })?;
        Ok(found.filter(|(ends, positioned)| !trial.sought || self.shift(ends, positioned) <= MOST_SHIFT))
    }

    /// How far the zone of stick is shifted as a whole, over the half length of the contact: half the difference of what both its ends are off by, over what
    /// their mean changes with their place.
    fn shift(&self, ends: &FreeEnds, at: &Positioned) -> f64 {
        let [right, left] = self.excess(&at.held, &at.nodes);
        let slope = ends.slope(0).unwrap_or(f64::INFINITY) / self.room();
        (0.5 * (right - left) / slope / at.nodes[at.nodes.len() - 1]).abs()
    }

    /// What the nodes on the ends are off by: the shear beyond its limit where stick ends, if that is sought, and the pressure where contact ends. The
    /// root of a node's share of the surface takes away how they grow with the level.
    fn residuals(&self, held: &Steps, nodes: &[f64]) -> Vec<f64> {
        let at = |x: f64| self.nearest(&held.points, x);
        let root = |i: usize| held.points[i].weight.sqrt();
        let end = at(nodes[nodes.len() - 1]);
        let end = held.pressed.pressure[end] * root(end);
        // Finite bodies shift the stick zone as a whole a little: its half length is that of both sides' mean.
        let of_stick = held.sheared.is_some().then(|| 0.5 * self.excess(held, nodes).iter().sum::<f64>());
        of_stick.into_iter().chain([end]).collect()
    }

    /// The shear beyond its limit where stick ends, on the right and on the left, in the scale of the residuals.
    fn excess(&self, held: &Steps, nodes: &[f64]) -> [f64; 2] {
        let Some(sheared) = &held.sheared else { return [0.0; 2] };
        let along = held.points.iter().zip(&sheared.shear).map(|(point, q)| point.weight * q).sum::<f64>().signum();
        [nodes[0], -nodes[0]].map(|x| {
            let i = self.nearest(&held.points, x);
            (along * sheared.shear[i] - self.friction * sheared.pressure[i]) * held.points[i].weight.sqrt()
        })
    }

    /// Both load steps, or the first alone, with the states of all points given by the ends.
    fn held_steps(&self, bodies: &[Body; 2], nodes: &[f64], both: bool, work: &mut Effort) -> Result<Steps, Fault> {
        let clock = self.options.clock;
        let pair = facing(bodies)?;
        let points = pair.points();
        let states = self.states(&points, nodes, 0.0);
        let closed: Vec<bool> = states.iter().map(|s| *s != ContactState::Open).collect();
        let operator = work.timed(Step::Interface, clock, |_| self.operator(&pair, &closed))?;
        let start = clock();
        let gap: Vec<f64> = points.iter().map(|p| self.disc.gap(p.position[0])).collect();
        let held = operator.held_on(&closed);
        let pressed = held.solve(&gap, &self.press()).and_then(solvable).map_err(unsolved)?;
        let sheared = if !both {
            None
        } else {
            let load = self.push(&pressed.slip);
            Some(held.solve_states(&gap, &load, &states).and_then(solvable).map_err(unsolved)?)
        };
        work.counters.contact_solves += 1 + usize::from(sheared.is_some());
        work.add_seconds(Step::Contact, clock() - start);
        Ok(Steps { unit: operator.unit_responses(), points, pressed, sheared })
    }

    fn operator<'p>(&self, pair: &Pair<'p>, closed: &[bool]) -> Result<ContactOperator<'p>, Fault> {
        ContactOperator::near(pair, self.shear != 0.0, closed)
            .map_err(|error| Fault::at("body1.support", "not-held", error.to_string(), "support the bodies"))
    }

    /// The contact with its conditions of sign on the positioned mesh, and everything that is reported.
    fn result(&self, level: Level, trial: &Trial, positioned: Positioned, mut effort: Effort) -> Result<Solved, Refusal> {
        let Positioned { nodes, parts, bodies, held } = positioned;
        let pair = facing(&bodies)?;
        let operator = ContactOperator::with(&pair, Arc::clone(&held.unit));
        let gap: Vec<f64> = held.points.iter().map(|p| self.disc.gap(p.position[0])).collect();
        (self.options.begun)(Step::Contact);
        let start = (self.options.clock)();
        let mut on = operator.held_on(&held.pressed.closed);
        let (found, load) = self.solved(&mut on, &gap, (&held, &self.states(&held.points, &nodes, trial.shift)))?;
        let embedded = self.embedded(&operator, &gap, &load, &found)?;
        let interface = diagnosis::condition(on.singular_values(&gap, &load, &found).map_err(unsolved)?);
        effort.counters.contact_solves += 1 + usize::from(self.shear != 0.0);
        effort.add_seconds(Step::Contact, (self.options.clock)() - start);
        let refined: Vec<f64> = trial.ends.refined().iter().map(|t| t * self.room()).collect();
        let refined = trial.nodes_at(&refined);
        let (setting, pair, operator, found, gap) = (self, &pair, &operator, &found, &gap[..]);
        let (stick_node, shift) = (trial.sought, shift(setting, operator, found));
        let rows = Rows { setting, pair, operator, found, gap, nodes: &nodes, ends: &refined, stick_node, shift };
        let end = refined[refined.len() - 1];
        let pressure = (0..SAMPLES).map(|i| rows.pressure_at(0.95 * end * i as f64 / (SAMPLES - 1) as f64)).collect();
        let profile = self.options.sample.map_or_else(|| rows.own(), |sampling| rows.sampled(sampling));
        let states = [Some(&found.shaped), found.counter.as_ref()];
        let told = Told {
            brake: None,
            energy: self.energy(pair, states),
            reactions: self.reactions(&parts, &bodies, states),
            profile,
            curve: rows.sampled(CURVE),
        };
        let imbalance = imbalance(&told.reactions, [None, Some(self.copies() * found.force[1])], None);
        let touches = found.status.is_solved() && found.status != ContactStatus::NoContact;
        let reported = found.counter.clone().map(|counter| {
            let states = [rows.held(), counter];
            Reported {
                level,
                ends: Vec::new(),
                heat: None,
                moments: vec![Moment { time: 0.0, name: "", states, around: Vec::new() }],
            }
        });
        let mut solved = Solved {
            contact: rows.contact_result(),
            interface,
            told,
            pressure,
            twist: None,
            embedded,
            unsettled: false,
            many: None,
            misplaced: misplaced(&trial.ends, trial.ends.places[trial.ends.places.len() - 1]),
            shifted: shift.abs(),
            imbalance,
            heat: None,
            refused: (!touches).then(|| found.status.to_string()),
            reported,
            effort,
        };
        self.turn(level, &rows, &mut solved)?;
        Ok(solved)
    }

    /// The last load step with its conditions of sign, from states that are expected of it, and its load.
    fn solved(
        &self,
        on: &mut HeldContact<'_, '_>,
        gap: &[f64],
        (held, expected): (&Steps, &[ContactState]),
    ) -> Result<(ContactSolution, ContactLoad), Fault> {
        let pressed = on.released(gap, &self.press(), &held.pressed).map_err(unsolved)?;
        if self.shear == 0.0 {
            return Ok((pressed, self.press()));
        }
        let push = self.push(&pressed.slip);
        let mut start = held.sheared.clone().unwrap_or(pressed);
        if held.sheared.is_some() {
            start.states = expected.to_vec();
        }
        Ok((on.released(gap, &push, &start).map_err(unsolved)?, push))
    }

    /// Error of the pressure as the embedded degree tells it, on a fixed discretisation.
    fn embedded(
        &self,
        operator: &ContactOperator<'_>,
        gap: &[f64],
        load: &ContactLoad,
        found: &ContactSolution,
    ) -> Result<Option<f64>, Fault> {
        if self.problem.wanted.fixed.is_none() {
            return Ok(None);
        }
        operator.embedded_difference(gap, load, found).map_err(unsolved)
    }

    /// Strain energies of the whole scene.
    fn energy(&self, pair: &Pair<'_>, states: [Option<&InterfaceState>; 2]) -> EnergyResult {
        let [first, second] = [0, 1].map(|body| {
            let operator = [Some(pair.shaped), pair.counter][body];
            self.copies() * operator.zip(states[body]).map_or(0.0, |(operator, state)| operator.strain_energy(state))
        });
        EnergyResult { body1: Some(first), body2: Some(second), ..EnergyResult::default() }
    }

    /// Forces of the supports of the whole scene.
    fn reactions(&self, parts: &Parts, bodies: &[Body; 2], states: [Option<&InterfaceState>; 2]) -> Vec<(String, Reaction)> {
        let held = [&parts.parts[0].held, &parts.parts[1].held];
        let mut reactions = bodies::reactions([&bodies[0].interface, &bodies[1].interface], held, states);
        if self.copies() > 1.0 {
            for (_, reaction) in &mut reactions {
                let z = reaction.z.map(|z| self.copies() * z);
                reaction.x = Some(0.0);
                reaction.moment = z.map(|z| self.disc.middle * z);
                reaction.z = z;
            }
        }
        reactions
    }

    /// Turns body 1, if the problem does, and writes what comes of it.
    fn turn(&self, level: Level, rows: &Rows<'_>, solved: &mut Solved) -> Result<(), Refusal> {
        if self.problem.load.turns.is_empty() {
            return Ok(());
        }
        let (parts, work) = self.on_meshes(level, rows.nodes, Parts::torsion)?;
        let (bodies, reduced) = parts.reduce(self.options.clock)?;
        solved.effort += work.aside();
        solved.effort += reduced.aside();
        let pair = facing(&bodies)?;
        let Some(twist) = Twist::new(self.problem, &pair, rows.found)? else { return Ok(()) };
        twist.report(&mut solved.contact, 0.0);
        for profile in [&mut solved.told.profile, &mut solved.told.curve] {
            twist.fill(rows.operator, profile, 0.0);
            let at: Vec<ContactPoint> = profile.s.iter().map(|s| pair.at_arc(*s)).collect();
            [solved.told.energy.twist1, solved.told.energy.twist2] = torsion::write(&pair, &twist.last.shear, &at, profile);
        }
        solved.twist = Some(twist.told);
        solved.refused = solved.refused.take().or(twist.refused);
        Ok(())
    }
}

/// The end of contact runs away from its trial place.
fn unsettled(nodes: &[f64]) -> Refusal {
    Refusal::Reason(format!("no end of contact settles near {:.4} mm from the middle", nodes[nodes.len() - 1]))
}

/// Pairs the two bodies of a level across their gap.
fn facing<'b>(bodies: &'b [Body; 2]) -> Result<Pair<'b>, Fault> {
    Pair::facing(&bodies[0].interface, &bodies[1].interface).map_err(unsolved)
}

fn solvable(solution: Option<ContactSolution>) -> Result<ContactSolution, contact::Error> {
    solution.ok_or(contact::Error::Singular)
}
