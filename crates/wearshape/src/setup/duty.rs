//! How long it runs: the end of a run in time by distance or turns, and the thickness that may wear off.

use std::f64::consts::TAU;

use meshing::{Couple, layer_thickness, outline};
use scene::{Fault, Functional, Layer, Length, Scene, Task, Time, Until, positive, short};

use crate::problem::{End, Wearable};
use crate::setup::repeat;
use crate::surface::Patch;

/// The thickness that may wear off, and its key: of body 1, or in the wear rule of a surface without bodies.
fn given(scene: &Scene) -> Result<Option<(Length, &'static str)>, Fault> {
    let first = match scene.body1.as_ref().and_then(|body| body.wearable.as_ref()) {
        Some(Layer::Thickness(thickness)) => Some(*thickness),
        Some(Layer::Material(_)) | None => None,
    };
    if scene.body2.as_ref().is_some_and(|body| body.wearable.is_some()) {
        let message = "a life is that of body 1, whose wear is followed";
        return Err(Fault::at("body2.wearable", "wrong-key", message, "give body1.wearable, or make this body the first"));
    }
    let in_wear = scene.wear.as_ref().and_then(|wear| wear.wearable);
    match (first, in_wear) {
        (Some(_), Some(_)) => {
            let message = "the thickness that may wear off is given twice, as `body1.wearable` and `wear.wearable`";
            Err(Fault::at("body1.wearable", "two-alternatives", message, "keep one of them"))
        }
        (Some(_), None) if scene.wear.is_none() => {
            let message = "body 1 has a thickness that may wear off, and the scene has no wear rule";
            Err(Fault::at("body1.wearable", "missing-key", message, "add wear = { k = 1e-8 }, or leave the thickness out"))
        }
        (first, in_wear) => {
            Ok(first.map(|first| (first, "body1.wearable")).or(in_wear.map(|thickness| (thickness, "wear.wearable"))))
        }
    }
}

/// Turns the name of the material whose layer may wear off into the thickness of that.
pub(super) fn layer(scene: &mut Scene, first: Option<&meshing::Body>) -> Result<(), Fault> {
    let key = "body1.wearable";
    let (Some(typed), Some(body)) = (first, &mut scene.body1) else { return Ok(()) };
    let Some(Layer::Material(name)) = &body.wearable else { return Ok(()) };
    let materials = body.geometry.materials();
    let Some(material) = materials.and_then(|materials| materials.get(name)) else {
        let known: Vec<&str> = materials.into_iter().flatten().map(|(name, _)| name.as_str()).collect();
        let message = format!("`{name}` is neither a thickness nor a material of the cells of body 1");
        let thickness = format!("{key} = \"4 mm\"");
        let remedy = if known.is_empty() {
            format!("give what of it may wear off, as in {thickness}")
        } else {
            format!("write a thickness, as in {thickness}, or a material at the contact: {}", known.join(", "))
        };
        return Err(Fault::at(key, "unknown-material", message, remedy));
    };
    let Some(thickness) = layer_thickness(typed, material) else {
        let message = format!(
            "the contact edge of body 1 is not a layer of `{name}` on another material, so that none of it has a thickness"
        );
        return Err(Fault::at(key, "wrong-value", message, format!("give what of it may wear off, as in {key} = \"4 mm\"")));
    };
    // No more than the middle has, by round-off.
    body.wearable = Some(Layer::Thickness(Length(thickness.min(outline(typed).thickness))));
    Ok(())
}

/// Refuses a thickness that may wear off where body 1 is not so thick.
fn thick_enough((wearable, key, remedy): (Length, &str, &str), couple: &Couple) -> Result<(), Fault> {
    let thickness = outline(&couple.bodies[0]).thickness;
    // Without a thickness nothing can be said.
    if !thickness.is_finite() || thickness <= 0.0 || wearable.0 <= thickness {
        return Ok(());
    }
    let message =
        format!("{} mm are to wear off body 1, which is {} mm thick at the contact", short(wearable.0), short(thickness));
    Err(Fault::at(key, "wrong-value", message, remedy))
}

/// Relative difference of speeds up to which a surface slides as one.
const SAME: f64 = 1e-9;

