//! Wear in time under loads that act by turns, averaged over their cycles.

use crate::closed_form::mean;
use crate::steady::{punch_stages, rule};
use approx::assert_relative_eq;
use contact::ContactSystem;
use shapeopt::{
    Evolution, EvolutionStatus, Interval, LoadStage, ReversingProblem, Stepping, Until, WearProblem, WearState, steady_reversing,
};
use wear::{Counterface, SurfacePoint};

/// A punch that slides to and fro from a flat start, averaged.
fn averaged(points: &[SurfacePoint], systems: &[ContactSystem; 2], share: f64, b: f64) -> WearProblem {
    let flat = vec![0.0; points.len()];
    let mut run = WearProblem::new(points.to_vec(), rule(b), Counterface::Fresh, flat, systems[0].clone());
    run.stages = systems.clone().map(|system| LoadStage { system, speeds: vec![5.0; points.len()], heated: None }).to_vec();
    run.shares = Some(vec![share, 1.0 - share]);
    run
}

fn last(run: &WearProblem, wanted: EvolutionStatus) -> WearState {
    let mut evolution = Evolution::new(run).unwrap();
    evolution.by_ref().for_each(drop);
    assert_eq!(*evolution.status(), wanted);
    evolution.state().clone()
}

/// Largest difference of two gaps without their means, over the range of the second.
fn apart(points: &[SurfacePoint], a: &[f64], b: &[f64]) -> f64 {
    let level = |gap: &[f64]| gap.iter().map(|g| g - mean(points, gap)).collect::<Vec<f64>>();
    let (a, b) = (level(a), level(b));
    let range = b.iter().copied().fold(f64::MIN, f64::max) - b.iter().copied().fold(f64::MAX, f64::min);
    a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / range
}

/// Two ways to one shape: the run that averages ends where the shape solved for directly stands.
#[test]
fn the_end_of_an_averaged_run_is_the_shape_solved_for_directly() {
    let (points, systems) = punch_stages(6, 6, [1.0, -1.0]);
    for (share, b) in [(0.5, 1.0), (0.5, 2.0), (0.3, 0.5), (0.8, 1.0), (0.3, 2.0)] {
        let direct = steady_reversing(&ReversingProblem {
            points: points.clone(),
            wear: rule(b),
            counterface: Counterface::Fresh,
            track_area: None,
            systems: systems.clone(),
            share,
        })
        .unwrap();
        let run = averaged(&points, &systems, share, b);
        let end = last(&run, EvolutionStatus::Steady);
        let off = apart(&points, &end.gap, &direct.gap);
        println!("share {share} b {b}: {} steps, {off:.1e} apart", end.step);
        assert!(off < 1e-6, "share {share} b {b}: {off:e}");
        for ((pressure, part), (found, wanted)) in
            run.pressures(&end.pressure).zip(direct.pressure.iter().zip([share, 1.0 - share]))
        {
            assert_relative_eq!(part, wanted);
            let square =
                |f: &dyn Fn(usize) -> f64| (0..points.len()).map(|i| points[i].weight * f(i).powi(2)).sum::<f64>().sqrt();
            assert!(square(&|i| pressure[i] - found[i]) < 1e-6 * square(&|i| found[i]), "share {share} b {b}");
        }
    }
}

/// The mean of one sense alone, and of two that are the same, is the run under that load.
#[test]
fn the_mean_of_one_load_is_that_load() {
    let (points, systems) = punch_stages(6, 4, [1.0, -1.0]);
    for b in [0.5, 1.0, 2.0] {
        let mut alone = averaged(&points, &systems, 1.0, b);
        alone.until = Until::Time(200.0);
        alone.stepping = Stepping::Adaptive { accuracy: 1e-7 };
        let mut same = averaged(&points, &[systems[0].clone(), systems[0].clone()], 0.4, b);
        let mut single = WearProblem::new(points.clone(), rule(b), Counterface::Fresh, alone.gap.clone(), systems[0].clone());
        for run in [&mut same, &mut single] {
            (run.until, run.stepping) = (alone.until, alone.stepping);
        }
        let single = last(&single, EvolutionStatus::TimeReached);
        for run in [&alone, &same] {
            let end = last(run, EvolutionStatus::TimeReached);
            let most = single.worn.iter().copied().fold(0.0, f64::max);
            let off = end.worn.iter().zip(&single.worn).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / most;
            println!("b {b}: {off:.1e}");
            assert!(off < 1e-6, "b {b}: {off:e}");
            assert_relative_eq!(end.volume[0], single.volume[0], max_relative = 1e-7);
            assert_relative_eq!(end.distance, single.distance, max_relative = 1e-12);
        }
    }
}

