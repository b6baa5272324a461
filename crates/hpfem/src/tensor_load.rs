//! Loads per volume on the modes of a quadrilateral: sums over the modes of one direction after the other.
//!
//! With the shape functions `N_i` and their slopes at the points of each direction, a load `f . [phi, phi_x, phi_z]` per volume on the mode
//! `phi = N_i(xi) N_j(eta)` is `N_i G_0 N_j + N_i' G_1 N_j + N_i G_2 N_j'`, where `G_k` hold `f` on the grid of points, brought to the coordinates of the
//! cell.

use crate::assembly::Assembly;
use crate::basis::{Table, points_for, shapes_at};
use crate::element::{CellGeometry, cell_geometry};
use crate::point_load::{PointLoad, Rows};
use crate::quadrature::gauss;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par};

/// Sums of modes that go through the points at once: as many as stay near the processor.
const AT_ONCE: usize = 8;

/// The points of integration of a quadrilateral, a grid.
pub(crate) struct Grid {
    /// Reference coordinates along each direction.
    pub(crate) points: Vec<f64>,
    /// Shape functions and their slopes at the points of a direction, `points x functions`.
    shapes: [Mat<f64>; 2],
    geometry: CellGeometry,
    /// The part of the volume that each point stands for.
    pub(crate) volume: Vec<f64>,
}

impl Grid {
    /// The grid of a cell of a degree, with so many points along each direction.
    pub(crate) fn new(assembly: &Assembly<'_>, cell: usize, degree: usize, points: usize) -> Grid {
        let rule = gauss(points);
        let geometry = cell_geometry(assembly.mesh, cell, &rule.points, &rule.points);
        let known = (points == points_for(degree)).then(|| Table::of(degree).shapes.clone());
        let shapes = known.unwrap_or_else(|| shapes_at(degree, &rule.points));
        let measured = |q: usize| {
            let [[xx, xe], [zx, ze]] = geometry.derivative[q];
            let weight = rule.weights[q % points] * rule.weights[q / points];
            weight * (xx * ze - xe * zx) * assembly.kinematics.measure(geometry.position[q][0])
        };
        let volume = (0..points * points).map(measured).collect();
        Grid { points: rule.points, shapes, geometry, volume }
    }

    /// Number of points.
    pub(crate) fn len(&self) -> usize {
        self.volume.len()
    }

    /// Reference coordinates of a point.
    pub(crate) fn reference(&self, q: usize) -> [f64; 2] {
        [self.points[q % self.points.len()], self.points[q / self.points.len()]]
    }

    /// Position of a point.
    pub(crate) fn position(&self, q: usize) -> [f64; 2] {
        self.geometry.position[q]
    }

    /// Values at the points of a sum of modes, by their coefficients in the numbering of
    /// [`LocalModes::position`](crate::basis::LocalModes::position).
    pub(crate) fn values(&self, coefficients: &[f64]) -> Vec<f64> {
        let [shapes, _] = &self.shapes;
        let (nq, n) = (shapes.nrows(), shapes.ncols());
        let by_modes = faer::MatRef::from_column_major_slice(coefficients, n, n);
        let mut along = Mat::<f64>::zeros(nq, n);
        matmul(along.as_mut(), Accum::Replace, shapes.as_ref(), by_modes, 1.0, Par::Seq);
        let mut values = vec![0.0; nq * nq];
        let out = faer::MatMut::from_column_major_slice_mut(&mut values, nq, nq);
        matmul(out, Accum::Replace, along.as_ref(), shapes.transpose(), 1.0, Par::Seq);
        values
    }

    /// Loads at the points, each times its volume, in the coordinates of the cell: for each component `G_0, G_1, G_2`.
    pub(crate) fn densities(&self, components: usize, loads: &[PointLoad]) -> Vec<[Mat<f64>; 3]> {
        let nq = self.points.len();
        let of = |component: usize| {
            let mut densities = [(); 3].map(|()| Mat::<f64>::zeros(nq, nq));
            for (q, load) in loads.iter().enumerate() {
                let [[xx, xe], [zx, ze]] = self.geometry.derivative[q];
                let (volume, jacobian) = (self.volume[q], xx * ze - xe * zx);
                let [f, fx, fz] = load[component];
                let along = [f, (fx * ze - fz * xe) / jacobian, (fz * xx - fx * zx) / jacobian];
                densities.iter_mut().zip(along).for_each(|(g, value)| g.col_as_slice_mut(q / nq)[q % nq] = volume * value);
            }
            densities
        };
        (0..components).map(of).collect()
    }

    /// Writes loads with these densities times sums of modes, one after the other, by their coefficients as in [`Grid::values`]: those of several sums go
    /// through each product at once. Rows are those of the modes, a column a sum.
    pub(crate) fn by_modes(
        &self,
        rows: Rows<'_>,
        densities: &[[Mat<f64>; 3]],
        (coefficients, load): (&[f64], &mut [f64]),
        memory: &mut [Vec<f64>; 5],
    ) {
        let (n, height) = (self.shapes[0].ncols(), rows.components * rows.local.modes);
        // In the plane a strain has no part along the value, in a rectangle each component one along its own direction alone.
        let acting = |density: &Mat<f64>| (!is_zero(density)).then(|| density.transpose().to_owned());
        let densities: Vec<[Option<Mat<f64>>; 3]> = densities.iter().map(|all| all.each_ref().map(acting)).collect();
        for (sums, loads) in coefficients.chunks(AT_ONCE * n * n).zip(load.chunks_mut(AT_ONCE * height)) {
            self.few_by_modes(rows, &densities, (sums, loads), memory);
        }
    }

