//! Bodies that spin: their densities, and that they spin about their centre of mass.

use meshing::{Body, mass_centre};
use scene::{Document, Fault, Geometry, Length, Scene, missing, positive};

use crate::setup::materials::for_each_material;

/// How far a body may spin off its centre of mass, over its size.
const BALANCED: f64 = 1e-9;

/// Takes out the densities that come with the names of materials of bodies that do not spin; gives the keys of those that were written.
pub(super) fn begin(document: &Document, scene: &mut Scene) -> Vec<String> {
    let mut unused = Vec::new();
    for (name, body) in [("body1", &mut scene.body1), ("body2", &mut scene.body2)] {
        let Some(body) = body else { continue };
        if body.spin.is_some() {
            continue;
        }
        for_each_material(body, &mut |place, material| {
            let key = format!("{name}.{place}.density");
            material.density = material.density.filter(|_| document.has(&key));
            unused.push(key);
        });
    }
    unused
}

/// The point about which a body spins, checked and filled in; none of a body that does not.
pub(super) fn resolve(body: &mut scene::Body, typed: &Body, axisymmetric: bool) -> Result<Option<[f64; 2]>, Fault> {
    let Some(spin) = &mut body.spin else { return Ok(None) };
    let key = format!("{}.spin", typed.key);
    if axisymmetric && spin.centre.is_some() {
        let message = "an axisymmetric body spins about its axis";
        return Err(Fault::at(format!("{key}.centre"), "wrong-key", message, "leave spin.centre out"));
    }
    for (key, density) in densities(typed) {
        let Some(density) = density else {
            return Err(missing(
                &key,
                "the centrifugal force of a body that spins follows from its density",
                "density = \"7850 kg/m3\"",
            ));
        };
        positive(&key, density, "density", " t/mm^3")?;
    }
    if axisymmetric {
        return Ok(Some([0.0; 2]));
    }
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
        return Ok(Some(centre));
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
    let names: Vec<String> = match &typed.geometry {
        Geometry::Blocks(blocks) => blocks.materials.keys().map(|name| format!("geometry.blocks.materials.{name}")).collect(),
        Geometry::Mesh(_) => typed.materials.iter().map(|_| "geometry.mesh.materials".to_string()).collect(),
        Geometry::ShoeBlock(_)
        | Geometry::Ring(_)
        | Geometry::Rectangle(_)
        | Geometry::RingSegment(_)
        | Geometry::HalfDisc(_) => Vec::new(),
    };
    let used = |index: usize| typed.cells.as_ref().is_none_or(|mesh| mesh.cells.iter().any(|cell| cell.material == index));
    let materials = typed.materials.iter().enumerate().filter(|(index, _)| used(*index));
    let named = |(index, material): (usize, &scene::Material)| {
        let place = names.get(index).map_or("material", String::as_str);
        (format!("{}.{place}.density", typed.key), material.density.map(|density| density.0))
    };
    materials.map(named).collect()
}

/// Angular speeds of both bodies (rad/s).
pub(super) fn speeds(scene: &Scene) -> [f64; 2] {
    [&scene.body1, &scene.body2].map(|body| body.as_ref().and_then(|body| body.spin).map_or(0.0, |spin| spin.omega.0))
}
