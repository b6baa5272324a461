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
        let mut stages = self.stages.clone();
        for stage in &mut stages {
            if stage.ran && !matches!(stage.name, Step::Force | Step::Pressure | Step::Plots | Step::Page) {
                (stage.ran, stage.because) = (false, "there is no pressure");
            }
        }
        stages
    }
}
