//! The plan: which stages a scene needs, and why the others are left out.

use serde::Serialize;

use crate::step::Step;

/// A step of the plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stage {
    /// What is done.
    pub name: Step,
    /// Whether it is done.
    pub ran: bool,
    /// Why, or why not.
    pub because: &'static str,
}

/// All stages in their order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plan {
    /// The stages.
    pub stages: Vec<Stage>,
}

impl Plan {
    /// Whether a stage is part of the run.
    pub fn runs(&self, step: Step) -> bool {
        self.stages.iter().any(|stage| stage.name == step && stage.ran)
    }

    /// The stages of a run that ended without a pressure: nothing that needs one was done.
    pub fn without_pressure(&self) -> Vec<Stage> {
        let before = |step: Step| matches!(step, Step::Force | Step::Pressure | Step::Plots | Step::Page);
        let left_out = |stage: &Stage| stage.ran && !before(stage.name);
        let told = |stage: &Stage| Stage { ran: false, because: "there is no pressure", ..stage.clone() };
        self.stages.iter().map(|stage| if left_out(stage) { told(stage) } else { stage.clone() }).collect()
    }
}
