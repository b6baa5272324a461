//! The first screen: the verdict, then the numbers and the notes, eleven lines at most.

use std::path::Path;

use wearshape::{
    Character, LifeResult, MachiningResult, PressureResult, Problem, Regime, ReversingResult, SenseResult, Solution, Status,
    Step, TurnsResult, WearResult, functional_row,
};

use crate::brake_line::{both_ways, brake_line};
use crate::brief::brief;
use crate::heat_line::heat_line;
use crate::missed;
use crate::place::place;
use crate::pressure_words::pressures;
use crate::round_off::shown_place;
use crate::verdict::verdict;

/// Columns of a terminal, of the names of lines, and of the longest phrase that is kept together.
const WIDTH: usize = 80;
const INDENT: usize = 10;
const PHRASE: usize = 45;

/// Lines of numbers and notes, and notes among them, where not all notes are asked for.
const LINES: usize = 8;
const NOTES: usize = 2;

/// The lines for the screen: two notes and how many more there are, or every note.
pub fn first_screen(problem: &Problem, solution: &Solution, folder: &Path, every_note: bool) -> String {
    let mut lines = Vec::new();
    lines.extend(missed::lines(problem, solution));
    if let Some(pressure) = solution.pressure.as_ref().filter(|_| solution.status != Status::Refused) {
        lines.extend(pressure_lines(problem, solution, pressure));
    }
    let brake = match &solution.as_machined {
        Some(machined) => machined.brake.as_ref(),
        None => solution.brake.as_ref(),
    };
    let brake = brake.filter(|_| solution.status != Status::Refused);
    let senses = solution.reversing.as_ref().filter(|reversing| reversing.share > 0.0 && reversing.share < 1.0);
    let senses = senses.and_then(|reversing| Some([reversing.forward.brake.as_ref()?, reversing.back.brake.as_ref()?]));
    lines.extend(brake.map(|brake| senses.map_or_else(|| brake_line(brake, solution.pressure.is_some()), both_ways)));
    lines.extend(solution.heat.as_ref().map(heat_line));
    lines.extend(solution.machining.as_ref().map(machining_line));
    lines.extend(solution.wear.as_ref().map(|wear| wear_line(wear, solution.pressure.is_some())));
    lines.extend(ends_line(solution));
    lines.extend(solution.wear.as_ref().and_then(|wear| wear.life.as_ref()).map(|life| life_line(life, " with its running in")));
    if let Some(trip) = solution.shape.as_ref().and_then(|shape| shape.roundtrip_independent.or(shape.roundtrip_same)) {
        let both = solution.reversing.as_ref().is_some_and(|reversing| reversing.share > 0.0 && reversing.share < 1.0);
        lines.push(match both {
            true => {
                format!("proof     contact solves forward and backward on this shape return both pressures within {trip:.1e}")
            }
            false => format!("proof     a contact solve on this shape returns the pressure within {trip:.1e}"),
        });
    }
    lines.truncate(LINES);
    let room = if every_note { usize::MAX } else { NOTES.min(LINES - lines.len()) };
    lines.extend(notes(problem, solution, room));
    if !problem.unused_keys().is_empty() {
        lines.push(format!("unused    {}", problem.unused_keys().join(", ")));
    }
    let mut rows = folded(&verdict(problem, solution), 0);
    let bracket = format!("[{}]", bracket(solution));
    match rows.last_mut().filter(|last| last.chars().count() + 3 + bracket.chars().count() <= WIDTH) {
        Some(last) => *last += &format!("   {bracket}"),
        None => rows.push(bracket),
    }
    rows.extend(lines.iter().flat_map(|line| folded(line, INDENT)));
    rows.push(format!("files     {}", folder.display()));
    rows.join("\n") + "\n"
}

/// The first notes, and how many more there are.
fn notes(problem: &Problem, solution: &Solution, room: usize) -> Vec<String> {
    let messages: Vec<&str> = solution.remarks.iter().chain(problem.remarks()).map(|note| note.message.as_str()).collect();
    let mut lines: Vec<String> = messages.iter().take(room).map(|message| format!("note      {message}")).collect();
    let file = if problem.plan().runs(Step::Page) { "report.html" } else { "summary.json" };
    if messages.len() > room {
        lines.push(format!("notes     {} more in {file}", messages.len() - room));
    }
    lines
}

/// A line in pieces that are no wider than a terminal, cut between phrases where they are short enough, else between words; all but the first are
/// indented.
fn folded(line: &str, indent: usize) -> Vec<String> {
    let mut rows = vec![String::new()];
    let mut add = |part: &str| {
        let room = WIDTH - if rows.len() > 1 { indent } else { 0 };
        match rows.last_mut().filter(|row| row.chars().count() + part.trim_end().chars().count() <= room || row.is_empty()) {
            Some(row) => row.push_str(part),
            None => rows.push(part.to_string()),
        }
    };
    for phrase in line.split_inclusive("; ").flat_map(|part| part.split_inclusive(", ")) {
        match phrase.chars().count() <= PHRASE {
            true => add(phrase),
            false => phrase.split_inclusive(' ').for_each(&mut add),
        }
    }
    let pad = |(number, row): (usize, String)| format!("{}{}", " ".repeat(if number > 0 { indent } else { 0 }), row.trim_end());
    rows.into_iter().enumerate().map(pad).collect()
}

