//! Left side x(p, v) of a stationarity condition x = f that is no sum of powers.

use crate::invert::{invert, invert_log};
use crate::own_functional::OwnFunctional;
use crate::rule::Rule;
use crate::threshold::ThresholdLaw;

/// A function of pressure and sliding speed that grows with the pressure.
#[derive(Clone, Debug)]
pub(crate) enum Condition {
    /// Sum of the wear rates of the bodies whose wear opens the gap, and the logarithms of the pressures at which it bends.
    Wear(Vec<Rule>, Vec<f64>),
    /// dX/dp of a functional, at a friction coefficient.
    Functional(OwnFunctional, f64),
    /// dX/dp of X = (p^d w')^q under a threshold, with `[d, q]`.
    Threshold(ThresholdLaw, [f64; 2]),
}

impl Condition {
    /// The sum of the rates of some rules.
    pub(crate) fn of_rules(rules: Vec<Rule>) -> Condition {
        let log_bends = bends(&rules).into_iter().map(f64::ln).collect();
        Condition::Wear(rules, log_bends)
    }

    /// Logarithms of the pressures at which it is known to bend.
    pub(crate) fn log_bends(&self) -> &[f64] {
        match self {
            Condition::Wear(_, log_bends) => log_bends,
            Condition::Functional(..) | Condition::Threshold(..) => &[],
        }
    }

    /// log p with x(p, v) = exp(log_value), and d log p / d log x.
    pub(crate) fn invert(&self, log_value: f64, speed: f64) -> (f64, f64) {
        match self {
            Condition::Wear(rules, _) => match &rules[..] {
                [Rule::Threshold(law)] => law.pressure_of(log_value, speed),
                rules => invert(&|p| total(rules, p, speed), log_value),
            },
            Condition::Functional(functional, friction) => {
                let derivatives = |p: f64| {
                    let [_, first, second] = functional.at(p, speed, *friction);
                    [first, second]
                };
                invert(&derivatives, log_value)
            }
            Condition::Threshold(law, powers) => invert_log(&|p| law.stationarity(*powers, p, speed), log_value),
        }
    }
}

/// Pressures (MPa) at which a sum of wear rates bends: those of each rule, and the threshold of one body where the other one wears below it.
pub(crate) fn bends(rules: &[Rule]) -> Vec<f64> {
    let several = rules.iter().filter(|rule| rule.wears()).count() > 1;
    let thresholds = rules.iter().filter_map(|rule| match rule {
        Rule::Threshold(law) if several && law.law.factor > 0.0 => Some(law.threshold),
        Rule::Threshold(_) | Rule::Power(_) | Rule::Own(_) => None,
    });
    thresholds.chain(rules.iter().flat_map(Rule::bends).copied()).collect()
}

/// Sum of wear rates and of their slopes at a pressure above 0.
fn total(rules: &[Rule], pressure: f64, speed: f64) -> [f64; 2] {
    rules.iter().map(|rule| rule.rate_and_slope(pressure, speed)).reduce(|a, b| [a[0] + b[0], a[1] + b[1]]).unwrap_or([0.0; 2])
}
