//! A shoe on a pin or a roller as a brake, in one line of the first screen.

use wearshape::{BrakeResult, Sense};

use crate::brief::brief;

/// Leading or trailing, what the actuator makes, and how far it is from locking.
///
/// A worn-in pressure of a pinned shoe is the same at any friction; another one, unless `steady`, changes as locking comes near.
pub(crate) fn brake_line(brake: &BrakeResult, steady: bool) -> String {
    let shoe = match brake.shoe {
        Sense::Leading => "leading",
        Sense::Trailing => "trailing",
        Sense::Neutral => "neither leading nor trailing",
    };
    let by = match (brake.actuator, brake.moment) {
        (Some(force), _) => format!(" from {} N", brief(force)),
        (None, Some(moment)) => format!(" from {} N m about the pin", brief(1e-3 * moment)),
        (None, None) => String::new(),
    };
    let made = match brake.torque {
        Some(torque) => format!("torque {} N m{by}", brief(1e-3 * torque)),
        None => format!("friction {} N{by}", brief(brake.friction_force)),
    };
    let mut words = vec![format!("{shoe}: {made}")];
    words.extend(brake.brake_factor.map(|factor| format!("brake factor {}", brief(factor))));
    words.extend(brake.locks_at_friction.map(|at| {
        let times = brake.lock_reserve.map(|times| format!(", {} times this one", brief(times))).unwrap_or_default();
        let so = if steady { "" } else { " if the pressure stayed as it is" };
        format!("locks at friction {}{times}{so}", brief(at))
    }));
    format!("brake     {}", words.join(", "))
}

/// The same of both senses of a reversing motion.
pub(crate) fn both_ways([forward, back]: [&BrakeResult; 2]) -> String {
    let told = |brake: &BrakeResult| brake_line(brake, false).trim_start_matches("brake").trim_start().to_string();
    format!("brake     forward {}; backward {}", told(forward), told(back))
}
