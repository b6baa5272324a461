//! Dense kernels of condensation and of the fronts.
//!
//! Products of matrices are faer's. What is too narrow for it, the factorisation of a few columns, is plain loops over columns, compiled for
//! the instructions of the processor they meet (pulp).

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use pulp::{Arch, Simd, WithSimd};

/// Columns that are factorised before the next ones hear of them.
const BLOCK: usize = 16;
/// Columns that are factorised before all columns behind them hear of them at once.
const PANEL: usize = 128;
/// Columns of what lies behind that are updated by one product.
const STRIP: usize = 64;
/// Multiplications from which the strips are shared among threads.
#[cfg(all(feature = "rayon", not(target_family = "wasm")))]
const SHARED: usize = 1 << 23;

/// Cholesky factorisation of the leading columns `[A11; A21]` (`n` rows, columns one after the other) of a symmetric matrix, in place:
/// `[L11; L21]` below the diagonal; what lies above it is lost.
///
/// # Errors
/// The index of the pivot that is not positive beyond round-off.
pub(crate) fn factor_panel(panel: &mut [f64], n: usize) -> Result<(), usize> {
    let ne = panel.len().checked_div(n).unwrap_or(0);
    let diagonal: Vec<f64> = (0..ne).map(|i| panel[i * n + i]).collect();
    for start in (0..ne).step_by(PANEL) {
        let width = PANEL.min(ne - start);
        let (block, behind) = panel[start * n..].split_at_mut(width * n);
        factor_block(block, n, start)?;
        let (next, columns) = (start + width, ne - start - width);
        let left = MatRef::from_column_major_slice(block, n, width).subrows(next, n - next);
        subtract_product(left, MatMut::from_column_major_slice_mut(behind, n, columns).subrows_mut(next, n - next));
    }
    // A pivot that is round-off of the diagonal it came from means a motion that nothing holds.
    let lost = (0..ne).find(|i| panel[i * n + i].powi(2) <= 1e-13 * diagonal[*i]);
    lost.map_or(Ok(()), Err)
}

/// The columns of a panel from column `first` on, which know of all before, in blocks.
fn factor_block(panel: &mut [f64], n: usize, first: usize) -> Result<(), usize> {
    let ne = panel.len() / n;
    for at in (0..ne).step_by(BLOCK) {
        let (start, width) = (first + at, BLOCK.min(ne - at));
        let (done, rest) = panel.split_at_mut(at * n);
        let columns = &mut rest[..width * n];
        if at > 0 {
            let left = MatRef::from_column_major_slice(done, n, at).subrows(start, n - start);
            let block = MatMut::from_column_major_slice_mut(columns, n, width).subrows_mut(start, n - start);
            matmul(block, Accum::Add, left, left.subrows(0, width).transpose(), -1.0, Par::Seq);
        }
        Arch::new().dispatch(Columns { columns, n, start }).map_err(|index| start + index)?;
    }
    Ok(())
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

/// `A - L L_1^T` of as many columns as `A` has, `L_1` being the first rows of `L`; only the lower triangle counts. Strips of columns
/// are shared among threads where that pays, with the same bits for any number of them.
pub(crate) fn subtract_product(left: MatRef<'_, f64>, a: MatMut<'_, f64>) {
    let (rows, columns) = (a.nrows(), a.ncols());
    if left.ncols() == 0 || columns == 0 {
        return;
    }
    let strip = |(start, strip): (usize, MatMut<'_, f64>)| {
        let left = left.subrows(start, rows - start);
        let first = left.subrows(0, strip.ncols()).transpose();
        matmul(strip.subrows_mut(start, rows - start), Accum::Add, left, first, -1.0, Par::Seq);
    };
    let mut behind = a;
    let strips = (0..columns).step_by(STRIP).map(|start| {
        let all = std::mem::replace(&mut behind, MatMut::from_column_major_slice_mut(&mut [], 0, 0));
        let (own, rest) = all.split_at_col_mut(STRIP.min(columns - start));
        behind = rest;
        (start, own)
    });
    #[cfg(all(feature = "rayon", not(target_family = "wasm")))]
    if rows * columns * left.ncols() > SHARED && rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        let strips: Vec<_> = strips.collect();
        return strips.into_par_iter().for_each(strip);
    }
    strips.for_each(strip);
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
    subtract_product(l21, trailing);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::Mat;

    /// The factorised panel and what is left of a matrix, on a pool of so many threads.
    fn factored(a: &Mat<f64>, ne: usize, threads: usize) -> Vec<f64> {
        let mut matrix: Vec<f64> = a.col_iter().flat_map(|c| c.iter().copied().collect::<Vec<_>>()).collect();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| factor_leading(&mut matrix, a.nrows(), ne)).expect("a definite matrix");
        matrix
    }

    #[test]
    fn panels_wider_than_a_block_are_the_factors_of_their_matrix_with_the_same_bits_for_any_number_of_threads() {
        let (n, ne) = (600, 300);
        let entry = |i: usize, j: usize| {
            if i == j { 30.0 } else { (i as f64 - 0.7 * j as f64).sin() + (j as f64 - 0.7 * i as f64).sin() }
        };
        let a = Mat::from_fn(n, n, |i, j| entry(i, j) + if i == j { n as f64 } else { 0.0 });
        // Large enough for the strips to be shared.
        #[cfg(all(feature = "rayon", not(target_family = "wasm")))]
        assert!((n - ne).pow(2) * ne > SHARED);
        let one = factored(&a, ne, 1);
        let lower = |i: usize, j: usize| if i >= j { one[j * n + i] } else { 0.0 };
        let l = Mat::from_fn(n, ne, lower);
        let product = &l * l.transpose();
        for j in 0..n {
            for i in j..n {
                let left = if j < ne { 0.0 } else { one[j * n + i] };
                let miss = (product[(i, j)] + left - a[(i, j)]).abs();
                assert!(miss < 1e-12 * n as f64, "{i} {j} {miss:.1e}");
            }
        }
        let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        assert!(bits(&one) == bits(&factored(&a, ne, 2)) && bits(&one) == bits(&factored(&a, ne, 3)));
    }
}
