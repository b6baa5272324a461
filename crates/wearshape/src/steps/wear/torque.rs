//! The torque of friction step by step, where body 2 turns.

use nalgebra::Vector3;
use shapeopt::{WearProblem, WearState};

use crate::stage::Stage;
use crate::steps::wear::pieces::Pieces;

/// The loads of a run and the wear problem on its contact points.
pub(super) struct Turning<'a> {
    pub stages: &'a [Stage<'a>],
    pub pieces: &'a Pieces,
    pub problem: &'a WearProblem,
}

impl Turning<'_> {
    /// Friction torque about the axis (N mm) in each state, `int mu p v dS / omega`; of loads that act by turns its mean over the time. `None`
    /// where body 2 does not only turn.
    pub(super) fn torques(&self, states: &[WearState]) -> Option<Vec<f64>> {
        let speeds: Option<Vec<f64>> = self.stages.iter().map(angular_velocity).collect();
        let speeds = speeds?;
        Some(states.iter().map(|state| self.torque(state, &speeds)).collect())
    }

    fn torque(&self, state: &WearState, speeds: &[f64]) -> f64 {
        let acting = self.pieces.intervals[state.interval].stage;
        let by_turns = self.pieces.shares.is_some();
        let of = |(k, (pressure, share)): (usize, (&[f64], f64))| {
            let load = if by_turns { k } else { acting };
            let swept: f64 = self.problem.stages[load]
                .speeds
                .iter()
                .zip(&self.problem.points)
                .zip(pressure)
                .map(|((speed, point), pressure)| point.weight * pressure * speed)
                .sum();
            share * self.stages[load].problem.friction.coefficient * swept / speeds[load]
        };
        self.problem.pressures(&state.pressure).enumerate().map(of).sum()
    }
}

/// Angular velocity (rad/s) of a body 2 that only turns.
fn angular_velocity(stage: &Stage<'_>) -> Option<f64> {
    let motion = stage.patch.surface.motion();
    let omega = motion.angular_velocity.norm();
    (omega > 0.0 && motion.velocity == Vector3::zeros()).then_some(omega)
}
