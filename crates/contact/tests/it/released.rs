//! A contact from points that are held: the one that all points together find.

use crate::cattaneo_mindlin::{FRICTION, NORMAL, SHEAR, bodies, gap, hertz, push};
use approx::assert_relative_eq;
use contact::*;

/// Largest differences of pressure, shear and opening of two solutions, each over the largest value.
fn apart(one: &ContactSolution, other: &ContactSolution) -> f64 {
    let of = |a: &[f64], b: &[f64]| {
        let largest = b.iter().fold(f64::MIN_POSITIVE, |most, v| most.max(v.abs()));
        a.iter().zip(b).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs() / largest))
    };
    of(&one.pressure, &other.pressure).max(of(&one.shear, &other.shear)).max(of(&one.opening, &other.opening))
}

#[test]
fn points_held_by_mistake_open_and_points_left_out_come_into_contact() {
    let bodies = bodies(&[hertz(NORMAL).0], 1.3, 8, 3);
    let pair = bodies.pair().unwrap();
    let points = pair.points();
    let gap: Vec<f64> = points.iter().map(gap).collect();
    let (n, middle) = (points.len(), points[points.len() / 2].position[0]);
    let near = |reach: f64| points.iter().map(|p| (p.position[0] - middle).abs() <= reach).collect::<Vec<bool>>();
    let drag: Vec<f64> = vec![-1.0; n];
    let press = ContactLoad { friction: Friction::None, ..push(NORMAL, 0.0, &[]) };
    let slide = ContactLoad { friction: Friction::Sliding { coefficient: FRICTION, drag }, ..press.clone() };
    for load in [press, slide] {
        // The surface reaches 1.3 times as far as contact; the last three points on both sides of it, all of them, and too few.
        for reach in [1.1, 2.0, 0.98, 0.9] {
            // What was expected in contact is not what is held.
            let beside = near(0.9 * hertz(NORMAL).0).into_iter().map(|held| !held).collect::<Vec<bool>>();
            let operator = ContactOperator::near(&pair, true, &beside).unwrap();
            let exact = ContactOperator::new(&pair, true).unwrap().solve(&gap, &load, None).unwrap();
            let mut held = operator.held_on(&near(reach * hertz(NORMAL).0));
            let start = held.solve(&gap, &load).unwrap().unwrap();
            let found = held.released(&gap, &load, &start).unwrap();
            println!(
                "{reach}: start {:.1e}, apart {:.1e}, {} steps",
                start.complementarity,
                apart(&found, &exact),
                found.iterations
            );
            assert!(start.complementarity > 1e-6, "there is nothing to mend");
            assert_eq!((found.status.clone(), &found.states), (exact.status.clone(), &exact.states));
            assert!(apart(&found, &exact) < 1e-11 && found.complementarity < 1e-12);
            assert!(reach > 1.3 || held.points().len() < n, "all points together were asked after all");
            let values = |of: Result<Option<[f64; 2]>, Error>| of.unwrap().unwrap();
            let (held, all) = (held.singular_values(&gap, &load, &found), operator.singular_values(&gap, &load, &exact));
            assert_relative_eq!(values(held)[0], values(all)[0], max_relative = 0.05);
        }
    }
}

#[test]
fn stick_turns_to_slip_and_the_end_that_shear_shifts_takes_points_in() {
    let bodies = bodies(&[0.3 * hertz(NORMAL).0, hertz(NORMAL).0], 1.3, 8, 3);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let press = ContactLoad { friction: Friction::None, ..push(NORMAL, 0.0, &[]) };
    let pressed = operator.solve(&gap, &press, None).unwrap();
    let load = push(NORMAL, SHEAR, &pressed.slip);
    let exact = operator.solve(&gap, &load, Some(&pressed)).unwrap();
    let stick = |states: &[ContactState]| states.iter().filter(|s| **s == ContactState::Stick).count();
    // All points in contact stick at first.
    let mut held = operator.held_on(&pressed.closed);
    let start = held.solve_states(&gap, &load, &pressed.states).unwrap().unwrap();
    let found = held.released(&gap, &load, &start).unwrap();
    println!("{} points stick of {}, apart {:.1e}", stick(&found.states), stick(&start.states), apart(&found, &exact));
    assert!(stick(&found.states) < stick(&start.states) && exact.closed != pressed.closed);
    assert_eq!((found.status.clone(), &found.states), (exact.status.clone(), &exact.states));
    assert!(apart(&found, &exact) < 1e-11 && held.points().len() < gap.len());
}

#[test]
fn a_surface_that_closes_all_over_is_found_from_a_part_of_it() {
    let bodies = bodies(&[hertz(NORMAL).0], 1.3, 6, 2);
    let pair = bodies.pair().unwrap();
    let operator = ContactOperator::new(&pair, false).unwrap();
    let n = operator.points().len();
    let load = ContactLoad { friction: Friction::None, ..push(NORMAL, 0.0, &[]) };
    let mut held = operator.held_on(&(0..n).map(|i| i > 2 && i < n - 3).collect::<Vec<bool>>());
    let gap = vec![0.0; n];
    let start = held.solve(&gap, &load).unwrap().unwrap();
    let found = held.released(&gap, &load, &start).unwrap();
    assert_eq!(found.status, Status::ClosedEverywhere);
    assert!(apart(&found, &operator.solve(&gap, &load, None).unwrap()) < 1e-11);
}
