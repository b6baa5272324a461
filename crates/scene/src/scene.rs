//! The scene file as written: keys and their types, no meaning yet. Optional keys get their defaults in `setup`.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::geometry::{Geometry, SurfaceShape};
use crate::heat::{EdgeHeat, Heat};
use crate::layer::Layer;
use crate::material::Material;
use crate::spin::Spin;
use crate::support::Support;
use crate::units::{Acceleration, AngularSpeed, Force, Length, Moment, Pair, Pressure, Speed, Time, WearFactor};
use crate::wear_function::WearFunction;

pub use crate::counterface::Counterface;
pub use crate::optimum::{Balance, Functional, Modes, Optimum};
pub use crate::output::{FieldPath, Output};

/// A wear scene: two bodies (or a surface alone), their load and sliding, the wear rule, and what is wanted.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(transform = crate::schema::mesh_or_accuracy))]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Scene {
    /// One line for reports.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Units of bare numbers.
    pub units: Units,
    /// Plane stress, plane strain, or axisymmetric.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kinematics: Option<Kinematics>,
    /// Thickness out of the plane (mm); axisymmetric scenes have none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub thickness: Option<Length>,
    /// What to compute. Default: pressure and shape; a surface alone: pressure.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minItems" = 1)))]
    pub tasks: Option<Vec<Task>>,
    /// Wanted relative accuracy of the answer; the mesh follows from it. Default 1e-6.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 1e-13, "maximum" = 0.5)))]
    pub accuracy: Option<f64>,
    /// A fixed discretisation instead of an accuracy.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<Mesh>,
    /// Whether the shape is proved by a contact solve on it. Default true.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub check: Option<bool>,
    /// The shaped body: shoe, punch, pad.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body1: Option<Body>,
    /// The counter-face: drum, plate, disc.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body2: Option<Body>,
    /// A contact surface without bodies, for the pressure alone; instead of body1 and body2.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface: Option<SurfaceShape>,
    /// The contact between the bodies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact: Option<Contact>,
    /// How body 2 slides.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sliding: Option<Sliding>,
    /// The load on body 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub load: Option<Load>,
    /// The wear rule of both bodies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wear: Option<Wear>,
    /// Load and speed that change in a run in time; without it they stay as given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub schedule: Option<Schedule>,
    /// Frictional heat and the thermal distortion of the bodies; without it nothing of this is computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<Heat>,
    /// Which pressure is wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub optimum: Option<Optimum>,
    /// Which of the larger files are written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<Output>,
}

/// Units of bare numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Units {
    /// N, mm, MPa, s, rad.
    #[serde(rename = "N-mm")]
    NewtonMillimetre,
}

/// Kinematics of both bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Kinematics {
    /// Thin in y: sigma_y = 0.
    PlaneStress,
    /// Long in y: eps_y = 0.
    PlaneStrain,
    /// x is r, z the axis; forces for the full turn.
    Axisymmetric,
}

/// One thing to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Task {
    /// The optimal or steady pressure.
    Pressure,
    /// The contact of the bodies as given.
    Contact,
    /// The shape that has the pressure.
    Shape,
    /// Wear in time.
    Wear,
}

/// A fixed discretisation.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// Polynomial degree.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 1, "maximum" = 24)))]
    pub degree: Option<usize>,
    /// Layers of cells graded towards each singular point.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("maximum" = 60)))]
    pub layers: Option<usize>,
}

/// One body.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Linear isotropic material; with `geometry.blocks` the default of all blocks.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<Material>,
    /// Shape with named edges.
    pub geometry: Geometry,
    /// What holds named edges: a list of components, { pin = [x, z] }, or { roller = angle }.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub support: BTreeMap<String, Support>,
    /// How fast the body spins; without it it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spin: Option<Spin>,
    /// Force by mass on the body, [g_x, g_z] (mm/s^2): gravity, or the opposite of its acceleration. Its materials need a density. The weight of body 2 is
    /// carried by its supports, that of body 1 by the loaded edge, evenly beside the load, so that `load.force` stays what presses the surfaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gravity: Option<[Acceleration; 2]>,
    /// What of body 1 may wear off: a thickness (mm), as `wear.wearable`, which a surface without bodies has, or the layer of its material at the contact, by
    /// name, as far as it goes where it is thinnest. Body 2 has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub wearable: Option<Layer>,
    /// What carries heat through named edges, in a scene with `heat`; all others are insulated.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub heat: BTreeMap<String, EdgeHeat>,
}

