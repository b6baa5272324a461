//! What is told of a round contact that wears: its scar step by step, the volumes, and the groove in a revolving disc.

use wear::Groove;

use crate::results::{GrooveResult, WearResult};
use crate::stage::Stage;
use crate::steps::wear::history::History;
use crate::steps::wear::scar;

/// Points across the groove in groove.csv.
const ACROSS: usize = 201;

/// Columns of a table: name and values.
type Columns = Vec<(String, Vec<f64>)>;

/// A round contact at the places (mm, from the middle) of its contact points.
pub(super) struct RoundContact<'a> {
    pub stage: Stage<'a>,
    pub places: Vec<f64>,
}

impl RoundContact<'_> {
    /// Width of the scar (mm) after each step; of a ball its diameter.
    pub(super) fn scars(&self, history: &History) -> Vec<f64> {
        let revolved = self.stage.couple.is_revolved();
        let width = |[from, to]: [f64; 2]| if revolved { 2.0 * to } else { to - from };
        history.states.iter().map(|s| scar::ends(&self.places, &s.pressure, &s.worn).map_or(0.0, width)).collect()
    }

    /// Fills in scar and groove, and returns the columns of groove.csv.
    pub(super) fn fill(&self, wear: &mut WearResult, history: &History, scars: &[f64]) -> Columns {
        let Some((last, scar)) = history.states.last().zip(scars.last().copied()) else { return Columns::new() };
        wear.scar = Some(scar);
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
