//! How high an axis has to reach: to the largest value, unless that is a spike on a small part of the axis, whose rest would be lost.

use crate::brief::brief;

/// Share of the length along x that lies below the level a spike is measured by.
const SHARE: f64 = 0.97;
/// How far above that level a peak must be to be cut off, and how far above it the axis then reaches.
const SPIKE: f64 = 3.0;
const ROOM: f64 = 1.3;
/// Fewest points of a curve that is judged.
const POINTS: usize = 20;

/// Where the axis ends, with the peak that lies beyond it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reach {
    /// The largest value drawn.
    pub(crate) high: f64,
    /// Place and value of the peak.
    pub(crate) peak: [f64; 2],
}

impl Reach {
    /// The words that stand where a peak is cut off.
    pub(crate) fn note(&self) -> String {
        format!("cut off: up to {} at {}", brief(self.peak[1]), brief(self.peak[0])).replace('-', "\u{2212}")
    }
}

/// Where an axis ends that would lose its curves otherwise; none where it holds all of them.
pub(crate) fn reach<'a>(curves: impl Iterator<Item = &'a [(f64, f64)]>) -> Option<Reach> {
    let (mut level, mut peak) = (0.0_f64, [0.0_f64; 2]);
    for curve in curves {
        let points: Vec<(f64, f64)> = curve.iter().copied().filter(|point| point.0.is_finite() && point.1.is_finite()).collect();
        let top = points.iter().fold([0.0_f64; 2], |top, point| if point.1 > top[1] { [point.0, point.1] } else { top });
        peak = if top[1] > peak[1] { top } else { peak };
        level = level.max(if points.len() < POINTS { top[1] } else { usual(&points, top[1]) });
    }
    (level > 0.0 && peak[1] > SPIKE * level).then_some(Reach { high: ROOM * level, peak })
}

/// Sorts values, each with its share of the whole.
pub(crate) fn by_value(rows: &mut [(f64, f64)]) {
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
}

/// The value that a share of the curve's length stays below; where the curve is zero it does not count.
fn usual(points: &[(f64, f64)], top: f64) -> f64 {
    let last = points.len() - 1;
    let length = |k: usize| 0.5 * (points[(k + 1).min(last)].0 - points[k.saturating_sub(1)].0).abs();
    let mut rows: Vec<(f64, f64)> = (0..=last).map(|k| (points[k].1, length(k))).filter(|row| row.0.abs() > 1e-9 * top).collect();
    by_value(&mut rows);
    let whole: f64 = rows.iter().map(|row| row.1).sum();
    let mut below = 0.0;
    let found = rows.iter().find(|row| {
        below += row.1;
        below >= SHARE * whole
    });
    found.map_or(top, |row| row.0)
}

#[cfg(test)]
mod tests {
    use super::reach;

    fn curve(value: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        (0..=400).map(|k| f64::from(k) / 200.0 - 1.0).map(|x| (x, value(x))).collect()
    }

    #[test]
    fn one_spike_does_not_take_the_axis_and_is_said() {
        let spiked = curve(|x| if x > 0.999 { 1002.0 } else { 1.5 + x });
        let found = reach([spiked.as_slice()].into_iter());
        assert!(found.is_some_and(|found| found.high > 2.4 && found.high < 4.0), "{found:?}");
        assert_eq!(found.map(|found| found.note()).as_deref(), Some("cut off: up to 1002 at 1"));
    }

    #[test]
    fn a_curve_that_is_high_on_a_part_that_can_be_seen_is_drawn_whole() {
        let start = curve(|x| if x > 0.9 { 9.0 } else { 2.0 });
        let narrow = curve(|x| 3600.0 * (1.0 - x * x / 0.01).max(0.0).sqrt());
        let steady = curve(|_| 2.4);
        assert_eq!(reach([start.as_slice(), steady.as_slice()].into_iter()), None);
        assert_eq!(reach([narrow.as_slice()].into_iter()), None);
    }
}
