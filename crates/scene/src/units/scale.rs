//! A factor on lengths, or the unit that they are in.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::{Serialize, Serializer};

use super::quantities::LENGTH;

/// A factor that turns lengths of a file into mm; written as a number, or as the unit of the file: "m" is 1000.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Scale(pub f64);

impl<'de> Deserialize<'de> for Scale {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ScaleVisitor;
        impl Visitor<'_> for ScaleVisitor {
            type Value = Scale;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a factor, as in scale = 1000, or the unit of the file, as in scale = \"m\"")
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Scale, E> {
                Ok(Scale(number as f64))
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Scale, E> {
                Ok(Scale(number))
            }

            fn visit_str<E: de::Error>(self, unit: &str) -> Result<Scale, E> {
                let known = LENGTH.units.iter().find(|known| known.0 == unit.trim());
                known
                    .map(|(_, numerator, denominator)| Scale(numerator / denominator))
                    .ok_or_else(|| E::invalid_value(de::Unexpected::Str(unit), &self))
            }
        }
        deserializer.deserialize_any(ScaleVisitor)
    }
}

impl Serialize for Scale {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.0)
    }
}
