//! What a caller chooses beside the scene: points of the table, the clock, where to go on.

use std::fmt;

use crate::effort::Clock;
use crate::step::Step;
use crate::watch::Resume;

/// Options of a solve that are no part of the scene.
#[derive(Clone, Copy)]
pub struct Options<'a> {
    /// Points of the table instead of the contact points.
    pub sample: Option<Sampling<'a>>,
    /// Solves the scene's fixed discretisation alone, without the others that its error estimate needs.
    pub alone: bool,
    /// Adds what the workshop needs: of a shape the finished surface and what errors of it do, of a pressure what 1 % more of each given number does.
    pub machining: bool,
    /// Clock for the seconds of the stages.
    pub clock: Clock,
    /// An unfinished run in time to go on with.
    pub resume: Option<&'a Resume>,
    /// Told of every part of the work as it begins, for a line of progress: [`Step::Mesh`], [`Step::Factor`], [`Step::Contact`] and so on, each as
    /// often as it comes. It cannot end anything; that is for the [`Watch`](crate::Watch).
    pub begun: &'a (dyn Fn(Step) + Sync),
    /// Asked between the meshes of a level that takes many: whether the watcher is going to end the run, so that no more of them are worth making.
    pub ending: &'a (dyn Fn() -> bool + Sync),
}

impl fmt::Debug for Options<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Options { sample, alone, machining, resume, .. } = self;
        let mut shown = f.debug_struct("Options");
        shown.field("sample", sample).field("alone", alone).field("machining", machining).field("resume", resume);
        shown.finish_non_exhaustive()
    }
}

impl Default for Options<'_> {
    /// The contact points, nothing for the workshop, a clock that stands.
    fn default() -> Self {
        Options { sample: None, alone: false, machining: false, clock: || 0.0, resume: None, begun: &|_| {}, ending: &|| false }
    }
}

/// Points of a contact surface that the user chooses.
#[derive(Debug, Clone, Copy)]
pub enum Sampling<'a> {
    /// This many, evenly spaced in the surface's own coordinate, both ends included.
    Even(usize),
    /// At these values of s (mm).
    At(&'a [f64]),
}

impl Sampling<'_> {
    /// Values of s between two ends.
    pub fn places(self, [from, to]: [f64; 2]) -> Vec<f64> {
        match self {
            Sampling::At(places) => places.iter().map(|s| s.clamp(from.min(to), to.max(from))).collect(),
            Sampling::Even(count) => {
                let last = count.max(2) - 1;
                let place = |i: usize| if i == last { to } else { from + (to - from) * (i as f64 / last as f64) };
                (0..=last).map(place).collect()
            }
        }
    }
}

/// Points of the curves in pictures.
pub const CURVE: Sampling<'static> = Sampling::Even(401);

/// Trapezoid weights of ascending places: half the way to each neighbour.
pub(crate) fn trapezoid_weights(places: &[f64]) -> Vec<f64> {
    let last = places.len().saturating_sub(1);
    (0..places.len()).map(|i| 0.5 * (places[(i + 1).min(last)] - places[i.saturating_sub(1)])).collect()
}
