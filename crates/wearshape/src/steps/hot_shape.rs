//! What frictional heat is to a shape: bodies bent by the heat of the wanted pressure, and the factors on the sliding speed that the shape bears.

use std::sync::Arc;

use contact::{ContactLoad, ContactPoint, Pair, SpeedFactors};
use meshing::Cut;
use scene::Fault;
use shapeopt::SurfacePlace;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::heat::Heat;
use crate::heat_result::{FromCold, HeatResult};
use crate::level::Level;
use crate::results::EnergyResult;
use crate::step::Step;
use crate::steps::answer::Told;
use crate::steps::heat::bodies::{Asked, HotBodies, Warm};
use crate::steps::heat::following::{Following, Speeds};
use crate::steps::heat::hot::Hot;
use crate::steps::heat::known::{PointHeat, with_heat};
use crate::steps::heat::report::{Thermal, tell};
use crate::steps::heat::smooth::Smooth;
use crate::steps::heat::warmed::Surfaces;
use crate::steps::shaper::Shaper;

/// Bodies of a level as problems of temperature and the heat of the wanted pressure.
pub(crate) struct HotShape<'a> {
    warm: Warm<'a>,
    /// Heat at the contact points.
    pub heat: PointHeat,
}

impl<'a> HotShape<'a> {
    /// The bodies of a level as they are, and bent by the heat of the wanted pressure; none of a scene without heat. Where more levels are `left`, heat that
    /// follows the pressure is not expected to be asked for.
    pub(crate) fn new(shaper: &Shaper<'a>, level: Level, left: bool) -> Result<Option<(HotShape<'a>, Reduced, Effort)>, Fault> {
        let (stage, ends) = (shaper.stage, &shaper.nodes);
        let cut = if ends.is_empty() { Cut::Plain } else { Cut::Ends(ends) };
        let wanted = |surfaces: &Surfaces, heat: &Heat| wanted_heat(shaper, surfaces, heat);
        let made =
            HotBodies::new(stage, level, (cut, if left { Asked::Under(&wanted) } else { Asked::Near(&wanted, Smooth::Waves) }))?;
        let Some((bodies, mut effort)) = made else { return Ok(None) };
        let found = effort.timed(Step::Heat, stage.clock(), |_| {
            Ok::<_, Fault>(bodies.asked()?.map(|(heat, reduced)| (heat.clone(), reduced)))
        })?;
        // Something was asked for, so that this is there.
        let Some((heat, reduced)) = found else { return Ok(None) };
        // What the elastic bodies are factorised for is there, and they take memory that the proof needs.
        Ok(Some((HotShape { warm: bodies.warm, heat }, reduced, effort)))
    }

    /// The bodies, of a level that is the last one, bent by heat that follows the pressure.
    pub(crate) fn following(&self, reduced: &Arc<Reduced>) -> Following<'a> {
        Following::on(&self.warm, Arc::clone(reduced), (&self.heat, Smooth::Waves))
    }

    /// Temperatures and powers of the shape on its pair, into its columns and as numbers.
    pub(crate) fn tell(&self, shaper: &Shaper<'_>, pair: &Pair<'_>, told: &mut Told) -> Result<HeatResult, Fault> {
        let cold = shaper.stage.cases().map(|cases| cases.len());
        let mut factors = with_heat(pair, shaper.stage.cases());
        factors.iter_mut().zip(cold).for_each(|(factors, cold)| factors[..cold].fill(0.0));
        let thermal = Thermal { stage: shaper.stage, pair, factors };
        // The work of the loads is no strain energy where there are thermal strains.
        told.energy = EnergyResult::default();
        tell(&self.warm.bodies, &self.heat, told, &thermal)
    }
}

/// Heat at the contact points of bodies under the wanted pressure.
pub(crate) fn wanted_heat(shaper: &Shaper<'_>, surfaces: &Surfaces, heat: &Heat) -> Result<PointHeat, Fault> {
    let forces: Vec<f64> = surfaces.points.iter().map(|p| p.weight * shaper.pressure(&SurfacePlace::from(p), None)).collect();
    let closed: Vec<bool> = forces.iter().map(|force| *force > 0.0).collect();
    let friction = surfaces.friction(&forces);
    let into = surfaces.share(heat, &closed, &friction)?;
    Ok(PointHeat { friction, into })
}

/// What a shape bears of its sliding speed.
pub(crate) struct Bears {
    /// Factors on the speed, of the points where pressure is wanted.
    pub speeds: Speeds,
    /// The same of heat that is smooth along the surface, where the contact is singular at any factor.
    pub smooth: Option<SpeedFactors>,
    /// The fastest growth of a deviation from its steady pressure (1/s).
    pub growth: Option<f64>,
    /// The contact that it has when it is brought to its speed cold, where that is another one.
    pub from_cold: Option<FromCold>,
}

/// What a shape with this gap bears of its sliding speed.
pub(crate) fn bears(shaper: &Shaper<'_>, following: &Following<'_>, gap: impl Fn(&ContactPoint) -> f64) -> Result<Bears, Fault> {
    let pair = following.reduced.pair()?;
    let operator = following.reduced.operator(&pair, shaper.stage.friction() > 0.0)?;
    let pressure: Vec<f64> = operator.points().iter().map(|p| shaper.pressure(&SurfacePlace::from(p), Some(&pair))).collect();
    let closed: Vec<bool> = pressure.iter().map(|p| *p > 0.0).collect();
    let load = contact_load(shaper, operator.points());
    let speeds = following.speeds(&operator, (&load, &closed), &following.surfaces.rates)?;
    let singular = !speeds.factors.singular.is_empty();
    let smooth = singular.then(|| following.smooth_factors(&operator, (&load, &closed))).transpose()?;
    let growth = following.deviation_growth(shaper.stage, &operator, (&load, &pressure))?;
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let another = following.another(&operator, &gap, &load, &pressure)?;
    let from_cold = another.map(|hot| from_cold(&hot, shaper.stage.start(&pair)));
    Ok(Bears { speeds, smooth, growth, from_cold })
}

/// What a contact that grows from that of the cold bodies comes to; arc lengths of the scene begin at `start`.
fn from_cold(hot: &Hot, start: f64) -> FromCold {
    let found = &hot.found;
    if hot.lost.is_some() || !found.status.is_solved() {
        return FromCold::Lost;
    }
    let arcs = || found.zones.iter().flatten().map(|arc| start + arc);
    let ends = [arcs().fold(f64::INFINITY, f64::min), arcs().fold(f64::NEG_INFINITY, f64::max)];
    FromCold::Carries { largest: found.pressure.iter().fold(0.0, |most: f64, p| most.max(*p)), ends }
}

/// Load of a contact on the shape, with the worn motions of its wear.
pub(crate) fn contact_load(shaper: &Shaper<'_>, points: &[ContactPoint]) -> ContactLoad {
    let mut load = shaper.stage.contact_load(points);
    shaper.add_feed(&mut load);
    load
}
