//! What the columns of a contact say of loads that act by turns: both pressures of a motion to and fro, and the mean wear rate.

use crate::profile::Profile;
use crate::stage::Stage;

/// A load that acts part of the time: its stage, its share of the time, and its pressure (MPa) at the places of a profile.
pub(super) struct Turn<'a> {
    pub stage: Stage<'a>,
    pub share: f64,
    pub pressure: Vec<f64>,
}

/// Fills in the second pressure of two, and the mean wear rate; the first pressure is there. One load leaves a profile as it is.
pub(super) fn fill(profile: &mut Profile, turns: &[Turn<'_>]) {
    if turns.len() < 2 {
        return;
    }
    if let [_, second] = turns {
        profile.pressure_back.clone_from(&second.pressure);
    }
    for row in 0..profile.s.len() {
        let ([x, _, z], [nx, _, nz]) = (profile.position[row], profile.normal[row]);
        let rate = |turn: &Turn<'_>| {
            let speed = turn.stage.surface_point([x, z], [nx, nz], 0.0).sliding_speed;
            turn.stage.problem.wear.rate(turn.pressure[row], speed).map(|rate| turn.share * rate)
        };
        if let Some(rate) = turns.iter().map(rate).sum::<Option<f64>>() {
            profile.wear_rate[row] = 1e3 * rate;
        }
    }
}
