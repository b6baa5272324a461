//! Which stages a scene needs, and why the others are left out: a table of every stage with its rule.

use scene::{Component, Task};

use crate::plan::{Plan, Stage};
use crate::problem::Problem;
use crate::step::Step;

/// What of a problem decides about the stages.
struct Facts {
    tasks: Vec<Task>,
    /// Whether anything wears in time.
    wears: bool,
    /// Whether elastic bodies are computed.
    bodies: bool,
    /// Whether friction shear acts on the bodies.
    shear: bool,
    /// Whether the shape is to be proved.
    check: bool,
    /// Whether a force is to be found for a prescribed approach.
    approach: bool,
    revolved: bool,
    slides: bool,
    turned: bool,
    /// Whether the shape is that of a reversing motion.
    reverses: bool,
    /// Whether a body is held against turning about the axis.
    held: bool,
    fields: bool,
    /// Whether they are asked for along lines.
    paths: bool,
    /// Whether frictional heat bends the bodies.
    heat: bool,
    page: bool,
    recording: bool,
}

/// Whether a stage is run, and why or why not; `None` leaves it off the list.
type Rule = fn(&Facts) -> Option<(bool, &'static str)>;

/// Every stage with when and why it is run.
const TABLE: [(Step, Rule); 19] = [
    (Step::Force, |f| {
        let wanted = f.has(Task::Pressure) || f.has(Task::Shape);
        let why = if wanted { "the pressure carries the force that this approach takes" } else { NO_TASK };
        f.approach.then_some((wanted, why))
    }),
    (Step::Pressure, |f| match (f.has(Task::Pressure), f.has(Task::Shape)) {
        (true, _) => Some((true, "the task \"pressure\" asks for it")),
        (false, true) => Some((true, "the shape is made for it")),
        _ => Some((false, NO_TASK)),
    }),
    (Step::Mesh, elastic),
    (Step::Assemble, elastic),
    (Step::Factor, elastic),
    (Step::Interface, elastic),
    (Step::Contact, |f| f.asked(Task::Contact, "the task \"contact\" asks for it", NO_TASK)),
    (Step::Shape, |f| match f.reverses {
        true => Some((true, "the pressures forward and backward are those of its gap")),
        false => f.asked(Task::Shape, "the task \"shape\" asks for it", NO_TASK),
    }),
    (Step::RoundTrip, |f| match (f.has(Task::Shape), f.check) {
        (true, true) => Some((true, "a contact solve on the shape proves it")),
        (true, false) => Some((false, "check = false")),
        _ => Some((false, "there is no shape to prove")),
    }),
    (Step::Evolution, |f| match f.has(Task::Wear) && !f.wears {
        true => Some((false, "without friction nothing wears by wear.beta")),
        false => f.asked(Task::Wear, "the task \"wear\" asks for it", NO_TASK),
    }),
    (Step::Torsion, |f| match (f.bodies && f.revolved, f.shear && (f.slides || f.turned), f.held) {
        (true, true, true) if f.turned => Some((true, "body 1 is turned about the axis, and friction resists")),
        (true, true, true) => Some((true, "friction twists the bodies about the axis")),
        (true, false, _) => Some((false, "no friction twists the bodies")),
        (true, true, false) => Some((false, "no body is held against turning")),
        _ => Some((false, "no axisymmetric body is computed")),
    }),
    (Step::Heat, |f| f.heat.then_some((true, "frictional heat bends the bodies"))),
    (Step::Tangential, |f| match (f.bodies, f.shear) {
        (true, true) => Some((true, "friction shear acts on the bodies")),
        (true, false) => Some((false, "no friction shear acts on the bodies")),
        _ => Some((false, NO_BODY)),
    }),
    (Step::Fields, |f| match (f.bodies, f.fields) {
        (true, false) if f.paths => Some((true, "output.paths asks for displacement and stress inside the bodies")),
        (true, true) => Some((true, "output.fields asks for displacement and stress inside the bodies")),
        (true, false) => Some((false, "no output asks for displacement and stress inside the bodies")),
        _ => Some((false, NO_BODY)),
    }),
    (Step::Table, |_| Some((true, "every run writes it"))),
    (Step::Machined, |f| f.asked(Task::Shape, "a shape is there to be machined", "there is no shape to machine")),
    (Step::Plots, |_| Some((true, "every run draws them"))),
    (Step::Page, |f| Some((f.page, if f.page { "output.report is on" } else { "output.report = false" }))),
    (Step::Recording, |f| match (f.recording, f.has(Task::Wear) && f.wears) {
        (_, true) => Some((true, "a run in time is recorded")),
        (true, false) => Some((true, "output.recording asks for it")),
        _ => Some((false, "no output asks for it")),
    }),
];

const NO_TASK: &str = "no task asks for it";

const NO_BODY: &str = "no body is computed";

fn elastic(facts: &Facts) -> Option<(bool, &'static str)> {
    let why = if facts.bodies {
        "contact, shape and wear need the elastic bodies"
    } else {
        "the pressure follows without elastic bodies"
    };
    Some((facts.bodies, why))
}

impl Facts {
    fn of(problem: &Problem, tasks: &[Task], check: bool) -> Facts {
        let has = |task| tasks.contains(&task);
        let wears = problem.wear.laws.as_ref().map_or(true, |laws| laws.active);
        let output = problem.scene.output.clone().unwrap_or_default();
        let couple = problem.couple.as_ref();
        Facts {
            tasks: tasks.to_vec(),
            wears,
            bodies: has(Task::Contact) || has(Task::Shape) || (has(Task::Wear) && wears),
            shear: problem.friction.shear() > 0.0,
            check,
            approach: problem.load.approach.is_some() && problem.load.force.is_none(),
            revolved: couple.is_some_and(|couple| couple.is_revolved()),
            slides: problem.sliding.is_some(),
            turned: !problem.load.turns.is_empty(),
            reverses: problem.reversing.is_some() && has(Task::Shape),
            held: couple.is_some_and(|couple| couple.bodies.iter().any(|body| body.holds(Component::Phi))),
            fields: output.fields.unwrap_or(false),
            paths: !problem.paths.is_empty(),
            heat: problem.heat.is_some(),
            page: output.report.unwrap_or(true),
            recording: output.recording.unwrap_or(false),
        }
    }

    fn has(&self, task: Task) -> bool {
        self.tasks.contains(&task)
    }

    fn asked(&self, task: Task, why: &'static str, why_not: &'static str) -> Option<(bool, &'static str)> {
        Some(if self.has(task) { (true, why) } else { (false, why_not) })
    }
}

/// The plan of a problem.
pub(super) fn plan(problem: &Problem, tasks: &[Task], check: bool) -> Plan {
    let facts = Facts::of(problem, tasks, check);
    let stage = |(name, rule): &(Step, Rule)| rule(&facts).map(|(ran, because)| Stage { name: *name, ran, because });
    Plan { stages: TABLE.iter().filter_map(stage).collect() }
}
