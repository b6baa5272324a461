//! Where the contact surface of a round body that wears is cut: the end of contact moves from that of the start to that of the end, and the
//! cells under it are about as long as a part of its distance from the middle.

use crate::stage::Stage;

/// Ratio of successive break points.
const GROWTH: f64 = 1.3;
/// The same where wear is no linear function of the pressure: the depth then keeps what each element got wrong while the end of contact passed it, and
/// falls with the square of their length; the volume of linear wear is exact at any time.
const FINER: f64 = 1.14;
/// Ratio below which the ends at start and end are one break point: a cell between them would be a splinter, and fold where the body is curved.
const APART: f64 = 1.05;
/// Length of the surface that may touch over that of the contact at the end.
pub(super) const CANDIDATE: f64 = 1.2;

/// Break points from the middle (mm), the last of them at the end of contact after the run.
pub(super) fn breaks(start: f64, end: f64, linear: bool) -> Vec<f64> {
    let growth = if linear { GROWTH } else { FINER };
    let first = if end < APART * start { end } else { start };
    let count = ((end / first).ln() / growth.ln() * (1.0 - 1e-9)).ceil().max(0.0) as usize;
    let mut breaks = vec![0.5 * first];
    breaks.extend((0..count).map(|i| first * (end / first).powf(i as f64 / count as f64)));
    breaks.push(end);
    breaks
}

/// Break points beyond the end of contact after a run on whose way it was wider: what was worn there stays, with a kink where the contact turned back.
pub(super) fn left(end: f64, widest: f64, linear: bool) -> Vec<f64> {
    if widest < APART * end {
        return Vec::new();
    }
    let growth = if linear { GROWTH } else { FINER };
    let count = ((widest / end).ln() / growth.ln()).ceil();
    (1..=count as usize).map(|i| end * (widest / end).powf(i as f64 / count)).collect()
}

/// The same places from -1 to 1 along a surface that reaches as far as `reach` from the middle.
pub(super) fn along(stage: Stage<'_>, breaks: &[f64], reach: f64) -> Vec<f64> {
    let part = breaks.iter().map(|x| x / reach);
    if stage.couple.is_revolved() { part.map(|part| 2.0 * part - 1.0).collect() } else { part.collect() }
}

#[cfg(test)]
mod tests {
    use super::{breaks, left};

    #[test]
    fn no_cell_is_a_splinter() {
        for end in [1e-6, 1e-3, 0.9, 1.0, 1.0 + 1e-9, 1.001, 1.049, 1.051, 1.3, 2.0, 40.0] {
            let breaks = breaks(1.0, end, false);
            assert!(breaks.windows(2).all(|pair| pair[1] > 1.04 * pair[0] && pair[1] < 2.01 * pair[0]), "{end}: {breaks:?}");
            assert_eq!(breaks.last(), Some(&end));
        }
    }

    #[test]
    fn beyond_the_end_cells_reach_to_where_the_contact_was_widest() {
        assert!(left(1.0, 1.04, false).is_empty() && left(1.0, 0.5, true).is_empty());
        for (widest, linear) in [(1.06, true), (1.3, false), (1.5, true), (7.0, false)] {
            let places = [vec![1.0], left(1.0, widest, linear)].concat();
            assert!(places.windows(2).all(|pair| pair[1] > 1.04 * pair[0] && pair[1] < 1.301 * pair[0]), "{widest}: {places:?}");
            assert!((places[places.len() - 1] / widest - 1.0).abs() < 1e-12 && places.len() > 1);
        }
    }
}
