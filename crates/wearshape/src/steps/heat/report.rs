//! What is told of frictional heat: temperatures, heat and thermal displacement along the contact, and the balance of the powers.

use contact::{ContactPoint, Pair, Side};
use hpfem::{Field, InterfaceState};
use scene::Fault;
use shapeopt::{Gauge, Integration, RigidPart, Shape, ShapeProblem, solve_shape};

use crate::heat_result::{HeatResult, TooHot};
use crate::profile::Profile;
use crate::stage::Stage;
use crate::steps::answer::Told;
use crate::steps::heat::boundary::on_edges;
use crate::steps::heat::known::PointHeat;
use crate::steps::heat::warmed::{Second, Warmed, no_field};

/// Fills in the columns of heat and gives its numbers.
pub(crate) fn tell(warmed: &Warmed<'_>, heat: &PointHeat, told: &mut Told, thermal: &Thermal<'_>) -> Result<HeatResult, Fault> {
    let warm_pair = warmed.pair()?;
    let states = warmed.states(&warm_pair, &heat.into);
    let expanded = thermal.state()?;
    let points = warm_pair.points();
    let total: f64 = heat.into[1].iter().sum();
    let start = warmed.stage.start(&warm_pair);
    for profile in [&mut told.profile, &mut told.curve] {
        let rows: Vec<ContactPoint> =
            profile.s.iter().map(|s| warm_pair.at_arc((s - start).clamp(0.0, warm_pair.trace().length()))).collect();
        for (number, side) in [Side::Shaped, Side::Counter].into_iter().enumerate() {
            let flux: Vec<f64> = heat.into[number].iter().zip(&points).map(|(heat, point)| heat / point.weight).collect();
            profile.heat[number] = rows.iter().map(|row| warm_pair.closed_value_at(&points, &flux, row.arc)).collect();
            let temperature = |row: &ContactPoint| match (&states[number], &warmed.second) {
                (Some(state), _) => warm_pair.potential(side, state, row),
                (None, Second::Drum(drum)) => drum.at(total, row.position),
                (None, Second::Fresh(temperature)) => *temperature,
                (None, Second::Body(_)) => f64::NAN,
            };
            profile.temperature[number] = rows.iter().map(temperature).collect();
            profile.thermal_displacement[number] = thermal.displacement(&expanded, side, profile, start);
        }
    }
    let fields = warmed.fields(&states)?;
    let mut result = powers(warmed, heat, &states, &fields)?;
    result.too_hot = too_hot(warmed, &fields, total)?;
    let [first, second] = fields.map(|field| field.map(|field| highest(&field, &|_| true)).transpose());
    let first = first?.map(|found| at_contact(found, &told.profile, 0));
    let second = second?.map(|found| at_contact(found, &told.profile, 1));
    let second = match &warmed.second {
        Second::Drum(drum) => Some(drum.highest(total)),
        Second::Body(_) | Second::Fresh(_) => second,
    };
    (result.highest1, result.highest1_at) = first.unzip();
    (result.highest2, result.highest2_at) = second.unzip();
    Ok(result)
}

/// The higher one of a temperature with its place and the highest at the contact points, which stand closer than those of the cells.
fn at_contact(found: (f64, [f64; 2]), profile: &Profile, number: usize) -> (f64, [f64; 2]) {
    let temperatures = profile.temperature[number].iter().zip(&profile.position);
    temperatures.fold(found, |most, (t, [x, _, z])| if *t > most.0 { (*t, [*x, *z]) } else { most })
}

/// Friction power, where it goes, and what of it is left over.
fn powers(
    warmed: &Warmed<'_>,
    heat: &PointHeat,
    states: &[Option<InterfaceState>; 2],
    fields: &[Option<Field>; 2],
) -> Result<HeatResult, Fault> {
    let sum = |values: &[f64]| values.iter().sum::<f64>();
    let (friction_power, into) = (sum(&heat.friction), heat.into.each_ref().map(|into| sum(into)));
    let mut out = Vec::new();
    for number in [0, 1] {
        let known = warmed.conduction(number).zip(states[number].as_ref()).zip(fields[number].as_ref());
        match (known, &warmed.second) {
            (Some(((body, state), field)), _) => out.extend(body.out(state, field).map_err(no_field)?),
            (None, Second::Drum(drum)) => out.extend(drum.out(into[1])),
            (None, Second::Fresh(_)) => out.push(("body2".to_string(), into[1])),
            (None, Second::Body(_)) => {}
        }
    }
    let left = friction_power - out.iter().map(|(_, heat)| heat).sum::<f64>();
    let size = out.iter().map(|(_, heat)| heat.abs()).fold(friction_power.abs(), f64::max);
    Ok(HeatResult {
        friction_power,
        into_body1: into[0],
        into_body2: into[1],
        out,
        balance: (size > 0.0).then(|| left.abs() / size),
        ..HeatResult::default()
    })
}

