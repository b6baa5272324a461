//! Contact with given limits of the forces (Tresca): a convex problem, the inner step of Coulomb friction where the plain iteration on the states
//! goes round in circles, and the whole of stick and slip in torsion.
//!
//! All forces together are the multipliers of one augmented Lagrangian: `lambda >= 0` and `|sigma| <= limit` are projections,
//! the augmented potential is convex and piecewise quadratic, and semismooth Newton with an exact line search finds its minimum.

use crate::products::{add, times, transposed_times};
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Newton steps for one set of multipliers.
const LIMIT: usize = 40;

/// Where the force of a constraint stands between its bounds.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Bound {
    Free,
    Low(f64),
    High(f64),
}

/// Forces and coordinates.
#[derive(Clone)]
pub(crate) struct Forces {
    pub(crate) force: Vec<f64>,
    pub(crate) coordinates: Vec<f64>,
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
    pub(crate) fn gaps(&self, at: &Forces) -> Vec<f64> {
        let mut gaps = self.offset.clone();
        add(&mut gaps, &times(&self.compliance, &at.force));
        add(&mut gaps, &times(&self.influence, &at.coordinates));
        gaps
    }

    /// Projected multiplier of constraint `i`, and where it stands.
    fn project(&self, centre: &Forces, gap: f64, [low, high]: [f64; 2], i: usize) -> (f64, Bound) {
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
    pub(crate) fn step(&self, centre: &Forces, limits: &[[f64; 2]]) -> Option<(Forces, Vec<Bound>, usize)> {
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
        let forces = Forces { force: bounds.iter().map(|b| b.0).collect(), coordinates: at.coordinates };
        Some((forces, bounds.iter().map(|b| b.1).collect(), solved))
    }

    /// Free forces with the others at their bounds; an infinite penalty gives those of the problem itself.
    pub(crate) fn newton(&self, centre: &Forces, bounds: &[(f64, Bound)], penalty: f64) -> Option<Forces> {
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
        finite.then_some(Forces { force, coordinates })
    }

    /// Bisection on the slope of the augmented potential along the line to the Newton point.
    fn search(&self, from: &Forces, to: Forces, centre: &Forces, limits: &[[f64; 2]]) -> Forces {
        let step = |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| b - a).collect() };
        let (force, coordinates) = (step(&from.force, &to.force), step(&from.coordinates, &to.coordinates));
        let response = times(&self.compliance, &force);
        let mut moved = response.clone();
        add(&mut moved, &times(&self.influence, &coordinates));
        let gaps = self.gaps(from);
        let at = |t: f64| Forces {
            force: from.force.iter().zip(&force).map(|(a, d)| a + t * d).collect(),
            coordinates: from.coordinates.iter().zip(&coordinates).map(|(a, d)| a + t * d).collect(),
        };
        let slope = |t: f64| {
            let p = at(t);
            let push: Vec<f64> = (0..force.len()).map(|i| self.project(centre, gaps[i] + t * moved[i], limits[i], i).0).collect();
            let elastic: f64 = (0..force.len()).map(|i| response[i] * (p.force[i] - push[i])).sum();
            let held = times(&self.stiffness, &p.coordinates);
            let pushed = transposed_times(&self.influence, &push);
            let rigid: f64 = (0..coordinates.len())
                .map(|j| {
                    let spring = self.resultant[j] / self.unit[j] / self.penalty * (p.coordinates[j] - centre.coordinates[j]);
                    coordinates[j] * (held[j] + spring - self.load[j] - pushed[j])
                })
                .sum();
            elastic + rigid
        };
        if slope(1.0) <= 1e-3 * slope(0.0).abs() {
            return to;
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..20 {
            let middle = 0.5 * (low + high);
            if slope(middle) < 0.0 { low = middle } else { high = middle }
        }
        at(0.5 * (low + high))
    }
}