/// Resolved reversals draw near to their mean within the run too: at the end of a cycle by its length, in the mean of both halves by its square.
#[test]
fn resolved_reversals_draw_near_to_their_mean_with_the_length_of_a_cycle() {
    let (points, systems) = punch_stages(4, 2, [1.0, -1.0]);
    for (share, b) in [(0.5, 1.0), (0.5, 2.0), (0.3, 1.0)] {
        let mut mean = averaged(&points, &systems, share, b);
        mean.stepping = Stepping::Adaptive { accuracy: 1e-7 };
        // About as long as the running-in takes: the slowest mode of its first moment.
        let time = Evolution::new(&mean).unwrap().run_in().unwrap().times[0];
        mean.until = Until::Time(time);
        let wanted = last(&mean, EvolutionStatus::TimeReached);
        let off = [10, 20, 40].map(|cycles: usize| {
            let mut run = mean.clone();
            run.shares = None;
            let period = time / cycles as f64;
            let lasts = |k: usize| [share, 1.0 - share][k % 2] * period;
            run.schedule = (0..2 * cycles).map(|k| Interval { stage: k % 2, duration: lasts(k) }).collect();
            apart(&points, &last(&run, EvolutionStatus::TimeReached).gap, &wanted.gap)
        });
        println!("share {share} b {b}: {off:?}");
        assert!(off[1] < 0.6 * off[0] && off[2] < 0.6 * off[1] && off[2] < 0.05, "share {share} b {b}: {off:?}");
    }
}

/// Its running-in has the times in which small deviations from the steady shape wear away.
#[test]
fn a_deviation_wears_away_in_the_times_of_the_modes() {
    let (points, systems) = punch_stages(6, 4, [1.0, -1.0]);
    let mut run = averaged(&points, &systems, 0.4, 2.0);
    let mut evolution = Evolution::new(&run).unwrap();
    evolution.by_ref().for_each(drop);
    let slowest = evolution.run_in().unwrap().times[0];
    run.stepping = Stepping::Fixed(0.25 * slowest);
    run.until = Until::Steady { residual: 1e-7, not_before: 0.0 };
    let states: Vec<WearState> = Evolution::new(&run).unwrap().collect();
    let late: Vec<&WearState> = states.iter().filter(|s| (1e-7..1e-4).contains(&s.steady_residual)).collect();
    let (first, then) = (late[0], late[late.len() - 1]);
    let found = (then.time - first.time) / (first.steady_residual / then.steady_residual).ln();
    println!("slowest {slowest}, found {found}");
    assert_relative_eq!(found, slowest, max_relative = 0.02);
}

#[test]
fn a_run_that_averages_goes_on_to_the_same_bits() {
    let (points, systems) = punch_stages(4, 2, [1.0, -1.0]);
    let run = averaged(&points, &systems, 0.4, 2.0);
    let states: Vec<WearState> = Evolution::new(&run).unwrap().collect();
    let half = states[states.len() / 2].clone();
    let on: Vec<WearState> = Evolution::resume(&run, half).unwrap().collect();
    assert_eq!(on, states[states.len() / 2 + 1..]);
}

#[test]
fn shares_that_are_none_are_refused() {
    let (points, systems) = punch_stages(4, 2, [1.0, -1.0]);
    for shares in [vec![1.0], vec![0.7, 0.7], vec![-0.5, 1.5], vec![f64::NAN, 0.5]] {
        let mut run = averaged(&points, &systems, 0.5, 1.0);
        run.shares = Some(shares);
        assert!(Evolution::new(&run).err().is_some_and(|error| error.to_string().contains("share")));
    }
}
