//! The threshold pressure of the wear rule: its range, and what it does not go with.

use scene::{Counterface, Fault, Functional, Geometry, Pair, Pressure, Scene, Task};

use crate::functional::functional_row;
use crate::surface::{Patch, PatchKind};

/// Thresholds of both bodies (MPa); zero where there is none.
pub(super) fn numbers(scene: &Scene) -> [f64; 2] {
    match scene.wear.as_ref().and_then(|wear| wear.threshold) {
        Some(Pair::Two(values)) => values.map(|value| value.0),
        Some(Pair::One(value)) => [value.0; 2],
        None => [0.0; 2],
    }
}

/// Whether a body that wears has a threshold.
pub(super) fn acts(scene: &Scene) -> bool {
    wearing(scene).into_iter().zip(numbers(scene)).any(|(wears, threshold)| wears && threshold > 0.0)
}

/// Checks the threshold and fills in its default; a threshold of 0 is none.
pub(super) fn resolve(scene: &mut Scene, tasks: &[Task], patch: Option<&Patch>) -> Result<(), Fault> {
    let Some(given) = scene.wear.as_ref().and_then(|wear| wear.threshold) else { return Ok(()) };
    let values = numbers(scene);
    for (place, value) in values.iter().enumerate() {
        let key = if matches!(given, Pair::One(_)) { "wear.threshold".into() } else { format!("wear.threshold.{place}") };
        if !(*value >= 0.0 && value.is_finite()) {
            let message = format!("a threshold pressure of {value} MPa is out of range");
            return Err(Fault::at(key, "wrong-value", message, "give a pressure of 0 or more, as in threshold = \"0.5 MPa\""));
        }
    }
    if let Some(wear) = &mut scene.wear {
        wear.threshold = (values != [0.0; 2]).then(|| Pair::Two(values.map(Pressure)));
    }
    if !acts(scene) || tasks == [Task::Contact] {
        return Ok(());
    }
    rate(scene)?;
    if tasks.iter().any(|task| matches!(task, Task::Pressure | Task::Shape)) {
        optimal(scene, patch)?;
    }
    motion(scene, tasks, "wear.threshold")
}

/// Which bodies have a wear factor.
fn wearing(scene: &Scene) -> [bool; 2] {
    scene.wear.as_ref().map_or([false; 2], scene::Wear::wearing)
}

/// Refuses factors that vanish with the friction: what does not wear has no threshold.
fn rate(scene: &Scene) -> Result<(), Fault> {
    let friction = scene.contact.as_ref().and_then(|contact| contact.friction).unwrap_or(0.0);
    if friction > 0.0 || scene.wear.as_ref().is_none_or(|wear| wear.k.is_some()) {
        return Ok(());
    }
    let message = "contact.friction = 0 with wear.beta means no wear, and wear.threshold is a pressure above which there is some";
    let remedy = "give Archard's factors without friction in them, as in wear.k = 1e-7, or contact.friction > 0";
    Err(Fault::at("contact.friction", "no-wear", message, remedy))
}

/// Refuses optima that are not convex above a threshold, or not derived.
fn optimal(scene: &Scene, patch: Option<&Patch>) -> Result<(), Fault> {
    let refuse = |key: &str, message: String, remedy: &str| Err(Fault::at(key, "not-available", message, remedy));
    let optimum = scene.optimum.clone().unwrap_or_default();
    let functional = optimum.functional.unwrap_or_default();
    let both = wearing(scene) == [true; 2];
    let ring = patch.is_some_and(|patch| patch.kind == PatchKind::Ring);
    let revolving = scene.wear.as_ref().and_then(|wear| wear.counterface) == Some(Counterface::Revolving);
    if functional == Functional::Steady && revolving && wearing(scene)[1] && !ring {
        let message =
            "the mean wear of a revolving counter-face follows from powers of the pressure, and wear.threshold makes it none";
        return refuse("wear.counterface", message.into(), "leave out `wear.threshold`, or let body 1 wear alone");
    }
    let row = functional_row(functional);
    if functional == Functional::Steady || !row.needs.wear {
        return Ok(());
    }
    if both {
        let message = format!("the {} of two bodies with a threshold has no condition that is solved here", row.word);
        return refuse("wear.threshold", message, "let one body wear, or ask for optimum.functional = \"steady\"");
    }
    let q = optimum.q.unwrap_or(1.0);
    let [_, constant] = row.exponents;
    let b = super::optimum::exponents(scene).first().copied().unwrap_or(1.0);
    if q.is_finite() && (q * b > 1.0 || (q * b == 1.0 && constant > 0.0)) {
        return Ok(());
    }
    let least = if constant > 0.0 { "at least" } else { "more than" };
    let message = format!(
        "above a threshold the functional \"{}\" is convex, with one best pressure, where q b is finite and {least} 1, and here q = {q}, b = {b}",
        row.word
    );
    refuse("optimum.q", message, "give a larger finite q, or ask for optimum.functional = \"steady\"")
}

/// Refuses motions and contacts whose wear is known for powers of the pressure alone, and not for the rule that a key gives.
pub(super) fn motion(scene: &Scene, tasks: &[Task], rule: &str) -> Result<(), Fault> {
    let remedy = format!("leave out `{rule}`");
    let refuse = |key: &str, message: &str| Err(Fault::at(key, "not-available", message, remedy.as_str()));
    let elastic = tasks.iter().any(|task| matches!(task, Task::Shape | Task::Wear));
    if elastic && scene.sliding.as_ref().is_some_and(|sliding| sliding.reversing.is_some()) {
        return refuse("sliding.reversing", "the mean wear of a reversing motion is found for powers of the pressure alone");
    }
    let round = scene.body1.as_ref().is_some_and(|body| matches!(body.geometry, Geometry::HalfDisc(_)));
    if tasks.contains(&Task::Wear) && round {
        return refuse(rule, "the scar of a round contact grows by a power of the pressure alone");
    }
    let clearance = scene.contact.as_ref().is_some_and(|contact| contact.clearance.is_some());
    if tasks.contains(&Task::Wear) && clearance {
        return refuse(rule, "a contact with clearance grows by a power of the pressure alone");
    }
    Ok(())
}
