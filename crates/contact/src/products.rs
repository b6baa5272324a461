//! Products of matrices and vectors.

use faer::Mat;

/// Some rows of a matrix.
pub(crate) fn rows_of(matrix: &Mat<f64>, at: &[usize]) -> Mat<f64> {
    Mat::from_fn(at.len(), matrix.ncols(), |i, j| matrix[(at[i], j)])
}

/// Matrix times vector.
pub(crate) fn times(matrix: &Mat<f64>, x: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; matrix.nrows()];
    for (j, v) in x.iter().enumerate().filter(|(_, v)| **v != 0.0) {
        matrix.col_as_slice(j).iter().zip(&mut y).for_each(|(a, y)| *y += a * v);
    }
    y
}

/// Transposed matrix times vector.
pub(crate) fn transposed_times(matrix: &Mat<f64>, x: &[f64]) -> Vec<f64> {
    (0..matrix.ncols()).map(|j| matrix.col_as_slice(j).iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

/// `y += x`.
pub(crate) fn add(y: &mut [f64], x: &[f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += x);
}
