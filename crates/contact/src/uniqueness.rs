//! Whether a steadily sliding contact can have other solutions, and from which coefficient of friction on; how well its system is conditioned.
//!
//! With friction the compliance `A = C + mu C_nt` is not symmetric. Where the quadratic form of `A` on the pressures that keep the balance is
//! positive, there is one solution (Cottle, Pang and Stone 1992, theorem 3.1.6). Where it is indefinite that guarantee is gone, and no
//! more: the solution branches only where the determinant of the system of its active points passes zero (Klarbring 1990), that is where its smallest
//! singular value vanishes. So the solution is followed from no friction up, but only where the form is indefinite.

use faer::{Mat, Side};
use hpfem::bisect;

use crate::error::Error;
use crate::growth::{Family, STEPS};
use crate::held::HeldContact;
use crate::lcp::{Complementarity, Point};
use crate::linear::{Scaling, extreme_singular_values, matrix};
use crate::load::{ContactLoad, Friction};
use crate::operator::ContactOperator;
use crate::solution::ContactSolution;

/// Halvings of a step or of the range in which something changes.
const HALVINGS: usize = 16;
/// Weight of the balance in the quadratic form (Finsler 1937).
const BALANCE: f64 = 1e6;

/// What was found out about other solutions of a contact that slides steadily.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Uniqueness {
    /// Coefficient of friction from which the quadratic form is indefinite and one solution is not guaranteed; `None` if it is up to that of the
    /// load.
    pub not_guaranteed_from: Option<f64>,
    /// Coefficient at which the determinant changes sign on the solution followed from no friction; `None` if it does not up to that of the load.
    pub singular_from: Option<f64>,
    /// Coefficient from which the solution followed from no friction was not found.
    pub lost_from: Option<f64>,
    /// Largest difference of the pressures of the solution followed from no friction and of the one at hand, over the largest pressure: of order
    /// one where they are two.
    pub other_solution: f64,
}

impl Uniqueness {
    /// Whether there is certainly no other solution.
    pub fn is_guaranteed(&self) -> bool {
        self.not_guaranteed_from.is_none()
    }
}

impl ContactOperator<'_> {
    /// Smallest and largest singular value (to some 1e-3) of the scaled system that a solution was found by, its open points left out: their ratio says how
    /// much of the digits the solve may lose, and the smallest vanishes where the solution branches. `None` where nothing touches.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn singular_values(
        &self,
        gap: &[f64],
        load: &ContactLoad,
        solution: &ContactSolution,
    ) -> Result<Option<[f64; 2]>, Error> {
        self.held_on(&solution.closed).singular_values(gap, load, solution)
    }

    /// Looks for other solutions of a load with steady sliding; `None` without it.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn uniqueness(&self, gap: &[f64], load: &ContactLoad, solution: &ContactSolution) -> Result<Option<Uniqueness>, Error> {
        let Friction::Sliding { coefficient, .. } = &load.friction else { return Ok(None) };
        if self.stage(gap, load)?.plain.problem.symmetric {
            return Ok(None);
        }
        let family = |mu: f64, read: &mut dyn FnMut(&Complementarity<'_>)| self.with_friction(gap, load, mu, read);
        Ok(Some(follow(&family, *coefficient, &solution.nodal_force)))
    }
}

impl HeldContact<'_, '_> {
    /// As [`ContactOperator::singular_values`], of a solution that is open at all points but these.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn singular_values(
        &self,
        gap: &[f64],
        load: &ContactLoad,
        solution: &ContactSolution,
    ) -> Result<Option<[f64; 2]>, Error> {
        let (stage, _) = self.stage(gap, load)?;
        let system = match &load.friction {
            Friction::Coulomb { coefficient, slip_before } => {
                stage.plain.coulomb(*coefficient, &self.pick(slip_before))?.matrix(&self.pick(&solution.states))
            }
            Friction::None | Friction::Sliding { .. } => of_active(&stage.plain.problem, &self.pick(&solution.closed)),
        };
        Ok(extreme_singular_values(&system))
    }
}

