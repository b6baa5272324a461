//! Two keys that hold either a word or a number: the start gap and the end of a run.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use crate::units::Time;

/// The unloaded gap at the start.
#[derive(Debug, Clone, PartialEq)]
pub enum Gap {
    /// The same everywhere (mm).
    Constant(f64),
    /// A CSV file with the columns s_mm and gap_um.
    File(String),
    /// The columns of such a file.
    Profile {
        /// Arc length from the middle (mm), or r.
        s: Vec<f64>,
        /// Gap along the normal (um).
        gap: Vec<f64>,
    },
}

impl<'de> Deserialize<'de> for Gap {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct GapVisitor;
        impl<'de> Visitor<'de> for GapVisitor {
            type Value = Gap;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("0, the name of a CSV file with the columns s_mm and gap_um, or { s_mm = [...], gap_um = [...] }")
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Gap, E> {
                Ok(Gap::Constant(number as f64))
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Gap, E> {
                Ok(Gap::Constant(number))
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Gap, E> {
                Ok(Gap::File(name.to_string()))
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Gap, A::Error> {
                let (mut s, mut gap) = (None, None);
                while let Some(key) = map.next_key::<String>()? {
                    match key.as_str() {
                        "s_mm" => s = Some(map.next_value()?),
                        "gap_um" => gap = Some(map.next_value()?),
                        other => return Err(de::Error::unknown_field(other, &["s_mm", "gap_um"])),
                    }
                }
                let s = s.ok_or_else(|| de::Error::missing_field("s_mm"))?;
                let gap = gap.ok_or_else(|| de::Error::missing_field("gap_um"))?;
                Ok(Gap::Profile { s, gap })
            }
        }
        deserializer.deserialize_any(GapVisitor)
    }
}

impl Serialize for Gap {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Gap::Constant(gap) => serializer.serialize_f64(*gap),
            Gap::File(name) => serializer.serialize_str(name),
            Gap::Profile { s, gap } => {
                let mut table = serializer.serialize_struct("Gap", 2)?;
                table.serialize_field("s_mm", s)?;
                table.serialize_field("gap_um", gap)?;
                table.end()
            }
        }
    }
}

/// Where a run in time ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Until {
    /// When the pressure no longer changes.
    Steady,
    /// At a time.
    Time(Time),
}

impl<'de> Deserialize<'de> for Until {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct UntilVisitor;
        impl Visitor<'_> for UntilVisitor {
            type Value = Until;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"steady\" or a time such as \"10 s\"")
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Until, E> {
                Ok(Until::Time(Time(number as f64)))
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Until, E> {
                Ok(Until::Time(Time(number)))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Until, E> {
                if text == "steady" {
                    return Ok(Until::Steady);
                }
                Time::deserialize(de::value::StrDeserializer::new(text)).map(Until::Time)
            }
        }
        deserializer.deserialize_any(UntilVisitor)
    }
}

impl Serialize for Until {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Until::Steady => serializer.serialize_str("steady"),
            Until::Time(time) => time.serialize(serializer),
        }
    }
}
