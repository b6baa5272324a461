//! Contact on a given set of points: unit forces stand at these alone, and what the others open by follows from the bodies.

use crate::coulomb::{ContactState, Outcome};
use crate::ending::Ending;
use crate::error::Error;
use crate::lcp::{Point, worst_sign};
use crate::load::{ContactLoad, Friction};
use crate::matrices::Matrices;
use crate::operator::{ContactOperator, SIGNS};
use crate::plain::{Plain, Unloaded};
use crate::products::{add, times};
use crate::solution::ContactSolution;
use crate::stage::{Acting, Stage};
use crate::status::Status;
use std::borrow::Cow;

/// Points held in contact, on a given operator: the compliance at these alone, for as many solves as are asked for.
pub struct HeldContact<'o, 'a> {
    operator: &'o ContactOperator<'a>,
    at: Vec<usize>,
    matrices: Cow<'o, Matrices>,
}

impl<'a> ContactOperator<'a> {
    /// Solves with a given set of points in contact and no conditions on signs: pressures may come out negative. Node positioning uses it. The bodies
    /// are solved for unit forces at these points alone. `None` where these cannot hold the bodies, or where they are not all points and the heat of each
    /// one's own force closes it further than that opens it ([`ContactSolution::closes_itself`]): what is held there is no start for a contact.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn solve_on(&self, gap: &[f64], load: &ContactLoad, closed: &[bool]) -> Result<Option<ContactSolution>, Error> {
        self.held_on(closed, matches!(load.friction, Friction::Coulomb { .. })).solve(gap, load)
    }

    /// Solves a step of Coulomb friction with given states of the points and no conditions on signs or friction limits; `None` if that is singular.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`]; the load's friction must be [`Friction::Coulomb`].
    pub fn solve_states(
        &self,
        gap: &[f64],
        load: &ContactLoad,
        states: &[ContactState],
    ) -> Result<Option<ContactSolution>, Error> {
        let closed: Vec<bool> = states.iter().map(|s| *s != ContactState::Open).collect();
        self.held_on(&closed, true).solve_states(gap, load, states)
    }

    /// Points held in contact, those `closed` (one a point, open where it says nothing), for [`HeldContact::solve`], and with the slip by shear (`stick`)
    /// for [`HeldContact::solve_states`] too. Makes the compliance at them, `points held x points held`, mm/N.
    pub fn held_on<'o>(&'o self, closed: &[bool], stick: bool) -> HeldContact<'o, 'a> {
        let n = self.unit.points.len();
        let at: Vec<usize> = (0..n).filter(|i| closed.get(*i) == Some(&true)).collect();
        let matrices = match at.len() {
            all if all == n => Cow::Borrowed(self.unit.matrices(stick)),
            _ => Cow::Owned(self.unit.matrices_at(&at, stick)),
        };
        HeldContact { operator: self, at, matrices }
    }
}

impl HeldContact<'_, '_> {
    /// Solves as [`ContactOperator::solve_on`] on these points.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn solve(&self, gap: &[f64], load: &ContactLoad) -> Result<Option<ContactSolution>, Error> {
        let (stage, opening) = self.stage(gap, load)?;
        let (problem, all) = (&stage.plain.problem, self.at.len() == gap.len());
        let answer = problem.solve_on(&vec![true; self.at.len()]).filter(|_| all || !problem.closes_itself());
        let Some(answer) = answer else { return Ok(None) };
        let ending = stage.plain.ending(answer, Status::Converged);
        Ok(Some(self.assemble(&stage, ending, (gap, opening))))
    }

    /// Solves as [`ContactOperator::solve_states`], these points being the ones that are not open.
    ///
    /// # Errors
    /// As [`ContactOperator::solve_states`]; [`Error::Gap`] for states of another number of points, [`Error::ShearNotPrepared`] without `stick`.
    pub fn solve_states(
        &self,
        gap: &[f64],
        load: &ContactLoad,
        states: &[ContactState],
    ) -> Result<Option<ContactSolution>, Error> {
        if states.len() != gap.len() {
            return Err(Error::Gap { given: states.len(), points: gap.len() });
        }
        let (stage, opening) = self.stage(gap, load)?;
        let Friction::Coulomb { coefficient, slip_before } = &load.friction else { return Err(Error::ShearNotPrepared) };
        let pick = |values: &[f64]| self.at.iter().map(|i| values[*i]).collect::<Vec<f64>>();
        let coulomb = stage.plain.coulomb(*coefficient, &pick(slip_before))?;
        let states: Vec<ContactState> = self.at.iter().map(|i| states[*i]).collect();
        let Some(at) = coulomb.on_states(&states) else { return Ok(None) };
        let outcome = Outcome { at: Some(at), states, steps: 1, history: Vec::new(), settled: true };
        let ending = stage.plain.sheared(&coulomb, outcome, Status::Converged);
        Ok(Some(self.assemble(&stage, ending, (gap, opening))))
    }

    /// The plain problem at these points, and the opening at all points without contact.
    fn stage(&self, gap: &[f64], load: &ContactLoad) -> Result<(Stage<'_>, Vec<f64>), Error> {
        let HeldContact { operator, at, matrices } = self;
        let Acting { unloaded, held, factors, prescribed } = operator.acting(gap, load)?;
        let pick = |values: &[f64]| at.iter().map(|i| values[*i]).collect::<Vec<f64>>();
        let there = Unloaded { opening: pick(&unloaded.opening), slip: pick(&unloaded.slip), forces: unloaded.forces };
        let mut plain = Plain::new(matrices, &load.friction.at(at, gap.len())?, there, &held)?;
        if let Some(followed) = operator.followed(load)? {
            plain.follow(&followed.at(at), &held.free);
        }
        Ok((Stage { plain, factors, prescribed, free: held.free, following: load.following.clone() }, unloaded.opening))
    }

    /// The solution at all points, from the gap and the opening without contact.
    fn assemble(&self, stage: &Stage<'_>, ending: Ending, (gap, unloaded): (&[f64], Vec<f64>)) -> ContactSolution {
        let operator = self.operator;
        if self.at.len() == gap.len() {
            return operator.assemble(stage, ending);
        }
        let mut solution = operator.assemble(stage, spread(ending, &self.at, gap.len()));
        solution.opening = operator.openings(gap, &solution);
        let mut stiff = unloaded;
        let coordinates: Vec<f64> = solution.coordinates.iter().flatten().copied().collect();
        let moving: Vec<f64> =
            (0..coordinates.len()).map(|j| if stage.free.contains(&j) { coordinates[j] } else { 0.0 }).collect();
        add(&mut stiff, &times(&operator.unit.influence, &moving));
        let elastic: Vec<f64> = solution.opening.iter().zip(&stiff).map(|(all, stiff)| all - stiff).collect();
        solution.complementarity = worst_sign(&solution.nodal_force, &solution.opening, &elastic);
        solution
    }
}

impl ContactOperator<'_> {
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
