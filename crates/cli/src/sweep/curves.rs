//! The curves of a sweep: pressure, gap and the rest over s, one row a place, points one after another.

use std::collections::BTreeMap;
use std::path::Path;

use report::{Axis, LinePlot, Series};
use wearshape::Profile;

use crate::grid::Grid;
use crate::sweep::figures;
use crate::sweep::rows::lines;

/// The file of all curves.
pub(crate) const CURVES: &str = "curves.csv";
/// Points that still can be told apart in one picture.
const MOST_DRAWN: usize = 12;

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

/// Whether a point of a sweep is drawn: all where they are few, else some that are evenly spread, with the first and the last.
pub(crate) fn is_drawn(point: usize, count: usize) -> bool {
    count <= MOST_DRAWN || (0..MOST_DRAWN).any(|number| point == number * (count - 1) / (MOST_DRAWN - 1))
}

/// The last column of a sweep over motions that reverse.
const BACK: &str = "pressure_back_MPa";

/// The first line of the file; `both_ways` where motions reverse.
pub(crate) fn header(grid: &Grid, both_ways: bool) -> String {
    report::table(&names(grid, both_ways), Vec::<Vec<String>>::new())
}

fn names(grid: &Grid, both_ways: bool) -> Vec<&str> {
    let named = std::iter::once("point").chain(columns().map(|(name, _)| *name)).chain(grid.keys());
    named.chain(both_ways.then_some(BACK)).collect()
}

/// The rows of a point.
pub(crate) fn curve(grid: &Grid, point: usize, profile: &Profile, both_ways: bool) -> String {
    let axes = grid.at(point);
    let row = |place: usize| {
        let numbers = columns().map(move |(_, value)| scene::number_text(value(profile, place)));
        let axes = axes.iter().map(|(_, value)| value.to_string());
        // A motion that keeps its sense has no pressure backward.
        let back = || scene::number_text(profile.pressure_back.get(place).copied().unwrap_or(f64::NAN));
        std::iter::once(point.to_string()).chain(numbers).chain(axes).chain(both_ways.then(back)).collect::<Vec<_>>()
    };
    let text = report::table(&names(grid, both_ways), (0..profile.s.len()).map(row));
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

/// The curves of the points that are drawn, overlaid: pressure and gap, as far as they are known.
pub(crate) fn plots(file: &Path, grid: &Grid, title: &str) -> Vec<LinePlot> {
    let mut curves: BTreeMap<usize, Vec<Vec<f64>>> = BTreeMap::new();
    let both_ways = lines(file).next().is_some_and(|header| header.trim_end().ends_with(BACK));
    for line in lines(file).skip(1) {
        let Some(point) = of_point(&line).filter(|point| is_drawn(*point, grid.count)) else { continue };
        let cells: Vec<&str> = line.trim_end().split(',').skip(1).collect();
        let back = cells.last().copied().filter(|_| both_ways);
        let numbers = cells.iter().copied().take(COLUMNS.len()).chain(back).map(|number| number.parse().unwrap_or(f64::NAN));
        curves.entry(point).or_default().push(numbers.collect());
    }
    let column = |name: &str| match name {
        BACK => COLUMNS.len(),
        _ => COLUMNS.iter().position(|known| *known == name).unwrap_or(0),
    };
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
    let forward = if both_ways { "contact pressure forward" } else { "contact pressure" };
    let mut plots = vec![plot(forward, "pressure (MPa)", "pressure_MPa")];
    plots.extend(both_ways.then(|| plot("contact pressure backward", "pressure (MPa)", BACK)));
    plots.push(plot("gap", "gap (\u{b5}m)", "gap_um"));
    let flat = |plot: &LinePlot| {
        plot.series.iter().flat_map(|series| &series.points).all(|point| !(point.1 != 0.0 && point.1.is_finite()))
    };
    plots.into_iter().filter(|plot| !flat(plot)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_most_twelve_points_are_drawn_with_the_first_and_the_last() {
        for count in [1, 2, 12, 13, 100, 10_000_000] {
            let drawn: Vec<usize> = (0..count.min(200)).filter(|point| is_drawn(*point, count)).collect();
            assert!(drawn.len() <= MOST_DRAWN && drawn[0] == 0 && is_drawn(count - 1, count), "{count}: {drawn:?}");
        }
        assert_eq!((0..100).filter(|point| is_drawn(*point, 100)).count(), MOST_DRAWN);
    }
}
