//! The rate at which wear opens the gap, and its implicit inverse.

use faer::Mat;
use wear::{Counterface, LocalRule, WearPair, resisted_pressure};

/// `w_1'` of body 1 plus what body 2 adds to the gap, at every point. Where several loads act by turns, in cycles short against wear, each point stands
/// once for every load, one load after the other, and a place wears by the mean of their rates.
pub(crate) struct GapRate {
    /// Rule of each body at the points.
    rules: [Vec<LocalRule>; 2],
    counterface: Counterface,
    /// Part of the time that acts at each point.
    part: Vec<f64>,
    /// Number of places: of the points of one load.
    places: usize,
    /// Weight over track area.
    share: Vec<f64>,
    /// The gap at the start, where body 2 opens it by its wear too.
    start: Option<Vec<f64>>,
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
        let share = weights.iter().map(|w| w / track).collect();
        GapRate { rules, counterface, part: vec![1.0; weights.len()], places: weights.len(), share, start: None, passing: None }
    }

    /// The mean of rates at the same places, each acting a part of the time.
    pub(crate) fn mean(rates: Vec<(GapRate, f64)>) -> Option<GapRate> {
        let mut rates = rates.into_iter().map(|(rate, part)| GapRate { part: vec![part; rate.places], ..rate });
        let mut mean = rates.next()?;
        for rate in rates {
            let [first, second] = rate.rules;
            mean.rules[0].extend(first);
            mean.rules[1].extend(second);
            mean.part.extend(rate.part);
            mean.share.extend(rate.share);
        }
        Some(mean)
    }

    /// Number of places.
    pub(crate) fn places(&self) -> usize {
        self.places
    }

    /// Part of the time that acts at a point.
    pub(crate) fn part(&self, i: usize) -> f64 {
        self.part[i]
    }

    /// The points of a place.
    pub(crate) fn at_place(&self, place: usize) -> impl Iterator<Item = usize> + '_ {
        (place..self.part.len()).step_by(self.places.max(1))
    }

    /// Mean over the time of one value a point, at the places.
    pub(crate) fn in_mean(&self, values: &[f64]) -> Vec<f64> {
        (0..self.places).map(|place| self.at_place(place).map(|i| self.part[i] * values[i]).sum()).collect()
    }

    /// Whether several loads act by turns.
    pub(crate) fn turns(&self) -> bool {
        self.part.len() > self.places
    }

    /// Rates of the other loads at the place of each point; none under one load.
    fn others(&self, pressure: &[f64]) -> Option<Vec<f64>> {
        if !self.turns() {
            return None;
        }
        let own: Vec<f64> = pressure.iter().enumerate().map(|(i, p)| self.local(i, *p)).collect();
        let place = |i: usize| self.at_place(i % self.places).filter(|j| *j != i).map(|j| own[j]).sum();
        Some((0..own.len()).map(place).collect())
    }

    /// What pressures at other points of the bodies wear off at each point, per second; none where that is nothing.
    pub(crate) fn elsewhere(&self, pressure: &[f64]) -> Option<Vec<f64>> {
        self.others(pressure).or_else(|| self.groove(pressure))
    }

    /// The same from a gap at the start, where body 2 opens it too.
    pub(crate) fn opened_by_both(self, start: Option<Vec<f64>>) -> GapRate {
        GapRate { start, ..self }
    }

    /// The largest depth of wear in a gap: what is worn off body 1, and off body 2 where that opens the gap too.
    pub(crate) fn deepest(&self, gap: &[f64], worn: &[f64]) -> f64 {
        match &self.start {
            Some(start) => gap.iter().zip(start).map(|(now, start)| now - start).fold(0.0, f64::max),
            None => worn.iter().copied().fold(0.0, f64::max),
        }
    }

    /// Wear rate of a body at the places.
    pub(crate) fn worn(&self, body: usize, place: usize, pressure: &[f64]) -> f64 {
        self.at_place(place).map(|i| self.wear(body, i, pressure[i])).sum()
    }

    /// The same with the groove that body 2 wears as it passes.
    pub(crate) fn passing(self, passing: Option<Mat<f64>>) -> GapRate {
        GapRate { passing: passing.filter(|_| self.rules[1].iter().any(LocalRule::wears)), ..self }
    }

    /// Rate of the groove at all points; none without one.
    fn groove(&self, pressure: &[f64]) -> Option<Vec<f64>> {
        let passing = self.passing.as_ref()?;
        let mut rate = vec![0.0; pressure.len()];
        for (j, p) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
            let own = self.wear(1, j, *p);
            rate.iter_mut().zip(passing.col_as_slice(j)).for_each(|(rate, share)| *rate += share * own);
        }
        Some(rate)
    }

    /// `d groove / dp_j` at every point over the slope of body 2's wear rate at point `j`, and that slope; none without a groove.
    pub(crate) fn groove_slope(&self, j: usize, pressure: f64) -> Option<(&[f64], f64)> {
        Some((self.passing.as_ref()?.col_as_slice(j), self.wear_slope(1, j, pressure)))
    }

    /// Mean wear rate of a body at a point.
    pub(crate) fn wear(&self, body: usize, i: usize, pressure: f64) -> f64 {
        self.part[i] * self.rules[body][i].rate(pressure)
    }

    fn wear_slope(&self, body: usize, i: usize, pressure: f64) -> f64 {
        self.part[i] * self.rules[body][i].slope(pressure)
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

    /// Gap rate at all places.
    pub(crate) fn total(&self, pressure: &[f64]) -> Vec<f64> {
        let recession = self.recession(pressure);
        let local = |place: usize| -> f64 { self.at_place(place).map(|i| self.local(i, pressure[i])).sum() };
        let mut total: Vec<f64> = (0..self.places).map(|place| local(place) + recession).collect();
        self.groove(pressure).iter().for_each(|groove| total.iter_mut().zip(groove).for_each(|(rate, g)| *rate += g));
        total
    }

    /// Gap rate at all places while each load acts.
    pub(crate) fn by_turns(&self, pressure: &[f64]) -> Vec<Vec<f64>> {
        if !self.turns() {
            return vec![self.total(pressure)];
        }
        let alone = |i: usize| if self.part[i] > 0.0 { self.local(i, pressure[i]) / self.part[i] } else { 0.0 };
        let recession =
            |i: usize| if self.part[i] > 0.0 { self.share[i] * self.wear(1, i, pressure[i]) / self.part[i] } else { 0.0 };
        (0..self.part.len())
            .step_by(self.places.max(1))
            .map(|first| {
                let points = first..first + self.places;
                let fed: f64 = if self.recedes() { points.clone().map(recession).sum() } else { 0.0 };
                points.map(|i| alone(i) + fed).collect()
            })
            .collect()
    }

    /// Density of `Phi` at a point.
    pub(crate) fn potential(&self, i: usize, pressure: f64) -> f64 {
        let of = |body: usize| self.part[i] * self.rules[body][i].potential(pressure);
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
        resisted_pressure(stiffness, step * self.part[i], &both[..if self.adds() { 2 } else { 1 }], u)
    }
}
