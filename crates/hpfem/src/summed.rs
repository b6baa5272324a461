//! Load cases on a body that is factorised already: what they sum up to over the cells, and what that is on the kept boundary.

use crate::body::Body;
use crate::elimination::Forward;
use faer::Mat;

/// Sums over the cells that load cases act on, a column each.
pub(crate) struct Summed {
    /// Loads on the unknowns of each group; empty for zero.
    pub(crate) values: Vec<Mat<f64>>,
    /// Constant parts of the reactions, `reactions x these cases`.
    pub(crate) constant: Mat<f64>,
    /// Work on the interior that each load case displaces, `cases x these`.
    pub(crate) inner: Mat<f64>,
}

impl Body {
    /// Eliminates so many loads on the unknowns of each group: what they leave on the fronts, and on the kept unknowns a column each.
    pub(crate) fn eliminated(&self, mut values: Vec<Mat<f64>>, many: usize) -> (Forward, Mat<f64>) {
        let (factored, first) = (&self.factored, self.interface.columns.ncols() - self.added.len());
        let mut size = factored.space.size.clone();
        size.push(first);
        values.push(Mat::new());
        let forward = factored.condensed.forward(&mut values, &size, [first, many]);
        let mut columns = Mat::zeros(factored.kept.unknowns, many);
        for g in factored.kept.groups.iter().filter(|g| values[**g].ncols() > 0) {
            let start = factored.kept.start[*g].unwrap_or(0);
            columns.as_mut().subrows_mut(start, factored.space.size[*g]).copy_from(&values[*g]);
        }
        (forward, columns)
    }
}
