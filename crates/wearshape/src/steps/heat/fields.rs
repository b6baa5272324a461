//! Temperature inside the bodies, beside their displacement and stress.

use contact::Pair;
use hpfem::Field;
use scene::Fault;

use crate::body_field::FieldFrame;
use crate::parts::Parts;
use crate::stage::Stage;
use crate::steps::heat::drum::WarmDrum;
use crate::steps::heat::known::{under, with_heat};
use crate::steps::heat::warmed::{Second, Warmed, no_field};
use crate::steps::reported::{Moment, Reported};

/// Temperature of a body.
enum Inside {
    Field(Box<Field>),
    /// Of a ring that turns, under the heat into it (mW).
    Drum(Box<WarmDrum>, f64),
    Even(f64),
}

/// Temperatures of both bodies.
pub(crate) struct Warm([Inside; 2]);

impl Warm {
    /// Temperatures of what is reported, and the bodies with their load; none of a scene without heat, whose bodies stay as they are.
    pub(crate) fn of(stage: Stage<'_>, reported: &Reported, parts: Parts) -> Result<(Parts, Option<Warm>), Fault> {
        let Some(heat) = &reported.heat else { return Ok((parts, None)) };
        let Some(warmed) = Warmed::new(stage, &parts)? else { return Ok((parts, None)) };
        let parts = under(&warmed, parts, heat)?;
        let states = warmed.states(&warmed.pair()?, &heat.into);
        let [first, second] = warmed.fields(&states)?;
        let Some(first) = first else { return Ok((parts, None)) };
        let second = match (second, warmed.second) {
            (Some(field), _) => Inside::Field(Box::new(field)),
            (None, Second::Drum(drum)) => Inside::Drum(drum, heat.into[1].iter().sum()),
            (None, Second::Fresh(temperature)) => Inside::Even(temperature),
            (None, Second::Body(_)) => return Ok((parts, None)),
        };
        Ok((parts, Some(Warm([Inside::Field(Box::new(first)), second]))))
    }

    /// Problems of temperature that were factorised.
    pub(crate) fn factorisations(&self) -> usize {
        self.0.iter().filter(|inside| matches!(inside, Inside::Field(_))).count()
    }

    /// Temperature of a body at a place of a cell.
    pub(crate) fn at(&self, body: usize, (cell, xi, eta): (usize, f64, f64), x: [f64; 2]) -> Result<f64, Fault> {
        match &self.0[body] {
            Inside::Field(field) => Ok(field.at(cell, xi, eta).map_err(no_field)?.displacement[0]),
            Inside::Drum(drum, heat) => Ok(drum.at(*heat, x)),
            Inside::Even(temperature) => Ok(*temperature),
        }
    }

    /// Fills in the temperatures at the points of the cells.
    pub(crate) fn fill(&self, frame: &mut FieldFrame) -> Result<(), Fault> {
        for (body, inside) in frame.bodies.iter_mut().zip(&self.0) {
            for (number, cell) in body.cells.iter_mut().enumerate() {
                cell.temperature = match inside {
                    Inside::Field(field) => {
                        let at = |[xi, eta]: [f64; 2]| field.at(number, xi, eta).map(|state| state.displacement[0]);
                        cell.grid.reference().map(at).collect::<Result<_, _>>().map_err(no_field)?
                    }
                    Inside::Drum(drum, heat) => cell.position.iter().map(|x| drum.at(*heat, *x)).collect(),
                    Inside::Even(temperature) => vec![*temperature; cell.position.len()],
                };
            }
        }
        Ok(())
    }
}

/// A moment with its heat as one load of each body.
pub(crate) fn with_known_heat(stage: Stage<'_>, pair: &Pair<'_>, moment: &Moment) -> Moment {
    let [shaped, counter] = with_heat(pair, stage.cases());
    let mut states = moment.states.clone();
    states[0].factors = pair.shaped.factors_in_order(&shaped);
    if let Some(body) = pair.counter {
        states[1].factors = body.factors_in_order(&counter);
    }
    Moment { time: moment.time, name: moment.name, states, around: moment.around.clone() }
}
