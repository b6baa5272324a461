//! The state of a wear run: plain numbers, all that is needed to go on.

/// State after a step. Arrays hold one value a contact point unless said otherwise; pressure and opening of a run that averages over loads hold them under
/// every load, one load after the other ([`WearProblem::shares`](crate::WearProblem::shares)).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WearState {
    /// Steps taken.
    pub step: usize,
    /// Time, s.
    pub time: f64,
    /// Sliding distance, mm, by the area mean of the sliding speeds.
    pub distance: f64,
    /// Unloaded gap, mm.
    pub gap: Vec<f64>,
    /// Pressure, MPa.
    pub pressure: Vec<f64>,
    /// Opening under load, mm.
    pub opening: Vec<f64>,
    /// Rigid coordinates of the free motions.
    pub coordinates: Vec<f64>,
    /// Change of the rigid coordinates since the start by wear (and load changes).
    pub approach: Vec<f64>,
    /// Rate of the gap, mm/s.
    pub gap_rate: Vec<f64>,
    /// Depth worn off body 1, mm.
    pub worn: Vec<f64>,
    /// Largest depth worn off body 1, at the points and at [`WearProblem::between`](crate::WearProblem::between), mm.
    pub depth: f64,
    /// Depth by which a revolving counter-face has receded, mm.
    pub recession: f64,
    /// Volumes worn off the bodies, mm^3.
    pub volume: [f64; 2],
    /// Area norm of the gap rate less its rigid part over that of the gap rate, on the points in contact; open points
    /// that the rigid part closes count as well. Where no load pushes along a free rigid mode: the part of the wear still to come.
    pub steady_residual: f64,
    /// `Phi = sum int beta~ v^a p^(b+1)/(b+1) dS` of the bodies whose wear opens the gap.
    pub lyapunov: f64,
    /// Largest relative growth of `Phi` in one step so far, under an unchanged load.
    pub lyapunov_increase: f64,
    /// Length of the last step, s.
    pub step_size: f64,
    /// Length of the next step unless the schedule cuts it, s.
    pub next_step: f64,
    /// Estimated error of the last step.
    pub error: f64,
    /// Steps rejected so far.
    pub rejected: usize,
    /// Linear systems solved so far.
    pub newton_iterations: usize,
    /// Which points conduct frictional heat: those in contact that stay so as they do; empty where that changes nothing.
    pub conducting: Vec<bool>,
    /// Times that the contact has jumped to another pressure by its frictional heat so far.
    pub jumps: usize,
    /// What is known of the points that come into a contact that grows.
    pub entering: Entering,
    /// Number of the interval of the schedule that acts.
    pub interval: usize,
    /// Time at which that interval began, s.
    pub interval_start: f64,
}

/// Points that come into a contact that grows as it wears ([`WearProblem::growing`](crate::WearProblem::growing)), as steps in time see them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Entering {
    /// Whether the last step ends with a point in contact that was open before it.
    pub entered: bool,
    /// Time until the next point is expected to enter, s; zero where none is.
    pub expected: f64,
    /// Length of the first step after the last point that entered, s; zero before any has.
    pub first_step: f64,
}

impl WearState {
    /// The largest depth worn off body 1 at the contact points alone, mm: what steps are measured by, since a profile of the first few points that
    /// touch says little of what is between them.
    pub(crate) fn deepest_point(&self) -> f64 {
        self.worn.iter().copied().fold(0.0, f64::max)
    }
}