fn pressure_lines(problem: &Problem, solution: &Solution, pressure: &PressureResult) -> Vec<String> {
    let machined = solution.as_machined.as_ref().map(|machined| &machined.curve);
    let curve = machined.or(solution.curve.as_ref()).or(solution.profile.as_ref());
    let spread = solution.shape.as_ref().and(curve).and_then(|curve| pressures(problem, curve, pressure));
    let spread = solution.reversing.as_ref().map(|reversing| both_senses(problem, reversing)).or(spread);
    let mean = pressure.p_mean.map(|mean| format!("mean {} MPa", brief(mean))).unwrap_or_default();
    let lines_of = [Some(spread.unwrap_or(mean)), kind(pressure)];
    let said: Vec<String> = lines_of.into_iter().flatten().filter(|text| !text.is_empty()).collect();
    let mut lines = if said.is_empty() { Vec::new() } else { vec![format!("pressure  {}", said.join("; "))] };
    for atom in pressure.limit_measure.iter().take(3) {
        let [x, y, z] = shown_place([atom.x, atom.y, atom.z]).map(brief);
        let force = brief(atom.force);
        lines.push(format!("          {force} N at x = {x}, y = {y}, z = {z} mm"));
    }
    let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
    let wear = [
        finite(pressure.wear_volume_rate).map(|rate| format!("{} mm^3/s", brief(rate))),
        finite(pressure.wear_depth_per_hour).map(|rate| format!("{} {} um/h", mean_of(problem), brief(rate))),
        finite(pressure.wear_depth_per_1000_km).map(|depth| format!("{} mm per 1000 km", brief(depth))),
        finite(pressure.friction_power).map(|power| format!("friction {} W", brief(1e-3 * power))),
        finite(pressure.torque).map(|torque| format!("torque {} N m", brief(1e-3 * torque))),
    ];
    let wear: Vec<String> = wear.into_iter().flatten().collect();
    if !wear.is_empty() {
        lines.push(format!("wear      {}", wear.join(", ")));
    }
    lines.extend(pressure.life.as_ref().map(|life| life_line(life, "")));
    lines
}

/// Of what a wear depth is the mean.
fn mean_of(problem: &Problem) -> &'static str {
    let [_, second] = problem.scene().wear.as_ref().map_or([false; 2], scene::Wear::wearing);
    if second { "both bodies, mean" } else { "mean" }
}

/// The largest pressures of a reversing motion, of the senses that it goes in.
fn both_senses(problem: &Problem, reversing: &ReversingResult) -> String {
    let most = |sense: &SenseResult| format!("{} MPa at {}", brief(sense.p_max), place(problem, sense.p_max_where));
    let forward = (reversing.share > 0.0).then(|| format!("forward at most {}", most(&reversing.forward)));
    let back = (reversing.share < 1.0).then(|| format!("backward at most {}", most(&reversing.back)));
    [forward, back].into_iter().flatten().collect::<Vec<String>>().join(", ")
}

/// How long the thickness that may wear off lasts; `counted` says what beside the steady wear.
fn life_line(life: &LifeResult, counted: &str) -> String {
    let mut words = vec![format!("{} h{counted}", brief(life.hours))];
    words.extend(
        life.hours_between.map(|[low, high]| format!("between {} h and {} h by the wear factor", brief(low), brief(high))),
    );
    words.push(format!("{} km", brief(life.distance)));
    words.extend(life.revolutions.map(|turns| format!("{} turns", brief(turns))));
    words.extend(life.cycles.map(|cycles| format!("{} cycles", brief(cycles))));
    words.extend(life.friction_work.filter(|work| *work > 0.0).map(|work| format!("{} MJ of friction", brief(work))));
    format!("life      {}", words.join(", "))
}

/// What is unusual about a pressure, in plain words; its terms stand in the summary.
fn kind(pressure: &PressureResult) -> Option<String> {
    let functional = pressure.functional;
    let q = pressure.q.filter(|_| functional_row(functional).needs.q).map(|q| format!("for q = {q}"));
    let character = match pressure.character {
        Some(Character::Maximum) => Some("the worst case, not the best".to_string()),
        Some(Character::Indifferent) => Some("every pressure that carries the load is as good".to_string()),
        Some(Character::Minimum | Character::Stationary) | None => None,
    };
    let regime = match pressure.regime {
        Some(Regime::NearSingular) => Some("nearly concentrated on points or lines"),
        Some(Regime::Singular) => Some("concentrated on points or lines"),
        Some(Regime::PartialContact) => Some("part of the surface carries nothing"),
        Some(Regime::Several) => Some("one of several pressures"),
        Some(Regime::Regular | Regime::Infeasible) | None => None,
    };
    let words: Vec<String> = [q, character, regime.map(String::from)].into_iter().flatten().collect();
    if words.is_empty() { None } else { Some(words.join(", ")) }
}

