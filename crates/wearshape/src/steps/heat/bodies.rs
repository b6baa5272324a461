//! Both bodies of a level, factorised once as problems of temperature and of displacement: what temperatures do to them comes as load cases.

use std::sync::Arc;

use contact::faer::Mat;
use hpfem::{Body, Eigenstrain, InterfaceOperator, InterfaceState, LoadCase, TemperatureCase, TraceLoad};
use meshing::Cut;
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::{Counters, Effort};
use crate::heat::Heat;
use crate::level::Level;
use crate::parts::{BodyHeat, Parts};
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::heat::known::{HEAT, PointHeat, same_points};
use crate::steps::heat::smooth::Smooth;
use crate::steps::heat::warmed::{Second, Surfaces, Warmed, no_field};

/// Both bodies of a level as problems of temperature.
pub(crate) struct Warm<'a> {
    pub bodies: Arc<Warmed<'a>>,
    /// What heat at the contact points does.
    pub surfaces: Arc<Surfaces>,
}

/// Both bodies of a level.
pub(crate) struct HotBodies<'a> {
    /// As problems of temperature.
    pub warm: Warm<'a>,
    parts: Parts,
    /// Without heat, but for strains that were asked for.
    cold: [Body; 2],
    /// The heat that was asked for, and the temperatures of both bodies that it takes.
    asked: Option<(PointHeat, [Temperatures; 2])>,
    counters: Counters,
}

/// Temperatures of a body as load cases.
enum Temperatures {
    /// Of its own temperature field.
    Fields(Vec<TemperatureCase>),
    /// Known at every place.
    Strains(Vec<Eigenstrain>),
}

/// The heat at the contact points of both surfaces.
pub(crate) type HeatOf<'k> = &'k dyn Fn(&Surfaces, &Heat) -> Result<PointHeat, Fault>;

/// What is to be asked of the bodies: less of it takes less.
#[derive(Clone, Copy)]
pub(crate) enum Asked<'k> {
    /// Anything.
    Anything,
    /// One load each, of their temperature under this heat at the contact points.
    Under(HeatOf<'k>),
    /// That load, then one of each flux that is smooth along the surface, or of all heat alike: for heat that is near this one.
    Near(HeatOf<'k>, Smooth),
}

impl Asked<'_> {
    /// The heat, and the temperatures of both bodies that it takes.
    fn known(self, warmed: &Warmed<'_>, surfaces: &Surfaces) -> Result<Option<(PointHeat, [Temperatures; 2])>, Fault> {
        Ok(match self {
            Asked::Anything => None,
            Asked::Under(heat) => {
                let heat = heat(surfaces, warmed.heat)?;
                let known = under(warmed, &heat)?;
                Some((heat, known))
            }
            Asked::Near(heat, wanted) => {
                let heat = heat(surfaces, warmed.heat)?;
                let known = near(warmed, surfaces, &heat, &surfaces.smooth(wanted))?;
                Some((heat, known))
            }
        })
    }
}

impl<'a> HotBodies<'a> {
    /// Bodies of a level; none of a scene without heat.
    pub(crate) fn new(
        stage: Stage<'a>,
        level: Level,
        (cut, asked): (Cut<'_>, Asked<'_>),
    ) -> Result<Option<(HotBodies<'a>, Effort)>, Fault> {
        if stage.problem.heat.is_none() {
            return Ok(None);
        }
        let (parts, mut effort) = stage.parts(level, cut)?;
        (stage.options.begun)(Step::Heat);
        let start = stage.clock()();
        let Some(warmed) = Warmed::new(stage, &parts)? else { return Ok(None) };
        let surfaces = warmed.surfaces(&warmed.pair()?)?;
        let asked = asked.known(&warmed, &surfaces)?;
        effort.add_seconds(Step::Heat, stage.clock()() - start);
        (stage.options.begun)(Step::Factor);
        let heats = [0, 1].map(|number| {
            let known = asked.as_ref().map(|(_, known)| &known[number]);
            if let Some(Temperatures::Strains(strains)) = known.filter(|_| warmed.conduction(number).is_none()) {
                return Some(BodyHeat::Strains(strain_cases(strains)));
            }
            let temperature = &warmed.conduction(number)?.body;
            let known = known.and_then(Temperatures::fields);
            Some(BodyHeat::Field { temperature, known, expansion: warmed.expansion(number) })
        });
        let (cold, work) = parts.reduce_for(heats, stage.clock())?;
        let counters = work.counters.clone();
        effort += work;
        effort.counters.factorisations += warmed.factorisations();
        let warm = Warm { bodies: Arc::new(warmed), surfaces: Arc::new(surfaces) };
        Ok(Some((HotBodies { warm, parts, cold, asked, counters }, effort)))
    }

    /// The heat that was asked for, and the bodies with the loads of what was; none where anything was.
    pub(crate) fn asked(&self) -> Result<Option<(&PointHeat, Reduced)>, Fault> {
        let Some((heat, [first, second])) = &self.asked else { return Ok(None) };
        let of = |number: usize, temperatures: &Temperatures| match temperatures {
            Temperatures::Fields(_) => self.interface(number, temperatures),
            // The bodies were made with them.
            Temperatures::Strains(_) => Ok(self.cold[number].interface.clone()),
        };
        Ok(Some((heat, self.reduced([of(0, first)?, of(1, second)?])?)))
    }

    /// The bodies with a load of what flows without friction, then one of each unit of heat at the contact points, or of all heat alike.
    pub(crate) fn by_units(&self) -> Result<Reduced, Fault> {
        let none = vec![0.0; self.warm.surfaces.points.len()];
        self.with(&about(&self.warm.bodies, &self.warm.surfaces, &[none.clone(), none], Mat::clone)?)
    }

