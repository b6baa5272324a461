//! Deviations from the steady state wear away at the rates of theory.
//!
//! ```text
//!        F                 Winkler layer k_f: p - mean falls as exp(-k_f beta~ v t), every shape alike
//!     ___v___              half-plane E*: slowest rate b beta~ v p^(b-1) E* / (c kappa),
//!    |_______|             kappa = .9969498 (approach free), .5791503, .3902214 (even modes: the first and third),
//!  ~~~~~~~~~~~~~           .5791503, .4194333 (approach and tilt free)
//!    2 c
//! ```

use crate::closed_form::{
    FORCE, HALF_WIDTH, SPEED, THICKNESS, gap_for, half_plane, mean, periodic_half_plane, points, problem, rule, winkler,
};
use approx::assert_relative_eq;
use shapeopt::{Evolution, Scheme, Stepping, Until};

const MODULUS: f64 = 115e3;
const WEAR: f64 = 1e-7;

/// Pressure of the steady state.
fn steady() -> f64 {
    FORCE / (2.0 * HALF_WIDTH * THICKNESS)
}

#[test]
fn on_a_winkler_layer_every_deviation_falls_exponentially() {
    let (foundation, count) = (500.0, 40);
    let points = points(count);
    let gap: Vec<f64> = points.iter().map(|p| 1e-4 * (0.2 * p.position.x).sin() + 1e-6 * (p.position.x + 3.0).powi(2)).collect();
    let system = winkler(&points, None, foundation);
    let time = 2.0 / (foundation * WEAR * SPEED);
    let mut run = problem(points, system, rule(WEAR, 1.0), gap);
    run.until = Until::Time(time);
    run.stepping = Stepping::Adaptive { accuracy: 1e-10 };
    let states: Vec<_> = Evolution::new(&run).unwrap().collect();
    let (first, last) = (&states[0], &states[states.len() - 1]);
    let average = mean(&run.points, &last.pressure);
    assert_relative_eq!(average, steady(), max_relative = 1e-13);
    for i in 0..count {
        let expected = steady() + (first.pressure[i] - steady()) * (-2.0_f64).exp();
        assert_relative_eq!(last.pressure[i], expected, max_relative = 1e-8);
    }
    assert_relative_eq!(last.distance, SPEED * time, max_relative = 1e-12);
}

/// Slowest times at the steady state, as `T b beta~ v p^(b-1) E* / c`, extrapolated in the cell size.
fn half_plane_numbers(b: f64, moment: Option<f64>, modes: usize) -> Vec<f64> {
    let numbers = |count: usize| -> Vec<f64> {
        let points = points(count);
        let system = half_plane(&points, moment, MODULUS);
        let gap = gap_for(&system, &points, |_| steady());
        let run = problem(points, system, rule(WEAR, b), gap);
        let mut evolution = Evolution::new(&run).unwrap();
        evolution.by_ref().for_each(drop);
        let rate = b * WEAR * SPEED * steady().powf(b - 1.0) * MODULUS / HALF_WIDTH;
        evolution.run_in().unwrap().times.iter().take(modes).map(|t| t * rate).collect()
    };
    let (coarse, middle, fine) = (numbers(100), numbers(200), numbers(400));
    (0..modes)
        .map(|k| {
            let ratio = (fine[k] - middle[k]) / (middle[k] - coarse[k]);
            fine[k] + (fine[k] - middle[k]) * ratio / (1.0 - ratio)
        })
        .collect()
}

#[test]
fn half_plane_modes_have_the_kappa_of_theory() {
    for b in [1.0, 2.0] {
        let free = half_plane_numbers(b, None, 3);
        let tilting = half_plane_numbers(b, Some(0.0), 2);
        println!("b {b}: {free:.8?} {tilting:.8?}");
        for (found, kappa) in free.iter().zip([0.9969498, 0.5791503, 0.3902214]) {
            assert_relative_eq!(*found, kappa, max_relative = 1e-5);
        }
        for (found, kappa) in tilting.iter().zip([0.5791503, 0.4194333]) {
            assert_relative_eq!(*found, kappa, max_relative = 1e-5);
        }
    }
}

#[test]
fn simulated_run_in_distance_is_that_of_the_slowest_mode() {
    for b in [0.5, 1.0, 2.0] {
        let points = points(80);
        let system = half_plane(&points, None, MODULUS);
        // A wedge: both odd and even modes.
        let gap: Vec<f64> = points.iter().map(|p| 1e-6 * p.position.x.abs() + 2e-6 * (p.position.x + 30.0)).collect();
        let mut run = problem(points, system, rule(WEAR, b), gap);
        run.stepping = Stepping::Adaptive { accuracy: 1e-7 };
        let mut evolution = Evolution::new(&run).unwrap();
        let states: Vec<_> = evolution.by_ref().collect();
        let slowest = evolution.run_in().unwrap().distances[0];
        // Between residuals of 1e-4 and 1e-6 only the slowest mode is left.
        let inside: Vec<_> = states.iter().filter(|s| (1e-6..1e-4).contains(&s.steady_residual)).collect();
        let (from, to) = (inside[0], inside[inside.len() - 1]);
        let simulated = (to.distance - from.distance) / (from.steady_residual / to.steady_residual).ln();
        println!("b {b}: {slowest:.6} {simulated:.6} ({} states)", inside.len());
        assert_relative_eq!(simulated, slowest, max_relative = 1e-2);
    }
}

