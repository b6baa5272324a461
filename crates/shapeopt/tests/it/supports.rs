//! Prescribed approach and springs instead of a free force, and the time a run takes to settle.
//!
//! ```text
//!      K / spring       per area: layer k_f in series with the spring K / A
//!     __|___
//!    |______|           uniform pressure falls as exp(-k' beta~ v t), 1/k' = 1/k_f + A/K
//!  ~~~~~~~~~~~~ k_f
//! ```

use crate::closed_form::{HALF_WIDTH, SPEED, THICKNESS, points, problem, rule, winkler};
use approx::assert_relative_eq;
use faer::Mat;
use shapeopt::{Evolution, Stepping, Times, Until, WearProblem, WearState};

const FOUNDATION: f64 = 500.0;
const WEAR: f64 = 1e-7;
const AREA: f64 = 2.0 * HALF_WIDTH * THICKNESS;

fn until(mut run: WearProblem, time: f64) -> (WearState, WearState) {
    run.until = Until::Time(time);
    run.stepping = Stepping::Adaptive { accuracy: 1e-9 };
    let states: Vec<WearState> = Evolution::new(&run).unwrap().collect();
    (states[0].clone(), states[states.len() - 1].clone())
}

#[test]
fn under_a_prescribed_approach_the_pressure_wears_away() {
    let points = points(20);
    let mut system = winkler(&points, None, FOUNDATION);
    let approach = 0.01;
    system.opening = vec![-approach; 20];
    system.influence = Mat::zeros(20, 0);
    system.balance = Mat::zeros(20, 0);
    system.stiffness = Mat::zeros(0, 0);
    system.load.clear();
    let time = 1.5 / (FOUNDATION * WEAR * SPEED);
    let (first, last) = until(problem(points, system, rule(WEAR, 1.0), vec![0.0; 20]), time);
    for (p0, p) in first.pressure.iter().zip(&last.pressure) {
        assert_relative_eq!(*p0, FOUNDATION * approach, max_relative = 1e-13);
        assert_relative_eq!(*p, p0 * (-1.5_f64).exp(), max_relative = 1e-8);
    }
    assert_relative_eq!(last.steady_residual, (-1.5_f64).exp(), max_relative = 1e-8);
}

#[test]
fn a_spring_in_series_slows_the_wear() {
    let points = points(20);
    let mut system = winkler(&points, None, FOUNDATION);
    let spring = 2.0 * FOUNDATION * AREA;
    // Pressed by the spring's own preload.
    system.stiffness = Mat::from_fn(1, 1, |_, _| spring);
    let together = 1.0 / (1.0 / FOUNDATION + AREA / spring);
    let time = 1.5 / (together * WEAR * SPEED);
    let run = problem(points, system, rule(WEAR, 1.0), vec![0.0; 20]);
    let times = Evolution::new(&run).unwrap().run_in().unwrap().times;
    assert_relative_eq!(times[0], 1.0 / (together * WEAR * SPEED), max_relative = 1e-12);
    assert_relative_eq!(times[1], 1.0 / (FOUNDATION * WEAR * SPEED), max_relative = 1e-12);
    let (first, last) = until(run, time);
    for (p0, p) in first.pressure.iter().zip(&last.pressure) {
        assert_relative_eq!(*p, p0 * (-1.5_f64).exp(), max_relative = 1e-8);
    }
}

#[test]
fn settling_tells_when_the_pressure_is_within_a_part_of_steady() {
    let points = points(30);
    let gap: Vec<f64> = points.iter().map(|p| 1e-4 * (0.3 * p.position.x).sin()).collect();
    let mut run = problem(points.clone(), winkler(&points, None, FOUNDATION), rule(WEAR, 1.0), gap);
    run.stepping = Stepping::Adaptive { accuracy: 1e-10 };
    run.until = Until::Steady { residual: 1e-12, not_before: 0.0 };
    run.times = Some(Times { deviation: 1e-5, accuracy: 1e-9 });
    let mut evolution = Evolution::new(&run).unwrap();
    let states: Vec<WearState> = evolution.by_ref().collect();
    let norm = |p: &[f64]| -> f64 { p.iter().map(|v| (v - 1000.0 / AREA).powi(2)).sum::<f64>().sqrt() };
    let start = norm(&states[0].pressure) / (30.0_f64.sqrt() * 1000.0 / AREA);
    for deviation in [1e-2, 1e-5] {
        let found = evolution.settling(&states, deviation).unwrap();
        let time = (start / deviation).ln() / (FOUNDATION * WEAR * SPEED);
        assert_relative_eq!(found.time, time, max_relative = 1e-8);
        assert_relative_eq!(found.distance, SPEED * time, max_relative = 1e-8);
        assert_relative_eq!(found.volume[0], WEAR * 1000.0 * SPEED * time, max_relative = 1e-8);
    }
    assert!(evolution.settling(&states, 0.0).is_none());
}

/// With b = 1 a change of units by powers of two changes no digit.
#[test]
fn powers_of_two_in_the_units_scale_every_number_exactly() {
    let run = |length: f64, force: f64| {
        let mut points = points(20);
        let mut system = winkler(&points, Some(2000.0), FOUNDATION);
        let gap = points.iter().map(|p| length * 1e-7 * (p.position.x - 5.0).powi(2)).collect();
        for p in &mut points {
            p.position *= length;
            p.weight *= length * length;
            p.sliding_speed *= length;
        }
        system.compliance = Mat::from_fn(20, 20, |i, j| system.compliance[(i, j)] * length / force);
        for i in 0..20 {
            system.influence[(i, 1)] *= length;
            system.balance[(i, 1)] *= length;
        }
        system.load[0] *= force;
        system.load[1] *= force * length;
        let mut run = problem(points, system, rule(WEAR / force * length * length, 1.0), gap);
        run.until = Until::Time(2000.0);
        Evolution::new(&run).unwrap().last().unwrap()
    };
    let plain = run(1.0, 1.0);
    let (length, force) = (2.0_f64.powi(20), 2.0_f64.powi(-12));
    let scaled = run(length, force);
    assert_eq!(plain.step, scaled.step);
    assert!(plain.step > 5);
    for i in 0..20 {
        assert_eq!(scaled.gap[i], plain.gap[i] * length);
        assert_eq!(scaled.pressure[i], plain.pressure[i] * force / (length * length));
    }
}
