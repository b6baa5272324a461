//! Whether a sliding contact can have other solutions, on bodies.

use crate::common::drum::Drum;
use crate::common::punch::Punch;
use crate::common::wedge;
use approx::assert_relative_eq;
use contact::*;
use std::time::Instant;

/// Solution and verdict of a coefficient of friction, the largest over the smallest singular value, and seconds of solve, verdict, values.
fn judged(operator: &ContactOperator<'_>, load: &ContactLoad) -> (ContactSolution, Uniqueness, f64, [f64; 3]) {
    let gap = vec![0.0; operator.points().len()];
    let start = Instant::now();
    let solution = operator.solve(&gap, load, None).unwrap();
    let solve = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let verdict = operator.uniqueness(&gap, load, &solution).unwrap().unwrap();
    let judge = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let [low, high] = operator.singular_values(&gap, load, &solution).unwrap().unwrap();
    (solution, verdict, high / low, [solve, judge, start.elapsed().as_secs_f64()])
}

#[test]
fn a_wedge_loses_its_solution_where_the_closed_form_jams() {
    // F / G = (tan a + mu) / (1 - mu tan a) grows beyond all bounds at mu = 1 / tan a.
    let (slope, friction) = (0.6, 2.0);
    let (body, plane) = wedge::bodies(slope);
    let pair = Pair::new(&body, Some(&plane)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    let mut load = ContactLoad::factors(&[], &[]).sliding(friction, vec![-1.0; n]);
    load.motions = [Motion::Prescribed { value: 0.0 }, Motion::Free { resultant: -1500.0 }, Motion::FREE];
    let (solution, verdict, _, _) = judged(&operator, &load);
    assert_eq!(solution.status, Status::Jammed);
    println!("{verdict:?}");
    assert_relative_eq!(verdict.lost_from.or(verdict.singular_from).unwrap(), 1.0 / slope, max_relative = 1e-3);
    assert!(verdict.not_guaranteed_from.unwrap() <= 1.0 / slope + 1e-3);
}

#[test]
fn friction_up_to_two_keeps_one_solution_on_drum_and_punch_or_says_from_where_it_may_not() {
    let drum = Drum::new(8, 6, [210e3; 2]);
    let (shoe, ring) = drum.bodies();
    let punch = Punch::translating(8, 6, [false, true, false]);
    let (body, plate) = punch.bodies();
    for (name, pair) in [
        ("drum", Pair::new(&shoe.interface, Some(&ring.interface)).unwrap()),
        ("punch", Pair::new(&body.interface, Some(&plate.interface)).unwrap()),
    ] {
        let operator = ContactOperator::new(&pair, true).unwrap();
        let n = operator.points().len();
        for friction in [0.25, 1.0, 2.0] {
            let mut load = ContactLoad::factors(if name == "drum" { &[1.0] } else { &[] }, &[]).sliding(friction, vec![1.0; n]);
            if name == "punch" {
                load.motions[1] = Motion::Free { resultant: -1000.0 };
            }
            let (solution, verdict, condition, seconds) = judged(&operator, &load);
            println!(
                "{name} {n} mu {friction}: {:?} {verdict:?} condition {condition:.1e} {:.1?} ms",
                solution.status,
                seconds.map(|s| 1e3 * s)
            );
            assert!(solution.status.is_solved());
        }
    }
}
