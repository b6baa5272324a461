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

/// A contact with its heat.
pub(crate) struct HotContact<'a> {
    pub stage: Stage<'a>,
    pub following: Following<'a>,
    pub hot: Hot,
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
        Ok(HotContact { stage, following, hot })
    }

    /// The contact of the same bodies at a part of the sliding speed; none where there is none.
    pub(crate) fn at_speed(&self, speed: f64, effort: &mut Effort) -> Result<Option<ContactSolution>, Fault> {
        let following = &self.following;
        let pair = following.reduced.pair()?;
        let operator = following.reduced.operator(&pair, self.stage.friction() > 0.0)?;
        effort.counters.contact_solves += 1;
        let (gap, load) = (start_gaps(self.stage, &operator), self.stage.contact_load(operator.points()));
        let slower =
            effort.timed(Step::Contact, self.stage.clock(), |_| following.settled(&operator, &gap, &load, speed, None))?;
        Ok(Some(slower.found).filter(|found| found.status.is_solved()))
    }

    /// The bodies.
    pub(crate) fn reduced(&self) -> Arc<Reduced> {
        Arc::clone(&self.following.reduced)
    }

    /// The contact found.
    pub(crate) fn found(&self) -> ContactSolution {
        self.hot.found.clone()
    }

    /// The load of the contact, that of its heat among it.
    pub(crate) fn load(&self) -> ContactLoad {
        self.hot.load.clone()
    }

    /// The part of the sliding speed up to which the contact of the cold bodies was followed before it was lost, and that contact.
    pub(crate) fn lasted(&self) -> Option<&(f64, ContactSolution)> {
        self.hot.lost.as_ref()?.last.as_ref()
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
            let at = (&stage.contact_load(operator.points()), &found.closed[..]);
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
