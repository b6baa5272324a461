//! The complementarity problem with its points in contact given: `w = 0` on these, `lambda = 0` on the others.

use crate::lcp::{Answer, Complementarity, Point, Proximal};
use crate::linear::{Factor, Scaling};
use faer::Mat;

/// Part of a number that may be round-off.
const LEAST: f64 = 1e-9;

impl Complementarity<'_> {
    /// Whether the force at each point closes it further, by its heat, than it opens it as a pressure, but for what the coordinates make up for: a body that grows
    /// by its heat moves away as a whole. Not without points.
    pub(crate) fn closes_itself(&self) -> bool {
        let (n, own) = (self.points(), |i: usize| self.compliance[(i, i)]);
        if n == 0 || !(0..n).all(|i| own(i) < 0.0) {
            return false;
        }
        let motions = self.motions();
        let made_up = &motions * (motions.transpose() * &*self.compliance);
        (0..n).all(|i| own(i) - made_up[(i, i)] < LEAST * own(i))
    }

    /// An orthonormal basis of what the coordinates open the points by, `points x motions`.
    fn motions(&self) -> Mat<f64> {
        let openings = &self.influence;
        let unit = Mat::from_fn(openings.nrows(), openings.ncols(), |i, j| match openings.col(j).norm_l2() {
            0.0 => 0.0,
            size => openings[(i, j)] / size,
        });
        let qr = unit.col_piv_qr();
        let independent = qr.thin_R().diagonal().column_vector().iter().filter(|r| r.abs() > LEAST).count();
        qr.compute_thin_Q().subcols(0, independent).to_owned()
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

#[cfg(test)]
mod tests {
    use std::borrow::Cow;

    use faer::Mat;

    use super::Complementarity;

    /// Three points of this compliance, which coordinates open by the columns of `influence`.
    fn closes_itself(compliance: Mat<f64>, influence: Mat<f64>) -> bool {
        let coordinates = influence.ncols();
        let problem = Complementarity {
            compliance: Cow::Owned(compliance),
            balance: influence.clone(),
            influence,
            stiffness: Mat::zeros(coordinates, coordinates),
            opening: vec![0.0; 3],
            load: vec![1.0; coordinates],
            symmetric: false,
        };
        problem.closes_itself()
    }

    #[test]
    fn points_close_themselves_only_by_what_no_rigid_motion_makes_up_for() {
        // Each opens itself by 1 and heat closes all of them by a half, or by 2 with two thirds of it at the point itself.
        let [weak, strong] = [[0.5, 0.5], [2.0, 2.0 / 3.0]]
            .map(|[own, others]| Mat::from_fn(3, 3, |i, j| if i == j { 1.0 - own } else { -others }));
        let grown = Mat::from_fn(3, 3, |i, j| weak[(i, j)] - 7.0);
        let closing = || Mat::full(3, 1, 1.0);
        assert!(!closes_itself(weak.clone(), closing()) && !closes_itself(weak, Mat::zeros(3, 0)));
        assert!(closes_itself(strong.clone(), Mat::zeros(3, 0)) && closes_itself(strong, closing()));
        // The body grows as a whole: its closing makes up for that, whatever its scale, and a coordinate that opens nothing changes nothing.
        assert!(closes_itself(grown.clone(), Mat::zeros(3, 0)) && !closes_itself(grown.clone(), closing()));
        assert!(!closes_itself(grown, Mat::from_fn(3, 2, |_, j| [0.0, 1e6][j])));
    }
}
