//! What two runs of one scene differ by.

use serde_json::Value;
use std::path::Path;

/// A quantity with an estimated error, by its key in the summary.
pub(super) type Quantity = &'static str;

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

    fn energy(&self) -> f64 {
        let of = |key: &str| self.summary["energy"][key].as_f64().unwrap_or(0.0);
        of("body1_Nmm") + of("body2_Nmm")
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
/// L2 over the inner 95 % of the contact, where both runs have it at the same places; of the energy.
pub(super) fn differences(coarse: &Solved, fine: &Solved, modes: usize) -> Vec<(Quantity, f64)> {
    if fine.summary["contact"].is_null() {
        return vec![("gap_relative", of_gaps(&coarse.rows, &fine.rows, modes))];
    }
    let mut found = vec![("energy_relative", (coarse.energy() / fine.energy() - 1.0).abs())];
    let same = coarse.rows.iter().zip(&fine.rows).all(|(a, b)| a[0] == b[0]);
    let ends: Vec<f64> = fine.summary["contact"]["ends_mm"].as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
    if let (true, [from, .., to]) = (same, &ends[..]) {
        found.push(("pressure_relative", of_pressures(&coarse.rows, &fine.rows, [*from, *to])));
    }
    found
}

fn of_pressures(a: &[[f64; 7]], b: &[[f64; 7]], [from, to]: [f64; 2]) -> f64 {
    let margin = 0.025 * (to - from);
    let inner = |row: &&[f64; 7]| row[0] >= from + margin && row[0] <= to - margin;
    let (mut off, mut size) = (0.0, 0.0);
    for (b, a) in b.iter().zip(a).filter(|(b, _)| inner(b)) {
        off += (a[5] - b[5]).powi(2);
        size += b[5].powi(2);
    }
    (off / size).sqrt()
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
