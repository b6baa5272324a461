//! The rate at which wear opens the gap, and its implicit inverse.

use faer::Mat;
use wear::{Counterface, LocalRule, WearPair, resisted_pressure};

/// `w_1'` of body 1 plus what body 2 adds to the gap, at every point.
pub(crate) struct GapRate {
    /// Rule of each body at the points.
    rules: [Vec<LocalRule>; 2],
    counterface: Counterface,
    /// Weight over track area.
    share: Vec<f64>,
    /// Rate at which a groove opens the gap at a point (row) by body 2's wear rate at each point (column).
    passing: Option<Mat<f64>>,
}

impl GapRate {
    pub(crate) fn new(wear: &WearPair, counterface: Counterface, speeds: &[f64], weights: &[f64], track: Option<f64>) -> GapRate {
        let rules = [0, 1].map(|body| {
            let rule = &wear.rules[body];
            speeds.iter().map(|v| if wear.wears(body) { rule.at(*v) } else { LocalRule::NONE }).collect()
        });
        let track = track.unwrap_or(f64::INFINITY);
        GapRate { rules, counterface, share: weights.iter().map(|w| w / track).collect(), passing: None }
    }

    /// The same with the groove that body 2 wears as it passes.
    pub(crate) fn passing(self, passing: Option<Mat<f64>>) -> GapRate {
        GapRate { passing: passing.filter(|_| self.rules[1].iter().any(LocalRule::wears)), ..self }
    }

    /// Rate of the groove at all points; none without one.
    pub(crate) fn groove(&self, pressure: &[f64]) -> Option<Vec<f64>> {
        let passing = self.passing.as_ref()?;
        let mut rate = vec![0.0; pressure.len()];
        for (j, p) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
            let own = self.wear(1, j, *p);
            rate.iter_mut().zip(passing.col(j).iter()).for_each(|(rate, share)| *rate += share * own);
        }
        Some(rate)
    }

    /// `d groove / dp_j` at every point; none without a groove.
    pub(crate) fn groove_slope(&self, j: usize, pressure: f64) -> Option<impl Fn(usize) -> f64> {
        let passing = self.passing.as_ref()?;
        let slope = self.wear_slope(1, j, pressure);
        Some(move |i: usize| slope * passing[(i, j)])
    }

    /// Wear rate of a body at a point.
    pub(crate) fn wear(&self, body: usize, i: usize, pressure: f64) -> f64 {
        self.rules[body][i].rate(pressure)
    }

    fn wear_slope(&self, body: usize, i: usize, pressure: f64) -> f64 {
        self.rules[body][i].slope(pressure)
    }

    /// Whether body 2's wear at a point opens the gap there.
    fn adds(&self) -> bool {
        self.counterface == Counterface::Congruent
    }

    /// Part of the gap rate that depends on the pressure at the point alone.
    pub(crate) fn local(&self, i: usize, pressure: f64) -> f64 {
        self.wear(0, i, pressure) + if self.adds() { self.wear(1, i, pressure) } else { 0.0 }
    }

    /// `d local / dp`.
    pub(crate) fn local_slope(&self, i: usize, pressure: f64) -> f64 {
        self.wear_slope(0, i, pressure) + if self.adds() { self.wear_slope(1, i, pressure) } else { 0.0 }
    }

    /// Whether body 2 recedes as a whole.
    pub(crate) fn recedes(&self) -> bool {
        self.counterface == Counterface::Revolving && self.rules[1].iter().any(LocalRule::wears)
    }

    /// Mean wear rate of body 2 along its closed track.
    pub(crate) fn recession(&self, pressure: &[f64]) -> f64 {
        if !self.recedes() {
            return 0.0;
        }
        pressure.iter().enumerate().map(|(i, p)| self.share[i] * self.wear(1, i, *p)).sum()
    }

    /// `d recession / dp_i`.
    pub(crate) fn recession_slope(&self, i: usize, pressure: f64) -> f64 {
        if self.recedes() { self.share[i] * self.wear_slope(1, i, pressure) } else { 0.0 }
    }

    /// Gap rate at all points.
    pub(crate) fn total(&self, pressure: &[f64]) -> Vec<f64> {
        let recession = self.recession(pressure);
        let mut total: Vec<f64> = pressure.iter().enumerate().map(|(i, p)| self.local(i, *p) + recession).collect();
        self.groove(pressure).iter().for_each(|groove| total.iter_mut().zip(groove).for_each(|(rate, g)| *rate += g));
        total
    }

    /// Density of `Phi` at a point.
    pub(crate) fn potential(&self, i: usize, pressure: f64) -> f64 {
        let of = |body: usize| self.rules[body][i].potential(pressure);
        let [first, second] = [of(0), if self.counterface == Counterface::Fresh { 0.0 } else { of(1) }];
        first + second
    }

    /// Whether every rate is proportional to the pressure.
    pub(crate) fn is_linear(&self) -> bool {
        self.rules.iter().flatten().all(LocalRule::is_linear)
    }

    /// The pressure `p` with `stiffness p + step local(p) = u > 0`, and `dp/du`.
    pub(crate) fn inverse(&self, i: usize, stiffness: f64, step: f64, u: f64) -> (f64, f64) {
        let both = [&self.rules[0][i], &self.rules[1][i]];
        resisted_pressure(stiffness, step, &both[..if self.adds() { 2 } else { 1 }], u)
    }
}