/// Turns the end of a run in time into a time; none means the steady state.
pub(super) fn end(scene: &mut Scene, patch: Option<&Patch>) -> Result<(), Fault> {
    if scene.wear.as_ref().is_some_and(|wear| wear.until.is_none()) && scene.schedule.as_ref().is_some_and(|s| s.repeat.is_some())
    {
        return Ok(());
    }
    let until = scene.wear.as_ref().and_then(|wear| wear.until).unwrap_or(Until::Steady);
    let time = match until {
        Until::Steady => None,
        Until::Depth(depth) => {
            positive("wear.until.depth", depth.0, "depth", " mm")?;
            if scene.wear.as_ref().is_some_and(|wear| !wear.wearing()[0]) {
                let message = "body 1 does not wear, and the depth is that of body 1";
                let remedy = "end the run by a time or a volume, or give body 1 a wear factor, as in wear.k = [1e-7, 1e-7]";
                return Err(Fault::at("wear.until.depth", "no-wear", message, remedy));
            }
            return worn(scene, "wear.until.depth");
        }
        Until::Volume(volume) => {
            positive("wear.until.volume", volume.0, "volume", " mm^3")?;
            return worn(scene, "wear.until.volume");
        }
        Until::Time(time) => {
            positive("wear.until", time.0, "time", " s")?;
            Some(time.0)
        }
        Until::Distance(length) => {
            positive("wear.until.distance", length.0, "distance", " mm")?;
            Some(length.0 / speed(scene, patch)?)
        }
        Until::Revolutions(count) => {
            positive("wear.until.revolutions", count, "number of turns", "")?;
            Some(count * TAU / turning(scene)?)
        }
    };
    if let Some(wear) = &mut scene.wear {
        wear.until = Some(time.map_or(Until::Steady, |time| Until::Time(Time(time))));
    }
    Ok(())
}

/// Refuses an end by wear that may never come.
fn worn(scene: &Scene, key: &str) -> Result<(), Fault> {
    if scene.load.as_ref().is_none_or(|load| load.approach.is_none()) {
        return Ok(());
    }
    let message = "under a prescribed approach body 1 wears itself free, and may never have worn so much";
    Err(Fault::at(key, "two-alternatives", message, "press by load.force, or end the run by a time"))
}

/// Where a run in time ends, of a checked scene; none where it goes on until it is steady.
pub(super) fn until(scene: &Scene) -> Option<End> {
    if let Some(cycles) = repeat::cycles(scene) {
        return Some(End::Time(cycles.count * cycles.period));
    }
    match scene.wear.as_ref()?.until? {
        Until::Time(time) => Some(End::Time(time.0)),
        Until::Depth(depth) => Some(End::Depth(depth.0)),
        Until::Volume(volume) => Some(End::Volume(volume.0)),
        Until::Steady | Until::Distance(_) | Until::Revolutions(_) => None,
    }
}

/// One speed that does not change in time.
fn steady(scene: &Scene, key: &str) -> Result<(), Fault> {
    if scene.schedule.as_ref().is_none_or(|schedule| schedule.speed.is_none()) {
        return Ok(());
    }
    let message = "the speed changes by schedule.speed, so that the end is no single time";
    Err(Fault::at(key, "two-alternatives", message, "write wear.until as a time, as in until = \"300 s\""))
}

/// Angular speed of body 2 (rad/s).
fn turning(scene: &Scene) -> Result<f64, Fault> {
    let key = "wear.until.revolutions";
    steady(scene, key)?;
    let sliding = scene.sliding.as_ref();
    let given = sliding.and_then(|sliding| sliding.omega).map(|omega| omega.0.abs());
    // A ball on a disc: its speed is that of its track.
    let by_track = || sliding.and_then(|sliding| Some(sliding.speed?.0.abs() / sliding.track_radius?.0));
    given.or_else(by_track).filter(|omega| *omega > 0.0).ok_or_else(|| {
        let remedy = "give sliding.omega, or the end as { distance = \"2 km\" }";
        Fault::at(key, "wrong-value", "body 2 does not turn, and has no revolutions", remedy)
    })
}

