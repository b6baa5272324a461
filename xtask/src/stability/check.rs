//! What must hold of a finished run.

use super::case::{Number, Scaled, Scene};
use crate::verify::tables::{Csv, read_csv, read_json};
use serde_json::Value;
use std::path::Path;

/// Round-off that a balance may be off by, relative to the load.
const BALANCE: f64 = 1e-9;
/// Largest `min(pressure, opening)` of a contact, relative.
const COMPLEMENTARITY: f64 = 1e-8;
/// Largest difference of the pressure that a contact solve on the same operators gives back.
const ROUND_TRIP: f64 = 1e-6;

/// What a case came to.
#[derive(Default)]
pub(crate) struct Result {
    /// Status and verdict in short.
    pub(crate) says: String,
    pub(crate) balance: Option<f64>,
    pub(crate) complementarity: Option<f64>,
    pub(crate) round_trip: Option<f64>,
    pub(crate) estimate: Option<f64>,
    /// Largest over smallest singular value of the system solved on the contact surface.
    pub(crate) condition: Option<f64>,
    /// Largest deviation from what is expected, and what was allowed.
    pub(crate) deviation: Option<(f64, f64)>,
    /// What does not hold; empty when the case is right.
    pub(crate) failures: Vec<String>,
}

impl Result {
    fn demand(&mut self, holds: bool, otherwise: String) {
        if !holds {
            self.failures.push(otherwise);
        }
    }

    fn deviates(&mut self, what: &str, deviation: f64, within: f64) {
        let worse = self.deviation.is_none_or(|(before, allowed)| deviation / within.max(1e-300) > before / allowed.max(1e-300));
        if worse {
            self.deviation = Some((deviation, within));
        }
        self.demand(deviation <= within, format!("{what}: off by {deviation:.1e}, allowed {within:.0e}"));
    }
}

/// Checks a run that ended with `exit` and printed `document`, its folder, and the folders of the earlier cases beside it.
pub(crate) fn scene(case: &Scene, exit: Option<i32>, document: &Value, folder: &Path, beside: &Path) -> Result {
    let mut result = Result { says: says(document), ..Result::default() };
    let code = exit.map_or("a signal".to_string(), |code| code.to_string());
    result.demand(exit == Some(case.exit), format!("exit {code}, expected {}", case.exit));
    if let Some(words) = &case.says {
        let whole = document.to_string();
        result.demand(whole.contains(words.as_str()), format!("does not say `{words}`"));
    }
    case.numbers.iter().for_each(|number| check_number(number, document, &mut result));
    // A refusal has no table, and a singular pressure is a measure: it has no values at points.
    let singular = document.pointer("/pressure/regime").is_some_and(|regime| regime == "singular");
    if document.get("error").is_some_and(|error| error.get("code").is_some()) || document["status"] == "refused" || singular {
        return result;
    }
    residuals(document, folder, &mut result);
    match read_csv(&folder.join("contact.csv")) {
        Ok(table) => {
            finite(&table, &mut result);
            if let Some(scaled) = &case.scaled {
                check_scaled(scaled, folder, beside, &mut result);
            }
        }
        Err(message) => result.failures.push(message),
    }
    result
}

/// Status, or the code of the error, and the sentence.
fn says(document: &Value) -> String {
    let text = |value: &Value| value.as_str().unwrap_or_default().to_string();
    match document.get("error").filter(|error| error.get("code").is_some()) {
        Some(error) => format!("refused ({}): {}", text(&error["code"]), text(&error["message"])),
        None => format!("{}: {}", text(&document["status"]), text(&document["verdict"])),
    }
}

fn check_number(number: &Number, document: &Value, result: &mut Result) {
    let read = |at: &str| document.pointer(at).and_then(Value::as_f64);
    let divisor = number.over.as_ref().map_or(Some(1.0), |at| read(at));
    let Some(value) = read(&number.of).zip(divisor).map(|(a, b)| a / b) else {
        let over = number.over.as_deref().unwrap_or_default();
        return result.failures.push(format!("no number {} {over}", number.of));
    };
    if let Some((expected, within)) = number.is {
        result.deviates(&number.of, ((value - expected) / expected).abs(), within);
    }
    if let Some(most) = number.below {
        result.demand(value < most, format!("{} = {value:.3e} is not below {most:.0e}", number.of));
    }
    if let Some(least) = number.above {
        result.demand(value > least, format!("{} = {value:.3e} is not above {least:.0e}", number.of));
    }
}

