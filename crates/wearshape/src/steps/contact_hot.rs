//! The hot contact of a level, with nodes on its ends where it ends inside the surface.

use contact::{ContactSolution, FreeEnds, SpeedFactors};
use scene::Fault;

use crate::effort::Effort;
use crate::level::Level;
use crate::remark::Remark;
use crate::stage::Stage;
use crate::steps::free_ends::{NO_START, Positioned, SIGNS_HOLD, branched, node_tolerance, position};
use crate::steps::heat::contact::HotContact;
use crate::steps::heat::continued::{Continued, continued};

/// Distance of ends on two levels, of half the surface, up to which they are those of one contact.
const SAME_CONTACT: f64 = 0.1;

/// Degree up to which every level is asked whether its contact lies beyond a branch.
const EARLY: usize = 6;

/// A hot contact.
pub(crate) struct HotFound<'a> {
    pub hot: HotContact<'a>,
    /// The level that it is of.
    pub level: Level,
    /// Whether nodes did not settle on its ends.
    pub unsettled: bool,
}

/// What the hot contact of one level leaves to the next.
#[derive(Default)]
pub(crate) struct HotSearch {
    /// Factors on the sliding speed of the last level.
    pub speeds: Option<SpeedFactors>,
    /// The contact that continues that of slower sliding, once it was asked for.
    continued: Option<Continued>,
}

impl HotSearch {
    /// The ends that continue those of slower sliding; none where they could not be followed.
    fn continued(&mut self, stage: Stage<'_>, level: Level, effort: &mut Effort) -> Result<FreeEnds, Fault> {
        let continued = match self.continued.take() {
            Some(continued) => continued,
            None => continued(stage, level, effort)?,
        };
        Ok(self.continued.insert(continued).ends.clone())
    }

    /// What is left of it for a ladder of other levels.
    pub(crate) fn once_more(self) -> HotSearch {
        HotSearch { speeds: None, ..self }
    }

    /// What is to be said of a contact on a surface of a length.
    pub(crate) fn note(&self, found: &ContactSolution, length: f64) -> Option<Remark> {
        let ends = FreeEnds::of(found, length);
        let continues = |continued: &Continued| continued.smoothly && ends.is_alike(&continued.ends, SAME_CONTACT);
        let strays = self.continued.as_ref().is_some_and(|continued| !continues(continued));
        let message = "The contact of slower sliding does not lead to this one without a jump: with this frictional heat several may carry the load, \
                       and other meshes may meet the others. Slide more slowly, or take less of the heat into the bodies.";
        strays.then(|| Remark { code: "several-solutions", message: message.into() })
    }
}

/// The contact of a level from the ends of the last one; on the standing mesh where nodes do not settle on the ends of contact, or lead to others. Forgets the
/// factors on the speeds of the last level where that found another contact.
pub(crate) fn find<'a>(
    stage: Stage<'a>,
    level: Level,
    (ends, search): (&mut FreeEnds, &mut HotSearch),
    effort: &mut Effort,
) -> Result<Option<HotFound<'a>>, Fault> {
    let before = ends.clone();
    let standing = trial(stage, level, (ends, search), effort)?;
    let mut found = on_ends(stage, level, ends, effort)?;
    let unsettled = found.is_none() && !ends.places.is_empty();
    // One that the standing mesh leads to may lie beyond a branch, which the first level need not tell.
    let early = before.places.is_empty() || level.degree <= EARLY;
    if unsettled || found.is_some() && early && branched(stage, level, ends, effort)? {
        let mut continued = search.continued(stage, level, effort)?;
        let other = if continued.is_alike(ends, 0.0) { None } else { on_ends(stage, level, &mut continued, effort)? };
        if other.is_some() {
            (found, *ends) = (other, continued);
        }
    }
    let found = match found {
        Some(hot) => Some(HotFound { hot, level, unsettled: false }),
        None => {
            *ends = FreeEnds::default();
            let level = if unsettled { level.evenly() } else { level };
            let hot = match standing.filter(|_| !unsettled) {
                Some(hot) => Some(hot),
                None => HotContact::new(stage, level, effort)?,
            };
            hot.map(|hot| HotFound { hot, level, unsettled })
        }
    };
    if !ends.is_alike(&before, SAME_CONTACT) {
        search.speeds = None;
    }
    Ok(found)
}

/// Trial ends of a level where the last one left none, and the contact on the standing mesh if they come from that.
fn trial<'a>(
    stage: Stage<'a>,
    level: Level,
    (ends, search): (&mut FreeEnds, &mut HotSearch),
    effort: &mut Effort,
) -> Result<Option<HotContact<'a>>, Fault> {
    if !ends.places.is_empty() {
        return Ok(None);
    }
    if search.continued.as_ref().is_some_and(|continued| !continued.ends.places.is_empty()) {
        *ends = search.continued(stage, level, effort)?;
        return Ok(None);
    }
    let standing = HotContact::new(stage, level, effort)?;
    let Some(hot) = &standing else { return Ok(None) };
    let lost = hot.lost().is_some();
    let inside = FreeEnds::of(&hot.hot.found, hot.reduced().pair()?.trace().length());
    *ends = if lost || hot.may_be_one_of_several(!inside.places.is_empty(), search.speeds.as_ref())? {
        search.continued(stage, level, effort)?
    } else {
        inside.clone()
    };
    if ends.places.is_empty() && !lost {
        *ends = inside;
    }
    Ok(standing)
}

/// The contact with nodes on its ends, from trial ends; none where they do not settle, or where another one is found on them.
fn on_ends<'a>(
    stage: Stage<'a>,
    level: Level,
    ends: &mut FreeEnds,
    effort: &mut Effort,
) -> Result<Option<HotContact<'a>>, Fault> {
    // Ends of a hot contact move its heat, and so each other: nodes that are off lead to another branch.
    let within = node_tolerance(stage.accuracy(), None);
    let positioned = position(stage, level, (ends, within), effort)?.filter(|(_, found)| found.held.complementarity < NO_START);
    let Some((at, Positioned { held, hot: Some(hot), .. })) = positioned else { return Ok(None) };
    let mut hot = if held.complementarity < SIGNS_HOLD { hot } else { hot.released(effort)? };
    if !at.bound_as_many(&hot.hot.found, hot.reduced().pair()?.trace().length()) {
        return Ok(None);
    }
    *ends = at;
    hot.between = Some(held.closed);
    hot.hot.found.pressure.iter_mut().for_each(|p| *p = p.max(0.0));
    Ok(Some(hot))
}
