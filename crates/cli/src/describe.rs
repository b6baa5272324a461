//! What a scene means, as `check` says it: in words, and as a document.

use scene::Fault;
use serde_json::json;
use wearshape::{Bodies, Forecast, Options, Problem, Step};

use crate::clock::seconds;
use crate::progress::Progress;

/// The plan as a document.
pub(crate) fn plan_json(problem: &Problem, bodies: &Bodies, progress: &Progress) -> serde_json::Value {
    let mut plan = json!({
        "scene": problem.name(),
        "stages": problem.plan().stages,
        "holding": problem.holding(),
        "lints": problem.remarks(),
        "unused_keys": problem.unused_keys(),
    });
    if let Some(reason) = problem.unanswered() {
        plan["no_answer"] = json!(reason);
    }
    match expected(problem, bodies, progress) {
        Some(Ok(levels)) => plan["expected"] = json!(levels),
        Some(Err(fault)) => plan["not_expected"] = json!(fault.message),
        None => {}
    }
    plan
}

/// Sizes and times of the levels; `None` for scenes without bodies.
fn expected(problem: &Problem, bodies: &Bodies, progress: &Progress) -> Option<Result<Vec<Forecast>, Fault>> {
    let begun = |step| progress.busy(step);
    progress.busy(Step::Mesh);
    let options = Options { clock: seconds, begun: &begun, ..Options::default() };
    problem.plan().runs(Step::Mesh).then(|| problem.forecast_on(&options, bodies))
}

/// What the plan will take, in words; nothing for scenes without bodies.
pub(crate) fn sizes(problem: &Problem, bodies: &Bodies, progress: &Progress) -> String {
    let mut out = String::new();
    match expected(problem, bodies, progress) {
        None => {}
        Some(Err(fault)) => out += &format!("\nno sizes: {}\n", fault.message),
        Some(Ok(levels)) => {
            out += "\n  degree  layers   cells  unknowns  contact points  memory MB  seconds, about\n";
            for level in &levels {
                let memory = level.memory_bytes as f64 / 1e6;
                out += &format!("  {:>6}  {:>6}  {:>6}  {:>8}  ", level.degree, level.layers, level.cells, level.dofs);
                out += &format!("{:>14}  {memory:>9.1}  about {:.2}\n", level.contact_points, level.about_seconds);
            }
            if levels.len() > 1 {
                out += "the run climbs from row to row until its accuracy is reached, and on where errors fall slower than is usual;\n";
                out += "seconds are those up to there, with the proof\n";
            }
            if problem.plan().runs(Step::Evolution) {
                out += "the steps in time come on top: how many it takes is not known before\n";
            }
        }
    }
    out
}

/// The plan in words.
pub(crate) fn describe(problem: &Problem) -> String {
    let title = problem.scene().title.as_deref().unwrap_or("");
    let mut out = format!("{}: {title}\nthe scene is sound\n\n", problem.name());
    for stage in &problem.plan().stages {
        let mark = if stage.ran { "yes" } else { " - " };
        out += &format!("  {mark}  {:<18} {}\n", stage.name.name(), stage.because);
    }
    if let Some(area) = problem.contact_area() {
        out += &format!("\ncontact surface {area:.6} mm^2, free rigid modes of body 1: {}\n", problem.free_modes());
    }
    for (number, body) in problem.holding().iter().enumerate() {
        out += &format!("{}{body}\n", if number == 0 { "\n" } else { "" });
    }
    if let Some(reason) = problem.unanswered() {
        out += &format!("\nno answer: {reason}\n  run says the same, and ends with 1\n");
    }
    for lint in problem.remarks() {
        out += &format!("\nnote [{}]: {}\n  more: wearshape explain {}\n", lint.code, lint.message, lint.code);
    }
    if !problem.unused_keys().is_empty() {
        out += &format!("\nkeys not used by this scene: {}\n", problem.unused_keys().join(", "));
    }
    out
}
