//! One function a command: from arguments to an exit code.

mod check;
mod completions;
mod diff;
mod explain;
mod man;
mod materials;
mod new;
mod report;
mod reproduce;
mod run;
mod study;
mod sweep;

use std::ffi::OsString;

use clap::Parser;
use scene::Fault;

use crate::args::{Cli, Command};
use crate::exit::Exit;
use crate::print::{colour_on_stderr, complain, ended, print_err, print_json, print_out};

/// Runs the command that the arguments ask for.
pub(crate) fn run(args: impl IntoIterator<Item = impl Into<OsString> + Clone>) -> Exit {
    let args: Vec<OsString> = args.into_iter().map(Into::into).collect();
    let json = args.iter().any(|arg| arg == "--json");
    let cli = match Cli::try_parse_from(&args) {
        Ok(cli) => cli,
        Err(error) => return ended(usage(&error, json)),
    };
    let outcome = match cli.command {
        Command::Check(args) => check::run(&args),
        Command::New(args) => new::run(&args),
        Command::Schema => schema(),
        Command::Completions { shell } => completions::run(shell),
        Command::Explain { code } => explain::run(code.as_deref()),
        Command::Materials => materials::run(),
        Command::Man { folder } => man::run(folder.as_deref()),
        Command::Run(args) => run::run(&args),
        Command::Sweep(args) => sweep::run(&args),
        Command::Diff(args) => diff::run(&args),
        Command::Report(args) => report::run(&args),
        Command::Study(args) => study::run(&args),
        Command::Reproduce(args) => reproduce::run(&args),
    };
    ended(outcome.unwrap_or_else(|fault| complain(&fault, json)))
}

fn usage(error: &clap::Error, json: bool) -> Exit {
    if !error.use_stderr() {
        print_out(&error.render().to_string());
        return Exit::Done;
    }
    if json {
        let text = error.render().to_string();
        // What is missing stands below the first line, before an empty one.
        let lines = text.lines().map(str::trim).take_while(|line| !line.is_empty());
        let message = lines.collect::<Vec<_>>().join(" ").trim_start_matches("error: ").to_string();
        return complain(&Fault::new("usage", message, "see `wearshape --help`"), true);
    }
    let text = error.render();
    print_err(&if colour_on_stderr() { text.ansi().to_string() } else { text.to_string() });
    Exit::Wrong
}

fn schema() -> Result<Exit, Fault> {
    let mut settings = schemars::generate::SchemaSettings::draft07();
    settings.inline_subschemas = false;
    let schema = settings.into_generator().into_root_schema_for::<scene::Scene>();
    print_json(schema.as_value());
    Ok(Exit::Done)
}
