//! Two keys that hold either a word or a number: the start gap and the end of a run.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use crate::gap_sum::GapSum;
use crate::units::{Length, Time, Volume};

/// Keys of a table of the gap.
const KEYS: [&str; 7] = ["s_mm", "gap_um", "crown", "tilt", "cosine", "profile", "smooth"];

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
    /// A sum of formulas and a profile.
    Sum(GapSum),
}

impl<'de> Deserialize<'de> for Gap {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct GapVisitor;
        impl<'de> Visitor<'de> for GapVisitor {
            type Value = Gap;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("0, the name of a CSV file with the columns s_mm and gap_um, { s_mm = [...], gap_um = [...] }, or a sum such as { crown = \"10 um\" }")
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
                let (mut s, mut gap, mut sum) = (None, None, GapSum::default());
                let (mut rows, mut terms) = (false, None);
                while let Some(key) = map.next_key::<String>()? {
                    let is_row = matches!(key.as_str(), "s_mm" | "gap_um");
                    match key.as_str() {
                        "s_mm" => s = Some(map.next_value()?),
                        "gap_um" => gap = Some(map.next_value()?),
                        "crown" => sum.crown = map.next_value()?,
                        "tilt" => sum.tilt = map.next_value()?,
                        "cosine" => sum.cosine = map.next_value()?,
                        "profile" => sum.profile = map.next_value()?,
                        "smooth" => sum.smooth = map.next_value()?,
                        other => return Err(de::Error::unknown_field(other, &KEYS)),
                    }
                    rows |= is_row;
                    terms = terms.or((!is_row).then_some(key));
                }
                match terms {
                    None if rows => {}
                    Some(term) if rows => {
                        return Err(de::Error::custom(format!(
                            "s_mm and gap_um beside `{term}`\nwrite profile = {{ s_mm = [...], gap_um = [...] }} to add them"
                        )));
                    }
                    _ => return Ok(Gap::Sum(sum)),
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
            Gap::Sum(sum) => sum.serialize(serializer),
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
    /// After a sliding distance.
    Distance(Length),
    /// After so many turns of body 2.
    Revolutions(f64),
    /// When so much is worn off body 1 where it is worn most.
    Depth(Length),
    /// When both bodies together have lost so much.
    Volume(Volume),
}

const ENDS: [&str; 5] = ["time", "distance", "revolutions", "depth", "volume"];

impl<'de> Deserialize<'de> for Until {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct UntilVisitor;
        impl<'de> Visitor<'de> for UntilVisitor {
            type Value = Until;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"steady\", a time such as \"10 s\", { distance = \"2 km\" }, { revolutions = 1e5 }, { depth = \"50 um\" } or { volume = \"2 mm^3\" }")
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

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Until, A::Error> {
                let mut until = None;
                while let Some(key) = map.next_key::<String>()? {
                    let next = match key.as_str() {
                        "time" => Until::Time(map.next_value()?),
                        "distance" => Until::Distance(map.next_value()?),
                        "revolutions" => Until::Revolutions(map.next_value()?),
                        "depth" => Until::Depth(map.next_value()?),
                        "volume" => Until::Volume(map.next_value()?),
                        other => return Err(de::Error::unknown_field(other, &ENDS)),
                    };
                    if until.replace(next).is_some() {
                        return Err(de::Error::custom(
                            "a run in time has one end\nkeep one of: time, distance, revolutions, depth, volume",
                        ));
                    }
                }
                until.ok_or_else(|| de::Error::custom("an empty table\nwrite one of: time, distance, revolutions, depth, volume"))
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
            Until::Distance(length) => {
                let mut table = serializer.serialize_struct("Until", 1)?;
                table.serialize_field("distance", length)?;
                table.end()
            }
            Until::Revolutions(count) => {
                let mut table = serializer.serialize_struct("Until", 1)?;
                table.serialize_field("revolutions", count)?;
                table.end()
            }
            Until::Depth(depth) => {
                let mut table = serializer.serialize_struct("Until", 1)?;
                table.serialize_field("depth", depth)?;
                table.end()
            }
            Until::Volume(volume) => {
                let mut table = serializer.serialize_struct("Until", 1)?;
                table.serialize_field("volume", volume)?;
                table.end()
            }
        }
    }
}
