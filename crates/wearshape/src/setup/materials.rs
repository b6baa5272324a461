//! The materials of a body as the scene writes them.

use hpfem::MAX_POISSON;
use scene::{Axes, Fault, Material};

/// Every material of a body with its key below the body's.
pub(super) fn for_each_material(body: &mut scene::Body, act: &mut dyn FnMut(&str, &mut Material)) {
    if let Some(material) = &mut body.material {
        act("material", material);
    }
    let place = format!("geometry.{}.materials", body.geometry.name());
    for (name, material) in body.geometry.materials_mut().into_iter().flatten() {
        act(&format!("{place}.{name}"), material);
    }
}

/// Refuses a body of a material whose stiffness against a change of volume is so large that the stresses it has to stand for are round-off.
pub(super) fn compressible(name: &str, body: &mut scene::Body) -> Result<(), Fault> {
    let mut found = None;
    for_each_material(body, &mut |place, material| {
        found = found.take().or(match material.poisson {
            Axes::One(ratio) if ratio > MAX_POISSON => Some((format!("{name}.{place}.poisson"), ratio)),
            Axes::One(_) | Axes::Three(_) => None,
        });
    });
    let Some((key, ratio)) = found else { return Ok(()) };
    let message = format!("Poisson's ratio {ratio} is above {MAX_POISSON} where volume changes count");
    Err(Fault::at(key, "wrong-value", message, format!("give at most {MAX_POISSON}, or kinematics = \"plane-stress\"")))
}
