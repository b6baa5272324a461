//! Where a zone of contact, or of stick, begins and ends between points.

use crate::point::ContactPoint;

/// Arcs between the ends of the active zones. An end between an active and an idle point is placed where the square of `force / weight`,
/// linear near a smooth end, vanishes. Along a closed boundary of the length `turn` point 0 is the last one too, and a zone across it is told as two.
pub(crate) fn zones(points: &[ContactPoint], active: &[bool], force: &[f64], turn: Option<f64>) -> Vec<[f64; 2]> {
    let n = points.len() + usize::from(turn.is_some());
    let active = |i: usize| active[i % points.len()];
    let pressure = |i: usize| force[i % points.len()] / points[i % points.len()].weight;
    let arc = |i: usize| points.get(i).map_or(turn.unwrap_or_default(), |point| point.arc);
    let end = |inside: usize, before: Option<usize>, outside: Option<usize>| {
        let Some(outside) = outside else { return arc(inside) };
        let (low, high) = (arc(inside), arc(outside));
        let Some(before) = before else { return 0.5 * (low + high) };
        let (a, b) = (pressure(before).powi(2), pressure(inside).powi(2));
        if a <= b {
            return 0.5 * (low + high);
        }
        let reach = (low - arc(before)).abs() * b / (a - b);
        if high > low { low + reach.min(high - low) } else { low - reach.min(low - high) }
    };
    let mut zones = Vec::new();
    let mut i = 0;
    while i < n {
        if !active(i) {
            i += 1;
            continue;
        }
        let start = i;
        while i + 1 < n && active(i + 1) {
            i += 1;
        }
        let inner = |k: usize| (start..=i).contains(&k).then_some(k);
        let left = end(start, inner(start + 1), start.checked_sub(1));
        let right = end(i, i.checked_sub(1).and_then(inner), Some(i + 1).filter(|k| *k < n));
        zones.push([left, right]);
        i += 1;
    }
    zones
}

/// Share of the surface below which a gap or a zone is none.
const TINY: f64 = 1e-6;

/// Zones on a surface of the given length without gaps and zones shorter than a millionth of it, which only layers around an edge too sharp for
/// them show. Zones are ranges of arc length, ascending.
pub fn without_slivers(zones: &[[f64; 2]], length: f64) -> Vec<[f64; 2]> {
    let near = TINY * length;
    let mut kept: Vec<[f64; 2]> = Vec::new();
    for [from, to] in zones {
        match kept.last_mut() {
            Some(last) if from - last[1] < near => last[1] = *to,
            _ => kept.push([*from, *to]),
        }
    }
    kept.retain(|[from, to]| to - from >= near);
    kept
}

/// `count` (two or more) evenly spaced arc lengths on the inner 95 %: without a fortieth of the surface at its ends, or of the contact where that
/// ends before.
pub fn inner_places(zones: &[[f64; 2]], length: f64, count: usize) -> Vec<f64> {
    let (from, to) = (zones.first().map_or(0.0, |zone| zone[0]), zones.last().map_or(0.0, |zone| zone[1]));
    let (low, high) = ((from + 0.025 * (to - from)).max(0.025 * length), (to - 0.025 * (to - from)).min(0.975 * length));
    (0..count).map(|i| low + (high - low) * i as f64 / (count - 1) as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::{inner_places, without_slivers};

    #[test]
    fn slivers_of_contact_and_of_gap_are_left_out() {
        let zones = [[0.0, 1e-6], [1.0, 4.0], [4.0 + 1e-6, 7.0], [9.0, 10.0]];
        assert_eq!(without_slivers(&zones, 10.0), [[1.0, 7.0], [9.0, 10.0]]);
    }

    #[test]
    fn inner_places_keep_off_the_ends_of_surface_and_contact() {
        assert_eq!(inner_places(&[[0.0, 40.0]], 40.0, 3), [1.0, 20.0, 39.0]);
        assert_eq!(inner_places(&[[10.0, 14.0], [20.0, 50.0]], 80.0, 3), [11.0, 30.0, 49.0]);
    }
}
