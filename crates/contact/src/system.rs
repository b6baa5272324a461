//! The complementarity problem of contact as plain numbers, for laws that add to it (wear).

use crate::error::Error;
use crate::lcp::Complementarity;
use crate::linear::{Factor, Scaling};
use crate::load::ContactLoad;
use crate::operator::ContactOperator;
use faer::Mat;
use std::borrow::Cow;

/// Openings and balance as functions of nodal normal forces `f >= 0` and free rigid coordinates `y`:
/// `opening = gap + opening_0 + A f + Psi y >= 0` with `f . opening = 0`, and `load + B^T f = K y`.
///
/// Nodal forces are pressure times the point's weight. Any linear contact can be written this way: the operator of two bodies
/// ([`ContactOperator::system`]), a contact of given matrices
/// ([`MatrixContact::system`](crate::MatrixContact::system)), or a closed-form compliance.
#[derive(Clone, Debug)]
pub struct ContactSystem {
    /// `A`, `points x points`: opening by nodal normal forces, the shear that goes with them included.
    pub compliance: Mat<f64>,
    /// `Psi`, `points x coordinates`: opening by the free coordinates, the closing velocities reversed.
    pub influence: Mat<f64>,
    /// `B`, `points x coordinates`: work of a unit nodal force with its shear along the coordinates.
    pub balance: Mat<f64>,
    /// `K`, `coordinates x coordinates`: stiffness of supports and springs, zero for rigid modes.
    pub stiffness: Mat<f64>,
    /// Opening under the load factors and prescribed motions alone, without a gap.
    pub opening: Vec<f64>,
    /// Resultants along the coordinates.
    pub load: Vec<f64>,
    /// Whether there is no shear, so that `A` is symmetric and `B = Psi`.
    pub symmetric: bool,
}

impl ContactSystem {
    /// The system of a problem.
    pub(crate) fn of(problem: Complementarity<'_>) -> ContactSystem {
        ContactSystem {
            compliance: problem.compliance.into_owned(),
            influence: problem.influence,
            balance: problem.balance,
            stiffness: problem.stiffness,
            opening: problem.opening,
            load: problem.load,
            symmetric: problem.symmetric,
        }
    }

    /// Whether the system of the closed points (one a point, open where it says nothing) has the sign of determinant that it has without shear and heat. Where these have turned it, the
    /// contact is beyond the point at which it branches: a deviation of the pressure feeds on itself.
    pub fn is_regular(&self, closed: &[bool]) -> bool {
        let problem = Complementarity {
            compliance: Cow::Borrowed(&self.compliance),
            influence: self.influence.clone(),
            balance: self.balance.clone(),
            stiffness: self.stiffness.clone(),
            opening: self.opening.clone(),
            load: self.load.clone(),
            symmetric: self.symmetric,
        };
        let index: Vec<usize> = (0..problem.points()).filter(|i| closed.get(*i) == Some(&true)).collect();
        let sign = Factor::new(&problem, &Scaling::new(&problem), &index, 0.0).sign();
        sign == if self.load.len().is_multiple_of(2) { 1.0 } else { -1.0 }
    }
}

impl ContactOperator<'_> {
    /// The system of a load.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn system(&self, load: &ContactLoad) -> Result<ContactSystem, Error> {
        Ok(ContactSystem::of(self.stage(&vec![0.0; self.points().len()], load)?.plain.problem))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two points, each pushed off by the other's force times `coupling` of its own, as heat does that bends both.
    fn two_points(coupling: f64) -> ContactSystem {
        ContactSystem {
            compliance: Mat::from_fn(2, 2, |i, j| if i == j { 1.0 } else { coupling }),
            influence: Mat::from_fn(2, 1, |_, _| 1.0),
            balance: Mat::from_fn(2, 1, |_, _| 1.0),
            stiffness: Mat::zeros(1, 1),
            opening: vec![0.0; 2],
            load: vec![-1.0],
            symmetric: false,
        }
    }

    /// Under a given force in all the pair is singular where each point does as much to the other as to itself.
    #[test]
    fn a_contact_is_irregular_beyond_the_coupling_at_which_it_branches() {
        assert!(two_points(0.99).is_regular(&[true, true]));
        assert!(!two_points(1.01).is_regular(&[true, true]));
        assert!(two_points(1.01).is_regular(&[true, false]), "one point alone has no other");
    }
}
