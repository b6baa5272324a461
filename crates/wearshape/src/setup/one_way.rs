//! Pins and rollers of body 1 and what presses it then: what may stand beside what.

use std::f64::consts::FRAC_PI_2;

use meshing::{Body, Couple, outline};
use scene::{Balance, Fault, Geometry, Load, LoadKind, Scene, Support, Task, missing};
use wear::Shape;

use crate::one_way::opens_a_part;
use crate::surface::Patch;

/// Refuses pins and rollers where they cannot be.
pub(super) fn supports(name: &str, body: &scene::Body, axisymmetric: bool) -> Result<(), Fault> {
    let mut pinned: Option<&str> = None;
    for (edge, support) in &body.support {
        let word = match support {
            Support::Components(_) => continue,
            Support::Pin(_) => "pin",
            Support::Roller(_) => "roller",
        };
        let key = format!("{name}.support.{edge}");
        if axisymmetric {
            let message = format!("{key}: a {word} holds a plane body, and this one is of revolution");
            return Err(Fault::at(key, "not-available", message, "write the components held, as in [\"z\", \"phi\"]"));
        }
        if name == "body2" {
            let message = format!("{key}: a {word} guides body 1, and body 2 is held by its supports");
            return Err(Fault::at(key, "not-available", message, "write the components held, as in [\"x\", \"z\"]"));
        }
        point_of_blocks(&key, edge, &body.geometry)?;
        let other = if matches!(support, Support::Pin(_)) { pinned.replace(edge) } else { None };
        if let Some(other) = other {
            let message = format!("two pins, on `{other}` and on `{edge}`: a body on two pins does not turn");
            return Err(Fault::at(
                key,
                "two-alternatives",
                message,
                "keep one pin; edges that turn together are one edge of several curves",
            ));
        }
    }
    Ok(())
}

/// Refuses a bare point of the body.
fn point_of_blocks(key: &str, name: &str, geometry: &Geometry) -> Result<(), Fault> {
    let Geometry::Blocks(blocks) = geometry else { return Ok(()) };
    if !blocks.points.contains_key(name) || blocks.edges.contains_key(name) {
        return Ok(());
    }
    let message = format!(
        "`{name}` is a point: a continuum moves without bound under a force on a point, so that nothing can turn about it"
    );
    let remedy = "name an edge that turns as a rigid line: the bore of the pin, or the line where the shoe meets its anchor";
    Err(Fault::at(key, "wrong-value", message, remedy))
}

/// Refuses a pin or a roller on an edge that touches body 2, and a pin on one that meets it: the ends of contact would turn too.
pub(super) fn off_contact(body: &Body) -> Result<(), Fault> {
    let outline = outline(body);
    for (edge, support) in &body.supports {
        let (word, remedy) = match support {
            Support::Components(_) => continue,
            Support::Pin(_) => ("pin", "name another edge of body 1, which turns about the pin"),
            Support::Roller(_) => ("roller", "name another edge of body 1, which runs on the roller"),
        };
        let key = format!("{}.support.{edge}", body.key);
        if *edge == body.contact {
            let message = format!("the edge `{edge}` touches body 2: a {word} cannot hold it too");
            return Err(Fault::at(key, "wrong-value", message, remedy));
        }
        if let Support::Roller(angle) = support {
            inclined(angle.0, &key)?;
            continue;
        }
        let [own, touching] = [edge, &body.contact].map(|name| ends(body, &outline.points(name), name));
        let near = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) <= 1e-9 * (a[0].hypot(a[1]) + b[0].hypot(b[1]));
        if let Some([x, z]) = own.iter().find(|a| touching.iter().any(|b| near(a, b))) {
            let message = format!(
                "the edge `{edge}` meets the contact edge `{}` at x = {x}, z = {z}: a {word} cannot hold it there",
                body.contact
            );
            return Err(Fault::at(key, "wrong-value", message, "leave a free edge between it and the contact"));
        }
    }
    Ok(())
}

/// Refuses a roller on a plane that is inclined by more than a right angle.
fn inclined(angle: f64, key: &str) -> Result<(), Fault> {
    if angle.abs() <= FRAC_PI_2 {
        return Ok(());
    }
    let message = format!("roller = {angle} rad is no inclination: a plane is inclined by a right angle at most");
    Err(Fault::at(key, "wrong-value", message, "a bare number is in rad: write degrees as in roller = \"30 deg\""))
}

/// Corners of an edge: vertices of the mesh, or the ends of a template's edge.
fn ends(body: &Body, points: &[[f64; 2]], edge: &str) -> Vec<[f64; 2]> {
    let Some(mesh) = &body.cells else { return points.first().into_iter().chain(points.last()).copied().collect() };
    let edges = mesh.boundary(edge).unwrap_or_default();
    edges.into_iter().flat_map(|e| mesh.edges[e].vertices.map(|v| mesh.vertices[v])).collect()
}

