//! What an item is made of: rows, files, the commands that repeat it, remarks.

use report::{Axis, LinePlot, Series, columns_csv, line_plot};

use crate::reproduce::row::Row;
use crate::reproduce::run::Run;

/// A file of the item's folder.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct File {
    /// Name.
    pub(crate) name: String,
    /// Text.
    pub(crate) text: String,
}

/// A computed item.
#[derive(Debug, Clone, Default)]
pub(crate) struct Made {
    /// Rows of the comparison.
    pub(crate) rows: Vec<Row>,
    /// Tables and pictures.
    pub(crate) files: Vec<File>,
    /// Commands that repeat the curves one by one.
    pub(crate) commands: Vec<String>,
    /// Remarks on the whole item.
    pub(crate) remarks: Vec<String>,
    /// scene.resolved.toml of the first run.
    pub(crate) resolved: String,
}

impl Made {
    /// Keeps a file.
    pub(super) fn file(&mut self, name: &str, text: String) {
        self.files.push(File { name: name.into(), text });
    }

    /// Draws curves, as `<name>.svg` and with all digits as `<name>.csv`.
    pub(super) fn draw(&mut self, name: &str, plot: &LinePlot) {
        self.file(&format!("{name}.svg"), line_plot(plot));
        self.file(&format!("{name}.csv"), curves_csv(plot));
    }

    /// The same with a picture that shows only values within a range; the table has all.
    pub(super) fn draw_within(&mut self, name: &str, plot: &LinePlot, [low, high]: [f64; 2]) {
        let mut shown = plot.clone();
        for point in shown.series.iter_mut().flat_map(|series| &mut series.points) {
            if !(low..=high).contains(&point.1) {
                point.1 = f64::NAN;
            }
        }
        self.file(&format!("{name}.svg"), line_plot(&shown));
        self.file(&format!("{name}.csv"), curves_csv(plot));
    }

    /// Notes that a run went into the item.
    pub(super) fn ran(&mut self, run: &Run) {
        if self.resolved.is_empty() {
            self.resolved.clone_from(&run.resolved);
        }
        if !self.commands.contains(&run.command) {
            self.commands.push(run.command.clone());
        }
    }
}

/// A plot with evenly counted axes.
pub(super) fn plot(title: &str, x_label: &str, y_label: &str, series: Vec<Series>) -> LinePlot {
    LinePlot {
        title: title.into(),
        x_label: x_label.into(),
        y_label: y_label.into(),
        axes: [Axis::Linear, Axis::Linear],
        from_zero: true,
        series,
    }
}

/// A curve without marks.
pub(super) fn series(name: impl Into<String>, points: Vec<(f64, f64)>) -> Series {
    Series { name: name.into(), points, marks: false, dashed: false }
}

/// The curves of a plot as a table: the abscissa once where all curves share it, else one pair of columns a curve.
fn curves_csv(plot: &LinePlot) -> String {
    let places = |series: &Series| series.points.iter().map(|point| point.0).collect::<Vec<f64>>();
    let Some(first) = plot.series.first().map(places) else { return String::new() };
    let shared = plot.series.iter().all(|series| places(series) == first);
    let mut columns = vec![];
    for (number, series) in plot.series.iter().enumerate() {
        let of = if series.name.is_empty() { String::new() } else { format!("{}: ", series.name) };
        if number == 0 || !shared {
            let of = if shared { "" } else { &of };
            columns.push((format!("{of}{}", plot.x_label), places(series)));
        }
        columns.push((format!("{of}{}", plot.y_label), series.points.iter().map(|point| point.1).collect()));
    }
    columns_csv(&columns)
}
