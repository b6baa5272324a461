//! Growing functions of the pressure that are no powers: inverse and integral.

use crate::quadrature::{ORDER, legendre};

/// Panels of an integral.
const PANELS: usize = 8;

/// log p with x(p) = exp(log_value), and d log p / d log x, of a function `[x, dx/dp]` that grows with p: bracketing, then Newton kept inside
/// the bracket.
pub(crate) fn invert(function: &dyn Fn(f64) -> [f64; 2], log_value: f64) -> (f64, f64) {
    let logs = |p: f64| {
        let [value, slope] = function(p);
        (value.ln(), slope * p / value)
    };
    invert_log(&logs, log_value)
}

/// The same of a function of p that gives `log x` and `d log x / d log p`.
pub(crate) fn invert_log(function: &dyn Fn(f64) -> (f64, f64), log_value: f64) -> (f64, f64) {
    let defect = |u: f64| {
        let (log, growth) = function(u.exp());
        (log - log_value, growth)
    };
    let [mut low, mut high] = bracket(&|u| defect(u).0);
    let mut u = 0.5 * (low + high);
    let (mut slope, mut before) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..200 {
        let (value, growth) = defect(u);
        // Below a threshold 0/0: there the pressure does not change with the rate.
        slope = if growth.is_nan() { f64::INFINITY } else { growth };
        if value > 0.0 {
            high = u
        } else {
            low = u
        }
        let newton = u - value / growth;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        let moved = (next - u).abs();
        u = next;
        // At its end steps are round-off, and get no shorter.
        if moved <= 1e-15 * (1.0 + u.abs()) || (moved <= 1e-13 * (1.0 + u.abs()) && moved >= before) {
            break;
        }
        before = moved;
    }
    (u, 1.0 / slope)
}

/// Logarithms of two pressures between which the defect of the rate changes its sign, as far as a pressure is a number.
fn bracket(defect: &dyn Fn(f64) -> f64) -> [f64; 2] {
    let (mut low, mut high) = (-1.0, 1.0);
    let mut step = 1.0;
    while defect(high) < 0.0 && high < 700.0 {
        (low, high) = (high, high + step);
        step *= 2.0;
    }
    step = 1.0;
    // Below a threshold the rate is zero and its logarithm -inf: that is low enough.
    while defect(low) >= 0.0 && low > -700.0 {
        low -= step;
        step *= 2.0;
    }
    [low, high]
}

/// int_0^p of a function that may start like any power: Gauss rules in x, p x^4 being the variable.
pub(crate) fn integral(function: &dyn Fn(f64) -> f64, pressure: f64) -> f64 {
    if pressure <= 0.0 {
        return 0.0;
    }
    let rule = legendre();
    let width = 1.0 / PANELS as f64;
    let panel = |k: usize| -> f64 {
        let at = |i: usize| {
            let x = width * (k as f64 + rule.abscissa[i]);
            rule.weight[i] * width * 4.0 * x.powi(3) * function(pressure * x.powi(4))
        };
        (0..ORDER).map(at).sum()
    };
    pressure * (0..PANELS).map(panel).sum::<f64>()
}
