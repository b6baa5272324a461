//! Frictional heat in the words of the summary.

use crate::steps::heat::following::Speeds;
use contact::SpeedFactors;
use serde::{Serialize, Serializer};

/// `summary.heat`.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct HeatResult {
    /// Power of friction.
    #[serde(rename = "friction_power_mW")]
    pub friction_power: f64,
    /// What of it goes into body 1.
    #[serde(rename = "into_body1_mW")]
    pub into_body1: f64,
    /// What of it goes into body 2.
    #[serde(rename = "into_body2_mW")]
    pub into_body2: f64,
    /// Heat that leaves through each edge (mW), by "body1.top".
    #[serde(serialize_with = "by_edge")]
    pub out: Vec<(String, f64)>,
    /// What of friction and prescribed fluxes does not leave through the edges, relative to it.
    pub balance: Option<f64>,
    /// Highest temperature of body 1, inside and on its surface.
    #[serde(rename = "T_max1_degC", skip_serializing_if = "Option::is_none")]
    pub highest1: Option<f64>,
    /// Place (x, z) of it.
    #[serde(rename = "T_max1_at_mm", skip_serializing_if = "Option::is_none")]
    pub highest1_at: Option<[f64; 2]>,
    /// Highest temperature of body 2; none of one that arrives fresh.
    #[serde(rename = "T_max2_degC", skip_serializing_if = "Option::is_none")]
    pub highest2: Option<f64>,
    /// Place (x, z) of it.
    #[serde(rename = "T_max2_at_mm", skip_serializing_if = "Option::is_none")]
    pub highest2_at: Option<[f64; 2]>,
    /// Factor on the sliding speed up to which a calculation that finds pressure and temperature by turns arrives.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub staggered_limit_speed_factor: Option<SpeedFactor>,
    /// Factor on the sliding speed at which surfaces without a gap separate somewhere; left out where heat flows without friction, which bends the bodies at
    /// any speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub separation_speed_factor: Option<SpeedFactor>,
    /// Factor on the sliding speed at which this contact is singular, and no longer unique near by. Others may carry the load before, far from it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub critical_speed_factor: Option<SpeedFactor>,
    /// How the temperature follows a run in time; none of what has no time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub in_time: Option<HeatInTime>,
    /// Times that the contact of a run in time jumped to another pressure by its heat; left out where it never did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub jumps: Option<usize>,
    /// The fastest growth of a deviation from a steady pressure (1/s), 0 where all of them wear off; none where that is not known.
    #[serde(skip)]
    pub growth: Option<f64>,
    /// Materials that are hotter than they bear.
    #[serde(skip)]
    pub too_hot: Vec<TooHot>,
    /// The contact that a shape has when it is brought to its speed cold, where that is another one than the wanted.
    #[serde(skip)]
    pub from_cold: Option<FromCold>,
}

/// A contact that grows from that of the cold bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FromCold {
    /// It carries the load at the sliding speed.
    Carries {
        /// Its largest pressure (MPa).
        largest: f64,
        /// Arc lengths between which it lies (mm).
        ends: [f64; 2],
    },
    /// It is lost before.
    Lost,
}

/// How the temperature follows a run in time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum HeatInTime {
    /// Heat passes through the bodies fast against wear: at each moment the temperature is the steady one of the pressure at that moment.
    QuasiSteady,
}

/// A material that is hotter than it bears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TooHot {
    /// Number of its body, 1 or 2.
    pub body: usize,
    /// Its highest temperature (degC).
    pub temperature: f64,
    /// The one that it bears (degC).
    pub limit: f64,
}

/// A factor on the sliding speed, or "none" where there is no such speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SpeedFactor {
    /// The factor.
    At(f64),
    /// There is none.
    None,
}

impl Serialize for SpeedFactor {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            SpeedFactor::At(factor) => serializer.serialize_f64(*factor),
            SpeedFactor::None => serializer.serialize_str("none"),
        }
    }
}

/// Largest relative difference of a factor on two meshes. Those of the meshes move with the distance of points, which from one degree to the next is 1.14
/// (16 after 14) to 1.5 times as small inside a cell and the square of that at its ends; those of the contact differed by up to .09 on degrees 6 to 10 of
/// `drum-brake-hot`.
pub(crate) const MESHES_ALIKE: f64 = 0.1;
/// The same by all heat and by what of it is smooth, on one mesh.
pub(crate) const HEAT_ALIKE: f64 = 0.01;

impl HeatResult {
    /// Takes in the factors on the sliding speed. Of those at which the contact is singular it is the least that another mesh has as well, or heat that is
    /// smooth along the surface, alike to the second of `other`; without either nothing is said of them.
    pub(crate) fn take_speeds(&mut self, Speeds { factors: found, separation }: &Speeds, other: Option<(&SpeedFactors, f64)>) {
        let factor = |found: Option<f64>| Some(found.map_or(SpeedFactor::None, SpeedFactor::At));
        self.staggered_limit_speed_factor = factor(found.staggered);
        self.separation_speed_factor = separation.and_then(factor);
        if other.is_none() && !found.singular.is_empty() {
            return;
        }
        let (others, apart) = other.map_or((&[][..], 0.0), |(other, apart)| (&other.singular, apart));
        let alike = |s: &&f64| others.iter().any(|t| (*s - t).abs() <= apart * t.abs());
        self.critical_speed_factor = factor(found.singular.iter().find(alike).copied());
    }

    /// Why there is no answer beyond the critical speed.
    pub(crate) fn beyond_critical(&self) -> Option<String> {
        let Some(SpeedFactor::At(factor)) = self.critical_speed_factor.filter(|f| matches!(f, SpeedFactor::At(f) if *f < 1.0))
        else {
            return None;
        };
        let factor = scene::short(factor);
        let what = "the sliding speed is beyond the critical one of its frictional heat";
        Some(format!("{what}, {factor} times it: pressure and temperature are no longer unique"))
    }
}

fn by_edge<S: Serializer>(edges: &[(String, f64)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(edges.iter().map(|(edge, heat)| (edge, heat)))
}
