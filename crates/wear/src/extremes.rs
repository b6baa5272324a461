//! Smallest and largest pressure of a solution over the closed surface.

use crate::stage::{Node, Stage};

/// Over the nodes, the ends of the surface, and the smooth extremum next to the extreme node.
pub(crate) fn extremes(stage: &Stage<'_>, nodes: &[Node], pressure: &[f64]) -> (f64, f64) {
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    let (mut lowest, mut highest) = (0, 0);
    for (i, value) in pressure.iter().enumerate() {
        if *value < low {
            (low, lowest) = (*value, i);
        }
        if *value > high {
            (high, highest) = (*value, i);
        }
    }
    let (node_low, node_high) = (low, high);
    stage.problem.surface.survey(&mut |point| {
        let value = stage.law.log_pressure(&stage.law.node(*point)).exp();
        (low, high) = (low.min(value), high.max(value));
    });
    if stage.problem.surface.is_listed() || nodes.is_empty() {
        return (low, high);
    }
    // An end of the surface that exceeds every node needs no search.
    if high <= node_high * (1.0 + 1e-12) || stage.problem.surface.outer_range().is_some() {
        high = high.max(polished(stage, nodes, highest, 1.0).exp());
    }
    if low > 0.0 && (low >= node_low * (1.0 - 1e-12) || stage.problem.surface.outer_range().is_some()) {
        low = low.min((-polished(stage, nodes, lowest, -1.0)).exp());
    }
    (low, high)
}

/// Largest sign * log p near a node, by golden section between its neighbours, one parameter after the other.
fn polished(stage: &Stage<'_>, nodes: &[Node], best: usize, sign: f64) -> f64 {
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
    found
}