/// The contact.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// Contact edge of body 1 and of body 2.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edges: Option<[String; 2]>,
    /// Coefficient of friction. Default 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0)))]
    pub friction: Option<f64>,
    /// Whether the friction shear acts on the bodies and in the balance. Default true.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shear: Option<bool>,
    /// Unloaded gap at the start: 0, a CSV file with the columns s_mm, gap_um, the columns themselves, or a sum of a crown, a tilt, a cosine and
    /// a profile.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<crate::gap::Gap>,
    /// Radial clearance of a shaft in its housing whose arcs are drawn with one radius: that of the hole less that of the shaft.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0)))]
    pub clearance: Option<Length>,
    /// Roughness of the machined surface (mm): a shape that differs by less from the surface as it is is not worth machining.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub roughness: Option<Length>,
}

/// Motion of body 2.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Sliding {
    /// Angular speed about its centre, anti-clockwise positive (rad/s).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub omega: Option<AngularSpeed>,
    /// Speed along +x (mm/s).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<Speed>,
    /// Radius of the track of a ball on a revolving disc (mm), on which `speed` is `omega` times it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub track_radius: Option<Length>,
    /// Motion that reverses, in cycles short against wear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reversing: Option<crate::reversing::Reversing>,
    /// Stroke and frequency of a motion to and fro, instead of `speed`; friction makes it a reversing one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle: Option<crate::reversing::Cycle>,
}

/// How the load is applied.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum LoadKind {
    /// Uniform pressure along the inward normal.
    Pressure,
    /// Vertical, uniform per projected length.
    Vertical,
    /// The edge moves as a rigid line.
    Rigid,
    /// Uniform traction along `load.direction`, on a body 1 that turns about a pin or runs on a roller.
    Traction,
}

/// The load on body 1.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Load {
    /// The loaded edge of body 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edge: Option<String>,
    /// How: pressure, vertical, rigid, traction.
    #[serde(rename = "as", skip_serializing_if = "Option::is_none")]
    pub kind: Option<LoadKind>,
    /// Resultant force that presses body 1 on body 2 (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<Force>,
    /// Direction of a traction: its angle from +x, anti-clockwise (rad).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<crate::units::Angle>,
    /// Prescribed closing of a rigid edge (mm), instead of a force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub approach: Option<Length>,
    /// Moment int (x - about_x) p dS of the contact pressure (N mm). On a body 1 that turns about a pin: the moment about it, anti-clockwise
    /// positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<Moment>,
    /// Moment int (y - about_y) p dS of the contact pressure (N mm), for surfaces of two dimensions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment_y: Option<Moment>,
    /// The point the moment is about: [x, z].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub about: Option<[Length; 2]>,
    /// Prescribed rotation of a rigid edge (rad), positive when the +x side closes, instead of a moment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tilt: Option<crate::units::Angle>,
    /// Adds the worn approach of this time (s) to the prescribed one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub approach_time: Option<Time>,
    /// Width of a vertical load along x (mm); without it the whole projected edge.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub width: Option<Length>,
    /// Middle of a vertical load along x (mm). Default 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<Length>,
    /// Shear force on a rigid edge, applied after the normal force (N).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shear_force: Option<Force>,
    /// Axisymmetric contact: rotation (rad) of the edge on which body 1 is held against turning, after the normal force, with stick
    /// and slip; a list turns it to one angle after the other. Anti-clockwise positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub twist: Option<crate::units::Steps<crate::units::Angle>>,
    /// The torque (N mm) instead of the rotation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque: Option<crate::units::Steps<Moment>>,
}

