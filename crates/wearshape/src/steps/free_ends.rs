//! Bodies with element nodes on the ends of contact inside the surface. Contact that fills its surface never comes here.

use std::sync::Arc;

use contact::{ContactSolution, FreeEnds, held_between};
use meshing::Cut;
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::level::Level;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::start_gap::start_gaps;

/// Accuracy of the nodes by the accuracy asked for: a misplaced end changes the pressure by about its distance over the length of the contact.
/// The ends themselves are reported closer, with the step that their pressures still ask for.
pub(crate) const TOLERANCE: f64 = 0.03;

/// Bodies with element nodes on the ends of contact, and the solution with the points between the ends held in contact.
pub(crate) struct Positioned {
    pub reduced: Arc<Reduced>,
    pub held: ContactSolution,
}

/// Moves nodes onto the ends, level by level from those of the last one; `None` where that does not settle.
pub(crate) fn position(
    stage: Stage<'_>,
    level: Level,
    ends: &FreeEnds,
    work: &mut Effort,
) -> Result<Option<(FreeEnds, Positioned)>, Fault> {
    ends.position(TOLERANCE * stage.accuracy(), |places| {
        // Cells that cannot be cut there are no fault of the user's: they serve on the standing mesh.
        let Ok((parts, effort)) = stage.parts(level, Cut::Ends(places)) else { return Ok(None) };
        (stage.options.begun)(Step::Factor);
        let (reduced, reduction) = Reduced::new(&parts, stage.clock())?;
        let reduced = Arc::new(reduced);
        *work += effort;
        *work += reduction;
        work.counters.contact_solves += 1;
        let pair = reduced.pair()?;
        let length = pair.trace().length();
        let arcs: Vec<f64> = places.iter().map(|t| 0.5 * (1.0 + t) * length).collect();
        let (nodes, closed) = held_between(&pair.points(), &arcs, ends.starts_closed);
        let shear = stage.friction() > 0.0;
        let operator = work.timed(Step::Interface, stage.clock(), |_| reduced.factorised(&pair, shear, Some(&closed)))?;
        let gap = start_gaps(stage, &operator);
        let load = stage.contact_load(operator.points());
        let held = work.timed(Step::Interface, stage.clock(), |_| operator.solve_on(&gap, &load, &closed));
        let Some(held) = held.map_err(unsolved)? else { return Ok(None) };
        // The root of the node's share of the surface takes away how the pressure of a sharp end grows with the level.
        let scaled = |n: &usize| held.pressure[*n] * operator.points()[*n].weight.sqrt();
        Ok(Some((nodes.iter().map(scaled).collect(), Positioned { reduced: Arc::clone(&reduced), held })))
    })
}

/// Meshes on which ends come nearer before a search for them, and the step (of half the surface) at which they are near enough.
const ROUNDS: usize = 5;
const NEAR: f64 = 1e-3;

/// Ends nearer to those of the contact, each round those of the contact on a mesh with nodes at the ones before; `None` where their number goes on
/// changing, or no mesh can be made.
pub(crate) fn nearer(stage: Stage<'_>, level: Level, ends: &FreeEnds, work: &mut Effort) -> Result<Option<FreeEnds>, Fault> {
    let mut ends = ends.clone();
    for _ in 0..ROUNDS {
        let Ok((parts, effort)) = stage.parts(level, Cut::Ends(&ends.places)) else { return Ok(None) };
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
