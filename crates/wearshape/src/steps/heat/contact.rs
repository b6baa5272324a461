//! The contact of the bodies as given with frictional heat, on a mesh of a level.

use std::sync::Arc;

use contact::{ContactLoad, ContactOperator, ContactSolution, SpeedFactors};
use meshing::Cut;
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::heat_result::{HEAT_ALIKE, HeatResult, MESHES_ALIKE};
use crate::level::Level;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::answer::Told;
use crate::steps::heat::following::Following;
use crate::steps::heat::hot::{Hot, Lost};
use crate::steps::heat::known::PointHeat;
use crate::steps::heat::report::{Thermal, tell};
use crate::steps::heat::running::thermal_factors;
use crate::steps::start_gap::start_gaps;

/// Factor on the sliding speed up to which pressure and heat by turns come to an end, from which on heat is held to change the pressure too little for a second
/// contact.
const WEAK: f64 = 5.0;

/// A contact with its heat.
pub(crate) struct HotContact<'a> {
    pub stage: Stage<'a>,
    pub following: Following<'a>,
    pub hot: Hot,
    /// The points between nodes on its ends, those included; none without such nodes. Signs may leave out the last ones, on which the critical speed depends.
    pub between: Option<Vec<bool>>,
}

impl<'a> HotContact<'a> {
    /// Solves a level on its standing mesh; none of a scene without heat.
    pub(crate) fn new(stage: Stage<'a>, level: Level, effort: &mut Effort) -> Result<Option<HotContact<'a>>, Fault> {
        let Some((following, work)) = Following::new(stage, level, Cut::Plain)? else { return Ok(None) };
        *effort += work;
        HotContact::on(stage, following, None, effort).map(Some)
    }

    /// The contact on the same bodies from this one, whose points were held in contact.
    pub(crate) fn released(self, effort: &mut Effort) -> Result<HotContact<'a>, Fault> {
        HotContact::on(self.stage, self.following, Some(&self.hot.found), effort)
    }

    /// Solves on bodies that are there, from a contact that is near.
    fn on(
        stage: Stage<'a>,
        following: Following<'a>,
        near: Option<&ContactSolution>,
        effort: &mut Effort,
    ) -> Result<HotContact<'a>, Fault> {
        let pair = following.reduced.pair()?;
        (stage.options.begun)(Step::Contact);
        let operator =
            effort.timed(Step::Interface, stage.clock(), |_| following.reduced.operator(&pair, stage.friction() > 0.0))?;
        let gap = start_gaps(stage, &operator);
        effort.counters.contact_solves += 1;
        let load = stage.contact_load(operator.points());
        let hot = effort.timed(Step::Contact, stage.clock(), |_| match near {
            Some(near) => following.solve_from(&operator, &gap, &load, near),
            None => following.grown(&operator, &gap, &load),
        })?;
        Ok(HotContact { stage, following, hot, between: None })
    }

    /// The bodies.
    pub(crate) fn reduced(&self) -> Arc<Reduced> {
        Arc::clone(&self.following.reduced)
    }

    /// The contact found.
    pub(crate) fn found(&self) -> ContactSolution {
        self.hot.found.clone()
    }

    /// Whether other contacts may carry the load: what conducts decides on the contact, which decides on what conducts. Not where heat does next to nothing to
    /// the pressure, nor where contact fills the surface below its critical speed, which is `known` where the last level filled it too.
    pub(crate) fn may_be_one_of_several(&self, ends_inside: bool, known: Option<&SpeedFactors>) -> Result<bool, Fault> {
        let found = &self.hot.found;
        if !self.following.conducts() || !found.status.is_solved() {
            return Ok(self.following.conducts());
        }
        if let Some(known) = known.filter(|_| !ends_inside) {
            return Ok(is_strong(known) && is_beyond_critical(known));
        }
        let pair = self.following.reduced.pair()?;
        let operator = self.following.reduced.operator(&pair, self.stage.friction() > 0.0)?;
        let factors = self.following.factors(&operator, &self.stage.contact_load(operator.points()), &found.closed)?;
        Ok(is_strong(&factors) && (ends_inside || is_beyond_critical(&factors)))
    }

    /// The load of the contact, that of its heat among it.
    pub(crate) fn load(&self) -> ContactLoad {
        self.hot.load.clone()
    }

    /// Why there is no contact, where that of the cold bodies does not last to the sliding speed.
    pub(crate) fn lost(&self) -> Option<String> {
        self.hot.lost.as_ref().map(Lost::words)
    }

    /// Heat at the contact points.
    pub(crate) fn heat(&self) -> PointHeat {
        self.hot.heat.clone()
    }

    /// Fills in the columns of heat and gives its numbers; `before` holds the factors on the speed of the level before, where that found the same contact.
    pub(crate) fn tell(
        &self,
        operator: &ContactOperator<'_>,
        told: &mut Told,
        before: &mut Option<SpeedFactors>,
    ) -> Result<HeatResult, Fault> {
        let (stage, found) = (self.stage, &self.hot.found);
        let thermal = Thermal { stage, pair: operator.pair(), factors: thermal_factors(stage, operator, found) };
        let mut result = tell(&self.following.warmed, &self.hot.heat, told, &thermal)?;
        if found.status.is_solved() {
            let following = &self.following;
            let closed = self.between.as_ref().unwrap_or(&found.closed);
            let at = (&stage.contact_load(operator.points()), &closed[..]);
            let speeds = following.speeds(operator, at, &following.surfaces.rates)?;
            let smooth = match before {
                None if !speeds.factors.singular.is_empty() => Some(following.smooth_factors(operator, at)?),
                None | Some(_) => None,
            };
            let other = before.as_ref().map(|before| (before, MESHES_ALIKE));
            result.take_speeds(&speeds, other.or(smooth.as_ref().map(|smooth| (smooth, HEAT_ALIKE))));
            *before = Some(speeds.factors);
        }
        Ok(result)
    }
}

/// Whether heat changes the pressure by much.
fn is_strong(factors: &SpeedFactors) -> bool {
    factors.staggered.is_some_and(|factor| factor < WEAK)
}

/// Whether sliding is faster than a speed at which the contact is singular.
fn is_beyond_critical(factors: &SpeedFactors) -> bool {
    factors.singular.first().is_some_and(|factor| *factor < 1.0)
}
