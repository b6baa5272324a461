//! Scenes in memory.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Effort, Options, Problem, Solution, builtin, solve};

/// The problem of a text without files beside it.
pub(crate) fn read(text: &str, settings: &[&str]) -> Problem {
    let settings: Vec<String> = settings.iter().map(|setting| setting.to_string()).collect();
    let document = Document::read("scene.toml", text, &settings).unwrap();
    Problem::new(&document, &|file| Err(format!("there is no {file}"))).unwrap()
}

/// A built-in scene with settings.
pub(crate) fn scene(name: &str, settings: &[&str]) -> Problem {
    read(builtin(name).unwrap().text, settings)
}

/// Solved undisturbed, on bodies of its own.
pub(crate) fn solved(problem: &Problem) -> Solution {
    solved_on(problem, &Bodies::default())
}

/// Solved undisturbed.
pub(crate) fn solved_on(problem: &Problem, bodies: &Bodies) -> Solution {
    solve(problem, &Options::default(), bodies, &mut |_| ControlFlow::Continue(())).unwrap()
}

/// Every number of a solution but the effort, digit by digit: shortest texts that read back to the same bits, with one for all that are no numbers.
pub(crate) fn digits(solution: &Solution) -> String {
    format!("{:?}", Solution { effort: Effort::default(), ..solution.clone() })
}

/// Everything a problem is computed from: all of it but the keys that its text had in vain.
pub(crate) fn computed_from(problem: &Problem) -> String {
    format!("{problem:?}").replace(&format!("unused_keys: {:?}", problem.unused_keys()), "")
}
