//! What a wear run is made of: plain numbers at the contact points.

use crate::error::Error;
use crate::wear_state::WearState;
use contact::{ContactSystem, HeatedSystem};
use faer::Mat;
use wear::{Counterface, SurfacePoint, WearPair};

/// Wear in time of a gap under given loads. Arrays hold one value a contact point.
#[derive(Clone, Debug)]
pub struct WearProblem {
    /// The contact points; weights in mm^2. Sliding speeds here are not used: every [`LoadStage`] brings its own.
    pub points: Vec<SurfacePoint>,
    /// Wear rules of the two bodies.
    pub wear: WearPair,
    /// How body 2 passes through the contact.
    pub counterface: Counterface,
    /// Area (mm^2) of body 2's closed track, needed by [`Counterface::Revolving`].
    pub track_area: Option<f64>,
    /// Depth of the groove that body 2 wears as it passes, at each point (row) by its wear standing still at each point (column); it adds to what
    /// the counter-face does. None where body 2 has no groove.
    pub passing: Option<Mat<f64>>,
    /// Unloaded gap at the start, mm, positive open.
    pub gap: Vec<f64>,
    /// Pressure (MPa) and opening (mm) at the start, if a contact solve has found them; they are solved for otherwise.
    pub start: Option<[Vec<f64>; 2]>,
    /// The loads that occur.
    pub stages: Vec<LoadStage>,
    /// Shares of the time of loads that act by turns, in cycles short against wear: the run averages over them, and pressures and openings of its states hold
    /// the values under every load, one load after the other. The schedule is one interval then. None where one load acts after the other.
    pub shares: Option<Vec<f64>>,
    /// Which stage acts when, one after another; the last one goes on until the run ends.
    pub schedule: Vec<Interval>,
    /// When the run ends.
    pub until: Until,
    /// Integrator.
    pub scheme: Scheme,
    /// How steps are chosen.
    pub stepping: Stepping,
    /// What the times of a run until the steady state are wanted for, if they are.
    pub times: Option<Times>,
    /// Places where the largest depth is looked for too, as many between any two neighbours among the points: each by the first of the points that
    /// interpolate there, and the weights of these. Empty where the depths at the points will do.
    pub between: Vec<(usize, Vec<f64>)>,
    /// Whether the contact grows as it wears, and its depth at the end is what is wanted: steps before it are as accurate as that asks for.
    pub growing: bool,
}

/// A load with its sliding speeds. A reversal is a stage of its own, since the shear turns with the sense of sliding.
#[derive(Clone, Debug)]
pub struct LoadStage {
    /// Contact under the load.
    pub system: ContactSystem,
    /// Sliding speed at each point, mm/s, at least 0.
    pub speeds: Vec<f64>,
    /// The same contact for any set of points that conduct heat, where frictional heat bends the bodies; `system` is then that of one such set. None
    /// without heat.
    pub heated: Option<HeatedSystem>,
}

/// A piece of the schedule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Number of the stage.
    pub stage: usize,
    /// Duration, s. That of the last interval is not used.
    pub duration: f64,
}

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Until {
    /// The certificate `||w' - Proj w'|| / ||w'||` of the last interval falls below a residual; where no load pushes along a rigid motion
    /// (a prescribed approach), the part of the wear still to come does.
    Steady {
        /// Residual.
        residual: f64,
        /// Time (s) that the run reaches in any case, 0 for none.
        not_before: f64,
    },
    /// A time, s.
    Time(f64),
    /// The largest depth worn off body 1, mm.
    Depth(f64),
    /// The volume worn off both bodies, mm^3.
    Volume(f64),
}

/// Integrators. The implicit ones are L-stable and end on their last stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Implicit Euler, order 1: without shear the Lyapunov function falls in every step, however large.
    BackwardEuler,
    /// Two stages, order 2 (Alexander 1977).
    Sdirk2,
    /// Five stages, order 4 with an embedded order 3 (Hairer and Wanner, Solving ODEs II, table IV.6.5).
    Sdirk4,
    /// Explicit Euler, for comparison: stable only for steps below [`RunIn::explicit_limit`](crate::RunIn::explicit_limit).
    Explicit,
}

/// Times at which a run comes near its steady state ([`Evolution::settling`](crate::Evolution::settling)), as far as adaptive steps are to see to
/// them: until then errors of the pressure are measured by what it deviates from the steady one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// Smallest relative deviation whose time is wanted.
    pub deviation: f64,
    /// Relative error wanted of that time, and of distance and depth then.
    pub accuracy: f64,
}

