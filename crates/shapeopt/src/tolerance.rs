//! What small errors of a shape do to the pressure, and how soon wear removes them: linear algebra on the contact system.

use crate::gap_rate::GapRate;
use crate::wear_problem::{LoadStage, WearProblem, fits};
use faer::Mat;
use faer::linalg::solvers::{PartialPivLu, Solve};

/// Effect of one error of the shape, in proportion to it as long as the contact stays closed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Tolerance {
    /// Change of the pressure at the contact points, MPa.
    pub change: Vec<f64>,
    /// Sliding distance, mm, in which the area norm of the change falls to `1/e` by wear; `None` if nothing wears it away, or if that norm is less than 1e-6
    /// of the largest of all errors, as it is of one that a free rigid motion takes up.
    pub run_in_distance: Option<f64>,
}

/// `1 - 1/sqrt(2)` of the two-stage L-stable method of order two.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;
/// First step over the shortest mean time of the errors, growth of the steps, most steps.
const STEPS: (f64, f64, usize) = (0.02, 1.3, 120);
/// Area norm of an error's pressure, relative to the largest, below which a free rigid motion takes the error up: what is left is round-off.
const RIGID: f64 = 1e-6;

/// Effects of errors `dg` (one a list of values at the contact points, mm, positive open) of the shape that has the given pressure under
/// the first load of the problem.
///
/// With the points in contact staying in contact, nodal forces `f` and free coordinates `y` answer by `dg + A f + Psi y = 0`,
/// `B^T f = K y`; wear then follows `A f' + Psi y' = -R f` with `R = (dw'/dp) / W`. Points without pressure are left out. `None` if no
/// forces balance an error, or a list or the first load is not of as many points.
pub fn tolerances(problem: &WearProblem, pressure: &[f64], errors: &[Vec<f64>]) -> Option<Vec<Tolerance>> {
    let stage = problem.stages.first()?;
    let count = problem.points.len();
    let long = pressure.len() == count && stage.speeds.len() == count && errors.iter().all(|error| error.len() == count);
    if !(long && fits(&stage.system, count)) {
        return None;
    }
    let closed = Closed::new(problem, stage, pressure);
    let n = closed.points.len();
    let right = closed.bordered_right(errors.len(), |i, k| -errors[k][closed.points[i]]);
    let solved = closed.bordered(0.0).solve(&right);
    let forces = Mat::from_fn(n, errors.len(), |i, k| solved[(i, k)] / closed.unit);
    if !forces.col_iter().all(|c| c.iter().all(|f| f.is_finite())) {
        return None;
    }
    let fallen = closed.fallen(&forces, errors);
    let area: f64 = closed.weights.iter().sum();
    let mean_speed = stage.speeds.iter().zip(&closed.weights).map(|(v, w)| v * w).sum::<f64>() / area;
    let of = |k: usize| {
        let mut change = vec![0.0; pressure.len()];
        closed.points.iter().enumerate().for_each(|(i, c)| change[*c] = forces[(i, k)] / closed.weights[*c]);
        Tolerance { change, run_in_distance: fallen[k].map(|time| time * mean_speed).filter(|d| d.is_finite()) }
    };
    Some((0..errors.len()).map(of).collect())
}

/// The points in contact with the compliance between them.
struct Closed<'a> {
    stage: &'a LoadStage,
    /// Numbers of the points in contact.
    points: Vec<usize>,
    /// Weights of all points.
    weights: Vec<f64>,
    /// Compliance of the softest point, so that the rows of the coordinates compare with those of the points.
    unit: f64,
    /// `R`.
    worn: Mat<f64>,
}

