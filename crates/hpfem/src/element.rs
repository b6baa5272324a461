//! Element matrices by sum factorisation, written as dense products.
//!
//! Every supported kinematics has the bilinear form `sum_kl int A^cd_kl (D_k v_c) (D_l u_d)` over the reference square, where
//! `D_0` is the value, `D_1 = d/dxi`, `D_2 = d/deta`, and `A` holds material, map and measure. With tensor shape functions the
//! integral over the square is a product of one-dimensional ones: first contract the eta points, `H = T_eta A`, then the xi
//! points, `K = H T_xi^T`. Both are plain matrix products.

use crate::basis::{LocalModes, Table};
use crate::error::Error;
use crate::material::{Kinematics, Moduli};
use crate::mesh::{Mesh, blend};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, Par};

/// Position, Jacobian and measure of a cell at a tensor grid of reference points.
pub(crate) struct CellGeometry {
    /// Positions, index `a + nx * b`.
    pub(crate) position: Vec<[f64; 2]>,
    /// `dX/d(xi, eta)` as `[[x_xi, x_eta], [z_xi, z_eta]]`.
    pub(crate) derivative: Vec<[[f64; 2]; 2]>,
}

/// Evaluates the map of `cell` on the tensor grid of `xi` and `eta`.
pub(crate) fn cell_geometry(mesh: &Mesh, cell: usize, xi: &[f64], eta: &[f64]) -> CellGeometry {
    let corners = mesh.cells[cell].corners.map(|v| mesh.vertices[v]);
    let curves: [_; 4] = std::array::from_fn(|e| mesh.local_curve(cell, e));
    let along = |e: usize, t: &[f64]| -> Vec<_> {
        t.iter()
            .map(|t| (curves[e].point(*t), curves[e].derivative(*t)))
            .collect()
    };
    let (e0, e1, e2, e3) = (along(0, xi), along(1, eta), along(2, xi), along(3, eta));
    let mut geometry = CellGeometry {
        position: Vec::new(),
        derivative: Vec::new(),
    };
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

/// Terms with derivatives only.
const GRADIENT: [Term; 4] = [[1, 1], [1, 2], [2, 1], [2, 2]];
/// Terms of a form that also has the value of the test or trial function.
const FULL: [Term; 9] = [
    [1, 1],
    [1, 2],
    [2, 1],
    [2, 2],
    [0, 1],
    [0, 2],
    [1, 0],
    [2, 0],
    [0, 0],
];

/// Stiffness matrix of a cell in the local order of [`LocalModes`]; only the lower triangle is filled.
///
/// # Errors
/// [`Error::FoldedCell`] where the Jacobian is not positive.
pub(crate) fn stiffness(
    mesh: &Mesh,
    cell: usize,
    table: &Table,
    local: &LocalModes,
    moduli: Moduli,
    kinematics: Kinematics,
) -> Result<Mat<f64>, Error> {
    let components = kinematics.components();
    let nq = table.rule.points.len();
    let geometry = cell_geometry(mesh, cell, &table.rule.points, &table.rule.points);
    let n = table.functions;
    let mut k = Mat::zeros(components * local.modes, components * local.modes);
    let mut pairs = vec![(0, 0)];
    if components == 2 {
        pairs.extend([(1, 1), (1, 0)]);
    }
    for (c, d) in pairs {
        let terms: &[Term] = if kinematics.is_revolved() && (c, d) != (1, 1) {
            &FULL
        } else {
            &GRADIENT
        };
        // Coefficients A_kl at the points, xi index fastest in the columns of term blocks.
        let mut coefficients = vec![Mat::<f64>::zeros(nq, nq); terms.len()];
        for b in 0..nq {
            for a in 0..nq {
                let [[xx, xe], [zx, ze]] = geometry.derivative[a + nq * b];
                let jacobian = xx * ze - xe * zx;
                let [x, z] = geometry.position[a + nq * b];
                if !(jacobian > 0.0) {
                    return Err(Error::FoldedCell {
                        cell,
                        jacobian,
                        x,
                        z,
                    });
                }
                // Rows: gradient of xi, gradient of eta; the value needs the hoop strain 1/r.
                let g = [
                    [ze / jacobian, -xe / jacobian],
                    [-zx / jacobian, xx / jacobian],
                ];
                let weight = table.rule.weights[a]
                    * table.rule.weights[b]
                    * jacobian
                    * kinematics.measure(x);
                let form = PointForm {
                    moduli,
                    kinematics,
                    inverse_radius: 1.0 / x,
                    test: c,
                    trial: d,
                };
                for (t, coefficient) in terms.iter().zip(&mut coefficients) {
                    coefficient[(b, a)] =
                        weight * form.value(operator(t[0], &g), operator(t[1], &g));
                }
            }
        }
        let mut h = Mat::<f64>::zeros(n * n, nq * terms.len());
        let mut xi_side = Mat::<f64>::zeros(n * n, nq * terms.len());
        for (i, (t, coefficient)) in terms.iter().zip(&coefficients).enumerate() {
            let product =
                |order: usize| 2 * usize::from(t[0] == order) + usize::from(t[1] == order);
            let columns = h.as_mut().subcols_mut(i * nq, nq);
            matmul(
                columns,
                Accum::Replace,
                table.products[product(2)].as_ref(),
                coefficient.as_ref(),
                1.0,
                Par::Seq,
            );
            xi_side
                .as_mut()
                .subcols_mut(i * nq, nq)
                .copy_from(&table.products[product(1)]);
        }
        let mut out = Mat::<f64>::zeros(n * n, n * n);
        matmul(
            out.as_mut(),
            Accum::Replace,
            h.as_ref(),
            xi_side.as_ref().transpose(),
            1.0,
            Par::Seq,
        );
        scatter(out, n, local, components, (c, d), k.as_mut());
    }
    Ok(k)
}

/// Copies `out[(i2 + n j2, i1 + n j1)]` (test i, trial j) into the lower triangle of `k`.
fn scatter(
    out: Mat<f64>,
    n: usize,
    local: &LocalModes,
    components: usize,
    (c, d): (usize, usize),
    mut k: MatMut<'_, f64>,
) {
    for j1 in 0..n {
        for i1 in 0..n {
            let column = out.col_as_slice(i1 + n * j1);
            for j2 in 0..n {
                let trial = j1 + n * j2;
                let pj = local.position[trial];
                if pj == usize::MAX {
                    continue;
                }
                let col = components * pj + d;
                for i2 in 0..n {
                    let test = i1 + n * i2;
                    let pi = local.position[test];
                    if pi == usize::MAX {
                        continue;
                    }
                    let row = components * pi + c;
                    let value = local.sign[test] * local.sign[trial] * column[i2 + n * j2];
                    if row >= col {
                        k[(row, col)] = value;
                    } else if c != d {
                        k[(col, row)] = value;
                    }
                }
            }
        }
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
struct PointForm {
    moduli: Moduli,
    kinematics: Kinematics,
    inverse_radius: f64,
    test: usize,
    trial: usize,
}

impl PointForm {
    /// `sigma(u) : eps(v)` for `v = test component` with `[value, d/dx, d/dz] = v`, and `u` likewise.
    fn value(&self, v: [f64; 3], u: [f64; 3]) -> f64 {
        let Moduli { c11, c12, shear } = self.moduli;
        let hoop = self.inverse_radius;
        match (self.kinematics, self.test, self.trial) {
            (Kinematics::Torsion, ..) => {
                shear * ((v[1] - hoop * v[0]) * (u[1] - hoop * u[0]) + v[2] * u[2])
            }
            (Kinematics::Axisymmetric, 0, 0) => {
                let (vh, uh) = (hoop * v[0], hoop * u[0]);
                c11 * (v[1] * u[1] + vh * uh) + c12 * (v[1] * uh + vh * u[1]) + shear * v[2] * u[2]
            }
            (Kinematics::Axisymmetric, 1, 0) => {
                c12 * v[2] * (u[1] + hoop * u[0]) + shear * v[1] * u[2]
            }
            (_, 0, 0) => c11 * v[1] * u[1] + shear * v[2] * u[2],
            (_, 1, 1) => c11 * v[2] * u[2] + shear * v[1] * u[1],
            _ => c12 * v[2] * u[1] + shear * v[1] * u[2],
        }
    }
}
