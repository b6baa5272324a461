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

/// The rules of the two bodies in contact: body 1 is shaped (shoe, punch), body 2 the counter-face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WearPair {
    /// Rules of body 1 and body 2.
    pub laws: [WearLaw; 2],
    /// False when the friction coefficient is zero while the factors are beta: the bodies do not wear, `laws` then only
    /// weigh the bodies against each other, and rates, powers, multipliers and feed are reported as zero.
    pub active: bool,
    /// True when the factors are beta mu^b and so change with the friction coefficient (for sensitivities).
    pub friction_driven: bool,
}

impl WearLaw {
    /// Rule with factor beta~ = beta mu^b, equation (4).
    pub fn from_beta(beta: f64, friction: f64, speed_exponent: f64, pressure_exponent: f64) -> Self {
        Self { factor: beta * friction.powf(pressure_exponent), speed_exponent, pressure_exponent }
    }

    /// A body that does not wear.
    pub const NONE: Self = Self { factor: 0.0, speed_exponent: 1.0, pressure_exponent: 1.0 };

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

impl WearPair {
    /// Rules with factors k (Archard, no friction coefficient in them): w_i' = k_i p^{b_i} v^{a_i}.
    pub fn archard(k: [f64; 2], speed_exponent: [f64; 2], pressure_exponent: [f64; 2]) -> Self {
        let law = |i: usize| WearLaw { factor: k[i], speed_exponent: speed_exponent[i], pressure_exponent: pressure_exponent[i] };
        Self { laws: [law(0), law(1)], active: true, friction_driven: false }
    }

    /// Rules with factors beta_i mu^{b_i}, equation (4).
    ///
    /// With mu = 0 nothing wears; the pressure is still defined as the limit mu -> 0 when one body wears or b1 = b2 (it does not
    /// depend on the factor), and the pair is then returned with `active = false`. Two wearing bodies with b1 != b2 and mu = 0
    /// are refused: the ratio of the factors has no limit; give Archard's k instead.
    pub fn from_beta(
        beta: [f64; 2],
        friction: f64,
        speed_exponent: [f64; 2],
        pressure_exponent: [f64; 2],
    ) -> Result<Self, WearError> {
        if friction != 0.0 {
            let law = |i: usize| WearLaw::from_beta(beta[i], friction, speed_exponent[i], pressure_exponent[i]);
            return Ok(Self { laws: [law(0), law(1)], active: true, friction_driven: true });
        }
        if beta[0] > 0.0 && beta[1] > 0.0 && pressure_exponent[0] != pressure_exponent[1] {
            return Err(WearError::NoWear {
                functional: "a wear functional",
                remedy: "with mu = 0 and b1 != b2 give Archard's factors k instead of beta",
            });
        }
        Ok(Self { active: false, friction_driven: true, ..Self::archard(beta, speed_exponent, pressure_exponent) })
    }

    /// True when the law of body `i` takes away material.
    pub fn wears(&self, i: usize) -> bool {
        self.active && self.laws[i].factor > 0.0
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
