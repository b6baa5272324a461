//! Materials by name: the numbers of standards, handbooks and makers, each with its source.

use serde::Deserialize;

use crate::fault::did_you_mean;
use crate::tree;

/// A material that a scene may name.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KnownMaterial {
    /// Its name in a scene.
    pub name: String,
    /// Young's modulus (GPa).
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Density (kg/m3).
    pub density: Option<f64>,
    /// Conductivity of heat (W/(m K)).
    pub conductivity: Option<f64>,
    /// Linear thermal expansion (1e-6/K).
    pub expansion: Option<f64>,
    /// Heat capacity (J/(kg K)).
    pub heat_capacity: Option<f64>,
    /// Where the numbers are from.
    pub source: String,
    /// How far they scatter, where that is much.
    pub about: Option<String>,
}

const TEXT: &str = include_str!("../materials.toml");

#[derive(Deserialize)]
struct Table {
    material: Vec<KnownMaterial>,
}

/// All materials that a scene may name.
pub fn known_materials() -> Vec<KnownMaterial> {
    // By the reader of scenes, so that a module for browsers holds no other.
    let tree = tree::parse(TEXT).ok();
    tree.and_then(|tree| Table::deserialize(&tree).ok()).map(|table| table.material).unwrap_or_default()
}

/// The material of a name; or what is wrong, and on a line of its own what to write.
pub(crate) fn known_material(name: &str) -> Result<KnownMaterial, String> {
    let known = known_materials();
    let names: Vec<&str> = known.iter().map(|material| material.name.as_str()).collect();
    let remedy = did_you_mean(name, &names);
    let found = known.iter().find(|material| material.name == name).cloned();
    found.ok_or_else(|| {
        format!("there is no material `{name}`\n{remedy}, or its numbers: {{ young = \"210 GPa\", poisson = 0.3 }}")
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn every_material_has_numbers_in_range_and_a_source() {
        let known = toml::from_str::<Table>(TEXT).unwrap().material;
        assert_eq!(known, known_materials());
        assert!(known.len() >= 20, "{}", known.len());
        for (at, material) in known.iter().enumerate() {
            let name = &material.name;
            assert!(known[..at].iter().all(|other| other.name != *name), "{name} twice");
            assert!(name.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-'), "{name}");
            assert!((0.05..1000.0).contains(&material.young) && (0.1..0.49).contains(&material.poisson), "{name}");
            assert!(material.density.is_some_and(|density| (900.0..20_000.0).contains(&density)), "{name}");
            let thermal = [material.conductivity, material.expansion, material.heat_capacity];
            assert!(thermal.iter().flatten().all(|number| *number > 0.0), "{name}");
            assert!(material.source.len() > 10, "{name}");
        }
    }

    #[test]
    fn a_name_that_is_nearly_one_is_answered_by_it() {
        assert_eq!(known_material("steel").unwrap().young, 210.0);
        let said = known_material("stele").unwrap_err();
        assert!(said.contains("there is no material `stele`") && said.contains("steel"), "{said}");
    }
}
