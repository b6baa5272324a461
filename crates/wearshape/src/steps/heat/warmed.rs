//! Both bodies of a level as problems of temperature, and what heat at the contact points does to them.

use contact::faer::Mat;
use contact::{ContactPoint, HeatSplit, HeatedSurface, Pair, SharedHeat, Side, share_heat, share_known_heat};
use hpfem::{Field, InterfaceState};
use scene::Fault;

use crate::faults::unsolved;
use crate::heat::{Heat, Meets, Split};
use crate::parts::Parts;
use crate::stage::Stage;
use crate::steps::heat::conduction::Conduction;
use crate::steps::heat::drum::WarmDrum;
use crate::steps::heat::smooth::{Smooth, smooth};

/// Body 2 as far as heat knows it.
pub(crate) enum Second {
    /// By its own temperature.
    Body(Box<Conduction>),
    /// A ring that turns.
    Drum(Box<WarmDrum>),
    /// At one temperature.
    Fresh(f64),
}

/// Both bodies of a level as problems of temperature.
pub(crate) struct Warmed<'a> {
    pub stage: Stage<'a>,
    pub heat: &'a Heat,
    /// Body 1.
    pub first: Box<Conduction>,
    /// Body 2.
    pub second: Second,
}

/// What heat at the contact points does.
pub(crate) struct Surfaces {
    /// The contact points.
    pub points: Vec<ContactPoint>,
    /// Kept unknowns of body 1 and 2 by a unit of heat at each point; none of a ring or a fresh body.
    pub units: [Option<Mat<f64>>; 2],
    /// Temperatures of both surfaces.
    pub surfaces: [HeatedSurface; 2],
    /// Friction power by the normal force at each point, `mu v` (mm/s).
    pub rates: Vec<f64>,
}

impl<'a> Warmed<'a> {
    /// Both bodies on the meshes of their displacement; none of a scene without heat.
    pub(crate) fn new(stage: Stage<'a>, parts: &Parts) -> Result<Option<Warmed<'a>>, Fault> {
        let Some(heat) = &stage.problem.heat else { return Ok(None) };
        let body = |number: usize| Conduction::new(stage, heat, number, &parts.parts[number]).map(Box::new);
        let first = body(0)?;
        let second = match heat.meets {
            Meets::Congruent => Second::Body(body(1)?),
            Meets::Revolving(drum) => {
                let arc = first.body.interface.trace.length();
                Second::Drum(Box::new(WarmDrum::new(stage, heat, drum, arc)?))
            }
            Meets::Fresh(temperature) => Second::Fresh(temperature),
        };
        Ok(Some(Warmed { stage, heat, first, second }))
    }

    /// The surfaces of both bodies, where body 2 has a temperature field of its own; else that of body 1.
    pub(crate) fn pair(&self) -> Result<Pair<'_>, Fault> {
        let second = match &self.second {
            Second::Body(body) => Some(&body.body.interface),
            Second::Drum(_) | Second::Fresh(_) => None,
        };
        let pair = Pair::new(&self.first.body.interface, second).map_err(unsolved)?;
        if pair.is_nodal() {
            return Ok(pair);
        }
        let message = "frictional heat of bodies whose break points on the contact surface differ is not available";
        Err(Fault::at("heat", "not-available", message, "give both bodies the same break points there, or remove `heat`"))
    }

    /// The temperature problem of a body, where it has one.
    pub(crate) fn conduction(&self, number: usize) -> Option<&Conduction> {
        match (number, &self.second) {
            (0, _) => Some(&self.first),
            (_, Second::Body(body)) => Some(body),
            (_, Second::Drum(_) | Second::Fresh(_)) => None,
        }
    }

    /// Problems of temperature that were factorised.
    pub(crate) fn factorisations(&self) -> usize {
        [0, 1].into_iter().filter(|number| self.conduction(*number).is_some()).count()
    }

    /// What heat at the contact points does.
    pub(crate) fn surfaces(&self, pair: &Pair<'_>) -> Result<Surfaces, Fault> {
        let points = pair.points();
        let (mut units, mut surfaces) = ([None, None], Vec::new());
        for (number, side) in [Side::Shaped, Side::Counter].into_iter().enumerate() {
            match (self.conduction(number), &self.second) {
                (Some(_), _) => {
                    let unit = pair.unit_heats(side).map_err(|error| uncooled(number, error))?;
                    let still = pair.heated(side, &vec![0.0; points.len()], &[1.0]);
                    surfaces.extend(still.map(|still| pair.heated_surface(side, &unit, &still)));
                    units[number] = Some(unit);
                }
                (None, Second::Drum(drum)) => {
                    let [still, slope] = drum.surface();
                    surfaces.push(HeatedSurface::even(points.len(), still, slope));
                }
                (None, Second::Fresh(temperature)) => surfaces.push(HeatedSurface::even(points.len(), *temperature, 0.0)),
                (None, Second::Body(_)) => {}
            }
        }
        let surfaces = <[HeatedSurface; 2]>::try_from(surfaces).map_err(|_| unsolved(contact::Error::Singular))?;
        let rates = rates(self.stage, &points);
        Ok(Surfaces { points, units, surfaces, rates })
    }

