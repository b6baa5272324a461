//! Mixed complementarity problem of contact: nodal forces `lambda >= 0`, openings `w >= 0`, `lambda . w = 0`, with
//! `w = d + A lambda + Psi y` and the balance `K y - B^T lambda = f` of the free coordinates `y`.
//!
//! Augmented Lagrangian (proximal method of multipliers, Rockafellar 1976) with penalty `PENALTY / A_ii`, semismooth Newton inside
//! with Kalker's sign control as active-set rule (points under tension leave, points that overlap enter), exact line search where `A` is
//! symmetric. On every active set the inner loop settles on, the limit of the outer loop is solved for directly and accepted if its signs are right.

use crate::linear::{Factor, Scaling};
use crate::pivoting;
use crate::response::{add, times, transposed_times};
use faer::Mat;
use std::borrow::Cow;

/// Penalty times the compliance of a point.
pub(crate) const PENALTY: f64 = 16384.0;
/// Newton steps before the pivoting method takes over.
const NEWTON_LIMIT: usize = 40;

/// The problem: `A` is `points x points`, `Psi` and `B` are `points x coordinates`, `K` is `coordinates x coordinates`.
pub(crate) struct Complementarity<'m> {
    pub(crate) compliance: Cow<'m, Mat<f64>>,
    pub(crate) influence: Mat<f64>,
    pub(crate) balance: Mat<f64>,
    pub(crate) stiffness: Mat<f64>,
    pub(crate) opening: Vec<f64>,
    pub(crate) load: Vec<f64>,
    pub(crate) symmetric: bool,
}

/// Forces and coordinates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Point {
    pub(crate) force: Vec<f64>,
    pub(crate) coordinates: Vec<f64>,
}

/// What a solve found.
pub(crate) struct Answer {
    pub(crate) point: Point,
    pub(crate) opening: Vec<f64>,
    pub(crate) active: Vec<bool>,
    pub(crate) factorisations: usize,
    /// Number of points with a wrong sign at each step.
    pub(crate) history: Vec<usize>,
    pub(crate) settled: bool,
    /// Whether the pivoting method had to take over.
    pub(crate) pivoted: bool,
    /// Whether the determinant has the sign of the frictionless problem.
    pub(crate) regular: bool,
}

/// Multipliers and weights of the proximal terms; `weight` is zero for the plain problem.
pub(crate) struct Proximal<'a> {
    pub(crate) weight: f64,
    pub(crate) centre: &'a Point,
}

