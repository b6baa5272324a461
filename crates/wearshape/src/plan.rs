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
        let kept = |step: Step| matches!(step, Step::Force | Step::Pressure | Step::Plots | Step::Page);
        self.ended(|step| !kept(step), "there is no pressure")
    }

    /// The stages of a run that ended with a shape that is no answer: it was neither proved nor worn, and there is nothing to machine.
    pub fn with_refused_shape(&self) -> Vec<Stage> {
        self.ended(|step| matches!(step, Step::RoundTrip | Step::Evolution | Step::Machined), "the shape is refused")
    }

    /// The stages, some of which were not come to.
    fn ended(&self, left_out: impl Fn(Step) -> bool, because: &'static str) -> Vec<Stage> {
        let mut stages = self.stages.clone();
        for stage in stages.iter_mut().filter(|stage| stage.ran && left_out(stage.name)) {
            (stage.ran, stage.because) = (false, because);
        }
        stages
    }
}
