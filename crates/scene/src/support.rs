//! What holds an edge: components, a pin it turns about, or a roller.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::units::{Angle, Length};

/// A displacement component.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Component {
    /// Along x, or r.
    X,
    /// Along z.
    Z,
    /// Around the axis.
    Phi,
}

/// What holds a named edge.
#[derive(Debug, Clone, PartialEq)]
pub enum Support {
    /// Components of the displacement that are held along the edge.
    Components(Vec<Component>),
    /// The edge turns as a rigid line about a point [x, z], which may lie off it.
    Pin([Length; 2]),
    /// The edge is free to move in the direction at this angle from +x, anti-clockwise, and held across it.
    Roller(Angle),
}

/// The keys of a support that is no list of components.
const KEYS: [&str; 2] = ["pin", "roller"];

impl Support {
    /// The components that are held; none of a pin or a roller.
    pub fn components(&self) -> &[Component] {
        match self {
            Support::Components(held) => held,
            Support::Pin(_) | Support::Roller(_) => &[],
        }
    }

    /// Whether a component is held; a pin holds the edge in no direction by itself, and a roller is at an angle.
    pub fn holds(&self, component: Component) -> bool {
        matches!(self, Support::Components(held) if held.contains(&component))
    }
}

impl<'de> Deserialize<'de> for Support {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct SupportVisitor;
        impl<'de> Visitor<'de> for SupportVisitor {
            type Value = Support;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of components such as [\"x\", \"z\"], or { pin = [x, z] }, or { roller = \"30 deg\" }")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Support, A::Error> {
                let mut held = Vec::new();
                while let Some(component) = list.next_element()? {
                    held.push(component);
                }
                Ok(Support::Components(held))
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Support, A::Error> {
                let mut found = None;
                while let Some(key) = map.next_key::<String>()? {
                    let support = match key.as_str() {
                        "pin" => Support::Pin(map.next_value()?),
                        "roller" => Support::Roller(map.next_value()?),
                        other => return Err(de::Error::unknown_field(other, &KEYS)),
                    };
                    if found.replace(support).is_some() {
                        return Err(de::Error::custom("an edge has a pin or a roller, not both\nkeep one of them"));
                    }
                }
                let remedy = "the support holds nothing\nwrite [\"x\", \"z\"], { pin = [x, z] } or { roller = \"30 deg\" }";
                found.ok_or_else(|| de::Error::custom(remedy))
            }
        }
        deserializer.deserialize_any(SupportVisitor)
    }
}

impl Serialize for Support {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut table = match self {
            Support::Components(held) => return held.serialize(serializer),
            Support::Pin(_) | Support::Roller(_) => serializer.serialize_map(Some(1))?,
        };
        match self {
            Support::Pin(at) => table.serialize_entry("pin", at)?,
            Support::Roller(angle) => table.serialize_entry("roller", angle)?,
            Support::Components(_) => {}
        }
        table.end()
    }
}
