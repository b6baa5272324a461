//! Numbers that say nothing are refused by their names.

use crate::surfaces::{problem, punch};
use nalgebra::Vector3;
use wear::{
    Counterface, FunctionLaw, Functional, Groove, OwnFunctional, OwnRule, Problem, RigidMode, RigidMotion, Shape, SlidingMotion,
    Surface, SurfacePoint, Unbalanced, WearError, WearLaw, WearPair, optimal_pressure,
};

fn tilted(q: f64, moment: f64) -> Problem {
    let modes = vec![RigidMode::press_down(1000.0), RigidMode::tilt(moment, Vector3::zeros())];
    problem(punch(), Functional::WearVolume, q, 1.0, 1.0, modes)
}

fn named(error: WearError) -> &'static str {
    match error {
        WearError::OutOfRange { name, .. } => name,
        other => unreachable!("{other}"),
    }
}

/// The limits of large and of low exponents are one where the load closes every point alone.
#[test]
fn q_of_minus_infinity_is_the_limit_of_negative_q() {
    for moment in [2000.0, 24_000.0] {
        let wanted = optimal_pressure(&tilted(-1000.0, moment)).unwrap_err();
        assert!(matches!(wanted, WearError::Infeasible { .. }), "{wanted}");
        assert_eq!(optimal_pressure(&tilted(f64::NEG_INFINITY, moment)).unwrap_err(), wanted);
        assert!(optimal_pressure(&tilted(f64::INFINITY, moment)).is_ok());
    }
    let even = |q: f64| problem(punch(), Functional::WearVolume, q, 1.0, 1.0, vec![RigidMode::press_down(1000.0)]);
    let [least, most] = [f64::NEG_INFINITY, f64::INFINITY].map(|q| optimal_pressure(&even(q)).unwrap());
    assert_eq!(least.p_max, most.p_max);
    // More than a half turn of an arc has points that no force closes.
    let arc = Shape::Arc { radius: 80.0, centre: Vector3::zeros(), angles: [-2.0, 1.0], thickness: 10.0, internal: false };
    let arc = Surface::new(arc, SlidingMotion::in_plane(2.0, Vector3::zeros())).unwrap();
    let open = |q: f64| Problem { surface: arc.clone(), ..even(q) };
    let wanted = optimal_pressure(&open(-10.0)).unwrap_err();
    assert_eq!(optimal_pressure(&open(f64::NEG_INFINITY)).unwrap_err(), wanted);
    let error = optimal_pressure(&tilted(1e100, 2000.0));
    assert!(error.as_ref().is_ok() || !error.unwrap_err().to_string().contains("p_max"), "no cap is given");
}

#[test]
fn surfaces_of_no_numbers_are_refused_by_name() {
    let point =
        SurfacePoint { position: Vector3::zeros(), normal: Vector3::z(), weight: 1.0, sliding_speed: 5.0, drag: Vector3::x() };
    let nan = Vector3::new(f64::NAN, 0.0, 0.0);
    for (wrong, name) in [
        (SurfacePoint { weight: -1.0, ..point }, "weight of a point"),
        (SurfacePoint { sliding_speed: -3.0, ..point }, "sliding speed of a point"),
        (SurfacePoint { sliding_speed: f64::NAN, ..point }, "sliding speed of a point"),
        (SurfacePoint { position: nan, ..point }, "place, normal or drag of a point"),
        (SurfacePoint { normal: nan, ..point }, "place, normal or drag of a point"),
    ] {
        assert_eq!(named(Surface::from_points(vec![point, point, wrong]).unwrap_err()), name);
    }
    assert!(Surface::from_points(vec![point, SurfacePoint { weight: 0.0, sliding_speed: 0.0, ..point }]).is_ok());
    let strip = |z: f64| Shape::Strip { x: [-30.0, 30.0], z, thickness: 10.0 };
    let arc = Shape::Arc { radius: 80.0, centre: nan, angles: [-1.0, 1.0], thickness: 1.0, internal: false };
    let refused = |shape, speed| named(Surface::new(shape, SlidingMotion::along_x(speed)).unwrap_err());
    assert_eq!(refused(strip(f64::NAN), 5.0), "height of the strip");
    assert_eq!(refused(strip(0.0), f64::NAN), "sliding motion");
    assert_eq!(refused(arc, 5.0), "centre");
}

