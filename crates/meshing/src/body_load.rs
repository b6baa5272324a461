//! What acts on a body as a whole, by its mass: one variant a load, with its key, its factor and its force.
//!
//! A body carries each for a unit, so that a sweep in their strength factors it once. They strain the bodies before they are pressed on each other.
//! What can be wrong with them is in `sound_body_load.rs`.

use hpfem::{BodyForce, LoadCase};

/// A load of a body by its mass, for a unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BodyLoad {
    /// The centrifugal force at 1 rad/s about a point [x, z] (mm), the centre of mass; any one of a body of revolution.
    Spin([f64; 2]),
    /// The weight under a gravity of 1 mm/s^2 along x (0) or z (1).
    Gravity(usize),
}

/// Keys of a scene that say the loads of its bodies.
pub const BODY_LOAD_KEYS: [&str; 4] = ["body1.spin", "body2.spin", "body1.gravity", "body2.gravity"];

impl BodyLoad {
    /// The loads that a body of the scene asks for, with their factors.
    pub fn of(body: &scene::Body) -> Vec<(BodyLoad, f64)> {
        let spin = body.spin.map(|spin| {
            let centre = spin.centre.map_or([0.0; 2], |centre| centre.map(|x| x.0));
            (BodyLoad::Spin(centre), spin.omega.0 * spin.omega.0)
        });
        let gravity = body.gravity.iter().flat_map(|g| [0, 1].map(|along| (BodyLoad::Gravity(along), g[along].0)));
        spin.into_iter().chain(gravity).collect()
    }

    /// Its key below that of the body.
    pub fn key(&self) -> &'static str {
        match self {
            BodyLoad::Spin(_) => "spin",
            BodyLoad::Gravity(_) => "gravity",
        }
    }

    /// What a body does that has it, where that is refused: "the contact .. does not know ".
    pub(crate) fn word(&self) -> &'static str {
        match self {
            BodyLoad::Spin(_) => "bodies that spin",
            BodyLoad::Gravity(_) => "the weight of bodies",
        }
    }

    /// Whether it has a resultant that something must carry. One without is in balance by itself.
    pub fn has_resultant(&self) -> bool {
        match self {
            BodyLoad::Spin(_) => false,
            BodyLoad::Gravity(_) => true,
        }
    }

    /// What acts on a mass at a point [x, z] (mm), in N/t; `revolved` is a body of revolution.
    pub fn at(&self, [x, z]: [f64; 2], revolved: bool) -> [f64; 2] {
        let plane = if revolved { 0.0 } else { 1.0 };
        match *self {
            BodyLoad::Spin(about) => [x - plane * about[0], plane * (z - about[1])],
            BodyLoad::Gravity(0) => [plane, 0.0],
            BodyLoad::Gravity(_) => [0.0, 1.0],
        }
    }

    /// Its load case on a body whose materials have these densities (t/mm^3).
    pub fn case(self, densities: &[f64], revolved: bool) -> LoadCase {
        let name = match self {
            BodyLoad::Spin(_) => "spin",
            BodyLoad::Gravity(0) => "gravity x",
            BodyLoad::Gravity(_) => "gravity z",
        };
        LoadCase::new(name).with(BodyForce::new(move |x| self.at(x, revolved)).by_material(densities))
    }
}
