//! The keys of the summary in words, with their units.

use wearshape::Problem;

/// Words for keys that do not say enough themselves, by the end of the dotted key.
const WORDS: &[(&str, &str)] = &[
    ("shape.iterations", "passes of the shape iteration"),
    ("shape.gap_max_um", "most taken off"),
    ("shape.gap_where_mm", "there, along the surface from its middle"),
    ("shape.gap_least_where_mm", "where nothing, or least, is taken off"),
    ("shape.crown_um", "most above least taken off"),
    ("shape.rigid_mm", "rigid motion in the gap"),
    ("shape.rigid_rad", "turn of body 1 in the gap"),
    ("shape.roundtrip_same", "proof on the same mesh: pressure off by, relative"),
    ("shape.roundtrip_independent", "proof on another mesh: pressure off by, relative"),
    ("pressure.functional", "what the pressure is best for"),
    ("pressure.q", "control parameter q"),
    ("pressure.balance", "balance of forces"),
    ("pressure.modes", "rigid motions used"),
    ("pressure.s", "exponent s of the theory"),
    ("pressure.k", "exponent k of the theory"),
    ("pressure.character", "kind of extremum"),
    ("pressure.regime", "kind of pressure"),
    ("pressure.feed.force", "how fast body 1 sinks as it wears, mm/s"),
    ("pressure.feed.side_force", "how fast body 1 shifts along x as it wears, mm/s"),
    ("pressure.feed.moment", "how fast body 1 turns as it wears, rad/s"),
    ("pressure.feed.moment_y", "how fast body 1 turns about the other axis as it wears, rad/s"),
    ("pressure.multipliers.force", "multiplier of the force (mm/s for the worn-in pressure)"),
    ("pressure.multipliers.side_force", "multiplier of the side force (mm/s for the worn-in pressure)"),
    ("pressure.multipliers.moment", "multiplier of the moment (rad/s for the worn-in pressure)"),
    ("pressure.multipliers.moment_y", "multiplier of the second moment (rad/s for the worn-in pressure)"),
    ("pressure.p_max_at_mm", "place of the largest pressure (x, y, z)"),
    ("pressure.normal_force_N", "sum of the normal pressure"),
    ("pressure.wear_depth_um_per_h", "mean depth worn off both bodies in an hour"),
    ("pressure.wear_depth_mm_per_1000_km", "mean depth worn off both bodies in 1000 km of sliding"),
    ("pressure.life.time_h", "life of what may wear off body 1"),
    ("pressure.life.distance_km", "sliding distance until then"),
    ("pressure.life.revolutions", "turns until then"),
    ("pressure.life.cycles", "cycles until then"),
    ("pressure.life.friction_work_MJ", "work of friction until then"),
    ("pressure.life.time_between_h", "shortest and longest life by the wear factor"),
    ("pressure.steadiness_residual", "how far the wear is from a rigid motion, relative"),
    ("pressure.congruence_residual", "how far the wear of both bodies is from proportional, relative"),
    ("machining.p_max_now_MPa", "largest pressure as it is now"),
    ("machining.p_max_then_MPa", "largest pressure as machined"),
    ("machining.contact_share_now", "part of the surface in contact as it is now"),
    ("machining.contact_share_then", "part of the surface in contact as machined"),
    ("machining.gap_max_um", "most taken off"),
    ("machining.differs_um", "most between the surface as it is and as machined"),
    ("machining.roughness_um", "roughness of the surface"),
    ("machining.worth_machining", "worth machining"),
    ("machining.run_in_distance_saved_mm", "sliding distance of running in that machining saves"),
    ("reversing.share", "share of the time forward"),
    ("reversing.forward.p_max_MPa", "forward: largest pressure"),
    ("reversing.forward.p_min_MPa", "forward: smallest pressure"),
    ("reversing.forward.p_max_where_mm", "forward: place of the largest pressure"),
    ("reversing.forward.normal_force_N", "forward: sum of the normal pressure"),
    ("reversing.forward.friction_power_mW", "forward: friction power"),
    ("reversing.forward.open_share", "forward: part of the area that carries nothing"),
    ("reversing.back.p_max_MPa", "backward: largest pressure"),
    ("reversing.back.p_min_MPa", "backward: smallest pressure"),
    ("reversing.back.p_max_where_mm", "backward: place of the largest pressure"),
    ("reversing.back.normal_force_N", "backward: sum of the normal pressure"),
    ("reversing.back.friction_power_mW", "backward: friction power"),
    ("reversing.back.open_share", "backward: part of the area that carries nothing"),
    ("reversing.ends_mm", "places where one sense begins to open"),
    ("p_min_MPa", "smallest pressure"),
    ("p_max_MPa", "largest pressure"),
    ("p_mean_MPa", "mean pressure"),
    ("q_max_MPa", "largest shear"),
    ("contact.approach_mm", "closing of body 1"),
    ("contact.tilt_rad", "rotation of body 1"),
    ("contact.ends_mm", "ends of contact"),
    ("contact.stick_ends_mm", "ends of the sticking part"),
    ("contact.edge_exponents", "exponents of the pressure at sharp ends"),
    ("contact.complementarity", "largest pressure times opening, relative"),
    ("contact.uniqueness.verdict", "one solution"),
    ("contact.uniqueness.not_guaranteed_from", "one solution not guaranteed from friction"),
    ("contact.uniqueness.singular_from", "singular from friction"),
    ("contact.uniqueness.lost_from", "solution lost from friction"),
    ("wear.time_s", "time"),
    ("wear.distance_mm", "sliding distance"),
    ("wear.depth_um", "largest depth worn off body 1"),
    ("wear.scar_mm", "width of the scar, of a ball its diameter"),
    ("wear.ends_mm", "ends of the contact along the surface"),
    ("wear.volumes_mm3", "volumes worn off body 1 and body 2"),
    ("wear.groove.depth_um", "depth of the groove in body 2"),
    ("wear.groove.width_mm", "width of the groove"),
    ("wear.groove.volume_mm3", "volume of the groove"),
    ("wear.groove.depth_ratio", "depth of the groove over the depth worn off body 1"),
    ("wear.volume_mm3", "volume worn off both bodies"),
    ("wear.life.time_h", "life of what may wear off body 1, its running-in counted"),
    ("wear.life.distance_km", "sliding distance until then"),
    ("wear.life.revolutions", "turns until then"),
    ("wear.life.cycles", "cycles until then"),
    ("wear.life.time_between_h", "shortest and longest life by the wear factor"),
    ("wear.turns.averaged", "averaged over the cycles"),
    ("wear.turns.because", "why"),
    ("wear.turns.cycles", "number of cycles"),
    ("wear.turns.resolved", "of them resolved, all others alike"),
    ("wear.turns.period_s", "length of a cycle"),
    ("wear.turns.ripple", "how far the gap strays within a cycle, over the gap"),
    ("wear.turns.shares", "shares of the time"),
    ("wear.explicit_step_limit_s", "longest stable explicit step"),
    ("wear.run_in_distance_mm", "sliding distances of the slowest parts of running in"),
    ("wear.lyapunov_increase", "largest growth of the energy in a step, relative"),
    ("wear.run_in_error", "error of that time, or of the depth without one, relative"),
    ("wear.to_1_percent.time_s", "time until within 1 % of the steady pressure"),
    ("wear.to_1_percent.distance_mm", "sliding distance until then"),
    ("wear.to_1_percent.depth_um", "depth worn off until then"),
    ("wear.to_1_percent.volume_mm3", "volume worn off until then"),
    ("heat.friction_power_mW", "power of friction"),
    ("heat.into_body1_mW", "of it into body 1"),
    ("heat.into_body2_mW", "of it into body 2"),
    ("heat.balance", "heat that is missing from the balance, relative"),
    ("heat.T_max1_degC", "highest temperature of body 1"),
    ("heat.T_max1_at_mm", "place of the highest temperature of body 1 (x, z)"),
    ("heat.T_max2_degC", "highest temperature of body 2"),
    ("heat.T_max2_at_mm", "place of the highest temperature of body 2 (x, z)"),
    ("heat.staggered_limit_speed_factor", "factor on the speed up to which pressure and temperature by turns would settle"),
    ("heat.separation_speed_factor", "factor on the speed at which surfaces without a gap begin to part"),
    ("heat.critical_speed_factor", "factor on the speed at which this contact is singular"),
    ("heat.in_time", "temperature in time"),
    ("heat.jumps", "jumps of the contact by its heat"),
    ("energy.body1_Nmm", "strain energy of body 1"),
    ("energy.body2_Nmm", "strain energy of body 2"),
    ("energy.body1_twist_Nmm", "strain energy of the twist of body 1"),
    ("energy.body2_twist_Nmm", "strain energy of the twist of body 2"),
    ("brake.actuator_N", "force of the actuator"),
    ("brake.moment_Nmm", "moment of the load about the pin"),
    ("brake.pressure_moment_Nmm", "moment of the pressure about the pin"),
    ("brake.friction_moment_Nmm", "moment of the friction about the pin, helping the load"),
    ("brake.friction_force_N", "friction along the surface"),
    ("brake.torque_Nmm", "torque on body 2"),
    ("brake.brake_factor", "friction over actuator (brake factor)"),
    ("brake.locks_at_friction", "locks itself at friction"),
    ("brake.lock_reserve", "that over the friction given"),
    ("brake.support_force.x_N", "force of the pin or roller on body 1, x"),
    ("brake.support_force.z_N", "force of the pin or roller on body 1, z"),
    ("error.gap_relative", "gap, relative"),
    ("error.pressure_relative", "pressure, relative"),
    ("error.energy_relative", "energy, relative"),
    ("error.twist_relative", "torque or angle of the twist, relative"),
    ("error.p_max_relative", "largest pressure, relative"),
    ("error.ends_mm", "ends of contact"),
    ("error.stick_ends_mm", "ends of the sticking part"),
    ("error.how", "estimated from"),
    ("counters.dofs", "unknowns"),
    ("counters.trace_dofs", "unknowns on the contact surface"),
    ("counters.check_solves", "contact solves of proofs"),
];

