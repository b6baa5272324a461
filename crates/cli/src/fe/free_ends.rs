//! Ends of contact inside the surface: element nodes are moved onto all of them, in both bodies. Contact that fills its surface never comes here.

use std::sync::Arc;

use contact::{ContactSolution, Start, Status, held_between, position_nodes};

use crate::fault::Fault;
use crate::fe::bodies::Level;
use crate::fe::contact::{gap_at, unsolved};
use crate::fe::operators::Reduced;
use crate::fe::stage::Stage;
use crate::fe::template::Cut;
use crate::solution::Solution;

/// Accuracy of the nodes by the accuracy asked for: a misplaced end changes the pressure by about its distance over the length of the contact.
const TOLERANCE: f64 = 0.01;

/// A level moves its nodes until the step left is this share of its first one, that is of what the level before it still lacked.
const SHARE: f64 = 0.05;

/// Meshes of a level after which its ends are held not to settle.
const MOST: usize = 16;

/// Ends of contact inside the surface.
#[derive(Clone, Debug, Default)]
pub(super) struct FreeEnds {
    /// Where the nodes are, from -1 to 1 on the surface, ascending.
    pub(super) places: Vec<f64>,
    /// Where contact ends: the places and the step that their pressures still ask for.
    refined: Vec<f64>,
    /// How the pressures at the ends change with their places, from the level before.
    jacobian: Option<nalgebra::DMatrix<f64>>,
    /// Whether the start of the surface is in contact.
    pub(super) starts_closed: bool,
}

/// Bodies with element nodes on the ends of contact, and the solution with the points between the ends held in contact.
pub(super) struct Positioned {
    pub(super) ends: FreeEnds,
    pub(super) reduced: Arc<Reduced>,
    pub(super) held: ContactSolution,
}

impl FreeEnds {
    /// The ends of a solution's contact zones that lie inside a surface of the given length; none where there is no partial contact.
    pub(super) fn of(solution: &ContactSolution, length: f64) -> FreeEnds {
        if solution.status != Status::Converged {
            return FreeEnds::default();
        }
        let inside = |arc: &f64| *arc > 1e-9 * length && *arc < (1.0 - 1e-9) * length;
        let places: Vec<f64> =
            solution.zones.iter().flatten().copied().filter(inside).map(|arc| 2.0 * arc / length - 1.0).collect();
        FreeEnds {
            refined: places.clone(),
            places,
            jacobian: None,
            starts_closed: solution.closed.first().copied().unwrap_or(false),
        }
    }

    /// All ends of contact as arc lengths, those of the surface included.
    pub(super) fn arcs(&self, length: f64) -> Vec<f64> {
        let mut arcs: Vec<f64> = self.refined.iter().map(|t| 0.5 * (1.0 + t) * length).collect();
        if self.starts_closed {
            arcs.insert(0, 0.0);
        }
        if !arcs.len().is_multiple_of(2) {
            arcs.push(length);
        }
        arcs
    }

    /// Moves nodes onto the ends until the pressure at all of them vanishes; `None` where that does not settle (two ends meet, an end leaves the
    /// surface, too many meshes).
    pub(super) fn position(&self, stage: Stage<'_>, level: Level, work: &mut Solution) -> Result<Option<Positioned>, Fault> {
        let tolerance = TOLERANCE * stage.accuracy();
        let start = Start { places: &self.refined, jacobian: self.jacobian.as_ref(), tolerance, share: SHARE };
        let mut meshes = 0;
        let found = position_nodes(start, |places| -> Result<_, Option<Fault>> {
            let ascending = places.windows(2).all(|pair| pair[0] < pair[1]);
            meshes += 1;
            if !(meshes <= MOST && ascending && places.iter().all(|t| t.abs() < 1.0 - 1e-6)) {
                return Err(None);
            }
            let reduced = Arc::new(Reduced::new(&stage.parts(level, Cut::Ends(places), work)?, work)?);
            work.counters.factorisations += 2;
            work.counters.contact_solves += 1;
            let pair = reduced.pair()?;
            let operator = reduced.operator(&pair, stage.friction() > 0.0)?;
            let (start, length) = (stage.start(&pair), pair.trace().length());
            let gap: Vec<f64> = operator.points().iter().map(|p| gap_at(stage, start + p.arc)).collect();
            let arcs: Vec<f64> = places.iter().map(|t| 0.5 * (1.0 + t) * length).collect();
            let (nodes, closed) = held_between(operator.points(), &arcs, self.starts_closed);
            let load = stage.contact_load(operator.points());
            let held = operator.solve_on(&gap, &load, &closed).map_err(unsolved)?.ok_or(None)?;
            // The root of the node's share of the surface takes away how the pressure of a sharp end grows with the level.
            let scaled = |n: &usize| held.pressure[*n] * operator.points()[*n].weight.sqrt();
            Ok((nodes.iter().map(scaled).collect(), (Arc::clone(&reduced), held)))
        });
        match found {
            Ok(nodes) if nodes.found => {
                let (reduced, held) = nodes.last;
                let (places, refined, jacobian) = (nodes.places, nodes.refined, Some(nodes.jacobian));
                let ends = FreeEnds { places, refined, jacobian, starts_closed: self.starts_closed };
                Ok(Some(Positioned { ends, reduced, held }))
            }
            Ok(_) | Err(None) => Ok(None),
            Err(Some(fault)) => Err(fault),
        }
    }
}
