//! A wear law of one's own: a rate that saturates, w' = k v p/(1 + p/p0), as where the surfaces run out of asperities. The worn-in pressure of a
//! punch under a load off its middle is known in closed form for it.
//!
//! In the steady state w' = V_0 + V_1 x on -c < x < c, so that with f = a + b x = (V_0 + V_1 x)/(k v) < p0
//!
//! ```text
//! p = f/(1 - f/p0),    F = t p0 (p0 L - 2c),    M = t p0^2 ((p0 - a) L - 2c)/b,    L = int dx/(p0 - f)
//! ```
//!
//! instead of Archard's straight line p = f: where the rate can hardly grow, the pressure has to.

use nalgebra::Vector3;
use wear::{Optimum, OwnRule, Problem, RigidMode, Shape, SlidingMotion, Surface, WearError, optimal_pressure};

/// k in mm^2/N, p0 in MPa.
pub(crate) const LAW: [f64; 2] = [1e-6, 6.0];
/// Half length and thickness of the punch in mm, sliding speed in mm/s.
const PUNCH: [f64; 3] = [30.0, 10.0, 5.0];

/// `[w', dw'/dp]`: all that a law of one's own has to say.
fn saturating(pressure: f64, sliding_speed: f64) -> [f64; 2] {
    let [k, p0] = LAW;
    let damping = 1.0 + pressure / p0;
    [k * sliding_speed * pressure / damping, k * sliding_speed / (damping * damping)]
}

/// The pressure p0 f/(p0 - f) for f = a + b x, and the force (N) and moment (N mm) it carries, integrated in closed form.
pub(crate) struct Exact {
    /// `[a, b]` in MPa and MPa/mm.
    pub f: [f64; 2],
}

impl Exact {
    /// Pressure at x.
    pub(crate) fn pressure(&self, x: f64) -> f64 {
        let f = self.f[0] + self.f[1] * x;
        LAW[1] * f / (LAW[1] - f)
    }

    /// `[F, M]`, with p = p0 (p0/(p0 - f) - 1) and L = int dx/(p0 - f).
    pub(crate) fn load(&self) -> [f64; 2] {
        let ([a, b], [c, thickness, _], p0) = (self.f, PUNCH, LAW[1]);
        let log = ((p0 - a + b * c) / (p0 - a - b * c)).ln() / b;
        let first = ((p0 - a) * log - 2.0 * c) / b;
        [thickness * p0 * (p0 * log - 2.0 * c), thickness * p0 * p0 * first]
    }
}

/// Steady state of the punch under a force and a moment.
pub(crate) fn punch([force, moment]: [f64; 2]) -> Result<Optimum, WearError> {
    let [c, thickness, speed] = PUNCH;
    let strip = Surface::new(Shape::Strip { x: [-c, c], z: 0.0, thickness }, SlidingMotion::along_x(speed))?;
    let modes = vec![RigidMode::press_down(force), RigidMode::tilt(moment, Vector3::zeros())];
    optimal_pressure(&Problem::new(strip, OwnRule::new(saturating), modes))
}

pub(crate) fn main() -> Result<(), WearError> {
    let exact = Exact { f: [2.0, 0.04] };
    let load = exact.load();
    let optimum = punch(load)?;
    println!("punch under {:.3} N at {:.4} mm from its middle", load[0], load[1] / load[0]);
    println!("{:>6} {:>12} {:>12}", "x/mm", "p/MPa", "exact/MPa");
    for x in [-30.0, -15.0, 0.0, 15.0, 30.0] {
        let point = wear::SurfacePoint { position: Vector3::new(x, 0.0, 0.0), sliding_speed: PUNCH[2], ..optimum.points[0] };
        let (found, expected) = (optimum.pressure_at(&point), exact.pressure(x));
        println!("{x:>6} {found:>12.6} {expected:>12.6}");
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} at {x} and not {expected}");
    }
    let feed = optimum.feed.as_ref().map_or(f64::NAN, |feed| feed[0]);
    println!("feed {feed:.6e} mm/s, largest pressure {:.6} MPa", optimum.p_max);
    assert!((feed / (LAW[0] * PUNCH[2] * exact.f[0]) - 1.0).abs() < 1e-9);
    Ok(())
}
