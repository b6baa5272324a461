//! Boxes in a tree: which of many hold a point.

/// A rectangle along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) low: [f64; 2],
    pub(crate) high: [f64; 2],
}

impl Bounds {
    /// What every box widens.
    pub(crate) const EMPTY: Bounds = Bounds { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };

    /// The box of points.
    pub(crate) fn around(points: impl IntoIterator<Item = [f64; 2]>) -> Bounds {
        points.into_iter().fold(Bounds::EMPTY, |b, x| b.with(&Bounds { low: x, high: x }))
    }

    /// The box of both.
    pub(crate) fn with(&self, other: &Bounds) -> Bounds {
        let low = [0, 1].map(|i| self.low[i].min(other.low[i]));
        Bounds { low, high: [0, 1].map(|i| self.high[i].max(other.high[i])) }
    }

    /// The box widened on every side.
    pub(crate) fn widened(&self, by: [f64; 2]) -> Bounds {
        Bounds { low: [0, 1].map(|i| self.low[i] - by[i]), high: [0, 1].map(|i| self.high[i] + by[i]) }
    }

    /// Widths along the axes.
    pub(crate) fn widths(&self) -> [f64; 2] {
        [0, 1].map(|i| self.high[i] - self.low[i])
    }

    /// The point in the middle.
    pub(crate) fn middle(&self) -> [f64; 2] {
        [0, 1].map(|i| 0.5 * (self.low[i] + self.high[i]))
    }

    pub(crate) fn holds(&self, x: [f64; 2]) -> bool {
        (0..2).all(|i| self.low[i] <= x[i] && x[i] <= self.high[i])
    }
}

/// Number of boxes below which a branch is not divided further.
const LEAF: usize = 4;

/// A branch: its box, its part of the order, and where the tree goes on without it. The branches below it follow it.
#[derive(Clone, Debug)]
struct Branch {
    bounds: Bounds,
    part: [usize; 2],
    past: usize,
}

/// Boxes in a binary tree, halved at the median of their centres across the longer side. Its size and the time of a search depend
/// on how many boxes lie on each other, not on how different they are in size.
#[derive(Clone, Debug)]
pub(crate) struct BoxTree {
    boxes: Vec<Bounds>,
    order: Vec<usize>,
    branches: Vec<Branch>,
}

impl BoxTree {
    pub(crate) fn new(boxes: Vec<Bounds>) -> BoxTree {
        let order = (0..boxes.len()).collect();
        let mut tree = BoxTree { boxes, order, branches: Vec::new() };
        tree.divide(0, tree.boxes.len());
        tree
    }

    /// Adds the branch of a part of the order.
    fn divide(&mut self, start: usize, end: usize) {
        let number = self.branches.len();
        let part = &mut self.order[start..end];
        let bounds = part.iter().fold(Bounds::EMPTY, |b, k| b.with(&self.boxes[*k]));
        self.branches.push(Branch { bounds, part: [start, end], past: 0 });
        if end - start > LEAF {
            let [across, up] = bounds.widths();
            let axis = usize::from(up > across);
            let centre = |k: usize| self.boxes[k].low[axis] + self.boxes[k].high[axis];
            let half = (end - start) / 2;
            part.select_nth_unstable_by(half, |a, b| centre(*a).total_cmp(&centre(*b)).then(a.cmp(b)));
            self.divide(start, start + half);
            self.divide(start + half, end);
        }
        self.branches[number].past = self.branches.len();
    }

    /// Puts the boxes that hold a point into `found`, ascending.
    pub(crate) fn holding(&self, x: [f64; 2], found: &mut Vec<usize>) {
        found.clear();
        let mut at = 0;
        while let Some(branch) = self.branches.get(at) {
            let leaf = branch.past == at + 1;
            if !branch.bounds.holds(x) {
                at = branch.past;
                continue;
            }
            if leaf {
                let [start, end] = branch.part;
                found.extend(self.order[start..end].iter().filter(|k| self.boxes[**k].holds(x)));
            }
            at += 1;
        }
        found.sort_unstable();
    }
}
