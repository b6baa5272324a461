//! The main figures of a sweep, for people: points by columns.

use serde_json::Value;

use crate::grid::Grid;

/// Width of a terminal.
const WIDTH: usize = 80;
/// Rows without an answer whose reason is told on a terminal.
const REASONS: usize = 5;

/// The figures in the order of their worth: name, and the keys of a row that have it, the first that is there.
const FIGURES: [(&str, &[&str]); 13] = [
    (LARGEST, &["contact.p_max_MPa", "pressure.p_max_MPa"]),
    ("gap max um", &["shape.gap_max_um"]),
    ("depth um", &["wear.depth_um"]),
    ("time s", &["wear.time_s"]),
    (ERROR, &["error.gap_relative", "error.pressure_relative"]),
    ("wear mm^3/s", &["pressure.wear_volume_rate_mm3_per_s"]),
    ("approach mm", &["contact.approach_mm"]),
    ("torque N mm", &["pressure.torque_Nmm"]),
    ("friction mW", &["pressure.friction_power_mW"]),
    ("p mean MPa", &["pressure.p_mean_MPa"]),
    ("volume mm^3", &["wear.volume_mm3"]),
    ("force N", &FORCES),
    (MOMENT, &["contact.moment_Nmm", "pressure.moment_Nmm"]),
];
/// The largest pressure, and its name where it is that of the mean of both directions of a motion.
const LARGEST: &str = "p max MPa";
const LARGEST_OF_MEAN: &str = "p max of mean MPa";
/// The moment, and the forces that it is measured by: below this share of a force over a millimetre it is round-off.
const MOMENT: &str = "moment N mm";
const FORCES: [&str; 2] = ["contact.force_N", "pressure.force_N"];
const NOTHING: f64 = 1e-9;
/// The figure of which the size alone matters.
const ERROR: &str = "error";
const STATUS: &str = "status";

/// A table of texts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Figures {
    /// Names of the columns: the axes, the figures that are known, the status where one is not ok.
    pub(crate) names: Vec<String>,
    /// A row for each point.
    pub(crate) rows: Vec<Vec<String>>,
    /// Why points have no answer.
    pub(crate) reasons: Vec<String>,
}

/// Names of the axes: the last word of the key where that is enough.
pub(crate) fn labels(grid: &Grid) -> Vec<String> {
    let keys = grid.keys();
    let last = |key: &str| key.rsplit('.').next().unwrap_or(key).to_string();
    let alone = |key: &str| keys.iter().filter(|other| last(other) == last(key)).count() == 1;
    keys.iter().map(|key| if alone(key) { last(key) } else { key.to_string() }).collect()
}

impl Figures {
    /// The figures of the first rows of a sweep.
    pub(crate) fn new(grid: &Grid, rows: &[Value]) -> Figures {
        let figure = |row: &Value, keys: &[&str]| keys.iter().find_map(|key| row[key].as_f64());
        let known = FIGURES.iter().filter(|(_, keys)| rows.iter().any(|row| figure(row, keys).is_some()));
        let known: Vec<&(&str, &[&str])> = known.collect();
        let failed = rows.iter().any(|row| row["status"] != "ok");
        let mut names = labels(grid);
        let of_mean = rows.iter().any(|row| row["reversing.share"].is_number() && row["contact.p_max_MPa"].is_null());
        let named = |name| if of_mean && name == LARGEST { LARGEST_OF_MEAN } else { name };
        names.extend(known.iter().map(|(name, _)| named(*name).to_string()));
        names.extend(failed.then(|| STATUS.to_string()));
        let word = |row: &Value, key: &str| row[key].as_str().unwrap_or("").to_string();
        let cells = |(point, row): (usize, &Value)| {
            let figures = known.iter().map(|(name, keys)| match figure(row, keys) {
                None => "-".to_string(),
                Some(value) if *name == ERROR => format!("{value:.0e}"),
                Some(value) if *name == MOMENT && value.abs() < NOTHING * figure(row, &FORCES).unwrap_or(0.0) => "0".to_string(),
                Some(value) => scene::short(value),
            });
            grid.label(point).into_iter().chain(figures).chain(failed.then(|| word(row, "status"))).collect()
        };
        let without = rows.iter().enumerate().filter(|(_, row)| row["status"] != "ok");
        let reason = |(point, row): (usize, &Value)| format!("{}: {}", grid.label(point).join(", "), word(row, "verdict"));
        Figures { rows: rows.iter().enumerate().map(cells).collect(), reasons: without.map(reason).collect(), names }
    }

    /// The table for a terminal, aligned; figures that find no room are left out.
    pub(crate) fn screen(&self) -> String {
        let wide = |column: usize| {
            let cells = self.rows.iter().map(|row| &row[column]).chain([&self.names[column]]);
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let columns = 0..self.names.len();
        let (first, status): (Vec<usize>, Vec<usize>) = columns.partition(|column| self.names[*column] != STATUS);
        let mut left = WIDTH.saturating_sub(status.iter().map(|column| wide(*column) + 2).sum());
        let mut shown = Vec::new();
        for column in first {
            let need = wide(column) + if shown.is_empty() { 0 } else { 2 };
            if need <= left {
                left -= need;
                shown.push(column);
            }
        }
        shown.extend(status);
        let line = |cells: &[String]| {
            let cells = shown.iter().map(|column| format!("{:>width$}", cells[*column], width = wide(*column)));
            cells.collect::<Vec<_>>().join("  ") + "\n"
        };
        let mut out = line(&self.names);
        out.extend(self.rows.iter().map(|row| line(row)));
        out.extend(self.reasons.iter().take(REASONS).map(|reason| format!("no answer at {reason}\n")));
        out
    }
}
