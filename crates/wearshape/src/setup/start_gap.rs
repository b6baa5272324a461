//! The gap at the start: its values, its files, its clearance.

use meshing::Files;
use scene::{Contact, Document, Fault, Gap, GapSum, Rows, Scene, SurfaceShape, Task, positive};

use crate::circles::Circles;
use crate::gap::StartGap;
use crate::gap_profile;
use crate::surface::Patch;

/// Checks `contact.gap` as far as it goes without the surface, and reads its file.
pub(super) fn resolve(contact: &mut Contact, files: Files<'_>) -> Result<(), Fault> {
    let gap = contact.gap.get_or_insert(Gap::Constant(0.0));
    match gap {
        Gap::Constant(0.0) => {}
        Gap::Constant(value) => {
            let message = format!("contact.gap = {value}: a uniform gap is no shape");
            let remedy = "write 0, or the name of a CSV file with the columns s_mm, gap_um";
            return Err(Fault::at("contact.gap", "wrong-value", message, remedy));
        }
        Gap::File(name) => {
            let (s, heights) = gap_profile::read(files, name, "contact.gap")?;
            *gap = Gap::Profile { s, gap: heights };
        }
        Gap::Profile { s, gap } => gap_profile::check(s, gap, "contact.gap")?,
        Gap::Sum(sum) => terms(sum, files)?,
    }
    Ok(())
}

/// Most waves of the gap on a contact surface, which is cut into as many pieces for them.
const MOST_WAVES: f64 = 40.0;

/// Longest piece of the contact surface, as a part of it, for the waves of the gap that the bodies have to follow: one wave.
pub(super) fn longest_piece(gap: &StartGap, tasks: &[Task], patch: Option<&Patch>) -> f64 {
    let followed = tasks.iter().any(|task| matches!(task, Task::Contact | Task::Wear));
    let (Some(surface), true) = (patch.and_then(Patch::places), followed) else { return 1.0 };
    let waves = gap.wavelength(surface).map_or(1.0, |length| (surface[1] - surface[0]) / length);
    1.0 / waves.clamp(1.0, MOST_WAVES)
}

/// Refuses waves that are too short to be followed: they are roughness, and no shape.
fn not_too_short(sum: &GapSum, surface: [f64; 2]) -> Result<(), Fault> {
    let cosine = sum.cosine.filter(|cosine| cosine.amplitude.0 > 0.0);
    let waves = cosine.map(|cosine| (surface[1] - surface[0]) / cosine.wavelength.0);
    let Some(waves) = waves.filter(|waves| *waves > MOST_WAVES) else { return Ok(()) };
    let [most, length] = [MOST_WAVES, surface[1] - surface[0]].map(scene::short);
    let message = format!("{:.0} waves on a surface of {length} mm: no more than {most} can be followed", waves);
    let remedy = "give a longer wave; what is as short as this is roughness (contact.roughness)";
    Err(Fault::at("contact.gap.cosine.wavelength", "wrong-value", message, remedy))
}

/// The terms of a sum.
fn terms(sum: &mut GapSum, files: Files<'_>) -> Result<(), Fault> {
    if *sum == GapSum::default() {
        let message = "contact.gap is an empty table: it says nothing of the gap";
        let remedy = "write 0, or a term such as contact.gap = { crown = \"10 um\" }";
        return Err(Fault::at("contact.gap", "wrong-value", message, remedy));
    }
    if let Some(crown) = sum.crown {
        not_negative("contact.gap.crown", crown.0, "the ends cannot reach beyond the middle; a hollow surface is a profile")?;
    }
    if let Some(tilt) = sum.tilt.filter(|tilt| tilt.0.is_nan() || tilt.0.abs() >= MOST_TILT) {
        let message = format!("contact.gap.tilt = {} rad is no small angle", tilt.0);
        return Err(Fault::at("contact.gap.tilt", "wrong-value", message, "give an angle such as \"0.1 mrad\""));
    }
    if let Some(cosine) = sum.cosine {
        not_negative("contact.gap.cosine.amplitude", cosine.amplitude.0, "a wave has a height of 0 or more")?;
        positive("contact.gap.cosine.wavelength", cosine.wavelength.0, "wavelength", " mm")?;
    }
    match &mut sum.profile {
        Some(Rows::File(name)) => {
            let (s, gap) = gap_profile::read(files, name, "contact.gap.profile")?;
            sum.profile = Some(Rows::Columns { s, gap });
        }
        Some(Rows::Columns { s, gap }) => gap_profile::check(s, gap, "contact.gap.profile")?,
        None => {}
    }
    let Some(smooth) = sum.smooth else { return Ok(()) };
    positive("contact.gap.smooth", smooth.0, "residual", " mm")?;
    if sum.profile.is_none() {
        let message = "contact.gap.smooth is said of the rows of a profile, and there is none";
        let remedy = "write contact.gap = { profile = \"gap.csv\", smooth = \"2 um\" }, or leave it out";
        return Err(Fault::at("contact.gap.smooth", "wrong-key", message, remedy));
    }
    Ok(())
}

