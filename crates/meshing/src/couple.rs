//! The two elastic bodies with every default filled in: what their meshes and their reduced problems depend on. How strong the load is, friction,
//! sliding and wear are no part of it, since bodies carry unit loads.

use std::collections::BTreeMap;
use std::sync::Arc;

use hpfem::{Kinematics, Mesh};
use scene::{Component, Geometry, LoadKind, Material, Support};

use crate::body_load::BodyLoad;

/// Two bodies that touch, and where the first is loaded.
#[derive(Debug, Clone, PartialEq)]
pub struct Couple {
    /// Kinematics of both, with their thickness (mm).
    pub kinematics: Kinematics,
    /// Body 1, which is shaped, and body 2, the counter-face.
    pub bodies: [Body; 2],
    /// Where and how body 1 is loaded.
    pub load: LoadedEdge,
    /// Longest piece of the contact surface, as a part of it, that templates leave uncut: 1 where the geometry alone decides, less for a gap of short
    /// waves.
    pub longest: f64,
}

/// One body.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Its key in the scene: "body1" or "body2".
    pub key: &'static str,
    /// Shape with named edges.
    pub geometry: Geometry,
    /// The cells of a body that is given by them; the boundaries of the mesh are the named edges.
    pub cells: Option<Arc<Mesh>>,
    /// Materials, by the index that cells have; one for a template.
    pub materials: Vec<Material>,
    /// What holds it, by the name of the edge.
    pub supports: BTreeMap<String, Support>,
    /// Name of the edge that touches the other body.
    pub contact: String,
    /// What acts on it by its mass, for a unit each.
    pub loads: Vec<BodyLoad>,
}

/// Where and how body 1 is loaded.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedEdge {
    /// Name of the edge.
    pub edge: String,
    /// How the load acts.
    pub kind: LoadKind,
    /// Part of the edge that a vertical load acts on; none for the whole.
    pub strip: Option<Strip>,
    /// Point [x, z] about which a rigid edge turns (mm).
    pub about: [f64; 2],
    /// Direction of a traction, from +x (rad); 0 of other loads.
    pub direction: f64,
    /// Whether a rigid edge is held against turning: a rotation prescribed as zero. Any other one is a motion like a free one.
    pub level: bool,
}

/// Part of an edge, along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Its middle (mm).
    pub centre: f64,
    /// Its width (mm).
    pub width: f64,
}

impl Strip {
    /// From and to along x (mm).
    pub fn ends(self) -> [f64; 2] {
        [self.centre - 0.5 * self.width, self.centre + 0.5 * self.width]
    }
}

impl Couple {
    /// Whether the bodies are solids of revolution.
    pub fn is_revolved(&self) -> bool {
        self.kinematics.is_revolved()
    }

    /// Whether the load acts through a rigid edge.
    pub fn has_rigid_edge(&self) -> bool {
        self.load.kind == LoadKind::Rigid
    }

    /// Whether a pin or a roller leaves body 1 one motion: the force of the load is then that of its actuator, whichever way it acts.
    pub fn moves_one_way(&self) -> bool {
        self.bodies[0].moves_one_way()
    }

    /// Young's modulus (MPa) of the softest material of both bodies, along its softest axis.
    pub fn softest(&self) -> f64 {
        let materials = self.bodies.iter().flat_map(|body| &body.materials);
        materials.flat_map(|material| material.young.each()).map(|young| young.0).fold(f64::INFINITY, f64::min)
    }
}

impl Body {
    /// Whether it is given by its cells.
    pub fn is_given(&self) -> bool {
        self.cells.is_some()
    }

    /// The materials in the words of the finite elements, by the index that cells have.
    ///
    /// # Errors
    /// A modulus or a ratio out of range.
    pub fn elastic(&self) -> Result<Vec<hpfem::Material>, hpfem::Error> {
        self.materials.iter().map(elastic).collect()
    }

    /// Isotropic materials that tell where cells have to be small: exponents of corners are known for them alone. Where some are orthotropic, first
    /// with the means in the plane, then with the first modulus and the second one by turns, so that one material in two directions is two.
    pub(crate) fn stand_ins(&self) -> Vec<impl Iterator<Item = Result<hpfem::Material, hpfem::Error>>> {
        let passes = if self.materials.iter().any(Material::is_orthotropic) { 2 } else { 1 };
        let stand_in = move |pass: usize, number: usize, material: &Material| {
            if !material.is_orthotropic() {
                return elastic(material);
            }
            let [mean, poisson] = material.in_plane();
            let young = if pass == 0 { mean } else { material.young.each()[number % 2].0 };
            hpfem::Material::isotropic(young, poisson.clamp(-0.9, 0.49))
        };
        let of_pass =
            move |pass| self.materials.iter().enumerate().map(move |(number, material)| stand_in(pass, number, material));
        (0..passes).map(of_pass).collect()
    }

    /// Whether an edge holds a component.
    pub fn holds(&self, component: Component) -> bool {
        self.supports.values().any(|held| held.holds(component))
    }

    /// Densities of its materials (t/mm^3), 0 where there is none.
    pub fn densities(&self) -> Vec<f64> {
        self.materials.iter().map(|material| material.density.map_or(0.0, |density| density.0)).collect()
    }

    /// Whether it has a pin or a roller.
    pub fn moves_one_way(&self) -> bool {
        self.supports.values().any(|support| matches!(support, Support::Pin(_) | Support::Roller(_)))
    }

    /// The edge that turns about a pin, and the pin (mm).
    pub fn pin(&self) -> Option<(&str, [f64; 2])> {
        self.supports.iter().find_map(|(edge, support)| match support {
            Support::Pin(at) => Some((edge.as_str(), at.map(|x| x.0))),
            Support::Components(_) | Support::Roller(_) => None,
        })
    }
}

/// A material in the words of the finite elements.
pub(crate) fn elastic(material: &Material) -> Result<hpfem::Material, hpfem::Error> {
    let (young, poisson) = (material.young.each().map(|young| young.0), material.poisson.each());
    let Some(shear) = material.shear.filter(|_| material.is_orthotropic()) else {
        return hpfem::Material::isotropic(young[0], poisson[0]);
    };
    let constants = hpfem::Orthotropic { young, poisson, shear: shear.each().map(|shear| shear.0) };
    hpfem::Material::orthotropic(constants, material.angle.map_or(0.0, |angle| angle.0))
}

impl LoadedEdge {
    /// Whether an edge of body 1 is the loaded one.
    pub fn is(&self, edge: &str) -> bool {
        self.edge == edge
    }
}
