//! Gauss-Legendre, Gauss-Lobatto and Gauss-Lobatto-Jacobi rules on `[-1, 1]`.
//!
//! Points by Newton's method on one half of the interval, mirrored, so that symmetric rules are symmetric by construction.

use crate::legendre::last_legendre;
use std::f64::consts::PI;
use std::sync::OnceLock;

/// Rules by their number of points, made when first asked for.
type Remembered = [OnceLock<Quadrature>; 40];
static GAUSS: Remembered = [const { OnceLock::new() }; 40];
static GAUSS_LOBATTO: Remembered = [const { OnceLock::new() }; 40];

fn remembered(rules: &Remembered, n: usize, rule: fn(usize) -> Quadrature) -> Quadrature {
    rules.get(n).map_or_else(|| rule(n), |known| known.get_or_init(|| rule(n)).clone())
}

/// Points and weights of a quadrature rule, points ascending.
#[derive(Clone, Debug, PartialEq)]
pub struct Quadrature {
    /// Points in `[-1, 1]`.
    pub points: Vec<f64>,
    /// Weights, one a point; they sum up to the integral of the weight function over `[-1, 1]`.
    pub weights: Vec<f64>,
}

/// Gauss-Legendre rule with `n >= 1` points, exact to degree `2n - 1`.
///
/// Roots of `P_n`; `w_i = 2 / ((1 - x_i^2) P_n'(x_i)^2)`.
///
/// # Panics
/// For none.
pub fn gauss(n: usize) -> Quadrature {
    assert!(n >= 1, "a rule has a point at least");
    remembered(&GAUSS, n, gauss_rule)
}

