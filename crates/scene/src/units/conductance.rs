//! Conductance of a contact: a coefficient of heat transfer that may be infinite.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::{Serialize, Serializer};

use super::QuantityVisitor;
use super::quantities::HEAT_TRANSFER;

/// A conductance in mW/(mm^2 K), that is 1000 W/(m^2 K); infinite where both surfaces have one temperature.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Conductance(pub f64);

impl<'de> Deserialize<'de> for Conductance {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct ConductanceVisitor;
        impl Visitor<'_> for ConductanceVisitor {
            type Value = Conductance;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "\"inf\", or {}", HEAT_TRANSFER.expected())
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Conductance, E> {
                Ok(Conductance(number as f64))
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Conductance, E> {
                if number == f64::INFINITY {
                    return Ok(Conductance(number));
                }
                QuantityVisitor(&HEAT_TRANSFER).visit_f64(number).map(|(number, _)| Conductance(number))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Conductance, E> {
                if text.trim().eq_ignore_ascii_case("inf") {
                    return Ok(Conductance(f64::INFINITY));
                }
                QuantityVisitor(&HEAT_TRANSFER).visit_str(text).map(|(number, _)| Conductance(number))
            }
        }
        deserializer.deserialize_any(ConductanceVisitor)
    }
}

impl Serialize for Conductance {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.0)
    }
}
