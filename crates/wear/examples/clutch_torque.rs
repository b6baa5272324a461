//! Torque of a worn-in disc clutch: between the textbook's uniform pressure (new) and uniform wear (worn in), for any wear exponents.
//!
//! r_eff = int r^(2 - a/b) dr / int r^(1 - a/b) dr; a = b gives (r_i + r_e)/2, a = 0 the uniform pressure.

use wear::{Functional, Problem, RigidMode, Shape, SlidingMotion, Surface, WearError, WearLaw, optimal_pressure};

/// Effective radius in mm of a ring 20-120 mm, new and worn in, for speed exponent a and pressure exponent b.
pub(crate) fn effective_radii(a: f64, b: f64) -> Result<[f64; 2], WearError> {
    let ring = Surface::new(Shape::Annulus { radii: [20.0, 120.0] }, SlidingMotion::about_z(100.0))?;
    let worn =
        Problem { friction: 0.25, ..Problem::new(ring, WearLaw::from_beta(2e-8, 0.25, a, b), vec![RigidMode::press_down(5e3)]) };
    let new = Problem { functional: Functional::Uniform, ..worn.clone() };
    let radius =
        |problem: &Problem| -> Result<f64, WearError> { Ok(optimal_pressure(problem)?.effective_radius.unwrap_or(f64::NAN)) };
    Ok([radius(&new)?, radius(&worn)?])
}

pub(crate) fn main() -> Result<(), WearError> {
    println!("clutch ring 20-120 mm, mu = 0.25, F = 5 kN");
    println!("{:>5} {:>5} {:>14} {:>14} {:>12}", "a", "b", "r_eff new/mm", "r_eff worn/mm", "torque/N m");
    for (a, b) in [(1.0, 1.0), (1.0, 2.0), (1.0, 0.7), (0.0, 1.0)] {
        let [new, worn] = effective_radii(a, b)?;
        println!("{a:>5} {b:>5} {new:>14.3} {worn:>14.3} {:>12.3}", 0.25 * 5e3 * worn * 1e-3);
    }
    Ok(())
}
