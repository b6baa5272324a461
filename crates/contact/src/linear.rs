//! The bordered linear system of an active set, scaled by powers that keep its results exact under changes of unit.

use crate::lcp::{Complementarity, Point, Proximal};
use faer::Mat;
use faer::linalg::solvers::{PartialPivLu, Solve};

/// Natural sizes: the compliance of each point, and for each coordinate a unit and a stiffness.
pub(crate) struct Scaling {
    /// `A_ii`, or the largest of them where a point does not yield at all.
    pub(crate) point: Vec<f64>,
    /// Size of a coordinate that moves some point by its compliance times a unit force.
    pub(crate) unit: Vec<f64>,
    /// Resultant of a unit force.
    pub(crate) resultant: Vec<f64>,
    /// `resultant / unit`.
    pub(crate) stiffness: Vec<f64>,
}

impl Scaling {
    pub(crate) fn new(problem: &Complementarity<'_>) -> Scaling {
        let n = problem.points();
        let own = (0..n).map(|i| problem.compliance[(i, i)]);
        // Heat may close each point further than its force opens it.
        let largest = match own.clone().all(|a| a < 0.0) {
            true => own.clone().map(f64::abs).fold(0.0, f64::max),
            false => own.clone().fold(0.0, f64::max),
        };
        let point: Vec<f64> = own.map(|a| if a > 1e-14 * largest { a } else { largest }).collect();
        let mut scaling = Scaling { point, unit: Vec::new(), resultant: Vec::new(), stiffness: Vec::new() };
        for j in 0..problem.load.len() {
            let motion = (0..n).map(|i| problem.influence[(i, j)].abs() / scaling.point[i]).fold(0.0, f64::max);
            let resultant = (0..n).map(|i| problem.balance[(i, j)].abs()).fold(0.0, f64::max);
            let own = problem.stiffness[(j, j)];
            let resultant = if resultant > 0.0 { resultant } else { 1.0 };
            let unit = if motion > 0.0 {
                1.0 / motion
            } else if own > 0.0 {
                resultant / own
            } else {
                1.0
            };
            scaling.unit.push(unit);
            scaling.resultant.push(resultant);
            scaling.stiffness.push(resultant / unit);
        }
        scaling
    }
}

/// The scaled system of an active set.
pub(crate) fn matrix(problem: &Complementarity<'_>, scaling: &Scaling, index: &[usize], weight: f64) -> Mat<f64> {
    let (a, m) = (index.len(), problem.load.len());
    Mat::from_fn(a + m, a + m, |i, j| match (i < a, j < a) {
        (true, true) => {
            let value = problem.compliance[(index[i], index[j])] / scaling.point[index[i]];
            if i == j { value + weight } else { value }
        }
        (true, false) => problem.influence[(index[i], j - a)] * scaling.unit[j - a] / scaling.point[index[i]],
        (false, true) => problem.balance[(index[j], i - a)] / scaling.resultant[i - a],
        (false, false) => {
            let (i, j) = (i - a, j - a);
            let spring = if i == j { weight * scaling.stiffness[j] } else { 0.0 };
            -(problem.stiffness[(i, j)] + spring) * scaling.unit[j] / scaling.resultant[i]
        }
    })
}

/// `[A + w/r, Psi; B^T, -K - w k]` on the active points, factorised.
pub(crate) struct Factor {
    lu: Option<PartialPivLu<f64>>,
    matrix: Mat<f64>,
}

/// Solves and refines once: in small cells of a body that bends much, the elimination's own round-off is up to a hundred times that of the
/// openings.
pub(crate) fn refined(lu: &PartialPivLu<f64>, matrix: &Mat<f64>, right: &Mat<f64>) -> Mat<f64> {
    let x = lu.solve(right);
    let rest = right - matrix * &x;
    x + lu.solve(rest)
}

/// Most iterations for a singular value, and the relative change at which they end.
const ITERATIONS: usize = 60;
const SETTLED: f64 = 1e-5;

