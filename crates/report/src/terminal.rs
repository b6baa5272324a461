//! The first screen: the verdict, then the numbers, ten lines at most.

use std::path::Path;

use scene::{Functional, short, with_short_numbers};
use wearshape::{Character, Problem, Profile, Regime, Shape, Solution, Status, word};

/// A place in the words of the scene.
fn place(problem: &Problem, s: f64) -> String {
    if let Some(angle) = problem.angle(s) {
        return format!("{} deg", short((angle.to_degrees() * 1e3).round() / 1e3));
    }
    match problem.contact_shape() {
        Some(Shape::Annulus { .. } | Shape::Sector { .. }) => format!("r = {} mm", short(s)),
        Some(Shape::Strip { x, .. } | Shape::Rectangle { x, .. }) => {
            // The middle, found up to round-off, is the middle.
            let s = if s.abs() < 1e-9 * (x[1] - x[0]) { 0.0 } else { s };
            format!("x = {} mm", short(s + 0.5 * (x[0] + x[1])))
        }
        Some(Shape::Ellipse { .. }) => format!("x = {} mm", short(s)),
        _ => format!("s = {} mm", short(s)),
    }
}

fn extreme(values: &[f64], better: fn(f64, f64) -> bool) -> Option<usize> {
    let mut best: Option<usize> = None;
    for (row, value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
        if best.is_none_or(|best| better(*value, values[best])) {
            best = Some(row);
        }
    }
    best
}

/// "5.45455 MPa at 0 deg, 4.09091 MPa at -30 deg".
fn pressures(problem: &Problem, profile: &Profile) -> Option<String> {
    let high = extreme(&profile.pressure, |a, b| a > b * (1.0 + 1e-9))?;
    let low = extreme(&profile.pressure, |a, b| a < b * (1.0 - 1e-9))?;
    let (top, bottom) = (profile.pressure[high], profile.pressure[low]);
    if top - bottom <= 1e-9 * top {
        return Some(format!("{} MPa everywhere", short(top)));
    }
    let at = |row: usize| {
        let mirrored = profile.pressure[profile.pressure.len() - 1 - row];
        let s = profile.s[row];
        let reach = profile.s.iter().fold(0.0f64, |most, s| most.max(s.abs()));
        let even = s < -1e-9 * reach && (mirrored - profile.pressure[row]).abs() <= 1e-9 * top;
        let word = place(problem, s);
        if even { word.replacen('-', "+-", 1) } else { word }
    };
    Some(format!("{} MPa at {}, {} MPa at {}", short(top), at(high), short(bottom), at(low)))
}

/// One sentence that says how it ended.
pub fn verdict(problem: &Problem, solution: &Solution) -> String {
    if let Some(reason) = &solution.reason {
        let head = match solution.status {
            Status::Refused => "This scene has no answer",
            Status::NotConverged => "The computation did not arrive",
            Status::AccuracyMissed => "Done, but not to the accuracy asked for",
            Status::Ok => "Done",
            Status::Interrupted => "Interrupted",
        };
        return format!("{head}: {}.", with_short_numbers(reason));
    }
    if let Some(shape) = &solution.shape {
        let crown = shape.crown.unwrap_or(0.0);
        let at = shape.gap_where.map(|s| format!(" at {}", place(problem, s))).unwrap_or_default();
        let steady = solution.pressure.as_ref().is_some_and(|pressure| pressure.functional == Functional::Steady);
        let end = if steady { "it starts worn in" } else { "it has the wanted pressure" };
        return format!("Machine this shape: crown {} um{at}; {end}.", short(crown));
    }
    if let Some(wear) = &solution.wear {
        let time = wear.time.map(short).unwrap_or_default();
        return match wear.steady {
            true => match &wear.to_1_percent {
                Some(near) => format!("Worn in to 1 % after {} s, steady after {time} s.", short(near.time)),
                None if problem.scene().load.as_ref().is_some_and(|load| load.approach.is_some()) => {
                    format!(
                        "The contact has worn itself free after {time} s: under the prescribed approach nothing presses any more."
                    )
                }
                None => format!("Worn in after {time} s: the pressure no longer changes."),
            },
            false => format!("Worn for {time} s; not yet steady."),
        };
    }
    if let Some(contact) = &solution.contact {
        let force = contact.force.map(short).unwrap_or_default();
        let exponents: Vec<String> = contact.edge_exponents.iter().map(|exponent| format!("{exponent:.3}")).collect();
        let peak = match contact.p_max {
            Some(peak) => format!("at most {} MPa", short(peak)),
            None => format!("the pressure grows towards the edges like d^({})", exponents.join(") and d^(")),
        };
        let turned = contact.twist.as_ref().and_then(|twist| twist.angle.last().zip(twist.torque.last()));
        let turned = turned.map_or(String::new(), |(angle, torque)| {
            format!("; turned by {} rad, a torque of {} N mm acts", short(*angle), short(*torque))
        });
        return format!("The bodies touch with {force} N, {peak}{turned}.");
    }
    let Some(pressure) = &solution.pressure else {
        return "Nothing was asked for.".into();
    };
    let what = match problem.scene().optimum.as_ref().and_then(|optimum| optimum.functional) {
        Some(Functional::Uniform) => "The uniform pressure",
        Some(Functional::WearVolume) => "The pressure that makes the wear volume rate stationary",
        Some(Functional::FrictionPower) => "The pressure that makes the friction power stationary",
        Some(Functional::WearPower) => "The pressure that makes the wear power stationary",
        _ => "The worn-in pressure",
    };
    if pressure.regime == Some(Regime::Singular) {
        return format!("{what} concentrates on points or lines: see the limit measure.");
    }
    let curve = solution.curve.as_ref().or(solution.profile.as_ref());
    let numbers = curve.and_then(|curve| pressures(problem, curve)).unwrap_or_default();
    let kind = if pressure.character == Some(Character::Maximum) { ", the worst case" } else { "" };
    format!("{what} is {numbers}{kind}.")
}

