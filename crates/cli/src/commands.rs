//! One function a command: from arguments to an exit code.

mod check;
mod explain;
mod new;
mod report;
mod reproduce;
mod run;
mod study;
mod sweep;

use std::ffi::OsString;
use std::path::Path;

use clap::{CommandFactory, Parser};
use scene::{Fault, Place};

use crate::args::{Cli, Command};
use crate::exit::Exit;
use crate::print::{complain, print_json, print_out};

/// Runs the command that the arguments ask for.
pub(crate) fn run(args: impl IntoIterator<Item = impl Into<OsString> + Clone>) -> Exit {
    let args: Vec<OsString> = args.into_iter().map(Into::into).collect();
    let json = args.iter().any(|arg| arg == "--json");
    let cli = match Cli::try_parse_from(&args) {
        Ok(cli) => cli,
        Err(error) => return usage(&error, json),
    };
    let outcome = match cli.command {
        Command::Check(args) => check::run(&args),
        Command::New(args) => new::run(&args),
        Command::Schema => schema(),
        Command::Completions { shell } => completions(shell),
        Command::Explain { code } => explain::run(code.as_deref()),
        Command::Man { folder } => man(folder.as_deref()),
        Command::Run(args) => run::run(&args),
        Command::Sweep(args) => sweep::run(&args),
        Command::Report(args) => report::run(&args),
        Command::Study(args) => study::run(&args),
        Command::Reproduce(args) => reproduce::run(&args),
    };
    outcome.unwrap_or_else(|fault| complain(&fault, json))
}

fn usage(error: &clap::Error, json: bool) -> Exit {
    if !error.use_stderr() {
        print_out(&error.render().to_string());
        return Exit::Done;
    }
    if json {
        let text = error.render().to_string();
        let first = text.lines().next().unwrap_or("").trim_start_matches("error: ").to_string();
        return complain(&Fault::new("usage", first, "see `wearshape --help`"), true);
    }
    let _ = error.print();
    Exit::Wrong
}

fn schema() -> Result<Exit, Fault> {
    let mut settings = schemars::generate::SchemaSettings::draft07();
    settings.inline_subschemas = false;
    let schema = settings.into_generator().into_root_schema_for::<scene::Scene>();
    print_json(schema.as_value());
    Ok(Exit::Done)
}

fn completions(shell: clap_complete::Shell) -> Result<Exit, Fault> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "wearshape", &mut script);
    print_out(&String::from_utf8_lossy(&script));
    Ok(Exit::Done)
}

fn man(folder: Option<&Path>) -> Result<Exit, Fault> {
    let unwritable = |error: std::io::Error| {
        let shown = folder.unwrap_or(Path::new("-")).display().to_string();
        Fault {
            place: Some(Place::Flag(shown.clone())),
            ..Fault::new(
                "unwritable",
                format!("cannot write manual pages to {shown}: {error}"),
                "give a folder that can be written",
            )
        }
    };
    if let Some(folder) = folder {
        let written = std::fs::create_dir_all(folder).and_then(|()| clap_mangen::generate_to(Cli::command(), folder));
        written.map_err(unwritable)?;
    } else {
        let mut page = Vec::new();
        clap_mangen::Man::new(Cli::command()).render(&mut page).map_err(unwritable)?;
        print_out(&String::from_utf8_lossy(&page));
    }
    Ok(Exit::Done)
}
