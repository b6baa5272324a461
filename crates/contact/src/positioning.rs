//! Ends of contact as unknowns: an element node is moved onto each of them.
//!
//! With a node on the trial end `s` and every point up to it held in contact, the pressure at the end grows like an inverse square root where
//! the contact is too short and turns into tension where it is too long; the end of contact is the root of that nodal pressure.

use crate::error::Error;
use crate::load::ContactLoad;
use crate::operator::ContactOperator;
use crate::pair::Pair;
use crate::point::ContactPoint;
use crate::solution::ContactSolution;
use hpfem::InterfaceOperator;

/// Bodies with element nodes on the trial ends of contact.
pub struct Rebuilt {
    /// The shaped body.
    pub shaped: InterfaceOperator,
    /// The counter-face.
    pub counter: InterfaceOperator,
    /// Whether the surfaces face each other across a gap ([`Pair::facing`]) instead of lying on each other ([`Pair::new`]).
    pub facing: bool,
}

impl Rebuilt {
    /// The pair of the two bodies.
    ///
    /// # Errors
    /// [`Error::Unmatched`].
    pub fn pair(&self) -> Result<Pair<'_>, Error> {
        if self.facing { Pair::facing(&self.shaped, &self.counter) } else { Pair::new(&self.shaped, Some(&self.counter)) }
    }
}

/// Result of [`position_ends`].
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Positioned {
    /// Arc lengths of the ends of contact.
    pub ends: Vec<f64>,
    /// Whether all ends were found to the tolerance.
    pub found: bool,
    /// Solution on the last meshes.
    pub solution: ContactSolution,
    /// The contact points of the last meshes.
    pub points: Vec<ContactPoint>,
    /// Number of pairs of bodies made.
    pub factorisations: usize,
    /// Largest change of an end in each step.
    pub history: Vec<f64>,
}

/// What stays the same while nodes move.
pub struct Positioning<'a> {
    /// Gap as a function of the contact point; it is evaluated anew on every mesh.
    pub gap: &'a dyn Fn(&ContactPoint) -> f64,
    /// Load, with friction (if sliding) given at the points of each mesh.
    pub load: &'a dyn Fn(&[ContactPoint]) -> ContactLoad,
    /// Whether the start of the path is in contact.
    pub starts_closed: bool,
    /// Wanted accuracy of the ends, relative to the length of the contact.
    pub tolerance: f64,
}

/// Most meshes tried.
const LIMIT: usize = 40;

/// Meshes after the best one that show that the residuals fall no further.
const IDLE: usize = 8;

/// Step, relative to the size of the places, below which the best place counts as found where round-off lets no residual fall further: what it is
/// off by, the errors of the levels show.
const ROUND_OFF: f64 = 1e-6;

/// Places found by [`position_nodes`].
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Nodes<T> {
    /// The places of the last evaluation.
    pub places: Vec<f64>,
    /// Those places and the step that the last residuals still ask for: closer to the roots by as much as the Jacobian is right.
    pub refined: Vec<f64>,
    /// Whether that step is below the tolerance, or below a hundred times that and no longer falling; or, the smallest of many, lost in round-off.
    pub found: bool,
    /// What the last evaluation gave along with its residuals.
    pub last: T,
    /// Number of evaluations.
    pub evaluations: usize,
    /// Largest change of a place that was still asked for after each evaluation at a trial.
    pub history: Vec<f64>,
    /// Derivatives of the residuals by the places, residual by row, as Broyden's method left them.
    pub jacobian: nalgebra::DMatrix<f64>,
}

/// Places that may be anywhere.
pub const UNBOUNDED: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Where [`position_nodes`] starts and how far it goes.
#[derive(Clone, Copy, Debug)]
pub struct Start<'a> {
    /// Trial places, ascending.
    pub places: &'a [f64],
    /// Derivatives from an earlier search, say on a coarser mesh; without them they are found by differences, one evaluation a place.
    pub jacobian: Option<&'a nalgebra::DMatrix<f64>>,
    /// Whether a residual changes at its root with its own place alone, so that one evaluation gives all derivatives. Pressures at ends of contact do:
    /// what the place of one end changes elsewhere is its own pressure times a field, and that pressure vanishes (Rice, Int. J. Solids Struct. 8,
    /// 1972, 751-758, for cracks).
    pub apart: bool,
    /// Wanted accuracy, relative to the largest distance of a place from the others or from zero.
    pub tolerance: f64,
    /// A step that is this share of the first one will do as well: the places need be no better than the mesh. 0 asks for the tolerance.
    pub share: f64,
    /// Bounds that no place may pass, say the ends of the surface; infinite without any.
    pub within: [f64; 2],
}

