//! The table on the screen, and docs/stability.md.

use super::row::Row;
use std::fs;
use std::path::Path;

/// One case in a line, and below it what does not hold.
pub(crate) fn line(row: &Row) -> String {
    let r = &row.result;
    let verdict = if r.failures.is_empty() { "ok" } else { "FAILED" };
    let mut text = format!(
        "{:<22} {verdict:<7} balance {:>7}  complementarity {:>7}  round trip {:>7}  estimate {:>7}  condition {:>7}  off by {:<18} {:5.1} s  {}",
        row.case.name,
        number(r.balance),
        number(r.complementarity),
        number(r.round_trip),
        number(r.estimate),
        number(r.condition),
        deviation(row),
        row.seconds,
        shorten(&r.says, 90),
    );
    r.failures.iter().for_each(|failure| text += &format!("\n    {failure}"));
    text
}

fn number(value: Option<f64>) -> String {
    value.map_or("-".into(), |value| format!("{value:.0e}"))
}

fn deviation(row: &Row) -> String {
    match row.result.deviation {
        Some((off, 0.0)) => format!("{off:.0e} (bit for bit)"),
        Some((off, within)) => format!("{off:.0e} of {within:.0e}"),
        None => "-".into(),
    }
}

fn shorten(text: &str, most: usize) -> String {
    let short: String = text.chars().take(most).collect();
    if short.len() < text.len() { short + " .." } else { short }
}

/// Writes docs/stability.md.
pub(crate) fn write(root: &Path, rows: &[Row]) -> Result<(), String> {
    let failed: Vec<&Row> = rows.iter().filter(|row| !row.result.failures.is_empty()).collect();
    let mut page = format!(
        "# Extreme cases\n\nWritten by `cargo xtask stability --docs` from [stability.toml](../verify/stability.toml), where each case stands with \
         its scene and what is demanded of it. {} cases, {} failed. Each must be right, or refused by name: never wrong in silence.\n\n\
         Balance: the force carried against the load. Complementarity: the largest of min(pressure, opening) of a contact, relative. Round trip: the pressure \
         that a contact solve on the shape gives back, same operators. Estimate: the program's own, of the gap, else the larger of energy and pressure. Condition: largest over smallest singular value of the scaled system \
         of the points in contact, which a contact or the round trip of a shape is solved by. \
         Off by: the largest deviation from what is expected, and what is allowed; 0 of bit for bit is demanded where only powers of two change.\n\n\
         | case | result | balance | complementarity | round trip | estimate | condition | off by | right because |\n|---|---|---|---|---|---|---|---|---|\n",
        rows.len(),
        failed.len()
    );
    for row in rows {
        let r = &row.result;
        let verdict = if r.failures.is_empty() { shorten(&r.says, 130) } else { format!("**FAILED** {}", r.failures.join("; ")) };
        page += &format!(
            "| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
            cell(&row.case.what),
            cell(&verdict),
            number(r.balance),
            number(r.complementarity),
            number(r.round_trip),
            number(r.estimate),
            number(r.condition),
            deviation(row),
            cell(&row.case.right)
        );
    }
    let path = root.join("docs/stability.md");
    fs::write(&path, page).map_err(|error| format!("{}: {error}", path.display()))
}

/// Text that ends no cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}