/// Whether a material has a temperature that it bears.
pub(crate) fn has_limits(warmed: &Warmed<'_>) -> bool {
    let limited = |body: &meshing::Body| body.materials.iter().any(|material| material.temperature_limit.is_some());
    warmed.stage.couple.bodies.iter().any(limited)
}

/// Materials that are hotter than they bear under heat at the contact points.
pub(crate) fn too_hot_under(warmed: &Warmed<'_>, heat: &PointHeat) -> Result<Vec<TooHot>, Fault> {
    let states = warmed.states(&warmed.pair()?, &heat.into);
    too_hot(warmed, &warmed.fields(&states)?, heat.into[1].iter().sum())
}

/// Materials that are hotter than they bear.
fn too_hot(warmed: &Warmed<'_>, fields: &[Option<Field>; 2], into_drum: f64) -> Result<Vec<TooHot>, Fault> {
    let mut found = Vec::new();
    for (number, field) in fields.iter().enumerate() {
        for (index, material) in warmed.stage.couple.bodies[number].materials.iter().enumerate() {
            let Some(limit) = material.temperature_limit else { continue };
            let temperature = match (field, &warmed.second) {
                (Some(field), _) => highest(field, &|own| own == index)?.0,
                (None, Second::Drum(drum)) => drum.highest(into_drum).0,
                (None, Second::Fresh(_) | Second::Body(_)) => continue,
            };
            if temperature > limit.0 {
                found.push(TooHot { body: number + 1, temperature, limit: limit.0 });
            }
        }
    }
    Ok(found)
}

/// The highest temperature of the materials asked for at the points of their cells, and its place: heat comes in through edges alone, so that they are
/// hottest at one of their own.
fn highest(field: &Field, of: &dyn Fn(usize) -> bool) -> Result<(f64, [f64; 2]), Fault> {
    let mut found = (f64::NEG_INFINITY, [0.0; 2]);
    for (cell, [xi, eta]) in on_edges(field, of) {
        let temperature = field.at(cell, xi, eta).map_err(no_field)?.displacement[0];
        if temperature > found.0 {
            found = (temperature, field.position(cell, xi, eta));
        }
    }
    Ok(found)
}

/// The bodies under their thermal loads alone.
pub(crate) struct Thermal<'a> {
    pub stage: Stage<'a>,
    pub pair: &'a Pair<'a>,
    /// Factors of the load cases of body 1 and 2, those of heat alone.
    pub factors: [Vec<f64>; 2],
}

impl Thermal<'_> {
    /// Both bodies free of all other loads, rigid coordinates of body 1 at zero as where it is loaded.
    fn state(&self) -> Result<Shape, Fault> {
        let gauge = match self.stage.gauge(self.pair) {
            Gauge::LoadedEdge(mut edge) => {
                edge.motions = edge.motions.map(|motion| match motion {
                    contact::Motion::Prescribed { .. } => contact::Motion::Prescribed { value: 0.0 },
                    contact::Motion::Free { .. } | contact::Motion::Sprung { .. } => contact::Motion::FREE,
                });
                Gauge::LoadedEdge(edge)
            }
            other => other,
        };
        solve_shape(&ShapeProblem {
            pair: *self.pair,
            traction: &|_| [0.0; 2],
            cases_shaped: &self.factors[0],
            cases_counter: &self.factors[1],
            gauge,
            rigid: RigidPart::Prescribed(Vec::new()),
            integration: Integration::Lobatto,
        })
        .map_err(|error| Fault::at("heat", "no-shape", error.to_string(), "check the bodies"))
    }

    /// Normal displacement of a side at the rows of a profile (um).
    fn displacement(&self, state: &Shape, side: Side, profile: &Profile, start: f64) -> Vec<f64> {
        let length = self.pair.trace().length();
        let at = |s: &f64| state.displacement(self.pair, side, &self.pair.at_arc((s - start).clamp(0.0, length)))[0];
        profile.s.iter().map(|s| 1e3 * at(s)).collect()
    }
}
