//! Wear in time of bodies that their frictional heat bends.

use contact::{ContactLoad, ContactOperator, ContactSolution, SpeedFactors};
use scene::Fault;
use shapeopt::{WearProblem, WearState};

use crate::heat_result::{HeatInTime, HeatResult, MESHES_ALIKE};
use crate::ladder::Refusal;
use crate::results::EnergyResult;
use crate::stage::Stage;
use crate::steps::answer::Told;
use crate::steps::heat::known::PointHeat;
use crate::steps::heat::running::{Instant, Running};
use crate::steps::start_gap::start_gaps;
use crate::steps::wear::pieces::Pieces;
use crate::watch::FinishedLevel;

/// The heat of a level under the loads of a run.
pub(super) struct Hot<'a> {
    pub running: Running<'a>,
    /// The loads without heat.
    pub base: Vec<ContactLoad>,
    pub stages: &'a [Stage<'a>],
    pub pieces: &'a Pieces,
}

/// The start of a hot run.
pub(super) struct Begun {
    /// The loads with their heat.
    pub loads: Vec<ContactLoad>,
    /// Pressure (MPa) and opening (mm).
    pub contact: [Vec<f64>; 2],
}

/// What is told of a hot run at its end.
pub(super) struct ToldHeat {
    pub result: HeatResult,
    pub heat: PointHeat,
    /// Factors on the sliding speed at which the contact is singular.
    pub singular: Vec<f64>,
}

impl Hot<'_> {
    fn at<'s>(&'s self, load: usize, conducting: &'s [bool]) -> Instant<'s> {
        Instant { stage: self.stages[load], base: &self.base[load], conducting }
    }

    /// Number of the load that acts in a state.
    fn acting(&self, state: &WearState) -> usize {
        self.pieces.intervals[state.interval].stage
    }

    /// The contact at the start, hot, and the loads while its points conduct.
    pub(super) fn begin(&self, operator: &ContactOperator<'_>) -> Result<Begun, Refusal> {
        let first = self.pieces.intervals[0].stage;
        let gap = start_gaps(self.stages[first], operator);
        let found = self.running.begin(operator, &gap, &self.base[first])?.map_err(Refusal::Reason)?;
        let loads = (0..self.stages.len()).map(|load| self.load(load, &found.closed)).collect::<Result<_, Fault>>()?;
        Ok(Begun { loads, contact: [found.pressure, found.opening] })
    }

    /// A load with its heat.
    pub(super) fn load(&self, load: usize, conducting: &[bool]) -> Result<ContactLoad, Fault> {
        self.running.load(self.at(load, conducting))
    }

    /// Tells a run how its contact changes with the points that conduct.
    pub(super) fn join(&self, problem: &mut WearProblem, operator: &ContactOperator<'_>) -> Result<(), Fault> {
        for ((acting, stage), base) in problem.stages.iter_mut().zip(self.stages).zip(&self.base) {
            acting.heated = Some(self.running.heated(operator, *stage, base)?);
        }
        Ok(())
    }

    /// Fills in the columns of heat at the end of a run and gives its numbers; `before` are the levels before this one.
    pub(super) fn tell(
        &self,
        operator: &ContactOperator<'_>,
        state: &WearState,
        (found, told): (&ContactSolution, &mut Told),
        before: &[FinishedLevel],
    ) -> Result<ToldHeat, Fault> {
        // With thermal strains the work of the loads is no strain energy.
        told.energy = EnergyResult::default();
        let at = self.at(self.acting(state), &state.conducting);
        let heat = self.running.heat(at, &state.pressure)?;
        let mut result = self.running.tell(operator, found, &heat, told)?;
        result.in_time = Some(HeatInTime::QuasiSteady);
        result.jumps = Some(state.jumps).filter(|jumps| *jumps > 0);
        let closed: Vec<bool> = state.pressure.iter().map(|p| *p > 0.0).collect();
        let speeds = self.running.speeds(operator, at, &closed)?;
        let other = before.last().map(|level| SpeedFactors { singular: level.singular.clone(), ..SpeedFactors::default() });
        result.take_speeds(&speeds, other.as_ref().map(|other| (other, MESHES_ALIKE)));
        Ok(ToldHeat { result, heat, singular: speeds.factors.singular })
    }

    /// Columns of history.csv: the highest temperature of each body under the heat of every state. Materials that are too hot in one of them are told.
    pub(super) fn on_the_way(&self, states: &[WearState], told: &mut HeatResult) -> Result<Vec<(String, Vec<f64>)>, Fault> {
        let heats = states
            .iter()
            .map(|state| self.running.heat(self.at(self.acting(state), &state.conducting), &state.pressure))
            .collect::<Result<Vec<PointHeat>, Fault>>()?;
        told.too_hot = self.running.too_hot(&heats)?;
        let names = ["T1_max_degC", "T2_max_degC"];
        let highest = self.running.highest(&heats)?;
        Ok(names.into_iter().zip(highest).filter_map(|(name, values)| Some((name.to_string(), values?))).collect())
    }
}