    /// The same, densities with a row for each point along eta and none where nothing acts.
    fn few_by_modes(
        &self,
        rows: Rows<'_>,
        densities: &[[Option<Mat<f64>>; 3]],
        (coefficients, load): (&[f64], &mut [f64]),
        memory: &mut [Vec<f64>; 5],
    ) {
        let [values, slopes] = self.shapes.each_ref().map(Mat::as_ref);
        let (nq, n) = (values.nrows(), values.ncols());
        let (many, height) = (coefficients.len() / (n * n), rows.components * rows.local.modes);
        let sizes = [n * n, nq * n, nq * n, nq * nq, nq * nq];
        memory.iter_mut().zip(sizes).for_each(|(numbers, size)| numbers.resize(size * many, 0.0));
        let [by_modes, along, turned, at_points, scaled] = memory;
        apply(values, coefficients, Accum::Replace, along);
        // Rows: points along eta. Columns: points along xi, then columns.
        transpose_blocks(along, nq, n, turned);
        apply(values, turned, Accum::Replace, at_points);
        for (component, [value, along_xi, along_eta]) in densities.iter().enumerate() {
            by_modes.fill(0.0);
            for (by_xi, parts) in [(slopes, &[(along_xi, values)][..]), (values, &[(along_eta, slopes), (value, values)])] {
                let mut accumulate = Accum::Replace;
                for (density, shapes) in parts.iter().filter_map(|(density, shapes)| Some((density.as_ref()?, shapes))) {
                    for (j, (to, from)) in scaled.chunks_exact_mut(nq).zip(at_points.chunks_exact(nq)).enumerate() {
                        let both = from.iter().zip(density.col_as_slice(j % nq));
                        to.iter_mut().zip(both).for_each(|(to, (from, g))| *to = from * g);
                    }
                    apply(shapes.transpose(), scaled, accumulate, along);
                    accumulate = Accum::Add;
                }
                if matches!(accumulate, Accum::Add) {
                    transpose_blocks(along, n, nq, turned);
                    apply(by_xi.transpose(), turned, Accum::Add, by_modes);
                }
            }
            for (modes, column) in by_modes.chunks_exact(n * n).zip(load.chunks_exact_mut(height)) {
                for (value, mode) in modes.iter().zip(&rows.local.position).filter(|(_, mode)| **mode != usize::MAX) {
                    column[rows.row(*mode, component)] = *value;
                }
            }
        }
    }

    /// Adds loads with these densities, times a factor at each point, to a column.
    pub(crate) fn add(&self, rows: Rows<'_>, densities: &[[Mat<f64>; 3]], factors: &[f64], column: &mut [f64]) {
        let [values, slopes] = &self.shapes;
        let (nq, n) = (values.nrows(), values.ncols());
        let mut scaled = Mat::<f64>::zeros(nq, nq);
        // Rows: modes along xi. Columns: points, then modes, along eta.
        let mut along = Mat::<f64>::zeros(n, nq);
        let mut sum = Mat::<f64>::zeros(n, n);
        for (component, [value, by_xi, by_eta]) in densities.iter().enumerate() {
            let mut scale = |density: &Mat<f64>, shapes: &Mat<f64>, accumulate: Accum, along: &mut Mat<f64>| {
                for (j, factors) in factors.chunks_exact(nq).enumerate() {
                    let both = density.col_as_slice(j).iter().zip(factors);
                    scaled.col_as_slice_mut(j).iter_mut().zip(both).for_each(|(out, (g, factor))| *out = g * factor);
                }
                matmul(along.as_mut(), accumulate, shapes.transpose(), scaled.as_ref(), 1.0, Par::Seq);
            };
            scale(by_xi, slopes, Accum::Replace, &mut along);
            // In the plane a strain has no part along the value.
            if !is_zero(value) {
                scale(value, values, Accum::Add, &mut along);
            }
            matmul(sum.as_mut(), Accum::Replace, along.as_ref(), values.as_ref(), 1.0, Par::Seq);
            scale(by_eta, values, Accum::Replace, &mut along);
            matmul(sum.as_mut(), Accum::Add, along.as_ref(), slopes.as_ref(), 1.0, Par::Seq);
            let modes = sum.col_iter().flat_map(|column| column.iter().copied());
            for (value, mode) in modes.zip(&rows.local.position).filter(|(_, mode)| **mode != usize::MAX) {
                column[rows.row(*mode, component)] += value;
            }
        }
    }
}

/// Whether a load is nowhere.
fn is_zero(density: &Mat<f64>) -> bool {
    density.col_iter().all(|column| column.iter().all(|v| *v == 0.0))
}

/// A matrix times one whose columns stand one after the other.
fn apply(matrix: MatRef<'_, f64>, columns: &[f64], accumulate: Accum, out: &mut [f64]) {
    let many = columns.len() / matrix.ncols();
    let columns = MatRef::from_column_major_slice(columns, matrix.ncols(), many);
    matmul(MatMut::from_column_major_slice_mut(out, matrix.nrows(), many), accumulate, matrix, columns, 1.0, Par::Seq);
}

/// Blocks of `rows x columns`, one after the other, each transposed.
fn transpose_blocks(blocks: &[f64], rows: usize, columns: usize, turned: &mut [f64]) {
    for (to, from) in turned.chunks_exact_mut(rows * columns).zip(blocks.chunks_exact(rows * columns)) {
        for (i, to) in to.chunks_exact_mut(columns).enumerate() {
            to.iter_mut().zip(from[i..].iter().step_by(rows)).for_each(|(to, from)| *to = *from);
        }
    }
}
