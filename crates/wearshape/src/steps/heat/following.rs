//! Bodies bent by the heat of a pressure that is yet to be found: one thermal load for each contact point, whose factor follows the force there.

use std::sync::Arc;

use contact::faer::Mat;
use contact::{ContactLoad, ContactOperator, ContactSolution, SharedHeat, SpeedFactors};
use hpfem::{Eigenstrain, InterfaceState, LoadCase};
use meshing::Cut;
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::heat::Split;
use crate::level::Level;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::heat::known::{HEAT, PointHeat, same_points};
use crate::steps::heat::warmed::{Second, Surfaces, Warmed, into_bodies, no_field};

/// Contact solves until the points that conduct are those in contact, and how many of them in which points may begin to conduct.
const ROUNDS: usize = 60;
const FREE: usize = 10;

/// Steps of the sliding speed from the cold bodies to the hot ones.
const STEPS: u32 = 16;

/// What of a body's temperature follows the pressure.
pub(crate) enum Follows {
    /// The heat at each point by itself.
    Each,
    /// All of it alike.
    Sum,
    /// Nothing: it is not distorted.
    Nothing,
}

/// Bodies bent by heat that follows the pressure.
pub(crate) struct Following<'a> {
    pub reduced: Arc<Reduced>,
    /// The bodies as problems of temperature.
    pub warmed: Warmed<'a>,
    pub(super) surfaces: Surfaces,
    pub(super) follows: [Follows; 2],
}

/// A contact with its heat.
pub(crate) struct Hot {
    pub found: ContactSolution,
    pub heat: PointHeat,
    /// The load of the last solve.
    pub load: ContactLoad,
    /// The part of the sliding speed up to which the contact of the cold bodies does not last; none where there is an answer.
    pub lost_at: Option<f64>,
}

impl<'a> Following<'a> {
    /// Bodies of a level; none of a scene without heat.
    pub(crate) fn new(stage: Stage<'a>, level: Level, cut: Cut<'_>) -> Result<Option<(Following<'a>, Effort)>, Fault> {
        if stage.problem.heat.is_none() {
            return Ok(None);
        }
        let (parts, mut effort) = stage.parts(level, cut)?;
        (stage.options.begun)(Step::Heat);
        let start = stage.clock()();
        let Some(warmed) = Warmed::new(stage, &parts, level)? else { return Ok(None) };
        let surfaces = warmed.surfaces(&warmed.pair()?)?;
        let loads = [loads(&warmed, &surfaces, 0)?, loads(&warmed, &surfaces, 1)?];
        let follows = [
            Follows::Each,
            match warmed.second {
                Second::Body(_) => Follows::Each,
                Second::Drum(_) => Follows::Sum,
                Second::Fresh(_) => Follows::Nothing,
            },
        ];
        effort.add_seconds(Step::Heat, stage.clock()() - start);
        (stage.options.begun)(Step::Factor);
        let (reduced, work) = Reduced::new(&parts.with_loads(loads), stage.clock())?;
        effort += work;
        same_points(&reduced, &surfaces.points)?;
        Ok(Some((Following { reduced: Arc::new(reduced), warmed, surfaces, follows }, effort)))
    }

    /// The contact of the bodies, pressure and temperature at once: `base` holds the load without heat. What is not found so is followed from the
    /// contact of the cold bodies on, the sliding speed growing.
    pub(crate) fn solve(&self, operator: &ContactOperator<'_>, gap: &[f64], base: &ContactLoad) -> Result<Hot, Fault> {
        let at_once = self.settled(operator, gap, base, 1.0, None)?;
        if at_once.found.status.is_solved() {
            return Ok(at_once);
        }
        let mut found: Option<ContactSolution> = None;
        for step in 1..=STEPS {
            let speed = f64::from(step) / f64::from(STEPS);
            let hot = self.settled(operator, gap, base, speed, found.as_ref())?;
            if !hot.found.status.is_solved() {
                return Ok(Hot { lost_at: Some(speed), ..at_once });
            }
            if step == STEPS {
                return Ok(hot);
            }
            found = Some(hot.found);
        }
        Ok(at_once)
    }

    /// The contact at a factor on the sliding speed, from a contact that is near.
    fn settled(
        &self,
        operator: &ContactOperator<'_>,
        gap: &[f64],
        base: &ContactLoad,
        speed: f64,
        near: Option<&ContactSolution>,
    ) -> Result<Hot, Fault> {
        let mut closed = near.map_or_else(|| vec![true; gap.len()], |near| near.closed.clone());
        let mut last: Option<ContactSolution> = near.cloned();
        for round in 0..ROUNDS {
            let shared = self.shared(&closed)?;
            let rates: Vec<f64> = self.surfaces.rates.iter().map(|rate| speed * rate).collect();
            let load = self.load(base, &shared, &rates);
            let found = operator.solve(gap, &load, last.as_ref()).map_err(unsolved)?;
            // A point at an end of contact may open because it conducts and close because it does not: such points do not conduct.
            let late = round >= FREE && closed.iter().zip(&found.closed).all(|(conducts, closed)| *closed || !conducts);
            if late || found.closed == closed || !self.conducts() || !found.status.is_solved() {
                let friction: Vec<f64> =
                    rates.iter().zip(&found.nodal_force).map(|(rate, force)| rate * force.max(0.0)).collect();
                let into = into_bodies(&shared, &friction);
                return Ok(Hot { heat: PointHeat { friction, into }, found, load, lost_at: None });
            }
            let kept = |(conducts, closed): (&bool, &bool)| *closed && (round < FREE || *conducts);
            closed = closed.iter().zip(&found.closed).map(kept).collect();
            last = Some(found);
        }
        let message = "the points that conduct heat and those in contact do not settle on each other";
        Err(Fault::at("heat.conductance", "not-converged", message, "give heat.share, or another gap"))
    }

