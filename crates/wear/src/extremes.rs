//! Smallest and largest pressure of a solution over the closed surface.

use crate::SurfacePoint;
use crate::pressure_law::Node;
use crate::stage::Stage;

/// Smallest and largest pressure in MPa.
pub(crate) struct Extremes {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// A place of the largest pressure.
    pub(crate) highest: SurfacePoint,
}

/// Over the nodes, the ends of the surface, and the smooth extremum next to the extreme node.
pub(crate) fn extremes(stage: &Stage<'_>, nodes: &[Node], pressure: &[f64]) -> Extremes {
    let surface = &stage.problem.surface;
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    let (mut lowest, mut largest) = (0, 0);
    for (i, value) in pressure.iter().enumerate() {
        if *value < low {
            (low, lowest) = (*value, i);
        }
        if *value > high {
            (high, largest) = (*value, i);
        }
    }
    let (node_low, node_high) = (low, high);
    let mut highest = nodes.get(largest).map(|node| node.point);
    surface.survey(&mut |point| {
        let value = stage.law.log_pressure(&stage.law.node(*point)).exp();
        if value > high || highest.is_none() {
            highest = Some(*point);
        }
        (low, high) = (low.min(value), high.max(value));
    });
    let mut highest = highest.unwrap_or_else(|| surface.at(0.0, 0.0));
    if surface.is_listed() || nodes.is_empty() {
        return Extremes { low, high, highest };
    }
    // An end of the surface that exceeds every node needs no search.
    if high <= node_high * (1.0 + 1e-12) || surface.outer_range().is_some() {
        let (value, at) = polished(stage, nodes, largest, 1.0);
        if value.exp() > high {
            highest = surface.at(at[0], at[1]);
        }
        high = high.max(value.exp());
    }
    if low > 0.0 && (low >= node_low * (1.0 - 1e-12) || surface.outer_range().is_some()) {
        low = low.min((-polished(stage, nodes, lowest, -1.0).0).exp());
    }
    Extremes { low, high, highest }
}

/// Largest sign * log p near a node and its parameters, by golden section between its neighbours, one parameter after the other.
fn polished(stage: &Stage<'_>, nodes: &[Node], best: usize, sign: f64) -> (f64, [f64; 2]) {
    let surface = &stage.problem.surface;
    let value = |at: [f64; 2]| sign * stage.law.log_pressure(&stage.law.node(surface.at(at[0], at[1])));
    let mut at = nodes[best].parameter;
    let directions = if surface.outer_range().is_some() { 2 } else { 1 };
    let mut found = value(at);
    for _ in 0..(2 * directions - 1) {
        for direction in 0..directions {
            let range = if direction == 0 { Some(surface.inner_range()) } else { surface.outer_range() };
            let [mut lo, mut hi] = range.unwrap_or([0.0; 2]);
            for node in nodes {
                let u = node.parameter[direction];
                if u < at[direction] {
                    lo = lo.max(u);
                } else if u > at[direction] {
                    hi = hi.min(u);
                }
            }
            let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
            let along = |u: f64| {
                let mut place = at;
                place[direction] = u;
                value(place)
            };
            let (mut a, mut b) = (hi - ratio * (hi - lo), lo + ratio * (hi - lo));
            let (mut fa, mut fb) = (along(a), along(b));
            for _ in 0..40 {
                if fa >= fb {
                    (hi, b, fb) = (b, a, fa);
                    a = hi - ratio * (hi - lo);
                    fa = along(a);
                } else {
                    (lo, a, fa) = (a, b, fb);
                    b = lo + ratio * (hi - lo);
                    fb = along(b);
                }
            }
            let (u, larger) = if fa >= fb { (a, fa) } else { (b, fb) };
            if larger > found {
                found = larger;
                at[direction] = u;
            }
        }
    }
    (found, at)
}
