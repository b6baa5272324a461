//! The only way out of a solve while it goes, and the only way to stop it: a closure that is told what happens, on the caller's thread, between
//! levels and between steps in time. One factorisation is not interruptible.

use std::ops::ControlFlow;

use scene::Fault;
use serde::{Deserialize, Serialize};
use shapeopt::WearState;

use crate::profile::Profile;
use crate::step::Step;

/// Something that happened.
pub enum Event<'a> {
    /// A level of discretisation begins.
    Level {
        /// The stage that climbs.
        step: Step,
        /// Degree of the cells.
        degree: usize,
        /// Layers around each singular point.
        layers: usize,
        /// Levels expected after this one, about: from the errors so far, once three levels tell them.
        left: usize,
    },
    /// A run in time begins a level, or goes on with one.
    Run(&'a RunLevel<'a>),
    /// A run in time has made a step.
    WearStep(&'a WearStep<'a>),
}

/// Told of every event; `Break` stops after what is finished.
pub type Watch<'w> = dyn FnMut(Event<'_>) -> ControlFlow<()> + 'w;

/// The beginning of a run in time on one level.
pub struct RunLevel<'a> {
    /// The levels before.
    pub finished: &'a [FinishedLevel],
    /// Steps that a resumed run has already; 0 for one from the start.
    pub known_steps: usize,
    /// The level in a sentence.
    pub message: String,
    /// The edges of the meshes of both bodies, two points (x, z) in mm a line; meshed again at each call.
    pub lines: &'a dyn Fn() -> Result<[Vec<[f64; 2]>; 2], Fault>,
}

/// An accepted step in time.
pub struct WearStep<'a> {
    /// Where the run is.
    pub state: &'a WearState,
    /// Steps tried, the accepted one included.
    pub tries: usize,
    /// Linear systems solved.
    pub linear_solves: usize,
    /// How far the run is, from 0 to 1, about.
    pub share: f64,
    /// The columns at the contact points; pressures that are none of the surface, of points that have closed within the step with more than all that
    /// pressed before, are NaN.
    pub profile: &'a dyn Fn() -> Profile,
}

/// What a finished level of a run in time leaves behind: all that the levels after it need.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct FinishedLevel {
    /// Degree of the cells.
    pub degree: usize,
    /// Layers around each singular point.
    pub layers: usize,
    /// Worn gap at points along the surface, of all levels the same.
    #[serde(rename = "gap_mm")]
    pub gap: Vec<f64>,
    /// Closing of each rigid mode there, point by point.
    pub closing: Vec<f64>,
    /// The largest displacement at its end, or the depth worn off if that is larger: a gap that is its round-off is none.
    #[serde(rename = "moved_mm", default)]
    pub moved: f64,
    /// Time at its end.
    #[serde(rename = "time_s")]
    pub time: f64,
    /// Depth at its end.
    #[serde(rename = "depth_mm", default)]
    pub depth: f64,
    /// Volumes worn off both bodies at its end.
    #[serde(rename = "volumes_mm3", default)]
    pub volumes: [f64; 2],
    /// Time until the pressure stayed within 1 % of the steady one, if it did.
    #[serde(rename = "to_1_percent_s", default)]
    pub to_1_percent: Option<f64>,
    /// What the steps in time leave wrong in that time and the depth then, or in the depth at the end: relative. Found on the first level.
    #[serde(default)]
    pub integration_error: Option<f64>,
    /// Whether part of the surface was open at some time.
    #[serde(default)]
    pub partial: bool,
    /// Ends of contact inside the surface at its end, from -1 to 1 along it, of a run that ends on its way to no known place.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ends: Vec<f64>,
    /// Places that the ends of a contact between round bodies passed, to where they are at its end, from -1 to 1 along the surface.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub passed: Vec<f64>,
    /// Factors on the sliding speed at which the contact at its end is singular, with frictional heat alone.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub singular: Vec<f64>,
    /// Steps taken.
    pub wear_steps: usize,
    /// Factorisations.
    pub factorisations: usize,
    /// Contact solves.
    pub contact_solves: usize,
}

/// An unfinished run in time, to go on with bit for bit.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Resume {
    /// The finished levels.
    pub finished: Vec<FinishedLevel>,
    /// States of the level after them, step by step. Only the last one must be whole; of the others step, time, sizes, volumes, gap, pressure, worn depth
    /// and interval are used.
    pub states: Vec<WearState>,
}
