//! How the counter-face passes under body 1, and how deep it wears.

use crate::{Optimum, SurfacePoint, WearLaw, wear_rate};

/// The way body 2's points pass through the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counterface {
    /// Long fresh plate under a translating punch: its profile is stationary in the punch frame and drops out of the gap rate.
    Fresh,
    /// Ring on ring: each point of body 2 always meets the same pressure; the wear rates add.
    Congruent,
    /// Drum under a shoe, disc under a pad: body 2 recedes uniformly along its closed track by the mean of its wear over a turn.
    Revolving,
}

/// Depth (mm) by which one pass under a translating punch wears a fresh plate, equation (41): w2 = int w2'/v dx, the integral over
/// the length of the punch; `thickness` (mm) turns the area weights of the points into lengths.
pub fn counterface_depth(optimum: &Optimum, law: &WearLaw, thickness: f64) -> f64 {
    let rate = |(point, pressure): (&SurfacePoint, &f64)| {
        point.weight * wear_rate(law, *pressure, point.sliding_speed) / (point.sliding_speed * thickness)
    };
    optimum.points.iter().zip(&optimum.pressure).map(rate).sum()
}

/// The same depth from the feed V_F of the punch, equation (43a) with the corrected multiplier V_F = lambda_F/(b+1):
/// w2 = bt2 v^a2 / (bt1 v^a1 + bt2 v^a2) (L/v) V_F, valid for b1 = b2 and q = 1, where V_F is the multiplier with both bodies in it.
pub fn counterface_depth_from_feed(laws: &[WearLaw; 2], speed: f64, length: f64, feed: f64) -> f64 {
    let rates = laws.map(|law| law.factor * speed.powf(law.speed_exponent));
    rates[1] / (rates[0] + rates[1]) * length / speed * feed
}
