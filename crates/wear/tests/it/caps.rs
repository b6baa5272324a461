//! Pressure caps at s = 1: where the cap is far above the mean pressure the surface is loaded along a strip that is narrower than any cell.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use wear::nalgebra::Vector3;
use wear::{Functional, Modes, Optimum, Problem, RigidMode, Shape, SlidingMotion, Surface, WearError, WearLaw, optimal_pressure};

const RADIUS: f64 = 200.0;
const THICKNESS: f64 = 10.0;
const FORCE: f64 = 1e4;
const FRICTION: f64 = 0.25;

/// The block shoe on a drum whose wear volume is the least under a cap.
fn shoe(cap: f64, mode_kind: Modes) -> Problem {
    let half = 30.0_f64.to_radians();
    let centre = Vector3::zeros();
    let shape = Shape::Arc { radius: RADIUS, centre, angles: [-half, half], thickness: THICKNESS, internal: false };
    let surface = Surface::new(shape, SlidingMotion::in_plane(2.5, centre)).unwrap();
    let rule = WearLaw { factor: 2e-4 * FRICTION, speed_exponent: 1.0, pressure_exponent: 1.0 };
    let mut problem = Problem::new(surface, rule, vec![RigidMode::press_down(FORCE)]);
    (problem.functional, problem.friction, problem.mode_kind, problem.p_max) =
        (Functional::WearVolume, FRICTION, mode_kind, Some(cap));
    problem
}

/// int psi p dS = 2 p R t sqrt(1 + mu^2) sin d over |alpha - atan mu| <= d.
#[test]
fn a_narrow_strip_at_the_cap_lies_about_the_angle_of_friction() {
    for cap in [60.0, 100.0, 150.0, 200.0, 300.0, 400.0, 600.0, 1e3, 3e3, 1e4] {
        let optimum = optimal_pressure(&shoe(cap, Modes::Associated)).unwrap_or_else(|error| panic!("{cap} MPa: {error}"));
        let half = (FORCE / (2.0 * cap * RADIUS * THICKNESS * (1.0 + FRICTION * FRICTION).sqrt())).asin();
        let side = optimum.points[0].drag.x.signum();
        let angles = || optimum.points.iter().zip(&optimum.pressure).filter(|(_, p)| **p > 0.0).map(|(point, _)| point);
        let middle = angles().map(|at| at.weight * at.position.x.atan2(at.position.z)).sum::<f64>()
            / angles().map(|at| at.weight).sum::<f64>();
        assert_abs_diff_eq!(middle, -side * FRICTION.atan(), epsilon = 1e-10);
        let width: f64 = angles().map(|at| at.weight).sum::<f64>() / (RADIUS * THICKNESS);
        assert_abs_diff_eq!(0.5 * width, half, epsilon = 1e-10);
        assert_relative_eq!(optimum.p_max, cap, max_relative = 1e-14);
        assert_relative_eq!(optimum.resultants[0], FORCE, max_relative = 1e-10_f64.max(1e-16 * 4.0 / half.powi(2)));
    }
}

/// Of the strip at a cap of 1e6 to 1e9 MPa f has few digits or none: it has an answer or an error, at once.
#[test]
fn a_strip_as_narrow_as_round_off_has_an_end() {
    for cap in [1e5, 1e6, 1e7, 1e9] {
        let started = std::time::Instant::now();
        match optimal_pressure(&shoe(cap, Modes::Associated)) {
            Ok(optimum) => assert_relative_eq!(optimum.resultants[0], FORCE, max_relative = 1e-2),
            Err(error) => assert!(matches!(error, WearError::NotConverged { .. }), "{error}"),
        }
        assert!(started.elapsed().as_secs() < 20, "{cap} MPa: {:?}", started.elapsed());
    }
}

/// Friction power on a sector that turns: p = p_max on pi/6 (r^2 - 100^2) = F / p_max beside the inner border.
#[test]
fn a_narrow_ring_at_the_cap_lies_beside_the_inner_border() {
    let half = 30.0_f64.to_radians();
    let sector = Shape::Sector { radii: [100.0, 150.0], angles: [-half, half] };
    let surface = Surface::new(sector, SlidingMotion::about_z(2.5)).unwrap();
    for cap in [10.0, 1e2, 1e3, 1e4, 1e5] {
        let optimum = capped(&surface, cap);
        let outer = (1e4 + FORCE / (cap * half)).sqrt();
        let farthest = optimum.points.iter().map(|at| at.position.norm()).fold(0.0, f64::max);
        assert!(farthest < outer + 1e-10, "{cap} MPa: {farthest} beyond {outer}");
        assert_relative_eq!(optimum.resultants[0], FORCE, max_relative = 1e-10);
    }
}

/// The least friction power of a surface without friction in its balance under a cap.
fn capped(surface: &Surface, cap: f64) -> Optimum {
    let mut problem = Problem::new(surface.clone(), WearLaw::NONE, vec![RigidMode::press_down(FORCE)]);
    (problem.functional, problem.friction, problem.p_max) = (Functional::FrictionPower, FRICTION, Some(cap));
    optimal_pressure(&problem).unwrap_or_else(|error| panic!("{cap} MPa: {error}"))
}
