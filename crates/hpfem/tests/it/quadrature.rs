//! Quadrature rules and shape functions against a table of 30 digits and against the integrals they must give exactly.

use crate::quadrature_table::{GAUSS, LOBATTO, LOBATTO_JACOBI};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use hpfem::{Quadrature, barycentric_weights, gauss, gauss_lobatto, gauss_lobatto_jacobi, lagrange, legendre, shape_functions};

fn assert_rule(rule: &Quadrature, table: &[(f64, f64)]) {
    assert_eq!(rule.points.len(), table.len());
    for ((x, w), (point, weight)) in rule.points.iter().zip(&rule.weights).zip(table) {
        assert_abs_diff_eq!(x, point, epsilon = 3e-16);
        assert_abs_diff_eq!(w, weight, epsilon = 4e-16);
        assert_relative_eq!(w, weight, max_relative = 3e-14);
    }
}

#[test]
fn gauss_rules_are_those_of_the_table() {
    GAUSS.iter().for_each(|table| assert_rule(&gauss(table.len()), table));
}

#[test]
fn gauss_lobatto_rules_are_those_of_the_table() {
    LOBATTO.iter().for_each(|table| assert_rule(&gauss_lobatto(table.len()), table));
}

#[test]
fn gauss_lobatto_jacobi_rules_are_those_of_the_table() {
    for table in LOBATTO_JACOBI {
        let rule = gauss_lobatto_jacobi(table.len());
        for ((x, w), (point, weight)) in rule.points.iter().zip(&rule.weights).zip(*table) {
            assert_abs_diff_eq!(x, point, epsilon = 3e-15);
            assert_abs_diff_eq!(w, weight, epsilon = 3e-15);
        }
    }
}

/// `int x^k (1 + x)^a dx` over `[-1, 1]` for a = 0 or 1.
fn monomial(k: usize, a: usize) -> f64 {
    let even = |k: usize| {
        if k.is_multiple_of(2) { 2.0 / (k + 1) as f64 } else { 0.0 }
    };
    even(k) + if a == 1 { even(k + 1) } else { 0.0 }
}

#[test]
fn rules_are_exact_to_their_degree_and_not_one_further() {
    let sum =
        |rule: &Quadrature, k: usize| -> f64 { rule.points.iter().zip(&rule.weights).map(|(x, w)| w * x.powi(k as i32)).sum() };
    for n in 2..=20 {
        for (rule, exact, weight) in
            [(gauss(n), 2 * n - 1, 0), (gauss_lobatto(n), 2 * n - 3, 0), (gauss_lobatto_jacobi(n), 2 * n - 3, 1)]
        {
            for k in 0..=exact {
                let difference = sum(&rule, k) - monomial(k, weight);
                assert!(difference.abs() < 3e-15, "n = {n}, k = {k}, weight {weight}: {difference:.1e}");
            }
            if n <= 8 {
                assert!((sum(&rule, exact + 1) - monomial(exact + 1, weight)).abs() > 1e-6, "n = {n}");
            }
        }
    }
}

#[test]
fn the_jacobi_weight_at_the_axis_is_positive() {
    for n in 2..=25 {
        assert!(gauss_lobatto_jacobi(n).weights.iter().all(|w| *w > 0.0), "n = {n}");
    }
}

#[test]
fn legendre_polynomials_are_orthogonal() {
    let rule = gauss(26);
    for i in 0..=24 {
        for j in 0..=24 {
            let sum: f64 =
                rule.points.iter().zip(&rule.weights).map(|(x, w)| w * legendre(24, *x)[i] * legendre(24, *x)[j]).sum();
            let norm = if i == j { 2.0 / (2 * i + 1) as f64 } else { 0.0 };
            assert_abs_diff_eq!(sum, norm, epsilon = 3e-15);
        }
    }
}

#[test]
fn shape_functions_vanish_at_the_ends_have_parity_and_orthonormal_slopes() {
    let at = |x| shape_functions(24, x);
    for k in 2..=24 {
        for x in [-1.0, 1.0] {
            assert_abs_diff_eq!(at(x).0[k], 0.0, epsilon = 1e-15);
        }
        let parity = if k % 2 == 0 { 1.0 } else { -1.0 };
        assert_abs_diff_eq!(at(-0.37).0[k], parity * at(0.37).0[k], epsilon = 1e-15);
        let h = 1e-6;
        let slope = (at(0.2 + h).0[k] - at(0.2 - h).0[k]) / (2.0 * h);
        assert_abs_diff_eq!(at(0.2).1[k], slope, epsilon = 1e-8);
    }
    let rule = gauss(26);
    for i in 2..=24 {
        for j in 2..=24 {
            let sum: f64 = rule.points.iter().zip(&rule.weights).map(|(x, w)| w * at(*x).1[i] * at(*x).1[j]).sum();
            assert_abs_diff_eq!(sum, f64::from(u8::from(i == j)), epsilon = 3e-14);
        }
    }
}

#[test]
fn lagrange_polynomials_interpolate_and_sum_to_one() {
    let points = gauss_lobatto(9).points;
    let weights = barycentric_weights(&points);
    let f = |x: f64| 3.0 * x.powi(8) - x.powi(5) + 0.5;
    for x in [-1.0, -0.3, points[3], 0.71, 1.0] {
        let l = lagrange(&points, &weights, x);
        assert_abs_diff_eq!(l.iter().sum::<f64>(), 1.0, epsilon = 1e-14);
        let value: f64 = l.iter().zip(&points).map(|(l, p)| l * f(*p)).sum();
        assert_abs_diff_eq!(value, f(x), epsilon = 1e-13);
    }
}

#[test]
fn rules_of_too_few_points_end_with_a_word() {
    let few: [fn() -> Quadrature; 5] =
        [|| gauss(0), || gauss_lobatto(0), || gauss_lobatto(1), || gauss_lobatto_jacobi(0), || gauss_lobatto_jacobi(1)];
    for rule in few {
        let panic = std::panic::catch_unwind(rule).unwrap_err();
        let word = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
        assert!(word.is_some_and(|word| word.starts_with("a rule")), "{word:?}");
    }
}
