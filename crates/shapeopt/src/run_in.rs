//! Wear linearised about a pressure: how fast each deviation from the steady state wears away, and how long explicit steps may be.
//!
//! A deviation `f` of nodal forces that keeps the balance obeys `A f' + Psi y' = -R f` with `R = (dw'/dp) / W`; modes `f ~ exp(-t / T)` are
//! eigenvectors of `A f + Psi y = T R f`. Explicit Euler is stable for steps below `min 2 Re(1/T) / |1/T|^2 = 2 min Re T`.

use crate::implicit_stage::Load;
use crate::rigid_wear::RigidWear;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// Modes of the linearised wear.
#[derive(Clone, Debug, PartialEq)]
pub struct RunIn {
    /// Times `1 / Re(1/T)` in which the modes fall by the factor e, slowest first, s. Negative ones grow.
    pub times: Vec<f64>,
    /// Sliding distances in which they do, mm, by the area mean of the sliding speeds.
    pub distances: Vec<f64>,
    /// Largest stable step of explicit Euler, s.
    pub explicit_limit: f64,
}

/// Modes at a pressure; `None` if nothing wears or the eigenvalues cannot be found.
pub(crate) fn run_in(load: &Load<'_>, rigid: &RigidWear, pressure: &[f64], mean_speed: f64) -> Option<RunIn> {
    let active: Vec<usize> =
        (0..pressure.len()).filter(|i| pressure[*i] > 0.0 && load.rate.local_slope(*i, pressure[*i]) > 0.0).collect();
    let n = active.len();
    // R^(-1/2).
    let soft: Vec<f64> = active.iter().map(|i| (load.weights[*i] / load.rate.local_slope(*i, pressure[*i])).sqrt()).collect();
    let rows = |m: &Mat<f64>| Mat::from_fn(n, m.ncols(), |i, j| soft[i] * m[(active[i], j)]);
    let mut compliance = Mat::from_fn(n, n, |i, j| soft[i] * load.system.compliance[(active[i], active[j])] * soft[j]);
    compliance += rows(&rigid.held_influence) * rows(&rigid.held_balance).transpose();
    let (closing, balance) = (rows(&rigid.influence), rows(&rigid.balance));
    if n <= closing.ncols() {
        return None;
    }
    let (right, left) = (complement(&balance), complement(&closing));
    let reduced = left.transpose() * compliance * &right;
    // T as real and imaginary part.
    let times: Vec<[f64; 2]> = if load.system.symmetric && !load.rate.recedes() {
        let symmetric = Mat::from_fn(reduced.nrows(), reduced.ncols(), |i, j| 0.5 * (reduced[(i, j)] + reduced[(j, i)]));
        symmetric.self_adjoint_eigenvalues(Side::Lower).ok()?.iter().map(|t| [*t, 0.0]).collect()
    } else {
        let slope = |j: usize| load.rate.recession_slope(active[j], pressure[active[j]]) / load.weights[active[j]];
        let wear = Mat::from_fn(n, n, |i, j| f64::from(u8::from(i == j)) + soft[i] * slope(j) * soft[j]);
        let wear = left.transpose() * wear * &right;
        let matrix = wear.partial_piv_lu().solve(&reduced);
        matrix.eigenvalues().ok()?.iter().map(|t| [t.re, t.im]).collect()
    };
    let mut decay: Vec<f64> = times.iter().map(|[re, im]| (re * re + im * im) / re).collect();
    decay.sort_by(|a, b| b.total_cmp(a));
    let shortest = times.iter().map(|t| t[0]).fold(f64::INFINITY, f64::min);
    Some(RunIn { distances: decay.iter().map(|t| t * mean_speed).collect(), times: decay, explicit_limit: 2.0 * shortest })
}

/// Orthonormal basis of what is orthogonal to the columns.
fn complement(columns: &Mat<f64>) -> Mat<f64> {
    let (n, m) = (columns.nrows(), columns.ncols());
    if m == 0 {
        return Mat::identity(n, n);
    }
    let q = columns.qr().compute_Q();
    q.submatrix(0, m, n, n - m).to_owned()
}
