//! The steady shape of a motion that reverses.

use crate::bodies::{drum, punch, surface_points};
use crate::steady::{BETA, FRICTION, punch_stages, rule};
use approx::assert_relative_eq;
use contact::{ContactLoad, ContactOperator, ContactSystem, MomentBalance, Motion, Pair};
use shapeopt::{Evolution, Interval, LoadStage, Reversing, ReversingProblem, Until, WearProblem, steady_reversing};
use wear::{Counterface, SurfacePoint, WearPair};

/// Mean pressure of the punch under 1 kN, MPa.
const MEAN: f64 = 1000.0 / 600.0;
/// Moment on the punch, N mm.
const MOMENT: f64 = 3000.0;

fn problem(points: &[SurfacePoint], systems: &[ContactSystem; 2], share: f64, wear: WearPair) -> ReversingProblem {
    ReversingProblem {
        points: points.to_vec(),
        wear,
        counterface: Counterface::Fresh,
        track_area: None,
        systems: systems.clone(),
        share,
    }
}

/// The punch under 1 kN and `MOMENT`, its top free to tilt.
fn tilting() -> (Vec<SurfacePoint>, [ContactSystem; 2]) {
    let [body, plate] = punch(6, 6, true).reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let systems = [1.0, -1.0].map(|drag| {
        let mut load = ContactLoad::factors(&[], &[]).sliding(FRICTION, vec![drag; operator.points().len()]);
        load.moment = MomentBalance::Pressure;
        load.motions[1] = Motion::Free { resultant: -1000.0 };
        load.motions[2] = Motion::Free { resultant: -MOMENT };
        operator.system(&load).unwrap()
    });
    (surface_points(&operator, 5.0), systems)
}

/// Gap whose bodies just touch under the pressure, up to a rigid part.
fn touching(points: &[SurfacePoint], system: &ContactSystem, pressure: impl Fn(&SurfacePoint) -> f64) -> Vec<f64> {
    let row = |i: usize| -> f64 {
        points.iter().enumerate().map(|(j, p)| system.compliance[(i, j)] * p.weight * pressure(p)).sum::<f64>()
    };
    (0..points.len()).map(|i| -system.opening[i] - row(i)).collect()
}

/// Largest difference of two gaps without the mean of each, over the range of the second.
fn apart(points: &[SurfacePoint], a: &[f64], b: &[f64]) -> f64 {
    let level = |gap: &[f64]| {
        let mean = crate::closed_form::mean(points, gap);
        gap.iter().map(|g| g - mean).collect::<Vec<f64>>()
    };
    let (a, b) = (level(a), level(b));
    let range = b.iter().copied().fold(f64::MIN, f64::max) - b.iter().copied().fold(f64::MAX, f64::min);
    a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / range
}

fn solved(name: &str, problem: &ReversingProblem) -> Reversing {
    let start = std::time::Instant::now();
    let found = steady_reversing(problem).unwrap();
    let open = [0, 1].map(|side| found.pressure[side].iter().filter(|p| **p == 0.0).count());
    let most = [0, 1].map(|side| found.pressure[side].iter().copied().fold(0.0, f64::max));
    println!(
        "{name}: {} points, {} steps, residual {:.1e}, open {open:?}, highest {most:?}, {:.3} s",
        problem.points.len(),
        found.iterations,
        found.residual,
        start.elapsed().as_secs_f64()
    );
    found
}

#[test]
fn without_friction_both_senses_press_as_one() {
    let (points, systems) = punch_stages(8, 8, [0.0, 0.0]);
    for b in [0.5, 1.0, 2.0] {
        let found = solved("frictionless", &problem(&points, &systems, 0.3, rule(b)));
        for p in found.pressure.iter().flatten() {
            assert_relative_eq!(*p, MEAN, max_relative = 1e-9);
        }
        assert!(apart(&points, &found.gap, &touching(&points, &systems[0], |_| MEAN)) < 1e-10);
    }
}

#[test]
fn one_sense_alone_has_its_own_steady_shape_and_the_other_its_mirror() {
    let (points, systems) = punch_stages(8, 8, [1.0, -1.0]);
    for b in [0.5, 1.0, 2.0] {
        for side in [0, 1] {
            let share = 1.0 - side as f64;
            let found = solved(&format!("alone b {b} share {share}"), &problem(&points, &systems, share, rule(b)));
            for p in &found.pressure[side] {
                assert_relative_eq!(*p, MEAN, max_relative = 1e-9);
            }
            assert!(apart(&points, &found.gap, &touching(&points, &systems[side], |_| MEAN)) < 1e-9);
        }
    }
}

