//! Contact with given limits of the forces (Tresca): a convex problem, the inner step of Coulomb friction where the plain iteration on the states
//! goes round in circles, and the whole of stick and slip in torsion.
//!
//! All forces together are the multipliers of one augmented Lagrangian: `lambda >= 0` and `|sigma| <= limit` are projections,
//! the augmented potential is convex and piecewise quadratic, and semismooth Newton with an exact line search finds its minimum.

use crate::lcp::Point;
use crate::line_search::{Line, line_search};
use crate::products::{add, times, transposed_times};
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Newton steps for one set of multipliers.
const LIMIT: usize = 40;
/// Halvings of the line to a Newton point.
const HALVINGS: usize = 20;

/// Where the force of a constraint stands between its bounds.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Bound {
    Free,
    Low(f64),
    High(f64),
}

/// Forces within bounds, against `gap = offset + compliance force + influence coordinates`, and the balance
/// `load + influence^T force = stiffness coordinates`: where a force is free its gap is zero, at the lower bound it is positive, at the
/// upper one negative.
pub(crate) struct Tresca {
    pub(crate) compliance: Mat<f64>,
    pub(crate) influence: Mat<f64>,
    pub(crate) offset: Vec<f64>,
    pub(crate) load: Vec<f64>,
    pub(crate) stiffness: Mat<f64>,
    /// Compliance of each constraint.
    pub(crate) own: Vec<f64>,
    /// Penalty times the compliance of a point.
    pub(crate) penalty: f64,
    /// Natural size of each coordinate and of its resultant.
    pub(crate) unit: Vec<f64>,
    pub(crate) resultant: Vec<f64>,
}

/// Penalty to begin with.
pub(crate) const SOFT: f64 = 4.0;

impl Tresca {
    pub(crate) fn gaps(&self, at: &Point) -> Vec<f64> {
        let mut gaps = self.offset.clone();
        add(&mut gaps, &times(&self.compliance, &at.force));
        add(&mut gaps, &times(&self.influence, &at.coordinates));
        gaps
    }

    /// Projected multiplier of constraint `i`, and where it stands.
    fn project(&self, centre: &Point, gap: f64, [low, high]: [f64; 2], i: usize) -> (f64, Bound) {
        if low >= high {
            return (low, Bound::Low(low));
        }
        let trial = centre.force[i] - self.penalty * gap / self.own[i];
        if trial > low && trial < high {
            (trial, Bound::Free)
        } else if trial <= low {
            (low, Bound::Low(low))
        } else {
            (high, Bound::High(high))
        }
    }

    /// One multiplier step with given bounds `[low, high]` of the forces: minimises the augmented potential and gives the projected forces, where
    /// each stands, and the number of linear systems.
    pub(crate) fn step(&self, centre: &Point, limits: &[[f64; 2]]) -> Option<(Point, Vec<Bound>, usize)> {
        let mut at = centre.clone();
        let mut gaps = self.gaps(&at);
        let read = |gaps: &[f64]| -> Vec<(f64, Bound)> {
            (0..limits.len()).map(|i| self.project(centre, gaps[i], limits[i], i)).collect()
        };
        let mut bounds = read(&gaps);
        let mut solved = 0;
        while solved < LIMIT {
            solved += 1;
            let target = self.newton(centre, &bounds, self.penalty)?;
            at = self.search(&at, target, centre, limits);
            gaps = self.gaps(&at);
            let next = read(&gaps);
            let same = next.iter().zip(&bounds).all(|(a, b)| a.1 == b.1);
            bounds = next;
            if same {
                break;
            }
        }
        let forces = Point { force: bounds.iter().map(|b| b.0).collect(), coordinates: at.coordinates };
        Some((forces, bounds.iter().map(|b| b.1).collect(), solved))
    }

    /// Free forces with the others at their bounds; an infinite penalty gives those of the problem itself.
    pub(crate) fn newton(&self, centre: &Point, bounds: &[(f64, Bound)], penalty: f64) -> Option<Point> {
        let m = self.load.len();
        let free: Vec<usize> = (0..bounds.len()).filter(|i| bounds[*i].1 == Bound::Free).collect();
        let fixed: Vec<f64> = bounds.iter().map(|b| if let Bound::Low(v) | Bound::High(v) = b.1 { v } else { 0.0 }).collect();
        let mut known = self.offset.clone();
        add(&mut known, &times(&self.compliance, &fixed));
        let mut balance = self.load.clone();
        add(&mut balance, &transposed_times(&self.influence, &fixed));
        let f = free.len();
        let spring = |j: usize| self.resultant[j] / self.unit[j] / penalty;
        let matrix = Mat::from_fn(f + m, f + m, |i, j| match (i < f, j < f) {
            (true, true) => {
                let value = self.compliance[(free[i], free[j])] / self.own[free[i]];
                if i == j { value + 1.0 / penalty } else { value }
            }
            (true, false) => self.influence[(free[i], j - f)] * self.unit[j - f] / self.own[free[i]],
            (false, true) => self.influence[(free[j], i - f)] / self.resultant[i - f],
            (false, false) => {
                let (i, j) = (i - f, j - f);
                let own = if i == j { spring(j) } else { 0.0 };
                -(self.stiffness[(i, j)] + own) * self.unit[j] / self.resultant[i]
            }
        });
        let right = Mat::from_fn(f + m, 1, |i, _| {
            if i < f {
                centre.force[free[i]] / penalty - known[free[i]] / self.own[free[i]]
            } else {
                let j = i - f;
                -(balance[j] + spring(j) * centre.coordinates[j]) / self.resultant[j]
            }
        });
        let x = matrix.partial_piv_lu().solve(&right);
        let mut force = fixed;
        free.iter().enumerate().for_each(|(i, k)| force[*k] = x[(i, 0)]);
        let coordinates: Vec<f64> = (0..m).map(|j| x[(f + j, 0)] * self.unit[j]).collect();
        let finite = force.iter().chain(&coordinates).all(|v| v.is_finite());
        finite.then_some(Point { force, coordinates })
    }

    /// Minimises the augmented potential along the line to the Newton point.
    fn search(&self, from: &Point, to: Point, centre: &Point, limits: &[[f64; 2]]) -> Point {
        let gaps = self.gaps(from);
        let line = Line { from, to: &to, compliance: &self.compliance, influence: &self.influence, opening: &gaps };
        let push = |i: usize, gap: f64| self.project(centre, gap, limits[i], i).0;
        let residual = |push: &[f64], y: &[f64]| -> Vec<f64> {
            let held = times(&self.stiffness, y);
            let pushed = transposed_times(&self.influence, push);
            let spring = |j: usize| self.resultant[j] / self.unit[j] / self.penalty * (y[j] - centre.coordinates[j]);
            (0..y.len()).map(|j| held[j] + spring(j) - self.load[j] - pushed[j]).collect()
        };
        line_search(&line, HALVINGS, push, residual).unwrap_or(to)
    }
}
