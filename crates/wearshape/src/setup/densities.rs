//! Densities of bodies on whose mass nothing acts.

use meshing::BodyLoad;
use scene::{Document, Scene};

use crate::setup::materials::for_each_material;

/// Takes out the densities that come with the names of materials of bodies without a load by their mass; gives the keys of those that were written.
pub(super) fn begin(document: &Document, scene: &mut Scene) -> Vec<String> {
    let mut unused = Vec::new();
    for (name, body) in [("body1", &mut scene.body1), ("body2", &mut scene.body2)] {
        let Some(body) = body else { continue };
        if !BodyLoad::of(body).is_empty() {
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
