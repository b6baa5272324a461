//! Which scenes of a half-disc on a rectangle are built.

use scene::{Body, Component, Fault, Gap, Task};

use crate::fe::ends::Setting;
use crate::fe::half_disc::Couple;
use crate::setup::{Problem, turns};

/// Refuses what is not built, before anything is written.
pub(super) fn available(problem: &Problem, couple: &Couple) -> Result<(), Fault> {
    let scene = &problem.scene;
    if let Some(task) = scene.tasks.iter().flatten().find(|task| **task != Task::Contact) {
        let task = format!("{task:?}").to_lowercase();
        let message = format!("a half-disc on a rectangle has the task contact, but no {task} yet");
        return Err(Fault::at("tasks", "not-available", message, "write tasks = [\"contact\"]"));
    }
    let refuse = |key: &str, message: &str, remedy: &str| Err(Fault::at(key, "not-available", message, remedy));
    let load = scene.load.clone().unwrap_or_default();
    if !matches!(scene.contact.as_ref().and_then(|c| c.gap.as_ref()), None | Some(Gap::Constant(0.0))) {
        return refuse("contact.gap", "a profile on a half-disc is not known yet", "write gap = 0");
    }
    if scene.output.as_ref().and_then(|output| output.fields) == Some(true) && !turns(scene).is_empty() {
        return refuse(
            "output.fields",
            "the inside of a half-disc that is turned is not recovered yet",
            "write output.fields = false",
        );
    }
    if scene.sliding.is_some() && turns(scene).is_empty() {
        return refuse("sliding", "a half-disc does not slide steadily yet", "remove `sliding`, or give load.shear_force");
    }
    if load.tilt.is_some_and(|tilt| tilt.0 != 0.0) || load.moment.is_some_and(|moment| moment.0 != 0.0) {
        let key = if load.tilt.is_some() { "load.tilt" } else { "load.moment" };
        return refuse(key, "a half-disc is pressed without tilt or moment so far", "write load.tilt = 0");
    }
    let setting = Setting::new(scene, couple);
    if setting.shear == 0.0 {
        return Ok(());
    }
    let held = |body: &Option<Body>| body.iter().flat_map(|b| b.support.values()).any(|held| held.contains(&Component::X));
    if !couple.whole || load.tilt.is_none() || held(&scene.body1) {
        let remedy = "write load.as = \"rigid\" with tilt = 0, and no support of body 1 along x";
        return refuse("load.shear_force", "the shear force needs a level rigid edge that is free along x", remedy);
    }
    if setting.friction == 0.0 {
        let message = "nothing resists the shear force: contact.friction = 0";
        return Err(Fault::at("load.shear_force", "no-balance", message, "give contact.friction, or remove load.shear_force"));
    }
    Ok(())
}
