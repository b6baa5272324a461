//! Ways to the steady shape of the paper's translating punch (b = 1 and 2, sliding with friction 0.25): direct, by implicit steps and by
//! explicit steps, on the same operators. Prints a table; `cargo run --release -p wearshape-shapeopt --example time_to_steady`.
#![allow(clippy::unwrap_used, unreachable_pub, dead_code)]

#[path = "../tests/it/bodies.rs"]
mod bodies;

use contact::{ContactLoad, ContactOperator, Motion, Pair};
use shapeopt::{Evolution, EvolutionStatus, Scheme, Stepping, Until, WearProblem, WearState};
use std::time::Instant;
use wear::{Counterface, WearPair};

/// Mean pressure of 1 kN on 600 mm^2.
const STEADY: f64 = 1000.0 / 600.0;

/// Area norm of the deviation from the steady pressure, over the steady pressure.
fn deviation(problem: &WearProblem, state: &WearState) -> f64 {
    let (square, area) = problem.points.iter().zip(&state.pressure).fold((0.0, 0.0), |(square, area), (point, p)| {
        (square + point.weight * (p / STEADY - 1.0_f64).powi(2), area + point.weight)
    });
    (square / area).sqrt()
}

/// Steps and seconds until the pressure deviates by less than each part.
fn until(problem: &WearProblem, parts: [f64; 2]) -> Vec<(usize, f64)> {
    let start = Instant::now();
    let mut reached = Vec::new();
    let mut evolution = Evolution::new(problem).unwrap();
    while *evolution.status() == EvolutionStatus::Running && reached.len() < parts.len() {
        let Some(state) = evolution.next() else { break };
        while reached.len() < parts.len() && deviation(problem, &state) < parts[reached.len()] {
            reached.push((state.step, start.elapsed().as_secs_f64()));
        }
    }
    reached
}

fn main() {
    let parts = [1e-2, 1e-6];
    let (degree, layers) = (8, 3);
    let start = Instant::now();
    let bodies = bodies::punch(degree, layers, false);
    let [body, plate] = bodies.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let mut load = ContactLoad::factors(&[], &[]).sliding(0.25, vec![1.0; operator.points().len()]);
    load.motions[1] = Motion::Free { resultant: -1000.0 };
    let system = operator.system(&load).unwrap();
    let points = bodies::surface_points(&operator, 5.0);
    println!(
        "degree {degree}, {layers} layers, {} contact points; bodies and operators {:.3} s",
        points.len(),
        start.elapsed().as_secs_f64()
    );
    println!("{:<4} {:<10} {:>9} {:>12} {:>9} {:>12}", "b", "way", "steps 1%", "seconds", "1e-6", "seconds");
    for b in [1.0, 2.0] {
        let rule = WearPair::from_beta([2e-4, 0.0], 0.25, [1.0; 2], [b; 2]).unwrap();
        // Direct: the steady pressure is known, the gap that meets it is one product.
        let start = Instant::now();
        let n = points.len();
        let force: Vec<f64> = points.iter().map(|p| STEADY * p.weight).collect();
        let gap: Vec<f64> =
            (0..n).map(|i| -system.opening[i] - (0..n).map(|j| system.compliance[(i, j)] * force[j]).sum::<f64>()).collect();
        let direct = start.elapsed().as_secs_f64();
        println!("{b:<4} {:<10} {:>9} {direct:>12.2e} {:>9} {direct:>12.2e}", "direct", 0, 0);
        let problem = WearProblem::new(points.clone(), rule, Counterface::Fresh, vec![0.0; n], system.clone());
        let mut implicit_gap = Vec::new();
        for (name, scheme, stepping) in [
            ("implicit", Scheme::Sdirk4, Stepping::Adaptive { accuracy: 1e-4 }),
            ("explicit", Scheme::Explicit, Stepping::Adaptive { accuracy: 1e-4 }),
        ] {
            let run =
                WearProblem { scheme, stepping, until: Until::Steady { residual: 1e-9, not_before: 0.0 }, ..problem.clone() };
            let reached = until(&run, parts);
            let [(steps, seconds), (last_steps, last_seconds)] = [reached[0], reached[1]];
            println!("{b:<4} {name:<10} {steps:>9} {seconds:>12.2e} {last_steps:>9} {last_seconds:>12.2e}");
            if scheme == Scheme::Sdirk4 {
                implicit_gap = Evolution::new(&run).unwrap().last().unwrap().gap;
            }
        }
        // The worn gap is the direct one up to the rigid part.
        let shift = implicit_gap[0] - gap[0];
        let largest = gap.iter().fold(0.0_f64, |m, g| m.max((g - gap[0]).abs()));
        let worst = gap.iter().zip(&implicit_gap).fold(0.0_f64, |m, (g, w)| m.max((w - g - shift).abs()));
        println!("     worn gap against the direct one: {:.1e} of its height", worst / largest);
    }
}
