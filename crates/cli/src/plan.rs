//! The plan: which stages a scene needs, and why the others are left out.

use scene::{Component, Scene, Task};
use serde::Serialize;

/// One stage.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Stage {
    /// What is done.
    pub(crate) name: &'static str,
    /// Whether it is done.
    pub(crate) ran: bool,
    /// Why, or why not.
    pub(crate) because: String,
}

/// All stages in their order.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Plan {
    /// The stages.
    pub(crate) stages: Vec<Stage>,
}

impl Plan {
    /// The plan of a resolved scene.
    pub(crate) fn new(scene: &Scene, tasks: &[Task]) -> Plan {
        let mut stages = Vec::new();
        let mut stage = |name, ran: bool, because: &str| stages.push(Stage { name, ran, because: because.to_string() });
        let has = |task| tasks.contains(&task);
        let bodies = has(Task::Contact) || has(Task::Shape) || has(Task::Wear);
        let friction = scene.contact.as_ref().and_then(|contact| contact.friction).unwrap_or(0.0);
        let shear = friction > 0.0 && scene.contact.as_ref().and_then(|contact| contact.shear).unwrap_or(true);
        let check = scene.check.unwrap_or(true);
        let load = scene.load.as_ref();
        if load.is_some_and(|load| load.approach.is_some() && load.force.is_none()) {
            let wanted = has(Task::Pressure) || has(Task::Shape);
            let why = if wanted { "the pressure carries the force that this approach takes" } else { "no task asks for it" };
            stage(crate::solve::FORCE, wanted, why);
        }
        match (has(Task::Pressure), has(Task::Shape)) {
            (true, _) => stage("optimal pressure", true, "the task \"pressure\" asks for it"),
            (false, true) => stage("optimal pressure", true, "the shape is made for it"),
            _ => stage("optimal pressure", false, "no task asks for it"),
        }
        let elastic = if bodies {
            "contact, shape and wear need the elastic bodies"
        } else {
            "the pressure follows without elastic bodies"
        };
        for name in ["mesh", "assemble", "factor", "interface"] {
            stage(name, bodies, elastic);
        }
        stage(
            "contact",
            has(Task::Contact),
            if has(Task::Contact) { "the task \"contact\" asks for it" } else { "no task asks for it" },
        );
        stage("shape", has(Task::Shape), if has(Task::Shape) { "the task \"shape\" asks for it" } else { "no task asks for it" });
        match (has(Task::Shape), check) {
            (true, true) => stage("round trip", true, "a contact solve on the shape proves it"),
            (true, false) => stage("round trip", false, "check = false"),
            _ => stage("round trip", false, "there is no shape to prove"),
        }
        stage(
            "evolution",
            has(Task::Wear),
            if has(Task::Wear) { "the task \"wear\" asks for it" } else { "no task asks for it" },
        );
        let held = |body: &Option<scene::Body>| {
            body.as_ref().is_some_and(|body| body.support.values().any(|held| held.contains(&Component::Phi)))
        };
        let axisymmetric = scene.kinematics == Some(scene::Kinematics::Axisymmetric);
        let turned = !crate::setup::turns(scene).is_empty();
        match (bodies && axisymmetric, shear && (scene.sliding.is_some() || turned), held(&scene.body1) || held(&scene.body2)) {
            (true, true, true) if turned => stage("torsion", true, "body 1 is turned about the axis, and friction resists"),
            (true, true, true) => stage("torsion", true, "friction twists the bodies about the axis"),
            (true, false, _) => stage("torsion", false, "no friction twists the bodies"),
            (true, true, false) => stage("torsion", false, "no body is held against turning"),
            _ => stage("torsion", false, "no axisymmetric body is computed"),
        }
        let tangential = match (bodies, shear) {
            (true, true) => "friction shear acts on the bodies",
            (true, false) => "no friction shear acts on the bodies",
            _ => "no body is computed",
        };
        stage("tangential columns", bodies && shear, tangential);
        let fields = scene.output.as_ref().and_then(|output| output.fields).unwrap_or(false);
        match (bodies, fields) {
            (true, true) => stage("field recovery", true, "output.fields asks for displacement and stress inside the bodies"),
            (true, false) => stage("field recovery", false, "no output asks for displacement and stress inside the bodies"),
            _ => stage("field recovery", false, "no body is computed"),
        }
        stage("contact.csv", true, "every run writes it");
        stage(
            "machined profile",
            has(Task::Shape),
            if has(Task::Shape) { "a shape is there to be machined" } else { "there is no shape to machine" },
        );
        stage("plots", true, "every run draws them");
        let report = scene.output.as_ref().and_then(|output| output.report).unwrap_or(true);
        stage("report.html", report, if report { "output.report is on" } else { "output.report = false" });
        let recording = scene.output.as_ref().and_then(|output| output.recording).unwrap_or(false);
        match (recording, has(Task::Wear)) {
            (_, true) => stage("run.mcap", true, "a run in time is recorded"),
            (true, false) => stage("run.mcap", true, "output.recording asks for it"),
            _ => stage("run.mcap", false, "no output asks for it"),
        }
        Plan { stages }
    }

    /// Whether a stage is part of the run.
    pub(crate) fn runs(&self, name: &str) -> bool {
        self.stages.iter().any(|stage| stage.name == name && stage.ran)
    }
}