#[test]
fn a_symmetric_body_that_goes_as_long_to_as_fro_gets_a_symmetric_shape() {
    let (points, systems) = punch_stages(8, 8, [1.0, -1.0]);
    let n = points.len();
    for b in [0.5, 1.0, 2.0, 3.0] {
        let found = solved(&format!("symmetric b {b}"), &problem(&points, &systems, 0.5, rule(b)));
        let mirrored: Vec<f64> = found.gap.iter().rev().copied().collect();
        assert!(apart(&points, &found.gap, &mirrored) < 1e-7);
        for i in 0..n {
            // Next to the ends areas are a millionth of the surface.
            assert!((found.pressure[0][i] - found.pressure[1][n - 1 - i]).abs() < 1e-5 * MEAN, "{b} {i}");
        }
        // The senses do differ, by the friction.
        assert!((found.pressure[0][n / 4] - found.pressure[1][n / 4]).abs() > 0.01 * MEAN);
        // The mean wear is a rigid feed: the same at every point of a guided punch.
        let law = rule(b);
        let rate = |i: usize| 0.5 * (law.rules[0].rate(found.pressure[0][i], 5.0) + law.rules[0].rate(found.pressure[1][i], 5.0));
        (0..n).for_each(|i| assert_relative_eq!(rate(i), rate(0), max_relative = 1e-9));
        (0..n).for_each(|i| assert_relative_eq!(rate(i), found.feed[i], max_relative = 1e-9));
    }
}

/// With b = 1 the mean pressure has the form of the feed: uniform, and linear under a moment, `F/A + M x / I`.
#[test]
fn a_linear_rule_gives_the_mean_pressure_in_closed_form() {
    let (points, systems) = tilting();
    let inertia = 10.0 * 60f64.powi(3) / 12.0;
    for share in [0.0, 0.2, 0.5, 0.9, 1.0] {
        let found = solved(&format!("linear share {share}"), &problem(&points, &systems, share, rule(1.0)));
        let exact = |x: f64| 1000.0 / 600.0 + MOMENT * x / inertia;
        let mean = |i: usize| share * found.pressure[0][i] + (1.0 - share) * found.pressure[1][i];
        for (i, point) in points.iter().enumerate() {
            assert_relative_eq!(mean(i), exact(point.position.x), max_relative = 1e-8);
        }
        for side in [0, 1] {
            let force: f64 = points.iter().zip(&found.pressure[side]).map(|(p, v)| p.weight * v).sum();
            let moment: f64 = points.iter().zip(&found.pressure[side]).map(|(p, v)| p.weight * v * p.position.x).sum();
            assert_relative_eq!(force, 1000.0, max_relative = 1e-9);
            assert_relative_eq!(moment, MOMENT, max_relative = 1e-8);
        }
    }
}

/// Stiffer bodies have the same pressures, on a gap that vanishes with their compliance.
#[test]
fn the_gap_of_rigid_bodies_vanishes_and_the_pressures_stay() {
    let (points, systems) = punch_stages(6, 6, [1.0, -1.0]);
    let soft = solved("soft", &problem(&points, &systems, 0.4, rule(2.0)));
    let factor = 1e-6;
    let stiff = systems.clone().map(|mut system| {
        system.compliance = faer::Scale(factor) * &system.compliance;
        system.opening.iter_mut().for_each(|o| *o *= factor);
        system
    });
    let found = solved("stiff", &problem(&points, &stiff, 0.4, rule(2.0)));
    let gap: Vec<f64> = found.gap.iter().map(|g| g / factor).collect();
    assert!(apart(&points, &gap, &soft.gap) < 1e-8);
    for (p, q) in found.pressure.iter().flatten().zip(soft.pressure.iter().flatten()) {
        assert!((p - q).abs() < 1e-6 * MEAN);
    }
}

/// Explicit steps of the mean wear rate, each with two contact solves, on the same operators.
#[test]
fn explicit_steps_of_the_mean_wear_arrive_at_the_same_gap() {
    let bodies = punch(5, 1, false);
    let [body, plate] = bodies.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let points = surface_points(&operator, 5.0);
    let n = points.len();
    let loads = [1.0, -1.0].map(|drag| {
        let mut load = ContactLoad::factors(&[], &[]).sliding(FRICTION, vec![drag; n]);
        load.motions[1] = Motion::Free { resultant: -1000.0 };
        load
    });
    let systems = loads.each_ref().map(|load| operator.system(load).unwrap());
    for (share, b) in [(0.5, 1.0), (0.3, 2.0)] {
        let direct = solved("direct", &problem(&points, &systems, share, rule(b)));
        let law = rule(b);
        let mut gap = vec![0.0; n];
        let mut last = [None, None];
        // Below the bound of the stiffest ripple, for the pressures of the flat start.
        let slope = law.rules[0].slope(MEAN, 5.0);
        let softest = (0..n).map(|i| systems[0].compliance[(i, i)] * points[i].weight).fold(f64::MAX, f64::min);
        let step = 0.15 * softest / slope;
        let mut steps = 0;
        while steps < 40_000 {
            let found = [0, 1].map(|side| operator.solve(&gap, &loads[side], last[side].as_ref()).unwrap());
            let rate = |side: usize, i: usize| law.rules[0].rate(found[side].pressure[i], 5.0);
            (0..n).for_each(|i| gap[i] += step * (share * rate(0, i) + (1.0 - share) * rate(1, i)));
            last = found.map(Some);
            steps += 1;
            if steps % 200 == 0 && apart(&points, &gap, &direct.gap) < 1e-7 {
                break;
            }
        }
        let left = apart(&points, &gap, &direct.gap);
        println!("share {share} b {b}: {steps} explicit steps, {left:.1e} left");
        assert!(left < 1e-6, "{left:e}");
    }
}

