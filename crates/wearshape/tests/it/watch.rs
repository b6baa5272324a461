//! What a watcher sees, and what it leaves when it stops a solve.

use std::ops::ControlFlow;
use std::sync::Mutex;

use wearshape::{Bodies, Event, Options, Problem, SCENES, Solution, Status, Step, Task, solve};

use crate::common::{digits, read, scene, solved};

/// Solves until the watcher has seen so many events; returns how often it was called.
fn stopped_at(problem: &Problem, event: usize) -> (Solution, usize) {
    let mut events = 0;
    let watch = &mut |_: Event<'_>| {
        events += 1;
        if events < event { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let solution = solve(problem, &Options::default(), &Bodies::default(), watch).unwrap();
    (solution, events)
}

/// Solves until so many levels are finished.
fn stopped_after(problem: &Problem, levels: usize) -> Solution {
    let mut begun = 0;
    let watch = &mut |event: Event<'_>| {
        begun += usize::from(matches!(event, Event::Level { .. }));
        if begun <= levels { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    solve(problem, &Options::default(), &Bodies::default(), watch).unwrap()
}

/// Nothing is told after a `Break`; what was known before the first event stays.
#[test]
fn every_task_of_every_scene_can_be_stopped_at_its_first_event() {
    let more = ["contact", "shape", "wear", "pressure,contact,shape,wear"].map(|tasks| format!("tasks=[{tasks}]"));
    let drum = more.iter().map(|tasks| scene("drum-brake-block", &[tasks]));
    let punch = ["contact", "wear"].map(|task| scene("translating-punch", &[&format!("tasks=[{task}]")]));
    let others = [
        scene("translating-punch", &["load.approach=1.3e-3"]),
        scene("annular-punch", &["tasks=[contact,shape,wear]", "output.fields=true"]),
        scene("punch-wear", &["schedule={time=[0,100],force=[1,0.5]}"]),
    ];
    let problems = SCENES.iter().map(|scene| read(scene.text, &[])).chain(drum).chain(punch).chain(others);
    for problem in problems {
        let (solution, events) = stopped_at(&problem, 1);
        let what = (problem.title().to_string(), &problem.scene().tasks);
        if problem.plan().runs(Step::Mesh) {
            assert_eq!((solution.status, events), (Status::Interrupted, 1), "{what:?}");
            assert!(solution.contact.is_none() && solution.shape.is_none() && solution.wear.is_none(), "{what:?}");
            // Under reversing motion the pressures depend on the bodies.
            let reversing = problem.scene().sliding.as_ref().is_some_and(|sliding| sliding.reversing.is_some());
            let known = problem.plan().runs(Step::Pressure) && !problem.plan().runs(Step::Force) && !reversing;
            assert_eq!(solution.pressure.is_some(), known, "{what:?}");
            let wear_alone = problem.scene().tasks.as_deref() == Some(&[Task::Wear]);
            assert!(solution.resume.is_some() || !wear_alone, "{what:?}");
        } else {
            assert_eq!((solution.status, events), (Status::Ok, 0), "{what:?}");
        }
    }
}

#[test]
fn a_stop_after_some_levels_gives_those_levels_and_no_proof() {
    for (task, levels) in [("contact", 1), ("contact", 2), ("shape", 1), ("wear", 1), ("wear", 2)] {
        let problem = scene("drum-brake-block", &["mesh.degree=6", &format!("tasks=[{task}]"), "wear.until=1"]);
        let solution = stopped_after(&problem, levels);
        assert_eq!(solution.status, Status::Interrupted, "{task}");
        let degrees: Vec<usize> = solution.ladder.iter().map(|rung| rung.degree).collect();
        let before: &[usize] = if task == "shape" { &[6] } else { &[2, 4, 6] };
        assert_eq!(degrees, before[..levels], "{task}");
        assert!(solution.profile.is_some(), "{task}: a finished level has its columns");
        let proofs = solution.shape.iter().filter(|shape| shape.roundtrip_same.or(shape.roundtrip_independent).is_some());
        assert_eq!(proofs.count(), 0, "{task}");
        assert_eq!(solution.resume.map(|resume| resume.finished.len()), (task == "wear").then_some(levels), "{task}");
        assert!(solution.error.is_none_or(|error| error.gap_relative.is_none()), "{task}: too few levels to tell an error");
    }
    let whole = solved(&scene("drum-brake-block", &["mesh.degree=6", "tasks=[shape]"]));
    assert!(whole.shape.unwrap().roundtrip_independent.is_some());
}

/// Stopped at each of the first events, gone on with at once: the same end as that of the undisturbed run.
#[test]
fn a_run_in_time_goes_on_from_wherever_it_was_stopped() {
    let problem = scene("punch-wear", &["mesh.degree=4", "wear.until=20"]);
    let whole = solved(&problem);
    for event in 1..=6 {
        let (stopped, _) = stopped_at(&problem, event);
        let options = Options { resume: stopped.resume.as_ref(), ..Options::default() };
        assert_eq!((stopped.status, options.resume.is_some()), (Status::Interrupted, true), "event {event}");
        let resumed = solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap();
        assert!(digits(&resumed) == digits(&whole), "event {event}");
    }
}

#[test]
fn levels_and_steps_are_told_in_their_order() {
    let problem = scene("drum-brake-block", &["mesh.degree=6", "tasks=[pressure,contact,shape,wear]", "wear.until=1"]);
    let (mut levels, mut runs, mut times) = (Vec::new(), Vec::new(), Vec::new());
    let watch = &mut |event: Event<'_>| {
        match event {
            Event::Level { step, degree, layers, .. } => levels.push((step, degree, layers)),
            Event::Run(level) => {
                assert_eq!(level.finished.len(), runs.len());
                assert!((level.lines)().unwrap().iter().all(|body| !body.is_empty()));
                runs.push(level.message.clone());
                times.clear();
            }
            Event::WearStep(step) => {
                assert_eq!((step.profile)().pressure, step.state.pressure);
                assert!((0.0..=1.0).contains(&step.share));
                times.push(step.state.time);
            }
        }
        ControlFlow::Continue(())
    };
    let solution = solve(&problem, &Options::default(), &Bodies::default(), watch).unwrap();
    // A finer level tells the error of a fixed one, coarser ones that of a run in time; the ends of a contact are found on coarser ones.
    let contact = [(2, 6), (4, 6), (6, 6), (8, 8)].map(|(degree, layers)| (Step::Contact, degree, layers));
    let shape = [6, 8].map(|degree| (Step::Shape, degree, degree));
    let wear = [2, 4, 6].map(|degree| (Step::Evolution, degree, degree));
    assert_eq!(levels, contact.into_iter().chain(shape).chain(wear).collect::<Vec<_>>());
    assert_eq!(runs.len(), 3);
    assert!(runs[2].starts_with("degree 6, 6 layers, "), "{}", runs[2]);
    let (name, told) = &solution.history[1];
    assert_eq!((name.as_str(), told), ("time_s", &times));
}

#[test]
fn every_part_of_the_work_is_told_as_it_begins() {
    let told = Mutex::new(Vec::new());
    let begun = |step: Step| told.lock().unwrap().push(step);
    let options = Options { begun: &begun, ..Options::default() };
    let problem = scene("drum-brake-block", &["tasks=[contact,shape]", "accuracy=1e-3", "output.fields=true"]);
    let left = Mutex::new(Vec::new());
    let watch = &mut |event: Event<'_>| {
        if let Event::Level { step: Step::Shape, left: more, .. } = event {
            left.lock().unwrap().push(more);
        }
        ControlFlow::Continue(())
    };
    assert_eq!(solve(&problem, &options, &Bodies::default(), watch).unwrap().status, Status::Ok);
    let told = told.into_inner().unwrap();
    for step in [Step::Mesh, Step::Factor, Step::Contact, Step::Shape, Step::RoundTrip, Step::Fields] {
        assert!(told.contains(&step), "{step:?} is not among {told:?}");
    }
    let left = left.into_inner().unwrap();
    assert!(left.len() >= 3 && left[..3] == [2, 1, 0], "{left:?}");
}
