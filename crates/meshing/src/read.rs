//! The cells of a body from `geometry.blocks` or `geometry.mesh`.

use scene::{Fault, Geometry};

use crate::given::{Files, Given};
use crate::{blocks, gmsh_file};

/// The cells of a body (`key` is "body1" or "body2"); none of a template. A mesh file is read, and from then on named as its copy.
pub fn given(key: &str, body: &mut scene::Body, files: Files<'_>) -> Result<Option<Given>, Fault> {
    let own = body.material;
    match &mut body.geometry {
        Geometry::Blocks(blocks) => blocks::given(&format!("{key}.geometry.blocks"), blocks, own).map(Some),
        Geometry::Mesh(file) => gmsh_file::read(key, file, files, own).map(Some),
        _ => Ok(None),
    }
}
