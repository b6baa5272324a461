//! One run of a built-in scene with some keys replaced, in memory.

use scene::{Document, Fault, Gap, builtin, number_text};
use wearshape::{Bodies, Files, Options, PressureResult, Problem, Profile, Solution, Status};

use crate::live::Live;

/// Points of a drawn curve.
const POINTS: usize = 201;

/// A solved scene with the command that repeats it.
pub(super) struct Run {
    /// `wearshape run ...`
    pub(super) command: String,
    /// scene.resolved.toml.
    pub(super) resolved: String,
    /// What was asked.
    pub(super) problem: Problem,
    /// What was computed.
    pub(super) solution: Solution,
}

/// Solves a built-in scene with `--set` pairs.
pub(super) fn run(scene: &str, settings: &[String]) -> Result<Run, Fault> {
    run_from(scene, settings, None)
}

/// The same with a start gap, which on the command line is a CSV file of the name given.
pub(super) fn run_from(scene: &str, settings: &[String], start: Option<(Gap, &str)>) -> Result<Run, Fault> {
    let (mut problem, resolved, mut command) = prepared(scene, settings)?;
    if let Some((gap, name)) = start {
        let table = csv(&gap);
        let mut all = settings.to_vec();
        all.push(format!("contact.gap={name}"));
        problem =
            read(scene, &all, &|path| if path == name { Ok(table.clone().into_bytes()) } else { Err("no such file".into()) })?;
        command += &format!(" --set contact.gap={name}");
    }
    let solution = Live::silent().solve(&problem, &Options::default(), &Bodies::default())?;
    if matches!(solution.status, Status::Refused | Status::NotConverged | Status::Interrupted) {
        let why = solution.reason.clone().unwrap_or_else(|| "interrupted".into());
        return Err(Fault::new("no-answer", format!("{command}: {why}"), "run the command by itself to see more"));
    }
    Ok(Run { command, resolved, problem, solution })
}

/// A gap profile as the file that it is on the command line.
fn csv(gap: &Gap) -> String {
    let Gap::Profile { s, gap } = gap else { return String::new() };
    let rows = s.iter().zip(gap).map(|(s, gap)| format!("{},{}\n", number_text(*s), number_text(*gap)));
    std::iter::once("s_mm,gap_um\n".to_string()).chain(rows).collect()
}

/// A built-in scene with `--set` pairs, checked.
fn read(scene: &str, settings: &[String], files: Files<'_>) -> Result<Problem, Fault> {
    let (file, text) = builtin(scene).map_or_else(Default::default, |builtin| (builtin.file(), builtin.text));
    Problem::new(&Document::read(&file, text, settings)?, files)
}

/// A built-in scene with `--set` pairs, checked, as scene.resolved.toml, and as a command.
pub(super) fn prepared(scene: &str, settings: &[String]) -> Result<(Problem, String, String), Fault> {
    let problem = read(scene, settings, &|_| Err("built-in scenes have no files beside them".into()))?;
    let resolved = problem.resolved();
    let mut command = format!("wearshape run {scene}");
    for setting in settings {
        let plain = setting.chars().all(|c| c.is_ascii_alphanumeric() || "=._-,[]".contains(c));
        command += &if plain { format!(" --set {setting}") } else { format!(" --set '{setting}'") };
    }
    Ok((problem, resolved, command))
}

impl Run {
    /// The pressure stage's numbers.
    pub(super) fn pressure(&self) -> PressureResult {
        self.solution.pressure.clone().unwrap_or_default()
    }

    /// A curve over the picture's coordinate, from small to large: angle (deg), radius or x (mm).
    pub(super) fn curve(&self, column: fn(&Profile) -> &Vec<f64>) -> Vec<(f64, f64)> {
        let Some(profile) = self.solution.curve.as_ref().or(self.solution.profile.as_ref()) else { return Vec::new() };
        let (places, _) = report::abscissa(&self.problem, profile);
        let step = (places.len().saturating_sub(1) / (POINTS - 1)).max(1);
        let mut curve: Vec<_> = places.into_iter().zip(column(profile).iter().copied()).step_by(step).collect();
        // The angle falls along a surface that faces away from its centre.
        curve.sort_by(|one, other| one.0.total_cmp(&other.0));
        curve
    }

    /// Value of a curve at a place, between the points by straight lines.
    pub(super) fn at(&self, column: fn(&Profile) -> &Vec<f64>, place: f64) -> f64 {
        value_at(&self.curve(column), place)
    }
}

/// Value of a curve over growing places at one of them, by straight lines; the ends beyond them.
pub(super) fn value_at(curve: &[(f64, f64)], place: f64) -> f64 {
    if curve.len() < 2 {
        return f64::NAN;
    }
    let after = curve.partition_point(|point| point.0 < place - 1e-9).clamp(1, curve.len() - 1);
    let ((x0, y0), (x1, y1)) = (curve[after - 1], curve[after]);
    let t = ((place - x0) / (x1 - x0)).clamp(0.0, 1.0);
    (1.0 - t) * y0 + t * y1
}

/// The largest value of a curve and where it is.
pub(super) fn highest(curve: &[(f64, f64)]) -> (f64, f64) {
    curve.iter().copied().fold((f64::NAN, f64::MIN), |best, point| if point.1 > best.1 { point } else { best })
}

/// Settings from words.
pub(super) fn set(words: &[&str]) -> Vec<String> {
    words.iter().map(|word| (*word).to_string()).collect()
}

/// Columns of a profile, for [`Run::curve`].
pub(super) mod column {
    use wearshape::Profile;

    /// Contact pressure (MPa).
    pub(crate) fn pressure(profile: &Profile) -> &Vec<f64> {
        &profile.pressure
    }

    /// Pressure that a contact solve on the shape gives back (MPa).
    pub(crate) fn solved(profile: &Profile) -> &Vec<f64> {
        &profile.pressure_solved
    }

    /// Wear rate (um/s).
    pub(crate) fn wear_rate(profile: &Profile) -> &Vec<f64> {
        &profile.wear_rate
    }

    /// Unloaded gap (um).
    pub(crate) fn gap(profile: &Profile) -> &Vec<f64> {
        &profile.gap
    }

    /// Normal displacement of body 1 (um).
    pub(crate) fn normal1(profile: &Profile) -> &Vec<f64> {
        &profile.normal_displacement[0]
    }

    /// Normal displacement of body 2 (um).
    pub(crate) fn normal2(profile: &Profile) -> &Vec<f64> {
        &profile.normal_displacement[1]
    }
}
