//! What loads inside cells do to the boundaries of these.

use crate::mesh::Mesh;
use faer::Mat;

/// What loads inside a cell do to its boundary.
pub(crate) struct OnBoundary {
    pub(crate) cell: usize,
    /// `((local boundary unknown, load case), value)`.
    pub(crate) boundary: Vec<((usize, usize), f64)>,
    /// `y_k . y_l` for load cases k, l, as in [`InnerLoad`](crate::volume_load::InnerLoad).
    pub(crate) work: Mat<f64>,
}

/// Loads inside the cells of each class by the number of the cell; nothing of none.
pub(crate) fn by_cell(mesh: &Mesh, loads: Vec<Vec<OnBoundary>>) -> Vec<Option<OnBoundary>> {
    if loads.iter().all(Vec::is_empty) {
        return Vec::new();
    }
    let mut sorted: Vec<Option<OnBoundary>> = mesh.cells.iter().map(|_| None).collect();
    for load in loads.into_iter().flatten() {
        let cell = load.cell;
        sorted[cell] = Some(load);
    }
    sorted
}
