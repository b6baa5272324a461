//! The contact of a stage: pressure, opening and rigid coordinates.

use crate::wear_state::WearState;

/// Pressure, opening and coordinates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Contact {
    pub(crate) pressure: Vec<f64>,
    pub(crate) opening: Vec<f64>,
    pub(crate) coordinates: Vec<f64>,
}

impl Contact {
    /// The contact of a state.
    pub(crate) fn of(state: &WearState) -> Contact {
        Contact { pressure: state.pressure.clone(), opening: state.opening.clone(), coordinates: state.coordinates.clone() }
    }
}
