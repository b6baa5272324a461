//! Element matrices of quadrilaterals by sum factorisation, written as dense products.
//!
//! Every supported kinematics has the bilinear form `sum_kl int A^cd_kl (D_k v_c) (D_l u_d)` over the reference square, where
//! `D_0` is the value, `D_1 = d/dxi`, `D_2 = d/deta`, and `A` holds material, map and measure. With tensor shape functions the
//! integral over the square is a product of one-dimensional ones: first contract the eta points, `H = T_eta A`, then the xi
//! points, `K = H T_xi^T`. Both are plain matrix products. Whether `D_k` and `D_l` differentiate in xi chooses `T_xi`, so that the terms of one
//! such choice share their part of `H`. Where `A` is a sum of few products of functions of eta and of xi, as one is in rectangles, the sums over the points
//! are those of the factors, and the last product has a column for each.

use crate::basis::{LocalModes, Table};
use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::mesh::{Mesh, blend};
use crate::moduli::Moduli;
use crate::separated::Separated;
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, Par};

/// Position, Jacobian and measure of a cell at a tensor grid of reference points.
pub(crate) struct CellGeometry {
    /// Positions, index `a + nx * b`.
    pub(crate) position: Vec<[f64; 2]>,
    /// `dX/d(xi, eta)` as `[[x_xi, x_eta], [z_xi, z_eta]]`.
    pub(crate) derivative: Vec<[[f64; 2]; 2]>,
}

/// Evaluates the map of a quadrilateral on the tensor grid of `xi` and `eta`.
pub(crate) fn cell_geometry(mesh: &Mesh, cell: usize, xi: &[f64], eta: &[f64]) -> CellGeometry {
    let corners = mesh.cells[cell].corners.map(|v| mesh.vertices[v]);
    let curves: [_; 4] = std::array::from_fn(|e| mesh.local_curve(cell, e));
    let along = |e: usize, t: &[f64]| -> Vec<_> { t.iter().map(|t| (curves[e].point(*t), curves[e].derivative(*t))).collect() };
    let (e0, e1, e2, e3) = (along(0, xi), along(1, eta), along(2, xi), along(3, eta));
    let points = xi.len() * eta.len();
    let mut geometry = CellGeometry { position: Vec::with_capacity(points), derivative: Vec::with_capacity(points) };
    for (b, y) in eta.iter().enumerate() {
        for (a, x) in xi.iter().enumerate() {
            let (point, derivative) = blend(&corners, [e0[a], e1[b], e2[a], e3[b]], *x, *y);
            geometry.position.push(point);
            geometry.derivative.push(derivative);
        }
    }
    geometry
}

/// One term of the bilinear form of a component pair: orders of differentiation of test and trial function, each 0 (value),
/// 1 (d/dxi) or 2 (d/deta).
type Term = [usize; 2];

/// Terms with derivatives only; here and below those with one [`product`] in xi stand together, in the order of [`XI_PRODUCTS`].
const GRADIENT: [Term; 4] = [[1, 1], [1, 2], [2, 1], [2, 2]];
/// Terms of a form that has the value of the trial function too.
const TRIAL_VALUE: [Term; 6] = [[1, 1], [1, 2], [1, 0], [2, 1], [2, 2], [2, 0]];
/// Terms of a form that has the values of both.
const FULL: [Term; 9] = [[1, 1], [1, 2], [1, 0], [2, 1], [0, 1], [2, 2], [2, 0], [0, 2], [0, 0]];

/// The products of one-dimensional functions in xi: derivatives of test and trial function, of the test function, of the trial function, of neither.
const XI_PRODUCTS: [usize; 4] = [3, 2, 1, 0];

/// Orders of the derivatives in xi and in eta.
const XI: usize = 1;
const ETA: usize = 2;

/// The product of one-dimensional functions that a term takes in a direction, as an index of the tables.
fn product(term: Term, direction: usize) -> usize {
    2 * usize::from(term[0] == direction) + usize::from(term[1] == direction)
}

