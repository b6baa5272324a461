//! Ends of contact inside the surface, followed from level to level of discretisation: element nodes are moved onto all of them.

use crate::positioning::{Start, by_differences, position_nodes};
use crate::solution::ContactSolution;
use crate::status::Status;
use crate::zones::without_slivers;
use nalgebra::DMatrix;

/// What an end moves from one level to the next, of what it moved to that one: the search starts that much further.
const GOES_ON: f64 = 0.15;

/// A level moves its nodes until the step left is this share of its first one, that is of what the level before it still lacked.
const SHARE: f64 = 0.05;

/// Meshes of a level after which its ends are held not to settle.
const MOST: usize = 16;

/// Ends of contact inside the surface; none where contact fills it.
#[derive(Clone, Debug, Default)]
pub struct FreeEnds {
    /// Where the nodes are, from -1 to 1 on the surface, ascending.
    pub places: Vec<f64>,
    /// Where contact ends: the places and the step that their pressures still ask for.
    refined: Vec<f64>,
    /// The same on the level before, if there was one.
    before: Option<Vec<f64>>,
    /// How the pressures at the ends change with their places, from the level before.
    jacobian: Option<DMatrix<f64>>,
    /// Whether the start of the surface is in contact.
    pub starts_closed: bool,
}

impl FreeEnds {
    /// The ends of a solution's contact zones that lie inside a surface of the given length; none where there is no partial contact.
    pub fn of(solution: &ContactSolution, length: f64) -> FreeEnds {
        if solution.status != Status::Converged {
            return FreeEnds::default();
        }
        let inside = |arc: &f64| *arc > 1e-9 * length && *arc < (1.0 - 1e-9) * length;
        let zones = without_slivers(&solution.zones, length);
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

    /// Whether there are as many of them as of a solution's contact zones, inside a surface of the given length.
    pub fn bound_as_many(&self, solution: &ContactSolution, length: f64) -> bool {
        let of = FreeEnds::of(solution, length);
        of.places.len() == self.places.len() && of.starts_closed == self.starts_closed
    }

    /// Whether others are as many, with contact on the same sides of them, and no place differs by more than `within` (1 is half the surface).
    pub fn is_alike(&self, other: &FreeEnds, within: f64) -> bool {
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= within;
        self.starts_closed == other.starts_closed
            && self.places.len() == other.places.len()
            && self.places.iter().zip(&other.places).all(near)
    }

    /// Part of the surface that is in contact between these ends and open between others, or the other way round.
    pub fn apart(&self, others: &FreeEnds) -> f64 {
        let both = [self.zones(1.0), others.zones(1.0)];
        let mut arcs: Vec<f64> = both.iter().flatten().flatten().copied().collect();
        arcs.sort_unstable_by(f64::total_cmp);
        let closed = |zones: &[[f64; 2]], arc: f64| zones.iter().any(|[from, to]| *from < arc && arc < *to);
        let differs = |pair: &[f64]| closed(&both[0], 0.5 * (pair[0] + pair[1])) != closed(&both[1], 0.5 * (pair[0] + pair[1]));
        arcs.windows(2).filter(|pair| differs(pair)).map(|pair| pair[1] - pair[0]).sum()
    }

    /// Trial ends from -1 to 1 on the surface, ascending, of a contact that leaves both ends of the surface open.
    pub fn near(places: Vec<f64>) -> FreeEnds {
        FreeEnds { refined: places.clone(), places, before: None, jacobian: None, starts_closed: false }
    }

    /// Trial ends that go on from others of as many: further by a factor on what these have moved since; these where that leaves the surface or their order.
    pub fn ahead(&self, before: &FreeEnds, factor: f64) -> FreeEnds {
        let moved = self.refined.iter().zip(&before.refined).map(|(now, before)| now + factor * (now - before));
        let places: Vec<f64> = moved.collect();
        let fits = places.len() == self.refined.len()
            && places.windows(2).all(|pair| pair[0] < pair[1])
            && places.iter().all(|t| t.abs() < 1.0);
        let places = if fits { places } else { self.refined.clone() };
        FreeEnds {
            refined: places.clone(),
            places,
            before: None,
            jacobian: self.jacobian.clone(),
            starts_closed: self.starts_closed,
        }
    }

    /// The ends by the same measure as [`FreeEnds::places`]: these and the step that their pressures still ask for.
    pub fn refined(&self) -> &[f64] {
        &self.refined
    }

    /// Derivative of the pressure at a node, in the scale that [`FreeEnds::position`] was given it, by the place of the node (from -1 to 1 on the surface),
    /// as the last search left it; `None` before ends were found, or for an end that there is not.
    pub fn slope(&self, end: usize) -> Option<f64> {
        self.jacobian.as_ref().and_then(|jacobian| jacobian.get((end, end))).copied()
    }

    /// Whether an odd number of branches lies between this contact and one that is unique: with the pressures `p_i` at the ends and their places `s_j`,
    /// `det(d p_i / d s_j)` of a unique contact has the sign of the product of all `d p_i / d s_i` of ends for themselves, positive where contact
    /// begins and negative where it ends, and the sign changes where contacts branch. Frictional heat that crosses the contact makes them branch,
    /// for the places of the ends change it. `held` is that of [`FreeEnds::position`]; it is asked only where the derivatives that the last search
    /// left have the other sign. `false` without ends, before a search, or where `held` makes no bodies.
    ///
    /// # Errors
    /// Those of `held`.
    pub fn branched<T, E>(&self, mut held: impl FnMut(&[f64]) -> Result<Option<(Vec<f64>, T)>, E>) -> Result<bool, E> {
        if !self.jacobian.as_ref().is_some_and(|jacobian| self.turned(jacobian)) {
            return Ok(false);
        }
        let mut pressures = |places: &[f64]| held(places).map_err(Some)?.ok_or(None);
        let start = Start { places: &self.places, jacobian: None, apart: false, tolerance: 0.0, share: 0.0, within: [-1.0, 1.0] };
        let jacobian = pressures(&self.places).and_then(|(here, _)| by_differences(&start, &here, &mut pressures));
        match jacobian {
            Ok(jacobian) => Ok(self.turned(&jacobian)),
            Err(None) => Ok(false),
            Err(Some(error)) => Err(error),
        }
    }

    /// Whether derivatives have a determinant of the other sign than those of ends for themselves: pressure rises at an end that leaves more open.
    fn turned(&self, jacobian: &DMatrix<f64>) -> bool {
        let closes = |end: usize| end.is_multiple_of(2) == self.starts_closed;
        let alone: f64 = (0..self.places.len()).map(|end| if closes(end) { -1.0 } else { 1.0 }).product();
        jacobian.clone().lu().determinant() * alone < 0.0
    }

    /// All ends of contact as arc lengths on a surface of the given length, its own ends included where they are in contact.
    pub fn arcs(&self, length: f64) -> Vec<f64> {
        let mut arcs: Vec<f64> = self.refined.iter().map(|t| 0.5 * (1.0 + t) * length).collect();
        if self.starts_closed {
            arcs.insert(0, 0.0);
        }
        if !arcs.len().is_multiple_of(2) {
            arcs.push(length);
        }
        arcs
    }

    /// The zones of contact between these ends, as arc lengths.
    pub fn zones(&self, length: f64) -> Vec<[f64; 2]> {
        self.arcs(length).chunks_exact(2).map(|zone| [zone[0], zone[1]]).collect()
    }

    /// Moves nodes onto the ends until the pressure at all of them vanishes, to a tolerance relative to the extent of the places. `held` makes bodies
    /// with nodes at the given places, solves with the points between them held in contact, and returns the pressures at the nodes (each
    /// in a scale of its own) with whatever is wanted of the last ones; `None` where no bodies can be made.
    ///
    /// Returns `None` where the ends do not settle: two of them meet, one leaves the surface, too many meshes.
    ///
    /// # Errors
    /// Those of `held`.
    pub fn position<T, E>(
        &self,
        tolerance: f64,
        mut held: impl FnMut(&[f64]) -> Result<Option<(Vec<f64>, T)>, E>,
    ) -> Result<Option<(FreeEnds, T)>, E> {
        let places: Vec<f64> = match &self.before {
            Some(before) => self.refined.iter().zip(before).map(|(now, before)| now + GOES_ON * (now - before)).collect(),
            None => self.refined.clone(),
        };
        if places.is_empty() {
            return Ok(None);
        }
        let jacobian = self.jacobian.as_ref();
        let start = Start { places: &places, jacobian, apart: true, tolerance, share: SHARE, within: [-1.0, 1.0] };
        let mut tried: Vec<Vec<f64>> = Vec::new();
        let found = position_nodes(start, |places| -> Result<_, Option<E>> {
            let ascending = places.windows(2).all(|pair| pair[0] < pair[1]);
            if !tried.iter().any(|before| before == places) {
                tried.push(places.to_vec());
            }
            if !(tried.len() <= MOST && ascending && places.iter().all(|t| t.abs() < 1.0 - 1e-6)) {
                return Err(None);
            }
            held(places)?.ok_or(None)
        });
        match found {
            Ok(nodes) if nodes.found => {
                let (places, refined, jacobian) = (nodes.places, nodes.refined, Some(nodes.jacobian));
                // The first search starts from a mesh that knows no ends.
                let before = self.jacobian.is_some().then(|| self.refined.clone());
                Ok(Some((FreeEnds { places, refined, before, jacobian, starts_closed: self.starts_closed }, nodes.last)))
            }
            Ok(_) | Err(None) => Ok(None),
            Err(Some(error)) => Err(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{DMatrix, FreeEnds};

    fn at(places: &[f64], starts_closed: bool) -> FreeEnds {
        FreeEnds { places: places.to_vec(), refined: places.to_vec(), starts_closed, ..FreeEnds::default() }
    }

    #[test]
    fn zones_between_free_ends_reach_the_ends_of_the_surface_where_these_are_closed() {
        assert_eq!(at(&[-0.5, 0.5], false).zones(8.0), [[2.0, 6.0]]);
        assert_eq!(at(&[-0.5, 0.5], true).zones(8.0), [[0.0, 2.0], [6.0, 8.0]]);
        assert_eq!(at(&[0.5], true).zones(8.0), [[0.0, 6.0]]);
        assert_eq!(at(&[0.5], false).zones(8.0), [[6.0, 8.0]]);
    }

    #[test]
    fn ends_differ_by_what_is_in_contact_between_one_of_both() {
        let middle = at(&[-0.5, 0.5], false);
        assert_eq!(middle.apart(&middle), 0.0);
        assert_eq!(middle.apart(&at(&[-0.25, 0.75], false)), 0.25);
        assert_eq!(middle.apart(&at(&[-0.5, 0.5], true)), 1.0);
        assert_eq!(middle.apart(&at(&[-0.5, -0.25, 0.0, 0.5], false)), 0.125);
        assert_eq!(at(&[0.5], true).apart(&at(&[-0.5], false)), 0.5);
    }

    #[test]
    fn ends_go_on_from_others_by_what_they_have_moved() {
        let now = at(&[-0.5, 0.5], false);
        assert_eq!(now.ahead(&at(&[-0.75, 0.5], false), 2.0).places, [0.0, 0.5]);
        // Not past one another, nor off the surface.
        assert_eq!(now.ahead(&at(&[-0.75, 0.5], false), 5.0).places, now.places);
        assert_eq!(now.ahead(&at(&[-0.25, 0.5], false), 4.0).places, now.places);
    }

    /// The pressures at two ends whose distances from 0.3 and 0.7 they are, some of each in the other.
    fn pressures(places: &[f64]) -> Vec<f64> {
        let off = [places[0] - 0.3, places[1] - 0.7];
        vec![2.0 * off[0] + 0.1 * off[1] + off[0] * off[0], off[1] - 0.2 * off[0]]
    }

    #[test]
    fn nodes_move_onto_the_ends_and_a_second_search_goes_on_from_them() {
        let mut meshes = 0;
        let mut search = |ends: &FreeEnds| {
            let found = ends.position(1e-8, |places| -> Result<_, ()> {
                meshes += 1;
                Ok(Some((pressures(places), places.to_vec())))
            });
            found.ok().flatten().expect("the ends settle")
        };
        let (first, last) = search(&at(&[0.25, 0.75], false));
        assert_eq!(first.places, last);
        let (second, _) = search(&first);
        assert!((second.arcs(2.0)[0] - 1.3).abs() < 1e-6 && (second.arcs(2.0)[1] - 1.7).abs() < 1e-6);
        assert!(meshes < 16);
    }

    /// Two ends, of which each moves the pressure at the other by so much of what it moves its own.
    #[test]
    fn a_contact_beyond_a_branch_is_told_by_ends_that_move_each_other_more_than_themselves() {
        for (coupling, starts_closed) in [(0.5, false), (2.0, false), (0.5, true), (2.0, true)] {
            let sign = if starts_closed { -1.0 } else { 1.0 };
            let pressures = |places: &[f64]| {
                let off = [places[0] - 0.3, places[1] - 0.7];
                vec![sign * (off[0] - coupling * off[1]), -sign * (off[1] - coupling * off[0])]
            };
            let before = FreeEnds { jacobian: Some(derivatives(coupling, sign)), ..at(&[0.3, 0.7], starts_closed) };
            let mut asked = 0;
            let branched = before.branched(|places| -> Result<_, ()> {
                asked += 1;
                Ok(Some((pressures(places), ())))
            });
            assert_eq!(
                (branched, asked),
                if coupling > 1.0 { (Ok(true), 3) } else { (Ok(false), 0) },
                "{coupling} {starts_closed}"
            );
            // Derivatives of a search that has gone astray are not believed.
            let astray = FreeEnds { jacobian: Some(derivatives(3.0, sign)), ..before.clone() };
            let asked = astray.branched(|places| -> Result<_, ()> { Ok(Some((pressures(places), ()))) });
            assert_eq!(asked, Ok(coupling > 1.0), "{coupling} {starts_closed}");
        }
        assert_eq!(at(&[0.3, 0.7], false).branched(|_| -> Result<Option<(Vec<f64>, ())>, i32> { Err(3) }), Ok(false));
    }

    fn derivatives(coupling: f64, sign: f64) -> DMatrix<f64> {
        DMatrix::from_row_slice(2, 2, &[sign, -sign * coupling, sign * coupling, -sign])
    }

    #[test]
    fn ends_that_meet_or_cannot_be_meshed_do_not_settle() {
        let apart = at(&[0.25, 0.75], false);
        let crossed = at(&[0.75, 0.25], false);
        assert!(matches!(crossed.position(1e-8, |places| -> Result<_, ()> { Ok(Some((pressures(places), ()))) }), Ok(None)));
        assert!(matches!(apart.position(1e-8, |_| -> Result<Option<(Vec<f64>, ())>, ()> { Ok(None) }), Ok(None)));
        assert_eq!(apart.position(1e-8, |_| -> Result<Option<(Vec<f64>, ())>, i32> { Err(3) }).err(), Some(3));
    }
}
