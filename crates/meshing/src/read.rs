//! The cells of a body from `geometry.blocks` or `geometry.mesh`.

use scene::{Fault, Geometry};

use crate::given::{Files, Given};
use crate::{blocks, gmsh_file};

/// The cells of a body (`key` is "body1" or "body2"); none of a template. A mesh file is read through `files` once: from then on the scene
/// holds its bytes and their SHA-256, and names it `key`.msh.
///
/// # Errors
/// The fault of the key below `key`.geometry that makes them degenerate, or that cannot be read.
pub fn read_cells(key: &str, body: &mut scene::Body, files: Files<'_>) -> Result<Option<Given>, Fault> {
    let own = body.material;
    if let Geometry::Blocks(blocks) = &mut body.geometry {
        return blocks::given(&format!("{key}.geometry.blocks"), blocks, own).map(Some);
    }
    if let Geometry::Mesh(file) = &mut body.geometry {
        return gmsh_file::read(key, file, files, own).map(Some);
    }
    Ok(None)
}
