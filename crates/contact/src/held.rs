//! Contact on a given set of points: unit forces stand at these alone, and what the others open by follows from the bodies.

use crate::coulomb::{ContactState, Outcome};
use crate::ending::{Ending, Warm};
use crate::error::Error;
use crate::held_points::HeldPoints;
use crate::lcp::{Point, worst_sign};
use crate::load::{ContactLoad, Friction};
use crate::operator::{ContactOperator, SIGNS};
use crate::plain::{Plain, Unloaded};
use crate::products::{add, times};
use crate::solution::ContactSolution;
use crate::stage::{Acting, Stage};
use crate::status::Status;
use std::sync::{Arc, PoisonError};

/// Relative overlap of points that are not held from which on they come into contact, and how often such points are taken in.
const OVERLAPS: f64 = 1e-9;
const ROUNDS: usize = 4;

/// Points held in contact, on a given operator: the compliance at these alone, for as many solves as are asked for.
pub struct HeldContact<'o, 'a> {
    operator: &'o ContactOperator<'a>,
    points: Arc<HeldPoints>,
}

impl<'a> ContactOperator<'a> {
    /// Solves with a given set of points in contact and no conditions on signs: pressures may come out negative. Node positioning uses it. The bodies
    /// are solved for unit forces at these points alone. `None` where these cannot hold the bodies, or where they are not all points and the heat of each
    /// one's own force closes it further than that opens it ([`ContactSolution::closes_itself`]): what is held there is no start for a contact.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`]; [`Error::Gap`] for another number of points.
    pub fn solve_on(&self, gap: &[f64], load: &ContactLoad, closed: &[bool]) -> Result<Option<ContactSolution>, Error> {
        if closed.len() != self.unit.points.len() {
            return Err(Error::Gap { given: closed.len(), points: self.unit.points.len() });
        }
        self.held_on(closed).solve(gap, load)
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
        self.held_on(&closed).solve_states(gap, load, states)
    }

    /// Points held in contact, those `closed` (one a point, open where it says nothing). Makes the compliance at them, `points held x points held`, mm/N;
    /// that of the points held last is kept.
    pub fn held_on<'o>(&'o self, closed: &[bool]) -> HeldContact<'o, 'a> {
        HeldContact { operator: self, points: self.held_points(closed) }
    }
}

impl ContactOperator<'_> {
    /// The points that are closed, from those held last where these are the same.
    fn held_points(&self, closed: &[bool]) -> Arc<HeldPoints> {
        let n = self.unit.points.len();
        let at: Vec<usize> = (0..n).filter(|i| closed.get(*i) == Some(&true)).collect();
        let mut kept = self.unit.held.lock().unwrap_or_else(PoisonError::into_inner);
        let known = kept.iter().find(|known| known.at == at).map(Arc::clone);
        let points = known.unwrap_or_else(|| {
            let matrices = match at.len() {
                all if all == n => Arc::clone(self.unit.matrices()),
                _ => Arc::new(self.unit.matrices_at(&at)),
            };
            Arc::new(HeldPoints { at, matrices })
        });
        *kept = Some(Arc::clone(&points));
        points
    }
}