/// Ends of keys that name a unit.
const UNITS: &[(&str, &str)] = &[
    ("_mm3_per_s", "mm\u{b3}/s"),
    ("_mm_per_1000_km", "mm"),
    ("_um_per_h", "\u{b5}m"),
    ("_mm3", "mm\u{b3}"),
    ("_mm2", "mm\u{b2}"),
    ("_Nmm", "N mm"),
    ("_MPa", "MPa"),
    ("_degC", "\u{b0}C"),
    ("_rad", "rad"),
    ("_mW", "mW"),
    ("_MJ", "MJ"),
    ("_km", "km"),
    ("_h", "h"),
    ("_um", "\u{b5}m"),
    ("_mm", "mm"),
    ("_N", "N"),
    ("_s", "s"),
];

/// A key of the summary in words, and its unit; "" for none.
pub(crate) fn label(key: &str) -> (String, &'static str) {
    let (stem, unit) = UNITS.iter().find_map(|(end, unit)| Some((key.strip_suffix(end)?, *unit))).unwrap_or((key, ""));
    let known = WORDS.iter().find(|(known, _)| key == *known || key.strip_suffix(known).is_some_and(|head| head.ends_with('.')));
    if let Some((_, words)) = known {
        let senses = [("reversing.forward.brake.", "forward"), ("reversing.back.brake.", "backward")];
        let sense = senses.iter().find(|(head, _)| key.starts_with(head)).map(|(_, sense)| format!("{sense}: "));
        return (sense.unwrap_or_default() + words, unit);
    }
    if let Some(edge) = key.strip_prefix("heat.out.") {
        return (format!("leaves through {edge}"), "mW");
    }
    let own = stem.split_once('.').map_or(stem, |(_, rest)| rest);
    (own.replace('_', " ").replace('.', ", "), unit)
}

