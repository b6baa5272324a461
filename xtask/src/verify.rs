//! `cargo xtask verify`: wearshape against independent solutions by Debian's dolfinx and gmsh.
//!
//! For each case of verify/cases.toml, wearshape is run, a script in verify/ solves the same
//! problem on two levels from the resolved scene and the sample points, and the two are compared.
//! With `--known` the scripts themselves are compared with published and computed numbers.

mod case;
mod compare;
pub(crate) mod debian;
mod known;
mod picture;
pub(crate) mod programs;
mod report;
mod row;
mod study;
pub(crate) mod tables;

use case::Case;
use report::Outcome;
use row::Row;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// What the command line asks for.
#[derive(Default)]
struct Wish {
    install: bool,
    quick: bool,
    known: bool,
    can_fail: bool,
    study: bool,
    docs: bool,
    repeat: Option<usize>,
    cases: Vec<String>,
    fault: Option<String>,
    /// A built wearshape to compare, instead of building one.
    program: Option<PathBuf>,
}

const FAULTS: [&str; 3] = ["friction-sign", "young", "conductivity"];

/// Runs what `words` ask for; fails when one quantity of one case does.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    let wish = match parse(words) {
        Ok(wish) => wish,
        Err(message) => return stop(&message),
    };
    if wish.install
        && let Err(message) = debian::install()
    {
        return stop(&message);
    }
    if let Err(message) = debian::check(root) {
        return stop(&message);
    }
    let only_install = wish.install && words.len() == 1;
    if only_install {
        return ExitCode::SUCCESS;
    }
    let done = if wish.known {
        known::compare(root, &wish.cases, wish.quick, wish.fault.as_deref())
    } else if wish.study {
        wearshape(root, &wish).and_then(|program| study::run(root, &program, &wish.cases, wish.repeat.unwrap_or(3), wish.docs))
    } else {
        compare_cases(root, &wish)
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => stop(&message),
    }
}

fn stop(message: &str) -> ExitCode {
    eprintln!("verify: {message}");
    ExitCode::from(2)
}

fn parse(words: &[String]) -> Result<Wish, String> {
    let mut wish = Wish::default();
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        match word.as_str() {
            "--install" => wish.install = true,
            "--quick" => wish.quick = true,
            "--known" => wish.known = true,
            "--can-fail" => wish.can_fail = true,
            "--study" => wish.study = true,
            "--docs" => wish.docs = true,
            "--repeat" => {
                let count = rest.next().and_then(|word| word.parse().ok()).filter(|count| *count > 0);
                wish.repeat = Some(count.ok_or("--repeat needs a number of runs, 1 at least")?);
            }
            "--case" => wish.cases.push(rest.next().ok_or("--case needs the name of a case")?.clone()),
            "--program" => wish.program = Some(rest.next().ok_or("--program needs the path of a built wearshape")?.into()),
            "--fault" => {
                let fault = rest.next().filter(|fault| FAULTS.contains(&fault.as_str()));
                wish.fault = Some(fault.ok_or(format!("--fault needs one of {}", FAULTS.join(", ")))?.clone());
            }
            other => return Err(format!("there is no option `{other}`")),
        }
    }
    if (wish.docs || wish.repeat.is_some()) && !wish.study {
        return Err("--docs and --repeat belong to --study".into());
    }
    Ok(wish)
}

/// The program to compare.
fn wearshape(root: &Path, wish: &Wish) -> Result<PathBuf, String> {
    match &wish.program {
        Some(program) => Ok(program.clone()),
        None => programs::build(root),
    }
}

fn compare_cases(root: &Path, wish: &Wish) -> Result<bool, String> {
    let all = case::read(&root.join("verify/cases.toml"))?;
    for name in &wish.cases {
        if !all.iter().any(|case| case.name == *name) {
            let names: Vec<&str> = all.iter().map(|case| case.name.as_str()).collect();
            return Err(format!("there is no case `{name}`; there are: {}", names.join(", ")));
        }
    }
    let wearshape = wearshape(root, wish)?;
    if wish.can_fail {
        return faults_are_caught(root, &wearshape, &all);
    }
    let started = Instant::now();
    let mut outcomes = Vec::new();
    for case in all.iter().filter(|case| is_wanted(case, wish)) {
        let outcome = match (&case.waits, wish.cases.is_empty()) {
            (Some(reason), true) => Outcome::waits(case, reason),
            _ => run_case(root, &wearshape, case, wish.fault.as_deref()),
        };
        report::print(&outcome);
        outcomes.push(outcome);
    }
    let seconds = started.elapsed().as_secs_f64();
    let passed = report::write(&root.join("target/verify"), &outcomes, wish.fault.as_deref(), seconds)?;
    if let Some(fault) = &wish.fault {
        println!("fault `{fault}`: {}", if passed { "NOT caught" } else { "caught, as it must be" });
    }
    Ok(passed)
}

fn is_wanted(case: &Case, wish: &Wish) -> bool {
    if wish.cases.is_empty() { !wish.quick || case.quick } else { wish.cases.contains(&case.name) }
}

/// One case from start to end; whatever goes wrong is its outcome, and the other cases go on.
fn run_case(root: &Path, wearshape: &Path, case: &Case, fault: Option<&str>) -> Outcome {
    let folder = root.join("target/verify").join(&case.name);
    let started = Instant::now();
    let result = programs::solve(root, wearshape, case, &folder)
        .and_then(|()| programs::script(root, &case.script, &folder, fault))
        .and_then(|()| compare::case(case, &folder));
    Outcome::new(case, result, started.elapsed().as_secs_f64())
}

/// Gives the scripts a wrong problem on purpose: a comparison that still passes proves nothing.
fn faults_are_caught(root: &Path, wearshape: &Path, all: &[Case]) -> Result<bool, String> {
    let mut caught_all = true;
    let mut tried = 0;
    for case in all.iter().filter(|case| case.waits.is_none()) {
        for fault in &case.faults {
            let outcome = run_case(root, wearshape, case, Some(fault));
            let Ok(rows) = &outcome.result else {
                return Err(format!("case {} with fault {fault} did not run: {}", case.name, outcome.message()));
            };
            let worst = rows.iter().filter(|row| !row.passed()).map(Row::excess).fold(0.0, f64::max);
            let caught = worst > 0.0;
            let verdict = if caught { format!("caught, {worst:.0} times the tolerance") } else { "NOT caught".into() };
            println!("{:<31} fault {fault:<14} {verdict}", case.name);
            caught_all &= caught;
            tried += 1;
        }
    }
    if tried == 0 {
        return Err("no case lists a fault".into());
    }
    Ok(caught_all)
}
