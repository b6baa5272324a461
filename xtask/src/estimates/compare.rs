//! What two runs of one scene differ by.

use serde_json::Value;
use std::path::Path;

/// A quantity with an estimated error, by its key in the summary.
pub(super) type Quantity = &'static str;

/// Distance of places, over that of samples, that is round-off.
const SAME: f64 = 1e-9;

/// A run.
pub(super) struct Solved {
    summary: Value,
    /// s, x, z, n_x, n_z, pressure and gap, row by row.
    rows: Vec<[f64; 7]>,
}

impl Solved {
    /// The program's own estimate.
    pub(super) fn estimate(&self, quantity: Quantity) -> Option<f64> {
        self.summary["error"][quantity].as_f64()
    }

    /// Of both bodies (N mm).
    fn energies(&self) -> [f64; 2] {
        ["body1_Nmm", "body2_Nmm"].map(|key| self.summary["energy"][key].as_f64().unwrap_or(0.0))
    }

    /// Where contact ends (mm), ascending, the ends of the surface included where they are in contact.
    fn ends(&self) -> Vec<f64> {
        self.summary["contact"]["ends_mm"].as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
    }
}

/// Reads a folder.
pub(super) fn read(folder: &Path) -> Result<Solved, String> {
    let text = |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| format!("{name}: {error}"));
    let summary = serde_json::from_str(&text("summary.json")?).map_err(|error| error.to_string())?;
    let table = text("contact.csv")?;
    let mut lines = table.lines();
    let head: Vec<&str> = lines.next().unwrap_or("").split(',').collect();
    let columns = ["s_mm", "x_mm", "z_mm", "nx", "nz", "pressure_MPa", "gap_um"];
    let places = columns.map(|name| head.iter().position(|column| *column == name));
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        places.map(|place| place.and_then(|p| fields.get(p)?.parse().ok()).unwrap_or(f64::NAN))
    };
    Ok(Solved { summary, rows: lines.map(row).collect() })
}

/// Relative differences as the summary counts them: of the gap its largest, over the largest gap, without the best rigid motion; of the pressure
/// L2 over the inner 95 % of the contact, where both runs have it at the same places; of the energies, those of both bodies over their sum.
pub(super) fn differences(coarse: &Solved, fine: &Solved, modes: usize) -> Vec<(Quantity, f64)> {
    if fine.summary["contact"].is_null() {
        return vec![("gap_relative", of_gaps(&coarse.rows, &fine.rows, modes))];
    }
    let mut found = vec![("energy_relative", of_energies(coarse.energies(), fine.energies()))];
    found.extend(of_pressures(&coarse.rows, &fine.rows, &fine.ends()).map(|apart| ("pressure_relative", apart)));
    found
}

fn of_energies(a: [f64; 2], b: [f64; 2]) -> f64 {
    ((a[0] - b[0]).abs() + (a[1] - b[1]).abs()) / (b[0] + b[1])
}

/// From one end of a contact to the other. Where contact ends in between the pressure goes like a square root: what a sample there is off by says
/// where it happens to lie and nothing of the strip that it stands for, so that those next to such an end are left out.
fn of_pressures(a: &[[f64; 7]], b: &[[f64; 7]], ends: &[f64]) -> Option<f64> {
    let [from, between @ .., to] = ends else { return None };
    let step = (b.last()?[0] - b.first()?[0]).abs() / (b.len() - 1) as f64;
    if a.len() != b.len() || a.iter().zip(b).any(|(a, b)| (a[0] - b[0]).abs() > SAME * step) {
        return None;
    }
    let margin = 0.025 * (to - from);
    let inner = |s: f64| s >= from + margin && s <= to - margin && between.iter().all(|end| (s - end).abs() > step);
    let (mut off, mut size) = (0.0, 0.0);
    for (b, a) in b.iter().zip(a).filter(|(b, _)| inner(b[0])) {
        off += (a[5] - b[5]).powi(2);
        size += b[5].powi(2);
    }
    Some((off / size).sqrt())
}

fn of_gaps(a: &[[f64; 7]], b: &[[f64; 7]], modes: usize) -> f64 {
    let mut off: Vec<f64> = a.iter().zip(b).map(|(a, b)| a[6] - b[6]).collect();
    // Closing by a motion along z, and by turning about the origin, made orthogonal to it.
    let along: Vec<f64> = b.iter().map(|row| row[4]).collect();
    let mut turning: Vec<f64> = b.iter().map(|row| row[1] * row[4] - row[2] * row[3]).collect();
    remove(&mut turning, &along);
    remove(&mut off, &along);
    if modes > 1 {
        remove(&mut off, &turning);
    }
    off.iter().fold(0.0_f64, |most, d| most.max(d.abs())) / b.iter().fold(0.0_f64, |most, row| most.max(row[6]))
}

/// Takes the part along a mode out of values.
fn remove(values: &mut [f64], mode: &[f64]) {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let factor = dot(values, mode) / dot(mode, mode);
    values.iter_mut().zip(mode).for_each(|(value, m)| *value -= factor * m);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pressure that goes like a square root to an end of contact at 10, between ends at 0 and 20, and so does the same with that end moved by a
    /// thousandth of the distance of samples; one of these lies just inside it.
    #[test]
    fn a_sample_next_to_an_end_of_contact_does_not_decide() {
        let rows = |end: f64, first: f64| -> Vec<[f64; 7]> {
            let row = |i: usize| {
                let s = first + 0.05 * i as f64;
                [s, 0.0, 0.0, 0.0, 0.0, 1.0 + (end - s).max(0.0).sqrt(), 0.0]
            };
            (0..=400).map(row).collect()
        };
        let apart = |first: f64| of_pressures(&rows(10.0 + 5e-5, first), &rows(10.0, first), &[0.0, 10.0, 12.0, 20.0]);
        let [chance, usual] = [-1e-9, 0.025].map(|first| apart(first).unwrap_or(f64::NAN));
        assert!((chance / usual - 1.0).abs() < 0.1, "{chance:e} {usual:e}");
    }

    #[test]
    fn places_that_are_the_same_but_for_round_off_are_compared_and_others_are_not() {
        let rows = |more: f64| [0.0, 1.0, 2.0, 3.0].map(|s| [s * (1.0 + more), 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        assert_eq!(of_pressures(&rows(1e-15), &rows(0.0), &[0.0, 3.0]), Some(0.0));
        assert_eq!(of_pressures(&rows(1e-3), &rows(0.0), &[0.0, 3.0]), None);
    }

    #[test]
    fn errors_of_one_body_do_not_make_up_for_those_of_the_other() {
        assert!((of_energies([1.1, 2.9], [1.0, 3.0]) - 0.05).abs() < 1e-12);
    }
}
