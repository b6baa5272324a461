//! The wear rule of a body: a power law, one with a threshold, or a function of one's own. Rate, slope, inverse and potential of all stand here, and the
//! optimum, the wear in time and the tolerance of a shape take them from here alone.

use crate::invert::{integral, invert};
use crate::own_rule::OwnRule;
use crate::threshold::ThresholdLaw;
use crate::{WearError, WearLaw};

use crate::law::{log_wear_rate, wear_rate};

/// Wear rule of one body: the wear rate w' (mm/s) as a function of pressure (MPa) and sliding speed (mm/s).
#[derive(Clone, Debug, PartialEq)]
pub enum Rule {
    /// w' = beta~ p^b v^a, equation (4).
    Power(WearLaw),
    /// w' = beta~ (p - p0)^b v^a above the threshold p0, else 0.
    Threshold(ThresholdLaw),
    /// A function of one's own.
    Own(OwnRule),
}

impl From<WearLaw> for Rule {
    fn from(law: WearLaw) -> Rule {
        Rule::Power(law)
    }
}

impl From<ThresholdLaw> for Rule {
    fn from(law: ThresholdLaw) -> Rule {
        Rule::Threshold(law)
    }
}

impl From<OwnRule> for Rule {
    fn from(rule: OwnRule) -> Rule {
        Rule::Own(rule)
    }
}

impl Rule {
    /// A body that does not wear.
    pub const NONE: Rule = Rule::Power(WearLaw::NONE);

    /// Wear rate w'(p, v) in mm/s; zero pressure gives zero.
    pub fn rate(&self, pressure: f64, sliding_speed: f64) -> f64 {
        match self {
            Rule::Power(law) => wear_rate(law, pressure, sliding_speed),
            Rule::Threshold(law) => wear_rate(&law.law, pressure - law.threshold, sliding_speed),
            Rule::Own(rule) => rule.rate(pressure, sliding_speed),
        }
    }

    /// Pressures (MPa) at which the slope is known to bend or jump and beyond which the body wears, as the rows of a table: where the pressure along a
    /// surface passes one it is not smooth.
    pub(crate) fn bends(&self) -> &[f64] {
        match self {
            Rule::Power(_) | Rule::Threshold(_) => &[],
            Rule::Own(rule) => &rule.bends,
        }
    }

    /// Slope dw'/dp in mm/(s MPa); at p = 0 from above.
    pub fn slope(&self, pressure: f64, sliding_speed: f64) -> f64 {
        self.at(sliding_speed).slope(pressure)
    }

    /// The pressure (MPa) that wears at a rate (mm/s): zero for rates of 0 and less, infinite for rates that no pressure reaches.
    pub fn inverse(&self, rate: f64, sliding_speed: f64) -> f64 {
        self.at(sliding_speed).inverse(rate)
    }

    /// Potential int_0^p w'(s, v) ds in N/(mm s), beta~ v^a p^(b+1)/(b+1) for the power law; its area integral is the Lyapunov function of the
    /// wear in time.
    pub fn potential(&self, pressure: f64, sliding_speed: f64) -> f64 {
        self.at(sliding_speed).potential(pressure)
    }

    /// The rule at a place, where the sliding speed (mm/s) is known.
    pub fn at(&self, sliding_speed: f64) -> LocalRule {
        match self {
            Rule::Power(law) => LocalRule::Power { factor: law.local_factor(sliding_speed), exponent: law.pressure_exponent },
            Rule::Threshold(ThresholdLaw { law, threshold }) => LocalRule::Threshold {
                factor: law.local_factor(sliding_speed),
                exponent: law.pressure_exponent,
                threshold: *threshold,
            },
            Rule::Own(rule) => LocalRule::Own { rule: rule.clone(), sliding_speed },
        }
    }

    /// Whether the rule takes away material.
    pub fn wears(&self) -> bool {
        match self {
            Rule::Power(law) => law.factor > 0.0,
            Rule::Threshold(law) => law.law.factor > 0.0,
            Rule::Own(_) => true,
        }
    }

    /// The power law; `None` for a rule that is none.
    pub fn power(&self) -> Option<&WearLaw> {
        match self {
            Rule::Power(law) => Some(law),
            Rule::Threshold(_) | Rule::Own(_) => None,
        }
    }

    /// What the rule is, in words, where it is no power of the pressure.
    pub fn word(&self) -> Option<&'static str> {
        match self {
            Rule::Power(_) => None,
            Rule::Threshold(_) => Some("with a threshold"),
            Rule::Own(rule) => Some(rule.word()),
        }
    }

    /// Wear rate and slope at a pressure above 0; of a function of one's own by one call.
    pub(crate) fn rate_and_slope(&self, pressure: f64, sliding_speed: f64) -> [f64; 2] {
        match self {
            Rule::Power(_) | Rule::Threshold(_) => [self.rate(pressure, sliding_speed), self.slope(pressure, sliding_speed)],
            Rule::Own(rule) => rule.at(pressure, sliding_speed),
        }
    }

    /// Checks the numbers of the rule, those of a [`FunctionLaw`](crate::FunctionLaw) too; a function of one's own has none.
    ///
    /// # Errors
    /// [`WearError::OutOfRange`] for a factor below 0, an exponent b or a threshold that is not greater than 0, and numbers that are not finite.
    pub fn check(&self) -> Result<(), WearError> {
        match self {
            Rule::Power(law) => law.check(),
            Rule::Threshold(law) => law.check(),
            Rule::Own(rule) => match rule.wrong {
                Some((name, value, wanted)) => Err(WearError::OutOfRange { name, value, wanted }),
                None => Ok(()),
            },
        }
    }

    /// log w', usable where w' itself overflows; -inf when nothing wears.
    pub(crate) fn log_rate(&self, log_pressure: f64, sliding_speed: f64) -> f64 {
        match self {
            Rule::Power(law) => log_wear_rate(law, log_pressure, sliding_speed.ln()),
            Rule::Threshold(_) | Rule::Own(_) => self.rate(log_pressure.exp(), sliding_speed).ln(),
        }
    }
}

