//! Our numbers against the script's, quantity by quantity.

use super::case::{Case, Norm, Wanted};
use super::row::Row;
use super::tables::{Csv, read_csv, read_json};
use serde_json::Value;
use std::path::Path;

/// What the script says about one quantity.
struct Reference {
    values: Vec<f64>,
    /// Rigid motions at the points that do not count.
    modes: Vec<Vec<f64>>,
    /// Points that count (not the singular ends, say).
    keep: Vec<bool>,
    /// Largest difference between the script's own two levels, in the unit of the values.
    self_error: f64,
}

/// Compares every quantity of a case whose `ours/` and `out.json` are written.
pub(crate) fn case(case: &Case, folder: &Path) -> Result<Vec<Row>, String> {
    rows(&case.quantities, folder)
}

/// Compares quantities in a case folder.
pub(crate) fn rows(wanted: &[Wanted], folder: &Path) -> Result<Vec<Row>, String> {
    let out = read_json(&folder.join("out.json"))?;
    let table = read_csv(&folder.join("ours/contact.csv"))?;
    wanted
        .iter()
        .map(|wanted| {
            let reference = reference(&out, &wanted.name)?;
            let ours = ours(&wanted.ours, &table, folder)?;
            row(wanted, &ours, &reference, coordinates(&table, ours.len()))
        })
        .collect()
}

fn row(wanted: &Wanted, ours: &[f64], reference: &Reference, at: Vec<f64>) -> Result<Row, String> {
    if ours.len() != reference.values.len() {
        let (a, b) = (ours.len(), reference.values.len());
        return Err(format!("{}: {a} values of ours, {b} of the reference", wanted.name));
    }
    let kept = |values: &[f64]| -> Vec<f64> {
        values.iter().zip(&reference.keep).filter(|(_, keep)| **keep).map(|(value, _)| *value).collect()
    };
    let modes: Vec<Vec<f64>> = reference.modes.iter().map(|mode| kept(mode)).collect();
    let (first, second) = (kept(ours), kept(&reference.values));
    if first.is_empty() || first.iter().chain(&second).any(|value| !value.is_finite()) {
        return Err(format!("{}: not a number among the values to compare", wanted.name));
    }
    if first.len() <= modes.len() {
        let (points, free) = (first.len(), modes.len());
        return Err(format!("{}: {points} points and {free} free motions: nothing to compare", wanted.name));
    }
    let raw: Vec<f64> = first.iter().zip(&second).map(|(a, b)| a - b).collect();
    let rest = without_modes(&raw, &modes);
    let scale = first.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    if scale == 0.0 {
        return Err(format!("{}: all our values are zero", wanted.name));
    }
    let shift: Vec<f64> = raw.iter().zip(&rest).map(|(a, b)| a - b).collect();
    Ok(Row {
        quantity: wanted.name.clone(),
        points: first.len(),
        scale,
        difference: size(&rest, wanted.norm) / scale,
        tolerance: wanted.tolerance,
        self_error: reference.self_error / scale,
        norm: wanted.norm,
        at: kept(&at),
        theirs: second.iter().zip(&shift).map(|(value, shift)| value + shift).collect(),
        ours: first,
    })
}

