//! A start gap given by formula: the sum of a crown, a tilt, a cosine and a profile.

use std::fmt;

use serde::de::{self, Deserializer, MapAccess, Visitor};
use serde::ser::SerializeStruct;
use serde::{Deserialize, Serialize, Serializer};

use crate::units::{Angle, Length};

/// A start gap that is a sum; each term is 0 at its lowest place.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct GapSum {
    /// Height of a parabola over the contact surface: 0 in its middle (on the axis where it begins there), this at its ends.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crown: Option<Length>,
    /// Angle of a plane wedge: the gap opens towards +s if positive, towards -s if negative, and is 0 at the other end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tilt: Option<Angle>,
    /// A wave `A (1 - cos(2 pi s / wavelength))`, 0 at s = 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cosine: Option<Cosine>,
    /// A CSV file with the columns s_mm and gap_um, or the columns themselves.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile: Option<Rows>,
    /// Largest root mean square by which a smooth curve may miss the rows of the profile; none to go through them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub smooth: Option<Length>,
}

/// A wave of the gap.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Cosine {
    /// Half the height from trough to crest.
    pub amplitude: Length,
    /// Length of one wave along s.
    pub wavelength: Length,
}

/// Rows of a measured gap.
#[derive(Debug, Clone, PartialEq)]
pub enum Rows {
    /// A CSV file with the columns s_mm and gap_um.
    File(String),
    /// The columns of such a file.
    Columns {
        /// Arc length from the middle (mm), or r.
        s: Vec<f64>,
        /// Gap along the normal (um).
        gap: Vec<f64>,
    },
}

impl<'de> Deserialize<'de> for Rows {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct RowsVisitor;
        impl<'de> Visitor<'de> for RowsVisitor {
            type Value = Rows;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a CSV file with the columns s_mm and gap_um, or { s_mm = [...], gap_um = [...] }")
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Rows, E> {
                Ok(Rows::File(name.to_string()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Rows, A::Error> {
                let Columns { s_mm: s, gap_um: gap } = Columns::deserialize(de::value::MapAccessDeserializer::new(map))?;
                Ok(Rows::Columns { s, gap })
            }
        }
        deserializer.deserialize_any(RowsVisitor)
    }
}

#[derive(Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub(crate) struct Columns {
    s_mm: Vec<f64>,
    gap_um: Vec<f64>,
}

impl Serialize for Rows {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Rows::File(name) => serializer.serialize_str(name),
            Rows::Columns { s, gap } => {
                let mut table = serializer.serialize_struct("Rows", 2)?;
                table.serialize_field("s_mm", s)?;
                table.serialize_field("gap_um", gap)?;
                table.end()
            }
        }
    }
}
