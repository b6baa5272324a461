//! Bodies: kinematics, thickness, material, geometry, supports, contact edges.

use std::sync::Arc;

use meshing::{Body, BodyLoad, Files, outline, outside, read_cells, sound, sound_body_loads, sound_material};
use scene::{Component, Fault, Kinematics, Scene, Support, did_you_mean, missing, positive};

use crate::setup::materials::compressible;
use crate::setup::{one_way, start_gap};

/// Checks both bodies and the contact, and fills in their defaults. None of a surface alone.
pub(super) fn resolve(scene: &mut Scene, files: Files<'_>) -> Result<Option<(hpfem::Kinematics, [Body; 2])>, Fault> {
    friction(scene)?;
    if scene.surface.is_some() {
        return Ok(None);
    }
    let axisymmetric = match scene.kinematics {
        Some(kinematics) => kinematics == Kinematics::Axisymmetric,
        None => {
            let why = "two bodies need their kinematics";
            return Err(missing("kinematics", why, "kinematics = \"plane-stress\""));
        }
    };
    if !axisymmetric {
        let Some(thickness) = scene.thickness else {
            return Err(missing("thickness", "plane bodies need a thickness", "thickness = 10"));
        };
        positive("thickness", thickness.0, "thickness", " mm")?;
    }
    let names = ["body1", "body2"];
    let mut bodies = Vec::new();
    for (name, body) in names.iter().zip([&mut scene.body1, &mut scene.body2]) {
        let Some(body) = body else {
            let why = "a scene has two bodies, or a `surface` alone";
            return Err(missing(name, why, &format!("{name}.geometry.rectangle = {{ x = [-30, 30], z = [0, 100] }}")));
        };
        bodies.push(one_body(name, body, axisymmetric, files)?);
        if scene.kinematics != Some(Kinematics::PlaneStress) {
            compressible(name, body)?;
        }
    }
    contact_edges(scene, &mut bodies, files)?;
    let thickness = scene.thickness.map_or(1.0, |thickness| thickness.0);
    let kinematics = match scene.kinematics {
        Some(Kinematics::PlaneStrain) => hpfem::Kinematics::PlaneStrain { thickness },
        Some(Kinematics::Axisymmetric) => hpfem::Kinematics::Axisymmetric,
        Some(Kinematics::PlaneStress) | None => hpfem::Kinematics::PlaneStress { thickness },
    };
    Ok(<[Body; 2]>::try_from(bodies).ok().map(|bodies| (kinematics, bodies)))
}

fn friction(scene: &mut Scene) -> Result<(), Fault> {
    let contact = scene.contact.get_or_insert_default();
    let friction = *contact.friction.get_or_insert(0.0);
    if !friction.is_finite() || friction < 0.0 {
        let what = if friction < 0.0 { "negative friction" } else { "no coefficient of friction" };
        let message = format!("{what}: contact.friction = {friction}");
        let remedy = "give a coefficient of friction of 0 or more; the sense of sliding is the sign of `sliding`";
        return Err(Fault::at("contact.friction", "wrong-value", message, remedy));
    }
    contact.shear.get_or_insert(true);
    Ok(())
}

fn one_body(name: &'static str, body: &mut scene::Body, axisymmetric: bool, files: Files<'_>) -> Result<Body, Fault> {
    sound(name, &mut body.geometry, axisymmetric)?;
    match body.material {
        Some(material) => sound_material(&format!("{name}.material"), material)?,
        None => {
            let geometry = &body.geometry;
            let of_blocks = geometry.blocks().is_some_and(|blocks| blocks.cells.values().all(|cell| cell.material.is_some()));
            // The groups of the file say below whether one is missing.
            let of_file = geometry.mesh().is_some_and(|file| !file.materials.is_empty());
            if !of_blocks && !of_file {
                let example = format!("{name}.material = {{ young = \"210 GPa\", poisson = 0.3 }}");
                return Err(missing(&format!("{name}.material"), "every body needs one", &example));
            }
        }
    }
    let given = read_cells(name, body, files)?;
    if let Some(given) = &given {
        on_axis_side(name, &given.mesh, axisymmetric)?;
    }
    let (cells, materials) = match given {
        Some(given) => (Some(Arc::new(given.mesh)), given.materials),
        None => (None, body.material.into_iter().collect()),
    };
    let (geometry, supports) = (body.geometry.clone(), body.support.clone());
    let mut typed = Body { key: name, geometry, cells, materials, supports, contact: String::new(), loads: Vec::new() };
    held_edges(name, body, &typed, axisymmetric)?;
    sound_body_loads(body, &typed, axisymmetric)?;
    typed.loads = BodyLoad::of(body).into_iter().map(|(load, _)| load).collect();
    Ok(typed)
}

