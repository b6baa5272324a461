//! The hot contact of a level, with nodes on its ends where it ends inside the surface.

use contact::{FreeEnds, SpeedFactors};
use scene::Fault;

use crate::effort::Effort;
use crate::level::Level;
use crate::stage::Stage;
use crate::steps::free_ends::{NO_START, Positioned, SIGNS_HOLD, branched, followed, from_slower, node_tolerance, position};
use crate::steps::heat::contact::HotContact;

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

/// The contact of a level from the ends of the last one; on the standing mesh where nodes do not settle on the ends of contact, or lead to others. Forgets the
/// factors on the `speeds` of the last level where that found another contact.
pub(crate) fn find<'a>(
    stage: Stage<'a>,
    level: Level,
    (ends, speeds): (&mut FreeEnds, &mut Option<SpeedFactors>),
    effort: &mut Effort,
) -> Result<Option<HotFound<'a>>, Fault> {
    let before = ends.clone();
    let mut standing = None;
    if ends.places.is_empty() {
        standing = HotContact::new(stage, level, effort)?;
        if let Some(hot) = &standing {
            let length = hot.reduced().pair()?.trace().length();
            *ends = match hot.lasted() {
                Some((speed, found)) => followed(stage, level, (*speed, FreeEnds::of(found, length)), effort)?,
                None => FreeEnds::of(&hot.found(), length),
            };
        }
    }
    let is_lost = standing.as_ref().is_some_and(|hot| hot.lost().is_some());
    let mut found = on_ends(stage, level, ends, effort)?;
    let unsettled = found.is_none() && !ends.places.is_empty();
    // One that the standing mesh leads to may lie beyond a branch, which the first level need not tell.
    let early = before.places.is_empty() || level.degree <= EARLY;
    let beyond = found.is_some() && early && branched(stage, level, ends, effort)?;
    if beyond || unsettled || found.is_none() && is_lost {
        standing = standing.map_or_else(|| HotContact::new(stage, level, effort), |hot| Ok(Some(hot)))?;
        let mut slower = match &standing {
            Some(hot) => from_slower(stage, level, hot, effort)?,
            None => FreeEnds::default(),
        };
        let other = on_ends(stage, level, &mut slower, effort)?;
        if other.is_some() {
            (found, *ends) = (other, slower);
        }
    }
    let whole = |hot: HotContact<'a>, level: Level| HotFound { hot, level, unsettled };
    let found = match found {
        Some(hot) => Some(HotFound { hot, level, unsettled: false }),
        None => {
            *ends = FreeEnds::default();
            let level = if unsettled { level.evenly() } else { level };
            match standing.filter(|_| !unsettled) {
                Some(hot) => Some(whole(hot, level)),
                None => HotContact::new(stage, level, effort)?.map(|hot| whole(hot, level)),
            }
        }
    };
    if !ends.is_alike(&before, SAME_CONTACT) {
        *speeds = None;
    }
    Ok(found)
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
    hot.hot.found.pressure.iter_mut().for_each(|p| *p = p.max(0.0));
    Ok(Some(hot))
}
