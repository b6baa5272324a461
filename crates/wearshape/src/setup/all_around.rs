//! Whole circles and round bodies that touch from outside: what is asked of them, and how they are loaded.

use meshing::{Body, touches_all_around};
use scene::{Fault, Geometry, LoadKind, Scene, Task};

use crate::surface::Patch;

/// Refuses tasks of a surface that touches all along where only a part of a circle touches, and a load that presses a circle from all sides.
pub(super) fn check(scene: &Scene, tasks: &[Task], first: Option<&Body>, patch: Option<&Patch>) -> Result<(), Fault> {
    let Some(body) = first else { return Ok(()) };
    let refuse = |key: &str, message: String, remedy: &str| Err(Fault::at(key, "not-available", message, remedy));
    match (touches_all_around(body), patch.is_some_and(Patch::is_convex)) {
        (_, true) if tasks.iter().any(|task| !matches!(task, Task::Contact | Task::Wear)) => {
            let message = "two round bodies that touch from outside have the tasks contact and wear alone: where they touch follows from the load";
            return refuse("tasks", message.to_string(), "write tasks = [\"contact\"], or [\"wear\"]");
        }
        (true, false) if patch.is_some() && tasks.iter().any(|task| !matches!(task, Task::Contact | Task::Wear)) => {
            let message = "a whole circle that touches along a part of it has the tasks contact and wear alone: where it touches follows from the load";
            return refuse("tasks", message.to_string(), "write tasks = [\"contact\"], or [\"wear\"]");
        }
        (around, convex)
            if (around && patch.is_some() || convex)
                && tasks.contains(&Task::Wear)
                && scene.wear.as_ref().is_none_or(|wear| wear.until.is_none()) =>
        {
            let what = if convex { "two round bodies are" } else { "a whole circle is" };
            let message = format!("{what} worn for ever: the contact grows, and no pressure is steady");
            return refuse("wear.until", message, "give a time, as in wear.until = \"10 h\"");
        }
        (_, true) | (true, false) => {}
        (false, false) => return Ok(()),
    }
    let pressed = scene.load.as_ref().is_some_and(|load| load.kind == Some(LoadKind::Pressure));
    if pressed && matches!(body.geometry, Geometry::Ring(_)) {
        let message = "a uniform pressure on a whole circle has no force along z";
        let remedy = "write load.as = \"rigid\", or \"vertical\"";
        return Err(Fault::at("load.as", "wrong-value", message, remedy));
    }
    Ok(())
}
