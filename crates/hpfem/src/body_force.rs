//! Forces per volume: their load on the boundary of a cell with its interior condensed, and their part of the interior displacement.
//!
//! With `L_11 L_11^T = K_ii` and `y = L_11^-1 f_i`, the condensed load is `f_b - L_21 y`, the interior displacement gains `L_11^-T y`,
//! and the work of the loads on the interior is `y . y`.

use crate::assembly::Assembly;
use crate::cell_point::{CellPoint, cell_rule};
use crate::element::Workspace;
use crate::error::Error;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Mat, Par};

/// Load of the body forces on one cell.
pub(crate) struct BodyLoad {
    /// `((local boundary unknown, column), value)`.
    pub(crate) boundary: Vec<((usize, usize), f64)>,
    /// `y_k . y_l` for load cases k, l.
    pub(crate) work: Mat<f64>,
    /// Interior displacement with the boundary held, unknowns as in the local order, one column a load case.
    pub(crate) interior: Mat<f64>,
}

impl Assembly<'_> {
    /// The load of body forces on a cell; the cell is condensed for it once more.
    pub(crate) fn body_load(&self, cell: usize, work: &mut Workspace) -> Result<BodyLoad, Error> {
        let local = self.space.local_modes(self.mesh, cell);
        let components = self.space.components;
        let degree = self.space.cell_degree[cell];
        let cases = self.load_cases.len();
        // In the order of the condensed matrix: interior first, one component after the other, unsigned.
        let (ni, nb) = (local.interior, local.modes - local.interior);
        let row = |mode: usize, c: usize| if mode < ni { c * ni + mode } else { components * ni + c * nb + mode - ni };
        let mut load = Mat::<f64>::zeros(components * local.modes, cases);
        let mut sign = vec![1.0; local.modes];
        local.position.iter().zip(&local.sign).filter(|(p, _)| **p != usize::MAX).for_each(|(p, s)| sign[*p] = *s);
        for force in self.body_forces {
            // Values are needed beyond the element's own rule: forces are no polynomials.
            for ([xi, eta], weight) in cell_rule(self.mesh.cells[cell].is_triangle(), degree + 6) {
                let point = CellPoint::new(self.mesh, cell, degree, xi, eta);
                let x = point.position;
                let volume = weight * point.jacobian() * self.kinematics.measure(x[0]) / self.unit;
                let value = (force.force)(x).map(|f| f * volume);
                for (jet, mode) in point.modes.iter().zip(&local.position).filter(|(_, m)| **m != usize::MAX) {
                    (0..components).for_each(|c| load[(row(*mode, c), force.case)] += jet[0] * value[c]);
                }
            }
        }
        let (k, interior_size) = self.condensed(cell, &local, work)?;
        let (l11, l21) = k.as_ref().subcols(0, interior_size).split_at_row(interior_size);
        let (mut y, boundary) = load.as_mut().split_at_row_mut(interior_size);
        solve_lower_triangular_in_place(l11, y.as_mut(), Par::Seq);
        let boundary = boundary - l21.get(..components * nb, ..) * y.as_ref();
        let energy = y.as_ref().transpose() * y.as_ref();
        solve_upper_triangular_in_place(l11.transpose(), y.as_mut(), Par::Seq);
        let interior = Mat::from_fn(interior_size, cases, |i, k| y[((i % components) * ni + i / components, k)]);
        let mut loads = Vec::new();
        for (mode, sign) in sign[ni..].iter().enumerate() {
            for c in 0..components {
                loads.extend((0..cases).map(|k| ((components * mode + c, k), sign * boundary[(c * nb + mode, k)])));
            }
        }
        Ok(BodyLoad { boundary: loads, work: energy, interior })
    }
}
