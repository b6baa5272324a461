//! Steps far beyond the explicit bound, extreme exponents, contact that opens and closes.

use crate::closed_form::{half_plane, mean, points, problem, rule, winkler};
use approx::assert_relative_eq;
use shapeopt::{Evolution, EvolutionStatus, Scheme, Stepping, Until, WearProblem, WearState};

const MODULUS: f64 = 115e3;
const WEAR: f64 = 1e-7;

fn run(run: &WearProblem) -> (Vec<WearState>, EvolutionStatus) {
    let mut evolution = Evolution::new(run).unwrap();
    let states = evolution.by_ref().collect();
    (states, evolution.status().clone())
}

/// Flat punch on a half-plane.
fn flat(b: f64, moment: Option<f64>) -> WearProblem {
    let points = points(60);
    let system = half_plane(&points, moment, MODULUS);
    let gap = vec![0.0; points.len()];
    problem(points, system, rule(WEAR, b), gap)
}

#[test]
fn steps_of_a_million_times_the_explicit_bound_arrive_at_the_steady_state() {
    for b in [0.05, 0.5, 1.0, 2.0, 5.0, 20.0] {
        for scheme in [Scheme::BackwardEuler, Scheme::Sdirk2, Scheme::Sdirk4] {
            let mut problem = flat(b, None);
            let limit = Evolution::new(&problem).unwrap().run_in().unwrap().explicit_limit;
            problem.scheme = scheme;
            problem.stepping = Stepping::Fixed(1e6 * limit);
            problem.until = Until::Time(5e6 * limit);
            let (states, status) = run(&problem);
            assert_eq!(status, EvolutionStatus::TimeReached);
            let residuals: Vec<f64> = states.iter().map(|s| s.steady_residual).collect();
            println!("b {b} {scheme:?}: limit {limit:.3e} s, residuals {residuals:?}, {} systems", states[5].newton_iterations);
            assert!(residuals.windows(2).all(|w| w[1] < w[0] || w[1] < 1e-10));
        }
    }
}

#[test]
fn any_exponent_wears_to_the_uniform_pressure() {
    for b in [0.05, 0.2, 0.5, 1.0, 2.0, 5.0, 20.0] {
        let problem = flat(b, None);
        let (states, status) = run(&problem);
        let last = &states[states.len() - 1];
        println!("b {b}: {} steps, {} rejected, {} systems", last.step, last.rejected, last.newton_iterations);
        assert_eq!(status, EvolutionStatus::Steady);
        for p in &last.pressure {
            assert_relative_eq!(*p, 1000.0 / 600.0, max_relative = 1e-7);
        }
    }
}

#[test]
fn without_shear_phi_never_grows_in_implicit_euler_steps() {
    for b in [0.5, 1.0, 2.0] {
        for moment in [None, Some(3000.0), Some(15000.0)] {
            let mut problem = flat(b, moment);
            problem.scheme = Scheme::BackwardEuler;
            problem.stepping = Stepping::Adaptive { accuracy: 1e-2 };
            let (states, status) = run(&problem);
            assert_eq!(status, EvolutionStatus::Steady);
            assert!(states[states.len() - 1].lyapunov < states[0].lyapunov);
            for pair in states.windows(2) {
                assert!(pair[1].lyapunov <= pair[0].lyapunov * (1.0 + 1e-13));
            }
        }
    }
}

/// Beyond the kern the punch ends in partial contact: b = 1 gives the triangle of length 3 (c - e), e = M / F.
///
/// ```text
///            F       pressure from the edge at c: p (1 - t / l), l = 3 (c - e)
///      ______|__
///     |     e|  |
///     |_________|
///          /|
///        /  |
/// ```
#[test]
fn beyond_the_kern_contact_opens_to_the_triangle() {
    let (b, count) = (1.0, 240);
    let points = points(count);
    let system = half_plane(&points, Some(15000.0), MODULUS);
    let gap = vec![0.0; count];
    let problem = problem(points, system, rule(WEAR, b), gap);
    let (states, status) = run(&problem);
    let last = &states[states.len() - 1];
    assert_eq!(status, EvolutionStatus::Steady);
    let length = 3.0 * (30.0 - 15.0);
    let open = last.pressure.iter().filter(|p| **p == 0.0).count();
    println!("{} steps, open {open} of {count}", last.step);
    assert!((open as f64 - (60.0 - length) / 60.0 * count as f64).abs() <= 1.0);
    let peak = 2.0 * 1000.0 / (10.0 * length);
    for (point, p) in problem.points.iter().zip(&last.pressure) {
        let expected = peak * (1.0 - (30.0 - point.position.x) / length).max(0.0);
        assert!((p - expected).abs() < 1e-3 * peak, "{} {p} {expected}", point.position.x);
    }
}

