//! Contact that opens and closes on finite element bodies: crowned punch, moment beyond the kern.

use crate::bodies::{punch, surface_points};
use crate::steady::{FRICTION, rule, run};
use contact::{ContactLoad, ContactOperator, MomentBalance, Motion, Pair};
use shapeopt::{Scheme, Stepping, WearProblem};
use wear::Counterface;

#[test]
fn a_crowned_sliding_punch_wears_to_uniform_pressure() {
    let bodies = punch(8, 6, false);
    let [body, plate] = bodies.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let mut load = ContactLoad::factors(&[], &[]).sliding(FRICTION, vec![1.0; operator.points().len()]);
    load.motions[1] = Motion::Free { resultant: -1000.0 };
    let points = surface_points(&operator, 5.0);
    for b in [0.5, 1.0, 2.0] {
        let gap = points.iter().map(|p| 1e-5 * (p.position.x - 4.0).powi(2)).collect();
        let system = operator.system(&load).unwrap();
        let problem = WearProblem::new(points.clone(), rule(b), Counterface::Fresh, gap, system);
        let state = run(&format!("crowned punch b {b}"), &problem);
        assert!(state.pressure.iter().all(|p| (p * 0.6 - 1.0).abs() < 1e-8));
    }
}

/// Beyond the kern, e = M / F = 15 mm > c / 3: the triangle of length 3 (c - e) for b = 1, whatever the bodies, and for any b the
/// pressure `p = p_edge (u / l)^(1/b)` with `l = (1/b + 2)(c - e)` (optimality theory, 3.7).
#[test]
fn a_tilting_punch_beyond_the_kern_ends_in_partial_contact() {
    let bodies = punch(10, 4, true);
    let [body, plate] = bodies.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let points = surface_points(&operator, 5.0);
    for b in [0.5, 1.0, 2.0] {
        let mut load = ContactLoad::factors(&[], &[]).sliding(FRICTION, vec![1.0; points.len()]);
        load.motions[1] = Motion::Free { resultant: -1000.0 };
        load.motions[2] = Motion::Free { resultant: 15000.0 };
        load.moment = MomentBalance::Pressure;
        let gap = vec![0.0; points.len()];
        let mut problem = WearProblem::new(points.clone(), rule(b), Counterface::Fresh, gap, operator.system(&load).unwrap());
        problem.stepping = Stepping::Adaptive { accuracy: 1e-3 };
        problem.scheme = Scheme::Sdirk2;
        let state = run(&format!("punch beyond the kern b {b}"), &problem);
        let k = 1.0 / b;
        let length = (k + 2.0) * 15.0;
        let peak = 1000.0 * (k + 1.0) / (10.0 * length);
        // Which edge carries follows from the sign of the moment.
        let side = points.iter().zip(&state.pressure).map(|(p, v)| p.position.x * v).sum::<f64>().signum();
        let square: f64 = points
            .iter()
            .zip(&state.pressure)
            .map(|(p, v)| {
                let u = (length - 30.0 + side * p.position.x).max(0.0);
                p.weight * (v - peak * (u / length).powf(k)).powi(2)
            })
            .sum();
        let error = (square / 600.0).sqrt() / peak;
        println!("side {side}, length {length}, error of the pressure {error:.2e} of its peak");
        assert!(error < 2e-2);
    }
}
