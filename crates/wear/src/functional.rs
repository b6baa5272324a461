//! The functionals (11)-(13), their exponents and their words: one table.
//!
//! J = sum_i (int X_i^q dS)^(1/q) with X_i = w_i' (wear volume), mu p v (friction power), p w_i' (wear power). In terms of
//! e = b, 1, b + 1 the exponent that matters is s = e q, with k = 1/(s - 1); s - 1 is computed with one rounding.

use crate::own_functional::OwnFunctional;

/// What is made stationary.
#[derive(Clone, Debug, PartialEq)]
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
    /// int X dS of a density X of one's own; q is not used.
    Own(OwnFunctional),
}

/// A row of the table of functionals: everything about one that is a word or a number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct FunctionalRow {
    /// Field word, as in scenes and summaries.
    pub word: &'static str,
    /// `[c, d]` of the power e = c b + d of the pressure in X, b being the pressure exponent of the wear rule; NaN where X is no power.
    pub exponents: [f64; 2],
    /// What has to be given for it.
    pub needs: Needs,
    /// Its pressure as the subject of a sentence.
    pub sentence: &'static str,
}

/// What a functional depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Needs {
    /// The exponent q.
    pub q: bool,
    /// A choice between kinematic and associated modes.
    pub modes: bool,
    /// A wear rule.
    pub wear: bool,
}

const WEAR_VOLUME: FunctionalRow = FunctionalRow {
    word: "wear-volume",
    exponents: [1.0, 0.0],
    needs: Needs { q: true, modes: true, wear: true },
    sentence: "The pressure that makes the wear volume rate stationary",
};

const FRICTION_POWER: FunctionalRow = FunctionalRow {
    word: "friction-power",
    exponents: [0.0, 1.0],
    needs: Needs { q: true, modes: true, wear: false },
    sentence: "The pressure that makes the friction power stationary",
};

const WEAR_POWER: FunctionalRow = FunctionalRow {
    word: "wear-power",
    exponents: [1.0, 1.0],
    needs: Needs { q: true, modes: true, wear: true },
    sentence: "The pressure that makes the wear power stationary",
};

const UNIFORM: FunctionalRow = FunctionalRow {
    word: "uniform",
    exponents: [0.0, 1.0],
    needs: Needs { q: false, modes: false, wear: false },
    sentence: "The uniform pressure",
};

const STEADY: FunctionalRow = FunctionalRow {
    word: "steady",
    exponents: [1.0, 1.0],
    needs: Needs { q: false, modes: true, wear: true },
    sentence: "The worn-in pressure",
};

const OWN: FunctionalRow = FunctionalRow {
    word: "own",
    exponents: [f64::NAN, f64::NAN],
    needs: Needs { q: false, modes: true, wear: false },
    sentence: "The pressure that makes the functional given as a function stationary",
};

impl Functional {
    /// The functionals of the theory, in the order of their equations.
    pub const ALL: [Functional; 5] =
        [Functional::WearVolume, Functional::FrictionPower, Functional::WearPower, Functional::Uniform, Functional::Steady];

    /// Its row of the table.
    pub fn row(&self) -> &'static FunctionalRow {
        match self {
            Self::WearVolume => &WEAR_VOLUME,
            Self::FrictionPower => &FRICTION_POWER,
            Self::WearPower => &WEAR_POWER,
            Self::Uniform => &UNIFORM,
            Self::Steady => &STEADY,
            Self::Own(_) => &OWN,
        }
    }

    /// Field word, as in scenes and summaries.
    pub fn word(&self) -> &'static str {
        self.row().word
    }

    /// Power e of the pressure in X for a body with pressure exponent b; NaN where X is no power.
    pub fn pressure_power(&self, b: f64) -> f64 {
        let [of_b, constant] = self.row().exponents;
        of_b * b + constant
    }

    /// s - 1 for a body with pressure exponent b, rounded once: e q - 1 by fma with the rounding of e = c b + d put back; b itself for the
    /// steady state, infinite for the uniform pressure, NaN where X is no power.
    pub fn s_minus_1(&self, b: f64, q: f64) -> f64 {
        match self {
            Self::WearVolume | Self::FrictionPower | Self::WearPower => {
                if q.is_infinite() {
                    return q;
                }
                let [of_b, constant] = self.row().exponents;
                let (power, e) = (of_b * b, self.pressure_power(b));
                // Error of the sum, by Knuth's two-sum: power + constant = e + error exactly.
                let back = e - constant;
                let error = (power - back) + (constant - (e - back));
                e.mul_add(q, -1.0) + error * q
            }
            Self::Steady => b,
            Self::Uniform => f64::INFINITY,
            Self::Own(_) => f64::NAN,
        }
    }
}
