//! Matrices as they are given: shape, finite entries, symmetry.

use crate::error::Error;
use faer::Mat;

/// Largest difference of two entries across the diagonal, relative to the geometric mean of their own diagonal entries.
const ASYMMETRY: f64 = 1e-9;

/// `rows x columns` finite numbers.
pub(crate) fn sized(name: &'static str, matrix: &Mat<f64>, wanted: [usize; 2]) -> Result<(), Error> {
    let given = [matrix.nrows(), matrix.ncols()];
    if given != wanted {
        return Err(Error::Shape { name, wanted, given });
    }
    let places = (0..given[1]).flat_map(|column| (0..given[0]).map(move |row| (row, column)));
    match places.into_iter().find(|place| !matrix[*place].is_finite()) {
        Some((row, column)) => Err(Error::NotFinite { name, row, column }),
        None => Ok(()),
    }
}

/// The matrix made exactly symmetric, if it is `size x size` and symmetric to round-off.
pub(crate) fn symmetric(name: &'static str, matrix: &Mat<f64>, size: usize) -> Result<Mat<f64>, Error> {
    sized(name, matrix, [size, size])?;
    for column in 0..size {
        for row in column + 1..size {
            let (below, above) = (matrix[(row, column)], matrix[(column, row)]);
            let scale = (matrix[(row, row)] * matrix[(column, column)]).abs().sqrt();
            if (below - above).abs() > ASYMMETRY * scale.max(below.abs()).max(above.abs()) {
                return Err(Error::NotSymmetric { name, row, column, below, above });
            }
        }
    }
    Ok(Mat::from_fn(size, size, |i, j| 0.5 * (matrix[(i, j)] + matrix[(j, i)])))
}

/// Numbers above 0.
pub(crate) fn positive(name: &'static str, values: impl Iterator<Item = f64>) -> Result<(), Error> {
    for (place, value) in values.enumerate() {
        if !(value > 0.0 && value.is_finite()) {
            return Err(Error::NotPositive { name, place, value });
        }
    }
    Ok(())
}

/// One finite number for each of `wanted` places.
pub(crate) fn listed(name: &'static str, values: &[f64], wanted: usize) -> Result<(), Error> {
    if values.len() != wanted {
        return Err(Error::Shape { name, wanted: [wanted, 1], given: [values.len(), 1] });
    }
    match values.iter().position(|v| !v.is_finite()) {
        Some(row) => Err(Error::NotFinite { name, row, column: 0 }),
        None => Ok(()),
    }
}
