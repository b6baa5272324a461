//! Loads inside cells, body forces, eigenstrains and forces at points: their load on the boundary of a cell with its interior
//! condensed, and their part of the interior displacement.
//!
//! With `L_11 L_11^T = K_ii` and `y = L_11^-1 f_i`, the condensed load is `f_b - L_21 y`, the interior displacement gains `L_11^-T y`,
//! and the work of the loads on the interior is `y . y`. An eigenstrain `eps*` is the load `int sigma* : eps(v) dV`, `sigma* = C eps*`.

use crate::assembly::Assembly;
use crate::basis::{LocalModes, points_for};
use crate::cell_point::{CellPoint, cell_rule};
use crate::element::Workspace;
use crate::error::Error;
use crate::load_case::{BodyPoint, Load};
use crate::point_load::{PlaneJet, PointLoad, Rows};
use crate::tensor_load::Grid;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, MatMut, MatRef, Par};

/// Load inside one cell.
pub(crate) struct InnerLoad {
    /// `((local boundary unknown, column), value)`.
    pub(crate) boundary: Vec<((usize, usize), f64)>,
    /// `y_k . y_l` for load cases k, l.
    pub(crate) work: Mat<f64>,
    /// Interior displacement with the boundary held, unknowns as in the local order, one column a load case.
    pub(crate) interior: Mat<f64>,
}

/// A strain alike in all directions by the modes of a cell, in the numbering of [`CellPoint::modes`], and a constant part.
pub(crate) type ModeStrain = (Vec<f64>, f64);

/// A point of integration in a triangle.
struct Weighted {
    reference: [f64; 2],
    /// The part of the volume that it stands for.
    volume: f64,
    jets: Vec<PlaneJet>,
    point: CellPoint,
}

/// Points of a direction beyond the degree of a cell: values are needed beyond the element's own rule, loads are no polynomials.
const MORE_POINTS: usize = 6;

