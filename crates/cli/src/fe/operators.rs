//! Reduced bodies of all levels, kept as long as what they depend on stays the same: a sweep in load, friction, wear or optimum meshes and
//! factors each level once, and so do several tasks of one run.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use contact::{ContactOperator, Pair, UnitResponses};
use hpfem::{Effort, InterfaceOperator, InterfaceState};

use crate::fault::Fault;
use crate::fe::bodies::Level;
use crate::fe::stage::Parts;
use crate::fe::template::Cut;
use crate::scene::{Scene, Units};
use crate::solution::{Counters, Reaction, Solution};

/// Kinds of bodies that are kept at once; a sweep over geometries does not keep them all.
const KINDS: usize = 4;

/// Which reduced bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) level: Level,
    pub(super) cut: Cut<'static>,
    /// The scalar problem of twisting instead of the one in the plane.
    pub(super) torsion: bool,
}

/// A value that one thread makes while the others wait for it.
type Slot<T> = Arc<Mutex<Option<T>>>;

/// The store. Its lock is never held while bodies are made; the lock of a slot is.
#[derive(Debug, Default)]
pub(crate) struct Operators {
    kinds: Mutex<Vec<(String, Kind)>>,
    factorisations: AtomicUsize,
    reused: AtomicUsize,
}

/// The reduced bodies of one kind.
type Kind = Vec<(Place, Slot<Arc<Reduced>>)>;

impl Operators {
    /// Bodies factorised so far.
    pub(crate) fn factorisations(&self) -> usize {
        self.factorisations.load(Ordering::Relaxed)
    }

    /// Bodies that were asked for again and needed no factorisation.
    pub(crate) fn reused(&self) -> usize {
        self.reused.load(Ordering::Relaxed)
    }

    /// The reduced bodies of a place, made if they are not there. What it costs goes to the counters and times of `solution`.
    pub(super) fn get(
        &self,
        scene: &Scene,
        place: Place,
        solution: &mut Solution,
        make: impl FnOnce(&mut Solution) -> Result<Reduced, Fault>,
    ) -> Result<Arc<Reduced>, Fault> {
        let slot = self.slot(kind_of(scene)?, place);
        let mut guard = lock(&slot);
        let reduced = match guard.as_ref() {
            Some(reduced) => {
                self.reused.fetch_add(2, Ordering::Relaxed);
                Arc::clone(reduced)
            }
            None => {
                let reduced = Arc::new(make(solution)?);
                solution.counters.factorisations += 2;
                self.factorisations.fetch_add(2, Ordering::Relaxed);
                *guard = Some(Arc::clone(&reduced));
                reduced
            }
        };
        Ok(reduced)
    }

    fn slot(&self, kind: String, place: Place) -> Slot<Arc<Reduced>> {
        let mut kinds = lock(&self.kinds);
        // The kind asked for last stands last.
        let known = match kinds.iter().position(|(known, _)| *known == kind) {
            Some(at) => kinds.remove(at),
            None => (kind, Kind::new()),
        };
        kinds.push(known);
        if kinds.len() > KINDS {
            kinds.remove(0);
        }
        let last = kinds.len() - 1;
        let places = &mut kinds[last].1;
        match places.iter().find(|(known, _)| *known == place) {
            Some((_, slot)) => Arc::clone(slot),
            None => {
                let slot = Slot::default();
                places.push((place, Arc::clone(&slot)));
                slot
            }
        }
    }
}

/// A panic elsewhere is reported there; the numbers behind the lock are whole.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What the reduced bodies of a scene depend on: all of it but loads (bodies carry unit loads), friction, sliding, wear, optimum and output.
fn kind_of(scene: &Scene) -> Result<String, Fault> {
    let mut kind = Scene {
        title: None,
        units: Units::NewtonMillimetre,
        tasks: None,
        accuracy: None,
        mesh: None,
        check: None,
        sliding: None,
        wear: None,
        schedule: None,
        optimum: None,
        output: None,
        ..scene.clone()
    };
    if let Some(contact) = &mut kind.contact {
        contact.friction = None;
        contact.shear = None;
        contact.gap = None;
    }
    if let Some(load) = &mut kind.load {
        // A rotation prescribed as zero is held; another one is a motion like a free one.
        load.tilt = load.tilt.filter(|tilt| tilt.0 == 0.0);
        load.force = None;
        load.approach = None;
        load.approach_time = None;
        load.moment = None;
        load.moment_y = None;
        load.shear_force = None;
        load.twist = None;
        load.torque = None;
    }
    serde_json::to_string(&kind)
        .map_err(|error| Fault::new("internal", format!("the scene cannot be compared: {error}"), "please report this scene"))
}

