//! Reduced bodies of all levels, kept as long as what they depend on stays the same: a sweep in load, friction, wear or optimum meshes and
//! factors each level once, and so do several tasks of one run.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use contact::{ContactOperator, Pair, UnitResponses};
use hpfem::{InterfaceOperator, InterfaceState, Sizes};
use meshing::{CoarseMeshes, Couple, Cut, Extent, GivenCells, coarse_meshes};
use scene::Fault;

use crate::effort::{Clock, Counters, Effort};
use crate::level::Level;
use crate::parts::{Held, Meeting, Parts};
use crate::results::Reaction;

/// Kinds of bodies that are kept at once; a sweep over geometries does not keep them all.
const KINDS: usize = 4;

/// Which reduced bodies of a couple.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// Degree and layers.
    pub level: Level,
    /// Where the meshes are cut.
    pub cut: Cut<'static>,
    /// The scalar problem of twisting instead of the one in the plane.
    pub torsion: bool,
}

/// The store, shared by whoever solves problems with the same bodies, on any number of threads. It is never locked while bodies are made: two
/// threads that miss the same ones both make them, and the first to finish keeps them.
#[derive(Debug, Default)]
pub struct Bodies {
    kinds: Mutex<Vec<(Couple, Kind)>>,
    given: Mutex<Vec<(Couple, Extent, Arc<GivenCells>)>>,
    coarse: Mutex<Vec<Coarse>>,
    sizes: Mutex<Vec<Sized>>,
    factorisations: AtomicUsize,
    reused: AtomicUsize,
}

/// The coarse meshes of a couple that touches on a surface, by where they are cut.
type Coarse = (Couple, Extent, Cut<'static>, Arc<CoarseMeshes>);

/// The sizes of a couple on a level.
type Sized = (Couple, Level, [Sizes; 2]);

/// The reduced bodies of one couple.
type Kind = Vec<(Place, Arc<Reduced>)>;

impl Bodies {
    /// Bodies that were factorised and kept so far.
    pub fn factorisations(&self) -> usize {
        self.factorisations.load(Ordering::Relaxed)
    }

    /// Bodies that were asked for and already there.
    pub fn reused(&self) -> usize {
        self.reused.load(Ordering::Relaxed)
    }

    /// The coarse meshes of a couple, made if they are not there: those of cells that the user gives take longer than what is done with them.
    pub(crate) fn coarse(&self, couple: &Couple, extent: Extent, cut: Cut<'static>) -> Result<Arc<CoarseMeshes>, Fault> {
        let same = |known: &&Coarse| known.0 == *couple && known.1 == extent && known.2 == cut;
        if let Some(known) = lock(&self.coarse).iter().find(same).map(|known| Arc::clone(&known.3)) {
            return Ok(known);
        }
        let new = Arc::new(coarse_meshes(&*self.given(couple, extent)?, couple, extent, cut)?);
        keep_last(&self.coarse, (couple.clone(), extent, cut, Arc::clone(&new)));
        Ok(new)
    }

    /// The cells that the bodies of a couple are given by, made ready if they are not: looking for their singular points takes longer than a mesh of them.
    pub(crate) fn given(&self, couple: &Couple, extent: Extent) -> Result<Arc<GivenCells>, Fault> {
        let same = |known: &&(Couple, Extent, Arc<GivenCells>)| known.0 == *couple && known.1 == extent;
        if let Some(known) = lock(&self.given).iter().find(same).map(|known| Arc::clone(&known.2)) {
            return Ok(known);
        }
        let new = Arc::new(GivenCells::new(couple, extent)?);
        keep_last(&self.given, (couple.clone(), extent, Arc::clone(&new)));
        Ok(new)
    }

    /// The sizes of the bodies of a couple on a level, found if they are not there: whoever checks a scene asks for one of them twice.
    pub(crate) fn sizes(
        &self,
        couple: &Couple,
        level: Level,
        find: impl FnOnce() -> Result<[Sizes; 2], Fault>,
    ) -> Result<[Sizes; 2], Fault> {
        let same = |known: &&Sized| known.0 == *couple && known.1 == level;
        if let Some(known) = lock(&self.sizes).iter().find(same).map(|known| known.2) {
            return Ok(known);
        }
        let new = find()?;
        keep_last(&self.sizes, (couple.clone(), level, new));
        Ok(new)
    }

    /// The reduced bodies of a place, made if they are not there.
    pub(crate) fn get(
        &self,
        couple: &Couple,
        place: Place,
        make: impl FnOnce() -> Result<(Reduced, Effort), Fault>,
    ) -> Result<(Arc<Reduced>, Effort), Fault> {
        if let Some(reduced) = self.find(couple, place) {
            self.reused.fetch_add(2, Ordering::Relaxed);
            let effort = reduced.sizes();
            return Ok((reduced, effort));
        }
        let (reduced, effort) = make()?;
        Ok((self.keep(couple, place, Arc::new(reduced)), effort))
    }

    /// The bodies of a place; its couple becomes the one asked for last, which stands last.
    fn find(&self, couple: &Couple, place: Place) -> Option<Arc<Reduced>> {
        let mut kinds = lock(&self.kinds);
        let at = kinds.iter().position(|(known, _)| known == couple)?;
        let kind = kinds.remove(at);
        kinds.push(kind);
        kinds.last()?.1.iter().find(|(known, _)| *known == place).map(|(_, reduced)| Arc::clone(reduced))
    }

    /// Keeps new bodies, unless another thread was first: then those.
    fn keep(&self, couple: &Couple, place: Place, new: Arc<Reduced>) -> Arc<Reduced> {
        let mut kinds = lock(&self.kinds);
        let at = kinds.iter().position(|(known, _)| known == couple).unwrap_or_else(|| {
            kinds.push((couple.clone(), Kind::new()));
            kinds.len() - 1
        });
        let (counter, kept) = match kinds[at].1.iter().find(|(known, _)| *known == place) {
            Some((_, other)) => (&self.reused, Arc::clone(other)),
            None => {
                kinds[at].1.push((place, Arc::clone(&new)));
                (&self.factorisations, new)
            }
        };
        counter.fetch_add(2, Ordering::Relaxed);
        if kinds.len() > KINDS {
            kinds.remove(0);
        }
        kept
    }
}

/// A panic elsewhere is reported there; the numbers behind the lock are whole.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Keeps one more, for which the first goes where there are many.
fn keep_last<T>(kept: &Mutex<Vec<T>>, new: T) {
    let mut kept = lock(kept);
    if kept.len() >= KINDS {
        kept.remove(0);
    }
    kept.push(new);
}

/// Both bodies of one discretisation, reduced to their contact surface.
pub(crate) struct Reduced {
    /// Body 1 and body 2.
    pub interfaces: [InterfaceOperator; 2],
    held: [Held; 2],
    meeting: Meeting,
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
    /// Assembles and reduces both bodies.
    pub(crate) fn new(parts: &Parts, clock: Clock) -> Result<(Reduced, Effort), Fault> {
        let (interfaces, effort) = parts.interfaces(clock)?;
        Ok((Reduced::of(parts, interfaces, effort.counters.clone()), effort))
    }

    /// Bodies of these parts that are reduced already.
    pub(crate) fn of(parts: &Parts, interfaces: [InterfaceOperator; 2], counters: Counters) -> Reduced {
        let held = |body: usize| parts.parts[body].held.clone();
        Reduced { interfaces, held: [held(0), held(1)], meeting: parts.meeting, counters, unit: Default::default() }
    }

    /// Cells and unknowns of the discretisation.
    pub(crate) fn sizes(&self) -> Effort {
        let Counters { cells, dofs, trace_dofs, .. } = self.counters;
        Effort { counters: Counters { cells, dofs, trace_dofs, ..Counters::default() }, seconds: Vec::new() }
    }

    /// Pairs the two bodies.
    pub(crate) fn pair(&self) -> Result<Pair<'_>, Fault> {
        paired([&self.interfaces[0], &self.interfaces[1]], self.meeting)
    }

    /// The contact of the pair with the compliance of all its points, its unit responses kept.
    pub(crate) fn operator<'b>(&'b self, pair: &Pair<'b>, shear: bool) -> Result<ContactOperator<'b>, Fault> {
        let operator = self.factorised(pair, shear, None)?;
        operator.compliance();
        Ok(operator)
    }

    /// The same without that compliance, as contact on known points does without it; `near` are the points expected in contact, where these are known.
    pub(crate) fn factorised<'b>(
        &'b self,
        pair: &Pair<'b>,
        shear: bool,
        near: Option<&[bool]>,
    ) -> Result<ContactOperator<'b>, Fault> {
        let place = &self.unit[usize::from(shear)];
        let known = lock(place).clone();
        if let Some(unit) = known {
            return Ok(ContactOperator::with(pair, unit));
        }
        let operator = near
            .map_or_else(|| ContactOperator::new(pair, shear), |near| ContactOperator::near(pair, shear, near))
            .map_err(|error| Fault::at("body1.support", "not-held", error.to_string(), "support the bodies"))?;
        *lock(place) = Some(operator.unit_responses());
        Ok(operator)
    }

    /// Forces of the supports on their bodies.
    pub(crate) fn reactions(&self, states: [Option<&InterfaceState>; 2]) -> Vec<(String, Reaction)> {
        reactions([&self.interfaces[0], &self.interfaces[1]], [&self.held[0], &self.held[1]], states)
    }
}

