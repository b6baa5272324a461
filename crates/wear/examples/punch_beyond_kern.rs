//! A punch pressed beyond its kern: part of the face lifts, the rest carries the load; for b = 1 the classical no-tension triangle of
//! length 3 (c - e). At the edge there is no answer, and the program says so.

use nalgebra::Vector3;
use wear::{Optimum, Problem, RigidMode, Shape, SlidingMotion, Surface, WearError, WearLaw, optimal_pressure};

/// Steady state of a punch 60 mm long and 10 mm thick under 1 kN at `eccentricity` mm.
pub(crate) fn punch(b: f64, eccentricity: f64) -> Result<Optimum, WearError> {
    let strip = Shape::Strip { x: [-30.0, 30.0], z: 0.0, thickness: 10.0 };
    let surface = Surface::new(strip, SlidingMotion::along_x(5.0))?;
    let modes = vec![RigidMode::press_down(1e3), RigidMode::tilt(1e3 * eccentricity, Vector3::zeros())];
    optimal_pressure(&Problem::new(surface, WearLaw::from_beta(2e-4, 0.25, 1.0, b), modes))
}

pub(crate) fn main() -> Result<(), WearError> {
    println!("{:>5} {:>6} {:>16} {:>10} {:>10}", "b", "e/mm", "regime", "p_max/MPa", "area/mm^2");
    for b in [1.0, 2.0] {
        for eccentricity in [5.0, 10.0, 20.0, 29.0, 30.0] {
            match punch(b, eccentricity) {
                Ok(answer) => {
                    let area: f64 = answer.points.iter().map(|point| point.weight).sum();
                    let regime = format!("{:?}", answer.regime);
                    println!("{b:>5} {eccentricity:>6} {regime:>16} {:>10.4} {area:>10.2}", answer.p_max);
                }
                Err(error) => println!("{b:>5} {eccentricity:>6}   {error}"),
            }
        }
    }
    Ok(())
}