fn residuals(document: &Value, folder: &Path, result: &mut Result) {
    let number = |at: &str| document.pointer(at).and_then(Value::as_f64);
    let load = std::fs::read_to_string(folder.join("scene.resolved.toml")).ok().and_then(|text| text.parse::<toml::Table>().ok());
    let load = load.as_ref().and_then(|scene| scene.get("load")?.get("force")?.as_float());
    let carried = number("/contact/force_N").or(number("/pressure/force_N"));
    result.balance = load.zip(carried).map(|(load, carried)| (carried / load - 1.0).abs());
    result.complementarity = number("/contact/complementarity");
    result.round_trip = number("/shape/roundtrip_same");
    result.condition = number("/interface/condition");
    let others = ["energy", "pressure"].iter().filter_map(|what| number(&format!("/error/{what}_relative")));
    result.estimate = number("/error/gap_relative").or(others.reduce(f64::max));
    if let Some(balance) = result.balance {
        result.demand(balance <= BALANCE, format!("the balance is off by {balance:.1e}"));
    }
    if let Some(complementarity) = result.complementarity {
        result.demand(complementarity <= COMPLEMENTARITY, format!("complementarity {complementarity:.1e}"));
    }
    // A shape that misses its accuracy says so; one that claims it must give the pressure back.
    if let Some(round_trip) = result.round_trip.filter(|_| document["status"] == "ok") {
        result.demand(round_trip <= ROUND_TRIP, format!("the round trip gives the pressure back to {round_trip:.1e} only"));
    }
}

/// No value but a finite one in the columns that every run fills, and no pull.
fn finite(table: &Csv, result: &mut Result) {
    for name in ["s_mm", "weight_mm2", "pressure_MPa"] {
        let column = table.column(name).unwrap_or_default();
        result.demand(
            !column.is_empty() && column.iter().all(|value| value.is_finite()),
            format!("{name} is not finite everywhere"),
        );
    }
    let pull = table.column("pressure_MPa").unwrap_or_default().iter().any(|p| *p < 0.0);
    result.demand(!pull, "a negative pressure".into());
}

fn check_scaled(scaled: &Scaled, folder: &Path, beside: &Path, result: &mut Result) {
    let read = |folder: &Path| read_csv(&folder.join(&scaled.table));
    let (table, base) = match (read(folder), read(&beside.join(&scaled.like))) {
        (Ok(table), Ok(base)) => (table, base),
        (Err(message), _) | (_, Err(message)) => return result.failures.push(message),
    };
    for (name, factor) in &scaled.columns {
        let (Ok(ours), Ok(theirs)) = (table.column(name), base.column(name)) else {
            return result.failures.push(format!("no column {name}"));
        };
        if ours.len() != theirs.len() {
            return result.failures.push(format!("{name}: {} points, {} has {}", ours.len(), scaled.like, theirs.len()));
        }
        let largest = theirs.iter().map(|v| (v * factor).abs()).fold(0.0, f64::max);
        let difference = ours.iter().zip(theirs).map(|(a, b)| (a - b * factor).abs()).fold(0.0, f64::max);
        result.deviates(&format!("{name} against {}", scaled.like), difference / largest, scaled.within);
    }
}

/// A summary.json printed on stdout.
pub(crate) fn document(stdout: &[u8], folder: &Path) -> Value {
    serde_json::from_slice(stdout).ok().or_else(|| read_json(&folder.join("summary.json")).ok()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn demand(of: &str, is: f64, within: f64) -> Number {
        Number { of: of.into(), over: None, is: Some((is, within)), below: None, above: None }
    }

    fn refusal(exit: i32, says: &str) -> Scene {
        Scene { scene: "s".into(), set: vec![], exit, says: Some(says.into()), numbers: vec![], scaled: None }
    }

    #[test]
    fn a_number_that_is_off_or_missing_fails() {
        let document = json!({ "pressure": { "p_max_MPa": 5.0 } });
        let check = |number: &Number| {
            let mut result = Result::default();
            check_number(number, &document, &mut result);
            result.failures.len()
        };
        assert_eq!(check(&demand("/pressure/p_max_MPa", 5.0, 1e-12)), 0);
        assert_eq!(check(&demand("/pressure/p_max_MPa", 5.001, 1e-5)), 1);
        assert_eq!(check(&demand("/pressure/p_min_MPa", 5.0, 1e-5)), 1);
    }

    #[test]
    fn a_refusal_passes_only_with_its_name_and_exit_code() {
        let document = json!({ "error": { "code": "wrong-value", "message": "poisson = 0.5 is out of range" } });
        let failures =
            |case: &Scene, exit: i32| scene(case, Some(exit), &document, Path::new("none"), Path::new("none")).failures.len();
        assert_eq!(failures(&refusal(2, "poisson"), 2), 0);
        assert_eq!(failures(&refusal(2, "young"), 2), 1);
        assert_eq!(failures(&refusal(2, "poisson"), 101), 1);
    }
}
