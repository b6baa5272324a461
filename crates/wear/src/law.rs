//! The wear rule (4): w' = beta~ p^b v^a, a free function of pressure and sliding speed.
//!
//! Source: Paczelt and Mroz (2007), equation (4): w_i' = beta_i (tau_n)^{b_i} v^{a_i} = beta~_i p^{b_i} v^{a_i} with
//! beta~_i = beta_i mu^{b_i}. Archard's rule is a = b = 1 with beta~ = k.

use crate::WearError;

/// Wear rule of one body, w' = factor p^b v^a (mm/s, with p in MPa and v in mm/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WearLaw {
    /// beta~ = beta mu^b, or Archard's k. Zero: this body does not wear.
    pub factor: f64,
    /// Exponent a of the sliding speed.
    pub speed_exponent: f64,
    /// Exponent b > 0 of the pressure.
    pub pressure_exponent: f64,
}

impl WearLaw {
    /// Rule with factor beta~ = beta mu^b, equation (4).
    pub fn from_beta(beta: f64, friction: f64, speed_exponent: f64, pressure_exponent: f64) -> Self {
        Self { factor: beta * friction.powf(pressure_exponent), speed_exponent, pressure_exponent }
    }

    /// A body that does not wear.
    pub const NONE: Self = Self { factor: 0.0, speed_exponent: 1.0, pressure_exponent: 1.0 };

    /// beta~ v^a.
    pub(crate) fn local_factor(&self, sliding_speed: f64) -> f64 {
        if self.factor == 0.0 { 0.0 } else { self.factor * sliding_speed.powf(self.speed_exponent) }
    }

    pub(crate) fn check(&self) -> Result<(), WearError> {
        if !(self.factor >= 0.0 && self.factor.is_finite()) {
            return Err(WearError::OutOfRange { name: "wear factor", value: self.factor, wanted: ">= 0 and finite" });
        }
        if !(self.pressure_exponent > 0.0 && self.pressure_exponent.is_finite()) {
            let value = self.pressure_exponent;
            return Err(WearError::OutOfRange { name: "pressure exponent b", value, wanted: "> 0 and finite" });
        }
        if !self.speed_exponent.is_finite() {
            let value = self.speed_exponent;
            return Err(WearError::OutOfRange { name: "speed exponent a", value, wanted: "finite" });
        }
        Ok(())
    }
}

/// Wear rate w' = beta~ p^b v^a in mm/s, equation (4). Zero pressure gives zero.
pub fn wear_rate(law: &WearLaw, pressure: f64, sliding_speed: f64) -> f64 {
    if law.factor == 0.0 || pressure <= 0.0 {
        return 0.0;
    }
    law.factor * pressure.powf(law.pressure_exponent) * sliding_speed.powf(law.speed_exponent)
}

/// Logarithm of the wear rate, log beta~ + b log p + a log v: usable where w' itself overflows. -inf when nothing wears.
pub(crate) fn log_wear_rate(law: &WearLaw, log_pressure: f64, log_speed: f64) -> f64 {
    if law.factor == 0.0 || log_pressure == f64::NEG_INFINITY {
        return f64::NEG_INFINITY;
    }
    let speed = if law.speed_exponent == 0.0 { 0.0 } else { law.speed_exponent * log_speed };
    law.factor.ln() + law.pressure_exponent * log_pressure + speed
}
