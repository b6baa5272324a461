//! `wearshape completions`: scripts that know the names of the built-in scenes and the codes of the notes.

use clap::CommandFactory;
use clap::builder::PossibleValuesParser;
use clap_complete::Shell;
use scene::{Fault, SCENES};

use crate::args::Cli;
use crate::commands::explain;
use crate::exit::Exit;
use crate::print::print_out;

/// Commands that take a scene.
const SCENE: [&str; 4] = ["run", "check", "sweep", "study"];

/// Prints the script of a shell.
pub(crate) fn run(shell: Shell) -> Result<Exit, Fault> {
    let scenes: Vec<&str> = SCENES.iter().map(|scene| scene.name).collect();
    let codes = explain::codes();
    // The program itself takes files too, and says what is meant by other words.
    let named = |command: clap::Command, argument: &'static str, names: &[&'static str]| {
        let names = PossibleValuesParser::new(names);
        command.mut_arg(argument, |argument| argument.value_parser(names))
    };
    let mut command = Cli::command();
    for name in SCENE {
        command = command.mut_subcommand(name, |command| named(command, "scene", &scenes));
    }
    command = command.mut_subcommand("new", |command| named(command, "template", &scenes));
    command = command.mut_subcommand("explain", |command| named(command, "code", &codes));
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, "wearshape", &mut script);
    let script = String::from_utf8_lossy(&script).into_owned();
    print_out(&match shell {
        Shell::Zsh => with_files(&script, &scenes),
        Shell::Fish => script + &for_fish(&scenes, &codes),
        _ => script,
    });
    Ok(Exit::Done)
}

/// In zsh the names of scenes and files.
fn with_files(script: &str, scenes: &[&str]) -> String {
    let mut out = String::new();
    for line in script.lines() {
        match line.split_once(":(").filter(|_| line.starts_with("':scene -- ")) {
            Some((head, _)) => out += &format!("{head}:{{compadd -- {}; _files}}' \\\n", scenes.join(" ")),
            None => out += &format!("{line}\n"),
        }
    }
    out
}

/// What fish is not told: words of arguments without a flag. Files stay offered where a scene is asked for.
fn for_fish(scenes: &[&str], codes: &[&str]) -> String {
    let line = |command: &str, more: &str, words: &[&str]| {
        let when = format!("__fish_wearshape_using_subcommand {command}");
        format!("complete -c wearshape -n \"{when}\" {more}-a \"{}\"\n", words.join(" "))
    };
    let mut out: String = SCENE.iter().map(|command| line(command, "", scenes)).collect();
    out += &line("new", "", scenes);
    out + &line("explain", "-f ", codes)
}