/// Growth of the shortest ripple, a millionth of the pressure from point to point, in 100 explicit steps of a multiple of the bound.
fn explicit_ripple(b: f64, factor: f64) -> f64 {
    let count = 60;
    let points = points(count);
    let system = periodic_half_plane(&points, MODULUS);
    let gap = gap_for(&system, &points, |_| steady());
    let mut run = problem(points, system, rule(WEAR, b), gap);
    let limit = Evolution::new(&run).unwrap().run_in().unwrap().explicit_limit;
    let cell = 2.0 * HALF_WIDTH / count as f64;
    let expected = 4.0 * cell / (std::f64::consts::PI * b * WEAR * steady().powf(b - 1.0) * MODULUS) / SPEED;
    assert_relative_eq!(limit, expected, max_relative = 1e-10);
    let height = 1e-6 * steady() * 2.0 * cell / (std::f64::consts::PI * MODULUS);
    run.gap.iter_mut().enumerate().for_each(|(i, g)| *g += if i % 2 == 0 { height } else { -height });
    run.scheme = Scheme::Explicit;
    run.stepping = Stepping::Fixed(factor * limit);
    run.until = Until::Time(100.0 * factor * limit);
    let states: Vec<_> = Evolution::new(&run).unwrap().collect();
    assert_eq!(states.len(), 101);
    states[100].steady_residual / states[0].steady_residual
}

#[test]
fn explicit_steps_below_the_half_plane_bound_settle_and_above_it_do_not() {
    for b in [0.5, 1.0, 2.0] {
        let growth = [0.95, 0.98, 1.02, 1.05].map(|factor| explicit_ripple(b, factor));
        println!("b {b}: {growth:?}");
        assert!(growth[0] < 1e-4 && growth[1] < 0.05);
        assert!(growth[2] > 20.0 && growth[3] > 1e3);
    }
}

/// On a Winkler layer an error of the shape changes the pressure by `k_f` times the error less its mean, and wears away in the layer's distance
/// `1 / (k_f b beta~ p^(b-1))`; on a half-plane that of the slowest mode has its run-in distance.
#[test]
fn an_error_of_the_shape_changes_the_pressure_and_runs_in_as_theory_says() {
    let (foundation, b) = (1e4, 2.0);
    let points = points(40);
    let error: Vec<f64> = points.iter().map(|p| 1e-6 * (p.position.x / 10.0).cos()).collect();
    let average = mean(&points, &error);
    let flat = vec![0.0; points.len()];
    let run = problem(points.clone(), winkler(&points, None, foundation), rule(WEAR, b), flat.clone());
    let pressure = vec![steady(); points.len()];
    let found = shapeopt::tolerances(&run, &pressure, std::slice::from_ref(&error)).unwrap();
    for (change, error) in found[0].change.iter().zip(&error) {
        approx::assert_abs_diff_eq!(*change, -foundation * (error - average), epsilon = 1e-12 * foundation * 1e-6);
    }
    let distance = 1.0 / (foundation * b * WEAR * steady().powf(b - 1.0));
    assert_relative_eq!(found[0].run_in_distance.unwrap(), distance, max_relative = 5e-3);
    // The slowest mode of a half-plane: let a wedge wear until it is alone.
    let mut run = problem(points.clone(), half_plane(&points, None, MODULUS), rule(WEAR, b), flat);
    run.gap = points.iter().map(|p| 2e-6 * (p.position.x + 30.0)).collect();
    run.until = Until::Steady { residual: 1e-5, not_before: 0.0 };
    let mut evolution = Evolution::new(&run).unwrap();
    let late = evolution.by_ref().last().unwrap();
    let slowest = evolution.run_in().unwrap().distances[0];
    let rest: Vec<f64> = late.pressure.iter().map(|p| p - steady()).collect();
    let system = &run.stages[0].system;
    let error: Vec<f64> = (0..points.len())
        .map(|i| -(0..points.len()).map(|j| system.compliance[(i, j)] * rest[j] * points[j].weight).sum::<f64>())
        .collect();
    let found = shapeopt::tolerances(&run, &pressure, &[error]).unwrap();
    let distance = found[0].run_in_distance.unwrap();
    println!("half-plane: {distance:.6} against {slowest:.6} of the slowest mode");
    assert_relative_eq!(distance, slowest, max_relative = 1e-2);
}
