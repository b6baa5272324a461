//! Ends of contact as unknowns: an element node is moved onto each of them.
//!
//! With a node on the trial end `s` and every point up to it held in contact, the pressure at the end grows like an inverse square root where
//! the contact is too short and turns into tension where it is too long; the end of contact is the root of that nodal pressure.

use crate::error::Error;
use crate::load::ContactLoad;
use crate::operator::ContactOperator;
use crate::pair::{ContactPoint, Pair};
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
    /// [`Error::Unmatched`], [`Error::EdgeCount`].
    pub fn pair(&self) -> Result<Pair<'_>, Error> {
        if self.facing { Pair::facing(&self.shaped, &self.counter) } else { Pair::new(&self.shaped, Some(&self.counter)) }
    }
}

/// Result of [`position_ends`].
#[derive(Clone, Debug)]
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

/// Moves element nodes onto the ends of contact by Broyden's method, from trial `ends` (ascending arc lengths at which contact changes).
/// `rebuild` makes the bodies with a node on each end. Without ends (full contact) it is called once and the answer is its plain solution.
///
/// # Errors
/// Those of the bodies (as given by `rebuild`) and of the contact solve.
pub fn position_ends<E: From<Error>>(
    problem: &Positioning<'_>,
    ends: &[f64],
    mut rebuild: impl FnMut(&[f64]) -> Result<Rebuilt, E>,
) -> Result<Positioned, E> {
    let k = ends.len();
    let mut made = 0;
    let mut trial = |ends: &[f64]| -> Result<(Vec<f64>, ContactSolution, Vec<ContactPoint>), E> {
        made += 1;
        let bodies = rebuild(ends)?;
        Ok(end_pressures(problem, &bodies, ends)?)
    };
    let mut at = ends.to_vec();
    let (mut value, mut solution, mut points) = trial(&at)?;
    let size = |ends: &[f64]| ends.last().map_or(0.0, |e| e - if k > 1 { ends[0] } else { 0.0 });
    // Jacobian by differences, then Broyden's updates.
    let mut jacobian = nalgebra::DMatrix::zeros(k, k);
    for j in 0..k {
        let mut moved = at.clone();
        let step = 1e-3 * size(&at);
        moved[j] += step;
        let (next, ..) = trial(&moved)?;
        (0..k).for_each(|i| jacobian[(i, j)] = (next[i] - value[i]) / step);
    }
    let mut history = Vec::new();
    let mut found = k == 0;
    for _ in 0..LIMIT {
        let residual = nalgebra::DVector::from_row_slice(&value);
        let Some(mut step) = jacobian.clone().lu().solve(&(-residual)) else { break };
        if found || k == 0 {
            break;
        }
        let largest = step.amax() / size(&at);
        if largest > 0.25 {
            step *= 0.25 / largest;
        }
        at.iter_mut().zip(step.iter()).for_each(|(a, s)| *a += s);
        let (next, next_solution, next_points) = trial(&at)?;
        let change = nalgebra::DVector::from_fn(k, |i, _| next[i] - value[i]);
        let square = step.norm_squared();
        if square > 0.0 {
            jacobian += (change - &jacobian * &step) * step.transpose() / square;
        }
        (value, solution, points) = (next, next_solution, next_points);
        history.push(step.amax());
        found = step.amax() <= problem.tolerance * size(&at);
    }
    Ok(Positioned { ends: at, found, solution, points, factorisations: made, history })
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
    let nearest = |end: f64| {
        (0..points.len()).min_by(|i, j| (points[*i].arc - end).abs().total_cmp(&(points[*j].arc - end).abs())).unwrap_or(0)
    };
    let nodes: Vec<usize> = ends.iter().map(|e| nearest(*e)).collect();
    let closed: Vec<bool> = (0..points.len())
        .map(|i| nodes.contains(&i) || ((nodes.iter().filter(|n| **n < i).count() % 2 == 0) == problem.starts_closed))
        .collect();
    let solution = operator.solve_on(&gap, &load, &closed)?.ok_or(Error::Singular)?;
    Ok((nodes.iter().map(|n| solution.pressure[*n]).collect(), solution, points))
}