/// Sliding speed of the whole surface (mm/s).
fn speed(scene: &Scene, patch: Option<&Patch>) -> Result<f64, Fault> {
    let key = "wear.until.distance";
    steady(scene, key)?;
    let sliding = scene.sliding.as_ref();
    let by_track = || sliding.and_then(|sliding| Some(sliding.omega?.0.abs() * sliding.track_radius?.0));
    let given = sliding.and_then(|sliding| sliding.speed).map(|speed| speed.0.abs()).or_else(by_track);
    let sampled = || {
        let speeds: Vec<f64> = patch?.sample(3).iter().map(|point| point.sliding_speed).collect();
        let [low, high] = speeds.iter().fold([f64::MAX, 0.0], |[low, high], v| [v.min(low), v.max(high)]);
        (high - low <= SAME * high).then_some(high)
    };
    given.or_else(sampled).filter(|speed| *speed > 0.0).ok_or_else(|| {
        let message = "the contact has no single sliding speed that a distance could be counted by";
        Fault::at(key, "wrong-value", message, "write { revolutions = 1e5 } where body 2 turns, or a time")
    })
}

/// Whether the steady wear that a life follows from is computed.
pub(super) fn has_life(scene: &Scene, tasks: &[Task]) -> bool {
    let steady = scene.optimum.as_ref().and_then(|optimum| optimum.functional).is_none_or(|f| f == Functional::Steady);
    (steady && (tasks.contains(&Task::Pressure) || tasks.contains(&Task::Shape))) || tasks.contains(&Task::Wear)
}

/// Checks the thickness that may wear off.
pub(super) fn resolve(scene: &Scene, tasks: &[Task], couple: Option<&Couple>) -> Result<(), Fault> {
    let given = given(scene)?;
    let Some(wear) = &scene.wear else { return Ok(()) };
    if let (true, Some(Until::Depth(depth)), Some(couple)) = (tasks.contains(&Task::Wear), wear.until, couple) {
        thick_enough(
            (depth, "wear.until.depth", "end the run at a depth that is there, as in until = { depth = \"1 mm\" }"),
            couple,
        )?;
    }
    if let Some(spread) = wear.spread {
        if !(0.0..1.0).contains(&spread) {
            let message = format!("the spread {spread} of the wear factor is out of range");
            return Err(Fault::at("wear.spread", "wrong-value", message, "give 0 or more and less than 1, as in spread = 0.5"));
        }
        if given.is_none() {
            let message = "the spread of the wear factor is for a life, and no thickness that may wear off is given";
            return Err(Fault::at(
                "wear.spread",
                "missing-key",
                message,
                "add wear.wearable = \"4 mm\", or leave the spread out",
            ));
        }
    }
    let Some((thickness, key)) = given else { return Ok(()) };
    positive(key, thickness.0, "thickness", " mm")?;
    let remedy = format!("give what of it may wear off, as in {key} = \"4 mm\"");
    couple.map_or(Ok(()), |couple| thick_enough((thickness, key, &remedy), couple))?;
    if !has_life(scene, tasks) {
        return Ok(());
    }
    let [first, _] = wear.wearing();
    let friction = scene.contact.as_ref().and_then(|contact| contact.friction).unwrap_or(0.0);
    if !first || (wear.beta.is_some() && friction == 0.0) {
        let why = if !first { "its wear factor is 0" } else { "contact.friction = 0 with wear.beta means no wear" };
        let message = format!("body 1 does not wear, so that no thickness of it has a life: {why}");
        let remedy = format!("give body 1 a wear factor, as in wear.k = [1e-7, 0], or leave {key} out");
        return Err(Fault::at(key, "no-wear", message, remedy));
    }
    if scene.load.as_ref().is_some_and(|load| load.approach.is_some()) {
        let message = "load.approach holds body 1 where it is: it does not follow the wear, and the steady wear is none";
        let remedy = format!("give load.force instead, or leave {key} out");
        return Err(Fault::at(key, "two-alternatives", message, remedy));
    }
    Ok(())
}

/// The thickness that may wear off, of a checked scene.
pub(super) fn wearable(scene: &Scene) -> Option<Wearable> {
    let (thickness, _) = given(scene).ok().flatten()?;
    Some(Wearable { thickness: thickness.0, spread: scene.wear.as_ref()?.spread })
}