/// The bilinear form of a cell on its modes.
pub(crate) struct CellForm<'a> {
    pub(crate) mesh: &'a Mesh,
    pub(crate) cell: usize,
    pub(crate) local: &'a LocalModes,
    pub(crate) moduli: Moduli,
    pub(crate) kinematics: Kinematics,
}

/// Memory for the matrices of a cell, kept from cell to cell.
#[derive(Default)]
pub(crate) struct Workspace {
    pub(crate) matrix: Vec<f64>,
    coefficients: Vec<f64>,
    eta_side: Vec<f64>,
    xi_side: Vec<f64>,
    out: Vec<f64>,
    separated: Separated,
    /// Coefficients of sums of modes of a cell, and what they take at its points.
    pub(crate) coefficients_of_sums: Vec<f64>,
    pub(crate) sums: [Vec<f64>; 5],
    /// Loads on the modes of a cell, a column each.
    pub(crate) load: Vec<f64>,
}

/// A matrix on the first `rows * columns` numbers of a buffer, which grows if need be; the contents are what was there before.
pub(crate) fn matrix_in(buffer: &mut Vec<f64>, rows: usize, columns: usize) -> MatMut<'_, f64> {
    if buffer.len() < rows * columns {
        buffer.resize(rows * columns, 0.0);
    }
    MatMut::from_column_major_slice_mut(&mut buffer[..rows * columns], rows, columns)
}

/// Stiffness matrix of a quadrilateral on its unsigned modes; only the lower triangle is filled.
///
/// Rows: interior modes of component 0, of component 1, boundary modes of component 0, of component 1, each in the order of
/// [`LocalModes`].
///
/// # Errors
/// [`Error::FoldedCell`] where the Jacobian is not positive.
pub(crate) fn stiffness<'w>(form: &CellForm<'_>, table: &Table, work: &'w mut Workspace) -> Result<MatMut<'w, f64>, Error> {
    let CellForm { mesh, cell, local, moduli, kinematics } = *form;
    let components = kinematics.components();
    let nq = table.rule.points.len();
    let geometry = cell_geometry(mesh, cell, &table.rule.points, &table.rule.points);
    let size = components * local.modes;
    let layout = Layout::new(table, local, components);
    matrix_in(&mut work.matrix, size, size);
    let pairs: &[(usize, usize)] = if components == 2 { &[(0, 0), (1, 1), (1, 0)] } else { &[(0, 0)] };
    for &(c, d) in pairs {
        // The hoop strain is the value of component 0.
        let terms: &[Term] = match (kinematics.has_hoop_strain(), (c, d)) {
            (true, (0, 0)) => &FULL,
            (true, (1, 0)) => &TRIAL_VALUE,
            _ => &GRADIENT,
        };
        // Coefficients A_kl at the points: one block of columns a term, rows eta, columns xi.
        let mut coefficients = matrix_in(&mut work.coefficients, nq, nq * terms.len());
        let points = PointCoefficients { form, table, geometry: &geometry, terms };
        let at = |inverse_radius| PointForm { moduli: &moduli, kinematics, inverse_radius, test: c, trial: d };
        match moduli {
            // The law of most bodies, compiled on its own.
            Moduli::Isotropic { c11, c12, shear } => {
                points.fill(coefficients.as_mut(), |r, v, u| at(r).isotropic([c11, c12, shear], v, u))?;
            }
            Moduli::Scalar { matrix } => {
                points.fill(coefficients.as_mut(), |r, v, u| at(r).scalar(matrix, v, u))?;
            }
            Moduli::General { .. } => {
                points.fill(coefficients.as_mut(), |r, v, u| at(r).value(v, u))?;
            }
        }
        contract(table, terms, c == d, work);
        layout.scatter(&work.out, (c, d), &mut work.matrix[..size * size]);
    }
    Ok(matrix_in(&mut work.matrix, size, size))
}

