//! Quantities of a scene: a bare number in N, mm, MPa, s, rad, or a string with a unit. Kept in base units.

mod axes;
mod conductance;
pub(crate) mod dimension;
mod pair;
pub(crate) mod quantities;
mod scale;
mod steps;

use std::fmt;

use serde::de::{self, Visitor};

pub use axes::Axes;
pub use conductance::Conductance;
use dimension::Dimension;
pub use pair::Pair;
pub use quantities::{
    Acceleration, Angle, AngularSpeed, Conductivity, Density, Expansion, Force, Frequency, HeatFlux, HeatTransfer, Length,
    Moment, Pressure, Speed, Temperature, Time, Volume, WearFactor,
};
pub use scale::Scale;
pub use steps::Steps;

/// Magnitudes other than zero that a quantity may have: squares and ratios of what is in between are numbers still.
const MAGNITUDES: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

fn in_range(number: f64, written: &str, dimension: &Dimension) -> Result<f64, String> {
    if number == 0.0 || MAGNITUDES.contains(&number.abs()) {
        return Ok(number);
    }
    let fault = if number.is_nan() {
        "no number"
    } else if number.abs() < 1.0 {
        "too small"
    } else {
        "too large"
    };
    let (word, base) = (dimension.word, dimension.base);
    Err(format!(
        "{written} is {fault}, and no {word}\nwrite a finite number in {base}, 0 or between 1e-100 and 1e100 in magnitude"
    ))
}

/// What a bare number says, and that it has no unit.
fn bare(number: f64, dimension: &Dimension) -> Result<(f64, bool), String> {
    Ok((in_range(number, &format!("{number:?}"), dimension)?, false))
}

/// The number that a text means, and whether it has a unit.
fn with_unit(text: &str, dimension: &Dimension) -> Result<(f64, bool), String> {
    let (number, unit) = dimension.parse(text)?;
    Ok((in_range(number, &format!("\"{text}\""), dimension)?, unit))
}

struct QuantityVisitor(&'static Dimension);

impl Visitor<'_> for QuantityVisitor {
    type Value = (f64, bool);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.expected())
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<(f64, bool), E> {
        Ok((number as f64, false))
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<(f64, bool), E> {
        bare(number, self.0).map_err(E::custom)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<(f64, bool), E> {
        with_unit(text, self.0).map_err(E::custom)
    }
}
