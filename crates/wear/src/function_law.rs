//! Wear rules that are functions of the pressure with a few numbers: one variant each. Inverse, potential and the steady state follow from rate and slope.

use crate::OwnRule;

/// Wear by distance W(p) (mm of depth by mm of sliding) as a function of the pressure; its rule is `w' = W(p) v`. W is zero at no pressure and grows from
/// there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FunctionLaw {
    /// Mild wear `k p` up to a pressure p1, and a steeper straight line `k p1 + k1 (p - p1)` above it, as where a film breaks down.
    Severe {
        /// Factor k of mild wear, mm^2/N.
        mild: f64,
        /// Pressure p1 at which wear turns severe, MPa.
        above: f64,
        /// Factor k1 of the pressure beyond it, mm^2/N.
        severe: f64,
    },
    /// `k p / (1 + p / ps)`: asperities that are pressed flat wear ever less for each further pressure. Rates stay below `k ps`.
    Saturating {
        /// Factor k of small pressures, mm^2/N.
        k: f64,
        /// Pressure ps at which the factor is half of that, MPa.
        half: f64,
    },
}

impl FunctionLaw {
    /// What the rule is, in words.
    fn word(self) -> &'static str {
        match self {
            FunctionLaw::Severe { .. } => "mild and severe",
            FunctionLaw::Saturating { .. } => "saturating",
        }
    }

    /// Wear by distance (mm/mm) at a pressure of 0 or more, and its slope (1/MPa); at a kink that from above.
    pub fn at(self, p: f64) -> [f64; 2] {
        match self {
            FunctionLaw::Severe { mild, above, .. } if p < above => [mild * p, mild],
            FunctionLaw::Severe { mild, above, severe } => [mild * above + severe * (p - above), severe],
            FunctionLaw::Saturating { k, half } => [k * p / (1.0 + p / half), k / ((1.0 + p / half) * (1.0 + p / half))],
        }
    }

    /// Its numbers by the names that scenes have for them.
    pub fn numbers(self) -> Vec<(&'static str, f64)> {
        match self {
            FunctionLaw::Severe { mild, above, severe } => vec![("mild", mild), ("above", above), ("severe", severe)],
            FunctionLaw::Saturating { k, half } => vec![("k", k), ("half", half)],
        }
    }

    /// The name of a number with which W does not grow everywhere, and what it must be: all are greater than 0 and finite.
    pub fn wrong(self) -> Option<(&'static str, f64, &'static str)> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let numbers = self.numbers();
        numbers.into_iter().find(|(_, value)| !positive(*value)).map(|(name, value)| (name, value, "greater than 0"))
    }
}

impl From<FunctionLaw> for OwnRule {
    fn from(law: FunctionLaw) -> OwnRule {
        let numbers = law.numbers().into_iter().map(|(_, value)| value).collect();
        let rate = move |pressure, sliding_speed| law.at(pressure).map(|value| value * sliding_speed);
        let mut rule = OwnRule::named(law.word(), numbers, rate);
        rule.bends = match law {
            FunctionLaw::Severe { above, .. } => vec![above],
            FunctionLaw::Saturating { .. } => Vec::new(),
        };
        rule.wrong = law.wrong();
        rule
    }
}
