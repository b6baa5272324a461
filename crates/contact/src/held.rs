//! Contact on a given set of points: unit forces stand at these alone, and what the others open by follows from the bodies.

use crate::coulomb::ContactState;
use crate::ending::Ending;
use crate::error::Error;
use crate::lcp::{Point, worst_sign};
use crate::load::{ContactLoad, Friction};
use crate::operator::{ContactOperator, SIGNS};
use crate::plain::{Plain, Unloaded};
use crate::products::{add, times};
use crate::solution::ContactSolution;
use crate::stage::{Acting, Stage};
use crate::status::Status;

impl ContactOperator<'_> {
    /// Solves with a given set of points in contact and no conditions on signs: pressures may come out negative. Node positioning uses it. The bodies
    /// are solved for unit forces at these points alone.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn solve_on(&self, gap: &[f64], load: &ContactLoad, closed: &[bool]) -> Result<Option<ContactSolution>, Error> {
        let n = self.unit.points.len();
        let at: Vec<usize> = (0..n).filter(|i| closed[*i]).collect();
        if at.len() == n {
            let stage = self.stage(gap, load)?;
            let answer = stage.plain.problem.solve_on(closed);
            return Ok(answer.map(|answer| self.assemble(&stage, stage.plain.ending(answer, Status::Converged))));
        }
        let Acting { unloaded, held, factors, prescribed } = self.acting(gap, load)?;
        let matrices = self.unit.matrices_at(&at);
        let pick = |values: &[f64]| at.iter().map(|i| values[*i]).collect::<Vec<f64>>();
        let there = Unloaded { opening: pick(&unloaded.opening), slip: pick(&unloaded.slip), forces: unloaded.forces.clone() };
        let mut plain = Plain::new(&matrices, &load.friction.at(&at, n)?, there, &held)?;
        if let Some(followed) = self.followed(load)? {
            plain.follow(&followed.at(&at), &held.free);
        }
        let Some(answer) = plain.problem.solve_on(&vec![true; at.len()]) else { return Ok(None) };
        let ending = spread(plain.ending(answer, Status::Converged), &at, n);
        let stage = Stage { plain, factors, prescribed, free: held.free, following: load.following.clone() };
        let mut solution = self.assemble(&stage, ending);
        solution.opening = self.openings(gap, &solution);
        let mut stiff = unloaded.opening;
        let coordinates: Vec<f64> = solution.coordinates.iter().flatten().copied().collect();
        let moving: Vec<f64> =
            (0..coordinates.len()).map(|j| if stage.free.contains(&j) { coordinates[j] } else { 0.0 }).collect();
        add(&mut stiff, &times(&self.unit.influence, &moving));
        let elastic: Vec<f64> = solution.opening.iter().zip(&stiff).map(|(all, stiff)| all - stiff).collect();
        solution.complementarity = worst_sign(&solution.nodal_force, &solution.opening, &elastic);
        Ok(Some(solution))
    }

    /// Opening at all points, from the states of the bodies.
    fn openings(&self, gap: &[f64], solution: &ContactSolution) -> Vec<f64> {
        let mut opening = gap.to_vec();
        let states = [Some(&solution.shaped), solution.counter.as_ref()];
        for (b, (response, state)) in self.unit.responses.iter().zip(states.into_iter().flatten()).enumerate() {
            let displaced = response.normal.times(&state.unknowns);
            (0..gap.len()).for_each(|i| opening[i] += SIGNS[b] * (displaced[i] + response.constant[0][i]));
        }
        opening
    }
}

impl Friction {
    /// The same at some of so many points.
    fn at(&self, at: &[usize], points: usize) -> Result<Friction, Error> {
        let given = |values: &[f64], coefficient: f64| {
            if values.len() != points {
                return Err(Error::Drag { coefficient, given: values.len(), points });
            }
            Ok(at.iter().map(|i| values[*i]).collect::<Vec<f64>>())
        };
        Ok(match self {
            Friction::None => Friction::None,
            Friction::Sliding { coefficient, drag } => {
                Friction::Sliding { coefficient: *coefficient, drag: given(drag, *coefficient)? }
            }
            Friction::Coulomb { coefficient, slip_before } => {
                Friction::Coulomb { coefficient: *coefficient, slip_before: given(slip_before, *coefficient)? }
            }
        })
    }
}

/// The ending of a solve at some of so many points, the others open without a force.
fn spread(ending: Ending, at: &[usize], points: usize) -> Ending {
    let all = |values: &[f64]| {
        let mut all = vec![0.0; points];
        at.iter().zip(values).for_each(|(i, value)| all[*i] = *value);
        all
    };
    let mut states = vec![ContactState::Open; points];
    at.iter().zip(&ending.states).for_each(|(i, state)| states[*i] = *state);
    Ending {
        states,
        point: Point { force: all(&ending.point.force), coordinates: ending.point.coordinates },
        shear: all(&ending.shear),
        opening: all(&ending.opening),
        ..ending
    }
}