impl Start<'_> {
    /// Distance of a place from the nearer bound.
    fn room(&self, place: f64) -> f64 {
        (place - self.within[0]).min(self.within[1] - place)
    }

    /// Moves the places by a step whose largest part is known; no place moves by more than a quarter of the distance to its neighbours (or to zero, for a
    /// single one), nor comes to a bound. The step becomes the one taken.
    fn step(&self, places: &mut [f64], step: &mut nalgebra::DVector<f64>, largest: f64) {
        let room = if places.len() == 1 { size(places) } else { narrowest(places) };
        if largest > 0.25 * room {
            *step *= 0.25 * room / largest;
        }
        for (place, step) in places.iter_mut().zip(step.iter_mut()) {
            let [least, most] = self.within.map(|bound| 0.75 * (bound - *place));
            *step = step.clamp(least, most);
            *place += *step;
        }
    }
}

/// Finds the places of nodes at which as many residuals vanish (pressure at an end of contact, shear less its limit at an end of stick), by
/// Broyden's method. It ends when the step that the last residuals ask for is small, and does not take it.
///
/// # Errors
/// Those of `evaluate`.
pub fn position_nodes<T, E>(
    start: Start<'_>,
    mut evaluate: impl FnMut(&[f64]) -> Result<(Vec<f64>, T), E>,
) -> Result<Nodes<T>, E> {
    let mut places = start.places.to_vec();
    let (mut value, last) = evaluate(&places)?;
    // What came with residuals may be large: there is one at a time.
    let mut last = Some(last);
    let mut evaluations = 1;
    let mut jacobian = match start.jacobian {
        Some(known) => known.clone(),
        None => {
            evaluations += if start.apart { 1 } else { places.len() };
            by_differences(&start, &value, &mut evaluate)?
        }
    };
    let first = jacobian.clone();
    let mut history: Vec<f64> = Vec::new();
    let mut best: Option<Tried> = None;
    loop {
        let residual = nalgebra::DVector::from_row_slice(&value);
        let step = jacobian.clone().lu().solve(&(-&residual));
        let largest = step.as_ref().map_or(f64::INFINITY, largest_of);
        // Round-off in the residuals may end the fall of the steps a little above the tolerance.
        let idle = history.last().is_some_and(|last| largest >= 0.5 * last);
        history.push(largest);
        let enough = (start.tolerance * size(&places) * if idle { 100.0 } else { 1.0 }).max(start.share * history[0]);
        if let Some(step) = step.as_ref().filter(|_| largest <= enough) {
            let refined = places.iter().zip(step.iter()).map(|(place, step)| place + step).collect();
            let Some(last) = last else { unreachable!("every evaluation leaves what came with it") };
            return Ok(Nodes { places, refined, found: true, last, evaluations, history, jacobian });
        }
        // Differences of residuals at places that are close together are round-off, and so are the steps they give: the first derivatives judge.
        let missed = first.clone().lu().solve(&residual).as_ref().map_or(f64::INFINITY, largest_of);
        if best.as_ref().is_none_or(|best| missed < best.missed) {
            best = Some(Tried { places: places.clone(), missed, number: history.len() });
        }
        let tried = best.as_ref().map_or(0, |best| best.number);
        let goes_on = history.len() <= LIMIT && history.len() < tried + IDLE && largest.is_finite();
        let (Some(mut step), true) = (step, goes_on) else {
            let Some(Tried { places, missed, .. }) = best else { unreachable!("the first places are the best until then") };
            let found = missed <= ROUND_OFF * size(&places);
            let known = last.filter(|_| tried == history.len());
            evaluations += usize::from(known.is_none());
            let last = known.map_or_else(|| evaluate(&places).map(|(_, given)| given), Ok)?;
            return Ok(Nodes { refined: places.clone(), places, found, last, evaluations, history, jacobian });
        };
        start.step(&mut places, &mut step, largest);
        drop(last.take());
        let (next, outcome) = evaluate(&places)?;
        evaluations += 1;
        let change = nalgebra::DVector::from_fn(places.len(), |i, _| next[i] - value[i]);
        let square = step.norm_squared();
        if square > 0.0 {
            jacobian += (change - &jacobian * &step) * step.transpose() / square;
        }
        (value, last) = (next, Some(outcome));
    }
}