/// Largest tilt of a gap (rad) of which small displacements know anything.
const MOST_TILT: f64 = 0.1;

fn not_negative(key: &str, value: f64, why: &str) -> Result<(), Fault> {
    if value >= 0.0 {
        return Ok(());
    }
    let message = format!("{key} = {value} mm is negative: {why}");
    Err(Fault::at(key, "wrong-value", message, "give a height of 0 or more"))
}

/// The start gap on a surface, with the clearance of circles.
pub(super) fn on_surface(scene: &Scene, patch: Option<&Patch>) -> Result<StartGap, Fault> {
    let Some(contact) = &scene.contact else { return Ok(StartGap::default()) };
    let circles = clearance(contact, scene.surface.as_ref(), patch)?;
    match (&contact.gap, patch.and_then(Patch::places)) {
        (Some(gap), Some(surface)) => {
            gap_profile::covers(gap, surface)?;
            if let Gap::Sum(sum) = gap {
                not_too_short(sum, surface)?;
            }
        }
        (Some(Gap::Sum(sum)), None) if scene.surface.is_none() => known_ends(sum)?,
        _ => {}
    }
    Ok(StartGap::new(contact.gap.as_ref(), circles, patch))
}

/// Refuses the gap of a run beside circles: it is the whole one, that of the circles in it.
pub(super) fn not_twice(document: &Document, gap: &StartGap, files: Files<'_>) -> Result<(), Fault> {
    let given = document.scene.contact.as_ref().and_then(|contact| contact.gap.as_ref());
    let (key, name) = match given {
        Some(Gap::File(name)) => ("contact.gap", name),
        Some(Gap::Sum(GapSum { profile: Some(Rows::File(name)), .. })) => ("contact.gap.profile", name),
        _ => return Ok(()),
    };
    if !gap.has_circles() || !gap_profile::is_of_run(files, name) {
        return Ok(());
    }
    let message =
        format!("the gap of {name} is the whole gap of a run, and the circles of this scene would add theirs to it once more");
    let remedy = "write contact.clearance = 0 (and draw both arcs with one radius), or leave out the gap";
    Err(Fault::at(key, "counted-twice", message, remedy))
}

/// A crown and a tilt are counted from the ends of the surface, which round bodies on flat ones do not have.
fn known_ends(sum: &GapSum) -> Result<(), Fault> {
    let terms = [("crown", sum.crown.is_some()), ("tilt", sum.tilt.is_some())];
    let Some((key, _)) = terms.into_iter().find(|(_, given)| *given) else { return Ok(()) };
    let message =
        format!("contact.gap.{key} is counted from the ends of the contact surface, and a round body on a flat one has none");
    Err(Fault::at(format!("contact.gap.{key}"), "not-available", message, "give a profile, or leave it out"))
}

/// The circles that a clearance makes of two equal ones, or those of arcs that are drawn with two radii.
fn clearance(contact: &Contact, bare: Option<&SurfaceShape>, patch: Option<&Patch>) -> Result<Option<Circles>, Fault> {
    let drawn = patch.and_then(Patch::circles);
    let Some(clearance) = contact.clearance.map(|clearance| clearance.0) else { return Ok(drawn) };
    let refuse = |code: &'static str, message: String, remedy: &str| Err(Fault::at("contact.clearance", code, message, remedy));
    if clearance.is_nan() || clearance < 0.0 {
        let message =
            format!("negative clearance: contact.clearance = {clearance} mm is an interference, which presses without a load");
        return refuse("wrong-value", message, "give the radius of the hole less that of the shaft, 0 or more");
    }
    if bare.is_some() {
        return Ok(None);
    }
    if drawn.is_some() && clearance == 0.0 {
        return Ok(drawn);
    }
    if patch.is_some_and(Patch::is_convex) {
        let message = "bodies that touch from outside have no clearance: their radii are the drawn ones".to_string();
        return refuse("wrong-key", message, "leave out contact.clearance; contact.gap gives a gap beside that of the circles");
    }
    if drawn.is_some() {
        let message = "the arcs are drawn with two radii, whose difference is their clearance".to_string();
        return refuse("wrong-key", message, "leave out contact.clearance, or draw both arcs with one radius");
    }
    let Some((radius, internal)) = patch.and_then(Patch::circle) else {
        let message = "a clearance is that of a shaft in its housing, and this contact surface is no arc".to_string();
        return refuse("wrong-key", message, "leave it out; contact.gap gives the gap of flat surfaces");
    };
    let first = if internal { radius - clearance } else { radius + clearance };
    if first <= 0.5 * radius || first >= 2.0 * radius {
        let message = format!("contact.clearance = {clearance} mm is no clearance of a radius of {radius} mm");
        return refuse("wrong-value", message, "draw arcs whose radii differ by that much with their own radii");
    }
    Ok(patch.filter(|_| clearance > 0.0).and_then(|patch| patch.circles_of(first)))
}
