//! Surfaces with two parameters: lines at the Gauss points of outer cells.
//!
//! An outer cell is halved where the lines' integrals vary too much; it ends exactly where the end of contact moves from one border
//! of the surface to another, and is graded towards such a place.

use crate::cells::{Line, ROUND_OFF, SAMPLES, Settings, cut_short, hidden, peak, smooth};
use crate::pressure_law::Node;
use crate::quadrature::{ORDER, Rule, legendre};
use crate::stage::Stage;

/// Ratio of neighbouring cells next to a place where the end of contact changes border, and the smallest cell there.
const GRADING: [f64; 2] = [0.15, 3e-3];
/// Part of the surface below which an outer cell is not halved.
const SHORTEST: f64 = 1e-7;

/// An outer cell; `graded` marks ends at which the lines' integrals are not smooth.
#[derive(Clone, Copy)]
struct Cell {
    lo: f64,
    hi: f64,
    graded: [bool; 2],
}

/// What a line carries.
#[derive(Clone, Copy)]
struct Profile {
    /// log of the integral over the line.
    log: f64,
    /// log of the mean over its part in contact.
    mean: f64,
    /// Which of its ends are in contact.
    ends: u8,
}

impl Stage<'_> {
    /// Adds the nodes of all lines between the ends of the outer and of the inner parameter.
    pub(crate) fn collect_lines(&self, [range, inner]: [[f64; 2]; 2], settings: Settings, front: &Rule, nodes: &mut Vec<Node>) {
        let whole = range[1] - range[0];
        let mut line = Vec::new();
        let mut stack = vec![Cell { lo: range[0], hi: range[1], graded: [false; 2] }];
        let mut top = f64::NEG_INFINITY;
        for i in 0..=8 {
            top = top.max(self.profile(range[0] + whole * f64::from(i) / 8.0, inner, &mut line).log);
        }
        while let Some(cell) = stack.pop().filter(|_| !cut_short(nodes)) {
            let Cell { lo, hi, graded } = cell;
            let length = hi - lo;
            let place = |i: usize| lo + length * (0.002 + 0.249 * i as f64);
            let profile: [Profile; SAMPLES] = std::array::from_fn(|i| self.profile(place(i), inner, &mut line));
            let [values, means] = [profile.map(|entry| entry.log), profile.map(|entry| entry.mean)];
            let largest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            top = top.max(largest);
            let change = (1..SAMPLES).find(|i| profile[*i].ends != profile[*i - 1].ends);
            let empty = largest == f64::NEG_INFINITY && change.is_none();
            let hidden = if empty && length >= SHORTEST * whole { self.hidden_border([lo, hi], inner) } else { None };
            if empty && hidden.is_none() {
                continue;
            }
            let split = if hidden.is_some() {
                hidden.map(|border| (border, true))
            } else if length < SHORTEST * whole || largest < top - settings.drop {
                None
            } else if let Some(i) = change {
                Some((self.border([place(i - 1), place(i)], profile[i - 1].ends, inner), true))
            } else if graded[0] && length > GRADING[1] * whole {
                Some((lo + GRADING[0] * length, false))
            } else if graded[1] && length > GRADING[1] * whole {
                Some((hi - GRADING[0] * length, false))
            } else if !smooth(&values, 0.1) || !settings.even(&values, &means) {
                Some((0.5 * (lo + hi), false))
            } else {
                None
            };
            match split {
                Some((middle, mark)) if middle > lo && middle < hi => {
                    stack.push(Cell { lo: middle, hi, graded: [mark, graded[1]] });
                    stack.push(Cell { lo, hi: middle, graded: [graded[0], mark] });
                }
                _ => {
                    let rule = legendre();
                    for i in 0..ORDER {
                        let outer = lo + length * rule.abscissa[i];
                        let weight = length * rule.weight[i];
                        Line { stage: self, outer, weight, settings, front }.collect(inner, nodes);
                    }
                }
            }
        }
    }

    /// Outer parameter at which the set of line ends in contact changes from `before`, by bisection.
    fn border(&self, ends: [f64; 2], before: u8, inner: [f64; 2]) -> f64 {
        let [mut a, mut b] = ends;
        for _ in 0..60 {
            let middle = 0.5 * (a + b);
            if self.ends_in_contact(middle, inner) == before { a = middle } else { b = middle }
        }
        0.5 * (a + b)
    }

    /// Where between two lines the first or the last one carries, if some lines do that lie between or beside the places looked at.
    fn hidden_border(&self, [lo, hi]: [f64; 2], inner: [f64; 2]) -> Option<f64> {
        let ridge = |outer: f64| self.ridge(outer, inner);
        let place = |i: usize| lo + (hi - lo) * i as f64 / (SAMPLES - 1) as f64;
        let samples: [f64; SAMPLES] = std::array::from_fn(|i| ridge(place(i)));
        let carries = match samples.iter().position(|f| *f > ROUND_OFF) {
            Some(i) => place(i),
            None => hidden(&samples, &place, &ridge)?,
        };
        let border = |end: f64| {
            let (mut inside, mut outside) = (carries, end);
            for _ in 0..60 {
                let middle = 0.5 * (inside + outside);
                if ridge(middle) > 0.0 { inside = middle } else { outside = middle }
            }
            outside
        };
        [(samples[SAMPLES - 1], hi), (samples[0], lo)]
            .into_iter()
            .filter(|(f, _)| *f <= 0.0)
            .map(|(_, end)| border(end))
            .find(|border| *border > lo && *border < hi)
    }

    /// Largest f on a line.
    fn ridge(&self, outer: f64, inner: [f64; 2]) -> f64 {
        let f = |u: f64| self.law.node(self.problem.surface.at(u, outer)).f;
        let place = |i: usize| inner[0] + (inner[1] - inner[0]) * i as f64 / (SAMPLES - 1) as f64;
        peak(&std::array::from_fn(|i| f(place(i))), &place, &f).1
    }

    /// Which of the two ends of a line have f > 0.
    fn ends_in_contact(&self, outer: f64, inner: [f64; 2]) -> u8 {
        let touches = |u: f64| u8::from(self.law.node(self.problem.surface.at(u, outer)).f > 0.0);
        touches(inner[0]) + 2 * touches(inner[1])
    }

    /// What a line carries.
    fn profile(&self, outer: f64, inner: [f64; 2], line: &mut Vec<Node>) -> Profile {
        line.clear();
        self.collect_line(outer, line);
        let logs = || line.iter().map(|node| node.log_h + node.point.weight.ln());
        let largest = logs().fold(f64::NEG_INFINITY, f64::max);
        let ends = self.ends_in_contact(outer, inner);
        if largest == f64::NEG_INFINITY {
            return Profile { log: largest, mean: largest, ends };
        }
        let log = largest + logs().map(|log| (log - largest).exp()).sum::<f64>().ln();
        Profile { log, mean: log - line.iter().map(|node| node.point.weight).sum::<f64>().ln(), ends }
    }
}
