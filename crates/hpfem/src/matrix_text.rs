//! Matrices as `[rows, columns, [numbers, column after column]]`, for serde; no number stands as none.

use faer::Mat;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

pub(crate) fn serialize<S: Serializer>(matrix: &Mat<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    let number = |value: &f64| Some(*value).filter(|value| !value.is_nan());
    let numbers: Vec<Option<f64>> = matrix.col_iter().flat_map(|column| column.iter().map(number).collect::<Vec<_>>()).collect();
    (matrix.nrows(), matrix.ncols(), numbers).serialize(serializer)
}

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Mat<f64>, D::Error> {
    let (rows, columns, numbers): (usize, usize, Vec<Option<f64>>) = Deserialize::deserialize(deserializer)?;
    if rows.checked_mul(columns) != Some(numbers.len()) {
        return Err(D::Error::custom(format!("a matrix of {rows} x {columns} with {} numbers", numbers.len())));
    }
    Ok(Mat::from_fn(rows, columns, |i, j| numbers[j * rows + i].unwrap_or(f64::NAN)))
}
