//! Exact cells: quadrature nodes placed so that the density of the moment is integrated to round-off.
//!
//! Cells are halved until log f and log v are smooth on them (fourth difference) and the density varies by less than a fixed factor;
//! at the end of contact, where f = 0, the cell ends exactly there and a Gauss-Jacobi rule takes the power f^k.

use crate::SurfacePoint;
use crate::WearError;
use crate::bracket::Bracket;
use crate::density::Density;
use crate::extremes::golden;
use crate::pressure_law::Node;
use crate::quadrature::{ORDER, Rule, legendre};
use crate::stage::Stage;
use crate::surface::{Shape, Surface};

pub(crate) const SAMPLES: usize = 5;
/// Nodes of a surface beyond which no more are added: the density is steeper than a run should pay for (some 300 MB).
const MOST_NODES: usize = 1_000_000;
/// Nodes of all collections of a solve beyond which it ends: some ten seconds under a rule that is a function.
const MOST_MADE: usize = 10_000_000;
/// Logarithm of a pressure beyond all numbers.
pub(crate) const BEYOND: f64 = 690.0;
const SMOOTH: f64 = 0.03;
/// Largest change of log h dA over a cell for the sake of the area alone; what a power of the pressure makes of a change does not count for areas.
const AREAS: f64 = 2.0;
/// What is round-off of f at s = 1, where it is a ratio less 1.
pub(crate) const ROUND_OFF: f64 = 1e-12;
/// Largest third difference of log p under a rule given as a function, so that a bend of p stands in a cell of 1e-4 of the surface, about.
const BENT: f64 = 1e-4;

impl Surface {
    /// Calls `visit` at a coarse set of points that includes the ends.
    pub(crate) fn survey(&self, visit: &mut dyn FnMut(&SurfacePoint)) {
        if let Shape::Points(points) = self.shape() {
            points.iter().for_each(visit);
            return;
        }
        let [lo, hi] = self.inner_range();
        let [outer_lo, outer_hi] = self.outer_range().unwrap_or([0.0, 0.0]);
        let outer_count = if self.outer_range().is_some() { 8 } else { 0 };
        for j in 0..=outer_count {
            let outer = if j == outer_count { outer_hi } else { outer_lo + (outer_hi - outer_lo) * j as f64 / 8.0 };
            for i in 0..=8 {
                let inner = if i == 8 { hi } else { lo + (hi - lo) * i as f64 / 8.0 };
                visit(&self.at(inner, outer));
            }
        }
    }
}

/// Whether a collection ended for its number of nodes, so that part of the surface is missing from it.
pub(crate) fn cut_short(nodes: &[Node]) -> bool {
    nodes.len() >= MOST_NODES
}

/// Whether a pressure is beyond all numbers, as under a wear rule that does not reach the rate asked for.
pub(crate) fn is_beyond(nodes: &[Node]) -> bool {
    nodes.iter().any(|node| node.log_h >= BEYOND)
}

/// Refuses a collection that [`cut_short`] says is incomplete.
pub(crate) fn whole(nodes: &[Node]) -> Result<(), WearError> {
    if cut_short(nodes) { Err(WearError::TooSteep { nodes: MOST_NODES }) } else { Ok(()) }
}

/// One line of the surface (fixed outer parameter) and the collector of its nodes.
pub(crate) struct Line<'a, 'b> {
    pub(crate) stage: &'a Stage<'b>,
    pub(crate) outer: f64,
    pub(crate) weight: f64,
    pub(crate) settings: Settings,
    pub(crate) front: &'a Rule,
}

/// Limits of one collection.
#[derive(Clone, Copy)]
pub(crate) struct Settings {
    /// Largest change of log h over a cell; below [`AREAS`] without the areas.
    pub(crate) spread: f64,
    /// Cells whose density is smaller than the largest by exp(-drop) are not refined.
    pub(crate) drop: f64,
    /// Smallest power of p that is integrated.
    pub(crate) smallest: f64,
    /// Exponent of f at the end of contact.
    pub(crate) exponent: f64,
}

impl Settings {
    /// Whether values change little enough over a cell, with and without the areas that they are multiplied by.
    pub(crate) fn even(&self, with_areas: &[f64; SAMPLES], without: &[f64; SAMPLES]) -> bool {
        spread(with_areas) < self.spread.max(AREAS) && (self.spread >= AREAS || spread(without) < self.spread)
    }
}

/// An interval with marks for ends at which f = 0.
#[derive(Clone, Copy)]
struct Interval {
    lo: f64,
    hi: f64,
    front: [bool; 2],
}