/// Wear rule w' = beta (mu p)^b v^a, or w' = k p^b v^a, of each body.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Wear {
    /// Wear factor in front of the friction stress; one number means body 1 alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0)))]
    pub beta: Option<Pair<WearFactor>>,
    /// Archard's wear factor in front of the pressure, instead of beta; one number means body 1 alone.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0)))]
    pub k: Option<Pair<WearFactor>>,
    /// Exponent of the sliding speed. Default 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0)))]
    pub a: Option<Pair<f64>>,
    /// Exponent of the pressure. Default 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub b: Option<Pair<f64>>,
    /// Threshold pressure p0: nothing wears up to it, and above it the excess p - p0 stands in place of the pressure. Default 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0)))]
    pub threshold: Option<Pair<Pressure>>,
    /// Measured wear factors k of body 1 instead of beta and k: pairs of a pressure and the factor at it, w' = k(p) p v. Between them k p follows
    /// the monotone cubic, beyond the last its straight line; body 2 does not wear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub table: Option<Vec<(Pressure, WearFactor)>>,
    /// Wear of body 1 by a function of the pressure instead of beta and k, w' = W(p) v. Body 2 does not wear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub law: Option<WearFunction>,
    /// How the counter-face meets body 1. Default by kind of scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub counterface: Option<Counterface>,
    /// Where the run in time ends: "steady", a time, `{ distance = "2 km" }`, `{ revolutions = 1e5 }`, or what is worn off:
    /// `{ depth = "50 um" }` of body 1, `{ volume = "2 mm^3" }` of both. Default "steady".
    #[serde(skip_serializing_if = "Option::is_none")]
    pub until: Option<crate::gap::Until>,
    /// Thickness of body 1 that may wear off (mm): its life follows from the steady wear. `body1.wearable` says the same.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub wearable: Option<Length>,
    /// Relative spread of the wear factor, from 0 to less than 1: that of the life follows.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 0, "exclusiveMaximum" = 1)))]
    pub spread: Option<f64>,
}

impl Wear {
    /// Whether body 1 wears by a function of the pressure, a table or a law, and body 2 does not.
    pub fn is_function(&self) -> bool {
        self.table.is_some() || self.law.is_some()
    }

    /// Which bodies wear: those with a function of the pressure or a factor above 0.
    pub fn wearing(&self) -> [bool; 2] {
        if self.is_function() {
            return [true, false];
        }
        match self.beta.or(self.k) {
            Some(Pair::Two(factors)) => factors.map(|factor| factor.value > 0.0),
            Some(Pair::One(factor)) => [factor.value > 0.0, false],
            None => [false; 2],
        }
    }

    /// Whether something says how the bodies wear: a function of the pressure, or a factor, be it 0.
    pub fn has_rule(&self) -> bool {
        self.is_function() || self.beta.or(self.k).is_some()
    }
}

/// A run in time in pieces: each begins at its time and lasts until the next one, the last until the run ends, or until `period` where they
/// `repeat`. The lists hold one number a piece, a factor on what `load` and `sliding` give; a list that is left out is 1 throughout.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Schedule {
    /// Times at which the pieces begin (s); the first is 0, and they increase.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time: Option<Vec<Time>>,
    /// Factors on load.force, greater than 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<Vec<f64>>,
    /// Factors on load.moment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<Vec<f64>>,
    /// Factors on sliding.speed or sliding.omega, other than 0; negative ones slide the other way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<Vec<f64>>,
    /// Number of times that all pieces are run through, one cycle after the other; the run ends with the last. With sliding.reversing a cycle is once
    /// forward and once backward, and needs no other list.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("minimum" = 1)))]
    pub repeat: Option<f64>,
    /// How long a cycle lasts (s): the end of its last piece.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub period: Option<Time>,
}