/// Choice of steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepping {
    /// Steps whose estimated errors of pressure (force misplaced over the force) and gap (over the larger of elastic closing and wear
    /// depth) add up to about `accuracy` over the run. An explicit integrator takes 0.9 of its stability bound.
    Adaptive {
        /// Error wanted.
        accuracy: f64,
    },
    /// Equal steps, s.
    Fixed(f64),
}

impl WearProblem {
    /// A run under one load until the steady state, with order 4 and an accuracy of 1e-4.
    pub fn new(
        points: Vec<SurfacePoint>,
        wear: WearPair,
        counterface: Counterface,
        gap: Vec<f64>,
        system: ContactSystem,
    ) -> WearProblem {
        let speeds = points.iter().map(|p| p.sliding_speed).collect();
        WearProblem {
            points,
            wear,
            counterface,
            track_area: None,
            passing: None,
            gap,
            start: None,
            stages: vec![LoadStage { system, speeds, heated: None }],
            shares: None,
            schedule: vec![Interval { stage: 0, duration: f64::INFINITY }],
            until: Until::Steady { residual: 1e-9, not_before: 0.0 },
            scheme: Scheme::Sdirk4,
            stepping: Stepping::Adaptive { accuracy: 1e-4 },
            times: None,
            between: Vec::new(),
            growing: false,
        }
    }
}

/// Part of the errors of a step that counts at the very start of a contact that grows.
const EARLIEST: f64 = 0.01;
/// Part of the wear of a contact that grows in which steps see to the pressure of the end, and how many times as much its errors count there.
const LAST: f64 = 0.01;
const AT_THE_END: f64 = 100.0;

impl WearProblem {
    /// Parts of the errors of a step from a state, in gap and pressure, that count at the end. Where the contact grows, what a step gets wrong of the depth
    /// stays what it is, and the depth grows as the root of the wear passed at least. What it gets wrong of the pressure is worn off soon after, so that the
    /// last steps decide about the pressure of the end.
    pub(crate) fn early(&self, state: &WearState) -> [f64; 2] {
        let passed = match self.until {
            _ if !self.growing => return [1.0; 2],
            Until::Time(end) => state.time / end,
            Until::Volume(end) => (state.volume[0] + state.volume[1]) / end,
            Until::Depth(end) => (state.deepest_point() / end).powi(2),
            Until::Steady { .. } => return [1.0; 2],
        };
        let part = passed.sqrt().clamp(EARLIEST, 1.0);
        [part, if passed < 1.0 - LAST { part } else { AT_THE_END }]
    }

    /// Whether the wear of body 2 opens the gap where it is, beside that of body 1.
    pub(crate) fn is_opened_by_both(&self) -> bool {
        self.counterface == Counterface::Congruent && self.wear.wears(1)
    }

    /// Depths of wear in the gap of a state, mm: what is worn off body 1, and off body 2 where that opens the gap too.
    pub fn worn_gap(&self, state: &WearState) -> Vec<f64> {
        if !self.is_opened_by_both() {
            return state.worn.clone();
        }
        state.gap.iter().zip(&self.gap).map(|(now, start)| now - start).collect()
    }

    /// The largest depth of a profile: that of its deepest point, or beside it.
    pub(crate) fn deepest(&self, worn: &[f64]) -> f64 {
        let Some(deepest) = (0..worn.len()).max_by(|i, j| worn[*i].total_cmp(&worn[*j])) else { return 0.0 };
        let each = self.between.len() / (worn.len() - 1).max(1);
        let beside = deepest.saturating_sub(1) * each..((deepest + 1) * each).min(self.between.len());
        let depth = |(first, weights): &(usize, Vec<f64>)| weights.iter().zip(&worn[*first..]).map(|(l, w)| l * w).sum();
        self.between[beside].iter().map(depth).fold(worn[deepest], f64::max)
    }

