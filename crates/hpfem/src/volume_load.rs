//! Loads inside cells, body forces, eigenstrains and forces at points: their load on the boundary of a cell with its interior
//! condensed, and their part of the interior displacement.
//!
//! With `L_11 L_11^T = K_ii` and `y = L_11^-1 f_i`, the condensed load is `f_b - L_21 y`, the interior displacement gains `L_11^-T y`,
//! and the work of the loads on the interior is `y . y`. An eigenstrain `eps*` is the load `int sigma* : eps(v) dV`, `sigma* = C eps*`.

use crate::assembly::Assembly;
use crate::basis::LocalModes;
use crate::cell_point::{CellPoint, cell_rule};
use crate::element::Workspace;
use crate::error::Error;
use crate::load_case::{BodyPoint, Load};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Mat, Par};

/// Load inside one cell.
pub(crate) struct InnerLoad {
    /// `((local boundary unknown, column), value)`.
    pub(crate) boundary: Vec<((usize, usize), f64)>,
    /// `y_k . y_l` for load cases k, l.
    pub(crate) work: Mat<f64>,
    /// Interior displacement with the boundary held, unknowns as in the local order, one column a load case.
    pub(crate) interior: Mat<f64>,
}

/// What a load at a point contributes to the rows of each component: factors of the value of a mode and of its two derivatives.
type PointLoad = [[f64; 3]; 2];

impl Assembly<'_> {
    /// The load inside a cell; the cell is condensed for it once more.
    pub(crate) fn inner_load(&self, cell: usize, work: &mut Workspace) -> Result<InnerLoad, Error> {
        let local = self.space.local_modes(self.mesh, cell);
        let components = self.space.components;
        let cases = self.loads.cases;
        let (ni, nb) = (local.interior, local.modes - local.interior);
        let mut load = self.load_on_modes(cell, &local);
        let (k, interior_size) = self.condensed(cell, &local, work)?;
        let (l11, l21) = k.as_ref().subcols(0, interior_size).split_at_row(interior_size);
        let (mut y, boundary) = load.as_mut().split_at_row_mut(interior_size);
        solve_lower_triangular_in_place(l11, y.as_mut(), Par::Seq);
        let boundary = boundary - l21.get(..components * nb, ..) * y.as_ref();
        let energy = y.as_ref().transpose() * y.as_ref();
        solve_upper_triangular_in_place(l11.transpose(), y.as_mut(), Par::Seq);
        let interior = Mat::from_fn(interior_size, cases, |i, k| y[((i % components) * ni + i / components, k)]);
        let sign = local.signs();
        let mut loads = Vec::new();
        for (mode, sign) in sign[ni..].iter().enumerate() {
            for c in 0..components {
                loads.extend((0..cases).map(|k| ((components * mode + c, k), sign * boundary[(c * nb + mode, k)])));
            }
        }
        Ok(InnerLoad { boundary: loads, work: energy, interior })
    }

    /// Loads on the unsigned modes of a cell, one column a load case, rows as in the condensed matrix: interior first, one component
    /// after the other.
    pub(crate) fn load_on_modes(&self, cell: usize, local: &LocalModes) -> Mat<f64> {
        let (components, degree) = (self.space.components, self.space.cell_degree[cell]);
        let (ni, nb) = (local.interior, local.modes - local.interior);
        let row = |mode: usize, c: usize| if mode < ni { c * ni + mode } else { components * ni + c * nb + mode - ni };
        let mut load = Mat::<f64>::zeros(components * local.modes, self.loads.cases);
        // Values and derivatives in the plane of every mode at a point, once for all load cases.
        let jets = |point: &CellPoint| -> Vec<(usize, [f64; 3])> {
            let [[xx, xe], [zx, ze]] = point.derivative;
            let jacobian = point.jacobian();
            let modes = point.modes.iter().zip(&local.position).filter(|(_, m)| **m != usize::MAX);
            let plane = |jet: &[f64; 3]| {
                let dx = (jet[1] * ze - jet[2] * zx) / jacobian;
                let dz = (jet[2] * xx - jet[1] * xe) / jacobian;
                [jet[0], dx, dz]
            };
            modes.map(|(jet, mode)| (*mode, plane(jet))).collect()
        };
        let mut add = |case: usize, jets: &[(usize, [f64; 3])], factors: &PointLoad| {
            let column = load.col_as_slice_mut(case);
            for (mode, [value, dx, dz]) in jets {
                for (c, f) in factors.iter().enumerate().take(components) {
                    column[row(*mode, c)] += f[0] * value + f[1] * dx + f[2] * dz;
                }
            }
        };
        if !self.loads.volume.is_empty() {
            // Values are needed beyond the element's own rule: loads are no polynomials.
            for ([xi, eta], weight) in cell_rule(self.mesh.cells[cell].is_triangle(), degree + 6) {
                let point = CellPoint::new(self.mesh, cell, degree, xi, eta);
                let volume = weight * point.jacobian() * self.kinematics.measure(point.position[0]);
                let jets = jets(&point);
                for (case, load) in &self.loads.volume {
                    add(*case, &jets, &self.point_load(cell, [xi, eta], &point, load).map(|f| f.map(|f| f * volume)));
                }
            }
        }
        for force in self.loads.points.get(&cell).into_iter().flatten() {
            let point = CellPoint::new(self.mesh, cell, degree, force.reference[0], force.reference[1]);
            add(force.case, &jets(&point), &force.force.map(|f| [f / self.unit, 0.0, 0.0]));
        }
        load
    }

    /// A load per volume at a point of a cell.
    fn point_load(&self, cell: usize, reference: [f64; 2], point: &CellPoint, load: &Load) -> PointLoad {
        let material = self.mesh.cells[cell].material;
        match load {
            Load::BodyForce(body) => (body.force)(point.position).map(|f| [f / self.unit, 0.0, 0.0]),
            Load::Eigenstrain(eigen) => {
                let near = eigen.at_modes.as_ref().and_then(|at| at(cell, material, point));
                let at = || (eigen.strain)(&BodyPoint { cell, reference, position: point.position, material });
                let strain = near.unwrap_or_else(at);
                let s = self.moduli[material].stress(strain, self.kinematics);
                let hoop = if self.kinematics.has_hoop_strain() { 1.0 / point.position[0] } else { 0.0 };
                match self.kinematics.components() {
                    1 => [[-hoop * s[0], s[0], s[1]], [0.0; 3]],
                    _ => [[hoop * s[3], s[0], s[2]], [0.0, s[2], s[1]]],
                }
            }
            Load::Traction(_) | Load::PointForce(_) => [[0.0; 3]; 2],
        }
    }
}
