//! What was computed: plain data, one struct a stage, the profile at the contact points, counters and times.

use hpfem::CellGrid;
use serde::Serialize;

use crate::body_field::FieldFrame;
use crate::brake::BrakeResult;
use crate::effort::Effort;
use crate::heat_result::HeatResult;
use crate::machined::Machined;
use crate::machining_result::MachiningResult;
use crate::path_profile::PathProfile;
use crate::profile::Profile;
use crate::remark::Remark;
use crate::results::{
    ContactResult, EnergyResult, ErrorResult, InterfaceResult, PressureResult, Reaction, ShapeResult, WearResult,
};
use crate::reversing_result::ReversingResult;
use crate::watch::Resume;

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// Everything asked for was computed.
    #[default]
    Ok,
    /// Computed, with an estimated error above the accuracy asked for.
    AccuracyMissed,
    /// An iteration did not arrive.
    NotConverged,
    /// The scene has no answer.
    Refused,
    /// The user asked to stop; the partial folder is kept.
    Interrupted,
}

/// Everything a run knows when it is done. A stage that did not run is `None`.
#[derive(Debug, Clone, Default)]
pub struct Solution {
    /// How it ended.
    pub status: Status,
    /// Why, when it did not end well: one sentence.
    pub reason: Option<String>,
    /// Whether it ended with a pressure that is none, so that nothing of the bodies was computed.
    pub without_pressure: bool,
    /// The optimal pressure.
    pub pressure: Option<PressureResult>,
    /// Both senses of a reversing motion.
    pub reversing: Option<ReversingResult>,
    /// The surface as it is now against as machined, of a scene that asks for contact and shape.
    pub machining: Option<MachiningResult>,
    /// Columns of the surface as it is now, for the picture beside those as machined.
    pub unmachined: Option<Profile>,
    /// The surface as machined, where wear in time goes on from another.
    pub as_machined: Option<AsMachined>,
    /// The contact of the bodies as given.
    pub contact: Option<ContactResult>,
    /// The shape.
    pub shape: Option<ShapeResult>,
    /// Wear in time.
    pub wear: Option<WearResult>,
    /// Strain energies.
    pub energy: Option<EnergyResult>,
    /// Reaction of each supported edge and of a rigid one, by "body1.left".
    pub reactions: Vec<(String, Reaction)>,
    /// Body 1 as a brake under the pressure of the last task, where a pin or a roller guides it.
    pub brake: Option<BrakeResult>,
    /// Frictional heat of the last task that has it.
    pub heat: Option<HeatResult>,
    /// Estimated errors.
    pub error: Option<ErrorResult>,
    /// Condition of the system on the contact surface.
    pub interface: Option<InterfaceResult>,
    /// Columns at the contact points, of the last task.
    pub profile: Option<Profile>,
    /// The same at evenly spaced points of a surface known without a mesh, for pictures.
    pub curve: Option<Profile>,
    /// The pressure over a surface of two dimensions, for a picture.
    pub map: Option<PressureMap>,
    /// Columns of history.csv: name and values.
    pub history: Vec<(String, Vec<f64>)>,
    /// Columns of groove.csv, of a ball on a revolving disc: name and values.
    pub groove: Vec<(String, Vec<f64>)>,
    /// Pressure and gap of a run in time, step by step.
    pub running_in: Option<RunningIn>,
    /// The levels of the last task that has any.
    pub ladder: Vec<Rung>,
    /// The surface to machine, of a shape.
    pub machined: Option<Machined>,
    /// Displacement and stress inside the bodies, the reported moment first; empty unless an output asks for them.
    pub fields: Vec<FieldFrame>,
    /// The same along lines, at the reported moment.
    pub paths: Vec<PathProfile>,
    /// Remarks that only the result could tell.
    pub remarks: Vec<Remark>,
    /// What it took.
    pub effort: Effort,
    /// An unfinished run in time that was stopped, to go on with.
    pub resume: Option<Resume>,
}

/// What a shape gives the bodies, beside what a run in time ends with.
#[derive(Debug, Clone, PartialEq)]
pub struct AsMachined {
    /// Columns at evenly spaced points of the surface.
    pub curve: Profile,
    /// Body 1 as a brake.
    pub brake: Option<BrakeResult>,
}

/// The pressure over a surface of two dimensions, on a grid of points that covers it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PressureMap {
    /// Where the points are in the grid.
    pub grid: CellGrid,
    /// Places (x, y), mm.
    pub position: Vec<[f64; 2]>,
    /// Pressure (MPa).
    pub pressure: Vec<f64>,
}

/// What a level of the ladder says about the error.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Rung {
    /// What is compared: gap or pressure.
    pub quantity: &'static str,
    /// Degree of the level.
    pub degree: usize,
    /// Relative difference from the level before.
    pub change: Option<f64>,
    /// Estimated relative error, from this level and the two before it.
    pub estimate: Option<f64>,
}

/// Pressure and gap of a run in time at the contact points.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunningIn {
    /// Surface coordinate of the points (mm).
    pub s: Vec<f64>,
    /// The steps.
    pub steps: Vec<RunningInStep>,
}

/// One step of a run in time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunningInStep {
    /// Number of the step.
    pub step: usize,
    /// Time (s).
    pub time: f64,
    /// Pressure at the points (MPa); NaN at one that has closed within the step with more than all that pressed before.
    pub pressure: Vec<f64>,
    /// Unloaded gap at the points (um).
    pub gap: Vec<f64>,
}
