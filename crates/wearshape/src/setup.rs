//! What a scene means: defaults filled in, every user error found, the plan made.

mod all_around;
mod bodies;
mod carried;
mod cycle;
mod densities;
mod duty;
mod heat;
mod load;
mod materials;
mod metres;
mod one_way;
mod optimum;
mod own_rule;
mod paths;
mod remarks;
mod repeat;
mod reversing;
mod schedule;
mod stages;
mod start_gap;
mod tasks;
mod threshold;
mod track;
mod turning_axes;
mod twist;
mod unused;
mod wear_rule;

use hpfem::Kinematics;
use meshing::{Body, Couple, Files};
use scene::{Document, Fault, Scene, Task};

use crate::freedom::{self, Grip};
use crate::load::Load;
use crate::plan::Plan;
use crate::problem::{Friction, Problem};
use crate::surface::Patch;

impl Problem {
    /// Checks a document and fills in its defaults; `files` gives the bytes of the files beside it, each read once.
    ///
    /// # Errors
    /// What the user has to mend, with its place.
    pub fn new(document: &Document, files: Files<'_>) -> Result<Problem, Fault> {
        check(document, files).map_err(|fault| document.locate(fault))
    }
}

fn check(document: &Document, files: Files<'_>) -> Result<Problem, Fault> {
    let mut scene = document.scene.clone();
    cycle::resolve(&mut scene)?;
    let tasks = tasks::resolve(&mut scene)?;
    let left_out = begin(document, &mut scene, &tasks)?;
    let bodies = bodies::resolve(&mut scene, files)?;
    duty::layer(&mut scene, bodies.as_ref().map(|(_, [first, _])| first))?;
    let patch = match (&scene.surface, &bodies) {
        (Some(surface), _) => Some(Patch::bare(surface, scene.sliding.as_ref()).map_err(|fault| cycle::named(&scene, fault))?),
        (None, Some((kinematics, [first, second]))) => Patch::between(*kinematics, [first, second], scene.sliding.as_ref())
            .map_err(|fault| cycle::named(&scene, metres::hinted(fault, [first, second])))?,
        _ => None,
    };
    all_around::check(&scene, &tasks, bodies.as_ref().map(|(_, [first, _])| first), patch.as_ref())?;
    let gap = start_gap::on_surface(&scene, patch.as_ref())?;
    start_gap::not_twice(document, &gap, files)?;
    track::resolve(&scene, &tasks)?;
    wear(&mut scene, &tasks, patch.as_ref())?;
    load::resolve(&mut scene, &tasks, patch.as_ref(), bodies.as_ref().map(|(_, [first, _])| first))?;
    twist::resolve(&scene, &tasks)?;
    wanted(&mut scene, &tasks, patch.as_ref())?;
    let load = load::numbers(&scene);
    let couple = bodies.and_then(|bodies| couple(&scene, start_gap::longest_piece(&gap, &tasks, patch.as_ref()), bodies));
    one_way::wanted(&scene, couple.as_ref(), patch.as_ref())?;
    duty::resolve(&scene, &tasks, couple.as_ref())?;
    carried::check(&scene, &tasks, couple.as_ref(), patch.as_ref())?;
    couple.as_ref().map_or(Ok(()), |couple| may_move(&scene, couple, &load, patch.as_ref()))?;
    let heat = heat::resolve(&mut scene, &tasks, couple.as_ref(), patch.as_ref())?;
    let paths = paths::resolve(&mut scene, &tasks)?;
    let unused_keys = unused::keys(document, &scene, &tasks, left_out);
    let mut problem = Problem {
        name: document.name.clone(),
        wanted: tasks::wanted(&scene, &tasks),
        couple,
        bare: scene.surface.clone(),
        patch,
        freedoms: Vec::new(),
        friction: friction(&scene),
        heat,
        gap,
        load,
        sliding: scene.sliding.clone(),
        reversing: reversing::share(&scene, &tasks),
        wear: wear_rule::numbers(&scene),
        pieces: schedule::pieces(&scene),
        cycles: repeat::cycles(&scene),
        paths,
        optimum: optimum::choice(&scene),
        plan: Plan::default(),
        remarks: Vec::new(),
        unused_keys,
        scene,
    };
    problem.plan = stages::plan(&problem, &tasks, problem.scene.check.unwrap_or(true));
    problem.freedoms = problem.own_freedoms();
    problem.remarks = remarks::remarks(&problem, &tasks);
    to_be_read_again(document, &mut problem, &tasks);
    Ok(problem)
}

/// Two bodies and where the first is loaded, if it is.
fn couple(scene: &Scene, longest: f64, (kinematics, bodies): (Kinematics, [Body; 2])) -> Option<Couple> {
    let load = load::edge(scene.load.as_ref()?, Some(&bodies[0]))?;
    Some(Couple { kinematics, bodies, load, longest })
}

/// The wear rule, and the threshold below which it wears nothing.
fn wear(scene: &mut Scene, tasks: &[Task], patch: Option<&Patch>) -> Result<(), Fault> {
    wear_rule::resolve(scene, tasks, patch)?;
    threshold::resolve(scene, tasks, patch)
}

/// Refuses bodies that are free to move otherwise than their load and sliding say, and axes that turn with body 2.
fn may_move(scene: &Scene, couple: &Couple, load: &Load, patch: Option<&Patch>) -> Result<(), Fault> {
    freedom::check(couple, load, patch, grip(scene))?;
    turning_axes::check(scene, couple, patch)
}

/// Takes out what bodies without heat and bodies without loads by their mass have no use for; gives the keys of it.
fn begin(document: &Document, scene: &mut Scene, tasks: &[Task]) -> Result<Vec<String>, Fault> {
    let cold = heat::begin(scene, tasks)?;
    Ok([cold, densities::begin(document, scene)].concat())
}

/// Makes of the scene one that has, read again, the same meaning and the same unused keys.
fn to_be_read_again(document: &Document, problem: &mut Problem, tasks: &[Task]) {
    unused::leave_out(document, &mut problem.scene, tasks);
    cycle::leave_out(&mut problem.scene);
    if problem.heat.is_none() {
        heat::put_back(document, &mut problem.scene);
    }
}

/// What is wanted of the pressure, how motion and load go on, and what a shape is compared with.
fn wanted(scene: &mut Scene, tasks: &[Task], patch: Option<&Patch>) -> Result<(), Fault> {
    optimum::resolve(scene, tasks)?;
    reversing::resolve(scene, tasks, patch)?;
    schedule::resolve(scene)?;
    roughness(scene)
}

/// Checks the roughness that a shape is compared with.
fn roughness(scene: &Scene) -> Result<(), Fault> {
    let given = scene.contact.as_ref().and_then(|contact| contact.roughness);
    given.map_or(Ok(()), |roughness| scene::positive("contact.roughness", roughness.0, "roughness", " mm"))
}

/// What friction does to body 1 along the contact surface.
fn grip(scene: &Scene) -> Grip {
    let Friction { coefficient, on_bodies } = friction(scene);
    match (coefficient > 0.0 && on_bodies, &scene.sliding) {
        (false, _) => Grip::None,
        (true, None) => Grip::Holds,
        (true, Some(_)) => Grip::Drags,
    }
}

fn friction(scene: &Scene) -> Friction {
    let contact = scene.contact.as_ref();
    Friction {
        coefficient: contact.and_then(|contact| contact.friction).unwrap_or(0.0),
        on_bodies: contact.and_then(|contact| contact.shear).unwrap_or(true),
    }
}
