//! Gauss-Legendre and Gauss-Jacobi rules on [0, 1].

use std::sync::OnceLock;

use nalgebra::DMatrix;

/// Points of one rule.
pub(crate) const ORDER: usize = 16;

/// Abscissas in (0, 1) and weights of int_0^1 f dt.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rule {
    pub(crate) abscissa: [f64; ORDER],
    pub(crate) weight: [f64; ORDER],
}

/// Gauss-Legendre rule on [0, 1], by Newton on the Legendre polynomial.
pub(crate) fn legendre() -> &'static Rule {
    static RULE: OnceLock<Rule> = OnceLock::new();
    RULE.get_or_init(|| {
        let mut rule = Rule { abscissa: [0.0; ORDER], weight: [0.0; ORDER] };
        let n = ORDER as f64;
        for i in 0..ORDER {
            let mut x = -(std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..50 {
                let (mut previous, mut value) = (1.0, x);
                for degree in 2..=ORDER {
                    let d = degree as f64;
                    (previous, value) = (value, ((2.0 * d - 1.0) * x * value - (d - 1.0) * previous) / d);
                }
                slope = n * (x * value - previous) / (x * x - 1.0);
                let step = value / slope;
                x -= step;
                if step.abs() < 1e-16 {
                    break;
                }
            }
            rule.abscissa[i] = 0.5 * (1.0 + x);
            rule.weight[i] = 1.0 / ((1.0 - x * x) * slope * slope);
        }
        rule
    })
}

/// Rule on [0, 1] for integrands with any powers of t above -1, and its logarithm, at t = 0: Gauss-Legendre in the sixth root of t.
pub(crate) fn graded() -> Rule {
    let Rule { abscissa, weight } = *legendre();
    let at = |i: usize| 6.0 * abscissa[i].powi(5) * weight[i];
    Rule { abscissa: abscissa.map(|s| s.powi(6)), weight: std::array::from_fn(at) }
}

/// Rule for integrands t^exponent times a smooth function on [0, 1] (exponent > -1), with the weights divided by t^exponent, so
/// that it is applied to the plain integrand. Golub-Welsch on the Jacobi recurrence.
pub(crate) fn jacobi(exponent: f64) -> Rule {
    let beta = exponent;
    let mut matrix = DMatrix::<f64>::zeros(ORDER, ORDER);
    for i in 0..ORDER {
        let n = i as f64;
        let sum = 2.0 * n + beta;
        // Shifted to [0, 1]: a_n = (1 + x_n) / 2, b_n half the coefficient on [-1, 1].
        let a = if i == 0 { beta / (beta + 2.0) } else { beta * beta / (sum * (sum + 2.0)) };
        matrix[(i, i)] = 0.5 * (1.0 + a);
        if i > 0 {
            // b_n^2 = 4 n^2 (n + beta)^2 / (sum^2 (sum + 1)(sum - 1)); for n = 1 the factors 1 + beta cancel.
            let squared = if i == 1 {
                4.0 * (1.0 + beta) / ((2.0 + beta).powi(2) * (3.0 + beta))
            } else {
                4.0 * n * n * (n + beta).powi(2) / (sum * sum * (sum + 1.0) * (sum - 1.0))
            };
            let b = 0.5 * squared.sqrt();
            matrix[(i, i - 1)] = b;
            matrix[(i - 1, i)] = b;
        }
    }
    let eigen = matrix.symmetric_eigen();
    let total = 1.0 / (beta + 1.0);
    let mut rule = Rule { abscissa: [0.0; ORDER], weight: [0.0; ORDER] };
    for i in 0..ORDER {
        let t = eigen.eigenvalues[i].max(f64::MIN_POSITIVE);
        rule.abscissa[i] = t;
        rule.weight[i] = total * eigen.eigenvectors[(0, i)].powi(2) / t.powf(exponent);
    }
    rule
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_integrate_their_powers() {
        let sum = |rule: &Rule, power: f64| -> f64 { (0..ORDER).map(|i| rule.weight[i] * rule.abscissa[i].powf(power)).sum() };
        for power in [0.0, 1.0, 7.0, 31.0] {
            approx::assert_relative_eq!(sum(legendre(), power), 1.0 / (power + 1.0), max_relative = 1e-13);
        }
        for exponent in [-0.999, -0.5, 0.3, 3.0] {
            for power in [0.0, 1.0, 9.0] {
                let exact = 1.0 / (exponent + power + 1.0);
                let got = sum(&jacobi(exponent), exponent + power);
                approx::assert_relative_eq!(got, exact, max_relative = 1e-11);
            }
        }
    }
}
