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
    pub(crate) time_s: f64,
    /// The points in order along the surface.
    pub(crate) points: Vec<Point>,
}

/// One contact point.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[allow(non_snake_case)]
pub(crate) struct Point {
    /// Arc length from the middle, or r.
    pub(crate) s_mm: f64,
    /// Place along x, or r.
    pub(crate) x_mm: f64,
    /// Place along z.
    pub(crate) z_mm: f64,
    /// Pressure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) pressure_MPa: Option<f64>,
    /// Shear on body 1 along tau.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) shear_MPa: Option<f64>,
    /// Unloaded gap.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) gap_um: Option<f64>,
    /// Gap under load.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) opening_um: Option<f64>,
    /// Wear rate of both bodies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) wear_rate_um_per_s: Option<f64>,
}

impl Points {
    /// The points of a profile.
    pub(crate) fn new(step: u64, time_s: f64, profile: &Profile) -> Points {
        let known = |value: f64| Some(value).filter(|value| value.is_finite());
        let point = |row: usize| Point {
            s_mm: profile.s[row],
            x_mm: profile.position[row][0],
            z_mm: profile.position[row][2],
            pressure_MPa: known(profile.pressure[row]),
            shear_MPa: known(profile.shear[row]),
            gap_um: known(profile.gap[row]),
            opening_um: known(profile.opening[row]),
            wear_rate_um_per_s: known(profile.wear_rate[row]),
        };
        Points { step, time_s, points: (0..profile.s.len()).map(point).collect() }
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
    pub(crate) step_s: f64,
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