/// A unit strain alike in all directions.
const ALIKE: [f64; 4] = [1.0, 1.0, 0.0, 1.0];

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
            let known = self.strains_in_modes(cell, local.position.len());
            let strains: Vec<&ModeStrain> = known.iter().flatten().collect();
            let by_strains = self.strain_columns(cell, local, &strains);
            let of_strains = self.loads.volume.iter().zip(&known).filter(|(_, known)| known.is_some());
            for (k, ((case, _), _)) in of_strains.enumerate() {
                let column = load.col_as_slice_mut(*case).iter_mut().zip(by_strains.col_as_slice(k));
                column.for_each(|(sum, one)| *sum += one);
            }
            self.add_volume_loads(cell, rows, &known, &mut load);
        }
        for force in self.loads.points.get(&cell).into_iter().flatten() {
            let point = CellPoint::new(self.mesh, cell, degree, force.reference[0], force.reference[1]);
            let factors = force.force.map(|f| [f / self.unit, 0.0, 0.0]);
            rows.add(load.col_as_slice_mut(force.case), &rows.jets(&point), &factors);
        }
        load
    }

    /// Adds the loads per volume that are no strains known by the modes of the cell.
    fn add_volume_loads(&self, cell: usize, rows: Rows<'_>, known: &[Option<ModeStrain>], load: &mut Mat<f64>) {
        let others: Vec<&(usize, &Load)> =
            self.loads.volume.iter().zip(known).filter(|(_, known)| known.is_none()).map(|(load, _)| load).collect();
        if others.is_empty() {
            return;
        }
        if self.mesh.cells[cell].is_triangle() {
            for Weighted { reference, volume, jets, point } in self.triangle_points(cell, rows) {
                for (case, volume_load) in &others {
                    let factors = self.point_load(cell, reference, point.position, volume_load).map(|f| f.map(|f| f * volume));
                    rows.add(load.col_as_slice_mut(*case), &jets, &factors);
                }
            }
            return;
        }
        let degree = self.space.cell_degree[cell];
        let grid = Grid::new(self, cell, degree, degree + MORE_POINTS);
        let ones = vec![1.0; grid.len()];
        for (case, volume_load) in others {
            let at = |q: usize| self.point_load(cell, grid.reference(q), grid.position(q), volume_load);
            let loads: Vec<PointLoad> = (0..grid.len()).map(at).collect();
            grid.add(rows, &grid.densities(rows.components, &loads), &ones, load.col_as_slice_mut(*case));
        }
    }

    fn triangle_points(&self, cell: usize, rows: Rows<'_>) -> Vec<Weighted> {
        let degree = self.space.cell_degree[cell];
        let weighted = |(reference, weight): ([f64; 2], f64)| {
            let point = CellPoint::new(self.mesh, cell, degree, reference[0], reference[1]);
            let volume = weight * point.jacobian() * self.kinematics.measure(point.position[0]);
            Weighted { reference, volume, jets: rows.jets(&point), point }
        };
        cell_rule(true, degree + MORE_POINTS).into_iter().map(weighted).collect()
    }

    /// Of each load inside cells the strain by so many modes of a cell, where it is known so.
    fn strains_in_modes(&self, cell: usize, modes: usize) -> Vec<Option<ModeStrain>> {
        let material = self.mesh.cells[cell].material;
        let known = |load: &Load| match load {
            Load::Eigenstrain(eigen) => eigen.in_modes.as_ref().and_then(|strain| strain(cell, material, modes)),
            Load::BodyForce(_) | Load::Traction(_) | Load::PointForce(_) => None,
        };
        self.loads.volume.iter().map(|(_, load)| known(load)).collect()
    }

    /// Loads of strains alike in all directions that are known by the modes of a cell, on its unsigned modes, a column each.
    pub(crate) fn strain_columns(&self, cell: usize, local: &LocalModes, strains: &[&ModeStrain]) -> Mat<f64> {
        let rows = Rows { components: self.space.components, local };
        let mut load = Mat::<f64>::zeros(rows.components * local.modes, strains.len());
        if strains.is_empty() {
            return load;
        }
        if !self.mesh.cells[cell].is_triangle() {
            // They are polynomials: the rule of the element, by which an even strain of a free body causes no stress.
            let degree = self.space.cell_degree[cell];
            let grid = Grid::new(self, cell, degree, points_for(degree));
            let unit = |q: usize| self.strain_load(self.mesh.cells[cell].material, grid.position(q)[0], ALIKE);
            let loads: Vec<PointLoad> = (0..grid.len()).map(unit).collect();
            let densities = grid.densities(rows.components, &loads);
            for (k, (modes, constant)) in strains.iter().enumerate() {
                let mut values = grid.values(modes);
                values.iter_mut().for_each(|value| *value += constant);
                grid.add(rows, &densities, &values, load.col_as_slice_mut(k));
            }
            return load;
        }
        let coefficients = Mat::from_fn(local.position.len(), strains.len(), |m, k| strains[k].0[m]);
        let constants: Vec<f64> = strains.iter().map(|(_, constant)| *constant).collect();
        self.triangle_strains(cell, rows, coefficients.as_ref(), &constants)
    }

    /// Writes those of many strains without constant parts, by their coefficients one after the other, to `load`.
    pub(crate) fn strain_matrix(
        &self,
        (cell, local): (usize, &LocalModes),
        coefficients: &[f64],
        sums: &mut [Vec<f64>; 5],
        load: &mut Vec<f64>,
    ) {
        let rows = Rows { components: self.space.components, local };
        let (height, many) = (rows.components * local.modes, coefficients.len() / local.position.len());
        load.resize(height * many, 0.0);
        if self.mesh.cells[cell].is_triangle() {
            let coefficients = MatRef::from_column_major_slice(coefficients, local.position.len(), many);
            let strains = self.triangle_strains(cell, rows, coefficients, &vec![0.0; many]);
            MatMut::from_column_major_slice_mut(load, height, many).copy_from(&strains);
            return;
        }
        let degree = self.space.cell_degree[cell];
        let grid = Grid::new(self, cell, degree, points_for(degree));
        let unit = |q: usize| self.strain_load(self.mesh.cells[cell].material, grid.position(q)[0], ALIKE);
        let loads: Vec<PointLoad> = (0..grid.len()).map(unit).collect();
        grid.by_modes(rows, &grid.densities(rows.components, &loads), (coefficients, load), sums);
    }

    /// Loads of strains alike in all directions on a triangle: three products of matrices for all of them.
    fn triangle_strains(&self, cell: usize, rows: Rows<'_>, coefficients: MatRef<'_, f64>, constants: &[f64]) -> Mat<f64> {
        let points = self.triangle_points(cell, rows);
        let values = Mat::from_fn(points.len(), coefficients.nrows(), |q, m| points[q].point.modes[m][0]);
        let mut at_points = Mat::from_fn(points.len(), constants.len(), |_, k| constants[k]);
        matmul(at_points.as_mut(), Accum::Add, values.as_ref(), coefficients, 1.0, Par::Seq);
        let mut by_strain = Mat::<f64>::zeros(rows.components * rows.local.modes, points.len());
        for (q, Weighted { volume, jets, point, .. }) in points.iter().enumerate() {
            let factors = self.strain_load(self.mesh.cells[cell].material, point.position[0], ALIKE);
            rows.add(by_strain.col_as_slice_mut(q), jets, &factors.map(|f| f.map(|f| f * volume)));
        }
        let mut load = Mat::<f64>::zeros(by_strain.nrows(), constants.len());
        matmul(load.as_mut(), Accum::Replace, by_strain.as_ref(), at_points.as_ref(), 1.0, Par::Seq);
        load
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
    fn point_load(&self, cell: usize, reference: [f64; 2], position: [f64; 2], load: &Load) -> PointLoad {
        let material = self.mesh.cells[cell].material;
        match load {
            Load::BodyForce(body) => body.at(position, material).map(|f| [f / self.unit, 0.0, 0.0]),
            Load::Eigenstrain(eigen) => {
                let strain = (eigen.strain)(&BodyPoint { cell, reference, position, material });
                // A component that the kinematics leaves out is read by fields.
                if strain.iter().any(|v| !v.is_finite()) {
                    return [[f64::NAN; 3]; 2];
                }
                self.strain_load(material, position[0], strain)
            }
            Load::Traction(_) | Load::PointForce(_) => [[0.0; 3]; 2],
        }
    }
}