/// Checks the edges that are held, and by which components.
fn held_edges(name: &str, body: &scene::Body, typed: &Body, axisymmetric: bool) -> Result<(), Fault> {
    let outline = outline(typed);
    let edges = outline.names(true);
    one_way::supports(name, body, axisymmetric)?;
    for (edge, support) in &body.support {
        let key = format!("{name}.support.{edge}");
        known_edge(&key, edge, &edges)?;
        off_axis(&key, edge, &outline.points(edge), axisymmetric)?;
        let Support::Components(components) = support else { continue };
        if components.is_empty() {
            let message = format!("{key} holds nothing");
            return Err(Fault::at(key, "wrong-value", message, "write the components held, as in [\"x\", \"z\"]"));
        }
        if components.contains(&Component::Phi) && !axisymmetric {
            let message = format!("{key}: \"phi\" is a component of axisymmetric bodies");
            return Err(Fault::at(key, "wrong-value", message, "write \"x\" or \"z\" here"));
        }
    }
    Ok(())
}

/// Refuses an edge on the axis of revolution.
pub(super) fn off_axis(key: &str, edge: &str, points: &[[f64; 2]], axisymmetric: bool) -> Result<(), Fault> {
    let size = points.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
    if !axisymmetric || points.is_empty() || points.iter().any(|x| x[0].abs() > 1e-12 * size) {
        return Ok(());
    }
    let message = format!("the edge `{edge}` lies on the axis of revolution, where it has no area: it holds and carries nothing");
    Err(Fault::at(key, "degenerate", message, "name an edge off the axis; along r the axis holds the body by itself"))
}

/// An axisymmetric body lies at r >= 0.
fn on_axis_side(name: &str, mesh: &hpfem::Mesh, axisymmetric: bool) -> Result<(), Fault> {
    let least = mesh.vertices.iter().map(|x| x[0]).fold(f64::INFINITY, f64::min);
    if !axisymmetric || least >= 0.0 {
        return Ok(());
    }
    let message = format!("an axisymmetric body reaches to r = {least}");
    Err(Fault::at(format!("{name}.geometry"), "degenerate", message, "give it points with x >= 0 only"))
}

/// Refuses an edge that the body does not have.
pub(super) fn known_edge(key: &str, edge: &str, edges: &[String]) -> Result<(), Fault> {
    if edges.iter().any(|known| known == edge) {
        return Ok(());
    }
    let known: Vec<&str> = edges.iter().map(String::as_str).collect();
    Err(Fault::at(key, "unknown-edge", format!("there is no edge `{edge}` here"), did_you_mean(edge, &known)))
}

fn contact_edges(scene: &mut Scene, bodies: &mut [Body], files: Files<'_>) -> Result<(), Fault> {
    let Some(contact) = &mut scene.contact else {
        return Ok(());
    };
    let Some(edges) = &contact.edges else {
        let why = "the scene must say which edges touch";
        return Err(missing("contact.edges", why, "contact.edges = [\"bottom\", \"top\"]"));
    };
    for (number, body) in bodies.iter().enumerate() {
        known_edge(&format!("contact.edges.{number}"), &edges[number], &outline(body).names(false))?;
    }
    for (body, edge) in bodies.iter_mut().zip(edges) {
        outside(body, edge)?;
        body.contact.clone_from(edge);
        one_way::off_contact(body)?;
    }
    start_gap::resolve(contact, files)
}