/// Sums the coefficients `A_kl` of a component pair over the points: rows of the result are the products in eta, columns those in xi, of one component half
/// of them, as its block is symmetric.
fn contract(table: &Table, terms: &[Term], one_component: bool, work: &mut Workspace) {
    let nq = table.rule.points.len();
    let xi_tables = if one_component { &table.lower } else { &table.all };
    let (rows, columns) = (table.all[0].nrows(), xi_tables[0].nrows());
    let coefficients = matrix_in(&mut work.coefficients, nq, nq * terms.len());
    let mut eta_side = matrix_in(&mut work.eta_side, rows, nq * XI_PRODUCTS.len());
    let mut xi_side = matrix_in(&mut work.xi_side, columns, nq * XI_PRODUCTS.len());
    let mut width = 0;
    for number in XI_PRODUCTS {
        let of_product = || terms.iter().enumerate().filter(|(_, t)| product(**t, XI) == number);
        let coefficient = |i: usize| coefficients.as_ref().subcols(i * nq, nq);
        let eta_table = |t: &Term| table.all[product(*t, ETA)].as_ref();
        let xi_table = xi_tables[number].as_ref();
        work.separated.clear();
        // Elimination takes its time too: beyond a third of the points nothing is gained.
        if of_product().all(|(i, _)| work.separated.add(coefficient(i), nq / 3)) {
            for ((_, t), [along_eta, along_xi]) in of_product().zip(work.separated.terms()) {
                let rank = along_eta.ncols();
                matmul(eta_side.as_mut().subcols_mut(width, rank), Accum::Replace, eta_table(t), along_eta, 1.0, Par::Seq);
                matmul(xi_side.as_mut().subcols_mut(width, rank), Accum::Replace, xi_table, along_xi, 1.0, Par::Seq);
                width += rank;
            }
            continue;
        }
        let mut first = Accum::Replace;
        for (i, t) in of_product() {
            matmul(eta_side.as_mut().subcols_mut(width, nq), first, eta_table(t), coefficient(i), 1.0, Par::Seq);
            first = Accum::Add;
        }
        xi_side.as_mut().subcols_mut(width, nq).copy_from(&xi_table);
        width += nq;
    }
    let (eta_side, xi_side) = (eta_side.as_ref().subcols(0, width), xi_side.as_ref().subcols(0, width));
    matmul(matrix_in(&mut work.out, rows, columns), Accum::Replace, eta_side, xi_side.transpose(), 1.0, Par::Seq);
}

/// What makes the coefficients `A_kl` of a component pair at the points of a cell.
struct PointCoefficients<'a> {
    form: &'a CellForm<'a>,
    table: &'a Table,
    geometry: &'a CellGeometry,
    terms: &'a [Term],
}

impl PointCoefficients<'_> {
    /// Fills one block of columns a term, rows eta, columns xi; `value` is the form of two operators `[value, d/dx, d/dz]`, given `1/r`.
    #[inline]
    fn fill(&self, mut out: MatMut<'_, f64>, value: impl Fn(f64, [f64; 3], [f64; 3]) -> f64) -> Result<(), Error> {
        let PointCoefficients { form: CellForm { cell, kinematics, .. }, table, geometry, terms } = *self;
        let nq = table.rule.points.len();
        for b in 0..nq {
            for a in 0..nq {
                let [[xx, xe], [zx, ze]] = geometry.derivative[a + nq * b];
                let jacobian = xx * ze - xe * zx;
                let [x, z] = geometry.position[a + nq * b];
                if jacobian.is_nan() || jacobian <= 0.0 {
                    return Err(Error::FoldedCell { cell: *cell, jacobian, x, z });
                }
                // Rows: gradient of xi, gradient of eta; the value needs the hoop strain 1/r.
                let inverse = 1.0 / jacobian;
                let g = [[ze * inverse, -xe * inverse], [-zx * inverse, xx * inverse]];
                let weight = table.rule.weights[a] * table.rule.weights[b] * jacobian * kinematics.measure(x);
                for (i, t) in terms.iter().enumerate() {
                    out[(b, a + nq * i)] = weight * value(1.0 / x, operator(t[0], &g), operator(t[1], &g));
                }
            }
        }
        Ok(())
    }
}

