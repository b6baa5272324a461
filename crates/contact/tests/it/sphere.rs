//! Elastic sphere on an elastic disc, steel on steel, axisymmetric: R 5 mm, 21 N; half-space values a = 0.088044, p0 = 1293.48.

use crate::common::cylinder::{Sizes, block, round};
use crate::common::{falling_degrees, material, support};
use approx::assert_relative_eq;
use contact::*;
use hpfem::*;

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

#[test]
fn sphere_approaches_the_half_space_values_as_the_load_falls_with_a_finite_pressure_on_the_axis() {
    assert_relative_eq!(hertz(21.0).0, 0.088044, max_relative = 1e-5);
    assert_relative_eq!(hertz(21.0).1, 1293.48, max_relative = 1e-5);
    let deviation = |force: f64| {
        let (a, p) = hertz(force);
        let problem = Positioning {
            gap: &gap,
            load: &|_| ContactLoad::factors(&[1.0], &[]),
            starts_closed: true,
            tolerance: 1e-10,
        };
        let result = position_ends::<Error>(&problem, &[1.05 * a], |ends| Ok(bodies(ends[0], 14, 7, force))).unwrap();
        assert!(result.found);
        let d = (result.ends[0] / a - 1.0, result.solution.pressure[0] / p - 1.0);
        println!("{force} N: a {:.7}, p0 {:.4}, deviations {:.4e} {:.4e}", result.ends[0], result.solution.pressure[0], d.0, d.1);
        d
    };
    let (large, middle, small) = (deviation(21e3), deviation(2.1e3), deviation(21.0));
    assert!(small.0.abs() < 1e-3 && small.1.abs() < 1e-3);
    assert!(small.0.abs() < middle.0.abs() && middle.0.abs() < large.0.abs());
}
