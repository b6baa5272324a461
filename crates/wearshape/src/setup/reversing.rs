//! Reversing motion: what it needs, and what it does not go with.

use scene::{Balance, Fault, Functional, Modes, Scene, Task};

use crate::surface::{Patch, PatchKind};

/// Share of the time that goes forward where the scene does not say it.
const SHARE: f64 = 0.5;

/// Share of the time that goes forward, of a resolved scene whose tasks ask for the mean wear of both senses.
pub(super) fn share(scene: &Scene, tasks: &[Task]) -> Option<f64> {
    let reversing = scene.sliding.as_ref()?.reversing.as_ref()?;
    (tasks.contains(&Task::Shape) || tasks.contains(&Task::Wear)).then(|| reversing.share.unwrap_or(SHARE))
}

/// Checks a reversing motion and fills in its share.
pub(super) fn resolve(scene: &mut Scene, tasks: &[Task], patch: Option<&Patch>) -> Result<(), Fault> {
    let Some(reversing) = scene.sliding.as_mut().and_then(|sliding| sliding.reversing.as_mut()) else { return Ok(()) };
    let share = *reversing.share.get_or_insert(SHARE);
    if !(0.0..=1.0).contains(&share) {
        let message = format!("the share {share} of the time forward is not between 0 and 1");
        return Err(Fault::at(
            "sliding.reversing.share",
            "wrong-value",
            message,
            "give a share such as 0.5: as long forward as backward",
        ));
    }
    let refuse = |key: &str, message: &str, remedy: &str| Err(Fault::at(key, "not-available", message, remedy));
    if scene.surface.is_some() {
        let message = "a surface without bodies does not tell how reversed friction moves its pressure";
        return refuse("sliding.reversing", message, "give body1 and body2, or leave `reversing` out");
    }
    if !tasks.contains(&Task::Shape) && !tasks.contains(&Task::Wear) {
        return Ok(());
    }
    if patch.is_some_and(|patch| patch.kind == PatchKind::Ring) {
        let message = "friction around the axis presses alike in both senses";
        return refuse("sliding.reversing", message, "leave `reversing` out: the steady shape is that of one sense");
    }
    loaded(scene)?;
    if tasks.contains(&Task::Shape) {
        wanted(scene)?;
    }
    wears(scene)
}

/// Refuses loads under which no shape stays.
fn loaded(scene: &Scene) -> Result<(), Fault> {
    let Some(load) = &scene.load else { return Ok(()) };
    let refuse = |key: &str, message: &str| {
        let remedy = "press by a force: load.force = \"1 kN\"";
        Err(Fault::at(key, "not-available", message, remedy))
    };
    match load {
        load if load.approach.is_some() => {
            refuse("load.approach", "under a prescribed approach wear ends without pressure, and no shape is steady")
        }
        load if load.approach_time.is_some() => refuse("load.approach_time", "a worn approach belongs to a prescribed one"),
        load if load.shear_force.is_some() => {
            refuse("load.shear_force", "a shear force with stick and slip does not go with a motion that slides to and fro")
        }
        _ => Ok(()),
    }
}

/// Refuses optima other than the steady pressure in balance.
fn wanted(scene: &Scene) -> Result<(), Fault> {
    let Some(optimum) = &scene.optimum else { return Ok(()) };
    let refuse = |key: &str, message: &str, remedy: &str| Err(Fault::at(key, "not-available", message, remedy));
    if optimum.functional.is_some_and(|functional| functional != Functional::Steady) {
        let message = "a reversing motion has the two pressures of its steady shape, and no others";
        return refuse("optimum.functional", message, "write optimum.functional = \"steady\", or leave `sliding.reversing` out");
    }
    if optimum.balance == Some(Balance::Paper) {
        let remedy = "write optimum.balance = \"equilibrium\"";
        return refuse("optimum.balance", "both pressures of a reversing motion are in equilibrium with the load", remedy);
    }
    if optimum.modes == Some(Modes::Associated) {
        let remedy = "write optimum.modes = \"kinematic\"";
        return refuse("optimum.modes", "the feed of a reversing motion is a rigid motion", remedy);
    }
    if optimum.p_max.is_some() {
        return refuse("optimum.p_max", "the pressures of a steady shape have no cap", "leave the cap out");
    }
    Ok(())
}

/// Refuses a contact surface that nothing shapes.
fn wears(scene: &Scene) -> Result<(), Fault> {
    let Some(wear) = &scene.wear else { return Ok(()) };
    let [first, _] = wear.wearing();
    let congruent = wear.counterface == Some(scene::Counterface::Congruent);
    if first || congruent {
        return Ok(());
    }
    let key = if wear.beta.is_some() { "wear.beta" } else { "wear.k" };
    let message = "body 1 does not wear, and passing points of body 2 do not shape the contact";
    Err(Fault::at(key, "no-wear", message, "give body 1 a wear factor, as in wear.k = 1e-7"))
}
