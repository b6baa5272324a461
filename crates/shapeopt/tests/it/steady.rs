//! Runs end at the steady pressure, from wherever they start.

use crate::bodies::{drum, punch, surface_points};
use contact::{ContactLoad, ContactOperator, ContactSystem, Motion, Pair};
use shapeopt::{Evolution, EvolutionStatus, WearProblem, WearState};
use std::time::Instant;
use wear::{Counterface, SurfacePoint, WearPair};

const BETA: f64 = 2e-4;
const FRICTION: f64 = 0.25;

fn rule(b: f64) -> WearPair {
    WearPair::from_beta([BETA, 0.0], FRICTION, [1.0; 2], [b; 2]).unwrap()
}

/// Points and system of the punch under 1 kN, sliding with or without shear on the bodies.
fn punch_system(degree: usize, layers: usize, shear: bool) -> (Vec<SurfacePoint>, ContactSystem) {
    let bodies = punch(degree, layers, false);
    let [body, plate] = bodies.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let friction = if shear { FRICTION } else { 0.0 };
    let mut load = ContactLoad::factors(&[], &[]).sliding(friction, vec![1.0; operator.points().len()]);
    load.motions[1] = Motion::Free { resultant: -1000.0 };
    (surface_points(&operator, 5.0), operator.system(&load).unwrap())
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
fn run(name: &str, problem: &WearProblem) -> WearState {
    let start = Instant::now();
    let mut evolution = Evolution::new(problem).unwrap();
    for state in &mut evolution {
        if std::env::var("TRACE").is_ok() {
            println!(
                "{} t {:.3e} h {:.3e} next {:.2e} err {:.1e} res {:.3e} phi {:.8e} newton {} rejected {} pmax {:.4} open {}",
                state.step, state.time, state.step_size, state.next_step, state.error, state.steady_residual, state.lyapunov,
                state.newton_iterations, state.rejected,
                state.pressure.iter().copied().fold(0.0, f64::max),
                state.pressure.iter().filter(|p| **p == 0.0).count()
            );
        }
    }
    let state = evolution.state().clone();
    println!(
        "{name}: {} points, {} steps, {} rejected, {} systems, {:.3} s; t {:.4e} residual {:.2e}, Phi grew {:.1e}: {}",
        problem.points.len(), state.step, state.rejected, state.newton_iterations, start.elapsed().as_secs_f64(), state.time,
        state.steady_residual, state.lyapunov_increase, evolution.status()
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
            let (points, system) = punch_system(8, 8, shear);
            let gap = vec![0.0; points.len()];
            let problem = WearProblem::new(points, rule(b), Counterface::Fresh, gap, system);
            let state = run(&format!("punch b {b} shear {shear}"), &problem);
            assert_pressure(&problem, &state, |_| 1000.0 / 600.0);
        }
    }
}

#[test]
fn drum_wears_to_the_cosine_power() {
    let b = 0.5;
    for friction in [0.0, FRICTION] {
        let (points, system) = drum_system(8, 8, friction);
        let gap = vec![0.0; points.len()];
        let problem = WearProblem::new(points, rule(b), Counterface::Fresh, gap, system);
        let state = run(&format!("drum mu {friction}"), &problem);
        let cosine: f64 = problem.points.iter().map(|p| p.weight * p.normal.z.powf(1.0 / b + 1.0)).sum();
        assert_pressure(&problem, &state, |p| 10000.0 / cosine * p.normal.z.powf(1.0 / b));
    }
}