/// Normals that are none scaled the load: of 10 N half was carried by normals of length 2.
#[test]
fn directions_that_are_no_unit_vectors_and_more_than_a_full_turn_are_refused_by_name() {
    let point =
        SurfacePoint { position: Vector3::zeros(), normal: Vector3::z(), weight: 1.0, sliding_speed: 5.0, drag: Vector3::x() };
    let listed = |wrong| Surface::from_points(vec![point, wrong]);
    for length in [0.0, 0.5, 2.0, 1.0 + 1e-4] {
        let wrong = SurfacePoint { normal: length * Vector3::z(), ..point };
        assert_eq!(named(listed(wrong).unwrap_err()), "length of the normal of a point");
    }
    for length in [1e-3, 5.0] {
        let wrong = SurfacePoint { drag: length * Vector3::x(), ..point };
        assert_eq!(named(listed(wrong).unwrap_err()), "length of the drag of a point");
    }
    assert!(listed(SurfacePoint { drag: Vector3::zeros(), ..point }).is_ok());
    assert!(listed(SurfacePoint { normal: (1.0 + 1e-7) * Vector3::z(), ..point }).is_ok());
    let motion = SlidingMotion::about_z(1.0);
    let turn = std::f64::consts::TAU;
    let sector = |angle: f64| Surface::new(Shape::Sector { radii: [1.0, 2.0], angles: [-1.0, angle - 1.0] }, motion);
    let centre = Vector3::zeros();
    let arc = |angle: f64| {
        Surface::new(Shape::Arc { radius: 1.0, centre, angles: [0.0, angle], thickness: 1.0, internal: true }, motion)
    };
    assert_eq!(named(sector(1.01 * turn).unwrap_err()), "angle of the sector");
    assert_eq!(named(arc(7.0).unwrap_err()), "angle of the arc");
    assert!(sector(turn).is_ok() && sector(turn * (1.0 + 1e-12)).is_ok() && arc(turn).is_ok());
}

