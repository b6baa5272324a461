//! The arc length of the places at which a traction is asked for.

use crate::bodies::{HALF_ANGLE, RADIUS, drum, punch};
use contact::Pair;
use shapeopt::{Gauge, Integration, RigidPart, ShapeProblem, SurfacePlace, solve_shape};
use std::sync::Mutex;

/// Places asked for on a pair; those of both bodies.
fn asked(pair: Pair<'_>, integration: Integration, cases: &[f64]) -> Vec<SurfacePlace> {
    let places = Mutex::new(Vec::new());
    let traction = |place: &SurfacePlace| {
        places.lock().unwrap().push(*place);
        [1.0, 0.0]
    };
    let problem = ShapeProblem {
        pair,
        traction: &traction,
        cases_shaped: cases,
        cases_counter: &[],
        gauge: Gauge::Orthogonal,
        rigid: RigidPart::Smallest,
        integration,
    };
    solve_shape(&problem).unwrap();
    places.into_inner().unwrap()
}

#[test]
fn a_place_knows_its_arc_length_from_the_start_of_the_surface() {
    for integration in [Integration::Lobatto, Integration::Gauss(3)] {
        let bodies = punch(6, 2, false);
        let [body, plate] = bodies.reduced();
        let places = asked(Pair::new(&body.interface, Some(&plate.interface)).unwrap(), integration, &[]);
        assert!(places.len() > 20);
        for place in places {
            assert!((place.arc - (place.position[0] + 30.0)).abs() < 1e-12, "{place:?}");
        }
        let bodies = drum(6, 2);
        let [shoe, ring] = bodies.reduced();
        let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
        let places = asked(pair, integration, &[1.0]);
        for place in places {
            let angle = place.position[0].atan2(place.position[1]);
            assert!((place.arc - RADIUS * (angle + HALF_ANGLE)).abs() < 1e-11, "{place:?}");
            let there = pair.at_arc(place.arc).position;
            assert!((0..2).all(|k| (there[k] - place.position[k]).abs() < 1e-11), "{place:?} {there:?}");
        }
    }
    let bodies = punch(4, 0, false);
    let [body, plate] = bodies.reduced();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    for point in pair.points() {
        let place = SurfacePlace::from(&point);
        assert_eq!((place.arc, place.position, place.normal), (point.arc, point.position, point.normal));
    }
}
