//! The surfaces of the reference cases, in the numbers of the paper.

use nalgebra::Vector3;
use wear::{Functional, Problem, RigidMode, Shape, SlidingMotion, Surface, WearLaw};

/// Drum brake: R = 200, t = 10, half angle 30 degrees, omega = 2.5 rad/s.
pub(crate) fn drum() -> Surface {
    let shape = Shape::Arc {
        radius: 200.0,
        centre: Vector3::zeros(),
        angles: [-30_f64.to_radians(), 30_f64.to_radians()],
        thickness: 10.0,
        internal: false,
    };
    Surface::new(shape, SlidingMotion::in_plane(2.5, Vector3::zeros())).unwrap()
}

/// Point of the drum at an angle in degrees.
pub(crate) fn drum_at(surface: &Surface, degrees: f64) -> wear::SurfacePoint {
    let (s, c) = degrees.to_radians().sin_cos();
    let n = Vector3::new(s, 0.0, c);
    surface.point(n * 200.0, n, 0.0)
}

/// Annular punch: radii 20 and 120, omega = 2.5 rad/s.
pub(crate) fn annulus() -> Surface {
    Surface::new(Shape::Annulus { radii: [20.0, 120.0] }, SlidingMotion::about_z(2.5)).unwrap()
}

/// Punch: 60 mm long, 10 mm thick, 5 mm/s.
pub(crate) fn punch() -> Surface {
    let shape = Shape::Strip { x: [-30.0, 30.0], z: 0.0, thickness: 10.0 };
    Surface::new(shape, SlidingMotion::along_x(5.0)).unwrap()
}

/// Point of a plane surface.
pub(crate) fn plane_at(surface: &Surface, x: f64) -> wear::SurfacePoint {
    surface.point(Vector3::new(x, 0.0, 0.0), Vector3::z(), 0.0)
}

/// A problem with beta = 2e-4, mu = .25 and shear in the balance, one wearing body.
pub(crate) fn problem(surface: Surface, functional: Functional, q: f64, a: f64, b: f64, modes: Vec<RigidMode>) -> Problem {
    let mut problem = Problem::new(surface, WearLaw::from_beta(2e-4, 0.25, a, b), modes);
    problem.functional = functional;
    problem.q = q;
    problem.friction = 0.25;
    problem
}
