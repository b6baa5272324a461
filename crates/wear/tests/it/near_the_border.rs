//! Forces near the border of an area, which press a small part of it.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use wear::{Problem, RigidMode, Shape, SlidingMotion, Surface, WearLaw, optimal_pressure};

/// A force near a corner presses a triangle there: p = 6 F / (a b) at the corner of the sides a, b, four times as long as the force is away.
#[test]
fn a_force_near_the_corner_of_a_rectangle_presses_a_triangle() {
    let surface = Surface::new(Shape::Rectangle { x: [-30.0, 30.0], y: [-20.0, 20.0] }, SlidingMotion::along_x(5.0)).unwrap();
    let law = WearLaw { factor: 1e-7, speed_exponent: 1.0, pressure_exponent: 1.0 };
    let force = 1e4;
    for [x, y] in [[1.0, 1.0], [0.1, 0.1], [0.01, 0.01], [1e-3, 2e-3], [1e-4, 1e-4], [1e-4, 1.0], [1.0, 1e-4], [1e-5, 1e-5]] {
        for [right, back] in [[1.0, -1.0], [-1.0, 1.0]] {
            let moments = [force * right * (30.0 - x), force * back * (20.0 - y)];
            let about = Vector3::zeros();
            let modes =
                vec![RigidMode::press_down(force), RigidMode::tilt(moments[0], about), RigidMode::tilt_y(moments[1], about)];
            let optimum = optimal_pressure(&Problem::new(surface.clone(), law, modes));
            let optimum = optimum.unwrap_or_else(|error| panic!("{x} mm, {y} mm: {error}"));
            let wanted = 6.0 * force / (16.0 * x * y);
            let corner = surface.point(Vector3::new(30.0 * right, 20.0 * back, 0.0), Vector3::z(), 0.0);
            assert_relative_eq!(optimum.pressure_at(&corner), wanted, max_relative = 1e-9 / x.min(y));
        }
    }
}

/// The part of an ellipse or a sector that a force near its border presses may lie between any two lines of points.
#[test]
fn a_force_near_the_border_of_an_ellipse_or_a_sector_is_carried() {
    let law = WearLaw { factor: 1e-7, speed_exponent: 0.0, pressure_exponent: 1.0 };
    let force = 1e4;
    let carried = |shape: Shape, [x, y]: [f64; 2]| {
        let surface = Surface::new(shape.clone(), SlidingMotion::along_x(5.0)).unwrap();
        let moments = [force * x, force * y];
        let about = Vector3::zeros();
        let modes = vec![RigidMode::press_down(force), RigidMode::tilt(moments[0], about), RigidMode::tilt_y(moments[1], about)];
        let optimum = optimal_pressure(&Problem::new(surface, law, modes));
        let optimum = optimum.unwrap_or_else(|error| panic!("{shape:?} {x} mm, {y} mm: {error}"));
        for (got, wanted) in optimum.resultants.iter().zip([force, moments[0], moments[1]]) {
            assert!((got - wanted).abs() < 1e-9 * (force + wanted.abs()), "{shape:?}: {got} {wanted}");
        }
    };
    for inside in [1e-2, 1e-3] {
        for turn in [0.0, 1.1, 4.0] {
            let (sine, cosine) = f64::sin_cos(turn);
            carried(Shape::Ellipse { semi_axes: [30.0, 20.0] }, [30.0 * (1.0 - inside) * cosine, 20.0 * (1.0 - inside) * sine]);
        }
        let sector = Shape::Sector { radii: [50.0, 90.0], angles: [-0.5, 0.7] };
        for angle in [-0.5 + inside, 0.3] {
            let (sine, cosine) = f64::sin_cos(angle);
            let radius = 90.0 * (1.0 - inside);
            carried(sector.clone(), [radius * cosine, radius * sine]);
        }
    }
}