/// The same for a part of the summary that is of the mean pressure of both senses of a motion.
pub(crate) fn label_of_mean(key: &str) -> (String, &'static str) {
    let (words, unit) = label(key);
    let of_mean = ["pressure.p_min_MPa", "pressure.p_max_MPa", "pressure.p_max_at_mm"].contains(&key);
    (if of_mean { format!("{words}, of the mean of both directions") } else { words }, unit)
}

/// Words of a key about bodies of revolution: their x is the radius, and so is what else is measured along the surface from its middle.
pub(crate) fn by_radius(words: &str) -> String {
    let radii = [("along the surface from its middle", "radius"), ("(x, z)", "(r, z)"), ("(x, y, z)", "(r, y, z)")];
    radii.iter().fold(words.to_string(), |words, (along, radius)| words.replace(along, radius))
}

/// A sentence of the summary, which is plain ASCII, with the signs of its units.
pub(crate) fn with_signs(sentence: &str) -> String {
    signed(sentence, |_| true)
}

/// A title with the signs of the units that stand behind a number: the other words are the user's, and may be of any language.
pub(crate) fn title_with_signs(title: &str) -> String {
    signed(title, |before| before.trim_end().ends_with(|c: char| c.is_ascii_digit()))
}

/// The title of a problem for pages and pictures.
pub(crate) fn shown_title(problem: &Problem) -> String {
    title_with_signs(problem.title())
}

