//! What a scene means: defaults filled in, every user error found, the plan made.

mod bodies;
mod load;
mod optimum;
mod schedule;
mod tasks;
mod twist;
mod unused;
mod wear_rule;

use std::path::Path;
use std::sync::Arc;

use scene::{Document, Fault, Scene};

use crate::fe::Operators;
use crate::lints::{self, Lint};
use crate::plan::Plan;
use crate::surface::Patch;

pub(crate) use bodies::template;
pub(crate) use optimum::{exponents, kind, s_minus_1};
pub(crate) use twist::turns;

/// A checked scene: everything the stages need.
#[derive(Debug, Clone)]
pub(crate) struct Problem {
    /// Short name of the scene.
    pub(crate) name: String,
    /// The scene with every default filled in, in base units.
    pub(crate) scene: Scene,
    /// The contact surface, when it is known without a mesh.
    pub(crate) patch: Option<Patch>,
    /// The rigid freedoms of body 1 with their resultants.
    pub(crate) freedoms: Vec<crate::freedom::Freedom>,
    /// Stages and reasons.
    pub(crate) plan: Plan,
    /// What the theory has to say about the scene.
    pub(crate) lints: Vec<Lint>,
    /// Keys that were written but are not used.
    pub(crate) unused_keys: Vec<String>,
    /// Reduced bodies, shared by the tasks of a run and by the points of a sweep.
    pub(crate) operators: Arc<Operators>,
}

/// Checks a scene and fills in its defaults.
/// Relative paths in it are meant from `folder`.
pub(crate) fn setup(document: &Document, folder: &Path) -> Result<Problem, Fault> {
    check(document, folder).map_err(|fault| document.locate(fault))
}

fn check(document: &Document, folder: &Path) -> Result<Problem, Fault> {
    let mut scene = document.scene.clone();
    let tasks = tasks::resolve(&mut scene)?;
    bodies::resolve(&mut scene, folder)?;
    let patch = Patch::of(&scene)?;
    wear_rule::resolve(&mut scene, &tasks, patch.as_ref())?;
    load::resolve(&mut scene, &tasks, patch.as_ref())?;
    twist::resolve(&scene, &tasks)?;
    schedule::resolve(&mut scene)?;
    optimum::resolve(&mut scene, &tasks)?;
    let freedoms = crate::freedom::freedoms(&scene, patch.as_ref())?;
    let unused_keys = unused::keys(document, &scene, &tasks);
    let plan = Plan::new(&scene, &tasks);
    let lints = lints::lints(&scene, &tasks, patch.as_ref(), &freedoms);
    Ok(Problem { name: document.name.clone(), scene, patch, freedoms, plan, lints, unused_keys, operators: Arc::default() })
}

/// A number that must be finite and positive.
pub(crate) fn positive(key: &str, value: f64, what: &str, unit: &str) -> Result<(), Fault> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    let kind = if value == 0.0 { "zero" } else { "negative" };
    Err(Fault::at(key, "wrong-value", format!("{kind} {what}: {key} = {value}{unit}"), format!("give a {what} greater than 0")))
}

/// A missing key, blamed on its table.
pub(crate) fn missing(key: &str, why: &str, example: &str) -> Fault {
    Fault::at(key, "missing-key", format!("the key `{key}` is missing: {why}"), format!("add `{example}`"))
}
