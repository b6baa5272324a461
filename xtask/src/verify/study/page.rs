//! The pages of a study: target/verify/study.html, and its part of docs/error-against-time.md.

use super::super::picture::escape;
use super::outcome::{Factor, Outcome};
use super::plot;
use crate::machine::machine;
use std::fs;
use std::path::Path;

const PAGE: &str = "docs/error-against-time.md";
const BEGIN: &str = "<!-- study: begin; written by `cargo xtask verify --study --docs` -->";
const END: &str = "<!-- study: end -->";

/// Where and when it was measured, in one sentence.
pub(crate) struct Machine {
    pub(crate) words: String,
}

impl Machine {
    /// This machine, now.
    pub(crate) fn here(outcomes: &[Outcome], repeat: usize) -> Self {
        let versions = outcomes.first().map(|outcome| &outcome.versions);
        let version = |name: &str| versions.and_then(|v| v[name].as_str()).unwrap_or("?").to_string();
        let waited = outcomes.iter().map(|outcome| outcome.waited).fold(1.0, f64::max);
        let words = format!(
            "{}; dolfinx {}, gmsh {}, PETSc {} with MUMPS, from Debian; one thread each, \
             least of {repeat} runs in turn, wall clock at most {waited:.2} times the processor's",
            machine(),
            version("dolfinx"),
            version("gmsh"),
            version("petsc"),
        );
        Self { words }
    }
}

/// One comparison in words.
pub(crate) fn sentence(factor: &Factor) -> String {
    let [ours, theirs, times] = cells(factor);
    let wanted = match factor.least {
        Some(least) if factor.value().is_some_and(|value| value >= least) => format!(" (wanted {least}: reached)"),
        Some(least) => format!(" (wanted {least}: MISSED)"),
        None => String::new(),
    };
    format!("error {:.0e}: wearshape {ours}, dolfinx {theirs}: {times}{wanted}", factor.error)
}

/// Seconds of ours, of theirs, and the factor.
fn cells(factor: &Factor) -> [String; 3] {
    let seconds = |value: Option<f64>| match value {
        Some(s) if s < 0.1 => format!("{:.1} ms", 1e3 * s),
        Some(s) => format!("{s:.2} s"),
        None => "outside its levels".into(),
    };
    [seconds(factor.ours), seconds(factor.theirs), factor.value().map_or("-".into(), |value| format!("{value:.0} times"))]
}

/// The page with pictures and all levels.
pub(crate) fn html(outcomes: &[Outcome], machine: &Machine) -> String {
    let mut body = format!("<h1>Error against seconds</h1>\n<p>{}.</p>\n", escape(&machine.words));
    for outcome in outcomes {
        body += &format!("<h2>{}</h2>\n{}", escape(&outcome.study.title), plot::picture(outcome));
        body += "<p>Truth: ours on a far finer mesh. ";
        body += &outcome.truth.iter().map(|sentence| escape(sentence) + ".").collect::<Vec<_>>().join(" ");
        body += "</p>\n<table><tr><th>error<th>wearshape<th>dolfinx<th>factor<th>wanted</tr>\n";
        for factor in &outcome.factors {
            let least = factor.least.map_or(String::new(), |least| format!("{least}"));
            body += &format!("<tr><td>{:.0e}<td>{}<td>{least}</tr>\n", factor.error, cells(factor).join("<td>"));
        }
        body += "</table>\n<details><summary>All levels</summary><table><tr><th>program<th>level<th>unknowns<th>seconds<th>error</tr>\n";
        for ladder in &outcome.ladders {
            for p in &ladder.points {
                let (name, label) = (escape(&ladder.name), escape(&p.label));
                body += &format!("<tr><td>{name}<td>{label}<td>{}<td>{:.4}<td>{:.1e}</tr>\n", p.unknowns, p.seconds, p.error);
            }
        }
        body += "</table></details>\n";
    }
    format!(
        "<!doctype html><html lang=en><meta charset=utf-8><title>Error against seconds</title><style>body{{font:15px sans-serif;\
         margin:2em;max-width:60em}}td,th{{padding:.2em .8em;text-align:left}}svg{{max-width:100%;height:auto}}</style>\n{body}</html>\n"
    )
}

/// Replaces the part of the committed page between the marks, and the pictures beside it.
pub(crate) fn docs(root: &Path, outcomes: &[Outcome], machine: &Machine) -> Result<(), String> {
    let path = root.join(PAGE);
    let page = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let lost = || format!("{}: the marks `{BEGIN}` and `{END}` are not there", path.display());
    let (before, rest) = page.split_once(BEGIN).ok_or_else(lost)?;
    let (_, after) = rest.split_once(END).ok_or_else(lost)?;
    let mut part = format!("\n\nMeasured {}.\n", machine.words);
    for outcome in outcomes {
        let name = format!("study-{}.svg", outcome.study.name);
        let picture = root.join("docs").join(&name);
        fs::write(&picture, plot::picture(outcome)).map_err(|error| format!("{}: {error}", picture.display()))?;
        part +=
            &format!("\n### {}\n\n![{}]({name})\n\nTruth: ours on a far finer mesh", outcome.study.title, outcome.study.title);
        part += &outcome.truth.iter().map(|sentence| format!("; {sentence}")).collect::<String>();
        part += ".\n\n| error | wearshape | dolfinx | factor |\n|---|---|---|---|\n";
        for factor in &outcome.factors {
            part += &format!("| {:.0e} | {} |\n", factor.error, cells(factor).join(" | "));
        }
    }
    let text = format!("{before}{BEGIN}{part}\n{END}{after}");
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
}
