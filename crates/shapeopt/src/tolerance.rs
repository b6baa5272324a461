//! What small errors of a shape do to the pressure, and how soon wear removes them: linear algebra on the contact system.

use crate::gap_rate::GapRate;
use crate::wear_problem::WearProblem;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Effect of one error of the shape, in proportion to it as long as the contact stays closed.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// Change of the pressure at the contact points, MPa.
    pub change: Vec<f64>,
    /// Sliding distance, mm, in which the area norm of the change falls to `1/e` by wear; `None` if nothing wears it away.
    pub run_in_distance: Option<f64>,
}

/// `1 - 1/sqrt(2)` of the two-stage L-stable method of order two.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;
/// First step over the shortest mean time of the errors, growth of the steps, most steps.
const STEPS: (f64, f64, usize) = (0.02, 1.3, 120);

/// Effects of errors `dg` (one a list of values at the contact points, mm, positive open) of the shape that has the given pressure under
/// the first load of the problem.
///
/// With the points in contact staying in contact, nodal forces `f` and free coordinates `y` answer by `dg + A f + Psi y = 0`,
/// `B^T f = K y`; wear then follows `A f' + Psi y' = -R f` with `R = (dw'/dp) / W`. Points without pressure are left out. `None` for an error
/// if no forces balance it.
pub fn tolerances(problem: &WearProblem, pressure: &[f64], errors: &[Vec<f64>]) -> Option<Vec<Tolerance>> {
    let stage = problem.stages.first()?;
    let closed: Vec<usize> = (0..pressure.len()).filter(|i| pressure[*i] > 0.0).collect();
    let weights: Vec<f64> = problem.points.iter().map(|p| p.weight).collect();
    let rate = GapRate::new(&problem.wear, problem.counterface, &stage.speeds, &weights, problem.track_area);
    let (n, m) = (closed.len(), stage.system.load.len());
    let system = &stage.system;
    // In units of the softest point's compliance, so that the rows of the coordinates compare with those of the points.
    let unit = closed.iter().map(|i| system.compliance[(*i, *i)].abs()).fold(f64::MIN_POSITIVE, f64::max);
    let area: f64 = weights.iter().sum();
    let wear = |i: usize, j: usize| {
        let slope = |of: f64| of / weights[closed[j]];
        let local = if i == j { slope(rate.local_slope(closed[j], pressure[closed[j]])) } else { 0.0 };
        local + slope(rate.recession_slope(closed[j], pressure[closed[j]]))
    };
    // `A / unit + factor R / unit`, bordered by the coordinates.
    let bordered = |factor: f64| {
        Mat::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
            (true, true) => {
                let worn = if factor > 0.0 { factor * wear(i, j) } else { 0.0 };
                (system.compliance[(closed[i], closed[j])] + worn) / unit
            }
            (true, false) => system.influence[(closed[i], j - n)],
            (false, true) => system.balance[(closed[j], i - n)],
            (false, false) => -unit * system.stiffness[(i - n, j - n)],
        })
        .partial_piv_lu()
    };
    let right = Mat::from_fn(n + m, errors.len(), |i, k| if i < n { -errors[k][closed[i]] } else { 0.0 });
    let solved = bordered(0.0).solve(&right);
    let forces = Mat::from_fn(n, errors.len(), |i, k| solved[(i, k)] / unit);
    if !forces.col_iter().all(|c| c.iter().all(|f| f.is_finite())) {
        return None;
    }
    let worn = Mat::from_fn(n, n, &wear);
    let norm = |f: &Mat<f64>, k: usize| (0..n).map(|i| f[(i, k)].powi(2) / weights[closed[i]]).sum::<f64>().sqrt();
    let start: Vec<f64> = (0..errors.len()).map(|k| norm(&forces, k)).collect();
    // Mean time of an error: work of its forces over what wear takes of it in a second.
    let taken = &worn * &forces;
    let mean_time = |k: usize| {
        let sum = |g: &dyn Fn(usize) -> f64| (0..n).map(|i| forces[(i, k)] * g(i)).sum::<f64>();
        (sum(&|i| errors[k][closed[i]]) / sum(&|i| taken[(i, k)])).abs()
    };
    let shortest = (0..errors.len()).map(mean_time).filter(|t| t.is_finite() && *t > 0.0).fold(f64::INFINITY, f64::min);
    let mut fallen: Vec<Option<f64>> = vec![None; errors.len()];
    if shortest.is_finite() {
        let (mut time, mut step, mut f) = (0.0, STEPS.0 * shortest, forces.clone());
        for _ in 0..STEPS.2 {
            let matrix = bordered(GAMMA * step);
            let slope = |f: &Mat<f64>| {
                let load = &worn * f;
                let k = matrix.solve(&Mat::from_fn(n + m, f.ncols(), |i, j| if i < n { -load[(i, j)] } else { 0.0 }));
                Mat::from_fn(n, f.ncols(), |i, j| k[(i, j)] / unit)
            };
            let first = slope(&f);
            let second = slope(&Mat::from_fn(n, f.ncols(), |i, j| f[(i, j)] + (1.0 - GAMMA) * step * first[(i, j)]));
            let next =
                Mat::from_fn(n, f.ncols(), |i, j| f[(i, j)] + step * ((1.0 - GAMMA) * first[(i, j)] + GAMMA * second[(i, j)]));
            for (k, fallen) in fallen.iter_mut().enumerate().filter(|(_, fallen)| fallen.is_none()) {
                let [before, after] = [norm(&f, k) / start[k], norm(&next, k) / start[k]];
                if after <= (-1.0_f64).exp() {
                    // Exponential between two times.
                    *fallen = Some(time + step * (1.0 + before.ln()) / (before / after).ln());
                }
            }
            if fallen.iter().all(Option::is_some) {
                break;
            }
            (time, step, f) = (time + step, step * STEPS.1, next);
        }
    }
    let mean_speed = stage.speeds.iter().zip(&weights).map(|(v, w)| v * w).sum::<f64>() / area;
    let of = |k: usize| {
        let mut change = vec![0.0; pressure.len()];
        closed.iter().enumerate().for_each(|(i, c)| change[*c] = forces[(i, k)] / weights[*c]);
        Tolerance { change, run_in_distance: fallen[k].map(|time| time * mean_speed).filter(|d| d.is_finite()) }
    };
    Some((0..errors.len()).map(of).collect())
}
