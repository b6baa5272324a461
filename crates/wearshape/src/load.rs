//! What presses, shifts and turns body 1.

use contact::Turn;

/// What presses, shifts and turns body 1. Where it acts is said by [`meshing::LoadedEdge`].
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Load {
    /// Force that presses body 1 on body 2 (N); under a prescribed approach none until it is found.
    pub force: Option<f64>,
    /// Prescribed closing of a rigid edge (mm).
    pub approach: Option<f64>,
    /// Adds the worn approach of this time (s) to the prescribed one.
    pub approach_time: Option<f64>,
    /// Prescribed rotation of a rigid edge (rad), positive when the +x side closes.
    pub tilt: Option<f64>,
    /// Moment int (x - about_x) p dS (N mm).
    pub moment: f64,
    /// Moment int (y - about_y) p dS (N mm).
    pub moment_y: f64,
    /// The point the moments are about (mm).
    pub about: [f64; 2],
    /// Shear force on a rigid edge, applied after the normal force (N).
    pub shear_force: f64,
    /// What body 1 is turned by about the axis, step after step.
    pub turns: Vec<Turn>,
}
