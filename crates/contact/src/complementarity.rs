//! Mixed complementarity problem of contact: nodal forces `lambda >= 0`, openings `w >= 0`, `lambda . w = 0`, with
//! `w = d + A lambda + Psi y` and the balance `K y - B^T lambda = f` of the free coordinates `y`.
//!
//! Augmented Lagrangian (proximal method of multipliers, Rockafellar 1976) with penalty `PENALTY / A_ii`, semismooth Newton inside
//! with Kalker's sign control as active-set rule (points under tension leave, points that overlap enter), exact line search where `A` is
//! symmetric. On every active set the inner loop settles on, the limit of the outer loop is solved for directly and accepted if its signs are right.

use crate::lcp::{Answer, Complementarity, PENALTY, Point, Proximal};
use crate::line_search::{Line, line_search};
use crate::linear::Scaling;
use crate::pivoting;

/// Newton steps before the pivoting method takes over.
const NEWTON_LIMIT: usize = 40;
/// Halvings of the line to a Newton point.
const HALVINGS: usize = 12;

impl Complementarity<'_> {
    /// Solves the problem from a starting active set and multipliers.
    pub(crate) fn solve(&self, start: Option<(&Point, &[bool])>) -> Answer {
        let scaling = Scaling::new(self);
        let n = self.points();
        let zero = Point { force: vec![0.0; n], coordinates: vec![0.0; self.load.len()] };
        let mut centre = start.map_or(zero, |s| s.0.clone());
        let mut active = start.map_or_else(|| vec![true; n], |s| s.1.to_vec());
        let mut answer = Answer::open(self);
        // The points of the start are mostly those of the contact: all of a surface that closes, or those found a little before.
        answer.factorisations += 1;
        if self.finish(&scaling, &active, &mut answer).is_some_and(|wrong| wrong.is_empty()) {
            return answer;
        }
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

    /// Augmented multiplier `lambda_i - r_i w_i`.
    fn multiplier(&self, scaling: &Scaling, centre: &Point, opening: &[f64], i: usize) -> f64 {
        centre.force[i] - PENALTY * opening[i] / scaling.point[i]
    }

    /// Minimises the augmented potential along the line to the Newton point; `None` if that is the Newton point.
    fn search(&self, scaling: &Scaling, from: &Point, to: &Point, centre: &Point) -> Option<Point> {
        let opening = self.openings(from);
        let line = Line { from, to, compliance: &self.compliance, influence: &self.influence, opening: &opening };
        let push = |i: usize, w: f64| (centre.force[i] - PENALTY * w / scaling.point[i]).max(0.0);
        let residual = |push: &[f64], y: &[f64]| -> Vec<f64> {
            let balance = self.imbalance(&Point { force: push.to_vec(), coordinates: y.to_vec() });
            let spring = |j: usize| scaling.stiffness[j] / PENALTY * (y[j] - centre.coordinates[j]);
            (0..y.len()).map(|j| spring(j) - balance[j]).collect()
        };
        line_search(&line, HALVINGS, push, residual)
    }
}