    /// Checks sizes and ranges.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let n = self.points.len();
        let wrong = |what: String| Err(Error::WearInput { what });
        if self.gap.len() != n || self.gap.iter().any(|g| !g.is_finite()) {
            return wrong(format!("{} finite gaps are needed for {n} contact points, {} values were given", n, self.gap.len()));
        }
        if let Some(point) = self.points.iter().find(|p| !(p.weight > 0.0 && p.weight.is_finite())) {
            return wrong(format!("a contact point has the area {}; it must be positive", point.weight));
        }
        if self.start.iter().flatten().any(|values| values.len() != self.values()) {
            return wrong(format!("the pressure and opening at the start need {} values each", self.values()));
        }
        for rule in &self.wear.rules {
            if let Err(error) = rule.check() {
                return wrong(format!("a wear rule does not do: {error}"));
            }
        }
        for (number, stage) in self.stages.iter().enumerate() {
            if !fits(&stage.system, n) || stage.speeds.len() != n || stage.speeds.iter().any(|v| !(*v >= 0.0 && v.is_finite())) {
                return wrong(format!("a load stage does not fit the {n} contact points, or a sliding speed is negative"));
            }
            if let Some(place) = not_finite(&stage.system) {
                return wrong(format!("the contact system of load stage {number} has a number that is not finite: {place}"));
            }
        }
        if self.passing.as_ref().is_some_and(|passing| passing.nrows() != n || passing.ncols() != n || !passing.is_all_finite()) {
            return wrong(format!("the groove does not fit the {n} contact points, or has numbers that are not finite"));
        }
        let within = |(first, weights): &(usize, Vec<f64>)| first + weights.len() <= n && weights.iter().all(|l| l.is_finite());
        if !self.between.len().is_multiple_of(n.max(2) - 1) || !self.between.iter().all(within) {
            return wrong(format!("the places between the points do not fit the {n} contact points"));
        }
        if self.schedule.is_empty() || self.schedule.iter().any(|i| i.stage >= self.stages.len()) {
            return wrong(format!("the schedule has to name stages 0..{}", self.stages.len()));
        }
        if let Some(interval) = self.schedule.iter().find(|i| i.duration.is_nan() || i.duration <= 0.0) {
            return wrong(format!("an interval of the schedule lasts {} s; it must last longer than 0", interval.duration));
        }
        if self.shares.is_some() && self.stages.iter().any(|stage| stage.heated.is_some()) {
            return wrong("loads that act by turns in short cycles know no heat".into());
        }
        if let Some(what) = self.wrong_shares() {
            return wrong(what);
        }
        if self.counterface == Counterface::Revolving && !self.track_area.is_some_and(|a| a > 0.0) {
            return wrong("a revolving counter-face needs the area of its closed track".into());
        }
        self.check_end()
    }

    /// Checks steps and end of the run.
    fn check_end(&self) -> Result<(), Error> {
        let (Stepping::Adaptive { accuracy: size } | Stepping::Fixed(size)) = self.stepping;
        let (end, from) = match self.until {
            Until::Steady { residual, not_before } => (residual, not_before),
            Until::Time(end) | Until::Depth(end) | Until::Volume(end) => (end, 0.0),
        };
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let what = if !positive(size) {
            format!("the accuracy or length of the steps is {size}; it must be above 0 and finite")
        } else if !(positive(end) && from >= 0.0 && from.is_finite()) {
            "the end of the run must be above 0 and finite".into()
        } else if matches!(self.until, Until::Depth(_)) && !self.wear.wears(0) {
            "body 1 does not wear, and the run ends by its depth".into()
        } else if matches!(self.until, Until::Volume(_)) && !(self.wear.wears(0) || self.wear.wears(1)) {
            "nothing wears, and the run ends by its volume".into()
        } else {
            return Ok(());
        };
        Err(Error::WearInput { what })
    }
}

/// The first number of a system that is not finite, with its place; none where all are.
pub(crate) fn not_finite(system: &ContactSystem) -> Option<String> {
    let ContactSystem { compliance, influence, balance, stiffness, load, opening, symmetric: _ } = system;
    let matrices = [("compliance", compliance), ("influence", influence), ("balance", balance), ("stiffness", stiffness)];
    let in_matrix = |(name, matrix): (&str, &Mat<f64>)| {
        let rows = |column: usize| (0..matrix.nrows()).map(move |row| (row, column));
        let (row, column) = (0..matrix.ncols()).flat_map(rows).find(|at| !matrix[*at].is_finite())?;
        Some(format!("the {name} in row {row}, column {column} is {}", matrix[(row, column)]))
    };
    let in_list = |(name, values): (&str, &Vec<f64>)| {
        let place = values.iter().position(|value| !value.is_finite())?;
        Some(format!("the {name} in row {place} is {}", values[place]))
    };
    matrices.into_iter().find_map(in_matrix).or_else(|| [("load", load), ("opening", opening)].into_iter().find_map(in_list))
}

/// Whether a system is one of so many points, its matrices of one size with each other.
pub(crate) fn fits(system: &ContactSystem, points: usize) -> bool {
    let (n, m) = (points, system.load.len());
    let is = |matrix: &Mat<f64>, rows: usize, columns: usize| matrix.nrows() == rows && matrix.ncols() == columns;
    let matrices = is(&system.compliance, n, n) && is(&system.influence, n, m) && is(&system.balance, n, m);
    matrices && is(&system.stiffness, m, m) && system.opening.len() == n
}
