//! The first screen: the verdict, then the numbers, ten lines at most.

use std::path::Path;

use scene::short;
use wearshape::{PressureResult, Problem, Solution, Status, WearResult, functional_row, word};

use crate::missed;
use crate::verdict::{pressures, verdict};

/// The lines for the screen.
pub fn first_screen(problem: &Problem, solution: &Solution, folder: &Path) -> String {
    let mut lines = vec![format!("{}   [{}]", verdict(problem, solution), bracket(solution))];
    lines.extend(missed::lines(problem, solution));
    if let Some(pressure) = solution.pressure.as_ref().filter(|_| solution.status != Status::Refused) {
        lines.extend(pressure_lines(problem, solution, pressure));
    }
    lines.extend(solution.wear.as_ref().map(wear_line));
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

fn pressure_lines(problem: &Problem, solution: &Solution, pressure: &PressureResult) -> Vec<String> {
    let curve = solution.curve.as_ref().or(solution.profile.as_ref());
    let q = pressure.q.filter(|_| functional_row(pressure.functional).needs.q).map(|q| format!(" q = {q},")).unwrap_or_default();
    let kind = format!("({},{q} {}, {})", word(&pressure.functional), word(&pressure.character), word(&pressure.regime));
    let spread = solution.shape.as_ref().and(curve).and_then(|curve| pressures(problem, curve));
    let mean = pressure.p_mean.map(|mean| format!("mean {} MPa", short(mean))).unwrap_or_default();
    let mut lines = vec![format!("pressure  {} {kind}", spread.unwrap_or(mean))];
    for atom in pressure.limit_measure.iter().take(3) {
        let [force, x, y, z] = [atom.force, atom.x, atom.y, atom.z].map(short);
        lines.push(format!("          {force} N at x = {x}, y = {y}, z = {z} mm"));
    }
    let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
    let wear = [
        finite(pressure.wear_volume_rate).map(|rate| format!("{} mm^3/s", short(rate))),
        finite(pressure.friction_power).map(|power| format!("friction {} W", short(1e-3 * power))),
        finite(pressure.torque).map(|torque| format!("torque {} N m", short(1e-3 * torque))),
    ];
    let wear: Vec<String> = wear.into_iter().flatten().collect();
    if !wear.is_empty() {
        lines.push(format!("wear      {}", wear.join(", ")));
    }
    lines
}

fn wear_line(wear: &WearResult) -> String {
    let mut words = vec![format!("depth {} um", short(wear.depth.unwrap_or(0.0)))];
    words.extend(wear.volume.map(|volume| format!("volume {} mm^3", short(volume))));
    let near = wear.to_1_percent.as_ref();
    words.extend(near.map(|near| format!("within 1 % of the steady pressure after {} s", short(near.time))));
    format!("wear      {}", words.join(", "))
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
