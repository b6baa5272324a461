//! The complementarity problem with its points in contact given: `w = 0` on these, `lambda = 0` on the others.

use crate::lcp::{Answer, Complementarity, Point, Proximal};
use crate::linear::{Factor, Scaling};

impl Complementarity<'_> {
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
}
