//! Quantities of a scene: a bare number in N, mm, MPa, s, rad, or a string with a unit. Kept in base units.

mod axes;
mod conductance;
pub(crate) mod dimension;
mod pair;
mod scale;
mod steps;

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::{Serialize, Serializer};

pub use axes::Axes;
pub use conductance::Conductance;
use dimension::{
    ANGLE, ANGULAR_SPEED, CONDUCTIVITY, DENSITY, Dimension, EXPANSION, FORCE, FREQUENCY, HEAT_FLUX, HEAT_TRANSFER, LENGTH,
    MOMENT, PRESSURE, SPEED, TEMPERATURE, TIME, VOLUME, WEAR_FACTOR,
};
pub use pair::Pair;
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
        in_range(number, &format!("{number:?}"), self.0).map(|number| (number, false)).map_err(E::custom)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<(f64, bool), E> {
        let (number, unit) = self.0.parse(text).map_err(E::custom)?;
        in_range(number, &format!("\"{text}\""), self.0).map(|number| (number, unit)).map_err(E::custom)
    }
}

macro_rules! quantity {
    ($(#[$doc:meta])* $name:ident, $dimension:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
        pub struct $name(pub f64);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(QuantityVisitor(&$dimension)).map(|(number, _)| $name(number))
            }
        }

        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_f64(self.0)
            }
        }
    };
}

quantity!(
    /// A length in mm.
    Length, LENGTH
);
quantity!(
    /// A force in N.
    Force, FORCE
);
quantity!(
    /// A pressure or modulus in MPa.
    Pressure, PRESSURE
);
quantity!(
    /// An angle in rad.
    Angle, ANGLE
);
quantity!(
    /// A speed in mm/s.
    Speed, SPEED
);
quantity!(
    /// An angular speed in rad/s.
    AngularSpeed, ANGULAR_SPEED
);
quantity!(
    /// A time in s.
    Time, TIME
);
quantity!(
    /// A moment in N mm.
    Moment, MOMENT
);
quantity!(
    /// A density in t/mm^3, that is N s^2/mm^4.
    Density, DENSITY
);
quantity!(
    /// A volume in mm^3.
    Volume, VOLUME
);
quantity!(
    /// A frequency in cycles a second.
    Frequency, FREQUENCY
);
quantity!(
    /// A temperature in degC.
    Temperature, TEMPERATURE
);
quantity!(
    /// A conductivity of heat in mW/(mm K), that is W/(m K).
    Conductivity, CONDUCTIVITY
);
quantity!(
    /// A linear thermal expansion in 1/K.
    Expansion, EXPANSION
);
quantity!(
    /// A coefficient of heat transfer in mW/(mm^2 K), that is 1000 W/(m^2 K).
    HeatTransfer, HEAT_TRANSFER
);
quantity!(
    /// A heat flux in mW/mm^2.
    HeatFlux, HEAT_FLUX
);

/// A wear factor. A bare number has the unit that the exponents a and b give it; a unit fixes a = b = 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WearFactor {
    /// The number in N, mm, s.
    pub value: f64,
    /// Whether it was written with a unit of specific wear rate.
    pub has_unit: bool,
}

impl<'de> Deserialize<'de> for WearFactor {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (value, has_unit) = deserializer.deserialize_any(QuantityVisitor(&WEAR_FACTOR))?;
        Ok(WearFactor { value, has_unit })
    }
}

impl Serialize for WearFactor {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.value)
    }
}
