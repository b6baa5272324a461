//! A wear rule given as a function.

use std::fmt;
use std::sync::Arc;

use crate::WearError;

/// What is refused of a rule.
const RATE: &str = "rate of a wear rule given as a function";
/// Part by which a rate near its bound may fall by round-off from one pressure to the next.
const FALL: f64 = 1e-9;

/// Wear rate and its slope as a function of pressure (MPa) and sliding speed (mm/s): `[w', dw'/dp]` in mm/s and mm/(s MPa).
type RateAndSlope = dyn Fn(f64, f64) -> [f64; 2] + Send + Sync;

/// A wear rule that is no power of the pressure: with a threshold, with a change from mild to severe wear, with a rate that saturates.
///
/// The rate must be zero up to some pressure p0 >= 0, continuous, and grow from there; where it comes near a bound the pressure of the steady
/// state grows without one. A [`Problem`](crate::Problem) is refused whose rates are no numbers, negative, or less at a larger pressure, at
/// 61 pressures from 1e-3 to 1e3 MPa, ten a decade, with the lowest and the highest speed of the surface that slides; between these speeds rates
/// of no numbers are looked for at 1e-3, 1 and 1e3 MPa. Two rules are equal if one is a clone of the other, or if they have the same name and the same numbers.
#[derive(Clone)]
pub struct OwnRule {
    law: Arc<RateAndSlope>,
    word: &'static str,
    numbers: Vec<f64>,
    /// Pressures (MPa) at which its slope is known to bend or jump: there the pressure it asks for is not smooth along a surface.
    pub(crate) bends: Vec<f64>,
    /// A number with which it is none, and what that must be.
    pub(crate) wrong: Option<(&'static str, f64, &'static str)>,
}

impl OwnRule {
    /// The rule of a function `law(pressure, sliding_speed)` that gives `[w', dw'/dp]` in mm/s and mm/(s MPa) from MPa and mm/s. It is called
    /// at pressures above 0 only.
    pub fn new(law: impl Fn(f64, f64) -> [f64; 2] + Send + Sync + 'static) -> OwnRule {
        OwnRule { law: Arc::new(law), word: "given as a function", numbers: Vec::new(), bends: Vec::new(), wrong: None }
    }

    /// The same of a function that a name ("from a table") and numbers say wholly.
    pub(crate) fn named(
        word: &'static str,
        numbers: Vec<f64>,
        law: impl Fn(f64, f64) -> [f64; 2] + Send + Sync + 'static,
    ) -> OwnRule {
        OwnRule { law: Arc::new(law), word, numbers, bends: Vec::new(), wrong: None }
    }

    /// What the rule is, in words.
    pub(crate) fn word(&self) -> &'static str {
        self.word
    }

    /// `[w', dw'/dp]` at a pressure above 0.
    pub(crate) fn at(&self, pressure: f64, sliding_speed: f64) -> [f64; 2] {
        (self.law)(pressure, sliding_speed)
    }

    /// Refuses rates that are no numbers, at a few pressures (MPa). Large pressures may wear without a bound.
    pub(crate) fn check_numbers(&self, sliding_speed: f64) -> Result<(), WearError> {
        let rates = [-3, 0, 3].map(|decade| self.rate(10_f64.powi(decade), sliding_speed));
        let wrong = rates.into_iter().find(|rate| rate.is_nan()).or(Some(rates[0]).filter(|rate| rate.is_infinite()));
        wrong.map_or(Ok(()), |value| Err(WearError::OutOfRange { name: RATE, value, wanted: "finite" }))
    }

    /// Refuses rates that are no numbers, negative, or less at a larger pressure, at pressures ten a decade.
    pub(crate) fn check_growth(&self, sliding_speed: f64) -> Result<(), WearError> {
        self.check_numbers(sliding_speed)?;
        let mut before = 0.0;
        for tenth in -30..=30 {
            let value = self.rate(10_f64.powf(0.1 * f64::from(tenth)), sliding_speed);
            let wanted = match value {
                _ if value.is_nan() => "finite",
                _ if value < 0.0 => "zero or positive",
                _ if value < before * (1.0 - FALL) => "no less than at a smaller pressure",
                _ => {
                    before = value;
                    continue;
                }
            };
            return Err(WearError::OutOfRange { name: RATE, value, wanted });
        }
        Ok(())
    }

    pub(crate) fn rate(&self, pressure: f64, sliding_speed: f64) -> f64 {
        if pressure > 0.0 { self.at(pressure, sliding_speed)[0] } else { 0.0 }
    }

    pub(crate) fn slope(&self, pressure: f64, sliding_speed: f64) -> f64 {
        self.at(pressure.max(f64::MIN_POSITIVE), sliding_speed)[1]
    }
}

impl fmt::Debug for OwnRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "OwnRule({})", self.word)
    }
}

impl PartialEq for OwnRule {
    fn eq(&self, other: &OwnRule) -> bool {
        let said = !self.numbers.is_empty() && (self.word, &self.numbers) == (other.word, &other.numbers);
        said || std::ptr::addr_eq(Arc::as_ptr(&self.law), Arc::as_ptr(&other.law))
    }
}
