//! Wear of both bodies: fresh, congruent and revolving counter-faces end where the wear crate says.

use crate::closed_form::{mean, points, winkler};
use approx::assert_relative_eq;
use contact::ContactSystem;
use faer::Mat;
use nalgebra::Vector3;
use shapeopt::{Evolution, EvolutionStatus, WearProblem, WearState};
use wear::{Counterface, Functional, RigidMode, Surface, SurfacePoint, WearPair, optimal_pressure};

const RADIUS: f64 = 200.0;
const THICKNESS: f64 = 10.0;

fn end(problem: &WearProblem) -> WearState {
    let mut evolution = Evolution::new(problem).unwrap();
    evolution.by_ref().for_each(drop);
    assert_eq!(*evolution.status(), EvolutionStatus::Steady);
    evolution.state().clone()
}

/// The steady pressure of the wear crate at the same points.
fn reference(problem: &WearProblem, force: f64) -> Vec<f64> {
    let mut surface = Surface::from_points(problem.points.clone()).unwrap();
    if let Some(area) = problem.track_area {
        surface = surface.with_track_area(area);
    }
    let mut wear = wear::Problem::new(surface, problem.wear.rules[0].clone(), vec![RigidMode::press_down(force)]);
    wear.wear = problem.wear.clone();
    wear.counterface = problem.counterface;
    wear.functional = Functional::Steady;
    optimal_pressure(&wear).unwrap().pressure
}

/// A strip whose sliding speed grows along it.
fn strip(wear: WearPair, counterface: Counterface) -> WearProblem {
    let mut points = points(40);
    points.iter_mut().for_each(|p| p.sliding_speed = 5.0 + 0.1 * p.position.x);
    let system = winkler(&points, None, 500.0);
    let gap = vec![0.0; points.len()];
    WearProblem::new(points, wear, counterface, gap, system)
}

#[test]
fn on_a_congruent_counterface_the_rates_add() {
    let wear = WearPair::archard([1e-7, 3e-7], [1.0, 0.5], [0.5, 1.5]);
    let problem = strip(wear, Counterface::Congruent);
    let state = end(&problem);
    for (p, expected) in state.pressure.iter().zip(reference(&problem, 1000.0)) {
        assert_relative_eq!(*p, expected, max_relative = 1e-8);
    }
    // All that is gone from the gap is gone from the bodies.
    let volume: f64 = problem.points.iter().zip(&state.gap).map(|(p, g)| p.weight * g).sum();
    assert_relative_eq!(state.volume[0] + state.volume[1], volume, max_relative = 1e-10);
    assert!(state.volume.iter().all(|v| *v > 0.0));
}

#[test]
fn a_fresh_counterface_drops_out_of_the_gap() {
    let wear = |k2| WearPair::archard([1e-7, k2], [1.0; 2], [0.5; 2]);
    let (with, without) = (end(&strip(wear(3e-7), Counterface::Fresh)), end(&strip(wear(0.0), Counterface::Fresh)));
    assert_eq!(with.pressure, without.pressure);
    assert_eq!(with.gap, without.gap);
    assert_relative_eq!(with.volume[1], 3.0 * with.volume[0], max_relative = 1e-12);
    assert_eq!(without.volume[1], 0.0);
}

/// Winkler layer on an arc of 2 x 30 degrees, pressed down by 10 kN.
fn arc(count: usize, wear: WearPair, counterface: Counterface) -> WearProblem {
    let half = std::f64::consts::PI / 6.0;
    let step = 2.0 * half / count as f64;
    let points: Vec<SurfacePoint> = (0..count)
        .map(|i| {
            let (sine, cosine) = (-half + step * (i as f64 + 0.5)).sin_cos();
            SurfacePoint {
                position: RADIUS * Vector3::new(sine, 0.0, cosine),
                normal: Vector3::new(sine, 0.0, cosine),
                weight: RADIUS * step * THICKNESS,
                sliding_speed: 500.0,
                drag: Vector3::new(-cosine, 0.0, sine),
            }
        })
        .collect();
    let influence = Mat::from_fn(count, 1, |i, _| -points[i].normal.z);
    let system = ContactSystem {
        compliance: Mat::from_fn(count, count, |i, j| if i == j { 1.0 / (500.0 * points[i].weight) } else { 0.0 }),
        balance: influence.clone(),
        influence,
        stiffness: Mat::zeros(1, 1),
        opening: vec![0.0; count],
        load: vec![10000.0],
        symmetric: true,
    };
    WearProblem {
        track_area: Some(2.0 * std::f64::consts::PI * RADIUS * THICKNESS),
        ..WearProblem::new(points, wear, counterface, vec![0.0; count], system)
    }
}

#[test]
fn a_revolving_drum_takes_wear_evenly_and_flattens_the_cosine() {
    let wear = WearPair::archard([1e-7; 2], [1.0; 2], [0.5; 2]);
    let problem = arc(120, wear, Counterface::Revolving);
    let state = end(&problem);
    for (p, expected) in state.pressure.iter().zip(reference(&problem, 10000.0)) {
        assert_relative_eq!(*p, expected, max_relative = 1e-8);
    }
    // The root of p is linear in the cosine.
    let (edge, middle) = (0, 60);
    let cosine = |i: usize| problem.points[i].normal.z;
    let slope = (state.pressure[middle].sqrt() - state.pressure[edge].sqrt()) / (cosine(middle) - cosine(edge));
    let root = |c: f64| state.pressure[edge].sqrt() + slope * (c - cosine(edge));
    let ratio = (root((std::f64::consts::PI / 6.0).cos()) / root(1.0)).powi(2);
    println!("edge over centre {ratio:.4}, receded {:.4e} mm, {} steps", state.recession, state.step);
    assert_relative_eq!(ratio, 0.714, max_relative = 1e-3);
    // What the drum loses along its track is what the shoe's contact takes off it.
    assert_relative_eq!(state.recession * problem.track_area.unwrap(), state.volume[1], max_relative = 1e-10);
    assert_relative_eq!(
        mean(&problem.points, &state.gap) - mean(&problem.points, &state.worn),
        state.recession,
        max_relative = 1e-10
    );
}

#[test]
fn a_drum_that_does_not_wear_leaves_the_cosine_power() {
    for b in [0.5, 1.0, 2.0] {
        let wear = WearPair::archard([1e-7, 0.0], [1.0; 2], [b; 2]);
        let problem = arc(120, wear, Counterface::Revolving);
        let state = end(&problem);
        let weight: f64 = problem.points.iter().map(|p| p.weight * p.normal.z.powf(1.0 / b + 1.0)).sum();
        for (point, p) in problem.points.iter().zip(&state.pressure) {
            assert_relative_eq!(*p, 10000.0 / weight * point.normal.z.powf(1.0 / b), max_relative = 1e-8);
        }
    }
}
