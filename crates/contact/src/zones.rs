//! Where a zone of contact, or of stick, begins and ends between points.

use crate::point::ContactPoint;

/// Arcs between the ends of the active zones. An end between an active and an idle point is placed where the square of `force / weight`,
/// linear near a smooth end, vanishes.
pub(crate) fn zones(points: &[ContactPoint], active: &[bool], force: &[f64]) -> Vec<[f64; 2]> {
    let n = points.len();
    let pressure = |i: usize| force[i] / points[i].weight;
    let arc = |i: usize| points[i].arc;
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
        if !active[i] {
            i += 1;
            continue;
        }
        let start = i;
        while i + 1 < n && active[i + 1] {
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
