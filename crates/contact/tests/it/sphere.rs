//! Elastic sphere on an elastic disc, steel on steel, axisymmetric: R 5 mm, 21 N; half-space values a = 0.088044, p0 = 1293.48.

use crate::common::cylinder::{Sizes, block, round};
use crate::common::{material, touching};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact::*;
use hpfem::{Body, Direction, EdgeTraction, Kinematics, Mesh};

const YOUNG: f64 = 2.1e5;
const SIZES: Sizes = Sizes { radius: 5.0, width: 10.0, depth: 10.0 };

fn bodies(end: f64, degree: usize, layers: usize, force: f64, poisson: f64) -> Rebuilt {
    let pressure = force / (std::f64::consts::PI * SIZES.radius * SIZES.radius);
    let held = |mesh: Mesh| {
        touching(mesh, [degree, layers], Kinematics::Axisymmetric, material(YOUNG, poisson)).hold("axis", Direction::First)
    };
    let load = EdgeTraction::new("top", move |_| [0.0, -pressure]);
    let upper = held(round(&SIZES, &[end], 1.6, layers)).load("force", load);
    let lower = held(block(&SIZES, &[end], 1.6, layers)).clamp("bottom");
    let reduced = |problem| Body::new(problem).unwrap().interface;
    Rebuilt { shaped: reduced(upper), counter: reduced(lower), facing: true }
}

fn gap(point: &ContactPoint) -> f64 {
    let x = point.position[0];
    x * x / (SIZES.radius + (SIZES.radius.powi(2) - x * x).sqrt())
}

/// `a^3 = 3 F R / (4 E*)`, `p0 = 3 F / (2 pi a^2)`.
fn hertz(force: f64, poisson: f64) -> (f64, f64) {
    let modulus = YOUNG / (2.0 * (1.0 - poisson * poisson));
    let end = (0.75 * force * SIZES.radius / modulus).cbrt();
    (end, 1.5 * force / (std::f64::consts::PI * end * end))
}

/// `a/R` of Hertz, and the relative deviations of contact radius and highest pressure from Hertz.
fn deviation(force: f64, poisson: f64) -> [f64; 3] {
    let (a, p) = hertz(force, poisson);
    let load = |_: &[ContactPoint]| ContactLoad::factors(&[1.0], &[]);
    let problem = Positioning { gap: &gap, load: &load, starts_closed: true, tolerance: 1e-10 };
    let result = position_ends::<Error>(&problem, &[1.0001 * a], |ends| Ok(bodies(ends[0], 12, 6, force, poisson))).unwrap();
    assert!(result.found);
    [a / SIZES.radius, result.ends[0] / a - 1.0, result.solution.pressure[0] / p - 1.0]
}

/// Response of a ball to a point force P at its surface, radius R, next to the force: Boussinesq's `P (1 - nu) / (2 pi G d)` of the tangent
/// plane, and since the surface is no plane a logarithm (Sternberg and Rosenthal 1952). To first order in 1/R the traction on the surface
/// `z = h = d^2 / (2 R)` vanishes when the tangent plane carries `q = -div (h sigma)`, `sigma_dd = -sigma_tt = (1 - 2 nu) P / (2 pi d^2)`: a
/// radial shear `-(1 - 2 nu) P / (2 pi R d)`, the gradient of `f = -(1 - 2 nu) P ln d / (2 pi R)`. By Cerruti a shear `grad f` moves the plane
/// by `(1 - 2 nu) f / (2 G)`, so that
///
/// ```text
/// u = P (1 - nu) / (2 pi G d) - k P ln d,   k = (1 - 2 nu)^2 / (4 pi G R)
/// ```
///
/// (the tilt of the surface between two places changes nothing: what the normal gains the tangent loses). `-k ln d` under Hertz's pressure is
/// a flatter ball, `f' = r/R - k P(r) / r` with the load `P(r)` inside r; with Sneddon's formulas for the shape f of an axisymmetric punch
/// `a = a0 (1 + E* k a / 2)`, `p0 = p00 (1 - pi^2 E* k a / 8)`: first powers of a/R, and none for nu = 1/2.
fn coefficient(poisson: f64) -> f64 {
    (1.0 - 2.0 * poisson).powi(2) / (8.0 * std::f64::consts::PI * (1.0 - poisson))
}

#[test]
fn deviation_of_the_sphere_from_the_half_space_is_the_logarithm_of_its_curvature() {
    assert_relative_eq!(hertz(21.0, 0.3).0, 0.088044, max_relative = 1e-5);
    assert_relative_eq!(hertz(21.0, 0.3).1, 1293.48, max_relative = 1e-5);
    for poisson in [0.0, 0.3, 0.45] {
        let found = [2.1, 0.021, 21e-6].map(|force| deviation(force, poisson));
        // e + c a/R + d (a/R)^2 with the error e of the mesh, which is the same for all small loads.
        let powers = nalgebra::Matrix3::from_fn(|i, j| found[i][0].powi(j as i32));
        let first = |k: usize| {
            let fit = powers.lu().solve(&nalgebra::Vector3::from_fn(|i, _| found[i][k])).unwrap();
            println!(
                "nu {poisson}: {:?}, mesh {:.1e}, of a/R {:.5}, of its square {:.3}",
                found.map(|f| f[k]),
                fit[0],
                fit[1],
                fit[2]
            );
            fit[1]
        };
        let (radius, pressure) = (coefficient(poisson), -0.25 * std::f64::consts::PI.powi(2) * coefficient(poisson));
        println!("theory {radius:.5} {pressure:.5}");
        assert_abs_diff_eq!(first(1), radius, epsilon = 3e-5);
        assert_abs_diff_eq!(first(2), pressure, epsilon = 1e-4);
    }
    let scene = deviation(21.0, 0.3);
    println!("21 N: {scene:?}");
    assert!(scene[1] > 0.0 && scene[1] < 2e-4 && scene[2] < 0.0 && scene[2] > -4e-4);
}
