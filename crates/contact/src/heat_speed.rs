//! Factors on the sliding speed at which frictional heat changes what a contact is.
//!
//! With the compliance `C`, the opening `H` by the heat of the pressure, and rigid coordinates `y`, forces `f(s)` at a factor `s` solve
//! `(C + s H) f + Psi y = -d`, `K y - (B + s B_h)^T f = load`. Let `M` take pressures to those that undo the opening by their heat, rigid coordinates free.
//! Pressure and temperature found by turns arrive while `s rho(M) < 1`; at `s = 1 / m`, `m` a real positive eigenvalue of `M`, the system is singular.

use crate::eigenvalues::eigenvalues;
use crate::error::Error;
use crate::following::Followers;
use crate::load::ContactLoad;
use crate::operator::ContactOperator;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Factors on the sliding speed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpeedFactors {
    /// Up to which a calculation of pressure and temperature by turns arrives; none where heat opens nothing.
    pub staggered: Option<f64>,
    /// At which the system is singular, growing: those of eigenvectors as fine as the points are no properties of the contact, they move with the
    /// points.
    pub singular: Vec<f64>,
}

/// An eigenvalue counts as real up to this part of its magnitude.
const REAL: f64 = 1e-9;
/// Factors among which a vanishing pressure is looked for, relative to the staggered one, and the ratio of one to the next.
const RANGE: [f64; 2] = [1e-3, 1e3];
const STEP: f64 = 1.1;

/// Up to this part of the staggered factor pressures are told by their power series, of so many terms, relative to the first of which the last counts
/// as nothing.
const SERIES: f64 = 0.8;
const TERMS: usize = 400;
const NOTHING: f64 = 1e-13;

/// Least part of the area that a point has whose pressure is told from nothing: forces have round-off of some 1e-11 of the load, which on the smallest
/// elements at the ends of a surface is more than the pressure itself.
const LEAST_AREA: f64 = 1e-6;

/// Steps of a search between two factors, the first of which are those of a false position.
const HALVINGS: usize = 48;
const SLOPES: usize = 24;

/// The system of the closed points in all unknowns: forces, then coordinates. The hot part is `by_case follows`, of few columns where the heat is that of few
/// fluxes.
pub(crate) struct Pencil {
    points: usize,
    /// Points whose pressure can be told from nothing.
    told: Vec<usize>,
    pub(crate) cold: Mat<f64>,
    pub(crate) by_case: Mat<f64>,
    pub(crate) follows: Mat<f64>,
    right: Mat<f64>,
}

impl ContactOperator<'_> {
    /// Factors on the sliding speed of a load whose heat follows the pressure, on the points that are closed.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`]; [`Error::Singular`] where the closed points cannot hold the bodies.
    pub fn speed_factors(&self, load: &ContactLoad, closed: &[bool]) -> Result<SpeedFactors, Error> {
        let Some(pencil) = self.pencil(load, closed)? else { return Ok(SpeedFactors::default()) };
        factors(&pencil.solved().passed)
    }

    /// The same of surfaces all of whose points are closed, and the factor on the sliding speed at which their pressure, without a gap, first vanishes
    /// somewhere: 0 where it does without heat, none where it does not up to a thousand times the staggered factor. Points with less than 1e-6 of the area
    /// do not count, whose pressure is round-off.
    ///
    /// # Errors
    /// As [`ContactOperator::speed_factors`].
    pub fn closed_factors(&self, load: &ContactLoad) -> Result<(SpeedFactors, Option<f64>), Error> {
        let closed = vec![true; self.points().len()];
        let Some(pencil) = self.pencil(load, &closed)? else { return Ok((SpeedFactors::default(), None)) };
        let solved = pencil.solved();
        let factors = factors(&solved.passed)?;
        let separation = factors.staggered.and_then(|staggered| solved.separation(staggered));
        Ok((factors, separation))
    }

    /// The system of the closed points; none where nothing follows the pressure.
    pub(crate) fn pencil(&self, load: &ContactLoad, closed: &[bool]) -> Result<Option<Pencil>, Error> {
        let gap = vec![0.0; self.points().len()];
        let Some(Followers { by_case, factors }) = self.followers(load)? else { return Ok(None) };
        let without = ContactLoad { following: [None, None], ..load.clone() };
        let stage = self.stage(&gap, &without)?;
        let problem = &stage.plain.problem;
        let points: Vec<usize> = (0..gap.len()).filter(|i| closed[*i]).collect();
        let (n, m, many) = (points.len(), problem.load.len(), factors.nrows());
        // Coordinates in units in which both blocks are of one size.
        let unit = points.iter().map(|i| problem.compliance[(*i, *i)]).fold(f64::MIN_POSITIVE, f64::max);
        let cold = Mat::from_fn(n + m, n + m, |i, j| match (points.get(i), points.get(j)) {
            (Some(a), Some(b)) => problem.compliance[(*a, *b)],
            (Some(a), None) => unit * problem.influence[(*a, j - n)],
            (None, Some(b)) => -unit * problem.balance[(*b, i - n)],
            (None, None) => unit * unit * problem.stiffness[(i - n, j - n)],
        });
        let by_case = Mat::from_fn(n + m, many, |i, k| match points.get(i) {
            Some(a) => by_case.opening[(*a, k)],
            None => -unit * by_case.forces[(k, stage.free[i - n])],
        });
        let right = Mat::from_fn(n + m, 1, |i, _| match points.get(i) {
            Some(a) => -problem.opening[*a],
            None => unit * problem.load[i - n],
        });
        let weight = |point: usize| self.points()[points[point]].weight;
        let area: f64 = (0..n).map(weight).sum();
        let told = (0..n).filter(|point| weight(*point) >= LEAST_AREA * area).collect();
        let follows = Mat::from_fn(many, n, |k, j| factors[(k, points[j])]);
        Ok(Some(Pencil { points: n, told, cold, by_case, follows, right }))
    }
}