/// Largest change of a place; infinite if one is no number.
fn largest_of(step: &nalgebra::DVector<f64>) -> f64 {
    step.iter().fold(0.0, |most: f64, s| if s.is_nan() { f64::INFINITY } else { most.max(s.abs()) })
}

/// Places that were tried.
struct Tried {
    places: Vec<f64>,
    /// Step that their residuals ask for by the first derivatives.
    missed: f64,
    /// Evaluations at trials until then.
    number: usize,
}

/// Derivatives of the residuals by the places, from differences over a thousandth of their extent, or a quarter of the way to a bound that is nearer:
/// each place by itself, or all at once where residuals are apart.
pub(crate) fn by_differences<T, E>(
    start: &Start<'_>,
    value: &[f64],
    evaluate: &mut impl FnMut(&[f64]) -> Result<(Vec<f64>, T), E>,
) -> Result<nalgebra::DMatrix<f64>, E> {
    let places = start.places;
    let step = |place: f64| (1e-3 * size(places)).min(0.25 * start.room(place));
    if start.apart {
        let moved: Vec<f64> = places.iter().map(|place| place + step(*place)).collect();
        let (next, _) = evaluate(&moved)?;
        let slope = |i: usize| (next[i] - value[i]) / step(places[i]);
        return Ok(nalgebra::DMatrix::from_diagonal(&nalgebra::DVector::from_fn(places.len(), |i, _| slope(i))));
    }
    let mut jacobian = nalgebra::DMatrix::zeros(places.len(), places.len());
    for j in 0..places.len() {
        let mut moved = places.to_vec();
        let step = step(places[j]);
        moved[j] += step;
        let (next, _) = evaluate(&moved)?;
        (0..places.len()).for_each(|i| jacobian[(i, j)] = (next[i] - value[i]) / step);
    }
    Ok(jacobian)
}

/// Distance of a single place from zero, or of the first from the last.
fn size(places: &[f64]) -> f64 {
    match places {
        [one] => one.abs(),
        _ => places.iter().fold(f64::MIN, |m, v| m.max(*v)) - places.iter().fold(f64::MAX, |m, v| m.min(*v)),
    }
}

/// Smallest distance between ascending places.
fn narrowest(places: &[f64]) -> f64 {
    places.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min)
}

/// Moves element nodes onto the ends of contact, from trial `ends` (ascending arc lengths at which contact changes).
/// `rebuild` makes the bodies with a node on each end. Without ends (full contact) it is called once and the answer is its plain solution.
///
/// # Errors
/// Those of the bodies (as given by `rebuild`) and of the contact solve.
pub fn position_ends<E: From<Error>>(
    problem: &Positioning<'_>,
    ends: &[f64],
    mut rebuild: impl FnMut(&[f64]) -> Result<Rebuilt, E>,
) -> Result<Positioned, E> {
    let start = Start { places: ends, jacobian: None, apart: true, tolerance: problem.tolerance, share: 0.0, within: UNBOUNDED };
    let nodes = position_nodes(start, |ends| -> Result<_, E> {
        let bodies = rebuild(ends)?;
        let (pressure, solution, points) = end_pressures(problem, &bodies, ends)?;
        Ok((pressure, (solution, points)))
    })?;
    let (solution, points) = nodes.last;
    Ok(Positioned {
        ends: nodes.refined,
        found: nodes.found,
        solution,
        points,
        factorisations: nodes.evaluations,
        history: nodes.history,
    })
}

/// Pressure at each end with the points between the ends held in contact; without ends the ordinary solution.
fn end_pressures(
    problem: &Positioning<'_>,
    bodies: &Rebuilt,
    ends: &[f64],
) -> Result<(Vec<f64>, ContactSolution, Vec<ContactPoint>), Error> {
    let pair = bodies.pair()?;
    let load = (problem.load)(&pair.points());
    let operator = ContactOperator::new(&pair, load.has_friction())?;
    let points = operator.points().to_vec();
    let gap: Vec<f64> = points.iter().map(problem.gap).collect();
    if ends.is_empty() {
        return Ok((Vec::new(), operator.solve(&gap, &load, None)?, points));
    }
    let (nodes, closed) = held_between(&points, ends, problem.starts_closed);
    let solution = operator.solve_on(&gap, &load, &closed)?.ok_or(Error::Singular)?;
    Ok((nodes.iter().map(|n| solution.pressure[*n]).collect(), solution, points))
}

