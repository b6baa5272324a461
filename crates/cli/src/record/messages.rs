//! The messages of a recording. Numbers that are not available are absent.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wearshape::Profile;

/// `/contact/profile`: the contact points at a time.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Points {
    /// Number of the step.
    pub(crate) step: u64,
    /// Simulated time.
    #[serde(rename = "time_s")]
    pub(crate) time: f64,
    /// The points in order along the surface.
    pub(crate) points: Vec<Point>,
}

/// One contact point.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Point {
    /// Arc length from the middle, or r.
    #[serde(rename = "s_mm")]
    pub(crate) s: f64,
    /// Place along x, or r.
    #[serde(rename = "x_mm")]
    pub(crate) x: f64,
    /// Place along z.
    #[serde(rename = "z_mm")]
    pub(crate) z: f64,
    /// Pressure; left out where it is none of the surface: at a point that has closed within the step with more than all that pressed before.
    #[serde(rename = "pressure_MPa", skip_serializing_if = "Option::is_none")]
    pub(crate) pressure: Option<f64>,
    /// Shear on body 1 along tau.
    #[serde(rename = "shear_MPa", skip_serializing_if = "Option::is_none")]
    pub(crate) shear: Option<f64>,
    /// Unloaded gap.
    #[serde(rename = "gap_um", skip_serializing_if = "Option::is_none")]
    pub(crate) gap: Option<f64>,
    /// Gap under load.
    #[serde(rename = "opening_um", skip_serializing_if = "Option::is_none")]
    pub(crate) opening: Option<f64>,
    /// Wear rate of both bodies.
    #[serde(rename = "wear_rate_um_per_s", skip_serializing_if = "Option::is_none")]
    pub(crate) wear_rate: Option<f64>,
}

impl Points {
    /// The points of a profile.
    pub(crate) fn new(step: u64, time: f64, profile: &Profile) -> Points {
        let known = |value: f64| Some(value).filter(|value| value.is_finite());
        let point = |row: usize| Point {
            s: profile.s[row],
            x: profile.position[row][0],
            z: profile.position[row][2],
            pressure: known(profile.pressure[row]),
            shear: known(profile.shear[row]),
            gap: known(profile.gap[row]),
            opening: known(profile.opening[row]),
            wear_rate: known(profile.wear_rate[row]),
        };
        Points { step, time, points: (0..profile.s.len()).map(point).collect() }
    }
}

/// `/iteration`: the work that a step of a run in time took.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Iteration {
    /// Number of the step.
    pub(crate) step: u64,
    /// Steps tried, the accepted one included.
    pub(crate) tries: u64,
    /// Linear systems solved.
    pub(crate) linear_solves: u64,
    /// Length of the accepted step.
    #[serde(rename = "step_s")]
    pub(crate) step_size: f64,
    /// Its estimated error.
    pub(crate) error: f64,
    /// How far the wear is from a rigid motion.
    pub(crate) steady_residual: f64,
}

/// `/log`: a sentence, in the words of foxglove.Log.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Log {
    /// Simulated time.
    pub(crate) timestamp: Timestamp,
    /// 2 is information, 3 a warning, 4 an error.
    pub(crate) level: u8,
    /// The sentence.
    pub(crate) message: String,
    /// Who says it.
    pub(crate) name: String,
    /// Empty.
    pub(crate) file: String,
    /// Zero.
    pub(crate) line: u32,
}

/// A time in foxglove's words.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Timestamp {
    /// Whole seconds.
    pub(crate) sec: u32,
    /// The rest.
    pub(crate) nsec: u32,
}

impl Log {
    /// An informing sentence at a simulated time in ns.
    pub(crate) fn new(time: u64, message: &str) -> Log {
        let timestamp =
            Timestamp { sec: (time / 1_000_000_000).min(u64::from(u32::MAX)) as u32, nsec: (time % 1_000_000_000) as u32 };
        Log { timestamp, level: 2, message: message.into(), name: "wearshape".into(), ..Log::default() }
    }
}