/// What one factorisation of the system without heat tells: `p(s) = p(0) + s U (1 - s F U)^-1 F p(0)`, and `M = U F` has the eigenvalues of `F U`, but for
/// zeros.
struct Solved {
    /// Points whose pressure can be told from nothing.
    told: Vec<usize>,
    /// `U`: pressures that undo the opening by a unit of each case.
    undone: Mat<f64>,
    /// `F`: what the cases follow.
    follows: Mat<f64>,
    /// `F U`.
    passed: Mat<f64>,
    /// The pressures, a column.
    pressures: Mat<f64>,
}

/// The factors that the eigenvalues of `M` tell.
fn factors(undone: &Mat<f64>) -> Result<SpeedFactors, Error> {
    let eigenvalues = eigenvalues(undone)?;
    let radius = eigenvalues.iter().map(|[re, im]| re.hypot(*im)).fold(0.0, f64::max);
    if !(radius > 0.0 && radius.is_finite() && (RANGE[1] / radius).is_finite()) {
        return Ok(SpeedFactors::default());
    }
    let real = eigenvalues.iter().filter(|[re, im]| *re > 0.0 && im.abs() <= REAL * radius);
    let mut singular: Vec<f64> = real.map(|[re, _]| 1.0 / re).filter(|s| *s < RANGE[1] / radius).collect();
    singular.sort_unstable_by(f64::total_cmp);
    Ok(SpeedFactors { staggered: Some(1.0 / radius), singular })
}

impl Pencil {
    fn solved(self) -> Solved {
        let factors = self.cold.partial_piv_lu();
        let solved = factors.solve(&self.by_case);
        let undone = Mat::from_fn(self.points, self.by_case.ncols(), |i, k| -solved[(i, k)]);
        let pressures = factors.solve(&self.right).get(..self.points, ..).to_owned();
        Solved { told: self.told, passed: &self.follows * &undone, follows: self.follows, undone, pressures }
    }
}

impl Solved {
    /// The least pressure at a factor.
    fn least(&self, factor: f64) -> f64 {
        let many = self.passed.nrows();
        let matrix = Mat::from_fn(many, many, |i, j| f64::from(u8::from(i == j)) - factor * self.passed[(i, j)]);
        let beyond = &self.undone * matrix.partial_piv_lu().solve(&self.follows * &self.pressures);
        self.told.iter().map(|i| self.pressures[(*i, 0)] + factor * beyond[(*i, 0)]).fold(f64::INFINITY, f64::min)
    }

    /// The factor at which a pressure vanishes first.
    fn separation(&self, unit: f64) -> Option<f64> {
        let pressed = |factor: f64| Some([factor, self.least(factor)]).filter(|[_, least]| *least > 0.0);
        if !self.told.iter().all(|i| self.pressures[(*i, 0)] > 0.0) {
            return Some(0.0);
        }
        // With hardly any heat no factor that is a number is large enough.
        if !(RANGE[1] * unit).is_finite() {
            return None;
        }
        let mut below = self.before(unit).and_then(pressed).unwrap_or([0.0; 2]);
        let mut factor = if below[0] > 0.0 { STEP * below[0] } else { RANGE[0] * unit };
        while let Some(pressed) = pressed(factor) {
            below = pressed;
            factor *= STEP;
            if factor > RANGE[1] * unit {
                return None;
            }
        }
        Some(self.between(below, [factor, self.least(factor)]))
    }

