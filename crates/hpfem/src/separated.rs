//! Values on a tensor grid as sums of few products, `C = sum_k u_k v_k^T` to round-off: those of straight cells are one product, whose sums over the grid are
//! products of sums along its directions.

use faer::MatRef;

/// Part of the largest value that counts as round-off.
const ROUND_OFF: f64 = 16.0 * f64::EPSILON;

/// Factors of several grids, their memory kept.
#[derive(Default)]
pub(crate) struct Separated {
    rows: usize,
    /// Of each grid, its number of products.
    ranks: Vec<usize>,
    /// `u_k` and `v_k` of all grids.
    factors: [Vec<f64>; 2],
    rest: Vec<f64>,
}

impl Separated {
    /// Forgets all grids.
    pub(crate) fn clear(&mut self) {
        self.ranks.clear();
        self.factors.iter_mut().for_each(Vec::clear);
    }

    /// Adds a square grid of as many points a direction as those before, so that all have `most` products at most; says whether they do, which those that are
    /// not finite never do. By elimination with complete pivoting.
    pub(crate) fn add(&mut self, grid: MatRef<'_, f64>, most: usize) -> bool {
        let n = grid.nrows();
        self.rows = n;
        self.rest.clear();
        grid.col_iter().for_each(|column| self.rest.extend(column.iter()));
        if !self.rest.iter().all(|value| value.is_finite()) {
            return false;
        }
        let before: usize = self.ranks.iter().sum();
        let mut enough = 0.0;
        for rank in 0.. {
            let (at, largest) = largest(&self.rest);
            if rank == 0 {
                enough = ROUND_OFF * largest;
            }
            if largest <= enough {
                self.ranks.push(rank);
                return true;
            }
            if before + rank == most {
                return false;
            }
            let [along_eta, along_xi] = &mut self.factors;
            let (row, column, start) = (at % n, at / n, along_eta.len());
            let pivot = self.rest[at];
            along_eta.extend_from_slice(&self.rest[column * n..(column + 1) * n]);
            along_xi.extend(self.rest[row..].iter().step_by(n).map(|value| value / pivot));
            for (rest, v) in self.rest.chunks_exact_mut(n).zip(&along_xi[start..]) {
                rest.iter_mut().zip(&along_eta[start..]).for_each(|(rest, u)| *rest -= u * v);
            }
        }
        false
    }

    /// The factors of each grid, `points x products`.
    pub(crate) fn terms(&self) -> impl Iterator<Item = [MatRef<'_, f64>; 2]> {
        let mut start = 0;
        self.ranks.iter().map(move |rank| {
            let part = start..start + rank * self.rows;
            start = part.end;
            self.factors.each_ref().map(|all| MatRef::from_column_major_slice(&all[part.clone()], self.rows, *rank))
        })
    }
}

/// Place and magnitude of the largest value.
fn largest(values: &[f64]) -> (usize, f64) {
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    (values.iter().position(|value| value.abs() == largest).unwrap_or(0), largest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::Mat;

    fn products(grid: &Mat<f64>, most: usize) -> Option<(usize, f64)> {
        let mut separated = Separated::default();
        let found = separated.add(grid.as_ref(), most);
        let sum = separated.terms().fold(Mat::zeros(grid.nrows(), grid.ncols()), |sum, [u, v]| sum + u * v.transpose());
        found.then(|| (separated.ranks[0], (sum - grid).norm_max() / grid.norm_max()))
    }

    #[test]
    fn sums_of_products_are_found_with_as_many_and_others_are_not() {
        let x = |i: usize| 0.1 + i as f64 / 7.0;
        let one = Mat::from_fn(9, 9, |i, j| x(i).exp() / x(j));
        let two = Mat::from_fn(9, 9, |i, j| x(i).exp() / x(j) + x(j).sin() * x(i).powi(3));
        let many = Mat::from_fn(9, 9, |i, j| 1.0 / (x(i) + x(j)));
        for (grid, rank) in [(&one, 1), (&two, 2)] {
            let (found, error) = products(grid, 4).unwrap_or_default();
            assert!(found == rank && error < 1e-14, "{found} {error:.1e}");
        }
        assert_eq!(products(&Mat::zeros(9, 9), 4).map(|(rank, _)| rank), Some(0));
        assert_eq!(products(&many, 4), None);
        assert_eq!(products(&Mat::full(9, 9, f64::NAN), 4), None);
    }
}