/// Counts the work of reducing both bodies.
pub(super) fn count(bodies: [(&InterfaceOperator, Effort); 2], solution: &mut Solution) {
    let total = |f: &dyn Fn(&Effort) -> f64| bodies.iter().map(|(_, effort)| f(effort)).sum::<f64>();
    solution.times.push(("assemble".into(), total(&|e| e.assemble)));
    solution.times.push(("factor".into(), total(&|e| e.factor)));
    solution.counters.cells = bodies.iter().map(|(_, effort)| effort.cells).sum();
    solution.counters.dofs = bodies.iter().map(|(_, effort)| effort.unknowns).sum();
    solution.counters.trace_dofs = bodies.iter().map(|(interface, _)| interface.stiffness.nrows()).sum();
    solution.counters.factorisations += bodies.len();
}

/// Both bodies of one discretisation, reduced to their contact surface.
pub(super) struct Reduced {
    pub(super) interfaces: [InterfaceOperator; 2],
    support_names: [Vec<String>; 2],
    facing: bool,
    counters: Counters,
    /// Unit responses without and with shear.
    unit: [Mutex<Option<Arc<UnitResponses>>>; 2],
}

impl std::fmt::Debug for Reduced {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Reduced").field("counters", &self.counters).finish_non_exhaustive()
    }
}

impl Reduced {
    /// Assembles and reduces both bodies; their effort goes to the times of `solution`.
    pub(super) fn new(parts: &Parts, solution: &mut Solution) -> Result<Reduced, Fault> {
        let mut work = Solution::default();
        let interfaces = parts.interfaces(&mut work)?;
        solution.times.append(&mut work.times);
        work.counters.factorisations = 0;
        let names = |body: usize| parts.parts[body].support_names.clone();
        let (support_names, facing) = ([names(0), names(1)], parts.facing);
        Ok(Reduced { interfaces, support_names, facing, counters: work.counters, unit: Default::default() })
    }

    /// Cells and unknowns of the discretisation, into the counters of a run.
    pub(super) fn count(&self, counters: &mut Counters) {
        counters.cells = self.counters.cells;
        counters.dofs = self.counters.dofs;
        counters.trace_dofs = self.counters.trace_dofs;
    }

    /// Pairs the two bodies.
    pub(super) fn pair(&self) -> Result<Pair<'_>, Fault> {
        paired([&self.interfaces[0], &self.interfaces[1]], self.facing)
    }

    /// The contact of the pair, its unit responses kept.
    pub(super) fn operator<'b>(&'b self, pair: &Pair<'b>, shear: bool) -> Result<ContactOperator<'b>, Fault> {
        let mut unit = lock(&self.unit[usize::from(shear)]);
        if let Some(unit) = unit.as_ref() {
            return Ok(ContactOperator::with(pair, Arc::clone(unit)));
        }
        let operator = ContactOperator::new(pair, shear)
            .map_err(|error| Fault::at("body1.support", "not-held", error.to_string(), "support the bodies"))?;
        *unit = Some(operator.unit_responses());
        Ok(operator)
    }

    /// Forces of the supports on their bodies.
    pub(super) fn reactions(&self, states: [Option<&InterfaceState>; 2]) -> Vec<(String, Reaction)> {
        reactions([&self.interfaces[0], &self.interfaces[1]], [&self.support_names[0], &self.support_names[1]], states)
    }
}

/// Pairs two reduced bodies, on each other or facing each other across a gap.
pub(super) fn paired<'b>([first, second]: [&'b InterfaceOperator; 2], facing: bool) -> Result<Pair<'b>, Fault> {
    let pair = if facing { Pair::facing(first, second) } else { Pair::new(first, Some(second)) };
    pair.map_err(|error| {
        let remedy = "give both bodies the same contact surface";
        Fault::at("contact.edges", "no-contact", error.to_string(), remedy)
    })
}

/// Forces of the supports on their bodies, edge by edge; supports without a name are planes of symmetry.
pub(super) fn reactions(
    bodies: [&InterfaceOperator; 2],
    support_names: [&[String]; 2],
    states: [Option<&InterfaceState>; 2],
) -> Vec<(String, Reaction)> {
    let mut reactions: Vec<(String, Reaction)> = Vec::new();
    for ((names, body), state) in support_names.iter().zip(bodies).zip(states) {
        let Some(state) = state else { continue };
        for (number, name) in names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
            let [x, z, moment] = body.reaction(number, state);
            match reactions.iter_mut().find(|(known, _)| known == name) {
                Some((_, sum)) => {
                    sum.x_N = sum.x_N.map(|v| v + x);
                    sum.z_N = sum.z_N.map(|v| v + z);
                    sum.moment_Nmm = sum.moment_Nmm.map(|v| v + moment);
                }
                None => {
                    let new = Reaction { x_N: Some(x), z_N: Some(z), moment_Nmm: Some(moment) };
                    reactions.push((name.clone(), new));
                }
            }
        }
    }
    reactions
}