impl HeldContact<'_, '_> {
    /// Solves as [`ContactOperator::solve_on`] on these points.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn solve(&self, gap: &[f64], load: &ContactLoad) -> Result<Option<ContactSolution>, Error> {
        let (stage, opening) = self.stage(gap, load)?;
        let (problem, all) = (&stage.plain.problem, self.points.at.len() == gap.len());
        let answer = problem.solve_on(&vec![true; self.points.at.len()]).filter(|_| all || !problem.closes_itself());
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
        let coulomb = stage.plain.coulomb(*coefficient, &self.pick(slip_before))?;
        let states = self.pick(states);
        let Some(at) = coulomb.on_states(&states) else { return Ok(None) };
        let outcome = Outcome { at: Some(at), states, steps: 1, history: Vec::new(), settled: true };
        let ending = stage.plain.sheared(&coulomb, outcome, Status::Converged);
        Ok(Some(self.assemble(&stage, ending, (gap, opening))))
    }

    /// The points held, as indices of [`ContactOperator::points`]; those that came in later stand after the others.
    pub fn points(&self) -> &[usize] {
        &self.points.at
    }

    /// Solves as [`ContactOperator::solve`] from a solution on these points, whose signs may be wrong: they may open, and slip where they stuck. Costs
    /// what these points alone do, and the few others that come into contact; they are held from then on too.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn released(&mut self, gap: &[f64], load: &ContactLoad, start: &ContactSolution) -> Result<ContactSolution, Error> {
        for _ in 0..ROUNDS {
            let Some(found) = self.signed(gap, load, start)? else { break };
            if found.complementarity < OVERLAPS {
                return Ok(found);
            }
            let at = &self.points.at;
            let more: Vec<usize> = (0..gap.len()).filter(|i| found.opening[*i] < 0.0 && !at.contains(i)).collect();
            if more.is_empty() || at.len() + more.len() == gap.len() {
                break;
            }
            let unit = &self.operator.unit;
            let influence = (&unit.influence, unit.shear_influence.as_ref());
            self.points = Arc::new(self.points.and(&more, &unit.responses, influence));
        }
        self.points = self.operator.held_points(&vec![true; gap.len()]);
        self.operator.solve(gap, load, Some(start))
    }

    /// The same whatever the other points do; `None` where that does not settle.
    fn signed(&self, gap: &[f64], load: &ContactLoad, start: &ContactSolution) -> Result<Option<ContactSolution>, Error> {
        let (stage, opening) = self.stage(gap, load)?;
        let friction = load.friction.at(&self.points.at, gap.len())?;
        let Warm { point: Point { coordinates, .. }, .. } = stage.warm(start, gap.len())?;
        let point = Point { force: self.pick(&start.nodal_force), coordinates };
        let (shear, closed, states) = (self.pick(&start.nodal_shear), self.pick(&start.closed), self.pick(&start.states));
        let warm = Warm { point, shear: &shear, closed: &closed, states: &states };
        let mut ending = stage.plain.solve(&friction, Some(warm), &|_, _| {})?;
        if ending.status == Status::ClosedEverywhere && self.points.at.len() < gap.len() {
            ending.status = Status::Converged;
        }
        Ok(ending.status.is_solved().then(|| self.assemble(&stage, ending, (gap, opening))))
    }

    /// The values at these points out of those of all points.
    pub(crate) fn pick<T: Copy>(&self, values: &[T]) -> Vec<T> {
        self.points.at.iter().map(|i| values[*i]).collect()
    }

    /// The plain problem at these points, and the opening at all points without contact.
    pub(crate) fn stage(&self, gap: &[f64], load: &ContactLoad) -> Result<(Stage<'_>, Vec<f64>), Error> {
        let (operator, HeldPoints { at, matrices, .. }) = (self.operator, &*self.points);
        let Acting { unloaded, held, factors, prescribed } = operator.acting(gap, load)?;
        let there = Unloaded { opening: self.pick(&unloaded.opening), slip: self.pick(&unloaded.slip), forces: unloaded.forces };
        let mut plain = Plain::new(matrices, &load.friction.at(at, gap.len())?, there, &held)?;
        if let Some(followed) = operator.followed(load)? {
            plain.follow(&followed.at(at), &held.free);
        }
        Ok((Stage { plain, factors, prescribed, free: held.free, following: load.following.clone() }, unloaded.opening))
    }

    /// The solution at all points, from the gap and the opening without contact.
    fn assemble(&self, stage: &Stage<'_>, ending: Ending, (gap, unloaded): (&[f64], Vec<f64>)) -> ContactSolution {
        let operator = self.operator;
        let at = &self.points.at;
        if at.len() == gap.len() {
            return operator.assemble(stage, ending);
        }
        let mut solution = operator.assemble(stage, spread(ending, at, gap.len()));
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
