//! `wearshape check`: what a scene means, before anything is computed.

use scene::Fault;

use crate::args::CheckArgs;
use crate::describe::{describe_with_sizes, plan_json};
use crate::exit::Exit;
use crate::open;
use crate::print::{print_json, print_out};

/// Prints the plan, the remarks and the unused keys of a scene.
pub(crate) fn run(args: &CheckArgs) -> Result<Exit, Fault> {
    let (_, problem) = open::problem(&args.scene, &args.set)?;
    if args.json {
        print_json(&plan_json(&problem));
    } else if !args.quiet {
        print_out(&describe_with_sizes(&problem));
    }
    Ok(Exit::Done)
}
