//! Runs end at the steady pressure, from wherever they start.

use crate::bodies::{drum, punch, surface_points};
use contact::{ContactLoad, ContactOperator, ContactSystem, Motion, Pair};
use shapeopt::{Evolution, EvolutionStatus, Scheme, Stepping, Until, WearProblem, WearState};
use std::time::Instant;
use wear::{Counterface, SurfacePoint, WearPair};

pub const BETA: f64 = 2e-4;
pub const FRICTION: f64 = 0.25;

pub fn rule(b: f64) -> WearPair {
    WearPair::from_beta([BETA, 0.0], FRICTION, [1.0; 2], [b; 2]).unwrap()
}

/// Points of the punch and systems under 1 kN, with the shear of sliding times each factor.
pub fn punch_stages<const N: usize>(degree: usize, layers: usize, shear: [f64; N]) -> (Vec<SurfacePoint>, [ContactSystem; N]) {
    let bodies = punch(degree, layers, false);
    let [body, plate] = bodies.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let systems = shear.map(|drag| {
        let mut load = ContactLoad::factors(&[], &[]).sliding(FRICTION, vec![drag; operator.points().len()]);
        load.motions[1] = Motion::Free { resultant: -1000.0 };
        operator.system(&load).unwrap()
    });
    (surface_points(&operator, 5.0), systems)
}

fn drum_system(degree: usize, layers: usize, friction: f64) -> (Vec<SurfacePoint>, ContactSystem) {
    let bodies = drum(degree, layers);
    let [shoe, ring] = bodies.reduced();
    let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let load = ContactLoad::factors(&[1.0], &[]).sliding(friction, vec![-1.0; operator.points().len()]);
    (surface_points(&operator, 500.0), operator.system(&load).unwrap())
}

/// Runs to the end and prints what it took.
pub fn run(name: &str, problem: &WearProblem) -> WearState {
    let start = Instant::now();
    let mut evolution = Evolution::new(problem).unwrap();
    for state in &mut evolution {
        if std::env::var("TRACE").is_ok() {
            println!(
                "{} t {:.3e} h {:.3e} next {:.2e} err {:.1e} res {:.3e} phi {:.8e} newton {} rejected {} pmax {:.4} open {}",
                state.step,
                state.time,
                state.step_size,
                state.next_step,
                state.error,
                state.steady_residual,
                state.lyapunov,
                state.newton_iterations,
                state.rejected,
                state.pressure.iter().copied().fold(0.0, f64::max),
                state.pressure.iter().filter(|p| **p == 0.0).count()
            );
        }
    }
    let state = evolution.state().clone();
    println!(
        "{name}: {} points, {} steps, {} rejected, {} systems, {:.3} s; t {:.4e} residual {:.2e}, Phi grew {:.1e}: {}",
        problem.points.len(),
        state.step,
        state.rejected,
        state.newton_iterations,
        start.elapsed().as_secs_f64(),
        state.time,
        state.steady_residual,
        state.lyapunov_increase,
        evolution.status()
    );
    assert_eq!(*evolution.status(), EvolutionStatus::Steady);
    state
}

fn assert_pressure(problem: &WearProblem, state: &WearState, exact: impl Fn(&SurfacePoint) -> f64) {
    let worst = problem.points.iter().zip(&state.pressure).map(|(p, v)| (v / exact(p) - 1.0).abs()).fold(0.0, f64::max);
    println!("largest relative deviation of the pressure {worst:.2e}");
    assert!(worst < 1e-8);
}

#[test]
fn punch_wears_from_flat_to_uniform_pressure() {
    for b in [1.0, 2.0] {
        for shear in [false, true] {
            let (points, [system]) = punch_stages(8, 8, [f64::from(u8::from(shear))]);
            let gap = vec![0.0; points.len()];
            let problem = WearProblem::new(points, rule(b), Counterface::Fresh, gap, system);
            let state = run(&format!("punch b {b} shear {shear}"), &problem);
            assert_pressure(&problem, &state, |_| 1000.0 / 600.0);
        }
    }
}

/// Twelve layers: points from 1e-9 mm apart, pressures of the start up to some thousand times the mean.
#[test]
fn finely_layered_punch_wears_to_uniform_pressure_for_any_exponent() {
    let (points, systems) = punch_stages(12, 12, [0.0, 1.0]);
    for b in [0.2, 0.5, 1.0, 2.0, 5.0] {
        for (shear, system) in systems.iter().enumerate() {
            let gap = vec![0.0; points.len()];
            let problem = WearProblem::new(points.clone(), rule(b), Counterface::Fresh, gap, system.clone());
            let state = run(&format!("layered punch b {b} shear {shear}"), &problem);
            assert_pressure(&problem, &state, |_| 1000.0 / 600.0);
        }
    }
}