/// Where the products of the tables go in the matrix of a cell.
struct Layout {
    functions: usize,
    /// For each place `i` of the xi table: scalar position and number of the modes with a bubble in eta, which stand in a run.
    runs: Vec<(usize, usize)>,
    /// Scalar positions of the modes with a hat in eta; `usize::MAX` if the space lacks them.
    hats: Vec<[usize; 2]>,
    interior: usize,
    boundary: usize,
    components: usize,
}

impl Layout {
    fn new(table: &Table, local: &LocalModes, components: usize) -> Layout {
        let n = table.functions;
        let position = |i: usize, j: usize| local.position[i + n * j];
        let run = |i: &usize| {
            let length = (2..n).take_while(|j| position(*i, *j) != usize::MAX).count();
            (if length > 0 { position(*i, 2) } else { 0 }, length)
        };
        Layout {
            functions: n,
            runs: table.order.iter().map(run).collect(),
            hats: table.order.iter().map(|i| [position(*i, 0), position(*i, 1)]).collect(),
            interior: local.interior,
            boundary: local.modes - local.interior,
            components,
        }
    }

    /// Row of a component of the mode at a scalar position.
    fn row(&self, component: usize, position: usize) -> usize {
        row_in(self.interior, self.boundary, self.components, component, position)
    }

    /// Copies `out[(i2 + n j2, (i1, j1))]` (test i, trial j) into the lower triangle of `k`; the columns are all pairs
    /// `(i1, j1)`, for equal components those with `i1 >= j1`.
    fn scatter(&self, out: &[f64], (c, d): (usize, usize), k: &mut [f64]) {
        let n = self.functions;
        let bubbles = n - 2;
        let size = self.components * (self.interior + self.boundary);
        let mut columns = out.chunks_exact(n * n);
        for j1 in 0..n {
            let (trial_start, trial_length) = self.runs[j1];
            for i1 in if c == d { j1..n } else { 0..n } {
                let (start, length) = self.runs[i1];
                let row = self.row(c, start);
                for (j2, values) in columns.next().into_iter().flat_map(|c| c.chunks_exact(n)).enumerate() {
                    let trial = match j2.checked_sub(bubbles) {
                        None if j2 < trial_length => trial_start + j2,
                        None => continue,
                        Some(hat) => self.hats[j1][hat],
                    };
                    if trial == usize::MAX {
                        continue;
                    }
                    let col = self.row(d, trial);
                    // On the diagonal pair the same holds for the eta modes.
                    let first = if c == d && i1 == j1 { j2 } else { 0 };
                    if first < length && row + first >= col {
                        k[col * size + row + first..col * size + row + length].copy_from_slice(&values[first..length]);
                    } else {
                        (first..length).for_each(|i2| k[(row + i2) * size + col] = values[i2]);
                    }
                    for (hat, test) in self.hats[i1].iter().enumerate() {
                        if bubbles + hat >= first && *test != usize::MAX {
                            let row = self.row(c, *test);
                            k[row.min(col) * size + row.max(col)] = values[bubbles + hat];
                        }
                    }
                }
            }
        }
    }
}

/// Row of a component of the mode at a scalar position, see [`stiffness`].
pub(crate) fn row_of(local: &LocalModes, components: usize, component: usize, position: usize) -> usize {
    row_in(local.interior, local.modes - local.interior, components, component, position)
}

