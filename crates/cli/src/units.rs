//! Quantities of a scene: a bare number in N, mm, MPa, s, rad, or a string with a unit. Kept in base units.

mod dimension;
mod pair;

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::{Serialize, Serializer};

use dimension::{ANGLE, ANGULAR_SPEED, Dimension, FORCE, LENGTH, MOMENT, PRESSURE, SPEED, TIME, WEAR_FACTOR};
pub(crate) use pair::Pair;

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
        if number.is_finite() {
            return Ok((number, false));
        }
        Err(E::custom(format!("{number} is not a {}\nwrite a finite number", self.0.word)))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<(f64, bool), E> {
        self.0.parse(text).map_err(E::custom).and_then(|(number, unit)| {
            if number.is_finite() {
                return Ok((number, unit));
            }
            Err(E::custom(format!("\"{text}\" is too large for a number\nwrite a finite {}", self.0.word)))
        })
    }
}

fn schema_of(dimension: &Dimension) -> Schema {
    json_schema!({
        "description": dimension.expected(),
        "anyOf": [{ "type": "number" }, { "type": "string", "pattern": "^\\s*[-+.0-9]" }]
    })
}

macro_rules! quantity {
    ($(#[$doc:meta])* $name:ident, $dimension:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
        pub(crate) struct $name(pub(crate) f64);

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

        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                schema_of(&$dimension)
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

/// A wear factor. A bare number has the unit that the exponents a and b give it; a unit fixes a = b = 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct WearFactor {
    /// The number in N, mm, s.
    pub(crate) value: f64,
    /// Whether it was written with a unit of specific wear rate.
    pub(crate) has_unit: bool,
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

impl JsonSchema for WearFactor {
    fn schema_name() -> Cow<'static, str> {
        "WearFactor".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        schema_of(&WEAR_FACTOR)
    }
}