/// A crown touches in the middle, wears flat, and ends in full contact.
#[test]
fn a_crown_closes_by_wear() {
    for b in [0.5, 1.0, 2.0] {
        let mut problem = flat(b, None);
        problem.gap = problem.points.iter().map(|p| 2e-5 * p.position.x.powi(2)).collect();
        let (states, status) = run(&problem);
        let closed = |s: &WearState| s.pressure.iter().filter(|p| **p > 0.0).count();
        let last = &states[states.len() - 1];
        println!(
            "b {b}: {} -> {} points, {} steps, {} rejected, {} systems",
            closed(&states[0]),
            closed(last),
            last.step,
            last.rejected,
            last.newton_iterations
        );
        assert_eq!(status, EvolutionStatus::Steady);
        assert!(closed(&states[0]) < 30);
        assert_eq!(closed(last), 60);
        for state in &states {
            assert_relative_eq!(mean(&problem.points, &state.pressure), 1000.0 / 600.0, max_relative = 1e-11);
            assert!(state.opening.iter().zip(&state.pressure).all(|(o, p)| *o >= 0.0 && *p >= 0.0 && (*o == 0.0 || *p == 0.0)));
        }
        // The volume is what the gap says.
        let volume: f64 =
            problem.points.iter().zip(last.gap.iter().zip(&problem.gap)).map(|(p, (g, g0))| p.weight * (g - g0)).sum();
        assert_relative_eq!(last.volume[0], volume, max_relative = 1e-10);
    }
}

/// A step in the gap with uniform pressure on the part in contact is no steady state: the other part comes closer.
#[test]
fn a_step_that_still_closes_is_not_steady() {
    let points = points(20);
    let system = winkler(&points, None, 500.0);
    let gap = points.iter().map(|p| if p.position.x > 0.0 { 0.05 } else { 0.0 }).collect();
    let problem = problem(points, system, rule(WEAR, 1.0), gap);
    let (states, status) = run(&problem);
    assert_eq!(status, EvolutionStatus::Steady);
    assert!(states[0].steady_residual > 0.5);
    let last = &states[states.len() - 1];
    assert!(last.pressure.iter().all(|p| (p * 0.6 - 1.0).abs() < 1e-7));
}

/// Rough gaps touch in few, scattered points: the start and the run keep every condition of contact.
#[test]
fn rough_gaps_wear_in() {
    let count = 120;
    // A fixed sequence of the linear congruence of Park and Miller.
    let mut seed = 20_070_518_u64;
    let mut random = || {
        seed = seed * 48_271 % 2_147_483_647;
        seed as f64 / 2_147_483_647.0
    };
    for (height, b) in [(1e-4, 1.0), (1e-3, 1.0), (1e-2, 0.5), (1e-2, 2.0), (1.0, 1.0)] {
        let mut problem = flat(b, Some(0.0));
        problem.points = points(count);
        problem.stages[0].system = half_plane(&problem.points, Some(0.0), MODULUS);
        problem.stages[0].speeds = vec![5.0; count];
        problem.gap = (0..count).map(|_| height * random()).collect();
        problem.stepping = Stepping::Adaptive { accuracy: 1e-2 };
        problem.scheme = Scheme::Sdirk2;
        let start = std::time::Instant::now();
        let (states, status) = run(&problem);
        let closed = |s: &WearState| s.pressure.iter().filter(|p| **p > 0.0).count();
        let last = &states[states.len() - 1];
        println!(
            "height {height} b {b}: {} -> {} of {count} points, {} steps, {} rejected, {} systems, {:.2} s, {status}",
            closed(&states[0]),
            closed(last),
            last.step,
            last.rejected,
            last.newton_iterations,
            start.elapsed().as_secs_f64()
        );
        assert_eq!(status, EvolutionStatus::Steady);
        assert_eq!(closed(last), count);
        for p in &last.pressure {
            assert_relative_eq!(*p, 1000.0 / 600.0, max_relative = 1e-7);
        }
    }
}
