//! Loads and speeds that change, reversal of the sliding, and runs that go on from a saved state.

use crate::closed_form::{FORCE, mean, points, problem, rule, winkler};
use crate::steady::{BETA, FRICTION, punch_stages};
use approx::assert_relative_eq;
use shapeopt::{Evolution, EvolutionStatus, Interval, LoadStage, Stepping, Until, WearProblem, WearState};
use wear::{Counterface, WearPair};

#[test]
fn pressure_follows_a_schedule_of_forces_and_speeds() {
    let (foundation, factor) = (500.0, 1e-7);
    let points = points(30);
    let gap: Vec<f64> = points.iter().map(|p| 1e-4 * (0.3 * p.position.x).sin()).collect();
    let mut run = problem(points.clone(), winkler(&points, None, foundation), rule(factor, 1.0), gap);
    let stage = |force: f64, speed: f64| {
        let mut system = winkler(&points, None, foundation);
        system.load[0] = force * FORCE;
        LoadStage { system, speeds: vec![speed; points.len()], heated: None }
    };
    run.stages = vec![stage(1.0, 5.0), stage(3.0, 20.0)];
    let interval = |stage, duration| Interval { stage, duration };
    run.schedule = vec![interval(0, 500.0), interval(1, 300.0), interval(0, 200.0), interval(1, 1.0)];
    run.until = Until::Time(1500.0);
    run.stepping = Stepping::Adaptive { accuracy: 1e-8 };
    let states: Vec<WearState> = Evolution::new(&run).unwrap().collect();
    for end in [500.0, 800.0, 1000.0] {
        assert!(states.iter().any(|s| (s.time - end).abs() < 1e-9), "no step ends at {end}");
    }
    let (first, last) = (&states[0], &states[states.len() - 1]);
    let distance = 5.0 * 700.0 + 20.0 * 800.0;
    assert_relative_eq!(last.distance, distance, max_relative = 1e-12);
    assert_eq!(last.interval, 3);
    let decay = (-foundation * factor * distance).exp();
    for (p, p0) in last.pressure.iter().zip(&first.pressure) {
        let deviation = decay * (p0 - mean(&points, &first.pressure));
        assert_relative_eq!(*p, 3.0 * FORCE / 600.0 + deviation, max_relative = 1e-7);
    }
}

/// The rate rule of the paper's punch with b = 1.
fn pair() -> WearPair {
    WearPair::from_beta([BETA, 0.0], FRICTION, [1.0; 2], [1.0; 2]).unwrap()
}

/// Gap less its mean.
fn shape(run: &WearProblem, state: &WearState) -> Vec<f64> {
    let average = mean(&run.points, &state.gap);
    state.gap.iter().map(|g| g - average).collect()
}

#[test]
fn reversed_sliding_wears_the_mirror_image() {
    let (points, [forwards, backwards]) = punch_stages(6, 6, [1.0, -1.0]);
    let stage = |system| LoadStage { system, speeds: vec![5.0; points.len()], heated: None };
    let gap = vec![0.0; points.len()];
    let mut run = WearProblem::new(points.clone(), pair(), Counterface::Fresh, gap, forwards.clone());
    run.until = Until::Steady { residual: 1e-11, not_before: 0.0 };
    let ahead = Evolution::new(&run).unwrap().last().unwrap();
    run.stages = vec![stage(forwards), stage(backwards)];
    run.schedule = vec![Interval { stage: 0, duration: ahead.time }, Interval { stage: 1, duration: f64::INFINITY }];
    let mut evolution = Evolution::new(&run).unwrap();
    let back = evolution.by_ref().last().unwrap();
    assert_eq!(*evolution.status(), EvolutionStatus::Steady);
    let (ahead, back) = (shape(&run, &ahead), shape(&run, &back));
    let largest = ahead.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let n = points.len();
    // The shear makes the shape skew: the mirror image differs from it.
    assert!((0..n).any(|i| (ahead[i] - ahead[n - 1 - i]).abs() > 0.1 * largest));
    for i in 0..n {
        assert!((back[i] - ahead[n - 1 - i]).abs() < 1e-7 * largest);
    }
}

#[test]
fn a_resumed_run_takes_the_same_steps_bit_for_bit() {
    let (points, [system, other]) = punch_stages(6, 6, [1.0, -1.0]);
    let stage = |system| LoadStage { system, speeds: vec![5.0; points.len()], heated: None };
    let gap = vec![0.0; points.len()];
    let mut run = WearProblem::new(points.clone(), pair(), Counterface::Fresh, gap, system.clone());
    run.stages = vec![stage(system), stage(other)];
    run.schedule = vec![Interval { stage: 0, duration: 2.0 }, Interval { stage: 1, duration: 1.0 }];
    let whole: Vec<WearState> = Evolution::new(&run).unwrap().collect();
    assert!(whole.len() > 20);
    for from in [0, 7, whole.len() / 2, whole.len() - 2] {
        let rest: Vec<WearState> = Evolution::resume(&run, whole[from].clone()).unwrap().collect();
        assert_eq!(rest, whole[from + 1..]);
    }
    let mut ended = Evolution::resume(&run, whole[whole.len() - 1].clone()).unwrap();
    assert_eq!(*ended.status(), EvolutionStatus::Steady);
    assert!(ended.next().is_none());
}

#[test]
fn numbers_that_do_not_fit_are_refused() {
    let points = points(10);
    let good = problem(points.clone(), winkler(&points, None, 500.0), rule(1e-7, 1.0), vec![0.0; 10]);
    let refused = |run: &WearProblem| Evolution::new(run).err().map(|e| e.to_string()).unwrap();
    let mut run = good.clone();
    run.gap.pop();
    assert!(refused(&run).contains("10 contact points"));
    let mut run = good.clone();
    run.wear = rule(1e-7, 0.0);
    assert!(refused(&run).contains("exponent"));
    let mut run = good.clone();
    run.schedule[0].stage = 3;
    assert!(refused(&run).contains("stages"));
    let mut run = good.clone();
    run.counterface = Counterface::Revolving;
    assert!(refused(&run).contains("track"));
    let mut run = good;
    run.stages[0].system.load[0] = -FORCE;
    assert!(refused(&run).contains("no contact pressure"));
}
