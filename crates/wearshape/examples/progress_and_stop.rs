//! A run in time that is watched, stopped halfway and gone on with: it ends as the undisturbed run does, bit for bit.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Event, Fault, Options, Problem, Resume, Solution, solve};

/// A punch on a plate, worn in from a flat start.
const PUNCH: &str = r#"
units = "N-mm"
kinematics = "plane-stress"
thickness = 10
tasks = ["wear"]
mesh = { degree = 6, layers = 4 }

body1.geometry.rectangle = { x = [-30, 30], z = [100, 200] }
body1.material = { young = "210 GPa", poisson = 0.3 }
body1.support = { top = ["x"] }

body2.geometry.rectangle = { x = [-60, 60], z = [0, 100] }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.support = { bottom = ["x", "z"] }

contact = { edges = ["bottom", "top"], friction = 0.25 }
sliding = { speed = "5 mm/s" }
load = { edge = "top", as = "rigid", force = "1 kN", moment = 0, about = [0, 100] }
wear = { beta = [2e-4, 0], a = 1, b = 2, until = "steady" }
"#;

/// Solves from the start, or from where a run was stopped; prints how far it is, stops after so many steps in time, and counts them.
fn watched(problem: &Problem, resume: Option<&Resume>, most: usize) -> Result<(Solution, usize), Fault> {
    let mut steps = 0;
    let watch = &mut |event: Event<'_>| {
        match event {
            Event::Level { degree, layers, .. } => println!("degree {degree}, {layers} layers"),
            Event::Run(level) => println!("  {} steps are known", level.known_steps),
            Event::WearStep(step) => {
                steps += 1;
                if steps % 10 == 0 {
                    println!("  {:3.0} %, t = {:9.3} s", 100.0 * step.share, step.state.time);
                }
            }
        }
        if steps < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let solution = solve(problem, &Options { resume, ..Options::default() }, &Bodies::default(), watch)?;
    Ok((solution, steps))
}

/// The undisturbed run, the one that was stopped halfway, and that one gone on with.
pub fn runs() -> Result<[Solution; 3], Fault> {
    let document = Document::read("punch.toml", PUNCH, &[])?;
    let problem = Problem::new(&document, &|file| Err(format!("there is no file {file}")))?;
    let (whole, steps) = watched(&problem, None, usize::MAX)?;
    println!("\nonce more, and stopped");
    let (stopped, _) = watched(&problem, None, steps / 2)?;
    println!("\ngone on with");
    let (resumed, _) = watched(&problem, stopped.resume.as_ref(), usize::MAX)?;
    Ok([whole, stopped, resumed])
}

#[allow(dead_code)]
fn main() -> Result<(), Fault> {
    let [whole, stopped, resumed] = runs()?;
    let gap = |solution: &Solution| solution.profile.as_ref().map(|profile| profile.gap.clone());
    let same = whole.history == resumed.history && gap(&whole) == gap(&resumed);
    println!("\nfirst {:?}, then {:?}; history and gap are the same: {same}", stopped.status, resumed.status);
    Ok(())
}
