//! The rate at which wear opens the gap, and its implicit inverse.

use wear::{Counterface, WearPair};

/// `w_i' = c_1 p^b1` of body 1 plus what body 2 adds to the gap, at every point.
pub(crate) struct GapRate {
    /// `beta~ v^a` of each body at the points.
    factors: [Vec<f64>; 2],
    exponents: [f64; 2],
    counterface: Counterface,
    /// Weight over track area.
    share: Vec<f64>,
}

impl GapRate {
    pub(crate) fn new(wear: &WearPair, counterface: Counterface, speeds: &[f64], weights: &[f64], track: Option<f64>) -> GapRate {
        let factors = wear.laws.map(|law| {
            let active = if wear.active { law.factor } else { 0.0 };
            speeds.iter().map(|v| if active == 0.0 { 0.0 } else { active * v.powf(law.speed_exponent) }).collect()
        });
        let track = track.unwrap_or(f64::INFINITY);
        GapRate {
            factors,
            exponents: wear.laws.map(|law| law.pressure_exponent),
            counterface,
            share: weights.iter().map(|w| w / track).collect(),
        }
    }

    /// Wear rate of a body at a point.
    pub(crate) fn wear(&self, body: usize, i: usize, pressure: f64) -> f64 {
        let c = self.factors[body][i];
        if c == 0.0 || pressure <= 0.0 { 0.0 } else { c * pressure.powf(self.exponents[body]) }
    }

    fn wear_slope(&self, body: usize, i: usize, pressure: f64) -> f64 {
        let (c, b) = (self.factors[body][i], self.exponents[body]);
        if c == 0.0 { 0.0 } else { c * b * pressure.max(0.0).powf(b - 1.0) }
    }

    /// Whether body 2's wear at a point opens the gap there.
    fn adds(&self) -> bool {
        self.counterface == Counterface::Congruent
    }

    /// Part of the gap rate that depends on the pressure at the point alone.
    pub(crate) fn local(&self, i: usize, pressure: f64) -> f64 {
        self.wear(0, i, pressure) + if self.adds() { self.wear(1, i, pressure) } else { 0.0 }
    }

    /// `d local / dp`.
    pub(crate) fn local_slope(&self, i: usize, pressure: f64) -> f64 {
        self.wear_slope(0, i, pressure) + if self.adds() { self.wear_slope(1, i, pressure) } else { 0.0 }
    }

    /// Whether body 2 recedes as a whole.
    pub(crate) fn recedes(&self) -> bool {
        self.counterface == Counterface::Revolving && self.factors[1].iter().any(|c| *c > 0.0)
    }

    /// Mean wear rate of body 2 along its closed track.
    pub(crate) fn recession(&self, pressure: &[f64]) -> f64 {
        if !self.recedes() {
            return 0.0;
        }
        pressure.iter().enumerate().map(|(i, p)| self.share[i] * self.wear(1, i, *p)).sum()
    }

    /// `d recession / dp_i`.
    pub(crate) fn recession_slope(&self, i: usize, pressure: f64) -> f64 {
        if self.recedes() { self.share[i] * self.wear_slope(1, i, pressure) } else { 0.0 }
    }

    /// Gap rate at all points.
    pub(crate) fn total(&self, pressure: &[f64]) -> Vec<f64> {
        let recession = self.recession(pressure);
        pressure.iter().enumerate().map(|(i, p)| self.local(i, *p) + recession).collect()
    }

    /// Density of `Phi` at a point.
    pub(crate) fn potential(&self, i: usize, pressure: f64) -> f64 {
        let of = |body: usize| self.wear(body, i, pressure) * pressure / (self.exponents[body] + 1.0);
        of(0) + if self.counterface == Counterface::Fresh { 0.0 } else { of(1) }
    }

    /// Whether every rate is proportional to the pressure.
    pub(crate) fn is_linear(&self) -> bool {
        (0..2).all(|body| self.exponents[body] == 1.0 || self.factors[body].iter().all(|c| *c == 0.0))
    }

    /// The pressure `p` with `stiffness p + step local(p) = u > 0`, and `dp/du`: Newton's method on logarithms, convex and increasing,
    /// from above.
    pub(crate) fn inverse(&self, i: usize, stiffness: f64, step: f64, u: f64) -> (f64, f64) {
        let second = if self.adds() { step * self.factors[1][i] } else { 0.0 };
        let terms = [(stiffness, 1.0), (step * self.factors[0][i], self.exponents[0]), (second, self.exponents[1])];
        let terms = || terms.iter().filter(|t| t.0 > 0.0);
        if terms().all(|t| t.1 == 1.0) {
            let sum: f64 = terms().map(|t| t.0).sum();
            return (u / sum, 1.0 / sum);
        }
        let target = u.ln();
        let mut x = terms().map(|(c, e)| (target - c.ln()) / e).fold(f64::INFINITY, f64::min);
        let (mut value, mut slope) = (0.0, 1.0);
        for _ in 0..60 {
            (value, slope) = (0.0, 0.0);
            for (c, e) in terms() {
                let term = c * (e * x).exp();
                value += term;
                slope += e * term;
            }
            let change = (value.ln() - target) * value / slope;
            x -= change;
            if change.abs() <= 4.0 * f64::EPSILON * (1.0 + x.abs()) {
                break;
            }
        }
        let p = x.exp();
        let slope = if value > 0.0 { slope } else { 1.0 };
        (p, p / slope)
    }
}
