//! How far a run is, from what happens in it: a share that never falls, and the words beside it.

use scene::short;
use wearshape::{Event, Problem, Step, WearState};

/// What climbs levels, in the order of a run, and how long it takes beside the others, about.
const LADDERS: [(Step, f64); 4] = [(Step::Force, 2.0), (Step::Contact, 1.0), (Step::Shape, 1.0), (Step::Evolution, 10.0)];
/// Share of the levels in a run; proof, fields and files take the rest. The proof is a level of two degrees more.
const LEVELS: f64 = 0.9;
const LEVELS_BEFORE_PROOF: f64 = 0.6;
/// Work of a level over its degree: unknowns of the contact grow like its square with as many layers, a solve with them like their square.
const POWER: i32 = 4;
/// Each part of the work that begins is taken for this share of what is left of its level.
const PART: f64 = 0.15;
/// Steps between the degrees of a ladder.
const NEXT: usize = 2;

/// A level that begins.
#[derive(Debug, Clone, Copy)]
struct Level {
    /// What climbs.
    step: Step,
    /// Degree of the cells.
    degree: usize,
    /// Levels expected after it.
    left: usize,
}

/// Where a run is: told of its events and of the parts of its work, it knows the share that is done, in words too.
#[derive(Debug, Default)]
pub struct Track {
    ladders: Vec<(Step, f64)>,
    /// Share of the run that its levels take.
    levels: f64,
    /// What climbs now, and the work of its levels that are done.
    climbing: Option<(Step, f64)>,
    /// Share of the run at the beginning and at the end of the level.
    level: [f64; 2],
    /// Work of the level.
    work: f64,
    share: f64,
    heading: String,
    doing: String,
}

impl Track {
    /// A run at its start.
    pub fn of(problem: &Problem) -> Track {
        let proof = problem.plan().runs(Step::RoundTrip) && !problem.plan().runs(Step::Evolution);
        let levels = if proof { LEVELS_BEFORE_PROOF } else { LEVELS };
        Track::along(LADDERS.into_iter().filter(|(step, _)| problem.plan().runs(*step)).collect(), levels)
    }

    fn along(ladders: Vec<(Step, f64)>, levels: f64) -> Track {
        Track { ladders, levels, level: [0.0, levels], ..Track::default() }
    }

    /// Something happened in the run.
    pub fn see(&mut self, event: &Event<'_>) {
        match event {
            Event::Level { step, degree, left, .. } => self.level(Level { step: *step, degree: *degree, left: *left }),
            Event::Run(_) => {}
            Event::WearStep(step) => self.wear(step.share, at(step.state)),
        }
    }

    /// A level begins.
    fn level(&mut self, Level { step, degree, left }: Level) {
        let done = match self.climbing {
            Some((same, done)) if same == step => done + self.work,
            _ => 0.0,
        };
        let work = |degree: usize| (degree as f64).powi(POWER);
        self.work = work(degree);
        let to_come: f64 = (1..=left).map(|k| work(degree + NEXT * k)).sum();
        let all = done + self.work + to_come;
        let [from, to] = self.ladder(step);
        let at = |part: f64| from + (to - from) * part / all;
        self.reach(at(done));
        self.level = [self.share, at(done + self.work).max(self.share)];
        self.climbing = Some((step, done));
        self.heading = format!("{}, degree {degree}", step_words(step));
        self.doing.clear();
    }

    /// A part of the work begins.
    pub fn part(&mut self, step: Step) {
        let more = matches!(step, Step::RoundTrip) && self.ladders.iter().any(|(known, _)| *known == Step::Evolution);
        if matches!(step, Step::RoundTrip | Step::Fields) && !more {
            // The levels are over.
            self.reach(self.levels);
            self.level = [self.share, 1.0];
            self.heading = step_words(step).into();
        }
        self.reach(self.share + PART * (self.level[1] - self.share));
        self.doing = step_words(step).into();
    }

    /// A run in time has come to this share of its way on its level.
    fn wear(&mut self, share: f64, state: String) {
        let [from, to] = self.level;
        if share.is_finite() {
            self.reach(from + (to - from) * share.clamp(0.0, 1.0));
        }
        self.doing = state;
    }

    /// How far the run is, from 0 to 1, about.
    pub fn share(&self) -> f64 {
        self.share
    }

    /// What is being done.
    pub fn words(&self) -> String {
        match (self.heading.as_str(), self.doing.as_str()) {
            ("", one) | (one, "") => one.to_string(),
            (heading, doing) if heading == doing => heading.to_string(),
            (heading, doing) => format!("{heading}: {doing}"),
        }
    }

