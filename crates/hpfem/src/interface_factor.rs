//! The stiffness of a kept boundary, factorised once for loads that come one after the other.

use crate::check::power_of_two_below;
use crate::interface::InterfaceOperator;
use faer::linalg::solvers::{Llt, PartialPivLu, Solve};
use faer::{Mat, Scale, Side};

/// The stiffness of an [`InterfaceOperator`], factorised: of a body that is held by Cholesky, of one that its supports leave free as the bordered
/// system `[S G; G^T 0]` by pivoted LU.
#[derive(Clone, Debug)]
pub struct InterfaceFactor {
    unknowns: usize,
    form: Form,
}

/// What is factorised.
#[derive(Clone, Debug)]
enum Form {
    /// `unit S`.
    Held { factor: Llt<f64>, unit: f64 },
    /// `S` bordered by so many modes.
    Bordered { factor: PartialPivLu<f64>, modes: usize },
}

impl InterfaceOperator {
    /// Factorises for [`InterfaceFactor::solve`]; `gauge` as in [`InterfaceOperator::solve`].
    pub fn factor(&self, gauge: &Mat<f64>) -> InterfaceFactor {
        let n = self.stiffness.nrows();
        let r = self.rigid_modes.ncols();
        let scale = (0..n).map(|i| self.stiffness[(i, i)]).fold(0.0, f64::max);
        // In units of a power of two, so that equal problems in other units go through the same square roots.
        let unit = 1.0 / power_of_two_below(scale);
        if r == 0
            && let Ok(factor) = (Scale(unit) * &self.stiffness).llt(Side::Lower)
        {
            return InterfaceFactor { unknowns: n, form: Form::Held { factor, unit } };
        }
        // Scale the border like the stiffness so that pivoting sees comparable rows.
        let size = gauge.as_ref().norm_max().max(f64::MIN_POSITIVE);
        let border = Mat::from_fn(n + r, n + r, |i, j| match (i < n, j < n) {
            (true, true) => self.stiffness[(i, j)],
            (true, false) => gauge[(i, j - n)] / size * scale,
            (false, true) => gauge[(j, i - n)] / size * scale,
            (false, false) => 0.0,
        });
        InterfaceFactor { unknowns: n, form: Form::Bordered { factor: border.partial_piv_lu(), modes: r } }
    }
}

impl InterfaceFactor {
    /// The kept unknowns under loads, one a column, as by [`InterfaceOperator::solve`].
    pub fn solve(&self, right: &Mat<f64>) -> Mat<f64> {
        let n = self.unknowns;
        match &self.form {
            Form::Held { factor, unit } => {
                let mut x = Scale(*unit) * right;
                factor.solve_in_place(&mut x);
                x
            }
            Form::Bordered { factor, modes } => {
                let mut x = Mat::zeros(n + modes, right.ncols());
                x.subrows_mut(0, n).copy_from(right);
                factor.solve_in_place(&mut x);
                x.truncate(n, right.ncols());
                x
            }
        }
    }
}
