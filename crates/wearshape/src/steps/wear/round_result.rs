//! What is told of a round contact that wears: its scar step by step, the volumes, and the groove in a revolving disc.

use contact::{ContactOperator, Pair};
use shapeopt::{WearProblem, WearState};
use wear::Groove;

use crate::results::{GrooveResult, WearResult};
use crate::stage::Stage;
use crate::steps::wear::history::History;
use crate::steps::wear::scar;

/// Points across the groove in groove.csv.
const ACROSS: usize = 201;

/// Columns of a table: name and values.
type Columns = Vec<(String, Vec<f64>)>;

/// A round contact at the places (mm, along the surface) of its contact points.
pub(super) struct RoundContact<'a> {
    pub stage: Stage<'a>,
    pub problem: &'a WearProblem,
    pub places: Vec<f64>,
}

/// Where round bodies touch first (mm along the surface): a ball or cylinder on a flat in the middle.
fn touch(stage: Stage<'_>) -> f64 {
    stage.problem.gap.touch().map_or(0.0, |(touch, _)| touch)
}

/// Distances (mm) of the contact points from the place where round bodies touch first.
pub(super) fn from_touch(stage: Stage<'_>, pair: &Pair<'_>, operator: &ContactOperator<'_>) -> Vec<f64> {
    let start = stage.start(pair) - touch(stage);
    operator.points().iter().map(|point| start + point.arc).collect()
}

impl RoundContact<'_> {
    /// Ends of the contact (mm along the surface) after each step; on the axis of revolution the first is 0.
    pub(super) fn ends(&self, history: &History) -> Vec<[f64; 2]> {
        let touch = touch(self.stage);
        let places: Vec<f64> = self.places.iter().map(|place| place - touch).collect();
        let of =
            |state: &WearState| scar::ends(&places, &self.problem.mean_pressure(&state.pressure), &self.problem.worn_gap(state));
        history.states.iter().map(|state| of(state).map_or([touch; 2], |ends| ends.map(|end| touch + end))).collect()
    }

    /// Width of the scar (mm) between ends; of a ball its diameter.
    fn width(&self, [from, to]: [f64; 2]) -> f64 {
        if self.stage.couple.is_revolved() { 2.0 * to } else { to - from }
    }

    /// Columns of history.csv: the width of the scar, and unless it is round about an axis its ends.
    pub(super) fn columns(&self, ends: &[[f64; 2]]) -> Columns {
        let mut columns = vec![("scar_mm".to_string(), ends.iter().map(|ends| self.width(*ends)).collect())];
        if !self.stage.couple.is_revolved() {
            let side = |k: usize| ends.iter().map(|ends| ends[k]).collect();
            columns.extend([("from_mm".to_string(), side(0)), ("to_mm".to_string(), side(1))]);
        }
        columns
    }

    /// Fills in scar and groove, and returns the columns of groove.csv.
    pub(super) fn fill(&self, wear: &mut WearResult, history: &History, ends: Option<&[f64; 2]>) -> Columns {
        let Some((last, ends)) = history.states.last().zip(ends.copied()) else { return Columns::new() };
        let scar = self.width(ends);
        wear.scar = Some(scar);
        wear.ends = (!self.stage.couple.is_revolved()).then_some(ends);
        wear.volumes = Some(last.volume);
        let Some((track, ratio)) = self.stage.problem.track().zip(self.ratio()) else { return Columns::new() };
        let groove = Groove::new(track, &self.places);
        let standing: Vec<f64> = last.worn.iter().map(|worn| ratio * worn).collect();
        let places: Vec<f64> = (0..ACROSS).map(|i| 0.5 * scar * (2.0 * i as f64 / (ACROSS - 1) as f64 - 1.0)).collect();
        let depths: Vec<f64> = places.iter().map(|y| 1e3 * groove.depth(&standing, y.abs())).collect();
        wear.groove = Some(GrooveResult {
            depth: 1e3 * groove.depth(&standing, 0.0),
            width: scar,
            volume: last.volume[1],
            depth_ratio: groove.depth(&standing, 0.0) / last.worn.iter().copied().fold(f64::MIN_POSITIVE, f64::max),
        });
        vec![("y_mm".into(), places), ("depth_um".into(), depths)]
    }

    /// Wear of body 2 over that of body 1 at one place; both wear with the same power of the pressure.
    fn ratio(&self) -> Option<f64> {
        let laws = self.stage.problem.wear.laws.as_ref().ok()?;
        let speed = self.stage.surface_point([0.0; 2], [0.0, 1.0], 0.0).sliding_speed;
        let [first, second] = [0, 1].map(|body| if laws.wears(body) { laws.rules[body].rate(1.0, speed) } else { 0.0 });
        (first > 0.0 && second > 0.0).then(|| second / first)
    }
}
