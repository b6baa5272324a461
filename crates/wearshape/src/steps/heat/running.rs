//! Frictional heat of a run in time: heat passes through the bodies fast against wear, so that the temperature is that of the present pressure.

use std::sync::Arc;

use contact::faer::Mat;
use contact::{ContactLoad, ContactOperator, ContactSolution, HeatExchange, HeatSplit, HeatedSystem};
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::heat::Split;
use crate::heat_result::{HeatResult, TooHot};
use crate::level::Level;
use crate::stage::Stage;
use crate::steps::answer::Told;
use crate::steps::heat::boundary::highest_of_each;
use crate::steps::heat::following::{Following, Follows, Speeds};
use crate::steps::heat::hot::Hot;
use crate::steps::heat::known::PointHeat;
use crate::steps::heat::report::{Thermal, has_limits, tell, too_hot_under};
use crate::steps::heat::warmed::Second;

/// Bodies of a level that wear while their frictional heat bends them.
pub(crate) struct Running<'a> {
    following: Following<'a>,
}

/// What presses and slides at a moment of a run, and where heat crosses.
#[derive(Clone, Copy)]
pub(crate) struct Instant<'a> {
    pub stage: Stage<'a>,
    /// The load without heat.
    pub base: &'a ContactLoad,
    /// The points that conduct; empty where all may.
    pub conducting: &'a [bool],
}

impl<'a> Running<'a> {
    /// Bodies of a level with nodes at the ends of a pressure; none of a scene without heat.
    pub(crate) fn new(stage: Stage<'a>, level: Level, ends: &[f64]) -> Result<Option<(Running<'a>, Effort)>, Fault> {
        let cut = if ends.is_empty() { meshing::Cut::Plain } else { stage.cut(ends) };
        let found = Following::new(stage, level, cut)?;
        Ok(found.map(|(following, effort)| (Running { following }, effort)))
    }

    /// The bodies.
    pub(crate) fn reduced(&self) -> Arc<Reduced> {
        Arc::clone(&self.following.reduced)
    }

    /// The contact at the start on a gap, under the load of the bodies' own stage without heat; the reason where there is none.
    pub(crate) fn begin(
        &self,
        operator: &ContactOperator<'_>,
        gap: &[f64],
        base: &ContactLoad,
    ) -> Result<Result<ContactSolution, String>, Fault> {
        let Hot { found, lost, .. } = self.following.grown(operator, gap, base)?;
        let lost = lost.map(|lost| lost.words()).or_else(|| (!found.status.is_solved()).then(|| found.status.to_string()));
        Ok(lost.map_or(Ok(found), Err))
    }

    /// The contact under a load for any points that conduct.
    pub(crate) fn heated(
        &self,
        operator: &ContactOperator<'_>,
        stage: Stage<'_>,
        base: &ContactLoad,
    ) -> Result<HeatedSystem, Fault> {
        let n = operator.points().len();
        let mut load = base.clone();
        let mut by_heat = [None, None];
        for (body, follows) in self.following.follows.iter().enumerate() {
            let cases = load.factors[body].len();
            let units = match follows {
                Follows::Each => Mat::identity(n, n),
                Follows::Sums(sums) => sums.clone(),
                Follows::Nothing => continue,
            };
            let rows = units.nrows();
            load.factors[body].push(1.0);
            load.factors[body].extend(vec![0.0; rows]);
            let unit = |i: usize, j: usize| if i > cases { units[(i - cases - 1, j)] } else { 0.0 };
            by_heat[body] = Some(Mat::from_fn(cases + 1 + rows, n, unit));
        }
        let split = match self.following.warmed.heat.split {
            Split::Share(share) => HeatSplit::Share(share),
            Split::Conductance(conductance) => HeatSplit::Conductance(conductance),
        };
        let surfaces = &self.following.surfaces;
        let exchange = HeatExchange {
            surfaces: surfaces.surfaces.clone(),
            weights: surfaces.points.iter().map(|point| point.weight).collect(),
            rates: surfaces.rates_of(stage),
            split,
        };
        operator.heated_system(&load, by_heat, exchange).map_err(unsolved)
    }

    /// The load at an instant, with that of its heat.
    pub(crate) fn load(&self, at: Instant<'_>) -> Result<ContactLoad, Fault> {
        let shared = self.following.shared(&self.closed(at))?;
        Ok(self.following.load(at.base, &shared, &self.following.surfaces.rates_of(at.stage)))
    }

