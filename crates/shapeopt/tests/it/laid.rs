//! The shape laid on the body as geometry, instead of given to the contact solve as a gap.
//!
//! ```text
//!   ___________ z = 200, rigid, pressed with F
//!  |           |
//!  |           |        (x, z) -> (x, z + g(x) (200 - z) / 100)
//!   \_       _/
//!  ___\_____/___ z = 100, plate
//! ```
//!
//! Small displacements: the difference is of the order of the gap's slope and of gap over size, and grows with the load.

use crate::bodies::punch;
use contact::{ContactLoad, ContactOperator, Motion, Pair};
use shapeopt::{GapCurve, Gauge, Integration, RigidPart, ShapeProblem, solve_shape};

const AREA: f64 = 600.0;
const FRICTION: f64 = 0.25;

/// Relative L2 difference of the contact pressure on the laid shape from the pressure that was wanted: 1 + x / 60 times `mean`.
fn difference(mean: f64) -> f64 {
    let wanted = |x: f64| mean * (1.0 + x / 60.0);
    let flat = punch(8, 6, true);
    let [body, plate] = flat.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let shape = solve_shape(&ShapeProblem {
        pair,
        traction: &|place| [wanted(place.position[0]), FRICTION * wanted(place.position[0])],
        cases_shaped: &[],
        cases_counter: &[],
        gauge: Gauge::HeldEdge,
        rigid: RigidPart::Smallest,
        integration: Integration::Lobatto,
    })
    .unwrap();
    let gap = GapCurve::of(&shape, &pair);
    let laid = punch(8, 6, true).with_shaped(|[x, z]| [x, z + gap.at(x + 30.0) * (200.0 - z) / 100.0]);
    let [body, plate] = laid.reduced();
    let pair = Pair::facing(&body.interface, &plate.interface).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let points = operator.points();
    let distance: Vec<f64> = points.iter().map(|p| pair.distance(p)).collect();
    let moment: f64 = points.iter().map(|p| p.weight * p.position[0] * wanted(p.position[0])).sum();
    let mut load = ContactLoad::factors(&[], &[]).sliding(FRICTION, vec![1.0; points.len()]);
    load.moment = contact::MomentBalance::Pressure;
    load.motions[1] = Motion::Free { resultant: -mean * AREA };
    load.motions[2] = Motion::Free { resultant: -moment };
    let found = operator.solve(&distance, &load, None).unwrap();
    assert!(found.status.is_solved(), "{}", found.status);
    let square = |f: &dyn Fn(usize) -> f64| (0..points.len()).map(|i| points[i].weight * f(i).powi(2)).sum::<f64>();
    (square(&|i| found.pressure[i] - wanted(points[i].position[0])) / square(&|i| wanted(points[i].position[0]))).sqrt()
}

#[test]
fn laid_on_the_mesh_the_shape_gives_the_pressure_back_but_for_the_small_displacements() {
    let [light, heavy] = [difference(5.0 / 3.0), difference(50.0 / 3.0)];
    println!("relative difference: {light:.2e} at 1 kN, {heavy:.2e} at 10 kN");
    assert!(light < 1e-3);
    // It is the difference between laid and given: in proportion to the gap, not an error of either solve.
    assert!((heavy / light - 10.0).abs() < 1.0, "{light:e} {heavy:e}");
}
