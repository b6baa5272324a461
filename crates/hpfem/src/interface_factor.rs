//! The stiffness of a kept boundary, factorised once for loads that come one after the other.

use crate::check::power_of_two_below;
use crate::interface::InterfaceOperator;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Mat, MatMut, MatRef, Par, get_global_parallelism};

/// The stiffness `S` of an [`InterfaceOperator`], factorised by Cholesky; of a body that its supports leave free the bordered system `[S G; G^T 0]`,
/// whose solutions are those of `[S + a G G^T, G; G^T, 0]`, with `S + a G G^T` factorised and the border eliminated.
#[derive(Clone, Debug)]
pub struct InterfaceFactor {
    /// Number of kept unknowns.
    unknowns: usize,
    /// The unknowns that are solved for, in the order of the matrix.
    pub(crate) order: Vec<usize>,
    pub(crate) form: Form,
}

/// What is factorised, its unknowns in order.
#[derive(Clone, Debug)]
pub(crate) enum Form {
    /// The factor of `unit (S + a G G^T)` on and below the diagonal, and the border.
    Definite { factor: Mat<f64>, unit: f64, border: Option<Border> },
    /// `S` bordered by so many modes, where round-off has left `S` indefinite.
    Bordered { factor: PartialPivLu<f64>, modes: usize },
}

/// What the border `G` adds to a solution `x`: `-K (G^T K)^-1 G^T x` with `(S + a G G^T) K = G`.
#[derive(Clone, Debug)]
pub(crate) struct Border {
    /// `K`, unknowns by modes.
    pub(crate) solved: Mat<f64>,
    /// `K (G^T K)^-1`.
    pub(crate) moved: Mat<f64>,
}

impl InterfaceOperator {
    /// Factorises for [`InterfaceFactor::solve`], `gauge` as in [`InterfaceOperator::solve`] (without columns for a body that is held), for the
    /// unknowns in `order`; those left out are held at zero.
    pub fn factor(&self, gauge: &Mat<f64>, order: Vec<usize>) -> InterfaceFactor {
        let n = order.len();
        let scale = order.iter().map(|i| self.stiffness[(*i, *i)]).fold(0.0, f64::max);
        // In units of a power of two, so that equal problems in other units go through the same square roots.
        let unit = 1.0 / power_of_two_below(scale);
        // Scale the border like the stiffness so that both have a say in each pivot.
        let size = gauge.as_ref().norm_max().max(f64::MIN_POSITIVE);
        let border = Mat::from_fn(n, gauge.ncols(), |i, j| gauge[(order[i], j)] / size);
        let form = self.definite(&order, &border, unit).unwrap_or_else(|| self.bordered(&order, &border, scale));
        InterfaceFactor { unknowns: self.stiffness.nrows(), order, form }
    }

    /// By Cholesky; `None` where round-off does not let it.
    fn definite(&self, order: &[usize], gauge: &Mat<f64>, unit: f64) -> Option<Form> {
        let (n, modes) = (order.len(), gauge.ncols());
        let squares: Vec<f64> = (0..modes).map(|k| gauge.col(k).squared_norm_l2()).collect();
        // Only what lies below the diagonal counts.
        let mut factor = Mat::zeros(n, n);
        for j in 0..n {
            let (from, to) = (self.stiffness.col_as_slice(order[j]), &mut factor.col_as_slice_mut(j)[j..]);
            to.iter_mut().zip(&order[j..]).for_each(|(to, i)| *to = unit * from[*i]);
            for k in 0..modes {
                let share = n as f64 * gauge[(j, k)] / squares[k];
                to.iter_mut().zip(&gauge.col_as_slice(k)[j..]).for_each(|(to, g)| *to += share * g);
            }
        }
        let par = get_global_parallelism();
        let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(n, par, Default::default()));
        let stack = MemStack::new(&mut memory);
        cholesky_in_place(factor.as_mut(), Default::default(), par, stack, Default::default()).ok()?;
        let border = (modes > 0).then(|| {
            let mut solved = gauge.clone();
            solve_last(factor.as_ref(), solved.as_mut());
            let moved = (gauge.transpose() * &solved).partial_piv_lu().solve(solved.transpose()).transpose().to_owned();
            Border { solved, moved }
        });
        Some(Form::Definite { factor, unit, border })
    }

    /// By pivoted LU of the bordered system.
    fn bordered(&self, order: &[usize], gauge: &Mat<f64>, scale: f64) -> Form {
        let (n, modes) = (order.len(), gauge.ncols());
        let matrix = Mat::from_fn(n + modes, n + modes, |i, j| match (i < n, j < n) {
            (true, true) => self.stiffness[(order[i], order[j])],
            (true, false) => gauge[(i, j - n)] * scale,
            (false, true) => gauge[(j, i - n)] * scale,
            (false, false) => 0.0,
        });
        Form::Bordered { factor: matrix.partial_piv_lu(), modes }
    }
}

impl InterfaceFactor {
    /// Number of kept unknowns.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// Whether the stiffness is positive definite on the unknowns that are solved for, apart from the gauge.
    pub fn is_definite(&self) -> bool {
        matches!(self.form, Form::Definite { .. })
    }

    /// The kept unknowns under loads, one a column, as by [`InterfaceOperator::solve`].
    pub fn solve(&self, right: &Mat<f64>) -> Mat<f64> {
        self.solve_from(right, 0)
    }

    /// The same for loads on the unknowns from place `first` of the order on, and only these unknowns; the others are left at zero.
    pub fn solve_from(&self, right: &Mat<f64>, first: usize) -> Mat<f64> {
        let (n, columns) = (self.order.len(), right.ncols());
        let (first, solved) = match &self.form {
            Form::Definite { factor, unit, border } => {
                let mut x = Mat::from_fn(n - first, columns, |i, j| unit * right[(self.order[first + i], j)]);
                let along = border.as_ref().map(|border| border.solved.subrows(first, n - first).transpose() * &x);
                solve_last(factor.as_ref(), x.as_mut());
                if let Some((Border { moved, .. }, along)) = border.as_ref().zip(along) {
                    x -= moved.subrows(first, n - first) * along;
                }
                (first, x)
            }
            Form::Bordered { factor, modes } => {
                let mut x = Mat::from_fn(n + modes, columns, |i, j| if i < n { right[(self.order[i], j)] } else { 0.0 });
                factor.solve_in_place(&mut x);
                (0, x)
            }
        };
        let mut all = Mat::zeros(self.unknowns, columns);
        for j in 0..columns {
            let (from, to) = (solved.col_as_slice(j), all.col_as_slice_mut(j));
            self.order[first..].iter().zip(from).for_each(|(k, value)| to[*k] = *value);
        }
        all
    }
}

/// Solves for the last unknowns under loads on these alone: the first ones add nothing on the way down, and are not asked for on the way up.
fn solve_last(factor: MatRef<'_, f64>, mut x: MatMut<'_, f64>) {
    let first = factor.nrows() - x.nrows();
    let last = factor.submatrix(first, first, x.nrows(), x.nrows());
    solve_lower_triangular_in_place(last, x.as_mut(), Par::Seq);
    solve_upper_triangular_in_place(last.transpose(), x.as_mut(), Par::Seq);
}
