//! Scenes in memory.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Effort, Event, Options, Problem, Solution, Status, builtin, solve};

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

/// A run in time that is stopped after so many steps goes on to the digits of one that is not.
pub(crate) fn goes_on(problem: &Problem, stops: &[usize]) {
    let whole = solved(problem);
    for step in stops {
        let mut steps = 0;
        let stopped = solve(problem, &Options::default(), &Bodies::default(), &mut |event| {
            steps += usize::from(matches!(event, Event::WearStep(_)));
            if steps > *step { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        let stopped = stopped.unwrap();
        assert_eq!(stopped.status, Status::Interrupted);
        let options = Options { resume: stopped.resume.as_ref(), ..Options::default() };
        let resumed = solve(problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap();
        assert!(digits(&resumed) == digits(&whole), "step {step}");
    }
}