    /// Heat at the contact points at an instant under a pressure (MPa).
    pub(crate) fn heat(&self, at: Instant<'_>, pressure: &[f64]) -> Result<PointHeat, Fault> {
        let surfaces = &self.following.surfaces;
        let rates = surfaces.rates_of(at.stage);
        let friction: Vec<f64> =
            surfaces.points.iter().zip(pressure).zip(rates).map(|((point, p), rate)| rate * p * point.weight).collect();
        let into = surfaces.share(self.following.warmed.heat, &self.closed(at), &friction)?;
        Ok(PointHeat { friction, into })
    }

    fn closed(&self, at: Instant<'_>) -> Vec<bool> {
        if at.conducting.is_empty() { vec![true; self.following.surfaces.points.len()] } else { at.conducting.to_vec() }
    }

    /// Highest temperatures of both bodies (degC) under each of the heats; none of a body that arrives fresh.
    pub(crate) fn highest(&self, heats: &[PointHeat]) -> Result<[Option<Vec<f64>>; 2], Fault> {
        let warmed = &self.following.warmed;
        let second = match &warmed.second {
            Second::Body(_) => Some(highest_of_each(warmed, 1, heats)?),
            Second::Drum(drum) => Some(heats.iter().map(|heat| drum.highest(heat.into[1].iter().sum()).0).collect()),
            Second::Fresh(_) => None,
        };
        Ok([Some(highest_of_each(warmed, 0, heats)?), second])
    }

    /// Materials that are hotter than they bear under the heat of one of many states or another, each as hot as it gets.
    pub(crate) fn too_hot(&self, heats: &[PointHeat]) -> Result<Vec<TooHot>, Fault> {
        let mut found: Vec<TooHot> = Vec::new();
        if !has_limits(&self.following.warmed) {
            return Ok(found);
        }
        for highest in self.highest(heats)?.into_iter().flatten() {
            let hottest = (0..heats.len()).max_by(|i, j| highest[*i].total_cmp(&highest[*j]));
            let Some(heat) = hottest.and_then(|state| heats.get(state)) else { continue };
            for hot in too_hot_under(&self.following.warmed, heat)? {
                match found.iter_mut().find(|known| known.body == hot.body && known.limit == hot.limit) {
                    Some(known) => known.temperature = known.temperature.max(hot.temperature),
                    None => found.push(hot),
                }
            }
        }
        Ok(found)
    }

    /// Fills in the columns of heat of a solved contact and gives its numbers.
    pub(crate) fn tell(
        &self,
        operator: &ContactOperator<'_>,
        found: &ContactSolution,
        heat: &PointHeat,
        told: &mut Told,
    ) -> Result<HeatResult, Fault> {
        let stage = self.following.warmed.stage;
        let thermal = Thermal { stage, pair: operator.pair(), factors: thermal_factors(stage, operator, found) };
        tell(&self.following.warmed, heat, told, &thermal)
    }

    /// Factors on the sliding speed of a contact.
    pub(crate) fn speeds(&self, operator: &ContactOperator<'_>, at: Instant<'_>, closed: &[bool]) -> Result<Speeds, Fault> {
        self.following.speeds(operator, (at.base, closed), &self.following.surfaces.rates_of(at.stage))
    }
}

/// Factors of the thermal load cases of both bodies in a solved contact, all others zero.
pub(crate) fn thermal_factors(stage: Stage<'_>, operator: &ContactOperator<'_>, found: &ContactSolution) -> [Vec<f64>; 2] {
    let pair = operator.pair();
    let of_cases =
        |state: &hpfem::InterfaceState, body: &hpfem::InterfaceOperator| state.factors[..body.load_cases.len()].to_vec();
    let [cold, cold_counter] = stage.cases().map(|cases| cases.len());
    let mut shaped = of_cases(&found.shaped, pair.shaped);
    shaped[..cold].fill(0.0);
    let mut counter: Vec<f64> =
        found.counter.as_ref().zip(pair.counter).map(|(state, body)| of_cases(state, body)).unwrap_or_default();
    counter.iter_mut().take(cold_counter).for_each(|factor| *factor = 0.0);
    [shaped, counter]
}
