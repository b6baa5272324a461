//! Bodies with element nodes on the ends of contact inside the surface. Contact that fills its surface never comes here.

use std::sync::Arc;

use contact::{ContactSolution, FreeEnds, held_between};
use meshing::Cut;
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::level::Level;
use crate::parts::Parts;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::heat::contact::HotContact;
use crate::steps::heat::following::Following;
use crate::steps::many_ends::leaves_room;
use crate::steps::start_gap::start_gaps;

/// Accuracy of the nodes by the accuracy asked for: a misplaced end changes the pressure by about its distance over the length of the contact.
/// The ends themselves are reported closer, with the step that their pressures still ask for.
const TOLERANCE: f64 = 0.03;

/// The same by the error of the pressure that is expected of a level, where that is still larger: nodes need not be better than the mesh.
const SHARE: f64 = 0.1;

/// Accuracy of the nodes, by the accuracy asked for and the error of the pressure that is expected of the level.
pub(crate) fn node_tolerance(accuracy: f64, expected: Option<f64>) -> f64 {
    let goes_on = expected.filter(|error| *error > accuracy);
    goes_on.map_or(TOLERANCE * accuracy, |error| SHARE * error)
}

/// Relative violation of signs below which a solution with its points held in contact is the contact's.
pub(crate) const SIGNS_HOLD: f64 = 1e-9;
/// Relative violation of signs above which that solution is no start for the contact's.
pub(crate) const NO_START: f64 = 1e-3;

/// How far nodes are from the ends of contact, by the step that the pressures at them still ask for, over the length of the contact in the measure of
/// the places; 0 without ends.
pub(crate) fn misplaced(ends: &FreeEnds, contact: f64) -> f64 {
    let steps = ends.refined().iter().zip(&ends.places).map(|(refined, place)| (refined - place).abs());
    if ends.places.is_empty() { 0.0 } else { steps.fold(0.0, f64::max) / contact }
}

/// Bodies with element nodes on the ends of contact, and the solution with the points between the ends held in contact.
pub(crate) struct Positioned<'a> {
    pub reduced: Arc<Reduced>,
    pub held: ContactSolution,
    /// The same contact with its heat, of a scene with heat.
    pub hot: Option<HotContact<'a>>,
}

impl Positioned<'_> {
    /// The ends of the contact of a scene with heat once its points may open and close, at a part of the sliding speed; none where these do not settle.
    pub(crate) fn ends_at(&self, speed: f64) -> Result<FreeEnds, Fault> {
        let pair = self.reduced.pair()?;
        let length = pair.trace().length();
        let Some(HotContact { stage, following, hot, .. }) = &self.hot else { return Ok(FreeEnds::of(&self.held, length)) };
        if self.held.complementarity < SIGNS_HOLD {
            return Ok(FreeEnds::of(&self.held, length));
        }
        let operator = self.reduced.operator(&pair, stage.friction() > 0.0)?;
        let (gap, load) = (start_gaps(*stage, &operator), stage.contact_load(operator.points()));
        let released = following.settled(&operator, &gap, &load, speed, Some(&hot.found));
        Ok(released.map_or_else(|_| FreeEnds::default(), |released| FreeEnds::of(&released.found, length)))
    }
}

/// Moves nodes onto the ends to an accuracy, level by level from those of the last one; `None` where that does not settle.
pub(crate) fn position<'a>(
    stage: Stage<'a>,
    level: Level,
    (ends, within): (&FreeEnds, f64),
    work: &mut Effort,
) -> Result<Option<(FreeEnds, Positioned<'a>)>, Fault> {
    position_at(stage, level, (ends, within, 1.0), work)
}

/// The same at a part of the sliding speed, of a scene with heat.
pub(crate) fn position_at<'a>(
    stage: Stage<'a>,
    level: Level,
    (ends, within, speed): (&FreeEnds, f64, f64),
    work: &mut Effort,
) -> Result<Option<(FreeEnds, Positioned<'a>)>, Fault> {
    ends.position(within, |places| held(stage, level, (places, ends.starts_closed, speed), work))
}

/// Whether an odd number of branches lies between a hot contact with these ends and one that is unique.
pub(crate) fn branched(stage: Stage<'_>, level: Level, ends: &FreeEnds, work: &mut Effort) -> Result<bool, Fault> {
    ends.branched(|places| held(stage, level, (places, ends.starts_closed, 1.0), work))
}

