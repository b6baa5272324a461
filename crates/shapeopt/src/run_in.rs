//! Wear linearised about a pressure: how fast each deviation from the steady state wears away, and how long explicit steps may be.
//!
//! A deviation `f` of nodal forces that keeps the balance obeys `A f' + Psi y' = -R f` with `R = (dw'/dp) / W`; modes `f ~ exp(-t / T)` are
//! eigenvectors of `A f + Psi y = T R f`. Explicit Euler is stable for steps below `min 2 Re(1/T) / |1/T|^2`.

use crate::implicit_stage::Load;
use crate::rigid_wear::RigidWear;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// Modes of the linearised wear.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
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
    if load.rate.turns() {
        return run_in_mean(load, pressure, mean_speed);
    }
    let wearing = |i: &usize| pressure[*i] > 0.0 && load.rate.local_slope(*i, pressure[*i]) > 0.0;
    let active: Vec<usize> = (0..pressure.len()).filter(wearing).collect();
    let n = active.len();
    if n <= rigid.influence.ncols() {
        return None;
    }
    // R^(-1/2).
    let soft: Vec<f64> = active.iter().map(|i| (load.weights[*i] / load.rate.local_slope(*i, pressure[*i])).sqrt()).collect();
    let slope = |j: usize| load.rate.recession_slope(active[j], pressure[active[j]]) / load.weights[active[j]];
    let wear = Mat::from_fn(n, n, |i, j| f64::from(u8::from(i == j)) + soft[i] * slope(j) * soft[j]);
    let symmetric = load.system.symmetric && !load.rate.recedes();
    // Scaled by the wear, slow modes are accurate; unscaled, the inverse has the fast ones.
    let Reduced { right, left, matrix } = Reduced::new(load, rigid, &active, &soft);
    let times = if symmetric {
        eigenvalues(&matrix, true)?
    } else {
        eigenvalues(&(left.transpose() * &wear * &right).partial_piv_lu().solve(&matrix), false)?
    };
    let mut decay: Vec<f64> = times.iter().map(|[re, im]| (re * re + im * im) / re).collect();
    decay.sort_unstable_by(f64::total_cmp);
    decay.reverse();
    let Reduced { right, left, matrix } = Reduced::new(load, rigid, &active, &vec![1.0; n]);
    let stiffness = &right * matrix.partial_piv_lu().solve(left.transpose());
    let rates = eigenvalues(&(wear * Mat::from_fn(n, n, |i, j| stiffness[(i, j)] / (soft[i] * soft[j]))), symmetric)?;
    let square = |[re, im]: &[f64; 2]| re * re + im * im;
    let fastest = rates.iter().map(square).fold(0.0, f64::max);
    let bounds = rates.iter().filter(|l| square(l) > ROUND_OFF * fastest).map(|l| 2.0 * l[0] / square(l));
    Some(RunIn {
        distances: decay.iter().map(|t| t * mean_speed).collect(),
        times: decay,
        explicit_limit: bounds.fold(f64::INFINITY, f64::min).max(0.0),
    })
}

