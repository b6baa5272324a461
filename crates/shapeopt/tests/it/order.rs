//! Orders of the integrators by step halving, and honesty of the error estimate.

use crate::closed_form::{half_plane, points, problem, rule};
use shapeopt::{Evolution, Scheme, Stepping, Until, WearProblem, WearState};

/// A tilted wedge on a half-plane, in full contact, with b = 2.
fn wedge() -> WearProblem {
    let points = points(24);
    let system = half_plane(&points, Some(2000.0), 115e3);
    let gap = points.iter().map(|p| 1e-7 * (p.position.x - 5.0).powi(2)).collect();
    let mut run = problem(points, system, rule(1e-7, 2.0), gap);
    run.until = Until::Time(60.0);
    run
}

fn last(run: &WearProblem, scheme: Scheme, stepping: Stepping) -> WearState {
    let run = WearProblem { scheme, stepping, ..run.clone() };
    let mut evolution = Evolution::new(&run).unwrap();
    evolution.by_ref().for_each(drop);
    evolution.state().clone()
}

fn pressure_error(a: &WearState, b: &WearState) -> f64 {
    let largest = b.pressure.iter().copied().fold(0.0, f64::max);
    a.pressure.iter().zip(&b.pressure).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) / largest
}

#[test]
fn halving_the_step_shows_the_order_of_each_scheme() {
    let run = wedge();
    let reference = last(&run, Scheme::Sdirk4, Stepping::Fixed(60.0 / 2000.0));
    for (scheme, order, steps) in [(Scheme::BackwardEuler, 1.0, 160.0), (Scheme::Sdirk2, 2.0, 80.0), (Scheme::Sdirk4, 4.0, 40.0)]
    {
        let errors =
            [1.0, 2.0, 4.0].map(|k| pressure_error(&last(&run, scheme, Stepping::Fixed(60.0 / (k * steps))), &reference));
        let orders = [0, 1].map(|k: usize| (errors[k] / errors[k + 1]).log2());
        println!("{scheme:?}: {errors:?} orders {orders:.3?}");
        assert!((orders[1] - order).abs() < 0.12 * order);
    }
}

#[test]
fn the_error_falls_with_the_accuracy_asked_for() {
    let run = wedge();
    let reference = last(&run, Scheme::Sdirk4, Stepping::Fixed(60.0 / 2000.0));
    for (scheme, finest) in [(Scheme::BackwardEuler, 1e-3), (Scheme::Sdirk2, 1e-5), (Scheme::Sdirk4, 1e-5)] {
        for accuracy in [1e-2, 1e-3, 1e-4, 1e-5].into_iter().filter(|a| *a >= finest) {
            let state = last(&run, scheme, Stepping::Adaptive { accuracy });
            let error = pressure_error(&state, &reference);
            println!("{scheme:?} {accuracy:.0e}: {} steps, error {error:.2e}", state.step);
            assert!(error < 3.0 * accuracy);
        }
    }
}
