//! Exact line search of the augmented Lagrangian: how far to go towards a Newton point.
//!
//! The augmented potential of forces `lambda` and coordinates `y` is convex and piecewise quadratic. Along the line
//! `(lambda, y) + t (d lambda, d y)`, `0 <= t <= 1`, its slope is
//!
//! ```text
//! phi'(t) = (A d lambda) . (lambda(t) - push(t)) + d y . r(push(t), y(t))
//! ```
//!
//! with `push` the projected multipliers at the openings `w(t) = w + t (A d lambda + Psi d y)` and `r` the residual of the balance with its
//! proximal springs. The slope grows with `t`.

use faer::Mat;
use hpfem::bisect;

use crate::lcp::Point;
use crate::products::{add, times};

/// Slope at the Newton point, over that at the start, below which the Newton point is the minimum.
const SETTLED: f64 = 1e-3;

/// The line from a point to its Newton point.
pub(crate) struct Line<'a> {
    pub(crate) from: &'a Point,
    pub(crate) to: &'a Point,
    /// `A`, symmetric.
    pub(crate) compliance: &'a Mat<f64>,
    /// `Psi`.
    pub(crate) influence: &'a Mat<f64>,
    /// Openings `w` at the start.
    pub(crate) opening: &'a [f64],
}

/// The minimum of the augmented potential on a line, to `2^-halvings` of its length; `None` if that is the Newton point.
///
/// `push(i, w)` is the projected multiplier of constraint `i` at the opening `w`, `residual(push, y)` the slope of the potential along each
/// coordinate.
pub(crate) fn line_search(
    line: &Line<'_>,
    halvings: usize,
    push: impl Fn(usize, f64) -> f64,
    residual: impl Fn(&[f64], &[f64]) -> Vec<f64>,
) -> Option<Point> {
    // Direction, and how the openings move along it.
    let step = |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| b - a).collect() };
    let force = step(&line.from.force, &line.to.force);
    let coordinates = step(&line.from.coordinates, &line.to.coordinates);
    let response = times(line.compliance, &force);
    let mut moved = response.clone();
    add(&mut moved, &times(line.influence, &coordinates));
    let at = |t: f64| Point {
        force: line.from.force.iter().zip(&force).map(|(a, d)| a + t * d).collect(),
        coordinates: line.from.coordinates.iter().zip(&coordinates).map(|(a, d)| a + t * d).collect(),
    };
    let slope = |t: f64| {
        let p = at(t);
        let pushed: Vec<f64> = (0..force.len()).map(|i| push(i, line.opening[i] + t * moved[i])).collect();
        let elastic: f64 = (0..force.len()).map(|i| response[i] * (p.force[i] - pushed[i])).sum();
        let rest = residual(&pushed, &p.coordinates);
        let rigid: f64 = (0..coordinates.len()).map(|j| coordinates[j] * rest[j]).sum();
        elastic + rigid
    };
    // The whole step, if the potential still falls at its end or hardly rises.
    if slope(1.0) <= SETTLED * slope(0.0).abs() {
        return None;
    }
    // Bisection on the sign of the slope.
    let [low, high] = bisect([0.0, 1.0], halvings, |middle| slope(middle) < 0.0);
    Some(at(0.5 * (low + high)))
}