impl Stage<'_> {
    /// Fills `nodes` with quadrature nodes of the present density; weights are areas.
    pub(crate) fn collect(&self, nodes: &mut Vec<Node>) {
        nodes.clear();
        if let Shape::Points(points) = self.problem.surface.shape() {
            nodes.extend(points.iter().map(|point| self.law.node(*point)));
            return;
        }
        let settings = self.settings();
        let front = self.front_rule.as_ref().unwrap_or(legendre());
        let inner = self.problem.surface.inner_range();
        match self.problem.surface.outer_range() {
            None => {
                let line = Line { stage: self, outer: 0.0, weight: 1.0, settings, front };
                line.collect(inner, nodes);
            }
            Some(outer) => self.collect_lines([outer, inner], settings, front, nodes),
        }
    }

    /// The same, and whether nothing is missing: a collection may be cut short, and all of a solve have a number of nodes that is the last.
    pub(crate) fn collect_within_reason(&mut self, nodes: &mut Vec<Node>) -> bool {
        nodes.clear();
        if self.affordable().is_err() {
            return false;
        }
        self.collect(nodes);
        self.made += nodes.len();
        !cut_short(nodes)
    }

    /// Refuses to go on where a solve has made too many nodes.
    pub(crate) fn affordable(&self) -> Result<(), WearError> {
        if self.made < MOST_MADE { Ok(()) } else { Err(WearError::TooSteep { nodes: MOST_MADE }) }
    }

    /// Adds the nodes of one line of a surface with two parameters, with the area per unit of the outer parameter as weight.
    pub(crate) fn collect_line(&self, outer: f64, nodes: &mut Vec<Node>) {
        let front = self.front_rule.as_ref().unwrap_or(legendre());
        let line = Line { stage: self, outer, weight: 1.0, settings: self.settings(), front };
        line.collect(self.problem.surface.inner_range(), nodes);
    }

    fn settings(&self) -> Settings {
        let powers = self.problem.wear.powers().map(|law| law.pressure_exponent);
        let small = powers[0].min(powers[1]).min(1.0);
        let large = powers[0].max(powers[1]) + 1.0;
        // A density on the way to another is not asked what it wears.
        let large = if self.on_the_way { large.min(1.0 / self.law.density.front_exponent().abs() + 1.0) } else { large };
        Settings {
            spread: 12.0 / large.max(1.5),
            drop: 40.0 / small,
            smallest: small,
            exponent: self.law.density.front_exponent(),
        }
    }
}

impl Line<'_, '_> {
    fn node(&self, inner: f64) -> Node {
        self.stage.law.node(self.stage.problem.surface.at(inner, self.outer))
    }

    pub(crate) fn collect(&self, range: [f64; 2], nodes: &mut Vec<Node>) {
        const BASE: usize = 2;
        let step = (range[1] - range[0]) / BASE as f64;
        let mut stack = [Interval { lo: 0.0, hi: 0.0, front: [false; 2] }; 64];
        let mut depth = 0;
        for i in (0..BASE).rev() {
            let lo = range[0] + step * i as f64;
            let hi = if i + 1 == BASE { range[1] } else { range[0] + step * (i + 1) as f64 };
            stack[depth] = Interval { lo, hi, front: [false; 2] };
            depth += 1;
        }
        let mut top = f64::NEG_INFINITY;
        for i in 0..=4 {
            let node = self.node(range[0] + (range[1] - range[0]) * f64::from(i) / 4.0);
            top = top.max(node.log_h + node.point.weight.ln());
        }
        while depth > 0 && !cut_short(nodes) {
            depth -= 1;
            let cell = stack[depth];
            match self.judge(&cell, &mut top) {
                Verdict::Empty => {}
                Verdict::Take(cell) => self.take(&cell, nodes),
                Verdict::Halve(middle, front) if depth + 2 <= stack.len() => {
                    stack[depth] = Interval { lo: middle, hi: cell.hi, front: [front, cell.front[1]] };
                    stack[depth + 1] = Interval { lo: cell.lo, hi: middle, front: [cell.front[0], front] };
                    depth += 2;
                }
                Verdict::Halve(..) => self.take(&cell, nodes),
            }
        }
    }

    fn judge(&self, cell: &Interval, top: &mut f64) -> Verdict {
        let length = cell.hi - cell.lo;
        let middle = 0.5 * (cell.lo + cell.hi);
        if length <= 0.0 {
            return Verdict::Empty;
        }
        if cell.front == [true, true] {
            return if self.node(middle).f > 0.0 { Verdict::Halve(middle, false) } else { Verdict::Empty };
        }
        // Sample away from an end where f = 0.
        let (start, stop) = match cell.front {
            [true, _] => (0.1, 1.0),
            [_, true] => (0.0, 0.9),
            _ => (0.0, 1.0),
        };
        let place = |i: usize| cell.lo + length * (start + (stop - start) * i as f64 / (SAMPLES - 1) as f64);
        let samples: [Node; SAMPLES] = std::array::from_fn(|i| self.node(place(i)));
        let inside = samples.iter().filter(|node| node.f > 0.0).count();
        if (1..SAMPLES).contains(&inside) {
            return self.at_front(cell, top, &place, &samples);
        }
        if let Some(split) = self.at_hidden(cell, &place, &samples) {
            return split;
        }
        if inside == 0 {
            return Verdict::Empty;
        }
        self.at_kink(cell, &place, &samples).unwrap_or_else(|| self.by_smoothness(cell, top, &place, &samples))
    }

