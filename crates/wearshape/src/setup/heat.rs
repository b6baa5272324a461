//! Frictional heat: its defaults, and what it needs of the scene.

use std::collections::BTreeMap;

use meshing::{Body, Couple, outline};
use scene::{
    Conductance, Counterface, Document, EdgeHeat, Fault, Geometry, Kinematics, Material, Scene, Task, Temperature, missing,
    positive,
};

use crate::heat::{Carried, Drum, Heat, Meets, Split};
use crate::setup::bodies::{known_edge, off_axis};
use crate::setup::materials::for_each_material;
use crate::setup::twist::turns;
use crate::surface::{Patch, PatchKind};

/// Temperature of the cold shape where the scene gives none (degC).
const REFERENCE: f64 = 20.0;
/// There is no colder temperature (degC).
const ABSOLUTE_ZERO: f64 = -273.15;

/// Takes heat out of a scene that does not use it; returns the keys that are not used then, whether they were written or not.
pub(super) fn begin(scene: &mut Scene, tasks: &[Task]) -> Result<Vec<String>, Fault> {
    if scene.heat.is_some() && scene.surface.is_none() && tasks != [Task::Pressure] {
        return Ok(Vec::new());
    }
    let keys = keys(scene);
    leave_out(scene)?;
    Ok(keys)
}

/// Takes out what a scene without heat does not use, so that its bodies are those of any other; edges that carry heat are refused.
fn leave_out(scene: &mut Scene) -> Result<(), Fault> {
    let heated = scene.heat.is_some();
    for (name, body) in [("body1", &mut scene.body1), ("body2", &mut scene.body2)] {
        let Some(body) = body else { continue };
        if !heated && let Some(edge) = body.heat.keys().next() {
            let key = format!("{name}.heat.{edge}");
            let message = format!("{key} would be left out: the scene has no table `heat`");
            return Err(Fault::at(key, "not-carried", message, "add `heat = { share = 0.1 }` (or conductance), or remove it"));
        }
        body.heat.clear();
        for_each_material(body, &mut |_, material| *material = material.without_heat());
    }
    scene.heat = None;
    Ok(())
}

/// Puts back what was written and taken out, so that the resolved scene has the same unused keys.
pub(super) fn put_back(document: &Document, scene: &mut Scene) {
    let written = &document.scene;
    scene.heat.clone_from(&written.heat);
    let bodies = [("body1", &mut scene.body1, &written.body1), ("body2", &mut scene.body2, &written.body2)];
    for (name, body, written) in bodies {
        let (Some(body), Some(mut written)) = (body, written.clone()) else { continue };
        body.heat.clone_from(&written.heat);
        let mut materials = BTreeMap::new();
        for_each_material(&mut written, &mut |place, material| {
            materials.insert(place.to_string(), *material);
        });
        for_each_material(body, &mut |place, material| {
            let Some(own) = materials.get(place) else { return };
            let has = |key: &str| document.has(&format!("{name}.{place}.{key}"));
            material.conductivity = own.conductivity.filter(|_| has("conductivity"));
            material.expansion = own.expansion.filter(|_| has("expansion"));
            material.temperature_limit = own.temperature_limit.filter(|_| has("temperature_limit"));
        });
    }
}

/// The keys of heat in a scene, whether they were written or not.
fn keys(scene: &Scene) -> Vec<String> {
    let mut keys = vec!["heat".to_string()];
    for (name, body) in [("body1", scene.body1.clone()), ("body2", scene.body2.clone())] {
        let Some(mut body) = body else { continue };
        keys.push(format!("{name}.heat"));
        for_each_material(&mut body, &mut |place, _| {
            keys.extend(["conductivity", "expansion", "temperature_limit"].map(|key| format!("{name}.{place}.{key}")));
        });
    }
    keys
}

