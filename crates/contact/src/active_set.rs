//! The complementarity problem with its points in contact given: `w = 0` on these, `lambda = 0` on the others.

use crate::lcp::{Answer, Complementarity, Point, Proximal};
use crate::linear::{Factor, Scaling};

impl Complementarity<'_> {
    /// Whether the force at each point closes it further, by its heat, than it opens it as a pressure; not without points.
    pub(crate) fn closes_itself(&self) -> bool {
        self.points() > 0 && (0..self.points()).all(|i| self.compliance[(i, i)] < 0.0)
    }

    /// Solves with `w = 0` on the active points and `lambda = 0` on the others; `None` if that is singular.
    pub(crate) fn on_active(&self, scaling: &Scaling, active: &[bool], proximal: &Proximal<'_>) -> Option<(Point, Factor)> {
        let index: Vec<usize> = (0..self.points()).filter(|i| active[*i]).collect();
        let factor = Factor::new(self, scaling, &index, proximal.weight);
        let point = factor.solve(self, scaling, &index, proximal)?;
        Some((point, factor))
    }

    /// Solves without proximal terms on an active set and accepts the answer if every sign is right. Returns the points with a wrong one,
    /// `None` if the system is singular.
    pub(crate) fn finish(&self, scaling: &Scaling, active: &[bool], answer: &mut Answer) -> Option<Vec<usize>> {
        let zero = Point::default();
        let plain = Proximal { weight: 0.0, centre: &zero };
        let (point, factor) = self.on_active(scaling, active, &plain)?;
        let opening = self.openings(&point);
        let wrong = self.wrong(&point, &opening, active);
        // Pivots of round-off: a coordinate is held by no point, although the factorisation went through.
        if wrong.is_empty() && !self.is_balanced(&point) {
            return None;
        }
        answer.history.push(wrong.len());
        answer.regular = factor.sign() == if self.load.len().is_multiple_of(2) { 1.0 } else { -1.0 };
        if wrong.is_empty() {
            answer.take(point, opening, active);
        } else {
            (answer.point, answer.opening, answer.active) = (point, opening, active.to_vec());
            answer.settled = false;
        }
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
}