fn size(values: &[f64], norm: Norm) -> f64 {
    match norm {
        Norm::Max => values.iter().fold(0.0, |most, value| most.max(value.abs())),
        Norm::Rms => (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt(),
    }
}

/// `values` minus their projection on the span of `modes` (Gram-Schmidt).
pub(crate) fn without_modes(values: &[f64], modes: &[Vec<f64>]) -> Vec<f64> {
    let mut rest = values.to_vec();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for mode in modes {
        let mut direction = mode.clone();
        let length = dot(&direction, &direction).sqrt();
        for known in &basis {
            take_out(&mut direction, known);
        }
        let left = dot(&direction, &direction).sqrt();
        if left > 1e-10 * length {
            direction.iter_mut().for_each(|value| *value /= left);
            take_out(&mut rest, &direction);
            basis.push(direction);
        }
    }
    rest
}

fn take_out(values: &mut [f64], unit: &[f64]) {
    let share = dot(values, unit);
    values.iter_mut().zip(unit).for_each(|(value, unit)| *value -= share * unit);
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn reference(out: &Value, name: &str) -> Result<Reference, String> {
    let found = out["quantities"].as_array().into_iter().flatten().find(|q| q["name"] == name);
    let record = found.ok_or(format!("the script gives no `{name}`"))?;
    let numbers =
        |value: &Value| -> Vec<f64> { value.as_array().into_iter().flatten().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect() };
    Ok(Reference {
        values: numbers(&record["values"]),
        modes: record["modes"].as_array().into_iter().flatten().map(numbers).collect(),
        keep: record["keep"].as_array().into_iter().flatten().map(|v| v.as_bool() == Some(true)).collect(),
        self_error: record["self_error"].as_f64().ok_or(format!("`{name}` has no self_error"))?,
    })
}

fn ours(place: &str, table: &Csv, folder: &Path) -> Result<Vec<f64>, String> {
    if let Some(path) = place.strip_prefix("summary:") {
        let summary = read_json(&folder.join("ours/summary.json"))?;
        let value = path.split('.').fold(&summary, |value, key| match key.parse::<usize>() {
            Ok(at) => &value[at],
            Err(_) => &value[key],
        });
        let list = value.as_array().map(|list| list.iter().filter_map(Value::as_f64).collect());
        return list.or(value.as_f64().map(|x| vec![x])).ok_or(format!("summary.json has no number {path}"));
    }
    match place.split_once(" - ") {
        Some((a, b)) => Ok(table.column(a)?.iter().zip(table.column(b)?).map(|(a, b)| a - b).collect()),
        None => Ok(table.column(place)?.to_vec()),
    }
}

/// Arc length of the points, for the picture.
fn coordinates(table: &Csv, count: usize) -> Vec<f64> {
    match table.column("s_mm") {
        Ok(s) if s.len() == count => s.to_vec(),
        _ => (0..count).map(|i| i as f64).collect(),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn wanted(tolerance: f64) -> Wanted {
        Wanted { name: "gap".into(), ours: "gap".into(), tolerance, norm: Norm::Max }
    }

    fn same(values: &[f64], modes: Vec<Vec<f64>>) -> Reference {
        Reference { values: values.to_vec(), modes, keep: vec![true; values.len()], self_error: 0.0 }
    }

    #[test]
    fn a_rigid_difference_does_not_count_and_another_does() {
        let modes = vec![vec![1.0; 3], vec![-1.0, 0.0, 1.0]];
        let ours = [1.0, 2.0, 3.0];
        let rigid = row(&wanted(1e-12), &ours, &same(&[5.0, 8.0, 11.0], modes.clone()), vec![0.0; 3]).unwrap();
        assert!(rigid.passed(), "{}", rigid.difference);
        let bent = row(&wanted(1e-3), &ours, &same(&[1.0, 2.1, 3.0], modes), vec![0.0; 3]).unwrap();
        assert!(!bent.passed());
    }

    #[test]
    fn a_value_that_is_no_number_is_an_error_not_a_pass() {
        let result = row(&wanted(0.5), &[1.0, f64::NAN], &same(&[1.0, 1.0], vec![]), vec![0.0; 2]);
        assert!(result.is_err());
    }

    #[test]
    fn a_reference_coarser_than_the_tolerance_does_not_pass() {
        let mut reference = same(&[1.0, 2.0], vec![]);
        reference.self_error = 0.1;
        assert!(!row(&wanted(1e-3), &[1.0, 2.0], &reference, vec![0.0; 2]).unwrap().passed());
    }

    #[test]
    fn a_difference_that_is_all_rigid_motion_is_an_error_not_a_pass() {
        let reference = same(&[9.0], vec![vec![1.0]]);
        assert!(row(&wanted(0.5), &[1.0], &reference, vec![0.0]).is_err());
    }

    #[test]
    fn points_left_out_do_not_count() {
        let mut reference = same(&[1.0, 2.0, 9.0], vec![]);
        reference.keep[2] = false;
        assert!(row(&wanted(1e-9), &[1.0, 2.0, 3.0], &reference, vec![0.0; 3]).unwrap().passed());
    }
}
