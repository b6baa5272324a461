//! Cells that lie on one place without sharing it.

use crate::error::Error;
use crate::mesh::Mesh;
use crate::point_search::{CellBoxes, centre};

impl Mesh {
    /// Refuses a cell whose middle lies inside another one: bodies laid on each other unawares. Vertices and edges on one place, as in
    /// slits, are fine.
    pub(crate) fn check_overlap(&self) -> Result<(), Error> {
        let search = CellBoxes::new(self);
        let mut near = Vec::new();
        for a in 0..self.cells.len() {
            let [x, z] = centre(self, a);
            if let Some(b) = search.other_cell(self, Some(a), [x, z], &mut near) {
                return Err(Error::CellsOverlap { a, b, x, z });
            }
        }
        Ok(())
    }
}
