//! One step of the wear in time: implicit Runge-Kutta stages, or an explicit one.

use crate::implicit_stage::{Contact, Linear, Load, Unsettled};
use crate::tableau::Tableau;
use crate::wear_problem::{Scheme, Until, WearProblem};
use crate::wear_state::WearState;

/// A step tried.
#[derive(Default)]
pub(crate) struct Trial {
    pub(crate) contact: Contact,
    pub(crate) gap: Vec<f64>,
    pub(crate) worn: Vec<f64>,
    pub(crate) recession: f64,
    pub(crate) volume: [f64; 2],
    pub(crate) error: f64,
    /// Points that press in one of the stages, or at the end.
    pub(crate) touched: Vec<bool>,
    /// Of the gap, and of the pressure by the force that acts.
    pub(crate) errors: [f64; 2],
    pub(crate) iterations: usize,
}

/// Tries a step; an error if a stage cannot be solved. `severity` are factors on the estimated errors of gap and pressure.
pub(crate) fn try_step(
    load: &Load<'_>,
    scheme: Scheme,
    state: &WearState,
    step: f64,
    severity: [f64; 2],
) -> Result<Trial, Unsettled> {
    match Tableau::of(scheme) {
        Some(tableau) => {
            let mut trial = implicit_step(load, state, step, tableau)?;
            let [gap, pressure] = trial.errors;
            trial.error = (severity[0] * gap).max(severity[1] * pressure);
            Ok(trial)
        }
        None => explicit_step(load, state, step),
    }
}

fn implicit_step(load: &Load<'_>, state: &WearState, step: f64, tableau: &Tableau) -> Result<Trial, Unsettled> {
    let n = state.gap.len();
    let mut contact = Contact::of(state);
    let mut stages: Vec<Contact> = Vec::new();
    let mut rates: Vec<Vec<f64>> = Vec::new();
    let mut iterations = 0;
    let mut linear: Option<Linear> = None;
    for row in tableau.rows {
        let mut known = state.gap.clone();
        for (factor, rate) in row.iter().zip(&rates) {
            known.iter_mut().zip(rate).for_each(|(g, r)| *g += step * factor * r);
        }
        let solved = load.solve_after(&known, step * tableau.diagonal(), &contact, linear)?;
        iterations += solved.iterations;
        contact = solved.contact;
        rates.push(load.rate.total(&contact.pressure));
        stages.push(contact.clone());
        linear = Some(solved.linear);
    }
    let weights = tableau.weights();
    let sum = |values: &dyn Fn(&Contact) -> f64| -> f64 { weights.iter().zip(&stages).map(|(b, s)| step * b * values(s)).sum() };
    let gap: Vec<f64> =
        (0..n).map(|i| state.gap[i] + (0..stages.len()).map(|s| step * weights[s] * rates[s][i]).sum::<f64>()).collect();
    let worn: Vec<f64> = (0..n).map(|i| state.worn[i] + sum(&|s| load.rate.worn(0, i, &s.pressure))).collect();
    let volume = std::array::from_fn(|body| {
        let rate = |s: &Contact| (0..load.weights.len()).map(|i| load.weights[i] * load.rate.wear(body, i, s.pressure[i])).sum();
        state.volume[body] + sum(&rate)
    });
    let recession = state.recession + sum(&|s| load.rate.recession(&s.pressure));
    let error: Vec<f64> = (0..n)
        .map(|i| {
            let stages: f64 = rates.iter().zip(&tableau.error[1..]).map(|(r, e)| e * r[i]).sum();
            step * (tableau.error[0] * state.gap_rate[i] + stages)
        })
        .collect();
    let (gap_error, pressure_error) = linear.and_then(|linear| load.filter(&linear, &error)).ok_or_else(Unsettled::default)?;
    let force = |p: &[f64]| -> f64 { p.iter().zip(&load.weights).map(|(p, w)| p.abs() * w).sum() };
    let depth = load.rate.deepest(&gap, &worn);
    let scale = gap_scale(load, state).max(depth);
    let error = gap_error.iter().fold(0.0_f64, |m, e| m.max(e.abs() / scale));
    let errors = [error, force(&pressure_error) / force(&contact.pressure)];
    let touched = (0..load.weights.len()).map(|i| stages.iter().any(|s| s.pressure[i] > 0.0)).collect();
    Ok(Trial { contact, gap, worn, recession, volume, error, touched, errors, iterations })
}

fn explicit_step(load: &Load<'_>, state: &WearState, step: f64) -> Result<Trial, Unsettled> {
    let n = state.gap.len();
    let gap: Vec<f64> = state.gap.iter().zip(&state.gap_rate).map(|(g, r)| g + step * r).collect();
    let wear = |body: usize, i: usize| load.rate.wear(body, i, state.pressure[i]);
    let worn = (0..n).map(|i| state.worn[i] + step * load.rate.worn(0, i, &state.pressure)).collect();
    let points = 0..load.weights.len();
    let volume = std::array::from_fn(|body| {
        state.volume[body] + step * points.clone().map(|i| load.weights[i] * wear(body, i)).sum::<f64>()
    });
    let recession = state.recession + step * load.rate.recession(&state.pressure);
    let solved = load.solve(&gap, 0.0, &Contact::of(state))?;
    Ok(Trial {
        touched: solved.contact.pressure.iter().map(|p| *p > 0.0).collect(),
        contact: solved.contact,
        gap,
        worn,
        recession,
        volume,
        error: 0.0,
        errors: [0.0; 2],
        iterations: solved.iterations,
    })
}

/// Length that gap errors are measured by: elastic closing or wear depth.
pub(crate) fn gap_scale(load: &Load<'_>, state: &WearState) -> f64 {
    let elastic = load.elastic(&state.pressure);
    elastic.iter().fold(load.rate.deepest(&state.gap, &state.worn), |m, v| m.max(v.abs())).max(f64::MIN_POSITIVE)
}

/// By how much errors of the gap count for more than by the length that they are measured by: that over the depth at the end, where that is less, for the depth
/// is the answer of a short run, however far the bodies are pressed together. What a step gets wrong in a contact that grows is worn off by the wear after it
/// only as far as that is as deep as they are pressed together, so that there errors count by the square of it.
pub(crate) fn shallow(problem: &WearProblem, load: &Load<'_>, state: &WearState) -> f64 {
    let depth_after =
        |time: f64| load.rate.deepest(&state.gap, &state.worn) + state.gap_rate.iter().copied().fold(0.0, f64::max) * time;
    let depth = match problem.until {
        Until::Time(end) => depth_after(end - state.time),
        Until::Depth(depth) => depth,
        Until::Volume(volume) => {
            let wear = |body: usize, i: usize| load.weights[i] * load.rate.wear(body, i, state.pressure[i]);
            let rate: f64 = (0..load.weights.len()).map(|i| wear(0, i) + wear(1, i)).sum();
            let left = (volume - state.volume[0] - state.volume[1]).max(0.0);
            if rate > 0.0 { depth_after(left / rate) } else { 0.0 }
        }
        Until::Steady { .. } => return 1.0,
    };
    let ratio = if depth > 0.0 { (gap_scale(load, state) / depth).max(1.0) } else { 1.0 };
    if problem.growing { ratio * ratio } else { ratio }
}