/// Bodies with nodes at places on the surface, the solution with the points between them held in contact, at a part of the sliding speed of a scene with
/// heat, and the pressures at the nodes; `None` where there are no such bodies.
fn held<'a>(
    stage: Stage<'a>,
    level: Level,
    (places, starts_closed, speed): (&[f64], bool, f64),
    work: &mut Effort,
) -> Result<Option<(Vec<f64>, Positioned<'a>)>, Fault> {
    if (stage.options.ending)() {
        return Ok(None);
    }
    let Some((reduced, following)) = bodies(stage, level, places, work)? else { return Ok(None) };
    work.counters.contact_solves += 1;
    let pair = reduced.pair()?;
    let length = pair.trace().length();
    let arcs: Vec<f64> = places.iter().map(|t| 0.5 * (1.0 + t) * length).collect();
    let (nodes, closed) = held_between(&pair.points(), &arcs, starts_closed);
    let shear = stage.friction() > 0.0;
    let operator = work.timed(Step::Interface, stage.clock(), |_| reduced.factorised(&pair, shear, Some(&closed)))?;
    let gap = start_gaps(stage, &operator);
    let load = stage.contact_load(operator.points());
    let found = work.timed(Step::Interface, stage.clock(), |_| match &following {
        Some(following) => {
            Ok(following.held(&operator, &gap, &load, (speed, &closed))?.map(|hot| (hot.found.clone(), Some(hot))))
        }
        None => Ok(operator.solve_on(&gap, &load, &closed).map_err(unsolved)?.map(|held| (held, None))),
    })?;
    let Some((held, hot)) = found else { return Ok(None) };
    // The root of the node's share of the surface takes away how the pressure of a sharp end grows with the level.
    let scaled = |n: &usize| held.pressure[*n] * operator.points()[*n].weight.sqrt();
    let residuals = nodes.iter().map(scaled).collect();
    let hot = following.zip(hot).map(|(following, hot)| HotContact { stage, following, hot, between: None });
    Ok(Some((residuals, Positioned { reduced: Arc::clone(&reduced), held, hot })))
}

/// Bodies, and what of them follows the pressure where there is heat.
type Followed<'a> = (Arc<Reduced>, Option<Following<'a>>);

/// Bodies with nodes at places on the surface. Cells that cannot be cut there are no fault of the user's: they serve on the standing mesh.
fn bodies<'a>(stage: Stage<'a>, level: Level, places: &[f64], work: &mut Effort) -> Result<Option<Followed<'a>>, Fault> {
    let cut = Cut::Ends(places);
    if stage.problem.heat.is_some() {
        let Ok(Some((following, effort))) = Following::new(stage, level, cut) else { return Ok(None) };
        *work += effort;
        return Ok(Some((Arc::clone(&following.reduced), Some(following))));
    }
    let Some((parts, effort)) = parts(stage, level, cut) else { return Ok(None) };
    (stage.options.begun)(Step::Factor);
    let (reduced, reduction) = Reduced::new(&parts, stage.clock())?;
    *work += effort;
    *work += reduction;
    Ok(Some((Arc::new(reduced), None)))
}

/// Bodies before their reduction, if cells can be cut as wanted and are not too many.
fn parts(stage: Stage<'_>, level: Level, cut: Cut<'_>) -> Option<(Parts, Effort)> {
    stage.parts(level, cut).ok().filter(|(parts, _)| leaves_room(parts.contact_unknowns(), level))
}

/// Meshes on which ends come nearer before a search for them, and the step (of half the surface) at which they are near enough.
const ROUNDS: usize = 5;
const NEAR: f64 = 1e-3;

/// Ends nearer to those of the contact, each round those of the contact on a mesh with nodes at the ones before; `None` where their number goes on
/// changing, or no mesh can be made.
pub(crate) fn nearer(stage: Stage<'_>, level: Level, ends: &FreeEnds, work: &mut Effort) -> Result<Option<FreeEnds>, Fault> {
    let mut ends = ends.clone();
    for _ in 0..ROUNDS {
        if (stage.options.ending)() {
            break;
        }
        let Some((parts, effort)) = parts(stage, level, Cut::Ends(&ends.places)) else { return Ok(None) };
        (stage.options.begun)(Step::Factor);
        let (reduced, reduction) = Reduced::new(&parts, stage.clock())?;
        *work += effort;
        *work += reduction;
        work.counters.contact_solves += 1;
        let pair = reduced.pair()?;
        let operator = work.timed(Step::Interface, stage.clock(), |_| reduced.operator(&pair, stage.friction() > 0.0))?;
        let (gap, load) = (start_gaps(stage, &operator), stage.contact_load(operator.points()));
        let found = operator.solve(&gap, &load, None).map_err(unsolved)?;
        let next = FreeEnds::of(&found, pair.trace().length());
        if next.places.is_empty() {
            return Ok(None);
        }
        let same = next.places.len() == ends.places.len() && next.starts_closed == ends.starts_closed;
        let moved = next.places.iter().zip(&ends.places).fold(0.0_f64, |most, (now, before)| most.max((now - before).abs()));
        ends = next;
        if same && moved < NEAR {
            return Ok(Some(ends));
        }
    }
    Ok(None)
}
