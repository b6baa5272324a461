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

/// Most rounds over both parameters of a surface on which the neighbours of the best node have not bracketed the extremum.
const ROUNDS: usize = 40;
/// Part of the surface searched on either side in such a round.
const WINDOW: f64 = 0.125;
/// Gain in log p below which such a round has found nothing.
const GAIN: f64 = 1e-9;

/// Largest sign * log p near a node and its parameters: between its neighbours, one parameter after the other, and over wider windows
/// where that finds more, as on the curved border of a surface whose lines are cut at different places.
fn polished(stage: &Stage<'_>, nodes: &[Node], best: usize, sign: f64) -> (f64, [f64; 2]) {
    let surface = &stage.problem.surface;
    let value = |at: [f64; 2]| sign * stage.law.log_pressure(&stage.law.node(surface.at(at[0], at[1])));
    let ranges = [Some(surface.inner_range()), surface.outer_range()];
    let mut at = nodes[best].parameter;
    let directions = if surface.outer_range().is_some() { 2 } else { 1 };
    let mut found = value(at);
    let mut climb = |at: &mut [f64; 2], direction: usize, [lo, hi]: [f64; 2], gain: f64| {
        let place = *at;
        let (u, larger) = golden(lo, hi, |u| value(std::array::from_fn(|i| if i == direction { u } else { place[i] })));
        let higher = larger > found + gain;
        if higher {
            (found, at[direction]) = (larger, u);
        }
        higher
    };
    for _ in 0..(2 * directions - 1) {
        for direction in 0..directions {
            let [mut lo, mut hi] = ranges[direction].unwrap_or([0.0; 2]);
            for node in nodes {
                let u = node.parameter[direction];
                if u < at[direction] {
                    lo = lo.max(u);
                } else if u > at[direction] {
                    hi = hi.min(u);
                }
            }
            climb(&mut at, direction, [lo, hi], 0.0);
        }
    }
    for _ in 0..(if directions == 2 { ROUNDS } else { 0 }) {
        let mut higher = false;
        for direction in 0..directions {
            let [from, to] = ranges[direction].unwrap_or([0.0; 2]);
            let reach = WINDOW * (to - from);
            let window = [(at[direction] - reach).max(from), (at[direction] + reach).min(to)];
            higher |= climb(&mut at, direction, window, GAIN);
        }
        if !higher {
            break;
        }
    }
    (found, at)
}

/// The largest value between two places by golden section, and where.
pub(crate) fn golden(mut lo: f64, mut hi: f64, value: impl Fn(f64) -> f64) -> (f64, f64) {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (hi - ratio * (hi - lo), lo + ratio * (hi - lo));
    let (mut fa, mut fb) = (value(a), value(b));
    for _ in 0..40 {
        if fa >= fb {
            (hi, b, fb) = (b, a, fa);
            a = hi - ratio * (hi - lo);
            fa = value(a);
        } else {
            (lo, a, fa) = (a, b, fb);
            b = lo + ratio * (hi - lo);
            fb = value(b);
        }
    }
    if fa >= fb { (a, fa) } else { (b, fb) }
}