/// Modes under loads that act by turns: the gap obeys `dg/dt = -sum_k share_k R_k S_k g` with the forces `S_k g` by which the bodies answer a gap under
/// load `k`, all of them at the same places.
fn run_in_mean(load: &Load<'_>, pressure: &[f64], mean_speed: f64) -> Option<RunIn> {
    let places = load.rate.places();
    let slope = |i: usize| load.rate.local_slope(i, pressure[i]) / load.weights[i];
    let wearing: Vec<usize> =
        (0..pressure.len()).filter(|i| pressure[*i] > 0.0 && slope(*i) > 0.0 && slope(*i).is_finite()).collect();
    let pressed: Vec<usize> = (0..pressure.len()).filter(|i| pressure[*i] > 0.0).collect();
    let (a, m) = (pressed.len(), load.system.load.len());
    if wearing.is_empty() || a <= m {
        return None;
    }
    let system = &load.system;
    let matrix = Mat::from_fn(a + m, a + m, |i, j| match (i < a, j < a) {
        (true, true) => system.compliance[(pressed[i], pressed[j])],
        (true, false) => system.influence[(pressed[i], j - a)],
        (false, true) => system.balance[(pressed[j], i - a)],
        (false, false) => -system.stiffness[(i - a, j - a)],
    });
    let unit = Mat::from_fn(a + m, places, |i, place| f64::from(u8::from(i < a && pressed[i] % places == place)));
    let forces = matrix.partial_piv_lu().solve(&unit);
    let mut decline = Mat::<f64>::zeros(places, places);
    for (i, point) in pressed.iter().enumerate().filter(|(_, point)| wearing.binary_search(point).is_ok()) {
        let slope = slope(*point);
        (0..places).for_each(|j| decline[(point % places, j)] += slope * forces[(i, j)]);
    }
    if load.rate.recedes() {
        let all: Vec<f64> = (0..places)
            .map(|j| {
                let of = |(i, point): (usize, &usize)| {
                    load.rate.recession_slope(*point, pressure[*point]) / load.weights[*point] * forces[(i, j)]
                };
                pressed.iter().enumerate().map(of).sum()
            })
            .collect();
        (0..places).for_each(|i| (0..places).for_each(|j| decline[(i, j)] += all[j]));
    }
    let rates = eigenvalues(&decline, false)?;
    let square = |[re, im]: &[f64; 2]| re * re + im * im;
    let fastest = rates.iter().map(square).fold(0.0, f64::max);
    let lasting: Vec<&[f64; 2]> = rates.iter().filter(|rate| square(rate) > ROUND_OFF * fastest && rate[0] != 0.0).collect();
    let mut times: Vec<f64> = lasting.iter().map(|rate| 1.0 / rate[0]).collect();
    times.sort_unstable_by(f64::total_cmp);
    times.reverse();
    Some(RunIn {
        distances: times.iter().map(|t| t * mean_speed).collect(),
        times,
        explicit_limit: lasting.iter().map(|rate| 2.0 * rate[0] / square(rate)).fold(f64::INFINITY, f64::min).max(0.0),
    })
}

/// Square of a rate over that of the fastest below which it is the round-off of a rigid mode.
const ROUND_OFF: f64 = 1e-18;

/// Compliance on the forces that keep the balance, seen modulo the rigid modes.
struct Reduced {
    /// Basis of the forces.
    right: Mat<f64>,
    /// Basis of the openings.
    left: Mat<f64>,
    matrix: Mat<f64>,
}

impl Reduced {
    /// With rows and columns multiplied by `scale`.
    fn new(load: &Load<'_>, rigid: &RigidWear, active: &[usize], scale: &[f64]) -> Reduced {
        let n = active.len();
        let rows = |m: &Mat<f64>| Mat::from_fn(n, m.ncols(), |i, j| scale[i] * m[(active[i], j)]);
        let mut compliance = Mat::from_fn(n, n, |i, j| scale[i] * load.system.compliance[(active[i], active[j])] * scale[j]);
        compliance += rows(&rigid.held_influence) * rows(&rigid.held_balance).transpose();
        let (right, left) = (complement(&rows(&rigid.balance)), complement(&rows(&rigid.influence)));
        let matrix = left.transpose() * compliance * &right;
        Reduced { right, left, matrix }
    }
}

/// Eigenvalues as real and imaginary part.
fn eigenvalues(matrix: &Mat<f64>, symmetric: bool) -> Option<Vec<[f64; 2]>> {
    if symmetric {
        let n = matrix.nrows();
        let even = Mat::from_fn(n, n, |i, j| 0.5 * (matrix[(i, j)] + matrix[(j, i)]));
        return Some(even.self_adjoint_eigenvalues(Side::Lower).ok()?.iter().map(|t| [*t, 0.0]).collect());
    }
    contact::eigenvalues(matrix).ok()
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
