//! The table of two programs on the screen, and docs/speed-by-release.md.

use super::row::Row;
use super::spread::{Spread, geometric_mean};
use crate::machine::machine;
use std::fs;
use std::path::Path;

const PAGE: &str = "docs/speed-by-release.md";
/// Where the newest row of the releases goes, and between which marks the table of the last measurement stands.
const ROWS: &str = "<!-- rows: the newest first; `cargo xtask bench --against REV --docs` adds one -->\n";
const TABLE: [&str; 2] = ["<!-- table: begin; written by the same command -->", "<!-- table: end -->"];

/// The first line on the screen.
pub(crate) fn head(old: &str) -> String {
    format!(
        "{:<34} {:>28}   {:>20}   {:>16}",
        format!("this tree over {old}"),
        "ratio, median (quartiles)",
        "processor s",
        "peak MB"
    )
}

/// One case on the screen.
pub(crate) fn line(row: &Row) -> String {
    let [ratio, seconds, peaks] = cells(row);
    format!("{:<34} {ratio:>28}   {seconds:>20}   {peaks:>16}", row.case.name)
}

fn cells(row: &Row) -> [String; 3] {
    let (Some(Spread { median, quartiles: [low, high] }), Some([old, new]), Some([from, to])) =
        (row.ratio(), row.seconds(), row.peaks())
    else {
        return ["no answer of one of them".into(), "-".into(), "-".into()];
    };
    [format!("{median:.2} ({low:.2} .. {high:.2})"), format!("{old:.3} -> {new:.3}"), format!("{from:.0} -> {to:.0}")]
}

/// What all cases say together.
pub(crate) fn whole(rows: &[Row]) -> String {
    let Some(Whole { mean, least, most, cases }) = Whole::of(rows) else { return "no case ran with both programs".into() };
    format!("{cases} cases: geometric mean {mean:.2}; least {:.2} ({}), most {:.2} ({})", least.0, least.1, most.0, most.1)
}

/// All cases together: how many, the geometric mean of their ratios, the least and the most with their names.
struct Whole {
    cases: usize,
    mean: f64,
    least: (f64, String),
    most: (f64, String),
}

impl Whole {
    fn of(rows: &[Row]) -> Option<Whole> {
        let mut ratios: Vec<(f64, String)> =
            rows.iter().filter_map(|row| Some((row.ratio()?.median, row.case.name.clone()))).collect();
        ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
        let numbers: Vec<f64> = ratios.iter().map(|(ratio, _)| *ratio).collect();
        let (least, most) = (ratios.first()?.clone(), ratios.last()?.clone());
        Some(Whole { cases: ratios.len(), mean: geometric_mean(&numbers), least, most })
    }
}

/// Adds a row to the page and replaces its last table; `names` are those of the earlier program and of this tree.
pub(crate) fn write(root: &Path, names: [&str; 2], rows: &[Row], repeat: usize) -> Result<(), String> {
    let path = root.join(PAGE);
    let page = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let page = with(&page, names, rows, &format!("{}; {repeat} pairs of runs a case, one thread", machine()))
        .ok_or_else(|| format!("{}: its marks are not there", path.display()))?;
    fs::write(&path, page).map_err(|error| format!("{}: {error}", path.display()))
}

/// The page with a further row and another table.
fn with(page: &str, [old, new]: [&str; 2], rows: &[Row], machine: &str) -> Option<String> {
    let (head, rest) = page.split_once(ROWS)?;
    let (between, rest) = rest.split_once(TABLE[0])?;
    let (_, tail) = rest.split_once(TABLE[1])?;
    // The head of the table comes before its newest row.
    let columns = "| revision | against | cases | geometric mean | least | most |\n|---|---|---|---|---|---|\n";
    let earlier = between.trim_start_matches('\n').strip_prefix(columns).unwrap_or_else(|| between.trim_start_matches('\n'));
    let Whole { mean, least, most, cases } = Whole::of(rows)?;
    let row = format!("| {new} | {old} | {cases} | {mean:.2} | {:.2} ({}) | {:.2} ({}) |\n", least.0, least.1, most.0, most.1);
    let mut table =
        format!("\n\nMeasured {machine}.\n\n| case | {new} over {old} | processor s | peak MB |\n|---|---|---|---|\n");
    for row in rows {
        table += &format!("| {} | {} |\n", row.case.name, cells(row).join(" | "));
    }
    Some(format!("{head}{ROWS}\n{columns}{row}{earlier}{}{table}\n{}{tail}", TABLE[0], TABLE[1]))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::speed::case::Case;
    use crate::speed::process::Taken;

    fn row(name: &str, seconds: [f64; 2]) -> Row {
        let case = Case { name: name.into(), command: "run".into(), scene: name.into(), set: vec![] };
        let runs = seconds.map(|seconds| vec![Taken { user: seconds, system: 0.0, peak: 20.0 }]);
        Row { case, runs: Some(runs) }
    }

    #[test]
    fn a_second_measurement_adds_a_row_above_the_first_and_takes_the_place_of_its_table() {
        let bare = format!("# Title\n\n{ROWS}\n{}\n{}\n", TABLE[0], TABLE[1]);
        let first = with(&bare, ["a", "b"], &[row("cam", [1.0, 0.5])], "then").unwrap();
        let second = with(&first, ["b", "c"], &[row("cam", [0.5, 0.25]), row("knee", [1.0, 2.0])], "later").unwrap();
        let rows: Vec<&str> = second.lines().filter(|line| line.starts_with("| c |") || line.starts_with("| b |")).collect();
        assert_eq!(rows, ["| c | b | 2 | 1.00 | 0.50 (cam) | 2.00 (knee) |", "| b | a | 1 | 0.50 | 0.50 (cam) | 0.50 (cam) |"]);
        assert_eq!(second.matches("| revision |").count(), 1);
        assert!(second.contains("Measured later") && !second.contains("Measured then"));
        assert!(second.contains("| knee | 2.00 (2.00 .. 2.00) | 1.000 -> 2.000 | 20 -> 20 |"), "{second}");
    }

    #[test]
    fn a_case_that_one_program_refuses_has_a_row_and_counts_for_nothing() {
        let mut refused = row("new", [1.0, 1.0]);
        refused.runs = None;
        assert!(line(&refused).contains("no answer"));
        assert!(whole(&[refused, row("cam", [1.0, 0.5])]).starts_with("1 cases: geometric mean 0.50"));
    }
}
