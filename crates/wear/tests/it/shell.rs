//! Bearing shells free along both directions: half turns of contact, strong friction, two wearing bodies.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use wear::{Counterface, Functional, Problem, Regime, RigidMode, Shape, SlidingMotion, Surface, WearError, optimal_pressure};

use crate::surfaces::problem;

fn infeasible(case: &Problem) -> bool {
    matches!(optimal_pressure(case), Err(WearError::Infeasible { .. }))
}

/// A shell on a shaft of radius 25, free along x and z, 2000 N along -z, w' ~ p^b.
fn shell(half: f64, friction: f64, b: f64) -> Problem {
    let shape = Shape::Arc { radius: 25.0, centre: Vector3::zeros(), angles: [-half, half], thickness: 40.0, internal: false };
    let surface = Surface::new(shape, SlidingMotion::in_plane(30.0, Vector3::zeros())).unwrap();
    let side = RigidMode { motion: wear::RigidMotion::Translation { direction: Vector3::x() }, resultant: 0.0 };
    let mut case = problem(surface, Functional::Steady, 1.0, 1.0, b, vec![RigidMode::press_down(2000.0), side]);
    case.friction = friction;
    case
}

/// Simpson's rule.
fn simpson(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let count = 20000;
    let h = (to - from) / f64::from(count);
    let weight = |i: i32| if i == 0 || i == count { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
    (0..=count).map(|i| weight(i) * f(from + h * f64::from(i))).sum::<f64>() * h / 3.0
}

#[test]
fn a_shell_that_wraps_its_shaft_touches_over_half_a_turn_about_the_angle_of_friction() {
    // Where half a turn about the pole fits into the shell p = p_max cos^(1/b)(a - pole), whose resultant with friction is vertical for
    // pole = atan(mu): p_max sqrt(1 + mu^2) R t int cos^(1 + 1/b) = F.
    for half in [2.8, std::f64::consts::PI] {
        for friction in [0.0, 0.3, 1.0, 2.0_f64] {
            for b in [0.5, 1.0, 3.0] {
                let case = shell(half, friction, b);
                let pole = friction.atan();
                if pole + std::f64::consts::FRAC_PI_2 > half {
                    continue;
                }
                let optimum = optimal_pressure(&case).unwrap_or_else(|error| panic!("{half} {friction} {b}: {error}"));
                // cos = sin^3 at the ends, so that the integrand is smooth enough.
                let whole = simpson(-1.0, 1.0, |u| {
                    let a = std::f64::consts::FRAC_PI_2 * (1.5 * u - 0.5 * u.powi(3));
                    a.cos().max(0.0).powf(1.0 + 1.0 / b) * std::f64::consts::FRAC_PI_2 * 1.5 * (1.0 - u * u)
                });
                let top = 2000.0 / (1000.0 * (1.0 + friction * friction).sqrt() * whole);
                assert_relative_eq!(optimum.p_max, top, max_relative = 1e-8);
                assert_eq!(optimum.regime, Regime::PartialContact);
                for off in [-1.5, -0.4, 0.0, 0.9, 1.5] {
                    let p = optimum.pressure_at(&case.surface.along(pole + off));
                    assert_relative_eq!(p, top * off.cos().powf(1.0 / b), max_relative = 1e-8);
                }
                assert_eq!(optimum.pressure_at(&case.surface.along(pole - 1.6)), 0.0);
            }
        }
    }
}

#[test]
fn a_shell_is_balanced_up_to_the_friction_that_jams_it() {
    for half in [0.3, 1.2, 1.6, 2.0, 3.0_f64] {
        for b in [0.3, 1.0, 3.0, 5.0] {
            for share in [0.1, 0.5, 0.9, 0.99] {
                let friction = if half < 1.5 { share * half.tan() } else { 2.0 * share };
                let optimum = optimal_pressure(&shell(half, friction, b));
                let optimum = optimum.unwrap_or_else(|error| panic!("{half} {friction} {b}: {error}"));
                assert_relative_eq!(optimum.resultants[0], 2000.0, max_relative = 1e-9);
                assert!(optimum.resultants[1].abs() < 1e-6, "{half} {friction} {b}: {:?}", optimum.resultants);
                assert!(optimum.steadiness_residual.unwrap() < 1e-8, "{half} {friction} {b}: {:?}", optimum.steadiness_residual);
                let feed = optimum.feed.unwrap();
                assert!(feed[1] < 0.0, "the shell moves with the drag, which is towards -x at its top: {feed:?}");
            }
            if half < 1.5 {
                assert!(infeasible(&shell(half, 1.01 * half.tan(), b)), "{half} {b}");
            }
        }
    }
}

#[test]
fn a_shell_on_a_shaft_that_wears_too_is_balanced() {
    for (half, friction) in [(1.2, 1.0), (2.2, 1.0), (3.0, 0.3)] {
        for (counterface, b2) in [(Counterface::Revolving, 3.0), (Counterface::Revolving, 1.0), (Counterface::Congruent, 1.0)] {
            let mut case = shell(half, friction, 3.0);
            let mut second = *case.wear.rules[0].power().unwrap();
            second.pressure_exponent = b2;
            case.wear.rules[1] = second.into();
            case.counterface = counterface;
            let optimum =
                optimal_pressure(&case).unwrap_or_else(|error| panic!("{half} {friction} {counterface:?} {b2}: {error}"));
            assert_relative_eq!(optimum.resultants[0], 2000.0, max_relative = 1e-9);
            assert!(optimum.resultants[1].abs() < 1e-6, "{:?}", optimum.resultants);
            assert!(optimum.steadiness_residual.unwrap() < 1e-7, "{counterface:?} {b2}: {:?}", optimum.steadiness_residual);
        }
    }
}
