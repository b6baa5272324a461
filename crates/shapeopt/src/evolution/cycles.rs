//! Cycles of a schedule that repeats, once each wears like the one before.

use crate::evolution::Evolution;
use crate::rigid_wear::inside;
use crate::wear_state::WearState;

impl Evolution<'_> {
    /// How far the wear `d = g_after - g_before` of a cycle, from a state at the end of one to that at the end of the next, is from a rigid feed:
    /// `max |d - Proj d| / max |g - Proj g|`, a number. Nothing but the rigid part is left in the limit, where each cycle begins with the pressure of the
    /// one before. Points that are open all the time count where the feed closes them.
    pub fn strayed(&self, before: &WearState, after: &WearState) -> f64 {
        let (worn, rest) = self.parts(before, after);
        let most = worn.iter().zip(&rest).map(|(w, r)| if *w > 0.0 { r.abs() } else { (-r).max(0.0) }).fold(0.0, f64::max);
        let acting = self.load(after);
        let gap = acting.rigid.rest(&inside(&acting.load.weights, &worn), &after.gap);
        most / gap.iter().fold(0.0_f64, |size, gap| size.max(gap.abs()))
    }

    /// The state after `count` more cycles like the one between two states, each of which feeds on by the rigid part of what that has worn. The second
    /// state is whole and the end of its cycle.
    pub fn after_cycles(&self, before: &WearState, after: &WearState, count: usize) -> WearState {
        let (grown, rest) = self.parts(before, after);
        let times = count as f64;
        let on = |now: f64, before: f64| now + times * (now - before);
        // Where a point wears, its two bodies have their shares of the rigid part.
        let part = |i: usize| if grown[i] > 0.0 { times * (grown[i] - rest[i]) / grown[i] } else { times };
        let pointwise = |now: &[f64], before: &[f64]| -> Vec<f64> {
            now.iter().zip(before).enumerate().map(|(i, (now, before))| now + part(i) * (now - before)).collect()
        };
        let interval_start = after.interval_start + times * (after.time - before.time);
        let mut state = WearState {
            step: after.step + 1,
            // To the bit, else the rest would be a step of its own.
            time: interval_start + self.problem.schedule[after.interval].duration,
            distance: on(after.distance, before.distance),
            gap: pointwise(&after.gap, &before.gap),
            worn: pointwise(&after.worn, &before.worn),
            recession: on(after.recession, before.recession),
            volume: [0, 1].map(|body| on(after.volume[body], before.volume[body])),
            interval: after.interval + count * (after.interval - before.interval),
            interval_start,
            error: 0.0,
            ..after.clone()
        };
        state.step_size = state.time - after.time;
        state.depth = self.problem.deepest(&state.worn);
        state
    }

    /// Time and distance at which a depth is worn off between states that are all cycles but the last apart: as in the last one, from which
    /// the states on are given, and so many cycles earlier.
    pub(crate) fn worn_off_alike(&self, [from, to]: [&WearState; 2], on: &[WearState], depth: f64) -> Option<[f64; 2]> {
        let cycle = self.problem.schedule.len() - 1 - to.interval;
        let count = ((to.interval - from.interval) / cycle) as f64;
        let each = |value: fn(&WearState) -> f64| (value(to) - value(from)) / count;
        let earlier = ((to.depth - depth) / each(|state| state.depth)).ceil();
        let deeper = depth + earlier * each(|state| state.depth);
        let [time, distance] =
            if deeper <= to.depth { [to.time, to.distance] } else { self.worn_off(on, deeper.min(on.last()?.depth))? };
        Some([time - earlier * each(|state| state.time), distance - earlier * each(|state| state.distance)])
    }

    /// Growth of the gap between two states, and what of it is no rigid motion, at each point.
    fn parts(&self, before: &WearState, after: &WearState) -> (Vec<f64>, Vec<f64>) {
        let grown: Vec<f64> = after.gap.iter().zip(&before.gap).map(|(after, before)| after - before).collect();
        let acting = self.load(after);
        let rest = acting.rigid.rest(&inside(&acting.load.weights, &grown), &grown);
        (grown, rest)
    }
}