/// The form by halving the range, then the solution from no friction on.
fn follow(family: &Family<'_>, coefficient: f64, force: &[f64]) -> Uniqueness {
    let definite = |mu: f64| {
        let mut answer = false;
        family(mu, &mut |problem| answer = is_definite(problem));
        answer
    };
    let mut found = Uniqueness { not_guaranteed_from: None, singular_from: None, lost_from: None, other_solution: 0.0 };
    if definite(coefficient) {
        return found;
    }
    found.not_guaranteed_from = Some(if definite(0.0) { halve([0.0, coefficient], definite) } else { 0.0 });
    let mut start: Option<(Point, Vec<bool>)> = None;
    // Whether the determinant keeps its sign; `None` without a solution.
    let step = |mu: f64, start: &mut Option<(Point, Vec<bool>)>| {
        let mut regular = None;
        family(mu, &mut |problem| {
            let answer = problem.solve(start.as_ref().map(|(point, active)| (point, active.as_slice())));
            if answer.settled && problem.relative_imbalance(&answer.point) < 1e-8 {
                regular = Some(answer.regular);
                *start = Some((answer.point, answer.active));
            }
        });
        regular
    };
    let mut before = 0.0;
    for k in 0..=STEPS {
        let mu = coefficient * k as f64 / STEPS as f64;
        let kept = start.clone();
        let regular = step(mu, &mut start);
        if regular != Some(true) {
            let as_good = |mu: f64| step(mu, &mut kept.clone()) == Some(true);
            let from = if k == 0 { 0.0 } else { halve([before, mu], as_good) };
            match regular {
                Some(_) => found.singular_from = Some(from),
                None => found.lost_from = Some(from),
            }
            return found;
        }
        before = mu;
    }
    if let Some((point, _)) = start {
        let largest = force.iter().fold(f64::MIN_POSITIVE, |m, f| m.max(f.abs()));
        found.other_solution = point.force.iter().zip(force).map(|(a, b)| (a - b).abs() / largest).fold(0.0, f64::max);
    }
    found
}

/// Where something that holds at the start of a range ceases to.
fn halve(range: [f64; 2], holds: impl Fn(f64) -> bool) -> f64 {
    let [low, high] = bisect(range, HALVINGS, holds);
    0.5 * (low + high)
}

/// The scaled system of the points in contact.
fn of_active(problem: &Complementarity<'_>, closed: &[bool]) -> Mat<f64> {
    let index: Vec<usize> = (0..problem.points()).filter(|i| closed[*i]).collect();
    matrix(problem, &Scaling::new(problem), &index, 0.0)
}

