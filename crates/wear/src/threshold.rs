//! The wear rule with a threshold pressure: w' = beta~ (p - p0)^b v^a above p0, nothing up to it.
//!
//! Up to a threshold the asperities give way elastically and nothing is taken off; beyond it wear goes with the excess. Powers of the rate are
//! convex functionals from q b = 1 on ("Under a threshold" in README).

use crate::log_sum::log_sum;
use crate::{WearError, WearLaw};

/// Wear rule of one body with a threshold: the power law of the excess `p - p0` where that is positive, else no wear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThresholdLaw {
    /// The power law, of the excess in place of the pressure.
    pub law: WearLaw,
    /// Threshold p0 > 0 in MPa.
    pub threshold: f64,
}

impl ThresholdLaw {
    pub(crate) fn check(&self) -> Result<(), WearError> {
        if !(self.threshold > 0.0 && self.threshold.is_finite()) {
            return Err(WearError::OutOfRange { name: "threshold pressure", value: self.threshold, wanted: "> 0 and finite" });
        }
        self.law.check()
    }

    /// log p at the wear rate exp(log_rate), `p = p0 + (w' / (beta~ v^a))^(1/b)`, and d log p / d log w'.
    pub(crate) fn pressure_of(&self, log_rate: f64, sliding_speed: f64) -> (f64, f64) {
        let power = 1.0 / self.law.pressure_exponent;
        let log_excess = power * (log_rate - self.law.local_factor(sliding_speed).ln());
        let log_pressure = log_sum([self.threshold.ln(), log_excess]);
        (log_pressure, power * (log_excess - log_pressure).exp())
    }

    /// `log dX/dp` and `p X''/X'` of `X = (p^d w')^q`; -inf and NaN up to the threshold.
    pub(crate) fn stationarity(&self, [d, q]: [f64; 2], pressure: f64, sliding_speed: f64) -> (f64, f64) {
        let excess = pressure - self.threshold;
        if excess <= 0.0 {
            return (f64::NEG_INFINITY, f64::NAN);
        }
        let (b, log_p) = (self.law.pressure_exponent, pressure.ln());
        let log_term = d * log_p + self.law.local_factor(sliding_speed).ln() + b * excess.ln();
        // First and second derivative of log (p^d w').
        let first = d / pressure + b / excess;
        let second = -d / (pressure * pressure) - b / (excess * excess);
        (q.ln() + q * log_term + first.ln(), pressure * (q * first + second / first))
    }
}
