//! Hot contacts that have branched: the heat that crosses a contact changes with the places of its ends.

use contact::FreeEnds;
use scene::Fault;

use crate::effort::Effort;
use crate::level::Level;
use crate::solution::Status;
use crate::stage::Stage;
use crate::steps::answer::Outcome;
use crate::steps::free_ends::branched;
use crate::words::ContactStatus;

/// Refuses a contact with these ends if an odd number of branches lies between it and one that is unique.
pub(crate) fn refuse(
    stage: Stage<'_>,
    (level, ends): (Level, &FreeEnds),
    outcome: &mut Outcome,
    work: &mut Effort,
) -> Result<(), Fault> {
    if outcome.stopped || !branched(stage, level, ends, work)? {
        return Ok(());
    }
    outcome.contact.iter_mut().for_each(|contact| contact.status = ContactStatus::NotUnique);
    let reason =
        "contacts with this frictional heat branch below this sliding speed: pressure and temperature are no longer unique";
    // Whatever its accuracy is.
    outcome.ended = Some((Status::Refused, reason.into()));
    Ok(())
}
