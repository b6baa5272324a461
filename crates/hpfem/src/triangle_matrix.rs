//! Stiffness of a triangle: plain dense products over the tables of its modes.

use crate::element::{CellForm, PointForm, Workspace, matrix_in, row_of};
use crate::error::Error;
use crate::triangle::{triangle_modes, triangle_rule};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, Par};

/// Modes of one degree at the points of one rule.
pub(crate) struct TriangleTable {
    points: Vec<[f64; 3]>,
    weights: Vec<f64>,
    /// Value and derivatives by `l_1` and `l_2`, points by modes.
    modes: [Mat<f64>; 3],
}

impl TriangleTable {
    pub(crate) fn new(degree: usize, points: usize) -> TriangleTable {
        let (points, weights) = triangle_rule(points);
        let jets: Vec<_> = points.iter().map(|l| triangle_modes(degree, *l)).collect();
        let modes = std::array::from_fn(|k| Mat::from_fn(points.len(), jets[0].len(), |q, m| jets[q][m][k]));
        TriangleTable { points, weights, modes }
    }
}

/// Stiffness matrix of a triangle, laid out as [`crate::element::stiffness`] does.
///
/// # Errors
/// [`Error::FoldedCell`] where the Jacobian is not positive.
pub(crate) fn triangle_stiffness<'w>(
    form: &CellForm<'_>,
    table: &TriangleTable,
    work: &'w mut Workspace,
) -> Result<MatMut<'w, f64>, Error> {
    let CellForm { mesh, cell, local, moduli, kinematics } = *form;
    let components = kinematics.components();
    let (nq, n) = (table.weights.len(), local.modes);
    // Rows of u, then u,x, then u,z at the points; columns in the local order of modes.
    let mut operators = Mat::<f64>::zeros(3 * nq, n);
    let mut measure = Vec::with_capacity(nq);
    let mut radius = Vec::with_capacity(nq);
    for (q, l) in table.points.iter().enumerate() {
        let ([x, z], [[xr, xs], [zr, zs]]) = mesh.reference_map(cell, *l);
        let jacobian = xr * zs - xs * zr;
        if jacobian.is_nan() || jacobian <= 0.0 {
            return Err(Error::FoldedCell { cell, jacobian, x, z });
        }
        measure.push(table.weights[q] * jacobian * kinematics.measure(x));
        radius.push(x);
        for (m, column) in local.position.iter().enumerate().filter(|(_, p)| **p != usize::MAX) {
            let [value, r, s] = std::array::from_fn(|k| table.modes[k][(q, m)]);
            operators[(q, *column)] = value;
            operators[(nq + q, *column)] = (r * zs - s * zr) / jacobian;
            operators[(2 * nq + q, *column)] = (s * xr - r * xs) / jacobian;
        }
    }
    let row = |component, position| row_of(local, components, component, position);
    let mut k = matrix_in(&mut work.matrix, components * n, components * n);
    let pairs: &[(usize, usize)] = if components == 2 { &[(0, 0), (1, 1), (1, 0)] } else { &[(0, 0)] };
    let mut stresses = Mat::<f64>::zeros(3 * nq, n);
    let mut out = Mat::<f64>::zeros(n, n);
    for &(c, d) in pairs {
        // The value itself counts only in the hoop strain.
        let first = if kinematics.has_hoop_strain() && (c, d) != (1, 1) { 0 } else { 1 };
        for q in 0..nq {
            let form = PointForm { moduli: &moduli, kinematics, inverse_radius: 1.0 / radius[q], test: c, trial: d };
            let unit = |k: usize| std::array::from_fn(|i| f64::from(u8::from(i == k)));
            let a: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| measure[q] * form.value(unit(i), unit(j))));
            for m in 0..n {
                let u: [f64; 3] = std::array::from_fn(|j| operators[(j * nq + q, m)]);
                for i in first..3 {
                    stresses[(i * nq + q, m)] = (first..3).map(|j| a[i][j] * u[j]).sum();
                }
            }
        }
        let rows = first * nq;
        let (test, trial) = (operators.as_ref().get(rows.., ..), stresses.as_ref().get(rows.., ..));
        matmul(out.as_mut(), Accum::Replace, test.transpose(), trial, 1.0, Par::Seq);
        for j in 0..n {
            for i in if c == d { j } else { 0 }..n {
                let (r, s) = (row(c, i), row(d, j));
                k[(r.max(s), r.min(s))] = out[(i, j)];
            }
        }
    }
    Ok(k)
}
