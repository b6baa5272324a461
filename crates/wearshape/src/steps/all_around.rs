//! Circles of which a part can touch: contact that reaches the end of that part has no end that could be found.

use crate::solution::Status;
use crate::stage::Stage;
use crate::steps::answer::Outcome;
use crate::words::PointStatus;

/// Refuses a contact that fills the part of a circle that can touch.
pub(super) fn refuse_full(stage: Stage<'_>, outcome: &mut Outcome) {
    let Some(told) = outcome.told.as_ref().filter(|_| !outcome.stopped) else { return };
    let ends = [told.profile.status.first(), told.profile.status.last()];
    let all_around = meshing::touches_all_around(&stage.couple.bodies[0]) || stage.patch.is_convex();
    if all_around && ends.contains(&Some(&PointStatus::Contact)) {
        let message = "the contact reaches the end of the part of the circle that can touch: there is no end of it to find";
        outcome.ended = Some((Status::Refused, message.into()));
    }
}
