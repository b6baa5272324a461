//! A load step of Coulomb friction with the states of its points given.

use crate::coulomb::{ContactState, Outcome};
use crate::error::Error;
use crate::load::{ContactLoad, Friction};
use crate::operator::ContactOperator;
use crate::solution::ContactSolution;
use crate::status::Status;

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
        let coulomb = stage.plain.coulomb(*coefficient, slip_before)?;
        let Some(at) = coulomb.on_states(states) else { return Ok(None) };
        let outcome = Outcome { at: Some(at), states: states.to_vec(), steps: 1, history: Vec::new(), settled: true };
        Ok(Some(self.assemble(&stage, stage.plain.sheared(&coulomb, outcome, Status::Converged))))
    }
}
