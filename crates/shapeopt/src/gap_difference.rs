//! How far two gaps are apart, in parts of the larger one.

use nalgebra::{DMatrix, DVector};

/// What the difference of two gaps is measured by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// The largest gap: the rigid part is the smallest.
    Largest,
    /// The crown, highest minus lowest of the gap without its best rigid part: a rigid part that is prescribed may be any number of
    /// times as large as the shape, and says nothing about it.
    Crown,
}

/// `max |a - b|` of two sampled gaps over the size of `b`, after the best combination of closing velocities (one column a mode) is
/// taken out of the difference. `a` and `b` hold one value a sample (mm); `closing` is samples x modes.
pub fn difference_of_gaps(a: &[f64], b: &[f64], closing: &DMatrix<f64>, measure: Measure) -> f64 {
    let b = DVector::from_column_slice(b);
    let difference = DVector::from_column_slice(a) - &b;
    let size = match measure {
        Measure::Largest => b.max(),
        Measure::Crown => {
            let rest = without_rigid_part(b, closing);
            rest.max() - rest.min()
        }
    };
    without_rigid_part(difference, closing).amax() / size.max(f64::MIN_POSITIVE)
}

/// What is left of sampled values without their best combination of closing velocities.
fn without_rigid_part(values: DVector<f64>, closing: &DMatrix<f64>) -> DVector<f64> {
    if closing.ncols() == 0 {
        return values;
    }
    let mut modes = closing.clone();
    for mut column in modes.column_iter_mut() {
        let size = column.amax();
        if size > 0.0 {
            column /= size;
        }
    }
    // Least squares by the normal equations of modes scaled to size one.
    let best = (modes.transpose() * &modes).lu().solve(&(modes.transpose() * &values));
    match best {
        Some(best) => values - modes * best,
        None => values,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rigid_part_however_large_hides_no_error_of_the_shape() {
        let count = 21;
        let x = |i: usize| i as f64 / 10.0 - 1.0;
        let shape: Vec<f64> = (0..count).map(|i| 1e-3 * x(i).powi(2)).collect();
        let closing = DMatrix::from_fn(count, 2, |i, k| if k == 0 { -1.0 } else { x(i) });
        let wrong: Vec<f64> = shape.iter().map(|g| 1.01 * g).collect();
        let apart = |lift: f64, measure| {
            let lifted = |values: &[f64]| values.iter().map(|g| g + lift).collect::<Vec<f64>>();
            difference_of_gaps(&lifted(&wrong), &lifted(&shape), &closing, measure)
        };
        approx::assert_relative_eq!(apart(0.0, Measure::Crown), apart(5.0, Measure::Crown), max_relative = 1e-9);
        assert!(apart(5.0, Measure::Largest) < 1e-3 * apart(0.0, Measure::Largest));
        // 1 % of x^2 less its mean, over x^2's own range.
        let mean = (0..count).map(|i| x(i).powi(2)).sum::<f64>() / count as f64;
        approx::assert_relative_eq!(apart(0.0, Measure::Crown), 0.01 * mean.max(1.0 - mean), max_relative = 1e-9);
    }
}
