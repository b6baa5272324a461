//! What of a body may wear off.

use std::fmt;

use serde::de::value::StrDeserializer;
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::units::Length;

/// What of a body may wear off: a thickness, or the layer of a material at the contact.
#[derive(Debug, Clone, PartialEq)]
pub enum Layer {
    /// So much (mm).
    Thickness(Length),
    /// As much as the layer of the material of this name is thick where it is thinnest.
    Material(String),
}

impl<'de> Deserialize<'de> for Layer {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Layer, D::Error> {
        struct LayerVisitor;
        impl Visitor<'_> for LayerVisitor {
            type Value = Layer;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a thickness such as \"4 mm\", or the name of the material at the contact, whose layer may wear off")
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Layer, E> {
                Ok(Layer::Thickness(Length(number as f64)))
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Layer, E> {
                Ok(Layer::Thickness(Length(number)))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Layer, E> {
                let is_name = text.starts_with(|c: char| c.is_alphabetic());
                if is_name {
                    return Ok(Layer::Material(text.into()));
                }
                Length::deserialize(StrDeserializer::new(text)).map(Layer::Thickness)
            }
        }
        deserializer.deserialize_any(LayerVisitor)
    }
}

impl Serialize for Layer {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Layer::Thickness(thickness) => thickness.serialize(serializer),
            Layer::Material(name) => serializer.serialize_str(name),
        }
    }
}
