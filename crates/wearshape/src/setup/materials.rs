//! The materials of a body as the scene writes them.

use std::collections::BTreeMap;

use scene::{Geometry, Material};

/// Every material of a body with its key below the body's.
pub(super) fn for_each_material(body: &mut scene::Body, act: &mut dyn FnMut(&str, &mut Material)) {
    if let Some(material) = &mut body.material {
        act("material", material);
    }
    let (place, named) = match &mut body.geometry {
        Geometry::Blocks(blocks) => ("geometry.blocks.materials", &mut blocks.materials),
        Geometry::Mesh(file) => ("geometry.mesh.materials", &mut file.materials),
        Geometry::ShoeBlock(_)
        | Geometry::Ring(_)
        | Geometry::Rectangle(_)
        | Geometry::RingSegment(_)
        | Geometry::HalfDisc(_) => return,
    };
    for (name, material) in named {
        act(&format!("{place}.{name}"), material);
    }
}

/// The materials of cells by name; none of a template.
pub(super) fn named(geometry: &Geometry) -> Option<&BTreeMap<String, Material>> {
    match geometry {
        Geometry::Blocks(blocks) => Some(&blocks.materials),
        Geometry::Mesh(file) => Some(&file.materials),
        Geometry::ShoeBlock(_)
        | Geometry::Ring(_)
        | Geometry::Rectangle(_)
        | Geometry::RingSegment(_)
        | Geometry::HalfDisc(_) => None,
    }
}
