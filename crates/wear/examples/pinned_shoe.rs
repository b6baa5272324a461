//! Pinned long shoe of a drum brake (Shigley, example 16-2): the textbook's p ~ sin(theta) follows from Archard's rule in the steady
//! state and becomes sin(theta)^(1/b) for other rules.

use nalgebra::Vector3;
use wear::{Optimum, Problem, RigidMode, RigidMotion, Shape, SlidingMotion, Surface, WearError, WearLaw, optimal_pressure};

/// Steady state of an internal shoe on a drum of radius 150 mm, pin 122.654 mm from the centre, lining 0-126 degrees from the pin, 32 mm
/// wide, mu = 0.32, actuated by a moment about the pin. Positive omega: leading shoe.
pub(crate) fn shoe(omega: f64, b: f64, moment: f64) -> Result<Optimum, WearError> {
    let arc = Shape::Arc {
        radius: 150.0,
        centre: Vector3::zeros(),
        angles: [0.0, 126_f64.to_radians()],
        thickness: 32.0,
        internal: true,
    };
    let surface = Surface::new(arc, SlidingMotion::in_plane(omega, Vector3::zeros()))?;
    let about_pin = RigidMotion::Rotation { axis: -Vector3::y(), about: Vector3::new(0.0, 0.0, 122.654) };
    let modes = vec![RigidMode { motion: about_pin, resultant: moment }];
    let law = WearLaw::from_beta(1e-9, 0.32, 1.0, b);
    optimal_pressure(&Problem { friction: 0.32, ..Problem::new(surface, law, modes) })
}

pub(crate) fn main() -> Result<(), WearError> {
    let moment = 2279.1 * 212.0;
    println!("pinned shoe, actuating force 2.2791 kN at 212 mm from the pin");
    println!("{:>9} {:>5} {:>10} {:>12}", "shoe", "b", "p_max/MPa", "torque/N m");
    for b in [1.0, 0.5, 2.0] {
        for (name, omega) in [("leading", 10.0), ("trailing", -10.0)] {
            let optimum = shoe(omega, b, moment)?;
            println!("{name:>9} {b:>5} {:>10.4} {:>12.2}", optimum.p_max, optimum.torque.unwrap_or(f64::NAN) * 1e-3);
        }
    }
    Ok(())
}