    /// Factors on the sliding speed for points in contact; that of separation is for surfaces without a gap, whose points all are.
    pub(crate) fn speeds(
        &self,
        operator: &ContactOperator<'_>,
        base: &ContactLoad,
        closed: &[bool],
    ) -> Result<SpeedFactors, Fault> {
        self.speeds_at(operator, base, &self.surfaces.rates, closed)
    }

    /// The same where normal forces make heat at other rates (mm/s).
    pub(super) fn speeds_at(
        &self,
        operator: &ContactOperator<'_>,
        base: &ContactLoad,
        rates: &[f64],
        closed: &[bool],
    ) -> Result<SpeedFactors, Fault> {
        let factors = |closed: &[bool]| {
            let mut load = self.load(base, &self.shared(closed)?, rates);
            // Bodies without any heat fit.
            load.factors.iter_mut().zip(&base.factors).for_each(|(factors, base)| factors[base.len()..].fill(0.0));
            operator.speed_factors(&load, closed).map_err(unsolved)
        };
        let all = factors(&vec![true; closed.len()])?;
        if closed.iter().all(|closed| *closed) {
            return Ok(all);
        }
        Ok(SpeedFactors { separation: all.separation, ..factors(closed)? })
    }

    /// Whether what points are in contact decides how the heat is shared.
    fn conducts(&self) -> bool {
        matches!(self.warmed.heat.split, Split::Conductance(_))
    }

    pub(super) fn shared(&self, closed: &[bool]) -> Result<SharedHeat, Fault> {
        self.surfaces.shared(self.warmed.heat, closed)
    }

    /// A load with that of the heat that normal forces make at these rates (mm/s).
    pub(super) fn load(&self, base: &ContactLoad, shared: &SharedHeat, rates: &[f64]) -> ContactLoad {
        let mut load = base.clone();
        let n = self.surfaces.points.len();
        for (body, follows) in self.follows.iter().enumerate() {
            let cases = load.factors[body].len();
            let by_force = |i: usize, j: usize| shared.into[body][(i, j)] * rates[j];
            let still = &shared.still[body];
            let (factors, rows) = match follows {
                Follows::Each => (still.clone(), Mat::from_fn(n, n, by_force)),
                Follows::Sum => {
                    (vec![still.iter().sum()], Mat::from_fn(1, n, |_, j| (0..n).map(|i| by_force(i, j)).sum::<f64>()))
                }
                Follows::Nothing => continue,
            };
            load.factors[body].push(1.0);
            load.factors[body].extend(factors);
            let following =
                Mat::from_fn(cases + 1 + rows.nrows(), n, |i, j| if i > cases { rows[(i - cases - 1, j)] } else { 0.0 });
            load.following[body] = Some(following);
        }
        load
    }
}

/// Why there is no contact, where that of the cold bodies lasts up to a part of the sliding speed alone.
pub(super) fn lost(speed: f64) -> String {
    let part = scene::short(speed);
    let what = "frictional heat narrows the contact until no pressure carries the load";
    format!("{what}: the contact of the cold bodies does not last to {part} of the sliding speed; slide more slowly")
}

/// Thermal loads of a body: of what flows without friction, then of each unit of heat.
fn loads(warmed: &Warmed<'_>, surfaces: &Surfaces, number: usize) -> Result<Vec<LoadCase>, Fault> {
    let reference = warmed.heat.reference;
    let named = |k: usize, strain: Eigenstrain| LoadCase::new(format!("{HEAT} {k}")).with(strain);
    let (conduction, units) = match (warmed.conduction(number).zip(surfaces.units[number].as_ref()), &warmed.second) {
        (Some(found), _) => found,
        (None, Second::Drum(drum)) => {
            return Ok(vec![LoadCase::new(HEAT).with(drum.strain(0.0, reference)), named(0, drum.unit_strain())]);
        }
        (None, Second::Body(_) | Second::Fresh(_)) => return Ok(Vec::new()),
    };
    let body = &conduction.body;
    let still = warmed.states(&warmed.pair()?, &[vec![0.0; surfaces.points.len()], vec![0.0; surfaces.points.len()]]);
    let columns = body.interface.columns.ncols();
    let mut states: Vec<InterfaceState> = still[number].iter().cloned().collect();
    states.extend((0..units.ncols()).map(|j| InterfaceState {
        unknowns: units.col(j).iter().copied().collect(),
        factors: vec![0.0; columns],
        load: hpfem::TraceLoad::default(),
    }));
    let expansion = warmed.expansion(number);
    let fields = body.fields(&states).map_err(no_field)?;
    let strain = |(k, field): (usize, hpfem::Field)| -> Result<LoadCase, Fault> {
        let above = if k == 0 { reference } else { 0.0 };
        let strain = Eigenstrain::of_temperature(&expansion, field, above).map_err(no_field)?;
        Ok(if k == 0 { LoadCase::new(HEAT).with(strain) } else { named(k - 1, strain) })
    };
    fields.into_iter().enumerate().map(strain).collect()
}
