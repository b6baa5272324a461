//! The run-in for the page: pressure and gap at the steps of a run in time.

use serde_json::{Value, json};
use wearshape::{RunningIn, RunningInStep};

use crate::reach::reach;

/// Most steps that the page shows, and most points a step.
const STEPS: usize = 80;
const POINTS: usize = 161;

/// Pressure and gap at the steps of a run, thinned out and in six digits, as the page draws them; none of a run with fewer than two steps.
/// Of bodies of revolution (`revolved`) the place is the radius.
pub fn run_in(run: &RunningIn, revolved: bool) -> Option<Value> {
    let RunningIn { s, steps } = run;
    let last = steps.len().checked_sub(1).filter(|last| *last > 0)?;
    let count = last.min(STEPS - 1);
    let shown: Vec<&RunningInStep> = (0..=count).map(|k| &steps[k * last / count]).collect();
    let points = s.len();
    if steps.iter().any(|step| step.pressure.len() != points || step.gap.len() != points) || points < 2 {
        return None;
    }
    let rows = points.min(POINTS) - 1;
    let rows: Vec<usize> = (0..=rows).map(|k| k * (points - 1) / rows).collect();
    let number = |value: f64| if value.is_finite() { json!(six_digits(value)) } else { Value::Null };
    let column = |values: &[f64]| -> Vec<Value> { rows.iter().map(|row| number(values[*row])).collect() };
    let above = |values: &[f64]| -> Vec<f64> {
        let least = values.iter().copied().filter(|value| value.is_finite()).fold(f64::INFINITY, f64::min);
        values.iter().map(|value| value - least).collect()
    };
    let pressures: Vec<Vec<f64>> = shown.iter().map(|step| step.pressure.clone()).collect();
    let gaps: Vec<Vec<f64>> = shown.iter().map(|step| above(&step.gap)).collect();
    Some(json!({
        "x_label": if revolved { "radius (mm)" } else { "along the surface from its middle, s (mm)" },
        "pressure_axis": axis(s, &pressures),
        "gap_axis": axis(s, &gaps),
        "x": column(s),
        "step": shown.iter().map(|step| step.step).collect::<Vec<_>>(),
        "time_s": shown.iter().map(|step| six_digits(step.time)).collect::<Vec<_>>(),
        "pressure": pressures.iter().map(|values| column(values)).collect::<Vec<_>>(),
        "gap": gaps.iter().map(|values| column(values)).collect::<Vec<_>>(),
    }))
}

/// The largest value that the axis of all steps holds, and the words on what is cut off.
fn axis(s: &[f64], steps: &[Vec<f64>]) -> Value {
    let curves: Vec<Vec<(f64, f64)>> =
        steps.iter().map(|values| s.iter().copied().zip(values.iter().copied()).collect()).collect();
    let cut = reach(curves.iter().map(Vec::as_slice));
    let most = steps.iter().flatten().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
    json!({ "top": six_digits(cut.map_or(most, |cut| cut.high)), "note": cut.map(|cut| cut.note()) })
}

/// Enough for a picture.
fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
