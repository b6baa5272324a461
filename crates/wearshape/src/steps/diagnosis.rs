//! What a contact solve rests on: the condition of its system, and whether friction lets it have other solutions.

use std::sync::{Arc, Weak};

use contact::{ContactLoad, ContactOperator, ContactSolution};
use scene::Fault;

use crate::bodies::Reduced;
use crate::faults::unsolved;
use crate::level::Level;
use crate::results::{InterfaceResult, UniquenessResult};
use crate::stage::Stage;
use crate::steps::answer::Outcome;
use crate::steps::start_gap::start_gaps;
use crate::words::Uniqueness;

/// Difference of pressures, over the largest, above which they are two solutions.
const APART: f64 = 1e-6;

/// A solved contact on its bodies; what it rests on is worked out for the reported level alone.
pub(crate) struct Diagnosis {
    /// The level, and where its element nodes stand on ends of contact.
    pub level: Level,
    pub ends: Vec<f64>,
    /// The bodies, while they are there; they are made again where another level than the last ones is reported.
    pub reduced: Weak<Reduced>,
    pub found: ContactSolution,
    /// The bodies and the load of a contact with frictional heat.
    pub hot: Option<(Arc<Reduced>, ContactLoad)>,
}

impl Diagnosis {
    /// Writes what the contact rests on.
    pub(crate) fn report(&self, stage: Stage<'_>, outcome: &mut Outcome) -> Result<(), Fault> {
        if let Some(contact) = outcome.contact.as_mut() {
            (contact.uniqueness, outcome.interface) = self.made(stage)?;
        }
        Ok(())
    }

    /// Uniqueness, and the condition of the system.
    fn made(&self, stage: Stage<'_>) -> Result<(Option<UniquenessResult>, Option<InterfaceResult>), Fault> {
        let known = self.hot.as_ref().map(|(reduced, _)| Arc::clone(reduced)).or_else(|| self.reduced.upgrade());
        let reduced = match known {
            Some(reduced) => reduced,
            None => stage.reduced_at(self.level, &self.ends)?.0,
        };
        let pair = reduced.pair()?;
        let operator = reduced.factorised(&pair, stage.friction() > 0.0, None)?;
        let gap = start_gaps(stage, &operator);
        if let Some((_, load)) = &self.hot {
            // What heat does to uniqueness is told by its critical speed.
            return Ok((None, interface(&operator, &gap, load, &self.found)?));
        }
        let load = stage.contact_load(operator.points());
        let uniqueness = uniqueness(&operator, &gap, &load, &self.found)?;
        Ok((uniqueness, interface(&operator, &gap, &load, &self.found)?))
    }
}

/// Singular values of the system of the points in contact.
pub(crate) fn interface(
    operator: &ContactOperator<'_>,
    gap: &[f64],
    load: &ContactLoad,
    found: &ContactSolution,
) -> Result<Option<InterfaceResult>, Fault> {
    Ok(condition(operator.singular_values(gap, load, found).map_err(unsolved)?))
}

/// What the smallest and the largest of them say.
pub(crate) fn condition(values: Option<[f64; 2]>) -> Option<InterfaceResult> {
    values.map(|[low, high]| InterfaceResult { condition: high / low, smallest_singular_value: low })
}

/// Other solutions of a contact that slides steadily.
fn uniqueness(
    operator: &ContactOperator<'_>,
    gap: &[f64],
    load: &ContactLoad,
    found: &ContactSolution,
) -> Result<Option<UniquenessResult>, Fault> {
    let judged = operator.uniqueness(gap, load, found).map_err(unsolved)?;
    Ok(judged.map(|judged| {
        let verdict = if judged.is_guaranteed() {
            Uniqueness::Guaranteed
        } else if judged.singular_from.or(judged.lost_from).is_some() {
            Uniqueness::Singular
        } else if judged.other_solution > APART {
            Uniqueness::Several
        } else {
            Uniqueness::NotGuaranteed
        };
        UniquenessResult {
            verdict,
            not_guaranteed_from: judged.not_guaranteed_from,
            singular_from: judged.singular_from,
            lost_from: judged.lost_from,
        }
    }))
}
