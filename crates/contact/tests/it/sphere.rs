//! Elastic sphere on an elastic disc, steel on steel, axisymmetric: R 5 mm, 21 N; half-space values a = 0.088044, p0 = 1293.48.

use crate::common::cylinder::{Sizes, block, round};
use crate::common::{falling_degrees, material, support};
use approx::assert_relative_eq;
use contact::*;
use hpfem::{Body, BodyProblem, Direction, EdgeTraction, Kinematics, LoadCase, Mesh, SpaceKind, Support};

const SIZES: Sizes = Sizes { radius: 5.0, width: 10.0, depth: 10.0 };

fn bodies(end: f64, degree: usize, layers: usize, force: f64) -> Rebuilt {
    let pressure = force / (std::f64::consts::PI * SIZES.radius * SIZES.radius);
    let load = vec![vec![EdgeTraction { boundary: "top".into(), traction: Box::new(move |_| [0.0, -pressure]) }]];
    let reduce = |mesh: &Mesh, supports: &[Support], load: &[LoadCase<'_>]| {
        Body::new(BodyProblem {
            mesh,
            degrees: falling_degrees(mesh, degree, layers),
            space: SpaceKind::Tensor,
            kinematics: Kinematics::Axisymmetric,
            materials: &material(2.1e5, 0.3),
            supports,
            rigid_edge: None,
            load_cases: load,
            kept: Some("contact"),
        })
        .unwrap()
        .interface
    };
    let axis = support("axis", Direction::First);
    let clamp = [axis.clone(), support("bottom", Direction::First), support("bottom", Direction::Second)];
    Rebuilt {
        shaped: reduce(&round(&SIZES, &[end], 1.6, layers), &[axis], &load),
        counter: reduce(&block(&SIZES, &[end], 1.6, layers), &clamp, &[]),
        facing: true,
    }
}

fn gap(point: &ContactPoint) -> f64 {
    let x = point.position[0];
    x * x / (SIZES.radius + (SIZES.radius.powi(2) - x * x).sqrt())
}

/// `a^3 = 3 F R / (4 E*)`, `p0 = 3 F / (2 pi a^2)`.
fn hertz(force: f64) -> (f64, f64) {
    let modulus = 2.1e5 / (2.0 * 0.91);
    let end = (0.75 * force * SIZES.radius / modulus).cbrt();
    (end, 1.5 * force / (std::f64::consts::PI * end * end))
}

/// The surface of a sphere is no plane: besides Boussinesq's 1/r its response to a point force has a logarithm (Sternberg and Rosenthal
/// 1952), so that the deviation from the half-space falls like a/R, not like its square.
#[test]
fn deviation_of_the_sphere_from_the_half_space_falls_like_the_contact_radius() {
    assert_relative_eq!(hertz(21.0).0, 0.088044, max_relative = 1e-5);
    assert_relative_eq!(hertz(21.0).1, 1293.48, max_relative = 1e-5);
    let deviation = |force: f64| {
        let (a, p) = hertz(force);
        let load = |_: &[ContactPoint]| ContactLoad::factors(&[1.0], &[]);
        let problem = Positioning { gap: &gap, load: &load, starts_closed: true, tolerance: 1e-10 };
        let result = position_ends::<Error>(&problem, &[1.05 * a], |ends| Ok(bodies(ends[0], 12, 6, force))).unwrap();
        assert!(result.found);
        let d = (result.ends[0] / a - 1.0, result.solution.pressure[0] / p - 1.0);
        println!("{force} N: a {:.7}, p0 {:.4}, deviations {:.4e} {:.4e}", result.ends[0], result.solution.pressure[0], d.0, d.1);
        d
    };
    let (scene, middle, small, tiny) = (deviation(21.0), deviation(2.1), deviation(0.021), deviation(21e-6));
    assert!(scene.0.abs() < 2e-4 && scene.1.abs() < 4e-4);
    // The radius of contact falls by a factor of 10^(2/3).
    let rate = (middle.1 / small.1).ln() / 100.0_f64.cbrt().ln();
    println!("rate {rate:.3}");
    assert!((0.9..1.15).contains(&rate));
    // What is left on the axis is the discretisation alone.
    assert!(tiny.0.abs() < 5e-6 && tiny.1.abs() < 5e-6);
}