/// Many resolved reversals: the shorter the cycles, the nearer their gap is to that of the mean wear.
#[test]
fn short_resolved_cycles_arrive_at_the_gap_of_the_mean_wear() {
    let (points, systems) = punch_stages(4, 2, [1.0, -1.0]);
    let direct = solved("direct", &problem(&points, &systems, 0.5, rule(1.0)));
    let mut run = WearProblem::new(points.clone(), rule(1.0), Counterface::Fresh, direct.gap.clone(), systems[0].clone());
    run.stages = systems.clone().map(|system| LoadStage { system, speeds: vec![5.0; points.len()], heated: None }).to_vec();
    let slowest = Evolution::new(&run).unwrap().run_in().unwrap().times[0];
    // After the last backward half: the ripple of a cycle, first order in its length. Averaged with the last forward half: second order.
    let ends = [0.2, 0.1].map(|part| {
        let half = 0.5 * part * slowest;
        let cycles = (12.0 / part) as usize;
        run.schedule = (0..2 * cycles).map(|k| Interval { stage: k % 2, duration: half }).collect();
        run.gap = vec![0.0; points.len()];
        run.until = Until::Time(half * 2.0 * cycles as f64);
        let states: Vec<_> = Evolution::new(&run).unwrap().collect();
        let at = |time: f64| states.iter().find(|state| state.time >= time * (1.0 - 1e-9)).unwrap().gap.clone();
        let end = half * 2.0 * cycles as f64;
        let (after, before) = (at(end), at(end - half));
        let mean: Vec<f64> = after.iter().zip(&before).map(|(a, b)| 0.5 * (a + b)).collect();
        [apart(&points, &after, &direct.gap), apart(&points, &mean, &direct.gap)]
    });
    println!("a fifth and a tenth of the run-in: {ends:?}");
    assert!(ends[1][0] < 0.6 * ends[0][0]);
    assert!(ends[1][1] < 0.3 * ends[0][1] && ends[1][1] < 2e-3);
}

#[test]
fn a_shoe_on_a_drum_returns_both_pressures_from_contact_solves() {
    let [shoe, ring] = drum(8, 8).reduced();
    let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let points = surface_points(&operator, 500.0);
    let n = points.len();
    let loads = [-1.0, 1.0].map(|drag| ContactLoad::factors(&[1.0], &[]).sliding(FRICTION, vec![drag; n]));
    let systems = loads.each_ref().map(|load| operator.system(load).unwrap());
    let area: f64 = points.iter().map(|p| p.weight).sum();
    for counterface in [Counterface::Fresh, Counterface::Congruent, Counterface::Revolving] {
        let wear = WearPair::from_beta([BETA, 0.5 * BETA], FRICTION, [1.0; 2], [0.5, 0.5]).unwrap();
        let mut problem = problem(&points, &systems, 0.7, wear);
        (problem.counterface, problem.track_area) = (counterface, Some(6.0 * area));
        let found = solved(&format!("drum {counterface:?}"), &problem);
        for side in [0, 1] {
            let back = operator.solve(&found.gap, &loads[side], None).unwrap();
            let square = |f: &dyn Fn(usize) -> f64| (0..n).map(|i| points[i].weight * f(i).powi(2)).sum::<f64>().sqrt();
            let off = square(&|i| back.pressure[i] - found.pressure[side][i]) / square(&|i| found.pressure[side][i]);
            println!("  round trip {side}: {off:.1e}");
            assert!(off < 1e-8, "{off:e}");
        }
    }
}

#[test]
fn what_has_no_steady_reversal_is_refused() {
    let (points, systems) = punch_stages(4, 2, [1.0, -1.0]);
    let refused = |problem: &ReversingProblem| steady_reversing(problem).err().map(|e| e.to_string()).unwrap();
    assert!(refused(&problem(&points, &systems, 1.5, rule(1.0))).contains("share"));
    assert!(refused(&problem(&points[1..], &systems, 0.5, rule(1.0))).contains("contact points"));
    assert!(refused(&problem(&points, &systems, 0.5, WearPair::archard([0.0, 1e-7], [1.0; 2], [1.0; 2]))).contains("body 1"));
    let mut pressed = systems.clone();
    pressed.iter_mut().for_each(|system| system.load[0] = 0.0);
    assert!(refused(&problem(&points, &pressed, 0.5, rule(1.0))).contains("press by a force"));
}