/// Checks the heat of a scene that uses it and fills in its defaults; none of other scenes.
pub(super) fn resolve(
    scene: &mut Scene,
    tasks: &[Task],
    couple: Option<&Couple>,
    patch: Option<&Patch>,
) -> Result<Option<Heat>, Fault> {
    let (Some(mut heat), Some(couple)) = (scene.heat.clone(), couple) else { return Ok(None) };
    sources(scene)?;
    available(scene, tasks, patch)?;
    let split = split(&heat)?;
    let reference = *heat.reference.get_or_insert(Temperature(REFERENCE));
    let reference = warm("heat.reference", reference)?;
    let worn = scene.wear.as_ref().and_then(|wear| wear.counterface);
    let counterface = *heat.counterface.get_or_insert(worn.unwrap_or(usual(patch)));
    let fresh = counterface == Counterface::Fresh;
    conducting(scene, fresh)?;
    let edges = [edges(scene, couple, 0)?, edges(scene, couple, 1)?];
    for (body, edges) in couple.bodies.iter().zip(&edges).take(if fresh { 1 } else { 2 }) {
        cooled(body, edges)?;
    }
    let meets = match counterface {
        Counterface::Congruent => Meets::Congruent,
        Counterface::Fresh => Meets::Fresh(arriving(&edges[1], reference)?),
        Counterface::Revolving if couple.is_revolved() => Meets::Congruent,
        Counterface::Revolving => Meets::Revolving(drum(couple)?),
    };
    scene.heat = Some(heat);
    Ok(Some(Heat { split, reference, meets, edges }))
}

/// How body 2 usually meets body 1, where no wear says it.
fn usual(patch: Option<&Patch>) -> Counterface {
    match patch.map(|patch| patch.kind) {
        Some(PatchKind::Ring) => Counterface::Congruent,
        Some(PatchKind::Turning) => Counterface::Revolving,
        Some(PatchKind::Plane) | None => Counterface::Fresh,
    }
}

/// Heat needs friction and sliding.
fn sources(scene: &Scene) -> Result<(), Fault> {
    if scene.contact.as_ref().and_then(|contact| contact.friction).unwrap_or(0.0) == 0.0 {
        let message = "`heat` is that of friction, and there is none: contact.friction = 0";
        return Err(Fault::at("contact.friction", "no-heat", message, "give contact.friction > 0, or remove `heat`"));
    }
    if scene.sliding.is_none() {
        return Err(missing("sliding", "frictional heat needs a sliding speed", "sliding = { omega = \"2.5 rad/s\" }"));
    }
    Ok(())
}

/// Refuses what heat does not know yet.
fn available(scene: &Scene, tasks: &[Task], patch: Option<&Patch>) -> Result<(), Fault> {
    let refused = |key: &str, what: &str, remedy: &str| {
        Err(Fault::at(key, "not-available", format!("{what} with frictional heat is not available"), remedy))
    };
    let repeats = scene.schedule.as_ref().is_some_and(|schedule| schedule.repeat.is_some());
    if tasks.contains(&Task::Wear) && repeats {
        let remedy = "heat takes longer than short cycles: write the pieces of the schedule without repeat, or remove `heat`";
        return refused("schedule.repeat", "a schedule that repeats", remedy);
    }
    if !turns(scene).is_empty() {
        return refused("load", "body 1 turned about the axis by load.twist or load.torque", "remove the turning, or `heat`");
    }
    let sliding = scene.sliding.as_ref();
    if sliding.is_some_and(|sliding| sliding.reversing.is_some() || sliding.cycle.is_some()) {
        return refused("sliding", "motion to and fro", "give a steady sliding.speed or sliding.omega, or remove `heat`");
    }
    let load = scene.load.as_ref();
    if load.is_some_and(|load| load.approach.is_some()) {
        return refused("load.approach", "a prescribed approach", "give load.force, or remove `heat`");
    }
    let known = patch.is_some_and(|patch| !patch.is_convex() && patch.extent().is_some_and(is_common));
    if !known {
        let what = "a contact of surfaces that do not lie on each other (round on flat, two round bodies)";
        return refused("contact.edges", what, "give both bodies one contact surface, or remove `heat`");
    }
    Ok(())
}

fn is_common(extent: meshing::Extent) -> bool {
    matches!(extent, meshing::Extent::Angles(_) | meshing::Extent::X(_))
}

