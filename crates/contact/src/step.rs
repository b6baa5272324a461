//! One load step of Coulomb friction on a contact operator.

use crate::assemble::Ending;
use crate::coulomb::{ContactState, Coulomb, Outcome, Sheared};
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
        let Some(at) = coulomb.on_states(states) else { return Ok(None) };
        let outcome = Outcome { at: Some(at), states: states.to_vec(), steps: 1, history: Vec::new(), settled: true };
        Ok(Some(self.sheared(&stage, &coulomb, outcome, Status::Converged)))
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
        self.sheared(stage, coulomb, outcome, status)
    }

    /// The solution of an outcome; nothing carries where there is none.
    fn sheared(&self, stage: &Stage<'_>, coulomb: &Coulomb<'_>, outcome: Outcome, status: Status) -> ContactSolution {
        let n = self.unit.points.len();
        let at = outcome.at.unwrap_or_else(|| Sheared {
            point: Point { force: vec![0.0; n], coordinates: vec![0.0; stage.free.len()] },
            shear: vec![0.0; n],
        });
        let (opening, _) = coulomb.gaps(&at);
        let ending = Ending {
            status,
            states: outcome.states,
            complementarity: coulomb.normal.complementarity(&at.point, &opening),
            balance: coulomb.relative_imbalance(&at),
            point: at.point,
            shear: at.shear,
            opening,
            iterations: outcome.steps,
            took_over: false,
        };
        self.assemble(stage, ending)
    }
}
