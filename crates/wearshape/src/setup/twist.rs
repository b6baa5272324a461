//! The turning of body 1 about the axis: where it is used, and what it needs.

use contact::Turn;
use scene::{Body, Component, Fault, Kinematics, Scene, Task, missing};

/// What body 1 is turned by, step after step; nothing where the scene does not turn it.
pub(super) fn turns(scene: &Scene) -> Vec<Turn> {
    let contact = scene.tasks.as_ref().is_some_and(|tasks| tasks.contains(&Task::Contact));
    let Some(load) = scene.load.as_ref().filter(|_| contact && scene.kinematics == Some(Kinematics::Axisymmetric)) else {
        return Vec::new();
    };
    let angles = load.twist.iter().flat_map(|steps| steps.0.iter().map(|angle| Turn::Angle(angle.0)));
    let torques = load.torque.iter().flat_map(|steps| steps.0.iter().map(|torque| Turn::Torque(torque.0)));
    angles.chain(torques).collect()
}

/// Checks the turning.
pub(super) fn resolve(scene: &Scene, tasks: &[Task]) -> Result<(), Fault> {
    let Some(load) = &scene.load else { return Ok(()) };
    if load.twist.is_some() && load.torque.is_some() {
        let message = "both `load.twist` and `load.torque` are given";
        return Err(Fault::at("load.torque", "two-alternatives", message, "keep the rotation or the torque"));
    }
    if turns(scene).is_empty() {
        return Ok(());
    }
    let key = if load.twist.is_some() { "load.twist" } else { "load.torque" };
    if let Some(task) = tasks.iter().find(|task| matches!(task, Task::Shape | Task::Wear)) {
        let word = super::tasks::word(*task);
        let message = format!("body 1 is turned in the task contact, and the {word} knows steady sliding only");
        return Err(Fault::at(key, "not-available", message, "write tasks = [\"contact\"], or remove the turning"));
    }
    let contact = scene.contact.as_ref();
    if contact.and_then(|c| c.friction).unwrap_or(0.0) == 0.0 || contact.and_then(|c| c.shear) == Some(false) {
        let message = "nothing resists the turning: there is no friction shear";
        return Err(Fault::at(key, "no-balance", message, "give contact.friction > 0, and no contact.shear = false"));
    }
    let held = |body: &Option<Body>| body.iter().flat_map(|b| b.support.values()).any(|held| held.holds(Component::Phi));
    for (name, body, edge) in [("body1", &scene.body1, "top"), ("body2", &scene.body2, "bottom")] {
        if !held(body) {
            let why = if name == "body1" { "this is the edge that is turned" } else { "it would turn along" };
            // What holds the edge already stays.
            let support = body.as_ref().and_then(|body| body.support.get(edge));
            let held = [(Component::X, "\"x\", "), (Component::Z, "\"z\", ")];
            let kept = held.into_iter().filter(|(component, _)| support.is_some_and(|support| support.holds(*component)));
            let kept: String = kept.map(|(_, word)| word).collect();
            let example = format!("{name}.support.{edge} = [{kept}\"phi\"]");
            return Err(missing(&format!("{name}.support"), &format!("no edge is held against turning, and {why}"), &example));
        }
    }
    Ok(())
}
