//! Which scenes of a half-disc on a rectangle are built.

use scene::{Component, Fault};

use crate::problem::Problem;
use crate::step::Step;
use crate::steps::ends_setting::Setting;

/// Refuses what is not built, before anything is written.
pub(crate) fn available(setting: &Setting<'_>) -> Result<(), Fault> {
    let Setting { problem, couple, disc, .. } = setting;
    contact_alone(problem, "a half-disc on a rectangle")?;
    let refuse = |key: &str, message: &str, remedy: &str| Err(Fault::at(key, "not-available", message, remedy));
    let load = &problem.load;
    if !problem.gap.is_none() {
        return refuse("contact.gap", "a profile on a half-disc is not known yet", "write gap = 0");
    }
    if problem.plan.runs(Step::Fields) && !load.turns.is_empty() {
        return refuse(
            "output.fields",
            "the inside of a half-disc that is turned is not recovered yet",
            "write output.fields = false",
        );
    }
    if problem.sliding.is_some() && load.turns.is_empty() {
        return refuse("sliding", "a half-disc does not slide steadily yet", "remove `sliding`, or give load.shear_force");
    }
    if load.tilt.is_some_and(|tilt| tilt != 0.0) || load.moment != 0.0 {
        let key = if load.tilt.is_some() { "load.tilt" } else { "load.moment" };
        return refuse(key, "a half-disc is pressed without tilt or moment so far", "write load.tilt = 0");
    }
    if setting.shear == 0.0 {
        return Ok(());
    }
    if !disc.whole || load.tilt.is_none() || couple.bodies[0].holds(Component::X) {
        let remedy = "write load.as = \"rigid\" with tilt = 0, and no support of body 1 along x";
        return refuse("load.shear_force", "the shear force needs a level rigid edge that is free along x", remedy);
    }
    if setting.friction == 0.0 {
        let message = "nothing resists the shear force: contact.friction = 0";
        return Err(Fault::at("load.shear_force", "no-balance", message, "give contact.friction, or remove load.shear_force"));
    }
    Ok(())
}

/// Refuses all tasks but the contact.
pub(crate) fn contact_alone(problem: &Problem, what: &str) -> Result<(), Fault> {
    let others = [(Step::Pressure, "pressure"), (Step::Shape, "shape"), (Step::Evolution, "wear")];
    let Some((_, task)) = others.iter().find(|(step, _)| problem.plan.runs(*step)) else { return Ok(()) };
    let message = format!("{what} has the task contact, but no {task} yet");
    Err(Fault::at("tasks", "not-available", message, "write tasks = [\"contact\"]"))
}
