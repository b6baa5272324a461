//! The wear rules of the two bodies in contact.

use crate::condition::bends;
use crate::rule::Rule;
use crate::threshold::ThresholdLaw;
use crate::{WearError, WearLaw};

/// The rules of the two bodies in contact: body 1 is shaped (shoe, punch), body 2 the counter-face.
#[derive(Clone, Debug, PartialEq)]
pub struct WearPair {
    /// Rules of body 1 and body 2.
    pub rules: [Rule; 2],
    /// False when the friction coefficient is zero while the factors are beta: the bodies do not wear, `rules` then only
    /// weigh the bodies against each other, and rates, powers, multipliers and feed are reported as zero.
    pub active: bool,
    /// True when the factors are beta mu^b and so change with the friction coefficient (for sensitivities).
    pub friction_driven: bool,
}

impl WearPair {
    /// Body 1 wears by a rule, body 2 does not.
    pub fn alone(rule: impl Into<Rule>) -> Self {
        Self { rules: [rule.into(), Rule::NONE], active: true, friction_driven: false }
    }

    /// Rules with factors k (Archard, no friction coefficient in them): w_i' = k_i p^{b_i} v^{a_i}.
    pub fn archard(k: [f64; 2], speed_exponent: [f64; 2], pressure_exponent: [f64; 2]) -> Self {
        let law = |i: usize| WearLaw { factor: k[i], speed_exponent: speed_exponent[i], pressure_exponent: pressure_exponent[i] };
        Self { rules: [law(0).into(), law(1).into()], active: true, friction_driven: false }
    }

    /// Rules with factors beta_i mu^{b_i}, equation (4).
    ///
    /// With mu = 0 nothing wears; the pressure is still defined as the limit mu -> 0 when one body wears or b1 = b2 (it does not
    /// depend on the factor), and the pair is then returned with `active = false`. Two wearing bodies with b1 != b2 and mu = 0
    /// are refused: the ratio of the factors has no limit; give Archard's k instead.
    ///
    /// # Errors
    /// [`WearError::NoWear`] for two wearing bodies with b1 != b2 and mu = 0.
    pub fn from_beta(
        beta: [f64; 2],
        friction: f64,
        speed_exponent: [f64; 2],
        pressure_exponent: [f64; 2],
    ) -> Result<Self, WearError> {
        if friction != 0.0 {
            let law = |i: usize| WearLaw::from_beta(beta[i], friction, speed_exponent[i], pressure_exponent[i]);
            return Ok(Self { rules: [law(0).into(), law(1).into()], active: true, friction_driven: true });
        }
        if beta[0] > 0.0 && beta[1] > 0.0 && pressure_exponent[0] != pressure_exponent[1] {
            return Err(WearError::NoWear {
                functional: "a wear functional",
                remedy: "with mu = 0 and b1 != b2 give Archard's factors k instead of beta",
            });
        }
        Ok(Self { active: false, friction_driven: true, ..Self::archard(beta, speed_exponent, pressure_exponent) })
    }

    /// The same with threshold pressures (MPa) in the power laws of body 1 and body 2; one of 0 leaves the power law as it is, and
    /// so does one in a law that does not wear. A [`Problem`](crate::Problem) is refused whose thresholds are negative or not finite.
    #[must_use]
    pub fn above(mut self, thresholds: [f64; 2]) -> Self {
        for (rule, threshold) in self.rules.iter_mut().zip(thresholds) {
            if let Rule::Power(law) = *rule
                && threshold != 0.0
                && (law.factor > 0.0 || !(threshold > 0.0 && threshold.is_finite()))
            {
                *rule = Rule::Threshold(ThresholdLaw { law, threshold });
            }
        }
        self
    }

    /// Pressures (MPa) at which the sum of both rates is known to bend: rows of a table, where mild wear turns severe, the threshold of one body where the
    /// other one wears below it. The pressure of a steady state is not smooth where it passes one.
    pub fn bends(&self) -> Vec<f64> {
        bends(&self.rules)
    }

    /// True when the rule of body `i` takes away material.
    pub fn wears(&self, i: usize) -> bool {
        self.active && self.rules[i].wears()
    }

    /// The power laws; another rule counts as one that does not wear.
    pub(crate) fn powers(&self) -> [WearLaw; 2] {
        [0, 1].map(|i| self.rules[i].power().copied().unwrap_or(WearLaw::NONE))
    }

    /// Whether some rule is no power of the pressure.
    pub(crate) fn has_other(&self) -> bool {
        self.rules.iter().any(|rule| rule.power().is_none())
    }
}