fn gauss_rule(n: usize) -> Quadrature {
    mirrored(n, |i| {
        let mut x = (PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
        // `P_n` and `P_n'` at the same x; a slope from before the last step would cost the weight two digits.
        let at = |x: f64| {
            let [lower, value] = last_legendre(n, x);
            (value, n as f64 * (lower - x * value) / (1.0 - x * x))
        };
        for _ in 0..100 {
            let (value, slope) = at(x);
            let step = value / slope;
            x -= step;
            if step.abs() < 1e-15 {
                break;
            }
        }
        let slope = at(x).1;
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// Gauss-Lobatto rule with `n >= 2` points, both ends included, exact to degree `2n - 3`.
///
/// Inner points are the roots of `P_{n-1}'`; `w_i = 2 / (n (n-1) P_{n-1}(x_i)^2)`.
///
/// # Panics
/// For less than two points.
pub fn gauss_lobatto(n: usize) -> Quadrature {
    assert!(n >= 2, "a rule with both ends has two points at least, not {n}");
    remembered(&GAUSS_LOBATTO, n, gauss_lobatto_rule)
}

fn gauss_lobatto_rule(n: usize) -> Quadrature {
    let m = n - 1;
    let end_weight = 2.0 / (n as f64 * m as f64);
    mirrored(n, |i| {
        if i == 0 {
            return (1.0, end_weight);
        }
        let mut x = (PI * i as f64 / m as f64).cos();
        for _ in 0..100 {
            let [lower, value] = last_legendre(m, x);
            let q = 1.0 - x * x;
            let first = m as f64 * (lower - x * value) / q;
            let second = (2.0 * x * first - (m * (m + 1)) as f64 * value) / q;
            let step = first / second;
            x -= step;
            if step.abs() < 1e-15 {
                break;
            }
        }
        let value = last_legendre(m, x)[1];
        (x, end_weight / (value * value))
    })
}

/// Gauss-Lobatto-Jacobi rule with `n >= 2` points for the weight `1 + x`: the rule for an edge that starts on the axis of
/// revolution, where the area element vanishes with the radius.
///
/// Both ends are points; the inner ones are the extrema of the Jacobi polynomials `P^(0,1)_{n-1}`, found as eigenvalues and
/// polished by Newton's method. The weights make `sum w_i f(x_i) = int f(x) (1 + x) dx` exact for
/// `f` of degree `2n - 3`. The weight of the point on the axis is positive (unlike `(1 + x_0) w_0 = 0`).
///
/// # Panics
/// For less than two points.
pub fn gauss_lobatto_jacobi(n: usize) -> Quadrature {
    assert!(n >= 2, "a rule with both ends has two points at least, not {n}");
    // Inner points: roots of P^(1,2)_{n-2}, the derivative of P^(0,1)_{n-1} up to a factor; they are the eigenvalues of the
    // Jacobi matrix of the weight (1-x)(1+x)^2 (Golub and Welsch 1969).
    let m = n - 2;
    let (a, b) = (1.0, 2.0);
    let mut jacobi = nalgebra::DMatrix::<f64>::zeros(m, m);
    for k in 0..m {
        let s = 2.0 * k as f64 + a + b;
        jacobi[(k, k)] = (b * b - a * a) / (s * (s + 2.0));
        if k > 0 {
            let kf = k as f64;
            let off = 4.0 * kf * (kf + a) * (kf + b) * (kf + a + b) / (s * s * (s + 1.0) * (s - 1.0));
            jacobi[(k, k - 1)] = off.sqrt();
            jacobi[(k - 1, k)] = off.sqrt();
        }
    }
    let mut points: Vec<f64> = Vec::with_capacity(n);
    if m > 0 {
        points.extend(jacobi.symmetric_eigenvalues().iter());
        for x in &mut points {
            for _ in 0..2 {
                // d/dx P^(a,b)_m = (m + a + b + 1) / 2 P^(a+1,b+1)_{m-1}.
                let slope = 0.5 * (m as f64 + a + b + 1.0) * jacobi_polynomial(m - 1, a + 1.0, b + 1.0, *x);
                *x -= jacobi_polynomial(m, a, b, *x) / slope;
            }
        }
    }
    points.extend([-1.0, 1.0]);
    points.sort_unstable_by(f64::total_cmp);
    // Weights: the integral of each Lagrange polynomial against 1 + x, by an exact Gauss rule.
    let rule = gauss(n);
    let barycentric = barycentric_weights(&points);
    let mut weights = vec![0.0; n];
    for (x, w) in rule.points.iter().zip(&rule.weights) {
        for (total, l) in weights.iter_mut().zip(lagrange(&points, &barycentric, *x)) {
            *total += w * (1.0 + x) * l;
        }
    }
    Quadrature { points, weights }
}

impl Quadrature {
    /// The same rule walked from the other end: for the weight function mirrored.
    pub(crate) fn reversed(mut self) -> Quadrature {
        self.points.reverse();
        self.points.iter_mut().for_each(|x| *x = -*x);
        self.weights.reverse();
        self
    }
}

/// Jacobi polynomial `P^(a,b)_n(x)` by its three-term recurrence (Abramowitz and Stegun 22.7.1).
fn jacobi_polynomial(n: usize, a: f64, b: f64, x: f64) -> f64 {
    let (mut lower, mut value) = (0.0, 1.0);
    for k in 0..n {
        let k = k as f64;
        let s = 2.0 * k + a + b;
        let next = if k == 0.0 {
            0.5 * (a - b + (a + b + 2.0) * x)
        } else {
            let middle = (s + 1.0) * (a * a - b * b) + s * (s + 1.0) * (s + 2.0) * x;
            (middle * value - 2.0 * (k + a) * (k + b) * (s + 2.0) * lower) / (2.0 * (k + 1.0) * (k + a + b + 1.0) * s)
        };
        (lower, value) = (value, next);
    }
    value
}

/// Weights of the barycentric interpolation formula for the given points, one a point.
pub fn barycentric_weights(points: &[f64]) -> Vec<f64> {
    points
        .iter()
        .enumerate()
        .map(|(i, x)| {
            let others = points.iter().enumerate().filter(|(j, _)| *j != i);
            1.0 / others.map(|(_, y)| 2.0 * (x - y)).product::<f64>()
        })
        .collect()
}

/// The values of the Lagrange polynomials of `points` at `x`, one a point, by the barycentric formula of the second kind.
pub fn lagrange(points: &[f64], barycentric: &[f64], x: f64) -> Vec<f64> {
    if let Some(hit) = points.iter().position(|y| *y == x) {
        return (0..points.len()).map(|i| f64::from(u8::from(i == hit))).collect();
    }
    let mut terms: Vec<f64> = points.iter().zip(barycentric).map(|(y, w)| w / (x - y)).collect();
    let total: f64 = terms.iter().sum();
    terms.iter_mut().for_each(|t| *t /= total);
    terms
}

/// Fills a symmetric rule from `positive_half(i)`, the i-th largest point and its weight.
fn mirrored(n: usize, positive_half: impl Fn(usize) -> (f64, f64)) -> Quadrature {
    let mut points = vec![0.0; n];
    let mut weights = vec![0.0; n];
    for i in 0..n.div_ceil(2) {
        let (x, w) = positive_half(i);
        let x = if 2 * i + 1 == n { 0.0 } else { x };
        points[i] = -x;
        points[n - 1 - i] = x;
        weights[i] = w;
        weights[n - 1 - i] = w;
    }
    Quadrature { points, weights }
}
