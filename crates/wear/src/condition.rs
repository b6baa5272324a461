//! Left side x(p, v) of a stationarity condition x = f that is no sum of powers.

use crate::invert::invert;
use crate::own_functional::OwnFunctional;
use crate::rule::Rule;

/// A function of pressure and sliding speed that grows with the pressure.
#[derive(Clone, Debug)]
pub(crate) enum Condition {
    /// Sum of the wear rates of the bodies whose wear opens the gap.
    Wear(Vec<Rule>),
    /// dX/dp of a functional, at a friction coefficient.
    Functional(OwnFunctional, f64),
}

impl Condition {
    /// `[x, dx/dp]` at a pressure above 0.
    fn at(&self, pressure: f64, speed: f64) -> [f64; 2] {
        match self {
            Condition::Wear(rules) => {
                let of = |rule: &Rule| match rule {
                    Rule::Power(_) => [rule.rate(pressure, speed), rule.slope(pressure, speed)],
                    Rule::Own(own) => own.at(pressure, speed),
                };
                rules.iter().map(of).reduce(|a, b| [a[0] + b[0], a[1] + b[1]]).unwrap_or([0.0; 2])
            }
            Condition::Functional(functional, friction) => {
                let [_, first, second] = functional.at(pressure, speed, *friction);
                [first, second]
            }
        }
    }

    /// log p with x(p, v) = exp(log_value), and d log p / d log x.
    pub(crate) fn invert(&self, log_value: f64, speed: f64) -> (f64, f64) {
        invert(&|p| self.at(p, speed), log_value)
    }
}
