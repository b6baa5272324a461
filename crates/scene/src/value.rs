//! Faults of single values: out of range, or missing.

use crate::fault::Fault;

/// A number that must be finite and positive.
///
/// # Errors
/// The fault of `key`, which names `what` it is and its unit.
pub fn positive(key: &str, value: f64, what: &str, unit: &str) -> Result<(), Fault> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    let kind = if value == 0.0 { "zero" } else { "negative" };
    Err(Fault::at(key, "wrong-value", format!("{kind} {what}: {key} = {value}{unit}"), format!("give a {what} greater than 0")))
}

/// A missing key, blamed on its table.
pub fn missing(key: &str, why: &str, example: &str) -> Fault {
    Fault::at(key, "missing-key", format!("the key `{key}` is missing: {why}"), format!("add `{example}`"))
}
