//! Whole circles and round bodies that touch from outside: what is asked of them, and how they are loaded.

use meshing::{Body, touches_all_around};
use scene::{Fault, Geometry, LoadKind, Scene, Task};

use crate::surface::Patch;

/// Refuses tasks other than the contact where only a part of a circle touches, and a load that presses a circle from all sides.
pub(super) fn check(scene: &Scene, tasks: &[Task], first: Option<&Body>, patch: Option<&Patch>) -> Result<(), Fault> {
    let Some(body) = first else { return Ok(()) };
    let what = match (touches_all_around(body), patch.is_some_and(Patch::is_convex)) {
        (_, true) => "two round bodies that touch from outside have",
        (true, false) if patch.is_some() => "a whole circle that touches along a part of it has",
        _ => return Ok(()),
    };
    if tasks != [Task::Contact] {
        let message = format!("{what} the task contact alone: where it touches follows from the load");
        return Err(Fault::at("tasks", "not-available", message, "write tasks = [\"contact\"]"));
    }
    let pressed = scene.load.as_ref().is_some_and(|load| load.kind == Some(LoadKind::Pressure));
    if pressed && matches!(body.geometry, Geometry::Ring(_)) {
        let message = "a uniform pressure on a whole circle has no force along z";
        let remedy = "write load.as = \"rigid\", or \"vertical\"";
        return Err(Fault::at("load.as", "wrong-value", message, remedy));
    }
    Ok(())
}
