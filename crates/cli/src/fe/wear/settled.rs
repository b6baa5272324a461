//! What the running-in has cost until the pressure was within 1 % of the steady one.

use shapeopt::{WearState, settling};

use crate::solution::Settled;

/// How close counts as worn in.
const DEVIATION: f64 = 0.01;

/// The states of a run as far as the running-in needs them.
#[derive(Default)]
pub(super) struct RunningIn {
    states: Vec<WearState>,
}

impl RunningIn {
    /// Adds a state.
    pub(super) fn push(&mut self, state: &WearState) {
        self.states.push(WearState {
            time: state.time,
            distance: state.distance,
            depth: state.depth,
            volume: state.volume,
            pressure: state.pressure.clone(),
            ..WearState::default()
        });
    }

    /// The cost of a run that ended steady.
    pub(super) fn cost(&self, weights: &[f64]) -> Option<Settled> {
        settling(&self.states, weights, DEVIATION).map(|found| Settled {
            time_s: found.time,
            distance_mm: found.distance,
            depth_um: 1e3 * found.depth,
            volume_mm3: found.volume[0] + found.volume[1],
        })
    }
}
