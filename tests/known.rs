//! Known values of data/reference/X.json for the built-in scenes, solved by the library or through the whole program.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use serde_json::Value;
use wearshape::{Bodies, Document, Options, Problem, Profile, Sampling, Solution, builtin, solve};

/// The problem of a built-in scene; settings as of `--set`.
pub(crate) fn problem(scene: &str, settings: &[&str]) -> Problem {
    let settings: Vec<String> = settings.iter().map(|setting| setting.to_string()).collect();
    let scene = builtin(scene).unwrap();
    let document = Document::read(&scene.file(), scene.text, &settings).unwrap();
    Problem::new(&document, &|file| Err(format!("there is no {file}"))).unwrap()
}

/// A built-in scene solved in memory, its columns at so many evenly spaced points, or at the contact points.
pub(crate) fn solved(scene: &str, settings: &[&str], samples: Option<usize>) -> Solution {
    let options = Options { sample: samples.map(Sampling::Even), ..Options::default() };
    let going_on = &mut |_: wearshape::Event<'_>| ControlFlow::Continue(());
    solve(&problem(scene, settings), &options, &Bodies::default(), going_on).unwrap()
}

/// The columns of a solution.
pub(crate) fn profile(solution: &Solution) -> &Profile {
    solution.profile.as_ref().unwrap()
}

/// The value of a column at a place of the surface, which must be a sample point.
pub(crate) fn at(profile: &Profile, column: &[f64], s: f64) -> f64 {
    let row = profile.s.iter().position(|place| (place - s).abs() < 1e-9 * (1.0 + s.abs()));
    column[row.unwrap_or_else(|| panic!("no sample at {s}"))]
}

/// Force along x and z of the support on an edge, N.
pub(crate) fn reaction(solution: &Solution, edge: &str) -> [f64; 2] {
    let (_, found) = solution.reactions.iter().find(|(name, _)| name == edge).unwrap();
    [found.x.unwrap(), found.z.unwrap()]
}

/// A finished run of the program.
pub(crate) struct Run {
    pub(crate) exit: cli::Exit,
    folder: PathBuf,
}

/// Runs a built-in scene through the program, in a folder of its own; `arguments` as on the command line.
pub(crate) fn run(scene: &str, case: &str, arguments: &[&str]) -> Run {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{scene}-{case}"));
    let mut all: Vec<String> = ["wearshape", "run", scene, "-q", "-o"].map(String::from).to_vec();
    all.push(folder.display().to_string());
    all.extend(arguments.iter().map(|a| a.to_string()));
    Run { exit: cli::run(all), folder }
}

impl Run {
    /// A file of the folder; none if it was not written.
    pub(crate) fn file(&self, name: &str) -> Option<Vec<u8>> {
        std::fs::read(self.folder.join(name)).ok()
    }

    pub(crate) fn summary(&self) -> Value {
        serde_json::from_slice(&self.file("summary.json").unwrap()).unwrap()
    }

    /// A column of contact.csv.
    pub(crate) fn column(&self, name: &str) -> Vec<f64> {
        let text = String::from_utf8(self.file("contact.csv").unwrap()).unwrap();
        let mut lines = text.lines();
        let at = lines.next().unwrap().split(',').position(|column| column == name).unwrap();
        lines.map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
    }
}

/// Known values of a scene.
pub(crate) fn reference(scene: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../data/reference/{scene}.json"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Largest difference of two lists after the best multiple of `mode` is taken out of it.
pub(crate) fn difference_modulo(found: &[f64], wanted: &[f64], mode: &[f64]) -> f64 {
    let difference: Vec<f64> = found.iter().zip(wanted).map(|(a, b)| a - b).collect();
    let along: f64 = difference.iter().zip(mode).map(|(a, b)| a * b).sum::<f64>() / mode.iter().map(|b| b * b).sum::<f64>();
    difference.iter().zip(mode).map(|(d, m)| (d - along * m).abs()).fold(0.0, f64::max)
}