fn split(heat: &scene::Heat) -> Result<Split, Fault> {
    match (heat.share, heat.conductance) {
        (Some(_), Some(_)) => {
            let message = "both `heat.share` and `heat.conductance` are given";
            let remedy = "keep the share, or the conductance, from which it follows";
            Err(Fault::at("heat.conductance", "two-alternatives", message, remedy))
        }
        (None, None) => Err(missing(
            "heat.share",
            "the scene must say how the bodies share the heat",
            "share = 0.1 (or conductance = \"inf\")",
        )),
        (Some(share), None) if (0.0..=1.0).contains(&share) => Ok(Split::Share(share)),
        (Some(share), None) => {
            let message = format!("heat.share = {share} is not between 0 and 1");
            Err(Fault::at("heat.share", "wrong-value", message, "give the part of the heat that goes into body 1"))
        }
        (None, Some(Conductance(conductance))) if conductance >= 0.0 => Ok(Split::Conductance(conductance)),
        (None, Some(Conductance(conductance))) => {
            let message = format!("negative conductance: heat.conductance = {conductance} mW/(mm^2 K)");
            Err(Fault::at("heat.conductance", "wrong-value", message, "give a conductance of 0 or more, or \"inf\""))
        }
    }
}

/// Every material that heat flows through needs its numbers.
fn conducting(scene: &Scene, fresh: bool) -> Result<(), Fault> {
    let bodies = [("body1", &scene.body1), ("body2", &scene.body2)];
    for (name, body) in bodies.into_iter().take(if fresh { 1 } else { 2 }) {
        let Some(mut body) = body.clone() else { continue };
        // Where every cell has a material of its own, the body's is not used.
        let mut found = Ok(());
        for_each_material(&mut body, &mut |place, material| {
            if found.is_ok() {
                found = conducts(&format!("{name}.{place}"), material);
            }
        });
        found?;
    }
    Ok(())
}

fn conducts(key: &str, material: &Material) -> Result<(), Fault> {
    match material.conductivity {
        Some(conductivity) => positive(&format!("{key}.conductivity"), conductivity.0, "conductivity", " mW/(mm K)")?,
        None => return Err(incomplete(&format!("{key}.conductivity"), "heat flows through it", "conductivity = \"50 W/(m K)\"")),
    }
    match material.expansion {
        Some(expansion) if expansion.0 >= 0.0 => Ok(()),
        Some(expansion) => {
            let message = format!("negative thermal expansion: {key}.expansion = {} 1/K", expansion.0);
            Err(Fault::at(format!("{key}.expansion"), "wrong-value", message, "give an expansion of 0 or more"))
        }
        None => Err(incomplete(&format!("{key}.expansion"), "heat makes it expand", "expansion = \"12e-6 1/K\"")),
    }
}

/// A material that lacks what heat asks for: one by name has what its source gives.
fn incomplete(key: &str, why: &str, example: &str) -> Fault {
    let fault = missing(key, why, example);
    Fault { remedy: format!("{}; a material by name that lacks it is written as a table of its numbers", fault.remedy), ..fault }
}

/// What carries heat through the edges of a body.
fn edges(scene: &Scene, couple: &Couple, number: usize) -> Result<BTreeMap<String, Carried>, Fault> {
    let given = [&scene.body1, &scene.body2][number].as_ref().map(|body| body.heat.clone()).unwrap_or_default();
    let body = &couple.bodies[number];
    let outline = outline(body);
    let axisymmetric = scene.kinematics == Some(Kinematics::Axisymmetric);
    let mut edges = BTreeMap::new();
    for (edge, heat) in given {
        let key = format!("{}.heat.{edge}", body.key);
        known_edge(&key, &edge, &outline.names(false))?;
        off_axis(&key, &edge, &outline.points(&edge), axisymmetric)?;
        let carried = carried(&key, heat)?;
        if edge == body.contact && !matches!(carried, Carried::Convection(..)) {
            let message = format!("{key}: the edge touches the other body, and outside of the contact it has convection alone");
            return Err(Fault::at(key, "wrong-value", message, "write { convection = ..., ambient = ... }, or another edge"));
        }
        edges.insert(edge, carried);
    }
    Ok(edges)
}

