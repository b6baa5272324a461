//! Products of matrices and vectors.

use faer::Mat;

/// Rows that are multiplied at once by [`narrow_product`].
const ROWS: usize = 16;

/// `a b` where a row of `a` has few entries beside zeros, and its neighbours have theirs in nearly the same columns.
pub(crate) fn narrow_product(a: &Mat<f64>, b: &Mat<f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.nrows(), b.ncols());
    for first in (0..a.nrows()).step_by(ROWS) {
        let block = a.subrows(first, ROWS.min(a.nrows() - first));
        let last = first + block.nrows();
        let columns: Vec<usize> = (0..a.ncols()).filter(|k| a.col_as_slice(*k)[first..last].iter().any(|v| *v != 0.0)).collect();
        let few = Mat::from_fn(block.nrows(), columns.len(), |i, k| block[(i, columns[k])]);
        let mut rows = Mat::zeros(columns.len(), b.ncols());
        for j in 0..b.ncols() {
            let from = b.col_as_slice(j);
            rows.col_as_slice_mut(j).iter_mut().zip(&columns).for_each(|(to, k)| *to = from[*k]);
        }
        product.as_mut().subrows_mut(first, block.nrows()).copy_from(few * rows);
    }
    product
}

/// Some rows of a matrix.
pub(crate) fn rows_of(matrix: &Mat<f64>, at: &[usize]) -> Mat<f64> {
    Mat::from_fn(at.len(), matrix.ncols(), |i, j| matrix[(at[i], j)])
}

/// Matrix times vector.
pub(crate) fn times(matrix: &Mat<f64>, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; matrix.nrows()];
    for (j, v) in x.iter().enumerate().filter(|(_, v)| **v != 0.0) {
        matrix.col(j).iter().zip(&mut y).for_each(|(a, y)| *y += a * v);
    }
    y
}

/// Transposed matrix times vector.
pub(crate) fn transposed_times(matrix: &Mat<f64>, x: &[f64]) -> Vec<f64> {
    (0..matrix.ncols()).map(|j| matrix.col(j).iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

/// `y += x`.
pub(crate) fn add(y: &mut [f64], x: &[f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += x);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_product_of_narrow_rows_is_that_of_all_columns() {
        // Bands of five entries that move on with the rows, more rows than one block has, and a row of zeros.
        let band = |i: usize, j: usize| if i != 20 && (2 * i..2 * i + 5).contains(&j) { 1.0 + (i * j) as f64 } else { 0.0 };
        let (a, b) = (Mat::from_fn(37, 80, band), Mat::from_fn(80, 9, |i, j| (i as f64 * 0.37 + j as f64).sin()));
        let difference = narrow_product(&a, &b) - &a * &b;
        assert!(difference.norm_max() < 1e-15 * (&a * &b).norm_max());
    }
}