    /// A cell over the end of contact: split there.
    fn at_front(&self, cell: &Interval, top: &mut f64, place: &dyn Fn(usize) -> f64, samples: &[Node; SAMPLES]) -> Verdict {
        let Some(i) = (0..SAMPLES - 1).find(|i| (samples[*i].f > 0.0) != (samples[*i + 1].f > 0.0)) else {
            return Verdict::Empty;
        };
        // At s = 1 the ends of a narrow strip have a width of round-off, which is not looked at digit by digit.
        let even = samples.iter().all(|node| node.f.abs() <= 0.01 * ROUND_OFF);
        if even && matches!(self.stage.law.density, Density::BangBang { .. }) {
            return if samples[SAMPLES / 2].f > 0.0 { Verdict::Take(*cell) } else { Verdict::Empty };
        }
        let root = self.root(place(i), place(i + 1), &|node| node.f);
        let mut marked = *cell;
        if root > cell.lo && root < cell.hi {
            Verdict::Halve(root, true)
        } else if cell.front == [false, false] {
            // f = 0 exactly at an end of the surface.
            marked.front = [root <= cell.lo, root >= cell.hi];
            self.judge(&marked, top)
        } else {
            Verdict::Take(marked)
        }
    }

    /// A cell whose samples have one sign is split at an inner extremum of the other: contact that lies between them, and at s = 1, where all that a place
    /// carries depends on the sign of f, an opening too.
    fn at_hidden(&self, cell: &Interval, place: &dyn Fn(usize) -> f64, samples: &[Node; SAMPLES]) -> Option<Verdict> {
        let closed = samples[0].f > 0.0;
        // Beside an end of contact there is none.
        let elsewhere = closed || cell.front != [false, false];
        if elsewhere && !matches!(self.stage.law.density, Density::BangBang { .. }) {
            return None;
        }
        let side = if closed { -1.0 } else { 1.0 };
        let u = hidden(&samples.map(|node| side * node.f), place, &|u| side * self.node(u).f)?;
        (u > cell.lo && u < cell.hi).then_some(Verdict::Halve(u, false))
    }

    /// A cell over the border of the cap, or over a pressure at which a wear rule bends: split there.
    fn at_kink(&self, cell: &Interval, place: &dyn Fn(usize) -> f64, samples: &[Node; SAMPLES]) -> Option<Verdict> {
        if cell.hi - cell.lo <= 1e-9 * cell.lo.abs().max(cell.hi.abs()) {
            return None;
        }
        let split = |value: &dyn Fn(&Node) -> f64| {
            let i = (0..SAMPLES - 1).find(|i| value(&samples[*i]) * value(&samples[*i + 1]) < 0.0)?;
            let root = self.root(place(i), place(i + 1), value);
            // An end that was put on the kink by an earlier split is left alone.
            let margin = 1e-10 * (cell.hi - cell.lo);
            (root > cell.lo + margin && root < cell.hi - margin).then_some(Verdict::Halve(root, false))
        };
        let bends = self.stage.law.density.log_bends();
        split(&|node| node.excess).or_else(|| bends.iter().find_map(|bend| split(&|node| node.log_h - bend)))
    }

