//! An orthotropic body 2 that turns would meet body 1 with another stiffness at every angle.

use meshing::Couple;
use scene::{Fault, Scene};

use crate::surface::{Patch, PatchKind};

/// Refuses a body 2 that turns in the plane and whose axes turn with it.
pub(super) fn check(scene: &Scene, couple: &Couple, patch: Option<&Patch>) -> Result<(), Fault> {
    let turns = scene.sliding.as_ref().is_some_and(|sliding| sliding.omega.is_some_and(|omega| omega.0 != 0.0));
    let turns = turns && patch.is_some_and(|patch| patch.kind == PatchKind::Turning);
    let second = &couple.bodies[1];
    if !turns || !second.materials.iter().any(scene::Material::is_orthotropic) {
        return Ok(());
    }
    let message =
        "body 2 turns, and the axes of its orthotropic material with it: its stiffness at the contact would change all the time";
    Err(Fault::at(
        "body2.material",
        "not-available",
        message,
        "give body 2 an isotropic material, or compute one position by tasks = [\"contact\"] without sliding",
    ))
}