/// The lines for the screen.
pub fn first_screen(problem: &Problem, solution: &Solution, folder: &Path) -> String {
    let mut lines = vec![format!("{}   [{}]", verdict(problem, solution), bracket(solution))];
    if let Some(pressure) = solution.pressure.as_ref().filter(|_| solution.status != Status::Refused) {
        let curve = solution.curve.as_ref().or(solution.profile.as_ref());
        let with_q = !matches!(pressure.functional, Functional::Steady | Functional::Uniform);
        let q = pressure.q.filter(|_| with_q).map(|q| format!(" q = {q},")).unwrap_or_default();
        let kind = format!("({},{q} {}, {})", word(&pressure.functional), word(&pressure.character), word(&pressure.regime));
        let spread = solution.shape.as_ref().and(curve).and_then(|curve| pressures(problem, curve));
        let mean = pressure.p_mean.map(|mean| format!("mean {} MPa", short(mean))).unwrap_or_default();
        lines.push(format!("pressure  {} {kind}", spread.unwrap_or(mean)));
        for atom in pressure.limit_measure.iter().take(3) {
            lines.push(format!(
                "          {} N at x = {}, y = {}, z = {} mm",
                short(atom.force),
                short(atom.x),
                short(atom.y),
                short(atom.z)
            ));
        }
        let mut wear = Vec::new();
        if let Some(rate) = pressure.wear_volume_rate.filter(|value| value.is_finite()) {
            wear.push(format!("{} mm^3/s", short(rate)));
        }
        if let Some(power) = pressure.friction_power.filter(|value| value.is_finite()) {
            wear.push(format!("friction {} W", short(1e-3 * power)));
        }
        if let Some(torque) = pressure.torque.filter(|value| value.is_finite()) {
            wear.push(format!("torque {} N m", short(1e-3 * torque)));
        }
        if !wear.is_empty() {
            lines.push(format!("wear      {}", wear.join(", ")));
        }
    }
    if let Some(wear) = &solution.wear {
        let mut words = vec![format!("depth {} um", short(wear.depth.unwrap_or(0.0)))];
        words.extend(wear.volume.map(|volume| format!("volume {} mm^3", short(volume))));
        let near = wear.to_1_percent.as_ref();
        words.extend(near.map(|near| format!("within 1 % of the steady pressure after {} s", short(near.time))));
        lines.push(format!("wear      {}", words.join(", ")));
    }
    if let Some(trip) = solution.shape.as_ref().and_then(|shape| shape.roundtrip_independent.or(shape.roundtrip_same)) {
        lines.push(format!("proof     a contact solve on this shape returns the pressure within {trip:.1e}"));
    }
    for lint in solution.remarks.iter().chain(problem.remarks()).take(2) {
        lines.push(format!("note      {}", lint.message));
    }
    if !problem.unused_keys().is_empty() {
        lines.push(format!("unused    {}", problem.unused_keys().join(", ")));
    }
    lines.truncate(9);
    lines.push(format!("files     {}", folder.display()));
    lines.join("\n") + "\n"
}

fn bracket(solution: &Solution) -> String {
    let status = match solution.status {
        Status::Ok => "done",
        Status::AccuracyMissed => "accuracy missed",
        Status::NotConverged => "not converged",
        Status::Refused => "refused",
        Status::Interrupted => "interrupted",
    };
    let error = solution.error.as_ref().and_then(|error| {
        let pressure = error.pressure_relative.filter(|value| *value > 1e-14);
        error.gap_relative.map(|value| ("gap", value)).or(pressure.map(|value| ("pressure", value)))
    });
    match error {
        Some((what, value)) => format!("{status}, {what} error {value:.0e}"),
        None => status.to_string(),
    }
}