/// Pairs two reduced bodies.
pub(crate) fn paired<'b>([first, second]: [&'b InterfaceOperator; 2], meeting: Meeting) -> Result<Pair<'b>, Fault> {
    let pair = match meeting {
        Meeting::Together => Pair::new(first, Some(second)),
        Meeting::Across => Pair::facing(first, second),
        Meeting::ByAngle => Pair::by_angle(first, second),
        Meeting::ByArc => Pair::by_arc(first, second),
    };
    pair.map_err(|error| {
        let remedy = "give both bodies the same contact surface";
        Fault::at("contact.edges", "no-contact", error.to_string(), remedy)
    })
}

/// Forces of the supports and of a rigid edge's guide on their bodies, edge by edge; supports without a name are planes of symmetry.
pub(crate) fn reactions(
    bodies: [&InterfaceOperator; 2],
    held: [&Held; 2],
    states: [Option<&InterfaceState>; 2],
) -> Vec<(String, Reaction)> {
    let mut reactions: Vec<(String, Reaction)> = Vec::new();
    for ((held, body), state) in held.iter().zip(bodies).zip(states) {
        let Some(state) = state else { continue };
        for (number, name) in held.names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
            let mut reaction = body.reaction(number, state);
            for (case, force) in held.carried.iter().filter(|_| number + 1 == held.names.len()) {
                reaction.iter_mut().zip(force).for_each(|(sum, force)| *sum += state.factors[*case] * force);
            }
            let [x, z, moment] = reaction;
            match reactions.iter_mut().find(|(known, _)| known == name) {
                Some((_, sum)) => {
                    sum.x = sum.x.map(|v| v + x);
                    sum.z = sum.z.map(|v| v + z);
                    sum.moment = sum.moment.map(|v| v + moment);
                }
                None => {
                    let new = Reaction { x: Some(x), z: Some(z), moment: Some(moment) };
                    reactions.push((name.clone(), new));
                }
            }
        }
    }
    reactions
}
