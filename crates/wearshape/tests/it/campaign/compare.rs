//! How far two answers are apart.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, HeatResult, Options, PointStatus, Problem, Sampling, Solution, Status, solve};

/// Accuracy of a scene that asks for none.
pub(super) const ACCURACY: f64 = 1e-6;

/// What became of a scene.
pub(super) enum Outcome {
    /// Refused as written, by the code of its fault.
    Fault(String),
    /// Solved, or refused when it was solved.
    Solved(Box<Solution>),
}

impl Outcome {
    /// A word for how it ended.
    pub(super) fn word(&self) -> String {
        match self {
            Outcome::Fault(code) => format!("fault {code}"),
            Outcome::Solved(solution) => format!("{:?}", solution.status),
        }
    }

    /// Whether bodies that could touch do not, so that ends of contact were searched.
    pub(super) fn opens(&self) -> bool {
        let profile = self
            .answer()
            .filter(|found| found.contact.is_some() || found.wear.is_some())
            .and_then(|found| found.profile.as_ref());
        profile.is_some_and(|profile| profile.status.contains(&PointStatus::Open))
    }

    /// The solution that ended well.
    pub(super) fn answer(&self) -> Option<&Solution> {
        match self {
            Outcome::Solved(solution) if solution.status == Status::Ok => Some(solution),
            _ => None,
        }
    }
}

/// A scene and the files that it names.
pub(super) struct Written {
    pub text: String,
    pub files: Vec<(String, Vec<u8>)>,
}

/// Solves a scene; alone, or with the discretisations that an estimate needs and a table at even places.
pub(super) fn outcome(scene: &Written, alone: bool) -> Outcome {
    let bytes = |file: &str| {
        let found = scene.files.iter().find(|(name, _)| name == file);
        found.map(|(_, bytes)| bytes.clone()).ok_or(format!("there is no {file}"))
    };
    let found =
        Document::read("scene.toml", &scene.text, &[]).and_then(|document| Problem::new(&document, &bytes)).and_then(|problem| {
            let options = Options { alone, sample: (!alone).then_some(Sampling::Even(41)), ..Options::default() };
            solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(()))
        });
    match found {
        Ok(solution) => Outcome::Solved(Box::new(solution)),
        Err(fault) => Outcome::Fault(fault.code.to_string()),
    }
}

/// What a twin's numbers are to be divided by, and whether they stand in the reverse order.
#[derive(Debug, Clone, Copy)]
pub(super) struct Change {
    pub length: f64,
    pub stress: f64,
    pub reversed: bool,
}

impl Change {
    pub(super) const NONE: Change = Change { length: 1.0, stress: 1.0, reversed: false };
}

/// Largest difference over a scale; infinite where one is a number and the other none.
fn apart(first: &[f64], second: &[f64], over: f64) -> f64 {
    if first.len() != second.len() {
        return f64::INFINITY;
    }
    let difference = |(a, b): (&f64, &f64)| match (a.is_finite(), b.is_finite()) {
        (true, true) => (a - b).abs(),
        (false, false) => 0.0,
        _ => f64::INFINITY,
    };
    let most = first.iter().zip(second).map(difference).fold(0.0, f64::max);
    if most == 0.0 { 0.0 } else { most / over }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().filter(|v| v.is_finite()).fold(0.0, |most, v| v.abs().max(most))
}

/// A named quantity of both, the twin's brought back, and what it is measured by.
pub(super) fn deviations(one: &Solution, twin: &Solution, change: Change) -> Vec<(&'static str, f64)> {
    let Change { length, stress, reversed } = change;
    let back = |values: &[f64], by: f64| {
        let mut values: Vec<f64> = values.iter().map(|v| v / by).collect();
        if reversed {
            values.reverse();
        }
        values
    };
    let mut found = Vec::new();
    if let (Some(a), Some(b)) = (&one.profile, &twin.profile) {
        // A gap is a difference of displacements.
        let moved = a.normal_displacement.iter().map(|u| largest(u)).fold(0.0, f64::max);
        found.push(("pressure", apart(&a.pressure, &back(&b.pressure, stress), largest(&a.pressure))));
        found.push(("gap", apart(&a.gap, &back(&b.gap, length), moved.max(largest(&a.gap)))));
        found.push(("wear rate", apart(&a.wear_rate, &back(&b.wear_rate, length), largest(&a.wear_rate))));
    }
    let energy = |solution: &Solution| solution.energy.as_ref().map_or(f64::NAN, |energy| energy.total());
    let depth = |solution: &Solution| solution.wear.as_ref().and_then(|wear| wear.depth).unwrap_or(f64::NAN);
    for (name, of, by) in [("energy", &energy as &dyn Fn(&Solution) -> f64, stress * length.powi(3)), ("depth", &depth, length)] {
        let (a, b) = (of(one), of(twin) / by);
        found.push((name, apart(&[a], &[b], a.abs())));
    }
    if let (Some(a), Some(b)) = (&one.heat, &twin.heat) {
        let hottest = [a.highest1, a.highest2].into_iter().flatten().fold(0.0, f64::max);
        let of = |heat: &HeatResult| [heat.highest1, heat.highest2].map(|found| found.unwrap_or(f64::NAN));
        found.push(("temperature", apart(&of(a), &of(b), hottest)));
    }
    found
}

/// A number of an answer and its estimated relative error: the largest gap of a shape, the depth of wear in time, the energy of a contact or how hot that
/// is.
fn estimated(solution: &Solution) -> Option<(f64, f64)> {
    if let Some(wear) = &solution.wear {
        // Where nothing is known of the error, the steps hold the accuracy of the scene.
        return Some((wear.depth?, wear.run_in_error.unwrap_or(ACCURACY)));
    }
    let error = solution.error.as_ref()?;
    if let (Some(heat), None) = (&solution.heat, &solution.shape) {
        // Energies of hot bodies are not estimated.
        return Some((heat.highest1?, error.pressure_relative?));
    }
    match &solution.shape {
        Some(shape) => Some((shape.gap_max?, error.gap_relative?)),
        None => Some((solution.energy.as_ref()?.total(), error.energy_relative?)),
    }
}

/// The difference of that number over what the estimates of both allow.
pub(super) fn over_estimates(one: &Solution, twin: &Solution, change: Change) -> Option<f64> {
    let ((a, first), (b, second)) = (estimated(one)?, estimated(twin)?);
    let by = match (one.shape.is_some() || one.wear.is_some(), &one.heat) {
        (true, _) => change.length,
        (false, Some(_)) => 1.0,
        (false, None) => change.stress * change.length.powi(3),
    };
    Some(apart(&[a], &[b / by], a.abs()) / (first + second))
}
