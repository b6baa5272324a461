//! One load step of Coulomb friction on a contact operator.

use crate::assemble::Ending;
use crate::coulomb::{ContactState, Coulomb, Sheared};
use crate::error::Error;
use crate::lcp::Point;
use crate::load::{ContactLoad, Friction};
use crate::operator::ContactOperator;
use crate::solution::ContactSolution;
use crate::stage::Stage;
use crate::status::Status;
use crate::verdict;

impl ContactOperator<'_> {
    /// Solves with given states of the points and no conditions on signs or friction limits; `None` if that is singular.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`]; the load's friction must be [`Friction::Coulomb`].
    pub fn solve_states(
        &self,
        gap: &[f64],
        load: &ContactLoad,
        states: &[ContactState],
    ) -> Result<Option<ContactSolution>, Error> {
        let stage = self.stage(gap, load)?;
        let Friction::Coulomb { coefficient, slip_before } = &load.friction else { return Err(Error::ShearNotPrepared) };
        let coulomb = self.coulomb(&stage, *coefficient, slip_before)?;
        let solved = coulomb.on_states(states);
        Ok(solved.map(|at| self.sheared(&stage, &coulomb, at, states.to_vec(), Status::Converged, 1)))
    }

    /// What shear adds to a stage.
    pub(crate) fn coulomb<'m>(
        &'m self,
        stage: &'m Stage<'m>,
        coefficient: f64,
        slip_before: &[f64],
    ) -> Result<Coulomb<'m>, Error> {
        let n = self.unit.points.len();
        let (Some(by_shear), Some(tangential), Some(influence)) =
            (&self.unit.normal_by_shear, &self.unit.tangential, &stage.sliding)
        else {
            return Err(Error::ShearNotPrepared);
        };
        if !(coefficient >= 0.0 && coefficient.is_finite() && slip_before.len() == n) {
            return Err(Error::Drag { coefficient, given: slip_before.len(), points: n });
        }
        Ok(Coulomb {
            normal: &stage.problem,
            by_shear,
            tangential,
            influence,
            slip: stage.slip.iter().zip(slip_before).map(|(s, b)| s - b).collect(),
            coefficient,
        })
    }

    /// One load step with stick and slip, from the states of an earlier solution or from a frictionless contact that sticks.
    pub(crate) fn step(&self, stage: &Stage<'_>, coulomb: &Coulomb<'_>, warm_start: Option<&ContactSolution>) -> ContactSolution {
        let n = self.unit.points.len();
        let (start, near) = match warm_start {
            Some(s) => {
                let point = stage.start(s);
                (s.states.clone(), Sheared { point, shear: s.nodal_shear.clone() })
            }
            None => {
                let frictionless = stage.without_shear().solve(None);
                let closed = if frictionless.settled { frictionless.active } else { vec![true; n] };
                let state = |c: &bool| if *c { ContactState::Stick } else { ContactState::Open };
                (closed.iter().map(state).collect(), Sheared { point: frictionless.point, shear: vec![0.0; n] })
            }
        };
        let outcome = coulomb.solve(&start, &near);
        let status = verdict::sheared_status(coulomb, &outcome);
        let at = outcome.at.unwrap_or_else(|| Sheared {
            point: Point { force: vec![0.0; n], coordinates: vec![0.0; stage.free.len()] },
            shear: vec![0.0; n],
        });
        self.sheared(stage, coulomb, at, outcome.states, status, outcome.steps)
    }

    fn sheared(
        &self,
        stage: &Stage<'_>,
        coulomb: &Coulomb<'_>,
        at: Sheared,
        states: Vec<ContactState>,
        status: Status,
        iterations: usize,
    ) -> ContactSolution {
        let (opening, _) = coulomb.gaps(&at);
        let complementarity = coulomb.normal.complementarity(&at.point, &opening);
        let balance = coulomb.relative_imbalance(&at);
        let ending = Ending { status, states, complementarity, balance, iterations, took_over: false };
        self.assemble(stage, at.point, at.shear, opening, ending)
    }
}