/// Shoe on a drum: the steady pressure is `cos^(1/b)`, not the uniform one, wherever the run starts.
#[test]
fn drum_wears_to_the_cosine_power_from_unworn_and_from_uniform_pressure() {
    let b = 0.5;
    for friction in [0.0, FRICTION] {
        let (points, system) = drum_system(8, 8, friction);
        let n = points.len();
        // The gap that meets a uniform pressure of 5 MPa.
        let uniform: Vec<f64> = (0..n)
            .map(|i| -system.opening[i] - (0..n).map(|j| system.compliance[(i, j)] * 5.0 * points[j].weight).sum::<f64>())
            .collect();
        let mut ends = Vec::new();
        for (name, gap) in [("unworn", vec![0.0; n]), ("uniform", uniform)] {
            let problem = WearProblem::new(points.clone(), rule(b), Counterface::Fresh, gap, system.clone());
            if name == "uniform" {
                // Forces are solved to round-off of the whole force; pressures of points next to the ends, whose areas are a millionth of
                // the surface, feel it most.
                let start = Evolution::new(&problem).unwrap().state().pressure.clone();
                let worst = start.iter().map(|p| (p / 5.0 - 1.0).abs()).fold(0.0, f64::max);
                let misplaced: f64 = points.iter().zip(&start).map(|(point, p)| point.weight * (p / 5.0 - 1.0).abs()).sum();
                let area: f64 = points.iter().map(|p| p.weight).sum();
                println!("start: {:.1e} of the force misplaced, worst pressure off by {worst:.1e}", misplaced / area);
                assert!(misplaced < 1e-11 * area);
            }
            let state = run(&format!("drum mu {friction} {name}"), &problem);
            let cosine: f64 = points.iter().map(|p| p.weight * p.normal.z.powf(1.0 / b + 1.0)).sum();
            assert_pressure(&problem, &state, |p| 10000.0 / cosine * p.normal.z.powf(1.0 / b));
            ends.push(state.gap);
        }
        // The shapes agree up to the rigid part, which moves by the cosine.
        let rise = (ends[0][n / 2] - ends[1][n / 2]) / points[n / 2].normal.z;
        let size = ends[0].iter().zip(&points).map(|(g, p)| (g - ends[0][n / 2] * p.normal.z).abs()).fold(0.0, f64::max);
        for i in 0..n {
            assert!((ends[0][i] - ends[1][i] - rise * points[i].normal.z).abs() < 1e-8 * size);
        }
    }
}

/// Close to the steady state of a sliding punch, whose operator is not symmetric, explicit steps tell on which side of the bound they
/// are: below it they settle; above it a linear rule grows and a convex one (b = 2) oscillates without settling.
#[test]
fn explicit_steps_on_a_sliding_punch_settle_below_the_bound_only() {
    let (points, [system]) = punch_stages(5, 2, [1.0]);
    for b in [1.0, 2.0] {
        let gap = vec![0.0; points.len()];
        let mut problem = WearProblem::new(points.clone(), rule(b), Counterface::Fresh, gap, system.clone());
        problem.until = Until::Steady { residual: 1e-7, not_before: 0.0 };
        let mut evolution = Evolution::new(&problem).unwrap();
        let steady = evolution.by_ref().last().unwrap();
        let modes = evolution.run_in().unwrap();
        let limit = modes.explicit_limit;
        problem.scheme = Scheme::Explicit;
        problem.gap = steady.gap;
        let residual = |factor: f64| {
            let steps = 3000.0;
            let until = Until::Time(steps * factor * limit);
            let run = WearProblem { stepping: Stepping::Fixed(factor * limit), until, ..problem.clone() };
            Evolution::new(&run).unwrap().last().unwrap().steady_residual
        };
        let (below, above) = (residual(0.95), residual(1.05));
        println!(
            "b {b}: limit {limit:.4e} s, slowest {:.4e} s, residual {:.2e} -> {below:.2e}, {above:.2e}",
            modes.times[0], steady.steady_residual
        );
        assert!(below < 0.1 * steady.steady_residual);
        assert!(above > 1e-3);
    }
}
