//! The curves of a sweep: pressure, gap and the rest over s, one row a place, points one after another.

use std::collections::BTreeMap;
use std::path::Path;

use report::{Axis, LinePlot, Series};
use scene::{Fault, Scene};
use wearshape::Profile;

use crate::folder::Folder;
use crate::grid::Grid;
use crate::sweep::drawn::Drawn;
use crate::sweep::figures;
use crate::sweep::rows::lines;

/// The file of all curves.
pub(crate) const CURVES: &str = "curves.csv";

/// The columns of contact.csv between the number of the point and the values of its axes.
const COLUMNS: [&str; 10] = [
    "s_mm",
    "x_mm",
    "y_mm",
    "z_mm",
    "pressure_MPa",
    "pressure_solved_MPa",
    "shear_MPa",
    "gap_um",
    "opening_um",
    "wear_rate_um_per_s",
];

fn columns() -> impl Iterator<Item = &'static report::ContactColumn> {
    report::CONTACT_COLUMNS.iter().filter(|(name, _)| COLUMNS.contains(name))
}

/// The column of sweeps over motions that reverse, and those of sweeps over scenes with heat.
const BACK: &str = "pressure_back_MPa";
const TEMPERATURES: [&str; 2] = ["temperature1_degC", "temperature2_degC"];

/// The last columns of a sweep, which not every scene has.
pub(crate) fn extras(first: &Scene, grid: &Grid) -> Vec<&'static str> {
    let over = |key: &str| grid.keys().iter().any(|given| given.starts_with(key));
    let hot = first.heat.is_some() || over("heat");
    let given = first.sliding.as_ref().is_some_and(|sliding| sliding.reversing.is_some() || sliding.cycle.is_some());
    let reverses = given || over("sliding.reversing") || over("sliding.cycle");
    let temperatures = TEMPERATURES.into_iter().filter(|_| hot);
    temperatures.chain(reverses.then_some(BACK)).collect()
}

/// The first line of the file.
pub(crate) fn header(grid: &Grid, extras: &[&'static str]) -> String {
    report::table(&names(grid, extras), Vec::<Vec<String>>::new())
}

fn names<'g>(grid: &'g Grid, extras: &[&'static str]) -> Vec<&'g str> {
    let named = std::iter::once("point").chain(columns().map(|(name, _)| *name)).chain(grid.keys());
    named.chain(extras.iter().copied()).collect()
}

/// The rows of a point.
pub(crate) fn curve(grid: &Grid, point: usize, profile: &Profile, extras: &[&'static str]) -> String {
    let axes = grid.at(point);
    // A motion that keeps its sense has no pressure backward, a scene without heat no temperature.
    let extra = |name: &str| match TEMPERATURES.iter().position(|known| *known == name) {
        Some(body) => &profile.temperature[body],
        None => &profile.pressure_back,
    };
    let row = |place: usize| {
        let numbers = columns().map(move |(_, value)| scene::number_text(value(profile, place)));
        let axes = axes.iter().map(|(_, value)| value.to_string());
        let more = extras.iter().map(|name| scene::number_text(extra(name).get(place).copied().unwrap_or(f64::NAN)));
        std::iter::once(point.to_string()).chain(numbers).chain(axes).chain(more).collect::<Vec<_>>()
    };
    let text = report::table(&names(grid, extras), (0..profile.s.len()).map(row));
    text.split_once('\n').map_or("", |(_, rows)| rows).to_string()
}

/// The bytes that the curves of the first points have in a file: what an interrupted sweep keeps of it.
pub(crate) fn length_of(file: &Path, points: usize) -> u64 {
    let mut lines = lines(file);
    let header = lines.next().map_or(0, |line| line.len());
    let whole = lines.take_while(|line| line.ends_with('\n') && of_point(line).is_some_and(|point| point < points));
    (header + whole.map(|line| line.len()).sum::<usize>()) as u64
}

fn of_point(line: &str) -> Option<usize> {
    line.split(',').next()?.parse().ok()
}

/// Takes the curves of points that are not drawn out of the file.
pub(crate) fn leave_drawn(folder: &Folder, drawn: &Drawn) -> Result<(), Fault> {
    if drawn.all_kept() {
        return Ok(());
    }
    let points = drawn.points();
    let kept = |line: &String| of_point(line).is_none_or(|point| points.contains(&point));
    folder.replace(CURVES, &lines(&folder.path().join(CURVES)).filter(kept).collect::<String>())
}

/// The curves of the points that are drawn, overlaid: pressure and gap, as far as they are known.
pub(crate) fn plots(file: &Path, grid: &Grid, drawn: &Drawn, title: &str) -> Vec<LinePlot> {
    let mut curves: BTreeMap<usize, Vec<Vec<f64>>> = BTreeMap::new();
    let header = lines(file).next().unwrap_or_default();
    let drawn = drawn.points();
    let extras: Vec<&str> = TEMPERATURES.into_iter().chain([BACK]).filter(|name| has_column(&header, name)).collect();
    for line in lines(file).skip(1) {
        let Some(point) = of_point(&line).filter(|point| drawn.contains(point)) else { continue };
        let cells: Vec<&str> = line.trim_end().split(',').skip(1).collect();
        let more = cells.len().saturating_sub(extras.len()).max(COLUMNS.len());
        let known = cells.iter().take(COLUMNS.len()).chain(&cells[more.min(cells.len())..]);
        curves.entry(point).or_default().push(known.map(|number| number.parse().unwrap_or(f64::NAN)).collect());
    }
    let column = |name: &str| COLUMNS.iter().chain(&extras).position(|known| *known == name).unwrap_or(0);
    let by = figures::labels(grid).join(", ");
    let plot = |what: &str, y_label: &str, name: &str| {
        let y = column(name);
        let place = |row: &Vec<f64>| Some((*row.first()?, *row.get(y)?));
        let series = curves.iter().enumerate().map(|(number, (point, rows))| Series {
            name: grid.label(*point).join(", "),
            points: rows.iter().filter_map(place).collect(),
            marks: false,
            // Colours come again after seven.
            dashed: number >= 7,
        });
        LinePlot {
            title: format!("{title}: {what} by {by}"),
            x_label: "s (mm)".into(),
            y_label: y_label.into(),
            axes: [Axis::Linear, Axis::Linear],
            from_zero: true,
            series: series.filter(|series| series.points.iter().any(|point| point.1.is_finite())).collect(),
        }
    };
    let both_ways = extras.contains(&BACK);
    let forward = if both_ways { "contact pressure forward" } else { "contact pressure" };
    let mut plots = vec![plot(forward, "pressure (MPa)", "pressure_MPa")];
    plots.extend(both_ways.then(|| plot("contact pressure backward", "pressure (MPa)", BACK)));
    plots.push(plot("gap", "gap (\u{b5}m)", "gap_um"));
    for (number, name) in (1..).zip(TEMPERATURES).filter(|(_, name)| extras.contains(name)) {
        plots.push(plot(&format!("temperature of body {number}"), "temperature (\u{b0}C)", name));
    }
    let flat = |plot: &LinePlot| {
        plot.series.iter().flat_map(|series| &series.points).all(|point| !(point.1 != 0.0 && point.1.is_finite()))
    };
    plots.into_iter().filter(|plot| !flat(plot)).collect()
}

/// Whether a header has a column.
fn has_column(header: &str, name: &str) -> bool {
    header.trim_end().split(',').any(|column| column == name)
}