/// Where a contact ends that does not fill its surface; of a ball its radius, and of a scar that is told by its width alone nothing.
fn ends_line(solution: &Solution) -> Option<String> {
    let ends = match (&solution.wear, &solution.contact) {
        (Some(wear), _) => wear.ends?,
        (None, Some(contact)) => <[f64; 2]>::try_from(contact.ends.as_slice()).ok()?,
        (None, None) => return None,
    };
    let [from, to] = ends;
    let profile = solution.curve.as_ref().or(solution.profile.as_ref())?;
    let [first, last] = [*profile.s.first()?, *profile.s.last()?];
    let near = 1e-6 * (last - first);
    if solution.status == Status::Refused || (from <= first + near && to >= last - near) {
        return None;
    }
    Some(format!("contact   from {} to {} mm, {} mm wide", brief(from), brief(to), brief(to - from)))
}

/// Wear in time; its name is another where that of a pressure has been told.
fn wear_line(wear: &WearResult, second: bool) -> String {
    let mut words = vec![format!("depth {} um", brief(wear.depth.unwrap_or(0.0)))];
    words.extend(wear.volume.map(|volume| match wear.volumes {
        // The depth is that of body 1.
        Some([first, second]) if first > 0.0 && second > 0.0 => format!("volume {} + {} mm^3", brief(first), brief(second)),
        _ => format!("volume {} mm^3", brief(volume)),
    }));
    if let (Some(depth), Some(time), Some(distance)) = (wear.depth, wear.time, wear.distance)
        && time > 0.0
        && distance > 0.0
    {
        words.push(format!("{} um/h", brief(3600.0 * depth / time)));
        words.push(format!("{} mm per 1000 km", brief(1e6 * depth / distance)));
    }
    words.extend(wear.turns.as_ref().and_then(cycles));
    let near = wear.to_1_percent.as_ref();
    // Of a run without that time it is the error of its depth.
    let off = |value: f64| wear.run_in_error.map(|error| format!(" +- {:.0e}", error * value)).unwrap_or_default();
    words.extend(near.map(|near| format!("within 1 % of the steady pressure after {}{} s", brief(near.time), off(near.time))));
    format!("{}{}", if second { "in time   " } else { "wear      " }, words.join(", "))
}

/// How the cycles of a run in time were taken.
fn cycles(turns: &TurnsResult) -> Option<String> {
    let count = brief(turns.cycles?);
    Some(match turns.resolved {
        _ if turns.averaged => format!("mean over {count} cycles"),
        Some(resolved) => format!("{count} cycles, {} of them one by one, the others alike", brief(resolved)),
        None => format!("{count} cycles one by one"),
    })
}

/// The surface as it is now against as machined.
fn machining_line(machining: &MachiningResult) -> String {
    let at_most =
        |peak: Option<f64>| peak.map_or("without limit at its edges".into(), |peak| format!("at most {} MPa", brief(peak)));
    let percent = |share: f64| brief(100.0 * share);
    let mut line =
        format!("now       {} on {} % of the surface", at_most(machining.p_max_now), percent(machining.contact_share_now));
    if let (Some(peak), Some(share)) = (machining.p_max_then, machining.contact_share_then) {
        line += &format!("; as machined at most {} MPa on {} %", brief(peak), percent(share));
    }
    if let Some(saved) = machining.run_in_distance_saved {
        line += &format!("; machining saves {} m of running in", brief(1e-3 * saved));
    }
    line
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

#[cfg(test)]
mod tests {
    use super::{INDENT, folded};

    #[test]
    fn long_lines_are_cut_between_phrases_and_lose_no_word() {
        let line = "wear      38480 mm^3/s, 3150000 um/h, 4273000 mm per 1000 km, friction 192400 W, torque 76970 N m";
        let rows = folded(line, INDENT);
        assert_eq!(rows, [&line[..80], "          torque 76970 N m"]);
        let note = format!("note      {}", "word ".repeat(60));
        let rows = folded(&note, INDENT);
        assert!(rows.len() > 3 && rows.iter().all(|row| row.chars().count() <= 80), "{rows:?}");
        assert_eq!(rows.join(" ").split_whitespace().collect::<Vec<_>>(), note.split_whitespace().collect::<Vec<_>>());
        assert_eq!(folded("short", 0), ["short"]);
    }
}
