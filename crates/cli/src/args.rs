//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Contact pressure and contact shape of two bodies worn in by steady sliding, computed directly.
#[derive(Debug, Parser)]
#[command(name = "wearshape", version, about, max_term_width = 100)]
#[command(
    after_help = "Begin with:\n  wearshape run drum-brake-block\n  wearshape new drum-brake-block my-shoe.toml\n  wearshape new --list"
)]
pub(crate) struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Compute a scene and write its folder.
    #[command(
        after_help = "Examples:\n  wearshape run drum-brake-block\n  wearshape run shoe.toml -o out/soft --set body1.material.young='5 GPa' --set contact.friction=.4"
    )]
    Run(RunArgs),
    /// Read a scene, say what would be done and what is wrong.
    #[command(after_help = "Example:\n  wearshape check shoe.toml")]
    Check(CheckArgs),
    /// Write a commented scene to start from.
    #[command(
        after_help = "Examples:\n  wearshape new --list\n  wearshape new drum-brake-block shoe.toml\n  wearshape new hertz-cylinder            (to stdout)"
    )]
    New(NewArgs),
    /// Compute a scene over a grid of keys; one row a point.
    #[command(
        after_help = "Examples:\n  wearshape sweep annular-punch --set tasks=[pressure] --over wear.b=1.05:2:20\n  wearshape sweep drum-brake-block --over contact.friction=0,.1,.25 --over optimum.functional=steady,uniform"
    )]
    Sweep(SweepArgs),
    /// Error against run time over a ladder of meshes.
    #[command(after_help = "Example:\n  wearshape study drum-brake-block")]
    Study(StudyArgs),
    /// Say what the results of two folders differ in.
    #[command(
        after_help = "Examples:\n  wearshape diff out/one out/other\n  wearshape diff before after --tolerance 1e-6\n\nExit codes: 0 the results are the same within the tolerance, 1 they differ, 2 they cannot be compared."
    )]
    Diff(DiffArgs),
    /// Build report.html of a folder again.
    #[command(after_help = "Example:\n  wearshape report out/drum-brake-block")]
    Report(ReportArgs),
    /// Recompute figures and tables of the paper.
    #[command(
        after_help = "Examples:\n  wearshape reproduce            (the list)\n  wearshape reproduce fig4\n  wearshape reproduce all -o out/paper"
    )]
    Reproduce(ReproduceArgs),
    /// Print the JSON schema of scenes (draft 7), for editors.
    #[command(after_help = "Example:\n  wearshape schema > wearshape.schema.json")]
    Schema,
    /// Print a completion script.
    #[command(after_help = "Example:\n  wearshape completions bash > ~/.local/share/bash-completion/completions/wearshape")]
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// List the materials that a scene may name, with their numbers and where these are from.
    #[command(
        after_help = "A scene names one in place of its numbers: body1.material = \"steel\".\n\nExamples:\n  wearshape materials\n  wearshape run drum-brake-block --set body2.material=grey-cast-iron"
    )]
    Materials,
    /// Print what is behind a note on a scene.
    #[command(after_help = "Examples:\n  wearshape explain                  (the list)\n  wearshape explain s-below-one")]
    Explain {
        /// Code of the note, as in note [s-one]; all codes without it.
        code: Option<String>,
    },
    /// Print the manual page, or write the pages of all commands into a folder.
    #[command(after_help = "Examples:\n  wearshape man | man -l -\n  wearshape man ~/.local/share/man/man1")]
    Man {
        /// Folder for one page a command.
        folder: Option<PathBuf>,
    },
}

/// Options of run, study and sweep.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct Common {
    /// Folder to write; default out/<scene>, of a study out/<scene>-study, of a sweep out/<scene>-sweep.
    #[arg(short, long = "output", value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// Replace one key of the scene, as in --set contact.friction=.1; repeatable.
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    pub(crate) set: Vec<String>,
    /// Print one JSON document on stdout: summary.json, or the error.
    #[arg(long)]
    pub(crate) json: bool,
    /// Say what would be done and write nothing.
    #[arg(long)]
    pub(crate) dry_run: bool,
    /// Number of threads; default all.
    #[arg(long, value_name = "N")]
    pub(crate) threads: Option<usize>,
    /// Say nothing but errors.
    #[arg(short, long)]
    pub(crate) quiet: bool,
    /// Say more: the plan with its reasons, every note.
    #[arg(short, long)]
    pub(crate) verbose: bool,
    /// No progress bars.
    #[arg(long)]
    pub(crate) no_progress: bool,
    /// Accepted; a folder that is not ours is refused all the same.
    #[arg(long, hide = true)]
    pub(crate) force: bool,
}

