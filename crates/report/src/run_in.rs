//! The run-in for the page: pressure and gap at the steps of a run in time.

use serde_json::{Value, json};
use wearshape::{RunningIn, RunningInStep};

/// Most steps that the page shows, and most points a step.
const STEPS: usize = 80;
const POINTS: usize = 161;

/// Steps of a run, thinned out; none of one with fewer than two.
pub(crate) fn run_in(run: &RunningIn) -> Option<Value> {
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
    Some(json!({
        "x_label": "s (mm)",
        "x": column(s),
        "step": shown.iter().map(|step| step.step).collect::<Vec<_>>(),
        "time_s": shown.iter().map(|step| six_digits(step.time)).collect::<Vec<_>>(),
        "pressure": shown.iter().map(|step| column(&step.pressure)).collect::<Vec<_>>(),
        "gap": shown.iter().map(|step| column(&step.gap)).collect::<Vec<_>>(),
    }))
}

/// Enough for a picture.
fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
