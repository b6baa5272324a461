//! The materials of a body as the scene writes them.

use scene::Material;

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