    /// The bodies with a load of their temperature under heat at the contact points, then one of each of these fluxes, a column each at the points.
    #[cfg(test)]
    pub(crate) fn about(&self, heat: &PointHeat, fluxes: &Mat<f64>) -> Result<Reduced, Fault> {
        self.with(&near(&self.warm.bodies, &self.warm.surfaces, heat, fluxes)?)
    }

    /// The reduced bodies with the loads of temperatures.
    fn with(&self, [first, second]: &[Temperatures; 2]) -> Result<Reduced, Fault> {
        self.reduced([self.interface(0, first)?, self.interface(1, second)?])
    }

    fn reduced(&self, interfaces: [InterfaceOperator; 2]) -> Result<Reduced, Fault> {
        let reduced = Reduced::of(&self.parts, interfaces, self.counters.clone());
        same_points(&reduced, &self.warm.surfaces.points)?;
        Ok(reduced)
    }

    fn interface(&self, number: usize, temperatures: &Temperatures) -> Result<InterfaceOperator, Fault> {
        let cold = &self.cold[number];
        match (temperatures, self.warm.bodies.conduction(number)) {
            (Temperatures::Fields(cases), Some(conduction)) => {
                cold.heated(&conduction.body, cases, &self.warm.bodies.expansion(number)).map_err(no_field)
            }
            (Temperatures::Strains(strains), _) if !strains.is_empty() => {
                let mut hot = cold.clone();
                hot.add_loads(strain_cases(strains)).map_err(no_field)?;
                Ok(hot.interface)
            }
            (Temperatures::Fields(_) | Temperatures::Strains(_), _) => Ok(cold.interface.clone()),
        }
    }
}

impl Temperatures {
    /// Those of a temperature field.
    fn fields(&self) -> Option<&[TemperatureCase]> {
        match self {
            Temperatures::Fields(cases) => Some(cases),
            Temperatures::Strains(_) => None,
        }
    }
}

/// Of each body its temperature under heat at the contact points.
fn under(warmed: &Warmed<'_>, heat: &PointHeat) -> Result<[Temperatures; 2], Fault> {
    let reference = warmed.heat.reference;
    let of = |number: usize, state: Option<InterfaceState>| match (state, &warmed.second) {
        (Some(state), _) => Temperatures::Fields(vec![TemperatureCase { name: HEAT.to_string(), state, reference }]),
        (None, Second::Drum(drum)) if number == 1 => {
            Temperatures::Strains(vec![drum.strain(heat.into[1].iter().sum(), reference)])
        }
        (None, _) => Temperatures::Strains(Vec::new()),
    };
    let [first, second] = warmed.states(&warmed.pair()?, &heat.into);
    Ok([of(0, first), of(1, second)])
}

/// The same, then temperatures by each of the fluxes.
fn near(warmed: &Warmed<'_>, surfaces: &Surfaces, heat: &PointHeat, fluxes: &Mat<f64>) -> Result<[Temperatures; 2], Fault> {
    let points = &surfaces.points;
    let heats = Mat::from_fn(points.len(), fluxes.ncols(), |i, k| points[i].weight * fluxes[(i, k)]);
    about(warmed, surfaces, &heat.into, |units| units * &heats)
}

/// Of each body its temperature under heat into it at the contact points, then temperatures made of the ones by unit heats.
fn about(
    warmed: &Warmed<'_>,
    surfaces: &Surfaces,
    into: &[Vec<f64>; 2],
    made_of: impl Fn(&Mat<f64>) -> Mat<f64>,
) -> Result<[Temperatures; 2], Fault> {
    let reference = warmed.heat.reference;
    let of = |number: usize, state: Option<InterfaceState>| match (state, &warmed.second) {
        (Some(state), _) => {
            let further = surfaces.units[number].iter().flat_map(|units| cases(&made_of(units), state.factors.len()));
            let further: Vec<TemperatureCase> = further.collect();
            let first = TemperatureCase { name: HEAT.to_string(), state, reference };
            Temperatures::Fields(std::iter::once(first).chain(further).collect())
        }
        (None, Second::Drum(drum)) if number == 1 => {
            Temperatures::Strains(vec![drum.strain(into[1].iter().sum(), reference), drum.unit_strain()])
        }
        (None, _) => Temperatures::Strains(Vec::new()),
    };
    let [first, second] = warmed.states(&warmed.pair()?, into);
    Ok([of(0, first), of(1, second)])
}

/// Temperatures with these kept unknowns, a column each, of a body of temperature with so many columns of loads.
fn cases(unknowns: &Mat<f64>, loads: usize) -> Vec<TemperatureCase> {
    let case = |k: usize| TemperatureCase {
        name: unit_name(k),
        state: InterfaceState {
            unknowns: unknowns.col_as_slice(k).to_vec(),
            factors: vec![0.0; loads],
            load: TraceLoad::default(),
        },
        reference: 0.0,
    };
    (0..unknowns.ncols()).map(case).collect()
}

/// Load cases of thermal strains, that of the heat, then those of units.
fn strain_cases(strains: &[Eigenstrain]) -> Vec<LoadCase> {
    let name = |k: usize| k.checked_sub(1).map_or(HEAT.to_string(), unit_name);
    strains.iter().enumerate().map(|(k, strain)| LoadCase::new(name(k)).with(strain.clone())).collect()
}

/// Name of the load case of a unit of heat.
fn unit_name(k: usize) -> String {
    format!("{HEAT} {k}")
}