/// Whether `lambda^T R A lambda > 0` for all `lambda` of all points that keep the balance of the rigid motions, `R` the positive factors of the
/// openings that make `R Psi = B`; without such factors nothing is guaranteed.
fn is_definite(problem: &Complementarity<'_>) -> bool {
    let n = problem.points();
    let (psi, b) = (&problem.influence, &problem.balance);
    let rigid: Vec<usize> = (0..problem.load.len()).collect();
    let scaling = Scaling::new(problem);
    let factor = |i: usize| {
        let dot = |x: &Mat<f64>| rigid.iter().map(|j| x[(i, *j)] * psi[(i, *j)] * scaling.unit[*j].powi(2)).sum::<f64>();
        let (top, bottom) = (dot(b), dot(psi));
        if bottom > 0.0 { top / bottom } else { 1.0 }
    };
    let factors: Vec<f64> = (0..n).map(factor).collect();
    let fits = |i: usize| {
        let off = |j: &usize| (b[(i, *j)] - factors[i] * psi[(i, *j)]).abs() <= 1e-9 * scaling.resultant[*j];
        factors[i] > 0.0 && rigid.iter().all(off)
    };
    if !(0..n).all(fits) {
        return false;
    }
    let size: Vec<f64> = (0..n).map(|i| 1.0 / scaling.point[i].sqrt()).collect();
    let entry = |i: usize, j: usize| factors[i] * problem.compliance[(i, j)];
    let free: Vec<usize> = rigid.into_iter().filter(|j| problem.stiffness[(*j, *j)] <= 0.0).collect();
    let rows: Vec<Vec<f64>> = free
        .iter()
        .map(|j| {
            let row: Vec<f64> = (0..n).map(|i| b[(i, *j)] * size[i]).collect();
            let length = row.iter().map(|v| v * v).sum::<f64>().sqrt();
            row.iter().map(|v| v / length).collect()
        })
        .collect();
    let form = Mat::from_fn(n, n, |i, j| {
        let held: f64 = rows.iter().map(|row| row[i] * row[j]).sum();
        0.5 * (entry(i, j) + entry(j, i)) * size[i] * size[j] + BALANCE * held
    });
    form.llt(Side::Lower).is_ok()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use std::borrow::Cow;

    /// Points overlapping by 1 whose compliance is `1 + mu N`, closed under no load.
    fn family<'f>(coupling: &'f [[f64; 2]]) -> impl Fn(f64, &mut dyn FnMut(&Complementarity<'_>)) + 'f {
        move |mu, read| {
            let n = coupling.len();
            let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
            read(&Complementarity {
                compliance: Cow::Owned(Mat::from_fn(n, n, |i, j| unit(i, j) + mu * coupling[i][j])),
                influence: Mat::zeros(n, 0),
                balance: Mat::zeros(n, 0),
                stiffness: Mat::zeros(0, 0),
                opening: vec![-1.0; n],
                load: Vec::new(),
                symmetric: false,
            });
        }
    }

    /// One particle on two springs, pressed on and dragged along a plane (Klarbring 1990): the normal compliance under sliding is `C_nn + mu C_nt`,
    /// zero at `mu = -C_nn / C_nt`, that is the tangential stiffness over the coupling.
    #[test]
    fn the_sliding_particle_loses_its_solution_at_the_friction_of_the_closed_form() {
        let coupling = [[-1.0 / 0.8, 0.0]];
        let found = follow(&family(&coupling), 2.0, &[1.0]);
        assert!((found.not_guaranteed_from.unwrap() - 0.8).abs() < 1e-4, "{found:?}");
        assert!((found.lost_from.or(found.singular_from).unwrap() - 0.8).abs() < 1e-4, "{found:?}");
        let before = follow(&family(&coupling), 0.79, &[1.0 / (1.0 - 0.79 / 0.8)]);
        assert!(before.is_guaranteed() && before.singular_from.is_none() && before.lost_from.is_none());
    }

    /// `[1, -2 mu; 0, 1]`: the form is indefinite from `mu = 1` on, the determinant is 1 whatever `mu`.
    #[test]
    fn an_indefinite_form_alone_is_no_branching() {
        let found = follow(&family(&[[0.0, -2.0], [0.0, 0.0]]), 3.0, &[7.0, 1.0]);
        assert!((found.not_guaranteed_from.unwrap() - 1.0).abs() < 1e-4, "{found:?}");
        assert_eq!((found.singular_from, found.lost_from), (None, None));
        assert!(found.other_solution < 1e-12);
    }

    /// `[1, mu; mu, 1]`: both change at `mu = 1`; from there on `(1, 0)` and `(0, 1)` are solutions too.
    #[test]
    fn two_points_that_push_each_other_off_branch_where_the_determinant_vanishes() {
        let found = follow(&family(&[[0.0, 1.0], [1.0, 0.0]]), 1.7, &[1.0, 0.0]);
        for from in [found.not_guaranteed_from, found.singular_from] {
            assert!((from.unwrap() - 1.0).abs() < 1e-4, "{found:?}");
        }
        let wait = follow(&family(&[[0.0, 1.0], [1.0, 0.0]]), 0.99, &[1.0 / 1.99; 2]);
        assert!(wait.is_guaranteed());
    }

    #[test]
    fn a_quarter_turn_between_points_leaves_the_form_definite_at_any_friction() {
        assert!(follow(&family(&[[0.0, 1.0], [-1.0, 0.0]]), 1e3, &[0.0; 2]).is_guaranteed());
    }

    #[test]
    fn the_smallest_singular_value_vanishes_where_the_determinant_does() {
        let smallest = |mu: f64| {
            let mut low = f64::NAN;
            family(&[[0.0, 1.0], [1.0, 0.0]])(mu, &mut |problem| {
                low = extreme_singular_values(&of_active(problem, &[true, true])).unwrap()[0];
            });
            low
        };
        assert!((smallest(0.5) - 0.5).abs() < 1e-5 && smallest(1.0) < 1e-15);
    }
}
