//! Where one boundary meets the normals of another.

use crate::point::{ContactPoint, along, difference};
use hpfem::Trace;

/// Whether two boundaries are the same edges with the same parameter, up to round-off.
pub(crate) fn coincide(a: &Trace, b: &Trace) -> bool {
    let same = |edge: usize, t: f64| {
        let d = difference(a.edges[edge].curve.point(t), b.edges[edge].curve.point(t));
        d[0].hypot(d[1]) <= 1e-9 * a.length()
    };
    a.edges.len() == b.edges.len() && (0..a.edges.len()).all(|edge| [-1.0, -0.5, 0.0, 0.5, 1.0].iter().all(|t| same(edge, *t)))
}

/// Where the normals of two boundaries are not opposite at the same edge and parameter: the edge, and how far a length of the boundary lies off by
/// that angle.
pub(crate) fn unlike_normal(a: &Trace, b: &Trace) -> Option<(usize, f64)> {
    if a.edges.len() != b.edges.len() {
        return Some((a.edges.len().min(b.edges.len()), a.length()));
    }
    let off = |edge: usize, t: f64| {
        let [one, other] = [a, b].map(|trace| trace.boundary_point(edge, t).0.outward);
        (one[0] + other[0]).hypot(one[1] + other[1])
    };
    let places = (0..a.edges.len()).flat_map(|edge| [-1.0, 0.0, 1.0].map(|t| (edge, off(edge, t))));
    places.into_iter().find(|(_, off)| off.is_nan() || *off > 1e-9).map(|(edge, off)| (edge, off * a.length()))
}

/// Where edges of two boundaries with the same number are not of the same length: the edge, and the difference.
pub(crate) fn unlike_length(a: &Trace, b: &Trace) -> Option<(usize, f64)> {
    if a.edges.len() != b.edges.len() {
        return Some((a.edges.len().min(b.edges.len()), a.length()));
    }
    let off = |edge: usize| (a.edges[edge].curve.length() - b.edges[edge].curve.length()).abs();
    (0..a.edges.len()).map(|edge| (edge, off(edge))).find(|(_, off)| off.is_nan() || *off > 1e-9 * a.length())
}

/// The place of a boundary on the normal line through a point, the nearest if there are several, and its distance along the normal. Where the line
/// passes by all edges, as by round-off at a break point or where the boundary ends a little early, it is the end that it passes closest by: there are
/// edges shorter than that little.
pub(crate) fn crossing(trace: &Trace, point: &ContactPoint) -> Option<((usize, f64), f64)> {
    let slack = 1e-9 * trace.length();
    let mut nearest: Option<((usize, f64), f64)> = None;
    let (mut closest, mut least) = (None, f64::INFINITY);
    for (number, edge) in trace.edges.iter().enumerate() {
        let across = |t: f64| along(point.tangent, difference(edge.curve.point(t), point.position));
        let (from, to) = (across(-1.0), across(1.0));
        if from.min(to) > slack || from.max(to) < -slack || from == to {
            continue;
        }
        let mut t = ((from + to) / (from - to)).clamp(-1.0, 1.0);
        for _ in 0..50 {
            let step = across(t) / along(point.tangent, edge.curve.derivative(t));
            t = (t - step).clamp(-1.0, 1.0);
            if step.is_nan() || step.abs() < 1e-15 {
                break;
            }
        }
        let distance = along(point.normal, difference(edge.curve.point(t), point.position));
        let off = across(t).abs();
        if off.is_nan() || off > slack {
            continue;
        }
        let meets = from.min(to) <= 0.0 && from.max(to) >= 0.0;
        if meets && nearest.is_none_or(|(_, d)| distance.abs() < d.abs()) {
            nearest = Some(((number, t), distance));
        }
        if off < least {
            (closest, least) = (Some(((number, t), distance)), off);
        }
    }
    nearest.or(closest)
}

/// Parameters on an edge at whose normals the break points of another boundary lie, in ascending order between -1 and 1.
pub(crate) fn breaks_on(edge: usize, own: &Trace, other: &Trace) -> Vec<f64> {
    let curve = &own.edges[edge].curve;
    let vertices = other.edges.iter().map(|e| e.curve.point(-1.0)).chain(other.edges.last().map(|e| e.curve.point(1.0)));
    let mut breaks = vec![-1.0, 1.0];
    for vertex in vertices {
        let behind = |t: f64| along(curve.derivative(t), difference(vertex, curve.point(t))) > 0.0;
        let (mut low, mut high) = (-1.0, 1.0);
        if !behind(low) || behind(high) {
            continue;
        }
        while high - low > 1e-15 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if behind(middle) { low = middle } else { high = middle }
        }
        breaks.push(0.5 * (low + high));
    }
    breaks.sort_unstable_by(f64::total_cmp);
    breaks.dedup_by(|b, a| *b - *a < 1e-10);
    if let Some(last) = breaks.last_mut() {
        *last = 1.0;
    }
    breaks
}

/// Distance of a place from the nearest break point.
pub(crate) fn nearest_break(trace: &Trace, x: [f64; 2]) -> f64 {
    let distance = |t: f64| {
        move |e: &hpfem::TraceEdge| {
            let d = difference(e.curve.point(t), x);
            d[0].hypot(d[1])
        }
    };
    trace.edges.iter().map(distance(-1.0)).chain(trace.edges.iter().map(distance(1.0))).fold(f64::INFINITY, f64::min)
}