/// Smallest and largest singular value, by power iterations with `A^T A` and its inverse: two solves each instead of a decomposition.
pub(crate) fn extreme_singular_values(matrix: &Mat<f64>) -> Option<[f64; 2]> {
    let lu = matrix.partial_piv_lu();
    let largest = power(matrix.ncols(), |x| matrix.transpose() * (matrix * x))?.sqrt();
    // No digits are left of a value that round-off makes.
    let inverse = power(matrix.ncols(), |x| lu.solve(lu.solve_transpose(x))).filter(|value| value.is_finite());
    Some([inverse.map_or(0.0, |value| 1.0 / value.sqrt()), largest])
}

/// Largest eigenvalue of a positive map.
fn power(size: usize, map: impl Fn(&Mat<f64>) -> Mat<f64>) -> Option<f64> {
    // A start without symmetry, the same each time.
    let mut x = Mat::from_fn(size, 1, |i, _| 0.5 + (0.618_033_988_749_895 * (i + 1) as f64).fract());
    let mut value = None;
    for _ in 0..ITERATIONS {
        x /= faer::Scale(x.norm_l2());
        x = map(&x);
        let next = x.norm_l2();
        let settled = value.is_some_and(|before: f64| (next - before).abs() <= SETTLED * next);
        value = Some(next);
        if settled || !next.is_finite() || next == 0.0 {
            break;
        }
    }
    value.filter(|_| size > 0)
}

impl Factor {
    pub(crate) fn new(problem: &Complementarity<'_>, scaling: &Scaling, index: &[usize], weight: f64) -> Factor {
        if index.len() + problem.load.len() == 0 {
            return Factor { lu: None, matrix: Mat::zeros(0, 0) };
        }
        let matrix = matrix(problem, scaling, index, weight);
        Factor { lu: Some(matrix.partial_piv_lu()), matrix }
    }

    pub(crate) fn solve(
        &self,
        problem: &Complementarity<'_>,
        scaling: &Scaling,
        index: &[usize],
        proximal: &Proximal<'_>,
    ) -> Option<Point> {
        let (a, m) = (index.len(), problem.load.len());
        let mut point = Point { force: vec![0.0; problem.points()], coordinates: vec![0.0; m] };
        let Some(lu) = &self.lu else { return Some(point) };
        let right = Mat::from_fn(a + m, 1, |i, _| {
            if i < a {
                let k = index[i];
                let pull = if proximal.weight > 0.0 { proximal.weight * proximal.centre.force[k] } else { 0.0 };
                pull - problem.opening[k] / scaling.point[k]
            } else {
                let j = i - a;
                let spring = if proximal.weight > 0.0 {
                    proximal.weight * scaling.stiffness[j] * proximal.centre.coordinates[j]
                } else {
                    0.0
                };
                -(problem.load[j] + spring) / scaling.resultant[j]
            }
        });
        if self.smallest_pivot_ratio() < 1e-15 {
            return None;
        }
        let x = refined(lu, &self.matrix, &right);
        index.iter().enumerate().for_each(|(i, k)| point.force[*k] = x[(i, 0)]);
        (0..m).for_each(|j| point.coordinates[j] = x[(a + j, 0)] * scaling.unit[j]);
        let finite = point.force.iter().chain(&point.coordinates).all(|v| v.is_finite());
        finite.then_some(point)
    }

    /// Smallest over largest pivot.
    fn smallest_pivot_ratio(&self) -> f64 {
        let Some(lu) = &self.lu else { return 1.0 };
        let pivots = (0..lu.U().nrows()).map(|i| lu.U()[(i, i)].abs());
        let (low, high) = pivots.fold((f64::INFINITY, 0.0_f64), |(l, h), p| (l.min(p), h.max(p)));
        if high > 0.0 { low / high } else { 0.0 }
    }

    /// Sign of the determinant.
    pub(crate) fn sign(&self) -> f64 {
        let Some(lu) = &self.lu else { return 1.0 };
        let mut sign: f64 = (0..lu.U().nrows()).map(|i| lu.U()[(i, i)].signum()).product();
        let (forward, _) = lu.P().arrays();
        let mut seen = vec![false; forward.len()];
        for start in 0..forward.len() {
            let mut at = start;
            let mut length = 0;
            while !seen[at] {
                seen[at] = true;
                at = forward[at];
                length += 1;
            }
            if length > 0 && length % 2 == 0 {
                sign = -sign;
            }
        }
        sign
    }
}