#[test]
fn modes_tracks_and_rules_of_no_numbers_are_refused_by_name() {
    let base = tilted(1.5, 100.0);
    let translation = |z: f64| RigidMotion::Translation { direction: Vector3::new(0.0, 0.0, z) };
    let about = Vector3::new(0.0, f64::NAN, 0.0);
    let turned = RigidMotion::Rotation { axis: Vector3::y(), about };
    for motion in [translation(-2.0), translation(0.0), translation(f64::NAN), turned] {
        let modes = vec![RigidMode { motion, resultant: 1000.0 }];
        let error = optimal_pressure(&Problem { modes, ..base.clone() }).unwrap_err();
        assert!(matches!(error, WearError::Modes { .. }), "{motion:?}: {error}");
    }
    let law = WearLaw { factor: 1e-7, speed_exponent: 1.0, pressure_exponent: 1.0 };
    let force = vec![RigidMode::press_down(1000.0)];
    for area in [-100.0, 0.0, f64::NAN] {
        let surface = punch().with_track_area(area);
        let fresh = Problem::new(surface.clone(), law, force.clone());
        assert_eq!(named(optimal_pressure(&fresh).unwrap_err()), "track area of the counterface");
        let revolving = Problem { counterface: Counterface::Revolving, ..Problem::new(surface, law, force.clone()) };
        let revolving = Problem { wear: WearPair::archard([1e-7; 2], [1.0; 2], [1.0; 2]), ..revolving };
        assert_eq!(named(optimal_pressure(&revolving).unwrap_err()), "track area of the counterface");
    }
    // Of a body that does not wear too.
    for thresholds in [[f64::NAN, 0.0], [-1.0, 0.0], [f64::INFINITY, 0.0], [0.0, f64::NAN]] {
        let wear = WearPair::archard([1e-7, 0.0], [1.0; 2], [1.0; 2]).above(thresholds);
        let wrong = Problem { wear, ..Problem::new(punch(), law, force.clone()) };
        assert_eq!(named(optimal_pressure(&wrong).unwrap_err()), "threshold pressure", "{thresholds:?}");
    }
    let wear = WearPair::archard([1e-7, 0.0], [1.0; 2], [1.0; 2]);
    assert_eq!(wear.clone().above([0.0, 2.0]), wear);
    let none = OwnFunctional::new(|p, _, _| if p > 100.0 { [p * p, f64::NAN, 2.0] } else { [p * p, 2.0 * p, 2.0] });
    for functional in [OwnFunctional::new(|_, _, _| [f64::NAN; 3]), none] {
        let wrong = Problem { functional: Functional::Own(functional), ..Problem::new(punch(), law, force.clone()) };
        let name = named(optimal_pressure(&wrong).unwrap_err());
        assert_eq!(name, "density of a functional given as a function, or one of its derivatives");
    }
    for (law, name) in [
        (FunctionLaw::Saturating { k: -1.0, half: 1.0 }, "k"),
        (FunctionLaw::Severe { mild: 1e-7, above: f64::NAN, severe: 1.0 }, "above"),
    ] {
        let wrong = Problem::new(punch(), OwnRule::from(law), force.clone());
        assert_eq!(named(optimal_pressure(&wrong).unwrap_err()), name);
    }
    assert_eq!(Groove::new(5.0, &[0.0, 1.0]).depth(&[], 0.0), 0.0);
}

#[test]
fn reasons_speak_of_the_pressures_that_they_are_true_of() {
    let point =
        SurfacePoint { position: Vector3::x(), normal: Vector3::z(), weight: 1.0, sliding_speed: 5.0, drag: Vector3::x() };
    let rests = SurfacePoint { position: -Vector3::x(), sliding_speed: 0.0, drag: Vector3::zeros(), ..point };
    let listed = Surface::from_points(vec![point, rests]).unwrap();
    let law = WearLaw { factor: 1e-7, speed_exponent: 1.0, pressure_exponent: 1.0 };
    let one = vec![RigidMode::press_down(10.0)];
    let two = vec![RigidMode::press_down(10.0), RigidMode::tilt(1.0, Vector3::zeros())];
    let kind = |error: &WearError| match error {
        WearError::Infeasible { kind, .. } => *kind,
        other => unreachable!("{other}"),
    };
    let words = |problem: &Problem, wanted: Unbalanced| {
        let error = optimal_pressure(problem).unwrap_err();
        assert_eq!(kind(&error), wanted);
        error.to_string()
    };
    for modes in [one.clone(), two.clone()] {
        let said = words(&Problem::new(listed.clone(), law, modes), Unbalanced::NoStationaryPressure);
        assert!(said.starts_with("no stationary pressure") && said.contains("does not slide"), "{said}");
    }
    // Without the speed in the rule the point counts like another.
    let evenly = WearLaw { speed_exponent: 0.0, ..law };
    assert!(optimal_pressure(&Problem::new(listed, evenly, two.clone())).is_ok());
    for modes in [one.clone(), two] {
        let error = optimal_pressure(&Problem::new(punch(), OwnRule::new(|_, _| [f64::NAN; 2]), modes)).unwrap_err();
        assert_eq!(named(error), "rate of a wear rule given as a function");
    }
    let below = WearPair::alone(law).above([1.0, 0.0]);
    let said = words(&Problem { wear: below, ..Problem::new(punch(), law, one) }, Unbalanced::ManyPressures);
    assert!(said.starts_with("more than one pressure"), "{said}");
    let said = words(&tilted(-1.0, 24_000.0), Unbalanced::NoStationaryPressure);
    assert!(said.starts_with("no stationary pressure"), "{said}");
    let said = words(&tilted(2.0, 40_000.0), Unbalanced::NoPressure);
    assert!(said.starts_with("no pressure p >= 0"), "{said}");
}