fn carried(key: &str, heat: EdgeHeat) -> Result<Carried, Fault> {
    let form = "write { temperature = \"20 degC\" }, { convection = \"100 W/(m2 K)\", ambient = \"20 degC\" } or { flux = 1 }";
    match (heat.temperature, heat.convection, heat.ambient, heat.flux) {
        (Some(held), None, None, None) => Ok(Carried::Held(warm(&format!("{key}.temperature"), held)?)),
        (None, Some(film), Some(ambient), None) if film.0 >= 0.0 => {
            Ok(Carried::Convection(film.0, warm(&format!("{key}.ambient"), ambient)?))
        }
        (None, Some(film), Some(_), None) => {
            let message = format!("negative coefficient of heat transfer: {key}.convection = {} mW/(mm^2 K)", film.0);
            Err(Fault::at(format!("{key}.convection"), "wrong-value", message, "give a coefficient of 0 or more"))
        }
        (None, None, None, Some(flux)) => Ok(Carried::Flux(flux.0)),
        (None, Some(_), None, None) => {
            Err(missing(&format!("{key}.ambient"), "convection goes to surroundings at a temperature", "ambient = \"20 degC\""))
        }
        (None, None, Some(_), None) => {
            Err(missing(&format!("{key}.convection"), "surroundings take heat by convection", "convection = \"100 W/(m2 K)\""))
        }
        (None, None, None, None) => Err(Fault::at(key, "wrong-value", format!("{key} carries nothing"), form)),
        _ => Err(Fault::at(key, "two-alternatives", format!("{key} has more than one of what carries heat"), form)),
    }
}

/// A temperature that there is (degC).
fn warm(key: &str, Temperature(temperature): Temperature) -> Result<f64, Fault> {
    if temperature >= ABSOLUTE_ZERO {
        return Ok(temperature);
    }
    let message = format!("{key} = {temperature} degC is below absolute zero, {ABSOLUTE_ZERO} degC");
    Err(Fault::at(key, "wrong-value", message, "give a temperature in degC"))
}

/// A body that nothing cools has no steady temperature.
fn cooled(body: &Body, edges: &BTreeMap<String, Carried>) -> Result<(), Fault> {
    if edges.values().any(|carried| carried.cools()) {
        return Ok(());
    }
    let why = "nothing cools the body, so that it has no steady temperature";
    let names = outline(body).names(false);
    let edge = names.iter().rev().find(|name| **name != body.contact).map_or("top", |name| name);
    let example = format!("{}.heat.{edge} = {{ convection = \"100 W/(m2 K)\", ambient = \"20 degC\" }}", body.key);
    let key = format!("{}.heat", body.key);
    if edges.is_empty() {
        return Err(missing(&key, why, &example));
    }
    let message = format!("{key} carries no heat away: {why}");
    Err(Fault::at(key, "wrong-value", message, format!("write {example}, or hold an edge at a temperature")))
}

/// The one temperature at which a fresh body 2 arrives: that of its surroundings, or that of the cold shape.
fn arriving(edges: &BTreeMap<String, Carried>, reference: f64) -> Result<f64, Fault> {
    let mut found: Option<f64> = None;
    for (edge, carried) in edges {
        let temperature = match carried {
            Carried::Held(temperature) | Carried::Convection(_, temperature) => *temperature,
            Carried::Flux(_) => {
                let message = "a fresh body 2 arrives at the temperature of its surroundings, and no flux warms it";
                return Err(Fault::at(format!("body2.heat.{edge}.flux"), "wrong-value", message, "remove the flux"));
            }
        };
        if found.is_some_and(|before| before != temperature) {
            let message = "a fresh body 2 arrives at one temperature, and its edges give several";
            return Err(Fault::at(format!("body2.heat.{edge}"), "wrong-value", message, "give one temperature"));
        }
        found = Some(temperature);
    }
    Ok(found.unwrap_or(reference))
}

/// The ring that turns under body 1.
fn drum(couple: &Couple) -> Result<Drum, Fault> {
    let body = &couple.bodies[1];
    if let Geometry::Ring(ring) = &body.geometry {
        let centre = ring.centre.map_or([0.0; 2], |centre| centre.map(|x| x.0));
        return Ok(Drum { radii: [ring.inner.0, ring.outer.0], outside: body.contact == "outer", centre });
    }
    let message = "a body 2 that revolves has one temperature along each circle, and it is known of geometry.ring alone";
    let remedy = "write heat.counterface = \"fresh\" or \"congruent\", or give body2.geometry.ring";
    Err(Fault::at("heat.counterface", "not-available", message, remedy))
}