    /// Whether the density is smooth enough on a cell in contact.
    fn by_smoothness(&self, cell: &Interval, top: &mut f64, place: &dyn Fn(usize) -> f64, samples: &[Node; SAMPLES]) -> Verdict {
        let length = cell.hi - cell.lo;
        let distance = |i: usize| match cell.front {
            [true, _] => (place(i) - cell.lo).ln(),
            [_, true] => (cell.hi - place(i)).ln(),
            _ => 0.0,
        };
        let log_h: [f64; SAMPLES] = std::array::from_fn(|i| samples[i].log_h + samples[i].point.weight.ln());
        let log_f: [f64; SAMPLES] = std::array::from_fn(|i| samples[i].f.ln() - distance(i));
        let log_v: [f64; SAMPLES] = std::array::from_fn(|i| samples[i].point.sliding_speed.max(f64::MIN_POSITIVE).ln());
        let largest = log_h.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        *top = top.max(largest);
        if largest < *top - self.settings.drop || length <= 4.0 * f64::EPSILON * cell.lo.abs().max(cell.hi.abs()) {
            return Verdict::Take(*cell);
        }
        // Far below the peak only p^b matters, which varies b times as slowly.
        if largest < *top - 45.0 && spread(&log_h) * self.settings.smallest < self.settings.spread {
            return Verdict::Take(*cell);
        }
        let plain: [f64; SAMPLES] = std::array::from_fn(|i| log_h[i] - self.settings.exponent * distance(i));
        let density: [f64; SAMPLES] = std::array::from_fn(|i| samples[i].log_h - self.settings.exponent * distance(i));
        // The pressure of a rule given as a function may bend where f does not.
        let given = matches!(self.stage.law.density, Density::Given(_));
        if given && largest >= BEYOND {
            return Verdict::Take(*cell);
        }
        let given = given && cell.front == [false, false];
        if given && bends(&log_h) {
            return Verdict::Halve(0.5 * (cell.lo + cell.hi), false);
        }
        let strong = (cell.front[0] || cell.front[1]) && self.settings.exponent > 6.0;
        if !strong && smooth(&log_f, SMOOTH) && smooth(&log_v, SMOOTH) && self.settings.even(&plain, &density) {
            return Verdict::Take(*cell);
        }
        Verdict::Halve(0.5 * (cell.lo + cell.hi), false)
    }

    /// Zero of a node's value between two parameters of opposite sign.
    fn root(&self, a: f64, b: f64, value: &dyn Fn(&Node) -> f64) -> f64 {
        let mut root = Bracket { a, value_a: value(&self.node(a)), b, value_b: value(&self.node(b)) };
        if root.value_a == 0.0 {
            return a;
        }
        if root.value_b == 0.0 {
            return b;
        }
        for _ in 0..200 {
            let Some(c) = root.secant() else { break };
            let at = value(&self.node(c));
            if at == 0.0 {
                return c;
            }
            root.take(c, at);
            if (root.a - root.b).abs() <= 2.0 * f64::EPSILON * root.a.abs().max(root.b.abs()) {
                break;
            }
        }
        root.b
    }

    fn take(&self, cell: &Interval, nodes: &mut Vec<Node>) {
        let length = cell.hi - cell.lo;
        let rule = if cell.front == [false, false] { legendre() } else { self.front };
        for i in 0..ORDER {
            let t = rule.abscissa[i];
            let inner = if cell.front[1] { cell.hi - length * t } else { cell.lo + length * t };
            let mut node = self.node(inner);
            node.parameter = [inner, self.outer];
            node.point.weight *= length * rule.weight[i] * self.weight;
            nodes.push(node);
        }
    }
}

enum Verdict {
    Empty,
    Take(Interval),
    /// Split at the parameter; the flag marks a zero of f there.
    Halve(f64, bool),
}

/// Where between its samples, none of which is positive, a smooth function is largest, if it is positive there.
pub(crate) fn hidden(samples: &[f64; SAMPLES], place: &dyn Fn(usize) -> f64, value: &dyn Fn(f64) -> f64) -> Option<f64> {
    // Between them it rises by less than it varies over all of them; what is even up to round-off has no strip.
    let spread = spread(samples);
    if spread <= ROUND_OFF || samples[highest(samples)] + spread < 0.0 {
        return None;
    }
    let (u, largest) = peak(samples, place, value);
    (largest > ROUND_OFF).then_some(u)
}

/// The largest value of a smooth function next to the largest of its samples, with its place.
pub(crate) fn peak(samples: &[f64; SAMPLES], place: &dyn Fn(usize) -> f64, value: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let highest = highest(samples);
    let (u, largest) = golden(place(highest.saturating_sub(1)), place((highest + 1).min(SAMPLES - 1)), value);
    if largest > samples[highest] { (u, largest) } else { (place(highest), samples[highest]) }
}

fn highest(samples: &[f64; SAMPLES]) -> usize {
    (0..SAMPLES).fold(0, |best, i| if samples[i] > samples[best] { i } else { best })
}

/// Small fourth difference: the function is close to a cubic on the cell.
pub(crate) fn smooth(values: &[f64; SAMPLES], limit: f64) -> bool {
    (values[0] - 4.0 * values[1] + 6.0 * values[2] - 4.0 * values[3] + values[4]).abs() < limit
}

/// A third difference that is not small: wherever a bend is between the places, one of the two sees it.
fn bends(values: &[f64; SAMPLES]) -> bool {
    let third = |i: usize| values[i + 3] - 3.0 * values[i + 2] + 3.0 * values[i + 1] - values[i];
    third(0).abs().max(third(1).abs()) > BENT
}

pub(crate) fn spread(values: &[f64; SAMPLES]) -> f64 {
    let (lo, hi) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(*v), hi.max(*v)));
    hi - lo
}
