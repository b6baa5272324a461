//! Factors on the sliding speed at which frictional heat changes what a contact is.
//!
//! With the compliance `C`, the opening `H` by the heat of the pressure, and rigid coordinates `y`, forces `f(s)` at a factor `s` solve
//! `(C + s H) f + Psi y = -d`, `K y - (B + s B_h)^T f = load`. Let `M` take pressures to those that undo the opening by their heat, rigid coordinates free.
//! Pressure and temperature found by turns arrive while `s rho(M) < 1`; at `s = 1 / m`, `m` a real positive eigenvalue of `M`, the system is singular.

use crate::error::Error;
use crate::load::ContactLoad;
use crate::operator::ContactOperator;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Factors on the sliding speed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpeedFactors {
    /// Up to which a calculation of pressure and temperature by turns arrives; none where heat opens nothing.
    pub staggered: Option<f64>,
    /// At which the pressure of surfaces without a gap first vanishes somewhere; 0 where it does without heat.
    pub separation: Option<f64>,
    /// At which the system is singular, growing: those of eigenvectors as fine as the points are no properties of the contact, they move with the
    /// points.
    pub singular: Vec<f64>,
}

/// An eigenvalue counts as real up to this part of its magnitude.
const REAL: f64 = 1e-9;
/// Factors among which a vanishing pressure is looked for, relative to the staggered one, and the ratio of one to the next.
const RANGE: [f64; 2] = [1e-3, 1e3];
const STEP: f64 = 1.1;

/// The system of the closed points in all unknowns: forces, then coordinates.
struct Pencil {
    points: usize,
    cold: Mat<f64>,
    hot: Mat<f64>,
    right: Mat<f64>,
}

impl ContactOperator<'_> {
    /// Factors on the sliding speed of a load whose heat follows the pressure, on the points that are closed.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`]; [`Error::Singular`] where the closed points cannot hold the bodies.
    pub fn speed_factors(&self, load: &ContactLoad, closed: &[bool]) -> Result<SpeedFactors, Error> {
        let Some(pencil) = self.pencil(load, closed)? else { return Ok(SpeedFactors::default()) };
        let solved = pencil.cold.partial_piv_lu().solve(&pencil.hot);
        let n = pencil.points;
        let undone = Mat::from_fn(n, n, |i, j| -solved[(i, j)]);
        let eigenvalues = undone.eigenvalues().map_err(|_| Error::Singular)?;
        let radius = eigenvalues.iter().map(|m| m.re.hypot(m.im)).fold(0.0, f64::max);
        if !(radius > 0.0 && radius.is_finite()) {
            return Ok(SpeedFactors::default());
        }
        let real = eigenvalues.iter().filter(|m| m.re > 0.0 && m.im.abs() <= REAL * radius);
        let mut singular: Vec<f64> = real.map(|m| 1.0 / m.re).filter(|s| *s < RANGE[1] / radius).collect();
        singular.sort_by(f64::total_cmp);
        Ok(SpeedFactors { staggered: Some(1.0 / radius), separation: pencil.separation(1.0 / radius), singular })
    }

    /// The system of the closed points; none where nothing follows the pressure.
    fn pencil(&self, load: &ContactLoad, closed: &[bool]) -> Result<Option<Pencil>, Error> {
        let gap = vec![0.0; self.points().len()];
        let Some(followed) = self.followed(load)? else { return Ok(None) };
        let without = ContactLoad { following: [None, None], ..load.clone() };
        let stage = self.stage(&gap, &without)?;
        let problem = &stage.plain.problem;
        let points: Vec<usize> = (0..gap.len()).filter(|i| closed[*i]).collect();
        let (n, m) = (points.len(), problem.load.len());
        // Coordinates in units in which both blocks are of one size.
        let unit = points.iter().map(|i| problem.compliance[(*i, *i)]).fold(f64::MIN_POSITIVE, f64::max);
        let cold = Mat::from_fn(n + m, n + m, |i, j| match (points.get(i), points.get(j)) {
            (Some(a), Some(b)) => problem.compliance[(*a, *b)],
            (Some(a), None) => unit * problem.influence[(*a, j - n)],
            (None, Some(b)) => -unit * problem.balance[(*b, i - n)],
            (None, None) => unit * unit * problem.stiffness[(i - n, j - n)],
        });
        let hot = Mat::from_fn(n + m, n + m, |i, j| match (points.get(i), points.get(j)) {
            (Some(a), Some(b)) => followed.opening[(*a, *b)],
            (None, Some(b)) => -unit * followed.forces[(*b, stage.free[i - n])],
            (_, None) => 0.0,
        });
        let right = Mat::from_fn(n + m, 1, |i, _| match points.get(i) {
            Some(a) => -problem.opening[*a],
            None => unit * problem.load[i - n],
        });
        Ok(Some(Pencil { points: n, cold, hot, right }))
    }
}

impl Pencil {
    /// Whether the pressure is positive everywhere at a factor.
    fn presses(&self, factor: f64) -> bool {
        let matrix = &self.cold + faer::Scale(factor) * &self.hot;
        let x = matrix.partial_piv_lu().solve(&self.right);
        (0..self.points).all(|i| x[(i, 0)] > 0.0)
    }

    /// The factor at which a pressure vanishes first.
    fn separation(&self, unit: f64) -> Option<f64> {
        if !self.presses(0.0) {
            return Some(0.0);
        }
        let (mut below, mut factor) = (0.0, RANGE[0] * unit);
        while self.presses(factor) {
            below = factor;
            factor *= STEP;
            if factor > RANGE[1] * unit {
                return None;
            }
        }
        let mut above = factor;
        for _ in 0..48 {
            let middle = 0.5 * (below + above);
            if self.presses(middle) { below = middle } else { above = middle }
        }
        Some(0.5 * (below + above))
    }
}
