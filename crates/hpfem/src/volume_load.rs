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
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, Par};

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

/// Value and derivatives in the plane of a mode at a point, with its place in the local order.
type PlaneJet = (usize, [f64; 3]);

/// A point of integration in a cell.
struct Weighted {
    reference: [f64; 2],
    /// The part of the volume that it stands for.
    volume: f64,
    jets: Vec<PlaneJet>,
    point: CellPoint,
}

/// Rows of a load on the modes of a cell.
#[derive(Clone, Copy)]
struct Rows<'a> {
    components: usize,
    local: &'a LocalModes,
}

impl Rows<'_> {
    fn row(self, mode: usize, c: usize) -> usize {
        let (ni, nb) = (self.local.interior, self.local.modes - self.local.interior);
        if mode < ni { c * ni + mode } else { self.components * ni + c * nb + mode - ni }
    }

    /// Values and derivatives in the plane of every mode at a point, once for all load cases.
    fn jets(self, point: &CellPoint) -> Vec<PlaneJet> {
        let [[xx, xe], [zx, ze]] = point.derivative;
        let jacobian = point.jacobian();
        let modes = point.modes.iter().zip(&self.local.position).filter(|(_, m)| **m != usize::MAX);
        let plane = |jet: &[f64; 3]| {
            let dx = (jet[1] * ze - jet[2] * zx) / jacobian;
            let dz = (jet[2] * xx - jet[1] * xe) / jacobian;
            [jet[0], dx, dz]
        };
        modes.map(|(jet, mode)| (*mode, plane(jet))).collect()
    }

    /// Adds a load at a point to a column.
    fn add(self, column: &mut [f64], jets: &[PlaneJet], factors: &PointLoad) {
        for (mode, [value, dx, dz]) in jets {
            for (c, f) in factors.iter().enumerate().take(self.components) {
                column[self.row(*mode, c)] += f[0] * value + f[1] * dx + f[2] * dz;
            }
        }
    }
}

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
        let rows = Rows { components, local };
        let mut load = Mat::<f64>::zeros(components * local.modes, self.loads.cases);
        if !self.loads.volume.is_empty() {
            // Values are needed beyond the element's own rule: loads are no polynomials.
            let points: Vec<Weighted> = cell_rule(self.mesh.cells[cell].is_triangle(), degree + 6)
                .into_iter()
                .map(|(reference, weight)| {
                    let point = CellPoint::new(self.mesh, cell, degree, reference[0], reference[1]);
                    let volume = weight * point.jacobian() * self.kinematics.measure(point.position[0]);
                    Weighted { reference, volume, jets: rows.jets(&point), point }
                })
                .collect();
            let known = self.strains_in_modes(cell, &points);
            self.add_strains(cell, rows, &points, &known, &mut load);
            for Weighted { reference, volume, jets, point } in &points {
                for (at, (case, volume_load)) in self.loads.volume.iter().enumerate() {
                    if known[at].is_none() {
                        let factors = self.point_load(cell, *reference, point, volume_load).map(|f| f.map(|f| f * volume));
                        rows.add(load.col_as_slice_mut(*case), jets, &factors);
                    }
                }
            }
        }
        for force in self.loads.points.get(&cell).into_iter().flatten() {
            let point = CellPoint::new(self.mesh, cell, degree, force.reference[0], force.reference[1]);
            let factors = force.force.map(|f| [f / self.unit, 0.0, 0.0]);
            rows.add(load.col_as_slice_mut(force.case), &rows.jets(&point), &factors);
        }
        load
    }

    /// Of each load inside cells the strain by the modes of a cell, where it is known so.
    fn strains_in_modes(&self, cell: usize, points: &[Weighted]) -> Vec<Option<(Vec<f64>, f64)>> {
        let modes = points.first().map_or(0, |at| at.point.modes.len());
        let material = self.mesh.cells[cell].material;
        let known = |load: &Load| match load {
            Load::Eigenstrain(eigen) => eigen.in_modes.as_ref().and_then(|strain| strain(cell, material, modes)),
            Load::BodyForce(_) | Load::Traction(_) | Load::PointForce(_) => None,
        };
        self.loads.volume.iter().map(|(_, load)| known(load)).collect()
    }

    /// Adds the loads of strains alike in all directions that are known by the modes of the cell: three products of matrices for all of them.
    fn add_strains(
        &self,
        cell: usize,
        rows: Rows<'_>,
        points: &[Weighted],
        known: &[Option<(Vec<f64>, f64)>],
        load: &mut Mat<f64>,
    ) {
        let found: Vec<(usize, &(Vec<f64>, f64))> =
            self.loads.volume.iter().zip(known).filter_map(|((case, _), strain)| Some((*case, strain.as_ref()?))).collect();
        let Some((_, (modes, _))) = found.first() else { return };
        let values = Mat::from_fn(points.len(), modes.len(), |q, m| points[q].point.modes[m][0]);
        let coefficients = Mat::from_fn(modes.len(), found.len(), |m, k| found[k].1.0[m]);
        let mut strains = Mat::from_fn(points.len(), found.len(), |_, k| found[k].1.1);
        matmul(strains.as_mut(), Accum::Add, values.as_ref(), coefficients.as_ref(), 1.0, Par::Seq);
        let mut by_strain = Mat::<f64>::zeros(load.nrows(), points.len());
        for (q, Weighted { volume, jets, point, .. }) in points.iter().enumerate() {
            let factors = self.strain_load(self.mesh.cells[cell].material, point.position[0], [1.0, 1.0, 0.0, 1.0]);
            rows.add(by_strain.col_as_slice_mut(q), jets, &factors.map(|f| f.map(|f| f * volume)));
        }
        let mut loads = Mat::<f64>::zeros(load.nrows(), found.len());
        matmul(loads.as_mut(), Accum::Replace, by_strain.as_ref(), strains.as_ref(), 1.0, Par::Seq);
        for (k, (case, _)) in found.iter().enumerate() {
            load.col_as_slice_mut(*case).iter_mut().zip(loads.col_as_slice(k)).for_each(|(sum, one)| *sum += one);
        }
    }

    /// The load of an eigenstrain at a point with this x or r.
    fn strain_load(&self, material: usize, x: f64, strain: [f64; 4]) -> PointLoad {
        let s = self.moduli[material].stress(strain, self.kinematics);
        let hoop = if self.kinematics.has_hoop_strain() { 1.0 / x } else { 0.0 };
        match self.kinematics.components() {
            1 => [[-hoop * s[0], s[0], s[1]], [0.0; 3]],
            _ => [[hoop * s[3], s[0], s[2]], [0.0, s[2], s[1]]],
        }
    }

    /// A load per volume at a point of a cell.
    fn point_load(&self, cell: usize, reference: [f64; 2], point: &CellPoint, load: &Load) -> PointLoad {
        let material = self.mesh.cells[cell].material;
        match load {
            Load::BodyForce(body) => body.at(point.position, material).map(|f| [f / self.unit, 0.0, 0.0]),
            Load::Eigenstrain(eigen) => {
                let strain = (eigen.strain)(&BodyPoint { cell, reference, position: point.position, material });
                self.strain_load(material, point.position[0], strain)
            }
            Load::Traction(_) | Load::PointForce(_) => [[0.0; 3]; 2],
        }
    }
}
