//! What is known of a body that is given by its cells, and where its file comes from.

use hpfem::Mesh;
use scene::Material;

/// The cells of a body as they are written; the boundaries of the mesh are the named edges.
#[derive(Debug, Clone)]
pub struct Given {
    /// The cells.
    pub mesh: Mesh,
    /// Materials, by the index that cells have.
    pub materials: Vec<Material>,
}

/// Where files beside the scene come from: a path as the scene has it, to bytes or to why not.
pub type Files<'f> = &'f dyn Fn(&str) -> Result<Vec<u8>, String>;
