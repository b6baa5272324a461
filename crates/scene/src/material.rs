//! The material of a body or of some of its cells.

use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserializer, MapAccess, Visitor};
use serde::{Deserialize, Serialize};

use crate::known::known_material;
use crate::units::Pressure;

/// Linear isotropic elasticity. A scene may name a known material instead ([`known_materials`](crate::known_materials)).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Material {
    /// Young's modulus (MPa).
    pub young: Pressure,
    /// Poisson's ratio.
    pub poisson: f64,
}

/// A material by its numbers.
#[derive(Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "MaterialNumbers"))]
#[serde(deny_unknown_fields)]
pub(crate) struct Numbers {
    /// Young's modulus (MPa).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    young: Pressure,
    /// Poisson's ratio.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = -1, "exclusiveMaximum" = 0.5)))]
    poisson: f64,
}

impl<'de> Deserialize<'de> for Material {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct MaterialVisitor;
        impl<'de> Visitor<'de> for MaterialVisitor {
            type Value = Material;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a table, as in { young = \"210 GPa\", poisson = 0.3 }, or a name that `wearshape materials` lists, as \"steel\"")
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Material, E> {
                let known = known_material(name).map_err(E::custom)?;
                Ok(Material { young: Pressure(1e3 * known.young), poisson: known.poisson })
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Material, A::Error> {
                let Numbers { young, poisson } = Numbers::deserialize(MapAccessDeserializer::new(map))?;
                Ok(Material { young, poisson })
            }
        }
        deserializer.deserialize_any(MaterialVisitor)
    }
}
