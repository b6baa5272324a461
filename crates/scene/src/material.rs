//! The material of a body or of some of its cells.

use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserializer, MapAccess, Visitor};
use serde::{Deserialize, Serialize};

use crate::known::known_material;
use crate::units::{Conductivity, Expansion, Pressure, Temperature};

/// Linear isotropic elasticity. A scene may name a known material instead ([`known_materials`](crate::known_materials)).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Material {
    /// Young's modulus (MPa).
    pub young: Pressure,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Conductivity of heat (mW/(mm K)).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub conductivity: Option<Conductivity>,
    /// Linear thermal expansion (1/K).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expansion: Option<Expansion>,
    /// The highest temperature that the material bears (degC).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub temperature_limit: Option<Temperature>,
}

impl Material {
    /// An elastic material of which nothing thermal is known.
    pub fn elastic(young: Pressure, poisson: f64) -> Material {
        Material { young, poisson, conductivity: None, expansion: None, temperature_limit: None }
    }
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
    /// Conductivity of heat (mW/(mm K), that is W/(m K)).
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    conductivity: Option<Conductivity>,
    /// Linear thermal expansion (1/K).
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0)))]
    expansion: Option<Expansion>,
    /// The highest temperature that the material bears (degC).
    #[serde(default)]
    temperature_limit: Option<Temperature>,
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
                Ok(Material {
                    conductivity: known.conductivity.map(Conductivity),
                    // The table is in 1e-6/K: a division rounds once.
                    expansion: known.expansion.map(|expansion| Expansion(expansion / 1e6)),
                    ..Material::elastic(Pressure(1e3 * known.young), known.poisson)
                })
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Material, A::Error> {
                let Numbers { young, poisson, conductivity, expansion, temperature_limit } =
                    Numbers::deserialize(MapAccessDeserializer::new(map))?;
                Ok(Material { young, poisson, conductivity, expansion, temperature_limit })
            }
        }
        deserializer.deserialize_any(MaterialVisitor)
    }
}