/// Options of run and sweep alone.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct Points {
    /// Write contact.csv at N equally spaced points; in a sweep, keep the curves of every point.
    #[arg(long, value_name = "N")]
    pub(crate) sample: Option<usize>,
    /// Continue an interrupted run from its partial folder.
    #[arg(long)]
    pub(crate) resume: bool,
}

/// `run`.
#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    /// TOML file, or name of a built-in scene.
    pub(crate) scene: String,
    /// Options.
    #[command(flatten)]
    pub(crate) common: Common,
    /// Those of points.
    #[command(flatten)]
    pub(crate) points: Points,
}

/// `check`.
#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// TOML file, or name of a built-in scene.
    pub(crate) scene: String,
    /// Write a drawing of the scene (SVG): bodies, materials, supports, load, sliding.
    #[arg(short = 'o', long = "drawing", value_name = "FILE")]
    pub(crate) drawing: Option<PathBuf>,
    /// Say more: draw the scene too, as NAME.svg here unless -o says where.
    #[arg(short, long)]
    pub(crate) verbose: bool,
    /// Replace one key of the scene; repeatable.
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    pub(crate) set: Vec<String>,
    /// Print one JSON document on stdout.
    #[arg(long)]
    pub(crate) json: bool,
    /// Say nothing but errors.
    #[arg(short, long)]
    pub(crate) quiet: bool,
    /// No progress line.
    #[arg(long)]
    pub(crate) no_progress: bool,
}

/// `new`.
#[derive(Debug, Args)]
pub(crate) struct NewArgs {
    /// Name of a built-in scene.
    #[arg(required_unless_present = "list")]
    pub(crate) template: Option<String>,
    /// File to write; stdout without it.
    pub(crate) file: Option<PathBuf>,
    /// List the templates.
    #[arg(long)]
    pub(crate) list: bool,
}

/// `sweep`.
#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    /// TOML file, or name of a built-in scene.
    pub(crate) scene: String,
    /// A key and its values, key=from:to:count or key=a,b,c; repeatable: all combinations.
    #[arg(long, value_name = "KEY=VALUES", required = true)]
    pub(crate) over: Vec<String>,
    /// Options.
    #[command(flatten)]
    pub(crate) common: Common,
    /// Those of points.
    #[command(flatten)]
    pub(crate) points: Points,
}

/// `study`.
#[derive(Debug, Args)]
pub(crate) struct StudyArgs {
    /// TOML file, or name of a built-in scene.
    pub(crate) scene: String,
    /// Folder of a run that is taken as the truth.
    #[arg(long, value_name = "DIR")]
    pub(crate) reference: Option<PathBuf>,
    /// Accepted; a study has no contact.csv.
    #[arg(long, hide = true)]
    pub(crate) sample: Option<usize>,
    /// Accepted; a study begins anew.
    #[arg(long, hide = true)]
    pub(crate) resume: bool,
    /// Options.
    #[command(flatten)]
    pub(crate) common: Common,
}

/// `diff`.
#[derive(Debug, Args)]
pub(crate) struct DiffArgs {
    /// Folder of a finished run.
    #[arg(value_name = "A")]
    pub(crate) first: PathBuf,
    /// Folder of another one.
    #[arg(value_name = "B")]
    pub(crate) second: PathBuf,
    /// Relative differences up to this are none.
    #[arg(long, value_name = "T", default_value_t = 0.0)]
    pub(crate) tolerance: f64,
    /// Print one JSON document on stdout.
    #[arg(long)]
    pub(crate) json: bool,
    /// Say nothing but errors.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// `report`.
#[derive(Debug, Args)]
pub(crate) struct ReportArgs {
    /// Folder of a run.
    pub(crate) folder: PathBuf,
}

/// `reproduce`.
#[derive(Debug, Args)]
pub(crate) struct ReproduceArgs {
    /// Figure, table, or `all`; without it the list of items.
    pub(crate) item: Option<String>,
    /// Folder to write; default out/reproduce/<item>, and out/reproduce for all.
    #[arg(short, long = "output", value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// List the items.
    #[arg(long)]
    pub(crate) list: bool,
    /// Number of threads; default all.
    #[arg(long, value_name = "N")]
    pub(crate) threads: Option<usize>,
    /// Print one JSON document on stdout.
    #[arg(long)]
    pub(crate) json: bool,
    /// Say nothing but errors.
    #[arg(short, long)]
    pub(crate) quiet: bool,
}