/// Whether a moment about the pin presses body 1, and no force of an actuator.
pub(super) fn by_moment(load: &Load, body: &Body) -> Result<bool, Fault> {
    let pinned = body.pin().is_some();
    if load.kind == Some(LoadKind::Rigid) {
        let word = if pinned { "a pin" } else { "a roller" };
        let message = format!("load.as = \"rigid\" moves its edge along z, and {word} guides body 1 otherwise");
        let remedy = match pinned {
            true => {
                "write load = { moment = \"400 N m\" } for a moment about the pin, or as = \"pressure\" for an actuator on the edge"
            }
            false => "write load.as = \"pressure\", \"vertical\" or \"traction\"",
        };
        return Err(Fault::at("load.as", "two-alternatives", message, remedy));
    }
    let Some(moment) = load.moment.filter(|_| pinned) else { return Ok(false) };
    if load.force.is_some() {
        let message = "both a moment about the pin and the force of an actuator are given: load.moment and load.force";
        return Err(Fault::at(
            "load.moment",
            "two-alternatives",
            message,
            "keep one: the moment follows from the force and its edge",
        ));
    }
    if let Some(key) = [("load.edge", load.edge.is_some()), ("load.as", load.kind.is_some())].iter().find(|(_, given)| *given) {
        let message = format!("{} belongs to the force of an actuator, and a moment about the pin is given", key.0);
        return Err(Fault::at(key.0, "two-alternatives", message, "leave it out, or give load.force instead of load.moment"));
    }
    if moment.0 == 0.0 {
        let remedy = "give a moment about the pin, anti-clockwise positive, as in load.moment = \"400 N m\"";
        return Err(Fault::at("load.moment", "wrong-value", "load.moment = 0: nothing presses body 1 on body 2", remedy));
    }
    Ok(true)
}

/// Checks the direction of a traction.
pub(super) fn direction(load: &Load, body: &Body) -> Result<(), Fault> {
    if load.kind != Some(LoadKind::Traction) {
        return Ok(());
    }
    if !body.moves_one_way() {
        let message = "load.as = \"traction\" presses a body 1 on a pin or a roller; this one is pressed downwards";
        return Err(Fault::at("load.as", "not-available", message, "write load.as = \"pressure\", \"vertical\" or \"rigid\""));
    }
    match load.direction {
        Some(_) => Ok(()),
        None => Err(missing("load.direction", "a traction needs its direction", "load.direction = \"120 deg\"")),
    }
}

/// Refuses what a pin or a roller does not go with.
pub(super) fn wanted(scene: &Scene, couple: Option<&Couple>, patch: Option<&Patch>) -> Result<(), Fault> {
    let Some(couple) = couple.filter(|couple| couple.moves_one_way()) else { return Ok(()) };
    let optimum = scene.optimum.clone().unwrap_or_default();
    let optimal = scene.tasks.iter().flatten().any(|task| matches!(task, Task::Pressure | Task::Shape));
    if optimal && optimum.balance == Some(Balance::Paper) {
        let message = "optimum.balance = \"paper\" is the normalisation of a body pressed downwards, and this one is guided by a pin or a roller";
        return Err(Fault::at("optimum.balance", "not-available", message, "write optimum.balance = \"equilibrium\""));
    }
    if couple.load.kind != LoadKind::Rigid && couple.unit_load().is_none() {
        let message = format!("the load on `{}` has no resultant force", couple.load.edge);
        return Err(Fault::at(
            "load.edge",
            "wrong-value",
            message,
            "load an open edge, or write load.as = \"traction\" with load.direction",
        ));
    }
    if let (Some((edge, at)), Some(patch)) = (couple.bodies[0].pin(), patch)
        && on_surface(patch, at)
    {
        let [x, z] = at;
        let message = format!("the pin at ({x}, {z}) lies on the contact surface, which does not close there");
        return Err(Fault::at(
            format!("body1.support.{edge}.pin"),
            "wrong-value",
            message,
            "place the pin off the contact surface",
        ));
    }
    let shaped = scene.tasks.iter().flatten().any(|task| *task == Task::Shape);
    if shaped && patch.is_some_and(|patch| opens_a_part(couple, patch)) {
        let message = "the motion that is left to body 1 closes part of the contact and opens another, which carries nothing once worn in: no shape touches everywhere";
        let remedy = match couple.bodies[0].pin() {
            Some(_) => "place the pin beyond the ends of the contact, or ask for tasks = [\"pressure\"] or [\"contact\"]",
            None => "turn the roller until all of the contact closes, or ask for tasks = [\"pressure\"] or [\"contact\"]",
        };
        return Err(Fault::at("body1.support", "not-available", message, remedy));
    }
    if shaped && couple.bodies[0].pin().is_some() && patch.is_some_and(|patch| patch.circles().is_some()) {
        let message =
            "body 1 on its pin and body 2 are drawn with two radii: the lever of the pressure about the pin has two values then";
        let remedy = "draw the contact of body 1 with the radius of body 2; the shape says what to take off from that";
        return Err(Fault::at("contact.edges", "not-available", message, remedy));
    }
    Ok(())
}

/// Whether a point lies on the contact surface.
fn on_surface(patch: &Patch, [x, z]: [f64; 2]) -> bool {
    let points = patch.surface.sample(401);
    let far = |p: &wear::SurfacePoint| (p.position.x - x).hypot(p.position.z - z);
    let nearest = points.iter().map(far).fold(f64::INFINITY, f64::min);
    let step = points.windows(2).map(|pair| (pair[1].position - pair[0].position).norm()).fold(0.0, f64::max);
    let off = match patch.surface.shape() {
        Shape::Arc { radius, centre, .. } => ((x - centre.x).hypot(z - centre.z) - radius).abs(),
        Shape::Strip { z: height, .. } => (z - height).abs(),
        Shape::Points(_) | Shape::Annulus { .. } | Shape::Sector { .. } | Shape::Rectangle { .. } | Shape::Ellipse { .. } => {
            nearest
        }
    };
    nearest <= step && off <= 1e-6 * step
}
