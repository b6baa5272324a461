//! The material of a body or of some of its cells.

use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserializer, MapAccess, Visitor};
use serde::{Deserialize, Serialize};

use crate::known::known_material;
use crate::units::{Angle, Axes, Conductivity, Density, Expansion, Pressure, Temperature};

/// Linear elasticity, isotropic or orthotropic. A scene may name a known material instead ([`known_materials`](crate::known_materials)).
///
/// An orthotropic material has moduli along its axes 1, 2 and 3: the first two lie in the plane of the bodies, the third points out of it (in a
/// body of revolution along the circumference).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Material {
    /// Young's modulus (MPa); of an orthotropic material `[E_1, E_2, E_3]`.
    pub young: Axes<Pressure>,
    /// Poisson's ratio; of an orthotropic material `[nu_12, nu_13, nu_23]`, `nu_ij` the contraction along j under a pull along i.
    pub poisson: Axes<f64>,
    /// Shear moduli (MPa) of an orthotropic material, `[G_12, G_13, G_23]`; one stands for all three.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shear: Option<Axes<Pressure>>,
    /// Angle (rad) of axis 1 to +x, anti-clockwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<Angle>,
    /// Density (t/mm^3).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub density: Option<Density>,
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
    /// An elastic material of which nothing else is known.
    pub fn elastic(young: Pressure, poisson: f64) -> Material {
        let (young, poisson) = (Axes::One(young), Axes::One(poisson));
        let (shear, angle, density, conductivity, expansion) = (None, None, None, None, None);
        Material { young, poisson, shear, angle, density, conductivity, expansion, temperature_limit: None }
    }

    /// The same of which nothing thermal is known.
    #[must_use]
    pub fn without_heat(self) -> Material {
        Material { conductivity: None, expansion: None, temperature_limit: None, ..self }
    }

    /// Whether it is written by its axes.
    pub fn is_orthotropic(&self) -> bool {
        matches!(self.young, Axes::Three(_))
    }

    /// Young's modulus (MPa) and Poisson's ratio; of an orthotropic material the means in the plane that stand for it where two numbers are
    /// asked for, in texts and first guesses alone: `E = sqrt(E_1 E_2)` and `nu = sqrt(nu_12 nu_21)` (Krenk 1979).
    pub fn in_plane(&self) -> [f64; 2] {
        match (self.young, self.poisson) {
            (Axes::Three([first, second, _]), poisson) => {
                let root = (second.0 / first.0).sqrt();
                [first.0 * root, poisson.each()[0] * root]
            }
            (Axes::One(young), poisson) => [young.0, poisson.each()[0]],
        }
    }
}

/// A material by its numbers.
#[derive(Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "MaterialNumbers"))]
#[serde(deny_unknown_fields)]
pub(crate) struct Numbers {
    /// Young's modulus (MPa); of an orthotropic material a list of three, [E1, E2, E3], along its axes 1 and 2 in the plane and 3 out of it.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    young: Axes<Pressure>,
    /// Poisson's ratio; of an orthotropic material a list of three, [nu12, nu13, nu23], where nu12 is the contraction along axis 2 under a pull
    /// along axis 1.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = -1, "exclusiveMaximum" = 0.5)))]
    poisson: Axes<f64>,
    /// Shear modulus of an orthotropic material in the plane, G12 (MPa), or a list of three, [G12, G13, G23], where the friction of an axisymmetric
    /// scene twists it; one number stands for all three.
    #[serde(default)]
    shear: Option<Axes<Pressure>>,
    /// Angle of axis 1 of an orthotropic material to +x, anti-clockwise (rad). Default 0.
    #[serde(default)]
    angle: Option<Angle>,
    /// Density (t/mm^3), of a body that spins or has `gravity`.
    #[serde(default)]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    density: Option<Density>,
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
                    // kg/m^3.
                    density: known.density.map(|density| Density(density / 1e12)),
                    conductivity: known.conductivity.map(Conductivity),
                    // The table is in 1e-6/K: a division rounds once.
                    expansion: known.expansion.map(|expansion| Expansion(expansion / 1e6)),
                    ..Material::elastic(Pressure(1e3 * known.young), known.poisson)
                })
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Material, A::Error> {
                let Numbers { young, poisson, shear, angle, density, conductivity, expansion, temperature_limit } =
                    Numbers::deserialize(MapAccessDeserializer::new(map))?;
                Ok(Material { young, poisson, shear, angle, density, conductivity, expansion, temperature_limit })
            }
        }
        deserializer.deserialize_any(MaterialVisitor)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Material, String> {
        #[derive(Deserialize)]
        struct Table {
            material: Material,
        }
        toml::from_str::<Table>(text).map(|table| table.material).map_err(|error| error.to_string())
    }

    #[test]
    fn an_orthotropic_material_is_written_as_it_was_read() {
        let material =
            read("material = { young = ['8 GPa', 2e3, 1e3], poisson = [0.3, 0.2, 0.1], shear = '0.7 GPa', angle = '90 deg' }")
                .unwrap();
        assert!(material.is_orthotropic());
        assert_eq!(material.young.each().map(|e| e.0), [8e3, 2e3, 1e3]);
        assert_eq!(material.shear.unwrap().each(), [Pressure(700.0); 3]);
        assert_eq!(material.angle, Some(Angle(std::f64::consts::FRAC_PI_2)));
        assert_eq!(material.in_plane(), [4e3, 0.15]);
        let again = read(&format!("[material]\n{}", toml::to_string(&material).unwrap())).unwrap();
        assert_eq!(again, material);
    }

    #[test]
    fn an_isotropic_material_has_two_numbers() {
        let material = read("material = { young = '210 GPa', poisson = 0.3 }").unwrap();
        assert!(!material.is_orthotropic());
        assert_eq!(material, Material::elastic(Pressure(210e3), 0.3));
        assert_eq!(material.in_plane(), [210e3, 0.3]);
        assert_eq!(toml::to_string(&material).unwrap(), "young = 210000.0\npoisson = 0.3\n");
    }

    #[test]
    fn two_moduli_are_no_axes() {
        let said = read("material = { young = [1e3, 2e3], poisson = [0.3, 0.2, 0.1] }").unwrap_err();
        assert!(said.contains("a list of three by the axes of the material"), "{said}");
    }
}