/// Rates were looked at at three pressures alone, and a rule that falls between them had a steady state that is none.
#[test]
fn rules_of_ones_own_whose_rate_does_not_grow_are_refused_by_name() {
    let force = vec![RigidMode::press_down(1000.0)];
    let answer = |law: fn(f64, f64) -> [f64; 2]| optimal_pressure(&Problem::new(punch(), OwnRule::new(law), force.clone()));
    let refused = |law| match answer(law) {
        Err(WearError::OutOfRange { name: "rate of a wear rule given as a function", wanted, .. }) => wanted,
        other => unreachable!("{other:?}"),
    };
    // Less wear from 20 to 30 MPa than at 20 MPa.
    assert_eq!(
        refused(|p, v| if (20.0..30.0).contains(&p) { [1e-6 * v, 0.0] } else { [1e-7 * p * v, 1e-7 * v] }),
        "no less than at a smaller pressure"
    );
    assert_eq!(refused(|p, v| if p < 0.1 { [-1e-7 * v, 0.0] } else { [1e-7 * p * v, 1e-7 * v] }), "zero or positive");
    assert_eq!(refused(|p, v| if (50.0..70.0).contains(&p) { [f64::NAN; 2] } else { [1e-7 * p * v, 1e-7 * v] }), "finite");
    // Only where it slides fast.
    let fast = |p: f64, v: f64| if v > 250.0 && p > 20.0 { [1e-9, 0.0] } else { [1e-7 * p * v, 1e-7 * v] };
    let ring = Problem::new(crate::surfaces::annulus(), OwnRule::new(fast), force.clone());
    assert_eq!(named(optimal_pressure(&ring).unwrap_err()), "rate of a wear rule given as a function");
    // A threshold, a bound, and a rate without one are rates that grow.
    assert!(answer(|p, v| if p > 0.1 { [1e-7 * (p - 0.1) * v, 1e-7 * v] } else { [0.0; 2] }).is_ok());
    assert!(answer(|p, v| [1e-5 * v * p.tanh(), 1e-5 * v * (1.0 - p.tanh().powi(2))]).is_ok());
    assert!(answer(|p, v| [1e-7 * v * (p.exp() - 1.0), 1e-7 * v * p.exp()]).is_ok());
}

/// What `carried` refuses has no optimal pressure, for the same reason.
#[test]
fn loads_that_no_pressure_carries_are_told_without_a_search_for_one() {
    let said =
        |problem: &Problem| [wear::carried(problem), optimal_pressure(problem).map(|_| ())].map(|answer| answer.unwrap_err());
    // 1000 N on 600 mm^2.
    let capped = |p_max: f64, moment: f64| Problem { p_max: Some(p_max), ..tilted(2.0, moment) };
    for (problem, words) in [
        (capped(1.6, 0.0), "under p_max"),
        (capped(2.0, 6000.0), "under p_max"),
        (tilted(2.0, 30_000.0), "beyond the edge"),
        (tilted(2.0, -40_000.0), "beyond the edge"),
        (Problem { modes: vec![RigidMode::press_down(-1000.0)], ..tilted(2.0, 0.0) }, "no force presses"),
    ] {
        let [carried, optimal] = said(&problem);
        assert!(carried.to_string().contains(words) && carried == optimal, "{carried} {optimal}");
    }
    for problem in [capped(1.7, 0.0), capped(2.0, 2000.0), tilted(2.0, 29_900.0), tilted(0.5, 0.0)] {
        assert_eq!((wear::carried(&problem), optimal_pressure(&problem).is_ok()), (Ok(()), true));
    }
}
