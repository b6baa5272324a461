//! How fast deviations of a worn-in contact grow or wear off, its heat following the pressure.
//!
//! A depth `w` worn off beyond the steady one changes forces and coordinates by `A (f, y) = (-w, 0)`, `A` the system of the closed points with the heat of the
//! pressure ([`crate::heat_speed`]), and wear follows the pressure `q`: `w' = k q`, `k` the slope of the wear rule. Pressures and depths are sums
//! `Phi a`, `Phi c` of few functions, orthonormal by the areas `W`, and what each side lacks is orthogonal to all of them:
//! `c' = Phi^T W k Phi a = -K T c`, with `T` the block of pressures of the inverse of `A` between these functions. Without heat `A` and `k` are positive, and
//! so is every eigenvalue of `K T`; with heat pairs of complex ones may cross to the other side at speeds at which `A` is regular.

use crate::eigenvalues::eigenvalues;
use crate::error::Error;
use crate::load::ContactLoad;
use crate::operator::ContactOperator;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Rates up to this part of the largest are those of rigid motions, zero but for round-off.
const ROUND_OFF: f64 = 1e-9;

impl ContactOperator<'_> {
    /// The largest real part (1/s) of the growth rates `r` in `r (C + H) f + r Psi y = -k q`, `K y = B^T f`, `f = W q`: with the compliance `C` and the opening `H`
    /// by heat (mm/N), rigid coordinates `y`, areas `W` and slopes `k` of the wear rate. Wear damps what heat drives (Dow and Burton, J. Lubr. Technol. 95, 1973,
    /// 71-75); here heat flows at once.
    ///
    /// It is the fastest growth of a deviation of a contact whose heat follows the pressure of its load, on the points that are closed: 0 where all
    /// wear off but rigid motions, which change no pressure; none where nothing wears or no heat follows. `slopes` are those of the wear rate by the
    /// pressure at the points (mm/(s MPa)), `functions` those that deviations are made of, `points x functions`, orthonormal by the areas of the points.
    ///
    /// # Errors
    /// As [`ContactOperator::speed_factors`].
    pub fn deviation_growth(
        &self,
        load: &ContactLoad,
        closed: &[bool],
        (slopes, functions): (&[f64], &Mat<f64>),
    ) -> Result<Option<f64>, Error> {
        let Some(pencil) = self.pencil(load, closed)? else { return Ok(None) };
        if !slopes.iter().any(|slope| *slope > 0.0) {
            return Ok(None);
        }
        let points: Vec<usize> = (0..closed.len()).filter(|i| closed[*i]).collect();
        let (n, many) = (points.len(), functions.ncols());
        let weight = |i: usize| self.points()[points[i]].weight;
        let all = pencil.cold.nrows();
        let between = Mat::from_fn(all, many + all - n, |i, k| match (i < n, k < many) {
            (true, true) => weight(i) * functions[(points[i], k)],
            (false, false) => f64::from(u8::from(i - n == k - many)),
            _ => 0.0,
        });
        let hot = &pencil.by_case * (&pencil.follows * between.get(..n, ..));
        let system = between.transpose() * (&pencil.cold * &between + hot);
        let depths = Mat::from_fn(system.nrows(), many, |i, k| f64::from(u8::from(i == k)));
        let pressures = system.partial_piv_lu().solve(&depths).get(..many, ..).to_owned();
        let worn = Mat::from_fn(many, many, |j, k| {
            (0..n).map(|i| weight(i) * slopes[points[i]] * functions[(points[i], j)] * functions[(points[i], k)]).sum::<f64>()
        });
        let rates = eigenvalues(&(&worn * &pressures))?;
        let largest = rates.iter().map(|[re, im]| re.hypot(*im)).fold(0.0, f64::max);
        let fastest = rates.iter().map(|[re, _]| -re).fold(f64::NEG_INFINITY, f64::max);
        Ok(fastest.is_finite().then_some(if fastest.abs() > ROUND_OFF * largest { fastest } else { 0.0 }))
    }
}
