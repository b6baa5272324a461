//! Tasks, accuracy, mesh.

use scene::{Fault, Geometry, Mesh, Scene, Task};

use crate::level::Level;
use crate::problem::Wanted;

/// Relative error where the scene asks for none.
const ACCURACY: f64 = 1e-6;

/// Fills in tasks, title, accuracy and mesh; returns the tasks in their order.
pub(super) fn resolve(scene: &mut Scene) -> Result<Vec<Task>, Fault> {
    if scene.surface.is_some() && (scene.body1.is_some() || scene.body2.is_some()) {
        let message = "both `surface` and bodies are given";
        return Err(Fault::at("surface", "two-alternatives", message, "keep body1 and body2, or `surface` alone"));
    }
    let default = match scene.surface {
        Some(_) => vec![Task::Pressure],
        None => vec![Task::Pressure, Task::Shape],
    };
    let mut tasks = scene.tasks.clone().unwrap_or(default);
    if let Some(twice) = (1..tasks.len()).find(|i| tasks[..*i].contains(&tasks[*i])).map(|i| tasks[i]) {
        let message = format!("the task {} stands in the list twice", word(twice));
        return Err(Fault::at("tasks", "two-alternatives", message, "name each task once"));
    }
    // The pressures of a reversing motion come with the shape that has them.
    let reverses = scene.sliding.as_ref().is_some_and(|sliding| sliding.reversing.is_some());
    if reverses && scene.surface.is_none() && tasks.contains(&Task::Pressure) {
        tasks.push(Task::Shape);
    }
    let tasks = in_order(tasks);
    if tasks.is_empty() {
        let remedy = "write some of pressure, contact, shape, wear, as in tasks = [\"pressure\"]";
        return Err(Fault::at("tasks", "wrong-value", "the list of tasks is empty", remedy));
    }
    if scene.surface.is_some()
        && let Some(task) = tasks.iter().find(|task| **task != Task::Pressure)
    {
        let message = format!("a surface without bodies has a pressure, but no {}", word(*task));
        return Err(Fault::at("tasks", "wrong-value", message, "write tasks = [\"pressure\"], or give body1 and body2"));
    }
    scene.tasks = Some(tasks.clone());
    accuracy(scene)?;
    if tasks.contains(&Task::Shape) && scene.check.is_none() {
        scene.check = Some(true);
    }
    Ok(tasks)
}

/// Each task once, in the order in which they are carried out. There are few: an instance of a sort would take 1 KB of the module for browsers.
fn in_order(mut tasks: Vec<Task>) -> Vec<Task> {
    let mut ordered = Vec::new();
    while let Some(first) = tasks.iter().min().copied() {
        ordered.push(first);
        tasks.retain(|task| *task != first);
    }
    ordered
}

/// The name of a task.
pub(super) fn word(task: Task) -> &'static str {
    match task {
        Task::Pressure => "pressure",
        Task::Contact => "contact",
        Task::Shape => "shape",
        Task::Wear => "wear in time",
    }
}

fn accuracy(scene: &mut Scene) -> Result<(), Fault> {
    if let (Some(mesh), Some(_)) = (&scene.mesh, scene.accuracy)
        && mesh.degree.is_some()
    {
        let message = "both `accuracy` and `mesh.degree` are given";
        let remedy = "keep `accuracy`, from which the mesh follows, or a fixed `mesh`";
        return Err(Fault::at("mesh.degree", "two-alternatives", message, remedy));
    }
    if let Some(mesh) = &mut scene.mesh {
        match mesh.degree {
            Some(degree) if !(1..=24).contains(&degree) => {
                let message = format!("mesh.degree = {degree} is out of range");
                return Err(Fault::at("mesh.degree", "wrong-value", message, "give a degree from 1 to 24"));
            }
            None if scene.accuracy.is_none() => {
                return Err(scene::missing("mesh.degree", "a fixed mesh needs its degree", "mesh.degree = 8"));
            }
            _ => {}
        }
        if let Some(layers) = mesh.layers.filter(|layers| *layers > 60) {
            let message = format!("mesh.layers = {layers} is out of range");
            return Err(Fault::at("mesh.layers", "wrong-value", message, "give 0 to 60 layers"));
        }
        if mesh.degree.is_some() && mesh.layers.is_none() {
            scene.mesh = Some(Mesh { layers: mesh.degree, ..mesh.clone() });
        }
    }
    let fixed = scene.mesh.as_ref().is_some_and(|mesh| mesh.degree.is_some());
    if fixed {
        return Ok(());
    }
    let accuracy = *scene.accuracy.get_or_insert(ACCURACY);
    if !(1e-13..=0.5).contains(&accuracy) {
        let message = format!("accuracy = {accuracy} is out of range");
        let remedy = "give a relative error from 1e-13 to 0.5, as in accuracy = 1e-6";
        return Err(Fault::at("accuracy", "wrong-value", message, remedy));
    }
    Ok(())
}

/// The accuracy of a resolved scene, or its fixed discretisation.
pub(super) fn wanted(scene: &Scene, tasks: &[Task]) -> Wanted {
    let thin = matches!(scene.body1.as_ref().map(|body| &body.geometry), Some(Geometry::RingSegment(_)));
    let bends = thin && tasks.contains(&Task::Shape);
    let mesh = scene.mesh.clone().unwrap_or_default();
    let fixed = mesh.degree.or(mesh.layers).map(|_| {
        let standing = Level::of(mesh.degree.unwrap_or(8), bends);
        Level { layers: mesh.layers.unwrap_or(standing.layers), ..standing }
    });
    Wanted { accuracy: scene.accuracy.unwrap_or(ACCURACY), fixed, bends }
}
