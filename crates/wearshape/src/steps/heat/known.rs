//! Bodies bent by a known heat: one thermal load a body, with the factor 1.

use contact::Pair;
use hpfem::{Eigenstrain, LoadCase};
use scene::Fault;

use crate::bodies::Reduced;
use crate::parts::Parts;
use crate::steps::heat::warmed::{Second, Warmed, no_field};

/// The load case of the temperature, or of the part of it that flows without friction.
pub(crate) const HEAT: &str = "heat";

/// Heat at the contact points.
#[derive(Clone, Debug, Default)]
pub(crate) struct PointHeat {
    /// Of friction (mW).
    pub friction: Vec<f64>,
    /// Into each body (mW).
    pub into: [Vec<f64>; 2],
}

/// Factors of the load cases of both bodies: those that are no heat's, 1 for the temperature of bodies that have one, and 0 for what may be beyond it.
pub(crate) fn with_heat(pair: &Pair<'_>, [mut shaped, mut counter]: [Vec<f64>; 2]) -> [Vec<f64>; 2] {
    let add = |factors: &mut Vec<f64>, body: &hpfem::InterfaceOperator| {
        if body.load_cases.iter().any(|case| case == HEAT) {
            factors.push(1.0);
            factors.resize(body.load_cases.len(), 0.0);
        }
    };
    add(&mut shaped, pair.shaped);
    if let Some(body) = pair.counter {
        add(&mut counter, body);
    }
    [shaped, counter]
}

/// The bodies with the load of their temperature under heat at the contact points.
pub(crate) fn under(warmed: &Warmed<'_>, parts: Parts, heat: &PointHeat) -> Result<Parts, Fault> {
    let states = warmed.states(&warmed.pair()?, &heat.into);
    let reference = warmed.heat.reference;
    let mut loads = [Vec::new(), Vec::new()];
    for (number, field) in warmed.fields(&states)?.into_iter().enumerate() {
        let strain = match (field, &warmed.second) {
            (Some(field), _) => Some(Eigenstrain::of_temperature(&warmed.expansion(number), field, reference).map_err(no_field)?),
            (None, Second::Drum(drum)) => Some(drum.strain(heat.into[1].iter().sum(), reference)),
            (None, Second::Body(_) | Second::Fresh(_)) => None,
        };
        loads[number].extend(strain.map(|strain| LoadCase::new(HEAT).with(strain)));
    }
    Ok(parts.with_loads(loads))
}

/// Refuses bodies whose contact points are not those of their temperature.
pub(crate) fn same_points(reduced: &Reduced, points: &[contact::ContactPoint]) -> Result<(), Fault> {
    let pair = reduced.pair()?;
    let own = pair.points();
    let length = pair.trace().length();
    let same = own.len() == points.len() && own.iter().zip(points).all(|(a, b)| (a.arc - b.arc).abs() <= 1e-9 * length);
    if same {
        return Ok(());
    }
    let message = "frictional heat of bodies with contact points of unlike degrees is not available";
    Err(Fault::at("heat", "not-available", message, "give both bodies alike cells at the contact, or remove `heat`"))
}
