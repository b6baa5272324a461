//! `wearshape check`: what a scene means, before anything is computed.

use serde_json::json;

use crate::args::CheckArgs;
use crate::commands::{print_json, print_out};
use crate::document::Document;
use crate::exit::Exit;
use crate::fault::Fault;
use crate::setup::{Problem, setup};

/// Prints the plan, the remarks and the unused keys of a scene.
pub(crate) fn run(args: &CheckArgs) -> Result<Exit, Fault> {
    let document = Document::open(&args.scene, &args.set)?;
    let problem = setup(&document)?;
    if args.json {
        print_json(&plan_json(&problem));
    } else if !args.quiet {
        print_out(&describe(&problem));
    }
    Ok(Exit::Done)
}

/// The plan as a document.
pub(crate) fn plan_json(problem: &Problem) -> serde_json::Value {
    json!({
        "scene": problem.name,
        "stages": problem.plan.stages,
        "lints": problem.lints,
        "unused_keys": problem.unused_keys,
    })
}

/// The plan in words.
pub(crate) fn describe(problem: &Problem) -> String {
    let title = problem.scene.title.as_deref().unwrap_or("");
    let mut out = format!("{}: {title}\nthe scene is sound\n\n", problem.name);
    for stage in &problem.plan.stages {
        let mark = if stage.ran { "yes" } else { " - " };
        out += &format!("  {mark}  {:<18} {}\n", stage.name, stage.because);
    }
    if let Some(patch) = &problem.patch {
        out += &format!("\ncontact surface {:.6} mm^2", patch.surface.area());
        out += &format!(", free rigid modes of body 1: {}\n", problem.freedoms.len());
    }
    for lint in &problem.lints {
        out += &format!("\nnote [{}]: {}\n  more: wearshape explain {}\n", lint.code, lint.message, lint.code);
    }
    if !problem.unused_keys.is_empty() {
        out += &format!("\nkeys not used by this scene: {}\n", problem.unused_keys.join(", "));
    }
    out
}
