//! What can be wrong with the loads of a body by its mass.

use scene::{Fault, Geometry, Length, Material, missing, positive};

use crate::body_load::BodyLoad;
use crate::couple::Body;
use crate::mass::mass_centre;

/// How far a body may spin off its centre of mass, over its size.
const BALANCED: f64 = 1e-9;

/// Checks the loads of a body and fills in their defaults: `typed` are the same body's numbers.
///
/// # Errors
/// The fault of a density that is missing, and of a load that the body cannot have.
pub fn sound_body_loads(body: &mut scene::Body, typed: &Body, axisymmetric: bool) -> Result<(), Fault> {
    if let Some(spin) = body.spin
        && axisymmetric
        && spin.centre.is_some()
    {
        let message = "an axisymmetric body spins about its axis";
        return Err(Fault::at(format!("{}.spin.centre", typed.key), "wrong-key", message, "leave spin.centre out"));
    }
    gravity(body, typed, axisymmetric)?;
    if let Some((load, _)) = BodyLoad::of(body).first() {
        dense(typed, load)?;
    }
    spin(body, typed, axisymmetric)
}

fn gravity(body: &scene::Body, typed: &Body, axisymmetric: bool) -> Result<(), Fault> {
    let Some([x, z]) = body.gravity.map(|g| g.map(|g| g.0)) else { return Ok(()) };
    let key = format!("{}.gravity", typed.key);
    if axisymmetric && x != 0.0 {
        let message = "gravity across the axis bends an axisymmetric body out of its kinematics";
        return Err(Fault::at(format!("{key}.0"), "wrong-value", message, format!("write gravity = [0, {z}]")));
    }
    if typed.key == "body1" && typed.moves_one_way() {
        let message =
            "the weight of a body 1 that turns about a pin or runs on a roller would be part of what presses it on body 2";
        return Err(Fault::at(key, "not-available", message, "add its moment to that of the load, and leave body1.gravity out"));
    }
    Ok(())
}

/// Refuses materials without a density.
fn dense(typed: &Body, load: &BodyLoad) -> Result<(), Fault> {
    for (key, density) in densities(typed) {
        let Some(density) = density else {
            let why = match load {
                BodyLoad::Spin(_) => "the centrifugal force of a body that spins follows from its density",
                BodyLoad::Gravity(_) => "the weight of a body follows from its density",
            };
            return Err(missing(&key, why, "density = \"7850 kg/m3\""));
        };
        positive(&key, density, "density", " t/mm^3")?;
    }
    Ok(())
}

/// Fills in the point about which a plane body spins; it must be its centre of mass.
fn spin(body: &mut scene::Body, typed: &Body, axisymmetric: bool) -> Result<(), Fault> {
    let Some(spin) = body.spin.as_mut().filter(|_| !axisymmetric) else { return Ok(()) };
    let key = format!("{}.spin", typed.key);
    let Some((middle, size)) = mass_centre(typed) else {
        let message = format!("{} spins, and only a ring, a rectangle or cells can spin in the plane", typed.key);
        return Err(Fault::at(key, "not-available", message, "give the body by cells (geometry.blocks), or let it stand still"));
    };
    let own = match &body.geometry {
        Geometry::Ring(_) => middle,
        _ => [0.0; 2],
    };
    let centre = spin.centre.get_or_insert(own.map(Length)).map(|x| x.0);
    let off = (centre[0] - middle[0]).hypot(centre[1] - middle[1]);
    if off <= BALANCED * size {
        return Ok(());
    }
    let [x, z] = middle;
    let message = format!(
        "{} spins about ({}, {}), {} mm off its centre of mass: its centrifugal force would not be in balance",
        typed.key,
        centre[0],
        centre[1],
        scene::short(off)
    );
    Err(Fault::at(
        format!("{key}.centre"),
        "out-of-balance",
        message,
        format!("write centre = [{x}, {z}], or give it another shape"),
    ))
}

/// Keys and values of the densities of the materials that cells have.
fn densities(typed: &Body) -> Vec<(String, Option<f64>)> {
    let of_blocks = typed.geometry.blocks().into_iter().flat_map(|blocks| blocks.materials.keys());
    let of_file = typed.geometry.mesh().into_iter().flat_map(|_| &typed.materials);
    let names: Vec<String> = of_blocks
        .map(|name| format!("geometry.blocks.materials.{name}"))
        .chain(of_file.map(|_| "geometry.mesh.materials".to_string()))
        .collect();
    let used = |index: usize| typed.cells.as_ref().is_none_or(|mesh| mesh.cells.iter().any(|cell| cell.material == index));
    let materials = typed.materials.iter().enumerate().filter(|(index, _)| used(*index));
    let named = |(index, material): (usize, &Material)| {
        let place = names.get(index).map_or("material", String::as_str);
        (format!("{}.{place}.density", typed.key), material.density.map(|density| density.0))
    };
    materials.map(named).collect()
}
