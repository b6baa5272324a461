//! What the summary says of a reversing motion: the mean pressure, and both senses.

use contact::ContactPoint;
use nalgebra::{DMatrix, DVector};
use wear::SurfacePoint;

use crate::brake::brake;
use crate::results::PressureResult;
use crate::reversing_result::{ReversingResult, SenseResult};
use crate::steps::life::{Steady, lasting};
use crate::steps::pressure::by_role;
use crate::steps::reversing::level::{Senses, Solved};

/// Index of the largest value.
fn highest(values: &[f64]) -> usize {
    (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(0)
}

impl Senses<'_> {
    /// Mean over the time of what both senses have.
    pub(super) fn mean(&self, [forward, backward]: [f64; 2]) -> f64 {
        self.share * forward + (1.0 - self.share) * backward
    }

    /// Mean wear rate of both bodies (mm/s) by both pressures; none where the factors leave it open.
    pub(super) fn mean_rate(&self, pressure: [f64; 2], sliding_speed: f64) -> Option<f64> {
        let wear = &self.stages[0].problem.wear;
        let [forward, backward] = pressure.map(|p| wear.rate(p, sliding_speed));
        Some(self.mean([forward?, backward?]))
    }

    /// The mean pressure.
    pub(super) fn pressure(&self, solved: &Solved, points: &[ContactPoint]) -> PressureResult {
        let problem = self.stages[0].problem;
        let surface: Vec<SurfacePoint> =
            points.iter().map(|p| self.stages[0].surface_point(p.position, p.normal, p.weight)).collect();
        let both = |i: usize| [0, 1].map(|side| solved.found.pressure[side][i]);
        let mean: Vec<f64> = (0..points.len()).map(|i| self.mean(both(i))).collect();
        let sum = |value: &dyn Fn(usize) -> f64| (0..points.len()).map(|i| points[i].weight * value(i)).sum::<f64>();
        let area = sum(&|_| 1.0);
        let speed = |i: usize| surface[i].sliding_speed;
        let friction = problem.friction.coefficient;
        let rate = |i: usize| self.mean_rate(both(i), speed(i)).unwrap_or(f64::NAN);
        let wear_power = |i: usize| {
            let of = |side: usize| problem.wear.rate(both(i)[side], speed(i)).unwrap_or(f64::NAN) * both(i)[side];
            self.mean([of(0), of(1)])
        };
        let most = highest(&mean);
        let place = surface[most].position;
        let volume = sum(&rate);
        let mean_speed = sum(&speed) / area;
        let friction_power = sum(&|i| friction * mean[i] * speed(i));
        let worn = volume > 0.0 && mean_speed > 0.0;
        PressureResult {
            functional: problem.optimum.functional,
            q: Some(problem.optimum.q),
            balance: problem.optimum.balance,
            modes: problem.optimum.modes,
            feed: problem.wear.laws.as_ref().is_ok_and(|laws| laws.active).then(|| self.feed(solved, &surface)),
            p_min: mean.iter().copied().reduce(f64::min),
            p_max: Some(mean[most]),
            p_max_at: Some([place.x, place.y, place.z]),
            p_mean: Some(sum(&|i| mean[i]) / area),
            force: problem.load.force,
            normal_force: Some(sum(&|i| mean[i])),
            wear_volume_rate: Some(volume),
            wear_depth_per_hour: worn.then(|| 1e3 * 3600.0 * volume / area),
            wear_depth_per_1000_km: worn.then(|| 1e9 * volume / area / mean_speed),
            friction_power: Some(friction_power),
            wear_power: Some(sum(&wear_power)),
            life: lasting(problem, Steady { fastest: self.fastest(solved, &surface), speed: mean_speed, friction_power }),
            ..PressureResult::default()
        }
    }

    /// Largest mean recession of body 1 (mm/s).
    fn fastest(&self, solved: &Solved, surface: &[SurfacePoint]) -> f64 {
        let Ok(laws) = &self.stages[0].problem.wear.laws else { return 0.0 };
        let rate = |side: usize, i: usize| laws.rules[0].rate(solved.found.pressure[side][i], surface[i].sliding_speed);
        (0..surface.len()).map(|i| self.mean([rate(0, i), rate(1, i)])).fold(0.0, f64::max)
    }

    /// Velocities of the freedoms that feed the points as they are fed.
    fn feed(&self, solved: &Solved, surface: &[SurfacePoint]) -> crate::results::ByRole {
        let freedoms = &self.stages[0].problem.freedoms;
        let modes = DMatrix::from_fn(surface.len(), freedoms.len(), |i, k| freedoms[k].mode.motion.closing(&surface[i]));
        let fed = DVector::from_column_slice(&solved.found.feed);
        let found = modes.svd(true, true).solve(&fed, 1e-12).map(|x| x.iter().copied().collect::<Vec<f64>>());
        by_role(&found.unwrap_or_default(), freedoms)
    }

    /// Both senses.
    pub(super) fn senses(&self, solved: &Solved, points: &[ContactPoint], [start, length]: [f64; 2]) -> ReversingResult {
        let friction = self.stages[0].problem.friction.coefficient;
        let area: f64 = points.iter().map(|p| p.weight).sum();
        let sense = |side: usize| {
            let pressure = &solved.found.pressure[side];
            let most = highest(pressure);
            let stage = &self.stages[side];
            let surface: Vec<SurfacePoint> = points.iter().map(|p| stage.surface_point(p.position, p.normal, p.weight)).collect();
            let sum = |value: &dyn Fn(usize) -> f64| (0..points.len()).map(|i| points[i].weight * value(i)).sum::<f64>();
            SenseResult {
                p_max: pressure[most],
                p_max_where: start + points[most].arc,
                p_min: pressure.iter().copied().fold(f64::INFINITY, f64::min),
                normal_force: sum(&|i| pressure[i]),
                friction_power: sum(&|i| friction * pressure[i] * surface[i].sliding_speed),
                open_share: sum(&|i| f64::from(u8::from(pressure[i] == 0.0))) / area,
                brake: brake(stage.problem, &surface, pressure),
            }
        };
        ReversingResult {
            share: self.share,
            forward: sense(0),
            back: sense(1),
            ends: solved.ends.iter().map(|t| start + 0.5 * (1.0 + t) * length).collect(),
            newton_steps: solved.found.iterations,
        }
    }
}
