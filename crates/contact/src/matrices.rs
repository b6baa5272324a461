//! Compliance of a contact at its points: what unit forces and motions do, as plain matrices.

use crate::error::Error;
use crate::load::Friction;
use faer::Mat;
use std::borrow::Cow;

/// Opening `w = C lambda + C_nt sigma + Psi y` and slip `s = C_nt^T lambda + C_tt sigma + Psi_t y` by nodal normal forces `lambda`, nodal
/// shear forces `sigma` on body 1 and coordinates `y`.
#[derive(Clone, Debug)]
pub(crate) struct Matrices {
    /// `C`, `points x points`.
    pub(crate) normal: Mat<f64>,
    /// `C_nt`: normal opening by shear forces.
    pub(crate) normal_by_shear: Option<Mat<f64>>,
    /// `C_tt`: slip by shear forces.
    pub(crate) tangential: Option<Mat<f64>>,
    /// `Psi`: opening by coordinates.
    pub(crate) influence: Mat<f64>,
    /// `Psi_t`: slip by coordinates.
    pub(crate) shear_influence: Option<Mat<f64>>,
}

impl Matrices {
    pub(crate) fn points(&self) -> usize {
        self.normal.nrows()
    }

    /// Shear per normal force at each point, and whether there is any.
    pub(crate) fn slide(&self, friction: &Friction) -> Result<(Vec<f64>, bool), Error> {
        let n = self.points();
        let Friction::Sliding { coefficient, drag } = friction else { return Ok((vec![0.0; n], false)) };
        let sound = *coefficient >= 0.0 && coefficient.is_finite() && drag.len() == n && drag.iter().all(|d| d.abs() <= 1.0);
        if !sound {
            return Err(Error::Drag { coefficient: *coefficient, given: drag.len(), points: n });
        }
        let slide: Vec<f64> = drag.iter().map(|d| coefficient * d).collect();
        let active = slide.iter().any(|s| *s != 0.0);
        if active && self.normal_by_shear.is_none() {
            return Err(Error::ShearNotPrepared);
        }
        Ok((slide, active))
    }

    /// Compliance and balance with the shear of steady sliding in them; the balance of a `guided` coordinate is that of the pressure alone.
    pub(crate) fn sliding(&self, slide: &[f64], active: bool, guided: &[bool]) -> (Cow<'_, Mat<f64>>, Mat<f64>) {
        let n = self.points();
        let mut compliance = Cow::Borrowed(&self.normal);
        let mut balance = self.influence.clone();
        if let (true, Some(by_shear), Some(shear)) = (active, &self.normal_by_shear, &self.shear_influence) {
            compliance = Cow::Owned(Mat::from_fn(n, n, |i, j| self.normal[(i, j)] + by_shear[(i, j)] * slide[j]));
            for j in (0..balance.ncols()).filter(|j| !guided[*j]) {
                (0..n).for_each(|i| balance[(i, j)] += slide[i] * shear[(i, j)]);
            }
        }
        (compliance, balance)
    }
}