impl<'a> Closed<'a> {
    fn new(problem: &WearProblem, stage: &'a LoadStage, pressure: &[f64]) -> Closed<'a> {
        let points: Vec<usize> = (0..pressure.len()).filter(|i| pressure[*i] > 0.0).collect();
        let weights: Vec<f64> = problem.points.iter().map(|p| p.weight).collect();
        let rate = GapRate::new(&problem.wear, problem.counterface, &stage.speeds, &weights, problem.track_area);
        let n = points.len();
        let unit = points.iter().map(|i| stage.system.compliance[(*i, *i)].abs()).fold(f64::MIN_POSITIVE, f64::max);
        let worn = Mat::from_fn(n, n, |i, j| {
            let slope = |of: f64| of / weights[points[j]];
            let local = if i == j { slope(rate.local_slope(points[j], pressure[points[j]])) } else { 0.0 };
            local + slope(rate.recession_slope(points[j], pressure[points[j]]))
        });
        Closed { stage, points, weights, unit, worn }
    }

    /// `A / unit + factor R / unit`, bordered by the coordinates.
    fn bordered(&self, factor: f64) -> PartialPivLu<f64> {
        let (n, system, closed, unit) = (self.points.len(), &self.stage.system, &self.points, self.unit);
        let m = system.load.len();
        Mat::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
            (true, true) => {
                let worn = if factor > 0.0 { factor * self.worn[(i, j)] } else { 0.0 };
                (system.compliance[(closed[i], closed[j])] + worn) / unit
            }
            (true, false) => system.influence[(closed[i], j - n)],
            (false, true) => system.balance[(closed[j], i - n)],
            (false, false) => -unit * system.stiffness[(i - n, j - n)],
        })
        .partial_piv_lu()
    }

    /// Right-hand sides given at the points, zero in the rows of the coordinates.
    fn bordered_right(&self, columns: usize, value: impl Fn(usize, usize) -> f64) -> Mat<f64> {
        let (n, m) = (self.points.len(), self.stage.system.load.len());
        Mat::from_fn(n + m, columns, |i, k| if i < n { value(i, k) } else { 0.0 })
    }

    /// Area norm of the pressures of a column of forces.
    fn norm(&self, forces: &Mat<f64>, k: usize) -> f64 {
        (0..self.points.len()).map(|i| forces[(i, k)].powi(2) / self.weights[self.points[i]]).sum::<f64>().sqrt()
    }

    /// Shortest mean time of those errors that press: work of an error's forces over what wear takes of it in a second.
    fn shortest_time(&self, presses: &[usize], forces: &Mat<f64>, errors: &[Vec<f64>]) -> f64 {
        let taken = &self.worn * forces;
        let mean_time = |k: usize| {
            let sum = |g: &dyn Fn(usize) -> f64| (0..self.points.len()).map(|i| forces[(i, k)] * g(i)).sum::<f64>();
            (sum(&|i| errors[k][self.points[i]]) / sum(&|i| taken[(i, k)])).abs()
        };
        presses.iter().copied().map(mean_time).filter(|t| t.is_finite() && *t > 0.0).fold(f64::INFINITY, f64::min)
    }

    /// Times at which the norms of the forces have fallen to `1/e`, in growing steps of the two-stage method.
    fn fallen(&self, forces: &Mat<f64>, errors: &[Vec<f64>]) -> Vec<Option<f64>> {
        let mut fallen: Vec<Option<f64>> = vec![None; errors.len()];
        let start: Vec<f64> = (0..errors.len()).map(|k| self.norm(forces, k)).collect();
        let largest = start.iter().copied().fold(0.0, f64::max);
        let presses: Vec<usize> = (0..errors.len()).filter(|k| start[*k] > RIGID * largest).collect();
        let shortest = self.shortest_time(&presses, forces, errors);
        if !shortest.is_finite() {
            return fallen;
        }
        let (mut time, mut step, mut f) = (0.0, STEPS.0 * shortest, forces.clone());
        for _ in 0..STEPS.2 {
            let next = self.worn_off(&f, step);
            for k in presses.iter().copied() {
                if fallen[k].is_some() {
                    continue;
                }
                let [before, after] = [self.norm(&f, k) / start[k], self.norm(&next, k) / start[k]];
                if after <= (-1.0_f64).exp() {
                    // Exponential between two times.
                    fallen[k] = Some(time + step * (1.0 + before.ln()) / (before / after).ln());
                }
            }
            if presses.iter().all(|k| fallen[*k].is_some()) {
                break;
            }
            (time, step, f) = (time + step, step * STEPS.1, next);
        }
        fallen
    }

    /// Forces after a step of wear.
    fn worn_off(&self, f: &Mat<f64>, step: f64) -> Mat<f64> {
        let n = self.points.len();
        let matrix = self.bordered(GAMMA * step);
        let slope = |f: &Mat<f64>| {
            let load = &self.worn * f;
            let k = matrix.solve(&self.bordered_right(f.ncols(), |i, j| -load[(i, j)]));
            Mat::from_fn(n, f.ncols(), |i, j| k[(i, j)] / self.unit)
        };
        let first = slope(f);
        let second = slope(&Mat::from_fn(n, f.ncols(), |i, j| f[(i, j)] + (1.0 - GAMMA) * step * first[(i, j)]));
        Mat::from_fn(n, f.ncols(), |i, j| f[(i, j)] + step * ((1.0 - GAMMA) * first[(i, j)] + GAMMA * second[(i, j)]))
    }
}
