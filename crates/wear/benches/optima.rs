//! Throughput of closed-form optima: annulus and drum, one core. Run with `cargo bench -p wearshape-wear`.

use std::time::Instant;

use nalgebra::Vector3;
use wear::{Functional, Problem, RigidMode, Shape, SlidingMotion, Surface, WearError, WearLaw, optimal_pressure};

fn main() -> Result<(), WearError> {
    let ring = Surface::new(Shape::Annulus { radii: [20.0, 120.0] }, SlidingMotion::about_z(2.5))?;
    let half = 30_f64.to_radians();
    let arc = Shape::Arc { radius: 200.0, centre: Vector3::zeros(), angles: [-half, half], thickness: 10.0, internal: false };
    let drum = Surface::new(arc, SlidingMotion::in_plane(2.5, Vector3::zeros()))?;
    let strip = Shape::Strip { x: [-30.0, 30.0], z: 0.0, thickness: 10.0 };
    let punch = Surface::new(strip, SlidingMotion::along_x(5.0))?;
    let tilt = RigidMode::tilt(5000.0, Vector3::zeros());
    for (name, surface, modes) in [
        ("annulus", ring, vec![RigidMode::press_down(4.4e6)]),
        ("drum", drum, vec![RigidMode::press_down(1e4)]),
        ("punch with moment", punch, vec![RigidMode::press_down(1e3), tilt]),
    ] {
        let mut problem = Problem::new(surface, WearLaw::from_beta(2e-4, 0.25, 1.0, 0.8), modes);
        problem.functional = Functional::WearPower;
        problem.friction = 0.25;
        const COUNT: usize = 20_000;
        let start = Instant::now();
        let mut sum = 0.0;
        for i in 0..COUNT {
            // q from .7 to 3.7: s from 1.26 up.
            problem.q = 0.7 + 3.0 * i as f64 / COUNT as f64;
            sum += optimal_pressure(&problem)?.p_max;
        }
        let seconds = start.elapsed().as_secs_f64();
        println!("{name:<18} {:>9.0} optima/s   (mean p_max {:.6})", COUNT as f64 / seconds, sum / COUNT as f64);
    }
    Ok(())
}
