//! The run-in for the page: pressure and gap at the steps of run.mcap.

use serde_json::{Value, json};

use crate::record::Replay;

/// Most steps that the page shows, and most points a step.
const STEPS: usize = 80;
const POINTS: usize = 161;

/// Steps of a recording, thinned out; none of one with fewer than two.
pub(crate) fn run_in(recording: &[u8]) -> Option<Value> {
    let replay = Replay::read(recording);
    let profiles = replay.profiles();
    let last = profiles.len().checked_sub(1).filter(|last| *last > 0)?;
    let count = last.min(STEPS - 1);
    let shown: Vec<usize> = (0..=count).map(|k| k * last / count).collect();
    let points = profiles[last].points.len();
    if profiles.iter().any(|profile| profile.points.len() != points) || points < 2 {
        return None;
    }
    let rows = points.min(POINTS) - 1;
    let rows: Vec<usize> = (0..=rows).map(|k| k * (points - 1) / rows).collect();
    let column = |step: usize, pick: &dyn Fn(&crate::record::Points, usize) -> Option<f64>| -> Vec<Value> {
        rows.iter().map(|row| pick(&profiles[step], *row).map_or(Value::Null, |value| json!(six_digits(value)))).collect()
    };
    Some(json!({
        "x_label": "s (mm)",
        "x": column(last, &|profile, row| Some(profile.points[row].s_mm)),
        "step": shown.iter().map(|step| profiles[*step].step).collect::<Vec<_>>(),
        "time_s": shown.iter().map(|step| six_digits(profiles[*step].time_s)).collect::<Vec<_>>(),
        "pressure": shown.iter().map(|step| column(*step, &|profile, row| profile.points[row].pressure_MPa)).collect::<Vec<_>>(),
        "gap": shown.iter().map(|step| column(*step, &|profile, row| profile.points[row].gap_um)).collect::<Vec<_>>(),
    }))
}

/// Enough for a picture.
fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