    /// Seconds to go after so many of a run in time, about; none before there is much to go by. How many levels another run takes is hardly known.
    pub fn left(&self, seconds: f64) -> Option<f64> {
        let in_time = self.climbing.is_some_and(|(step, _)| step == Step::Evolution);
        (in_time && seconds > 1.0 && self.share > 0.02).then(|| seconds * (1.0 - self.share) / self.share)
    }

    /// Shares of the run between which the levels of a step lie.
    fn ladder(&self, step: Step) -> [f64; 2] {
        let Track { levels, .. } = *self;
        let all: f64 = self.ladders.iter().map(|(_, weight)| weight).sum();
        let mut from = 0.0;
        for (known, weight) in &self.ladders {
            let to = from + levels * weight / all;
            if *known == step {
                return [from, to];
            }
            from = to;
        }
        [0.0, levels]
    }

    fn reach(&mut self, share: f64) {
        self.share = share.clamp(self.share, 1.0);
    }
}

/// A state of a run in time.
fn at(state: &WearState) -> String {
    let time: f64 = format!("{:.2e}", state.time).parse().unwrap_or(state.time);
    format!("step {}, t = {} s", state.step, short(time))
}

/// What is done in a step.
pub fn step_words(step: Step) -> &'static str {
    match step {
        Step::Force => "force of the approach",
        Step::Pressure => "pressure",
        Step::Mesh => "meshing",
        Step::Assemble | Step::Factor => "factoring",
        Step::Interface | Step::Tangential => "responses of the surface",
        Step::Contact => "contact",
        Step::Shape => "shape",
        Step::RoundTrip => "proof",
        Step::Evolution => "wear",
        Step::Torsion => "twist",
        Step::Heat => "heat",
        Step::Fields => "stresses inside",
        Step::Table | Step::Machined | Step::Plots | Step::Page | Step::Recording => "writing files",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn climb(track: &mut Track, step: Step, left: &[usize], shares: &mut Vec<f64>) {
        for (number, left) in left.iter().enumerate() {
            track.level(Level { step, degree: 4 + 2 * number, left: *left });
            shares.push(track.share());
            for part in [Step::Mesh, Step::Factor, Step::Contact, Step::Mesh, Step::Factor] {
                track.part(part);
                shares.push(track.share());
            }
            if step == Step::Evolution {
                // The share of a run that a reversal throws back, and one that is no number.
                for share in [0.0, 0.2, 0.5, 0.3, f64::NAN, 0.9, 1.0, 0.1] {
                    track.wear(share, "step 3".into());
                    shares.push(track.share());
                }
            }
        }
    }

    #[test]
    fn the_share_of_a_run_never_falls_and_ends_below_one() {
        // Levels that were not expected, and some that were and do not come.
        for left in [vec![4, 3, 2, 1, 0], vec![4, 3, 9, 8, 2], vec![0, 0, 0, 0, 0, 0, 0], vec![6, 5, 0]] {
            let mut track = Track::along(LADDERS.to_vec(), LEVELS);
            let mut shares = Vec::new();
            for step in [Step::Force, Step::Contact, Step::Shape, Step::Evolution] {
                climb(&mut track, step, &left, &mut shares);
            }
            for step in [Step::RoundTrip, Step::Mesh, Step::Factor, Step::Fields] {
                track.part(step);
                shares.push(track.share());
            }
            assert!(shares.windows(2).all(|pair| pair[0] <= pair[1]), "{shares:?}");
            assert!(shares.iter().all(|share| (0.0..1.0).contains(share)), "{shares:?}");
            assert!(*shares.last().unwrap_or(&0.0) > LEVELS);
        }
    }

    #[test]
    fn a_run_in_time_goes_on_where_the_last_level_was() {
        let mut track = Track::along(vec![(Step::Evolution, 10.0)], LEVELS);
        track.level(Level { step: Step::Evolution, degree: 4, left: 1 });
        track.wear(1.0, String::new());
        let before = track.share();
        assert!(before > 0.05 && before < 0.3, "{before}");
        track.level(Level { step: Step::Evolution, degree: 6, left: 0 });
        track.wear(0.5, String::new());
        assert!((track.share() - 0.5 * (before + LEVELS)).abs() < 1e-12);
        assert_eq!(track.left(0.5), None);
        let left = track.left(10.0).unwrap_or(0.0);
        assert!((left - 10.0 * (1.0 - track.share()) / track.share()).abs() < 1e-9);
    }
}
