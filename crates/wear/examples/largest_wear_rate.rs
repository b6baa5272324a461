//! A functional of one's own: the largest wear rate. No smooth density is a maximum, but `X = (w'/w0)^q` comes near it as q grows, and its limit is known:
//! where the load lets it, the pressure that makes the wear rate the same everywhere; on a ring `p ~ r^(-a/b)`.
//!
//! Why that is the least largest rate: with the rate the same everywhere, another pressure of the same force is higher somewhere, and wears faster there.

use wear::{
    Functional, Optimum, OwnFunctional, Problem, RigidMode, Shape, SlidingMotion, Surface, WearError, WearLaw, optimal_pressure,
};

const LAW: WearLaw = WearLaw { factor: 1e-8, speed_exponent: 1.2, pressure_exponent: 0.8 };
/// A rate (mm/s) near those of this clutch, so that powers of the ratio are numbers.
const USUAL: f64 = 1e-5;

/// `[X, dX/dp, d2X/dp2]` of `X = (w'/w0)^q`, a power `e = b q` of the pressure.
fn density(q: f64) -> OwnFunctional {
    let e = LAW.pressure_exponent * q;
    OwnFunctional::new(move |p, v, _| {
        let x = (wear::wear_rate(&LAW, p, v) / USUAL).powf(q);
        [x, e * x / p, e * (e - 1.0) * x / (p * p)]
    })
}

/// The pressure of a clutch ring 20-120 mm under 5 kN that is best for a functional.
pub(crate) fn best(functional: Functional, q: f64) -> Result<Optimum, WearError> {
    let ring = Surface::new(Shape::Annulus { radii: [20.0, 120.0] }, SlidingMotion::about_z(10.0))?;
    let problem = Problem::new(ring, LAW, vec![RigidMode::press_down(5e3)]);
    optimal_pressure(&Problem { functional, q, ..problem })
}

/// Largest over smallest wear rate.
pub(crate) fn spread(optimum: &Optimum) -> f64 {
    let rates = optimum.points.iter().zip(&optimum.pressure).map(|(point, p)| wear::wear_rate(&LAW, *p, point.sliding_speed));
    let [low, high] = rates.fold([f64::INFINITY, 0.0_f64], |[low, high], rate| [low.min(rate), high.max(rate)]);
    high / low
}

/// Largest wear rate in mm/s.
pub(crate) fn largest(optimum: &Optimum) -> f64 {
    let rates = optimum.points.iter().zip(&optimum.pressure).map(|(point, p)| wear::wear_rate(&LAW, *p, point.sliding_speed));
    rates.fold(0.0, f64::max)
}

pub(crate) fn main() -> Result<(), WearError> {
    println!("{:>5} {:>24} {:>18}", "q", "largest rate/(um/h)", "over the smallest");
    for q in [2.0, 8.0, 32.0] {
        let optimum = best(Functional::Own(density(q)), 1.0)?;
        println!("{q:>5} {:>24.6} {:>18.4}", 3.6e6 * largest(&optimum), spread(&optimum));
    }
    // The limit itself is the wear volume with q = inf, whose sum is a maximum.
    let limit = best(Functional::WearVolume, f64::INFINITY)?;
    println!("{:>5} {:>24.6} {:>18.4}", "inf", 3.6e6 * largest(&limit), spread(&limit));
    Ok(())
}
