//! Legendre polynomials and their integrals, the shape functions of the p-version.
//!
//! `P_k` follows the three-term recurrence `(k+1) P_{k+1} = (2k+1) x P_k - k P_{k-1}`. The one-dimensional hierarchic
//! shape functions on `[-1, 1]` (Szabo and Babuska, *Finite Element Analysis*, 1991, sec. 3.2) are
//!
//! ```text
//! N_0 = (1 - x) / 2,   N_1 = (1 + x) / 2,
//! N_k = (P_k - P_{k-2}) / sqrt(2 (2k - 1)),   k = 2, 3, ...     (zero at both ends, parity (-1)^k)
//! N_k' = sqrt((2k - 1) / 2) P_{k-1}
//! ```

/// Values `P_0(x) .. P_degree(x)` of the Legendre polynomials.
pub fn legendre(degree: usize, x: f64) -> Vec<f64> {
    let mut values = vec![1.0; degree + 1];
    if degree >= 1 {
        values[1] = x;
    }
    for k in 1..degree {
        let n = k as f64;
        values[k + 1] = ((2.0 * n + 1.0) * x * values[k] - n * values[k - 1]) / (n + 1.0);
    }
    values
}

/// `P_{degree-1}(x)` and `P_degree(x)`, `degree >= 1`, by the same recurrence.
pub(crate) fn last_legendre(degree: usize, x: f64) -> [f64; 2] {
    let (mut lower, mut value) = (1.0, x);
    for k in 1..degree {
        let n = k as f64;
        (lower, value) = (value, ((2.0 * n + 1.0) * x * value - n * lower) / (n + 1.0));
    }
    [lower, value]
}

/// The values alone of [`shape_functions`], one after the other.
pub(crate) fn shape_values(degree: usize, x: f64) -> impl Iterator<Item = f64> {
    // P_{k-2} and P_{k-1}.
    let (mut lower, mut value) = (1.0, x);
    (0..=degree).map(move |k| {
        if k < 2 {
            return 0.5 * if k == 0 { 1.0 - x } else { 1.0 + x };
        }
        let (n, c) = ((k - 1) as f64, (2 * k - 1) as f64);
        let next = ((2.0 * n + 1.0) * x * value - n * lower) / (n + 1.0);
        let shape = (next - lower) / (2.0 * c).sqrt();
        (lower, value) = (value, next);
        shape
    })
}

/// The hierarchic shape functions `N_0 .. N_degree` at `x` and their derivatives, as `(values, derivatives)`, each of
/// length `degree + 1`; `degree >= 1`.
pub fn shape_functions(degree: usize, x: f64) -> (Vec<f64>, Vec<f64>) {
    let mut values = Vec::with_capacity(degree + 1);
    let mut derivatives = Vec::with_capacity(degree + 1);
    values.extend([0.5 * (1.0 - x), 0.5 * (1.0 + x)]);
    derivatives.extend([-0.5, 0.5]);
    // P_{k-2} and P_{k-1}.
    let (mut lower, mut value) = (1.0, x);
    for k in 2..=degree {
        let (n, c) = ((k - 1) as f64, (2 * k - 1) as f64);
        let next = ((2.0 * n + 1.0) * x * value - n * lower) / (n + 1.0);
        values.push((next - lower) / (2.0 * c).sqrt());
        derivatives.push((0.5 * c).sqrt() * value);
        (lower, value) = (value, next);
    }
    (values, derivatives)
}
