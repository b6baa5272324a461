//! Dense kernels of condensation and of the fronts.
//!
//! Products of matrices are faer's. What is too narrow for it, the factorisation of a few columns, is plain loops over columns, compiled for
//! the instructions of the processor they meet (pulp).

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use pulp::{Arch, Simd, WithSimd};

/// Columns that are factorised before the next ones hear of them.
const BLOCK: usize = 16;
/// Columns of a trailing square that are updated by one product.
const STRIP: usize = 64;

/// Cholesky factorisation of the leading columns `[A11; A21]` (`n` rows, columns one after the other) of a symmetric matrix, in place:
/// `[L11; L21]` below the diagonal; what lies above it is lost.
///
/// # Errors
/// The index of the pivot that is not positive beyond round-off.
pub(crate) fn factor_panel(panel: &mut [f64], n: usize) -> Result<(), usize> {
    let ne = panel.len().checked_div(n).unwrap_or(0);
    let diagonal: Vec<f64> = (0..ne).map(|i| panel[i * n + i]).collect();
    for start in (0..ne).step_by(BLOCK) {
        let width = BLOCK.min(ne - start);
        let (done, rest) = panel.split_at_mut(start * n);
        let columns = &mut rest[..width * n];
        if start > 0 {
            let left = MatRef::from_column_major_slice(done, n, start).subrows(start, n - start);
            let block = MatMut::from_column_major_slice_mut(columns, n, width).subrows_mut(start, n - start);
            matmul(block, Accum::Add, left, left.subrows(0, width).transpose(), -1.0, Par::Seq);
        }
        Arch::new().dispatch(Columns { columns, n, start }).map_err(|index| start + index)?;
    }
    // A pivot that is round-off of the diagonal it came from means a motion that nothing holds.
    let lost = (0..ne).find(|i| panel[i * n + i].powi(2) <= 1e-13 * diagonal[*i]);
    lost.map_or(Ok(()), Err)
}

/// A few columns of a panel of `n` rows, the first of which is column `start`.
struct Columns<'a> {
    columns: &'a mut [f64],
    n: usize,
    start: usize,
}

impl WithSimd for Columns<'_> {
    type Output = Result<(), usize>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Result<(), usize> {
        factor_columns(self.columns, self.n, self.start)
    }
}

/// Factorises a few columns whose rows start at the diagonal in row `start`, each after it has heard of those before.
#[inline(always)]
fn factor_columns(columns: &mut [f64], n: usize, start: usize) -> Result<(), usize> {
    for j in 0..columns.len() / n {
        let (done, rest) = columns.split_at_mut(j * n);
        let column = &mut rest[start + j..n];
        subtract_columns(column, done, n, start + j);
        let pivot = column[0];
        if pivot.is_nan() || pivot <= 0.0 {
            return Err(j);
        }
        let root = pivot.sqrt();
        let inverse = 1.0 / root;
        column.iter_mut().for_each(|x| *x *= inverse);
        column[0] = root;
    }
    Ok(())
}

/// Subtracts from a column, whose first row is row `row` of the `n` rows, the columns `done`, each times its number in that row.
#[inline(always)]
fn subtract_columns(column: &mut [f64], done: &[f64], n: usize, row: usize) {
    let length = column.len();
    let mut fours = done.chunks_exact(4 * n);
    for four in &mut fours {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| &four[k * n + row..k * n + row + length]);
        let [fa, fb, fc, fd] = [a[0], b[0], c[0], d[0]];
        for i in 0..length {
            column[i] -= (fa * a[i] + fb * b[i]) + (fc * c[i] + fd * d[i]);
        }
    }
    for one in fours.remainder().chunks_exact(n) {
        let a = &one[row..row + length];
        let factor = a[0];
        column.iter_mut().zip(a).for_each(|(x, a)| *x -= factor * a);
    }
}

/// `A22 - L21 L21^T` in strips of columns; only the lower triangle counts.
pub(crate) fn subtract_square(l21: MatRef<'_, f64>, mut a22: MatMut<'_, f64>) {
    let n = l21.nrows();
    if l21.ncols() == 0 {
        return;
    }
    for start in (0..n).step_by(STRIP) {
        let width = STRIP.min(n - start);
        let left = l21.subrows(start, n - start);
        let strip = a22.as_mut().subcols_mut(start, width).subrows_mut(start, n - start);
        matmul(strip, Accum::Add, left, left.subrows(0, width).transpose(), -1.0, Par::Seq);
    }
}

/// Factorises the leading `ne` of `n` unknowns in place: on return the first columns hold `[L11; L21]`, the trailing lower triangle the
/// Schur complement.
///
/// # Errors
/// The index of the pivot that is not positive beyond round-off.
pub(crate) fn factor_leading(matrix: &mut [f64], n: usize, ne: usize) -> Result<(), usize> {
    let (panel, trailing) = matrix.split_at_mut(ne * n);
    factor_panel(panel, n)?;
    let l21 = MatRef::from_column_major_slice(panel, n, ne).subrows(ne, n - ne);
    let trailing = MatMut::from_column_major_slice_mut(trailing, n, n - ne).subrows_mut(ne, n - ne);
    subtract_square(l21, trailing);
    Ok(())
}
