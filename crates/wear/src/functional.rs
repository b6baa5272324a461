//! The functionals (11)-(13) and their exponents.
//!
//! J = sum_i (int X_i^q dS)^(1/q) with X_i = w_i' (wear volume), mu p v (friction power), p w_i' (wear power). In terms of
//! e = b, 1, b + 1 the exponent that matters is s = e q, with k = 1/(s - 1); s - 1 is computed with one rounding.

/// What is made stationary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Functional {
    /// W^(q), equation (11).
    WearVolume,
    /// D_F^(q), equation (12).
    FrictionPower,
    /// D_w^(q), equation (13).
    WearPower,
    /// Uniform pressure (no functional of the paper; the minimum of the largest pressure).
    Uniform,
    /// The steady state of wear: sum_i w_i' is a rigid motion; q is not used.
    Steady,
}

impl Functional {
    /// Power e of the pressure in X for a body with pressure exponent b.
    pub fn pressure_power(&self, b: f64) -> f64 {
        match self {
            Self::WearVolume => b,
            Self::FrictionPower | Self::Uniform => 1.0,
            Self::WearPower | Self::Steady => b + 1.0,
        }
    }

    /// Field word, as in scenes and summaries.
    pub fn word(&self) -> &'static str {
        match self {
            Self::WearVolume => "wear-volume",
            Self::FrictionPower => "friction-power",
            Self::WearPower => "wear-power",
            Self::Uniform => "uniform",
            Self::Steady => "steady",
        }
    }

    /// s - 1 for a body with pressure exponent b, rounded once: (b + 1) q - 1 by fma with the rounding of b + 1 put back.
    pub fn s_minus_1(&self, b: f64, q: f64) -> f64 {
        match self {
            Self::WearVolume => b.mul_add(q, -1.0),
            Self::FrictionPower => q - 1.0,
            Self::WearPower => {
                if q.is_infinite() {
                    return q;
                }
                let e = b + 1.0;
                // Error of the sum, by Knuth's two-sum: b + 1 = e + error exactly.
                let back = e - 1.0;
                let error = (b - back) + (1.0 - (e - back));
                e.mul_add(q, -1.0) + error * q
            }
            Self::Steady => b,
            Self::Uniform => f64::INFINITY,
        }
    }
}