/// Words with the signs of units, where `is_unit` says so by what stands before one.
fn signed(words: &str, is_unit: fn(&str) -> bool) -> String {
    let mut out = String::new();
    for word in words.split_inclusive(' ') {
        let (unit, rest) = word.split_at(word.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(word.len()));
        let sign = match unit {
            _ if !is_unit(&out) => unit,
            "um" => "\u{b5}m",
            "degC" => "\u{b0}C",
            "deg" => {
                out.truncate(out.trim_end().len());
                "\u{b0}"
            }
            _ => unit,
        };
        out += sign;
        out += rest;
    }
    out.replace("mm^3", "mm\u{b3}").replace("mm^2", "mm\u{b2}").replace("+-", "\u{b1}")
}

/// A word of the summary, with what it means to whom the theory is new.
pub(crate) fn word_explained(word: &str) -> Option<&'static str> {
    Some(match word {
        "regular" => "positive on the whole surface",
        "near-singular" => "nearly concentrated on points or lines",
        "singular" => "concentrated on points or lines",
        "partial-contact" => "part of the surface carries nothing",
        "several" => "there are several",
        "minimum" => "the least, proved",
        "maximum" => "the largest, proved",
        "stationary" => "no more is proved",
        "indifferent" => "every pressure gives the same",
        "steady" => "the pressure once worn in",
        "equilibrium" => "force and moment with friction",
        "leading" => "friction helps to press it on",
        "trailing" => "friction lifts it off",
        "kinematic" => "how wear lets body 1 move",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::{by_radius, label, label_of_mean, title_with_signs, with_signs};

    #[test]
    fn sentences_of_the_page_have_the_signs_of_units() {
        let plain = "Leave on most, 3 um, at 30 deg; hottest at 40 degC, 2 um.";
        assert_eq!(with_signs(plain), "Leave on most, 3 \u{b5}m, at 30\u{b0}; hottest at 40 \u{b0}C, 2 \u{b5}m.");
        assert_eq!(with_signs("2 MPa at +-45 deg"), "2 MPa at \u{b1}45\u{b0}");
        assert_eq!(title_with_signs("Welle um 25 mm, Spiel 50 um"), "Welle um 25 mm, Spiel 50 \u{b5}m");
        assert_eq!(with_signs("2 mm^3 of a sum to a degree"), "2 mm\u{b3} of a sum to a degree");
    }

    #[test]
    fn keys_become_words_with_units() {
        assert_eq!(label("contact.p_max_MPa"), ("largest pressure".into(), "MPa"));
        assert_eq!(label("reactions.body1.left.x_N"), ("body1, left, x".into(), "N"));
        assert_eq!(label("heat.out.body1.top"), ("leaves through body1.top".into(), "mW"));
        assert_eq!(label("heat.T_max1_degC"), ("highest temperature of body 1".into(), "\u{b0}C"));
        assert_eq!(label_of_mean("pressure.p_max_MPa").0, "largest pressure, of the mean of both directions");
        assert_eq!(label_of_mean("pressure.force_N"), label("pressure.force_N"));
        assert_eq!(by_radius(&label("shape.gap_where_mm").0), "there, radius");
        assert_eq!(by_radius(&label("heat.T_max2_at_mm").0), "place of the highest temperature of body 2 (r, z)");
        assert_eq!(label("wear.rejected_steps"), ("rejected steps".into(), ""));
        assert_eq!(label("pressure.wear_volume_rate_mm3_per_s"), ("wear volume rate".into(), "mm\u{b3}/s"));
    }
}
