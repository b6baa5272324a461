//! Ends of contact inside the surface: element nodes are moved onto all of them, in both bodies. Contact that fills its surface never comes here.

use std::sync::Arc;

use contact::{ContactSolution, Start, Status, held_between, position_nodes};
use meshing::Cut;
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::level::Level;
use crate::stage::Stage;
use crate::steps::start_gap::gap_at;

/// Accuracy of the nodes by the accuracy asked for: a misplaced end changes the pressure by about its distance over the length of the contact.
/// The ends themselves are reported closer, with the step that their pressures still ask for.
const TOLERANCE: f64 = 0.03;

/// What an end moves from one level to the next, of what it moved to that one: the search starts that much further.
const GOES_ON: f64 = 0.15;

/// A level moves its nodes until the step left is this share of its first one, that is of what the level before it still lacked.
const SHARE: f64 = 0.05;

/// Share of the surface below which a gap or a zone is none.
const TINY: f64 = 1e-6;

/// Meshes of a level after which its ends are held not to settle.
const MOST: usize = 16;
/// Samples of the pressure for the comparison of levels, over the inner 95 % of the contact.
const SAMPLES: usize = 191;

/// Ends of contact inside the surface.
#[derive(Clone, Debug, Default)]
pub(crate) struct FreeEnds {
    /// Where the nodes are, from -1 to 1 on the surface, ascending.
    pub places: Vec<f64>,
    /// Where contact ends: the places and the step that their pressures still ask for.
    refined: Vec<f64>,
    /// The same on the level before, if there was one.
    before: Option<Vec<f64>>,
    /// How the pressures at the ends change with their places, from the level before.
    jacobian: Option<nalgebra::DMatrix<f64>>,
    /// Whether the start of the surface is in contact.
    pub starts_closed: bool,
}

/// Bodies with element nodes on the ends of contact, and the solution with the points between the ends held in contact.
pub(crate) struct Positioned {
    pub ends: FreeEnds,
    pub reduced: Arc<Reduced>,
    pub held: ContactSolution,
}

impl FreeEnds {
    /// The ends of a solution's contact zones that lie inside a surface of the given length; none where there is no partial contact.
    pub(crate) fn of(solution: &ContactSolution, length: f64) -> FreeEnds {
        if solution.status != Status::Converged {
            return FreeEnds::default();
        }
        let inside = |arc: &f64| *arc > 1e-9 * length && *arc < (1.0 - 1e-9) * length;
        let zones = zones(solution, length);
        if zones.len() < solution.zones.len() {
            return FreeEnds::default();
        }
        let places: Vec<f64> = zones.iter().flatten().copied().filter(inside).map(|arc| 2.0 * arc / length - 1.0).collect();
        FreeEnds {
            refined: places.clone(),
            places,
            before: None,
            jacobian: None,
            starts_closed: zones.first().is_some_and(|zone| !inside(&zone[0])),
        }
    }

    /// All ends of contact as arc lengths, those of the surface included.
    pub(crate) fn arcs(&self, length: f64) -> Vec<f64> {
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
    pub(crate) fn position(&self, stage: Stage<'_>, level: Level, work: &mut Effort) -> Result<Option<Positioned>, Fault> {
        let tolerance = TOLERANCE * stage.accuracy();
        let places: Vec<f64> = match &self.before {
            Some(before) => self.refined.iter().zip(before).map(|(now, before)| now + GOES_ON * (now - before)).collect(),
            None => self.refined.clone(),
        };
        let start = Start { places: &places, jacobian: self.jacobian.as_ref(), tolerance, share: SHARE };
        let mut meshes = 0;
        let found = position_nodes(start, |places| -> Result<_, Option<Fault>> {
            let ascending = places.windows(2).all(|pair| pair[0] < pair[1]);
            meshes += 1;
            if !(meshes <= MOST && ascending && places.iter().all(|t| t.abs() < 1.0 - 1e-6)) {
                return Err(None);
            }
            // Cells that cannot be cut there are no fault of the user's: they serve on the standing mesh.
            let (parts, effort) = stage.parts(level, Cut::Ends(places)).map_err(|_| None)?;
            let (reduced, reduction) = Reduced::new(&parts, stage.clock())?;
            let reduced = Arc::new(reduced);
            *work += effort;
            *work += reduction;
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
                // The first search starts from a mesh that knows no ends.
                let before = self.jacobian.is_some().then(|| self.refined.clone());
                let ends = FreeEnds { places, refined, before, jacobian, starts_closed: self.starts_closed };
                Ok(Some(Positioned { ends, reduced, held }))
            }
            Ok(_) | Err(None) => Ok(None),
            Err(Some(fault)) => Err(fault),
        }
    }
}

/// The contact zones of a solution on a surface of the given length; gaps and zones shorter than a millionth of it are left out, which only
/// layers around an edge too sharp for them show.
pub(crate) fn zones(solution: &ContactSolution, length: f64) -> Vec<[f64; 2]> {
    let near = TINY * length;
    let mut zones: Vec<[f64; 2]> = Vec::new();
    for [from, to] in &solution.zones {
        match zones.last_mut() {
            Some(last) if from - last[1] < near => last[1] = *to,
            _ => zones.push([*from, *to]),
        }
    }
    zones.retain(|[from, to]| to - from >= near);
    zones
}

/// Ends of contact taken two by two.
pub(crate) fn pairs(arcs: &[f64]) -> Vec<[f64; 2]> {
    arcs.chunks_exact(2).map(|zone| [zone[0], zone[1]]).collect()
}

/// Evenly spaced places on the inner 95 %: without a fortieth of the surface at its ends, or of the contact where that ends before.
pub(crate) fn inner(zones: &[[f64; 2]], length: f64) -> Vec<f64> {
    let (from, to) = (zones.first().map_or(0.0, |zone| zone[0]), zones.last().map_or(0.0, |zone| zone[1]));
    let (low, high) = ((from + 0.025 * (to - from)).max(0.025 * length), (to - 0.025 * (to - from)).min(0.975 * length));
    (0..SAMPLES).map(|i| low + (high - low) * i as f64 / (SAMPLES - 1) as f64).collect()
}
