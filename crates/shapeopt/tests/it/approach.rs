//! The shape for a prescribed approach: one equation for the force against the paper's iteration through contact solves.
//!
//! ```text
//!      ____d____      the top of the punch comes down by d, nothing says how hard
//!     |         |
//!     |_  p* v _|     p = p* v(s) with v = 1; its smallest gap needs the approach Delta(p*)
//!   ~~~~~~~~~~~~~~~   fixed point: Delta(p*) = d
//! ```
//!
//! Paczelt and Mroz (2007), Appendix A: `p*` is the largest pressure of the contact solve on the last gap.

use crate::bodies::punch;
use approx::assert_relative_eq;
use contact::{ContactLoad, ContactOperator, Motion, Pair};
use shapeopt::{Gauge, Integration, RigidPart, Shape, ShapeProblem, force_of_approach, solve_shape};

/// Approach of the rigid top, mm.
const APPROACH: f64 = 1e-3;

/// Shape of a uniform pressure, with the approach that its smallest gap needs.
fn shape(pair: Pair<'_>, pressure: f64) -> (Shape, f64) {
    let problem = ShapeProblem {
        pair,
        traction: &|_| [pressure, 0.0],
        cases_shaped: &[],
        cases_counter: &[],
        gauge: Gauge::HeldEdge,
        rigid: RigidPart::Smallest,
        integration: Integration::Lobatto,
    };
    let shape = solve_shape(&problem).unwrap();
    let closing = -shape.rigid[0] * pair.shaped.rigid_motions[0][1];
    (shape, closing)
}

/// Contact under the approach on a gap.
fn pressure_on(operator: &ContactOperator<'_>, gap: &[f64]) -> Vec<f64> {
    let mut load = ContactLoad::factors(&[], &[]);
    load.motions[1] = Motion::Prescribed { value: -APPROACH };
    let found = operator.solve(gap, &load, None).unwrap();
    assert!(found.status.is_solved());
    found.pressure
}

#[test]
fn the_force_of_an_approach_is_the_fixed_point_of_the_papers_iteration() {
    let bodies = punch(6, 4, false);
    let [body, plate] = bodies.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, false).unwrap();
    let area = 600.0;
    let direct = force_of_approach(APPROACH, 1.0, |force| Ok::<_, ()>(Some(shape(pair, force / area).1))).unwrap().unwrap();
    assert!(direct.passes <= 3, "{} passes", direct.passes);
    let wanted = direct.force / area;
    // The contact under the approach returns the pressure on its shape.
    let gap_of = |pressure: f64| -> Vec<f64> {
        let (shape, _) = shape(pair, pressure);
        operator.points().iter().map(|p| shape.gap(&pair, p)).collect()
    };
    for p in pressure_on(&operator, &gap_of(wanted)) {
        assert_relative_eq!(p, wanted, max_relative = 1e-8);
    }
    // The iteration from a rounded punch, whose first pressure is finite.
    let mut gap: Vec<f64> = operator.points().iter().map(|p| p.position[0].powi(2) / 2e6).collect();
    let mut trace: Vec<f64> = Vec::new();
    for _ in 0..60 {
        let largest = pressure_on(&operator, &gap).into_iter().fold(0.0, f64::max);
        trace.push(largest / wanted - 1.0);
        if trace.last().is_some_and(|off| off.abs() < 1e-9) {
            break;
        }
        gap = gap_of(largest);
    }
    println!("direct: {} passes, p* = {wanted:.9}; iteration: {} contact solves, off by {:?}", direct.passes, trace.len(), trace);
    assert!(trace[trace.len() - 1].abs() < 1e-9);
    assert!(trace.len() <= 40);
}

#[test]
fn a_force_is_found_where_the_approach_is_not_in_proportion_and_refused_where_there_is_none() {
    // As of a moment: below 3 N nothing balances, then the approach grows unevenly.
    let needed = |force: f64| Ok::<_, ()>((force > 3.0).then(|| 1e-3 * (force - 3.0).sqrt() + 1e-4 * force));
    for trial in [1e-6, 3.5, 1e4] {
        let found = force_of_approach(2e-3, trial, needed).unwrap().unwrap();
        let delta = needed(found.force).unwrap().unwrap();
        assert!((delta / 2e-3 - 1.0).abs() < 1e-12 && found.passes < 60, "{found:?}");
    }
    // An approach that even no force exceeds, as of a punch tilted into the plate.
    let tilted = |force: f64| Ok::<_, ()>(Some(3e-3 + 1e-6 * force));
    assert_eq!(force_of_approach(2e-3, 1.0, tilted).unwrap(), None);
}