fn row_in(interior: usize, boundary: usize, components: usize, component: usize, position: usize) -> usize {
    if position < interior {
        component * interior + position
    } else {
        (components - 1) * interior + component * boundary + position
    }
}

/// The operator that a reference derivative contributes: `[value, d/dx, d/dz]` of one shape function.
fn operator(order: usize, g: &[[f64; 2]; 2]) -> [f64; 3] {
    match order {
        0 => [1.0, 0.0, 0.0],
        1 => [0.0, g[0][0], g[0][1]],
        _ => [0.0, g[1][0], g[1][1]],
    }
}

/// Energy density form of a component pair at one point.
pub(crate) struct PointForm<'m> {
    pub(crate) moduli: &'m Moduli,
    pub(crate) kinematics: Kinematics,
    pub(crate) inverse_radius: f64,
    pub(crate) test: usize,
    pub(crate) trial: usize,
}

impl PointForm<'_> {
    /// `sigma(u) : eps(v)` for `v = test component` with `[value, d/dx, d/dz] = v`, and `u` likewise.
    pub(crate) fn value(&self, v: [f64; 3], u: [f64; 3]) -> f64 {
        match self.moduli {
            Moduli::Isotropic { c11, c12, shear } => self.isotropic([*c11, *c12, *shear], v, u),
            Moduli::General { stiffness } => {
                let (e, f) = (self.strain(self.test, v), self.strain(self.trial, u));
                let stress = |i: usize| (0..4).map(|j| stiffness[i][j] * f[j]).sum::<f64>();
                (0..4).map(|i| e[i] * stress(i)).sum()
            }
            Moduli::Scalar { matrix } => self.scalar(*matrix, v, u),
        }
    }

    /// Strains `[xx, zz, yy, gamma_xz]` of a component.
    fn strain(&self, component: usize, w: [f64; 3]) -> [f64; 4] {
        match (component, self.kinematics.has_hoop_strain()) {
            (0, true) => [w[1], 0.0, self.inverse_radius * w[0], w[2]],
            (0, false) => [w[1], 0.0, 0.0, w[2]],
            _ => [0.0, w[2], 0.0, w[1]],
        }
    }

    #[inline]
    fn scalar(&self, [[a, b], [c, d]]: [[f64; 2]; 2], v: [f64; 3], u: [f64; 3]) -> f64 {
        let hoop = if self.kinematics.has_hoop_strain() { self.inverse_radius } else { 0.0 };
        let [e, f] = [v, u].map(|w| [if hoop == 0.0 { w[1] } else { w[1] - hoop * w[0] }, w[2]]);
        e[0] * (a * f[0] + b * f[1]) + e[1] * (c * f[0] + d * f[1])
    }

    #[inline]
    fn isotropic(&self, [c11, c12, shear]: [f64; 3], v: [f64; 3], u: [f64; 3]) -> f64 {
        let hoop = self.inverse_radius;
        match self.kinematics {
            Kinematics::Torsion => shear * ((v[1] - hoop * v[0]) * (u[1] - hoop * u[0]) + v[2] * u[2]),
            Kinematics::Axisymmetric => match (self.test, self.trial) {
                (0, 0) => {
                    let (vh, uh) = (hoop * v[0], hoop * u[0]);
                    c11 * (v[1] * u[1] + vh * uh) + c12 * (v[1] * uh + vh * u[1]) + shear * v[2] * u[2]
                }
                (1, 0) => c12 * v[2] * (u[1] + hoop * u[0]) + shear * v[1] * u[2],
                _ => c11 * v[2] * u[2] + shear * v[1] * u[1],
            },
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } => match (self.test, self.trial) {
                (0, 0) => c11 * v[1] * u[1] + shear * v[2] * u[2],
                (1, 1) => c11 * v[2] * u[2] + shear * v[1] * u[1],
                _ => c12 * v[2] * u[1] + shear * v[1] * u[2],
            },
            // A potential has a scalar law.
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => 0.0,
        }
    }
}