    /// The last factor of the search before the first at which a pressure vanishes, or before the end of the power series, `p(s) = sum s^k M^k p(0)`,
    /// which takes no factorisation; none where it does not converge, or no factor is before.
    fn before(&self, unit: f64) -> Option<f64> {
        let size = |term: &Mat<f64>| term.norm_max();
        let mut terms = vec![self.pressures.clone()];
        let highest = SERIES * unit;
        loop {
            let last = size(terms.last()?);
            if last <= NOTHING * size(&terms[0]) {
                break;
            }
            // Nor does it where terms are no numbers.
            if terms.len() > TERMS {
                return None;
            }
            terms.push(faer::Scale(highest) * (&self.undone * (&self.follows * terms.last()?)));
        }
        let factors = std::iter::successors(Some(RANGE[0] * unit), |factor| Some(factor * STEP));
        let factors: Vec<f64> = factors.take_while(|factor| *factor <= highest).collect();
        let by_power = Mat::from_fn(self.pressures.nrows(), terms.len(), |i, k| terms[k][(i, 0)]);
        let powers = Mat::from_fn(terms.len(), factors.len(), |k, j| (factors[j] / highest).powi(k as i32));
        let pressures = by_power * powers;
        let presses = |j: &usize| self.told.iter().all(|i| pressures[(*i, *j)] > 0.0);
        (0..factors.len()).take_while(presses).last().map(|j| factors[j])
    }

    /// Where the least pressure vanishes, between a factor with its least pressure, which is positive, and one where it is not: by false position, of
    /// which an end that stays counts half (Illinois), and in the end by halves.
    fn between(&self, [mut below, mut most]: [f64; 2], [mut above, mut least]: [f64; 2]) -> f64 {
        let mut last = 0.0;
        for step in 0..HALVINGS + SLOPES {
            let weight = if step < SLOPES && (most - least).is_finite() { most / (most - least) } else { 0.5 };
            let middle = below + weight * (above - below);
            if !(middle > below && middle < above) {
                return middle.clamp(below, above);
            }
            let found = self.least(middle);
            if found > 0.0 {
                (below, most) = (middle, found);
                least *= if last > 0.0 { 0.5 } else { 1.0 };
            } else {
                (above, least) = (middle, found);
                most *= if last < 0.0 { 0.5 } else { 1.0 };
            }
            last = found;
        }
        0.5 * (below + above)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A system of two points with the pressures `p_1 = (1 - s / 4 p_2) / (1 - s / 4)` and `p_2 = 1 - s / at p_1`.
    fn system(at: f64) -> Solved {
        let hot = [[-0.25, 0.25], [1.0 / at, 0.0]];
        let by_case = Mat::from_fn(2, 2, |i, j| hot[i][j]);
        let (cold, follows) = (Mat::identity(2, 2), Mat::identity(2, 2));
        Pencil { points: 2, told: vec![0, 1], cold, by_case, follows, right: Mat::full(2, 1, 1.0) }.solved()
    }

    /// The factor by halves alone, from a fine search.
    fn by_halves(system: &Solved) -> f64 {
        let (mut below, mut above) = (0.0, 1e-3);
        while system.least(above) > 0.0 {
            (below, above) = (above, above + 1e-3);
        }
        for _ in 0..60 {
            let middle = 0.5 * (below + above);
            if system.least(middle) > 0.0 { below = middle } else { above = middle }
        }
        below
    }

    #[test]
    fn the_search_for_separation_finds_what_halving_finds_with_the_power_series_and_beyond_it() {
        for at in [0.05, 0.7, 3.0] {
            let solved = system(at);
            let wanted = by_halves(&solved);
            let radius = 1.0 / factors(&solved.passed).unwrap().staggered.unwrap();
            // The series lasts to a part of the staggered factor.
            for unit in [1.0 / radius, 100.0 / radius] {
                let found = solved.separation(unit).unwrap();
                assert!((found / wanted - 1.0).abs() < 1e-12, "{at} {unit}: {found} for {wanted}");
            }
        }
    }
}