/// A wear rule at a place of known sliding speed: a function of the pressure alone. The factor beta~ v^a is one number here, so that a rate may
/// differ in its last digit from that of [`Rule::rate`], which multiplies from the left.
#[derive(Clone, Debug, PartialEq)]
pub enum LocalRule {
    /// w' = factor p^exponent.
    Power {
        /// beta~ v^a.
        factor: f64,
        /// b.
        exponent: f64,
    },
    /// w' = factor (p - threshold)^exponent above the threshold, else 0.
    Threshold {
        /// beta~ v^a.
        factor: f64,
        /// b.
        exponent: f64,
        /// p0, MPa.
        threshold: f64,
    },
    /// A function of one's own.
    Own {
        /// The rule.
        rule: OwnRule,
        /// Sliding speed, mm/s.
        sliding_speed: f64,
    },
}

impl LocalRule {
    /// A place that does not wear.
    pub const NONE: LocalRule = LocalRule::Power { factor: 0.0, exponent: 1.0 };

    /// Wear rate in mm/s.
    pub fn rate(&self, pressure: f64) -> f64 {
        match self {
            LocalRule::Power { factor, exponent } => {
                if *factor == 0.0 || pressure <= 0.0 {
                    0.0
                } else {
                    factor * raised(pressure, *exponent)
                }
            }
            LocalRule::Threshold { factor, exponent, threshold } => power(factor, exponent).rate(pressure - threshold),
            LocalRule::Own { rule, sliding_speed } => rule.rate(pressure, *sliding_speed),
        }
    }

    /// Slope dw'/dp in mm/(s MPa); at a threshold from above.
    pub fn slope(&self, pressure: f64) -> f64 {
        match self {
            LocalRule::Power { factor, exponent } => {
                if *factor == 0.0 {
                    0.0
                } else {
                    factor * exponent * raised(pressure.max(0.0), exponent - 1.0)
                }
            }
            LocalRule::Threshold { threshold, .. } if pressure < *threshold => 0.0,
            LocalRule::Threshold { factor, exponent, threshold } => power(factor, exponent).slope(pressure - threshold),
            LocalRule::Own { rule, sliding_speed } => rule.slope(pressure, *sliding_speed),
        }
    }

    /// The pressure that wears at a rate, as [`Rule::inverse`].
    pub fn inverse(&self, rate: f64) -> f64 {
        if rate <= 0.0 {
            return 0.0;
        }
        match self {
            LocalRule::Power { factor, exponent } => (rate / factor).powf(1.0 / exponent),
            LocalRule::Threshold { factor, exponent, threshold } => threshold + power(factor, exponent).inverse(rate),
            LocalRule::Own { rule, sliding_speed } => invert(&|p| rule.at(p, *sliding_speed), rate.ln()).0.exp(),
        }
    }

    /// Potential int_0^p w' in N/(mm s), as [`Rule::potential`]; that of a function by Gauss rules.
    pub fn potential(&self, pressure: f64) -> f64 {
        match self {
            LocalRule::Power { exponent, .. } => self.rate(pressure) * pressure / (exponent + 1.0),
            LocalRule::Threshold { factor, exponent, threshold } => {
                power(factor, exponent).potential((pressure - threshold).max(0.0))
            }
            LocalRule::Own { rule, sliding_speed } => integral(&|p| rule.rate(p, *sliding_speed), pressure),
        }
    }

    /// Whether anything wears here.
    pub fn wears(&self) -> bool {
        match self {
            LocalRule::Power { factor, .. } | LocalRule::Threshold { factor, .. } => *factor > 0.0,
            LocalRule::Own { .. } => true,
        }
    }

    /// Factor and exponent of a power of the pressure; `None` for a rule that is none.
    pub(crate) fn power(&self) -> Option<(f64, f64)> {
        match self {
            LocalRule::Power { factor, exponent } => Some((*factor, *exponent)),
            LocalRule::Threshold { .. } | LocalRule::Own { .. } => None,
        }
    }

    /// Whether the rate is proportional to the pressure.
    pub fn is_linear(&self) -> bool {
        match self {
            LocalRule::Power { factor, exponent } => *exponent == 1.0 || *factor == 0.0,
            LocalRule::Threshold { factor, .. } => *factor == 0.0,
            LocalRule::Own { .. } => false,
        }
    }
}

/// The power law of the excess over a threshold.
fn power(factor: &f64, exponent: &f64) -> LocalRule {
    LocalRule::Power { factor: *factor, exponent: *exponent }
}

/// A power, without a call where it is the first or the zeroth; the same bits.
fn raised(value: f64, exponent: f64) -> f64 {
    if exponent == 1.0 {
        value
    } else if exponent == 0.0 {
        1.0
    } else {
        value.powf(exponent)
    }
}
