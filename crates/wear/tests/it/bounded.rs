//! Wear rules whose rate stays below a bound: the pressure goes to infinity there, and what it carries may have a bound of its own.

use approx::assert_relative_eq;
use wear::nalgebra::Vector3;
use wear::{
    FunctionLaw, Optimum, OwnRule, Problem, RigidMode, Shape, SlidingMotion, Surface, WearError, WearLaw, WearPair,
    optimal_pressure,
};

const RATE: f64 = 1e-6;

/// A strip of 2 x 2 mm under 10 N with a moment in N mm.
fn strip(rule: impl Into<wear::Rule>, moment: f64) -> Result<Optimum, WearError> {
    let shape = Shape::Strip { x: [-1.0, 1.0], z: 0.0, thickness: 2.0 };
    let surface = Surface::new(shape, SlidingMotion::along_x(3.0)).unwrap();
    let mut modes = vec![RigidMode::press_down(10.0)];
    if moment != 0.0 {
        modes.push(RigidMode::tilt(moment, Vector3::zeros()));
    }
    optimal_pressure(&Problem { wear: WearPair::alone(rule), ..Problem::new(surface, WearLaw::NONE, modes) })
}

fn tanh() -> OwnRule {
    OwnRule::new(|p, v| [RATE * v * p.tanh(), RATE * v / p.cosh().powi(2)])
}

fn says_bound(error: &WearError) -> bool {
    matches!(error, WearError::Infeasible { why, .. } if why.contains("bound"))
}

#[test]
fn a_rate_that_does_not_grow_determines_no_pressure() {
    let error = strip(OwnRule::new(|_, v| [RATE * v, 0.0]), 1.0).unwrap_err();
    assert!(says_bound(&error), "{error}");
}

/// p = artanh f of f = 1 - c (1 - x): where it carries 10 N its moment is 1.0 N mm, and where its moment is a fifth of its force, some 5.5 N.
#[test]
fn a_load_that_is_not_carried_at_the_bound_of_the_rate_is_refused_as_such() {
    let started = std::time::Instant::now();
    let error = strip(tanh(), 2.0).unwrap_err();
    assert!(says_bound(&error), "{error}");
    assert!(started.elapsed().as_secs() < 60, "{:?}", started.elapsed());
    let even = strip(tanh(), 0.0).unwrap();
    assert_relative_eq!(even.p_max, 2.5, max_relative = 1e-12);
}

/// The same of an arc under one force, whose middle alone comes to the bound.
#[test]
fn a_force_that_is_not_carried_at_the_bound_of_the_rate_is_refused_as_such() {
    let shape = Shape::Arc { radius: 2.0, centre: Vector3::zeros(), angles: [-0.7, 0.9], thickness: 1.0, internal: false };
    let surface = Surface::new(shape, SlidingMotion::in_plane(2.0, Vector3::zeros())).unwrap();
    let solve = |force: f64| optimal_pressure(&Problem::new(surface.clone(), tanh(), vec![RigidMode::press_down(force)]));
    let error = solve(10.0).unwrap_err();
    assert!(says_bound(&error), "{error}");
    assert_relative_eq!(solve(3.0).unwrap().resultants[0], 3.0, max_relative = 1e-9);
}

/// The force of p = ps f / (1 - f) under a linear f is 2 ps (-ln(1 - f) - f) / f' from the end of contact to the edge.
#[test]
fn saturating_and_severe_wear_carry_a_moment_far_beyond_the_kern() {
    for half in [1e-2, 1.0, 100.0] {
        let optimum = strip(OwnRule::from(FunctionLaw::Saturating { k: RATE, half }), 6.0).unwrap();
        assert_relative_eq!(optimum.resultants[0], 10.0, max_relative = 1e-8);
        assert_relative_eq!(optimum.resultants[1], 6.0, max_relative = 1e-8);
        let feed = optimum.feed.unwrap().iter().map(|feed| feed / (RATE * half * 3.0)).collect::<Vec<_>>();
        let at = |x: f64| feed[0] + feed[1] * x;
        assert!(at(1.0) < 1.0);
        let integral = |f: f64| -(-f).ln_1p() - f;
        let force = 2.0 * half * (integral(at(1.0)) - integral(at(-1.0).max(0.0))) / feed[1];
        assert_relative_eq!(force, 10.0, max_relative = 1e-6);
    }
    let severe = strip(OwnRule::from(FunctionLaw::Severe { mild: 1e-3, above: 2.5, severe: 1e-7 }), 0.5).unwrap();
    assert_relative_eq!(severe.resultants[1], 0.5, max_relative = 1e-8);
}
