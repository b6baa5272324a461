//! Known values of data/reference/X.json for the built-in scenes, through the whole program.

use std::path::{Path, PathBuf};

use serde_json::Value;

/// A finished run.
pub(crate) struct Run {
    pub(crate) exit: cli::Exit,
    folder: PathBuf,
}

/// Runs a built-in scene in a folder of its own; `arguments` as on the command line.
pub(crate) fn run(scene: &str, case: &str, arguments: &[&str]) -> Run {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{scene}-{case}"));
    let mut all: Vec<String> = ["wearshape", "run", scene, "-q", "-o"].map(String::from).to_vec();
    all.push(folder.display().to_string());
    all.extend(arguments.iter().map(|a| a.to_string()));
    Run { exit: cli::run(all), folder }
}

impl Run {
    pub(crate) fn summary(&self) -> Value {
        serde_json::from_str(&std::fs::read_to_string(self.folder.join("summary.json")).unwrap()).unwrap()
    }

    /// A column of contact.csv.
    pub(crate) fn column(&self, name: &str) -> Vec<f64> {
        let text = std::fs::read_to_string(self.folder.join("contact.csv")).unwrap();
        let mut lines = text.lines();
        let at = lines.next().unwrap().split(',').position(|column| column == name).unwrap();
        lines.map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
    }

    /// Linear interpolation of a column at a place of the surface; the places asked for are sample points.
    pub(crate) fn at(&self, name: &str, s: f64) -> f64 {
        let places = self.column("s_mm");
        let row = (0..places.len()).min_by(|a, b| (places[*a] - s).abs().total_cmp(&(places[*b] - s).abs())).unwrap();
        assert!((places[row] - s).abs() < 1e-9 * (1.0 + s.abs()), "no sample at {s}");
        self.column(name)[row]
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
