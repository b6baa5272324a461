//! Eigenvalues of square matrices that need not be symmetric.

use crate::error::Error;
use faer::Mat;

/// Eigenvalues `[re, im]` of a square matrix: by faer, which is the quicker one of large matrices, and in browsers by nalgebra, which is the smaller one.
///
/// # Errors
/// [`Error::Singular`] if they are not found, or the matrix has entries that are no numbers; [`Error::Shape`].
pub fn eigenvalues(matrix: &Mat<f64>) -> Result<Vec<[f64; 2]>, Error> {
    let given = [matrix.nrows(), matrix.ncols()];
    if given[0] != given[1] {
        return Err(Error::Shape { name: "matrix", wanted: [given[0]; 2], given });
    }
    #[cfg(target_family = "wasm")]
    return small(matrix);
    #[cfg(not(target_family = "wasm"))]
    Ok(matrix.eigenvalues().map_err(|_| Error::Singular)?.iter().map(|m| [m.re, m.im]).collect())
}

/// By the iteration of Francis, of so many steps a row at most: it needs two or three.
#[cfg(any(test, target_family = "wasm"))]
fn small(matrix: &Mat<f64>) -> Result<Vec<[f64; 2]>, Error> {
    const STEPS: usize = 60;
    let n = matrix.nrows();
    let numbers = nalgebra::DMatrix::from_fn(n, n, |i, j| matrix[(i, j)]);
    if !numbers.iter().all(|value| value.is_finite()) {
        return Err(Error::Singular);
    }
    let triangle = nalgebra::Schur::try_new(numbers, f64::EPSILON, STEPS * n).ok_or(Error::Singular)?;
    Ok(triangle.complex_eigenvalues().iter().map(|m| [m.re, m.im]).collect())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn both_libraries_find_the_same_eigenvalues() {
        let wave = |i: usize, j: usize| ((3 * i + 7 * j) as f64).sin() + if i == j { 0.3 * i as f64 } else { 0.0 };
        for n in [1, 2, 30, 90] {
            let matrix = Mat::from_fn(n, n, wave);
            let [one, other] = [eigenvalues, small].map(|found| {
                let mut found = found(&matrix).unwrap();
                found.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
                found
            });
            let largest = one.iter().map(|m| m[0].hypot(m[1])).fold(0.0, f64::max);
            for m in &one {
                let nearest = other.iter().map(|w| (m[0] - w[0]).hypot(m[1] - w[1])).fold(f64::INFINITY, f64::min);
                assert!(nearest <= 1e-10 * largest, "{n} {m:?} {nearest:.1e}");
            }
            assert_eq!(one.len(), other.len());
        }
        let none = Mat::full(2, 2, f64::NAN);
        assert!(small(&none).is_err());
    }
}
