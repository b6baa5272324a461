//! Frictional heat on one line of the screen.

use wearshape::{HeatResult, SpeedFactor};

use crate::brief::brief;

/// Where the heat goes, the highest temperatures, and the speed up to which there is one contact.
pub(crate) fn heat_line(heat: &HeatResult) -> String {
    let mut words = Vec::new();
    if heat.friction_power > 0.0 {
        words.push(format!("{} % of the friction into body 1", brief(100.0 * heat.into_body1 / heat.friction_power)));
    }
    for (number, highest) in [(1, heat.highest1), (2, heat.highest2)] {
        words.extend(highest.map(|highest| format!("body {number} at most {} degC", brief(highest))));
    }
    if let Some(SpeedFactor::At(factor)) = heat.critical_speed_factor {
        words.push(format!("critical speed {} times this one", brief(factor)));
    }
    format!("heat      {}", words.join(", "))
}