impl Complementarity<'_> {
    pub(crate) fn points(&self) -> usize {
        self.opening.len()
    }

    /// `w = d + A lambda + Psi y`.
    pub(crate) fn openings(&self, at: &Point) -> Vec<f64> {
        let mut w = self.opening.clone();
        add(&mut w, &times(&self.compliance, &at.force));
        add(&mut w, &times(&self.influence, &at.coordinates));
        w
    }

    /// `f + B^T lambda - K y`.
    pub(crate) fn imbalance(&self, at: &Point) -> Vec<f64> {
        let mut r = self.load.clone();
        add(&mut r, &transposed_times(&self.balance, &at.force));
        times(&self.stiffness, &at.coordinates).iter().zip(&mut r).for_each(|(k, r)| *r -= k);
        r
    }

    /// Solves with `w = 0` on the active points and `lambda = 0` on the others; `None` if that is singular.
    pub(crate) fn on_active(&self, scaling: &Scaling, active: &[bool], proximal: &Proximal<'_>) -> Option<(Point, Factor)> {
        let index: Vec<usize> = (0..self.points()).filter(|i| active[*i]).collect();
        let factor = Factor::new(self, scaling, &index, proximal.weight);
        let point = factor.solve(self, scaling, &index, proximal)?;
        Some((point, factor))
    }

    /// Tolerances for the signs of forces and openings at a solution: round-off of what was added up.
    pub(crate) fn tolerances(&self, at: &Point) -> (f64, Vec<f64>) {
        let largest = at.force.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let elastic = times(&self.compliance, &at.force);
        let scale = elastic.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let rigid = times(&self.influence, &at.coordinates);
        let openings =
            (0..self.points()).map(|i| 1e-11 * scale + 16.0 * f64::EPSILON * (self.opening[i].abs() + rigid[i].abs())).collect();
        (1e-11 * largest, openings)
    }

    /// Points whose sign is wrong.
    pub(crate) fn wrong(&self, at: &Point, opening: &[f64], active: &[bool]) -> Vec<usize> {
        let (force, tolerance) = self.tolerances(at);
        let wrong = |i: &usize| if active[*i] { at.force[*i] < -force } else { opening[*i] < -tolerance[*i] };
        (0..self.points()).filter(wrong).collect()
    }

    /// Solves the problem from a starting active set and multipliers.
    pub(crate) fn solve(&self, start: Option<(&Point, &[bool])>) -> Answer {
        let scaling = Scaling::new(self);
        let n = self.points();
        let zero = Point { force: vec![0.0; n], coordinates: vec![0.0; self.load.len()] };
        let mut centre = start.map_or(zero, |s| s.0.clone());
        let mut active = start.map_or_else(|| vec![true; n], |s| s.1.to_vec());
        let mut answer = Answer::open(self);
        let mut current: Option<Point> = None;
        while answer.factorisations < NEWTON_LIMIT {
            let proximal = Proximal { weight: 1.0 / PENALTY, centre: &centre };
            answer.factorisations += 1;
            let Some((target, _)) = self.on_active(&scaling, &active, &proximal) else { break };
            let shorter =
                current.as_ref().filter(|_| self.symmetric).and_then(|from| self.search(&scaling, from, &target, &centre));
            // On the whole step the multiplier of an active point is its force: taken from the opening it would carry round-off times the penalty.
            let whole = shorter.is_none();
            let next = shorter.unwrap_or(target);
            let opening = self.openings(&next);
            let multiplier =
                |i: usize| if whole && active[i] { next.force[i] } else { self.multiplier(&scaling, &centre, &opening, i) };
            let pushed: Vec<bool> = (0..n).map(|i| multiplier(i) > 0.0).collect();
            let changed = (0..n).filter(|i| pushed[*i] != active[*i]).count();
            answer.history.push(changed);
            if changed > 0 {
                active = pushed;
                current = Some(next);
                continue;
            }
            answer.factorisations += 1;
            if self.finish(&scaling, &active, &mut answer).is_some_and(|wrong| wrong.is_empty()) {
                return answer;
            }
            centre = Point { force: (0..n).map(|i| multiplier(i).max(0.0)).collect(), coordinates: next.coordinates };
            current = None;
            active = (0..n).map(|i| self.multiplier(&scaling, &centre, &opening, i) > 0.0).collect();
        }
        pivoting::solve(self, &scaling, &mut answer);
        answer
    }

    /// Solves from full contact by the pivoting method alone.
    pub(crate) fn solve_by_pivoting(&self) -> Answer {
        let mut answer = Answer::open(self);
        pivoting::solve(self, &Scaling::new(self), &mut answer);
        answer
    }

    /// Solves without proximal terms on an active set and accepts the answer if every sign is right. Returns the points with a wrong one,
    /// `None` if the system is singular.
    pub(crate) fn finish(&self, scaling: &Scaling, active: &[bool], answer: &mut Answer) -> Option<Vec<usize>> {
        let zero = Point::default();
        let plain = Proximal { weight: 0.0, centre: &zero };
        let (point, factor) = self.on_active(scaling, active, &plain)?;
        let opening = self.openings(&point);
        let wrong = self.wrong(&point, &opening, active);
        answer.history.push(wrong.len());
        answer.settled = wrong.is_empty();
        answer.regular = factor.sign() == if self.load.len().is_multiple_of(2) { 1.0 } else { -1.0 };
        answer.point = point;
        if answer.settled {
            answer.point.force.iter_mut().for_each(|f| *f = f.max(0.0));
        }
        answer.opening = opening;
        answer.active = active.to_vec();
        Some(wrong)
    }

    /// Solves with the given points in contact, whatever the signs.
    pub(crate) fn solve_on(&self, active: &[bool]) -> Option<Answer> {
        let zero = Point::default();
        let plain = Proximal { weight: 0.0, centre: &zero };
        let (point, _) = self.on_active(&Scaling::new(self), active, &plain)?;
        let opening = self.openings(&point);
        Some(Answer { point, opening, active: active.to_vec(), factorisations: 1, settled: true, ..Answer::open(self) })
    }

    /// Augmented multiplier `lambda_i - r_i w_i`.
    fn multiplier(&self, scaling: &Scaling, centre: &Point, opening: &[f64], i: usize) -> f64 {
        centre.force[i] - PENALTY * opening[i] / scaling.point[i]
    }

    /// Minimises the augmented potential along the line to the Newton point, by bisection on its slope; `None` if that is the Newton point.
    fn search(&self, scaling: &Scaling, from: &Point, to: &Point, centre: &Point) -> Option<Point> {
        let step = |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| b - a).collect() };
        let (force, coordinates) = (step(&from.force, &to.force), step(&from.coordinates, &to.coordinates));
        let response = times(&self.compliance, &force);
        let mut moved = response.clone();
        add(&mut moved, &times(&self.influence, &coordinates));
        let opening = self.openings(from);
        let at = |t: f64| Point {
            force: from.force.iter().zip(&force).map(|(a, d)| a + t * d).collect(),
            coordinates: from.coordinates.iter().zip(&coordinates).map(|(a, d)| a + t * d).collect(),
        };
        let slope = |t: f64| {
            let p = at(t);
            let push: Vec<f64> = (0..force.len())
                .map(|i| (centre.force[i] - PENALTY * (opening[i] + t * moved[i]) / scaling.point[i]).max(0.0))
                .collect();
            let elastic: f64 = (0..force.len()).map(|i| response[i] * (p.force[i] - push[i])).sum();
            let pushed = Point { force: push, coordinates: p.coordinates.clone() };
            let balance = self.imbalance(&pushed);
            let rigid: f64 = (0..coordinates.len())
                .map(|j| {
                    let spring = scaling.stiffness[j] / PENALTY * (p.coordinates[j] - centre.coordinates[j]);
                    coordinates[j] * (spring - balance[j])
                })
                .sum();
            elastic + rigid
        };
        if slope(1.0) <= 1e-3 * slope(0.0).abs() {
            return None;
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            if slope(middle) < 0.0 { low = middle } else { high = middle }
        }
        Some(at(0.5 * (low + high)))
    }
}

impl Answer {
    /// Nothing in contact.
    pub(crate) fn open(problem: &Complementarity<'_>) -> Answer {
        let n = problem.points();
        Answer {
            point: Point { force: vec![0.0; n], coordinates: vec![0.0; problem.load.len()] },
            opening: problem.opening.clone(),
            active: vec![false; n],
            factorisations: 0,
            history: Vec::new(),
            settled: false,
            pivoted: false,
            regular: true,
        }
    }
}
