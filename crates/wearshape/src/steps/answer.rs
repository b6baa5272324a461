//! What every elastic step tells of the level that it reports: one recipe for energies, reactions and the columns at the contact points.

use contact::{ContactPoint, Pair};
use hpfem::InterfaceState;

use crate::bodies::Reduced;
use crate::brake::{BrakeResult, brake};
use crate::heat_result::HeatResult;
use crate::machined::Machined;
use crate::options::{CURVE, Sampling};
use crate::profile::Profile;
use crate::remark::Remark;
use crate::results::{
    ContactResult, EnergyResult, ErrorResult, InterfaceResult, PressureResult, Reaction, ShapeResult, WearResult,
};
use crate::reversing_result::ReversingResult;
use crate::solution::{Rung, RunningIn, Status};
use crate::stage::Stage;
use crate::steps::reported::Reported;
use crate::watch::Resume;
use crate::words::PointStatus;

/// A solved pair of bodies.
pub(crate) struct Answer<'a> {
    pub stage: Stage<'a>,
    pub reduced: &'a Reduced,
    pub pair: &'a Pair<'a>,
    /// Displacements of body 1 and 2.
    pub states: [Option<&'a InterfaceState>; 2],
    /// At the contact points.
    pub own: Own<'a>,
    /// Pressure (MPa), gap and opening (mm) at any point of the surface.
    pub between: &'a dyn Fn(&ContactPoint) -> [f64; 3],
}

/// What is known at the contact points.
pub(crate) struct Own<'a> {
    pub points: &'a [ContactPoint],
    /// MPa.
    pub pressure: &'a [f64],
    /// Unloaded, mm.
    pub gap: &'a [f64],
    /// Under load, mm.
    pub opening: &'a [f64],
    /// Whether each point is in contact, where that is said by more than the sign of its pressure.
    pub closed: Option<&'a [bool]>,
}

/// What is told of a reported level.
pub(crate) struct Told {
    pub energy: EnergyResult,
    pub reactions: Vec<(String, Reaction)>,
    /// Body 1 as a brake, where a pin or a roller guides it.
    pub brake: Option<BrakeResult>,
    /// At the contact points, or where the user wants it.
    pub profile: Profile,
    /// At the points of pictures.
    pub curve: Profile,
}

impl Answer<'_> {
    /// Energies, reactions and columns.
    pub(crate) fn told(&self) -> Told {
        let profile = match self.stage.options.sample {
            Some(sampling) => self.sampled(sampling),
            None => self.at_own_points(),
        };
        let (energy, reactions) = (self.energy(), self.reduced.reactions(self.states));
        Told { energy, reactions, brake: self.brake(), profile, curve: self.sampled(CURVE) }
    }

    fn brake(&self) -> Option<BrakeResult> {
        let Own { points, pressure, .. } = self.own;
        let surface: Vec<wear::SurfacePoint> =
            points.iter().map(|p| self.stage.surface_point(p.position, p.normal, p.weight)).collect();
        brake(self.stage.problem, &surface, pressure)
    }

    fn energy(&self) -> EnergyResult {
        let bodies = [Some(self.pair.shaped), self.pair.counter];
        let [first, second] = [0, 1].map(|k| bodies[k].zip(self.states[k]).map(|(body, state)| body.strain_energy(state)));
        EnergyResult { body1: first, body2: second, ..EnergyResult::default() }
    }

    fn at_own_points(&self) -> Profile {
        let Own { points, pressure, gap, opening, closed } = self.own;
        let mut profile = self.stage.profile(self.pair, points, pressure, self.states);
        profile.gap = gap.iter().map(|g| 1e3 * g).collect();
        profile.opening = opening.iter().map(|g| 1e3 * g).collect();
        if let Some(closed) = closed {
            profile.status = closed.iter().map(|closed| PointStatus::pressed(*closed)).collect();
        }
        profile
    }

    fn sampled(&self, sampling: Sampling<'_>) -> Profile {
        let points = self.stage.sample(self.pair, sampling);
        let values: Vec<[f64; 3]> = points.iter().map(self.between).collect();
        let pressure: Vec<f64> = values.iter().map(|[pressure, ..]| *pressure).collect();
        let mut profile = self.stage.profile(self.pair, &points, &pressure, self.states);
        profile.gap = values.iter().map(|[_, gap, _]| 1e3 * gap).collect();
        profile.opening = values.iter().map(|[.., opening]| 1e3 * opening).collect();
        profile
    }
}

/// Result of an elastic step; what it does not say stays as it was.
#[derive(Default)]
pub(crate) struct Outcome {
    /// How it ended, with the reason where it did not end well.
    pub ended: Option<(Status, String)>,
    /// Whether the watcher ended it.
    pub stopped: bool,
    /// The mean pressure of a reversing motion.
    pub pressure: Option<PressureResult>,
    pub reversing: Option<ReversingResult>,
    pub contact: Option<ContactResult>,
    pub interface: Option<InterfaceResult>,
    pub shape: Option<ShapeResult>,
    pub wear: Option<WearResult>,
    pub history: Vec<(String, Vec<f64>)>,
    pub groove: Vec<(String, Vec<f64>)>,
    pub running_in: Option<RunningIn>,
    pub machined: Option<Machined>,
    pub told: Option<Told>,
    /// Frictional heat of the reported level.
    pub heat: Option<HeatResult>,
    /// Estimated errors; `how` is empty where there are none.
    pub error: ErrorResult,
    pub ladder: Vec<Rung>,
    pub remarks: Vec<Remark>,
    /// For the fields and the twist.
    pub reported: Option<Reported>,
    /// An unfinished run in time.
    pub resume: Option<Resume>,
}

impl Outcome {
    /// Writes another estimate of the last level's error into the table of levels, if there is one.
    pub(crate) fn tell(&mut self, error: Option<f64>) {
        if let Some((rung, error)) = self.ladder.last_mut().zip(error) {
            rung.estimate = Some(error);
        }
    }
}