    /// States of the bodies with a temperature field under heat into each body at the contact points (mW).
    pub(crate) fn states(&self, pair: &Pair<'_>, heats: &[Vec<f64>; 2]) -> [Option<InterfaceState>; 2] {
        [Side::Shaped, Side::Counter].map(|side| pair.heated(side, &heats[side as usize], &[1.0]))
    }

    /// Temperature fields of bodies that have one.
    pub(crate) fn fields(&self, states: &[Option<InterfaceState>; 2]) -> Result<[Option<Field>; 2], Fault> {
        let field = |number: usize| -> Result<Option<Field>, Fault> {
            let Some((body, state)) = self.conduction(number).zip(states[number].as_ref()) else { return Ok(None) };
            body.body.field(state).map(Some).map_err(no_field)
        };
        Ok([field(0)?, field(1)?])
    }

    /// Thermal expansion of the materials of a body (1/K).
    pub(crate) fn expansion(&self, number: usize) -> Vec<f64> {
        self.stage.couple.bodies[number].materials.iter().map(|m| m.expansion.map_or(0.0, |alpha| alpha.0)).collect()
    }
}

/// A body that loses no heat anywhere.
fn uncooled(number: usize, error: contact::Error) -> Fault {
    if !matches!(error, contact::Error::NotHeld { .. }) {
        return unsolved(error);
    }
    let body = format!("body{}", number + 1);
    let message = format!("nothing cools {body} outside of the contact, so that it has no steady temperature");
    Fault::at(
        format!("{body}.heat"),
        "no-temperature",
        message,
        "give a temperature or convection on an edge that does not touch",
    )
}

/// A temperature that cannot be recovered.
pub(crate) fn no_field(error: hpfem::Error) -> Fault {
    Fault::at("heat", "no-temperature", error.to_string(), "check the bodies and what carries their heat")
}

/// Friction power by the normal force at each point, `mu v` (mm/s).
fn rates(stage: Stage<'_>, points: &[ContactPoint]) -> Vec<f64> {
    let speed = |point: &ContactPoint| stage.surface_point(point.position, point.normal, 0.0).sliding_speed;
    points.iter().map(|point| stage.problem.friction.coefficient * speed(point)).collect()
}

impl Surfaces {
    /// Friction power by the normal force at each point under another load and speed (mm/s).
    pub(crate) fn rates_of(&self, stage: Stage<'_>) -> Vec<f64> {
        rates(stage, &self.points)
    }

    /// How frictional heat at the points goes into the bodies, of which the closed ones conduct.
    pub(crate) fn shared(&self, heat: &Heat, closed: &[bool]) -> Result<SharedHeat, Fault> {
        share_heat(self.surfaces.each_ref(), &self.weights(), closed, split_of(heat)).map_err(no_resistance)
    }

    /// Heat into each body at the points (mW) by a frictional heat that is known there.
    pub(crate) fn share(&self, heat: &Heat, closed: &[bool], friction: &[f64]) -> Result<[Vec<f64>; 2], Fault> {
        let asked = (split_of(heat), friction);
        share_known_heat(self.surfaces.each_ref(), &self.weights(), closed, asked).map_err(no_resistance)
    }

    fn weights(&self) -> Vec<f64> {
        self.points.iter().map(|point| point.weight).collect()
    }

    /// Fluxes that are smooth along the surface, a column each.
    pub(crate) fn smooth(&self, wanted: Smooth) -> Mat<f64> {
        let points: Vec<(f64, f64)> = self.points.iter().map(|point| (point.arc, point.weight)).collect();
        smooth(&points, wanted)
    }

    /// Frictional heat at the points (mW) by the normal forces there.
    pub(crate) fn friction(&self, forces: &[f64]) -> Vec<f64> {
        self.rates.iter().zip(forces).map(|(rate, force)| rate * force.max(0.0)).collect()
    }
}

fn split_of(heat: &Heat) -> HeatSplit {
    match heat.split {
        Split::Share(share) => HeatSplit::Share(share),
        Split::Conductance(conductance) => HeatSplit::Conductance(conductance),
    }
}

fn no_resistance(_: contact::Error) -> Fault {
    let message = "both surfaces are held at a temperature where they touch without resistance";
    Fault::at("heat.conductance", "no-temperature", message, "give a finite conductance, or hold other edges")
}

/// Heat into each body at the points (mW) by the frictional heat there.
pub(crate) fn into_bodies(shared: &SharedHeat, friction: &[f64]) -> [Vec<f64>; 2] {
    [0, 1].map(|body| {
        let by_friction = |i: usize| (0..friction.len()).map(|j| shared.into[body][(i, j)] * friction[j]).sum::<f64>();
        (0..friction.len()).map(|i| shared.still[body][i] + by_friction(i)).collect()
    })
}