/// The points nearest to the ends of contact (ascending arc lengths), and which points lie between them and so are in contact, the ends included.
pub fn held_between(points: &[ContactPoint], ends: &[f64], starts_closed: bool) -> (Vec<usize>, Vec<bool>) {
    let far = |i: usize, end: f64| (points[i].arc - end).abs();
    let nearest = |end: &f64| (0..points.len()).min_by(|i, j| far(*i, *end).total_cmp(&far(*j, *end))).unwrap_or(0);
    let nodes: Vec<usize> = ends.iter().map(nearest).collect();
    let inside = |i: usize| nodes.iter().filter(|n| **n < i).count().is_multiple_of(2) == starts_closed;
    let closed = (0..points.len()).map(|i| nodes.contains(&i) || inside(i)).collect();
    (nodes, closed)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn residuals_lost_in_round_off_end_at_the_best_place_and_not_at_the_last() {
        // A root at 0.7 under noise that no step can overcome, as of pressures in the smallest cells.
        let mut state = 1_u64;
        let mut calls = 0;
        let mut noise = move || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            2.0 * (state >> 11) as f64 / (1_u64 << 53) as f64 - 1.0
        };
        let start = Start { places: &[0.71], jacobian: None, apart: false, tolerance: 1e-10, share: 0.0, within: UNBOUNDED };
        let found = position_nodes(start, |places| -> Result<_, ()> {
            calls += 1;
            Ok((vec![-1e7 * (places[0] - 0.7) + 0.5 * noise()], places.to_vec()))
        });
        let nodes = found.expect("nothing fails");
        assert!(nodes.found && (nodes.refined[0] - 0.7).abs() < 1e-6, "{:?} after {calls}", nodes.refined);
        assert!(calls <= 20, "{calls} meshes");
        assert_eq!(nodes.places, nodes.last);
    }

    /// Between a free end and one next to the end of the surface, beyond which there is no mesh.
    #[test]
    fn a_place_next_to_a_bound_is_found_without_passing_it() {
        let start =
            Start { places: &[-0.2, 0.9995], jacobian: None, apart: true, tolerance: 1e-9, share: 0.0, within: [-1.0, 1.0] };
        let found = position_nodes(start, |places| {
            let inside = places.iter().all(|place| place.abs() < 1.0);
            if inside { Ok((vec![places[0] + 0.25, (1.0 - places[1]).ln() - 1e-4_f64.ln()], ())) } else { Err(places.to_vec()) }
        });
        let nodes = found.expect("no place passes the bound");
        assert!(nodes.found && (nodes.refined[1] - 0.9999).abs() < 1e-8, "{:?}", nodes.refined);
    }

    /// Like the pressures at many ends of contact: each changes with the places of the others by its share of what is left.
    #[test]
    fn one_evaluation_gives_the_derivatives_of_many_places_whose_residuals_are_apart() {
        let roots: Vec<f64> = (0..24).map(|i| 0.08 * f64::from(i) - 0.9).collect();
        let places: Vec<f64> = roots.iter().map(|root| root + 1e-3 * (40.0 * root).sin()).collect();
        let pressures = |places: &[f64]| -> Vec<f64> {
            let off: Vec<f64> = places.iter().zip(&roots).map(|(place, root)| place - root).collect();
            let others: f64 = off.iter().map(|off| off * off).sum();
            (0..off.len()).map(|i| (2.0 + f64::from(i as u32)) * off[i] + off[i].powi(2) + 5.0 * others).collect()
        };
        let start = Start { places: &places, jacobian: None, apart: true, tolerance: 1e-8, share: 0.0, within: [-1.0, 1.0] };
        let nodes = position_nodes(start, |places| -> Result<_, ()> { Ok((pressures(places), ())) }).expect("nothing fails");
        let off = nodes.refined.iter().zip(&roots).fold(0.0, |most: f64, (place, root)| most.max((place - root).abs()));
        assert!(nodes.found && off < 1e-8, "{off}");
        assert!(nodes.evaluations < 8, "{}", nodes.evaluations);
    }
}
