//! A motion to and fro by stroke and frequency: its mean speed, and its reversals.

use scene::{Fault, Geometry, Reversing, Scene, Speed, missing};

/// Share of the time forward of a motion that goes as fast there as back.
const SHARE: f64 = 0.5;

const EXAMPLE: &str = "cycle = { stroke = \"10 mm\", frequency = \"2 Hz\" }";

/// Fills in the speed of a cycle, and that friction makes the motion a reversing one where bodies answer it.
pub(super) fn resolve(scene: &mut Scene) -> Result<(), Fault> {
    let reverses = turns_friction(scene);
    let Some(sliding) = &mut scene.sliding else { return Ok(()) };
    let Some(cycle) = &sliding.cycle else { return Ok(()) };
    let stroke = cycle.stroke.ok_or_else(|| missing("sliding.cycle.stroke", "a cycle needs the way from end to end", EXAMPLE))?;
    let frequency =
        cycle.frequency.ok_or_else(|| missing("sliding.cycle.frequency", "a cycle needs its number a second", EXAMPLE))?;
    scene::positive("sliding.cycle.stroke", stroke.0, "stroke", " mm")?;
    scene::positive("sliding.cycle.frequency", frequency.0, "frequency", " Hz")?;
    let given = [
        ("speed", sliding.speed.is_some()),
        ("omega", sliding.omega.is_some()),
        ("track_radius", sliding.track_radius.is_some()),
    ];
    if let Some((key, _)) = given.iter().find(|(_, given)| *given) {
        let message = format!(
            "both sliding.cycle and sliding.{key} are given: the speed of a cycle is twice its stroke times its frequency"
        );
        return Err(Fault::at(format!("sliding.{key}"), "two-alternatives", message, "keep one of them"));
    }
    if sliding.reversing.as_ref().and_then(|reversing| reversing.share).is_some_and(|share| share != SHARE) {
        let message = "a cycle goes as far back as it goes forth, at one speed: half of the time each";
        let remedy = "leave sliding.reversing out, or give sliding.speed and the share without `cycle`";
        return Err(Fault::at("sliding.reversing.share", "two-alternatives", message, remedy));
    }
    sliding.speed = Some(Speed(2.0 * stroke.0 * frequency.0));
    if reverses {
        sliding.reversing.get_or_insert(Reversing { share: Some(SHARE) });
    }
    Ok(())
}

/// Whether friction acts on bodies that meet on a whole surface.
fn turns_friction(scene: &Scene) -> bool {
    let contact = scene.contact.as_ref();
    let shear =
        contact.and_then(|contact| contact.friction).unwrap_or(0.0) > 0.0 && contact.is_some_and(|c| c.shear != Some(false));
    let bodies = [&scene.body1, &scene.body2];
    let round = bodies.iter().any(|body| matches!(body.as_ref().map(|body| &body.geometry), Some(Geometry::HalfDisc(_))));
    shear && !round && bodies.iter().all(|body| body.is_some())
}

/// A fault of the sliding in the words of a scene with a cycle.
pub(super) fn named(scene: &Scene, fault: Fault) -> Fault {
    let cycle = scene.sliding.as_ref().is_some_and(|sliding| sliding.cycle.is_some());
    if !cycle || !fault.key.as_deref().is_some_and(|key| key.starts_with("sliding.")) {
        return fault;
    }
    let message = "a cycle with a stroke is a motion along a straight line, and this contact turns about an axis";
    Fault::at("sliding.cycle", "wrong-key", message, "give sliding.omega, and sliding.reversing where it turns to and fro")
}

/// Takes the speed that follows from a cycle out of a scene that is written.
pub(super) fn leave_out(scene: &mut Scene) {
    if let Some(sliding) = scene.sliding.as_mut().filter(|sliding| sliding.cycle.is_some()) {
        sliding.speed = None;
    }
}
