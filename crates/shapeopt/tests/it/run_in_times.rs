//! Times of the running-in against an exact solution.
//!
//! With b = 1 and full contact the deviation of the pressure from the mean obeys a linear equation: by `z = W^(1/2) (p - mean)` and an
//! orthonormal basis Q of what is orthogonal to `W^(1/2) Psi`, `c = Q^T z` follows `Q^T W^(1/2) A W^(1/2) Q c' = -k v c`. Its eigenvectors
//! decay as `exp(-k v t / lambda)`, and `||p - mean||` in the area norm is `||c||`.

use crate::closed_form::{FORCE, SPEED, gap_for, half_plane, mean, points, problem, rule};
use nalgebra::{DMatrix, DVector};
use shapeopt::{Evolution, Times, Until, WearProblem, WearState};

const WEAR: f64 = 1e-7;
const MODULUS: f64 = 1e5;

/// Decay rates and amplitudes of the deviation over `||mean||`.
fn modes(run: &WearProblem, start: &[f64]) -> Vec<[f64; 2]> {
    let (n, system) = (run.points.len(), &run.stages[0].system);
    let root: Vec<f64> = run.points.iter().map(|p| p.weight.sqrt()).collect();
    let across = DVector::from_fn(n, |i, _| root[i] * system.influence[(i, 0)]).normalize();
    // Householder's reflection that takes the first unit vector to it: the other columns are Q.
    let mut v = across.clone();
    v[0] += across[0].signum();
    let reflection = DMatrix::identity(n, n) - &v * v.transpose() * (2.0 / v.norm_squared());
    let q = reflection.columns(1, n - 1).into_owned();
    let compliance = DMatrix::from_fn(n, n, |i, j| root[i] * system.compliance[(i, j)] * root[j]);
    let reduced = q.transpose() * compliance * &q;
    let eigen = (0.5 * (&reduced + reduced.transpose())).symmetric_eigen();
    let level = mean(&run.points, start);
    let z = DVector::from_fn(n, |i, _| root[i] * (start[i] - level));
    let amplitudes = eigen.eigenvectors.transpose() * q.transpose() * z;
    let size = level * root.iter().map(|r| r * r).sum::<f64>().sqrt();
    eigen.eigenvalues.iter().zip(amplitudes.iter()).map(|(lambda, c)| [WEAR * SPEED / lambda, c / size]).collect()
}

/// Time at which the deviation is `deviation`, by bisection.
fn time_of(modes: &[[f64; 2]], deviation: f64) -> f64 {
    let away = |t: f64| modes.iter().map(|[rate, c]| (c * (-rate * t).exp()).powi(2)).sum::<f64>().sqrt();
    let (mut low, mut high) = (0.0, 1.0);
    while away(high) > deviation {
        high *= 2.0;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if away(middle) > deviation { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Largest relative error of the times, distances and volumes to these deviations from the steady pressure, and the number of steps.
fn error(mut run: WearProblem, accuracy: f64, deviations: &[f64]) -> (f64, usize) {
    let deviation = deviations.iter().copied().fold(1.0, f64::min);
    run.times = Some(Times { deviation, accuracy });
    run.until = Until::Steady { residual: 1e-13, not_before: 0.0 };
    let mut evolution = Evolution::new(&run).unwrap();
    let states: Vec<WearState> = evolution.by_ref().collect();
    let modes = modes(&run, &states[0].pressure);
    let mut worst = 0.0_f64;
    for deviation in deviations.iter().copied() {
        let exact = time_of(&modes, deviation);
        let found = evolution.settling(&states, deviation).unwrap();
        let relative = |value: f64, wanted: f64| (value / wanted - 1.0).abs();
        worst = worst.max(relative(found.time, exact)).max(relative(found.distance, SPEED * exact));
        worst = worst.max(relative(found.volume[0], WEAR * FORCE * SPEED * exact));
    }
    (worst, states.len())
}

/// Within the accuracy for the times to 1 %, within three times that for those to 1e-6, where errors of six decades add up.
#[test]
fn run_in_times_are_as_accurate_as_the_run_is_asked_to_be() {
    let points = points(48);
    let flat = || problem(points.clone(), half_plane(&points, None, MODULUS), rule(WEAR, 1.0), vec![0.0; 48]);
    let hilly = || {
        let system = half_plane(&points, None, MODULUS);
        let gap = gap_for(&system, &points, |p| 5.0 / 3.0 * (1.0 + 0.8 * (0.2 * p.position.x + 0.3).sin()));
        problem(points.clone(), system, rule(WEAR, 1.0), gap)
    };
    for (name, run) in [("flat", &flat as &dyn Fn() -> WearProblem), ("hilly", &hilly)] {
        for accuracy in [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
            let (near, _) = error(run(), accuracy, &[1e-1, 1e-2]);
            assert!(near <= accuracy, "{name}: the times to 1 % are off by {near:e} at an accuracy of {accuracy:e}");
            let (far, steps) = error(run(), accuracy, &[1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6]);
            assert!(far <= 3.0 * accuracy, "{name}: the times to 1e-6 are off by {far:e} at an accuracy of {accuracy:e}");
            assert!(steps < 400, "{name}: {steps} steps at an accuracy of {accuracy:e}");
        }
    }
}
