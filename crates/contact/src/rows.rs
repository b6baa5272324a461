//! Displacements at contact points as linear functions of kept unknowns, a few for each point.

use faer::Mat;

/// Rows that are multiplied at once by [`Rows::product`].
const BLOCK: usize = 16;

/// A matrix whose rows have few entries, and neighbours theirs in nearly the same columns.
#[derive(Clone, Debug)]
pub(crate) struct Rows {
    /// Column and value, by ascending column.
    entries: Vec<Vec<(usize, f64)>>,
    columns: usize,
}

impl Rows {
    /// Of rows by column, zeros left out.
    pub(crate) fn new(rows: Vec<std::collections::BTreeMap<usize, f64>>, columns: usize) -> Rows {
        let entries = rows.into_iter().map(|row| row.into_iter().filter(|(_, v)| *v != 0.0).collect()).collect();
        Rows { entries, columns }
    }

    /// Column and value of the entries of some of the rows.
    pub(crate) fn entries(&self, at: &[usize]) -> Vec<&[(usize, f64)]> {
        at.iter().map(|i| &self.entries[*i][..]).collect()
    }

    /// Some of the rows.
    pub(crate) fn at(&self, at: &[usize]) -> Rows {
        Rows { entries: at.iter().map(|i| self.entries[*i].clone()).collect(), columns: self.columns }
    }

    /// The first of some of the rows that has an entry in each column, if any has.
    pub(crate) fn reach(&self, some: &[bool]) -> Vec<Option<usize>> {
        let mut reached = vec![None; self.columns];
        for (i, row) in self.entries.iter().enumerate().filter(|(i, _)| some[*i]) {
            row.iter().for_each(|(k, _)| reached[*k] = reached[*k].or(Some(i)));
        }
        reached
    }

    /// The rows as columns of a full matrix.
    pub(crate) fn transposed(&self) -> Mat<f64> {
        let mut matrix = Mat::zeros(self.columns, self.entries.len());
        for (i, row) in self.entries.iter().enumerate() {
            let column = matrix.col_as_slice_mut(i);
            row.iter().for_each(|(k, v)| column[*k] = *v);
        }
        matrix
    }

    /// Times a vector.
    pub(crate) fn times(&self, x: &[f64]) -> Vec<f64> {
        self.entries.iter().map(|row| row.iter().map(|(k, v)| v * x[*k]).sum()).collect()
    }

    /// The transposed matrix times a vector.
    pub(crate) fn transposed_times(&self, y: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.columns];
        for (row, y) in self.entries.iter().zip(y).filter(|(_, y)| **y != 0.0) {
            row.iter().for_each(|(k, v)| x[*k] += v * y);
        }
        x
    }

    /// Times a full matrix.
    pub(crate) fn product(&self, b: &Mat<f64>) -> Mat<f64> {
        let mut product = Mat::zeros(self.entries.len(), b.ncols());
        for (number, block) in self.entries.chunks(BLOCK).enumerate() {
            let mut columns: Vec<usize> = block.iter().flatten().map(|(k, _)| *k).collect();
            columns.sort_unstable();
            columns.dedup();
            let mut few = Mat::zeros(block.len(), columns.len());
            for (i, row) in block.iter().enumerate() {
                row.iter().for_each(|(k, v)| few[(i, columns.partition_point(|column| column < k))] = *v);
            }
            let mut rows = Mat::zeros(columns.len(), b.ncols());
            for j in 0..b.ncols() {
                let from = b.col_as_slice(j);
                rows.col_as_slice_mut(j).iter_mut().zip(&columns).for_each(|(to, k)| *to = from[*k]);
            }
            product.as_mut().subrows_mut(number * BLOCK, block.len()).copy_from(few * rows);
        }
        product
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_of_few_entries_are_those_of_the_full_matrix() {
        // Bands of five entries that move on with the rows, more rows than one block has, and a row of zeros.
        let band = |i: usize, j: usize| if i != 20 && (2 * i..2 * i + 5).contains(&j) { 1.0 + (i * j) as f64 } else { 0.0 };
        let (a, b) = (Mat::from_fn(37, 80, band), Mat::from_fn(80, 9, |i, j| (i as f64 * 0.37 + j as f64).sin()));
        let rows = Rows::new((0..37).map(|i| (0..80).map(|j| (j, a[(i, j)])).collect()).collect(), 80);
        let size = (&a * &b).norm_max();
        assert!((rows.product(&b) - &a * &b).norm_max() < 1e-15 * size);
        assert_eq!(rows.transposed(), a.transpose().to_owned());
        let column = |m: &Mat<f64>| m.col_as_slice(0).to_vec();
        let x = column(&b);
        let off =
            |got: Vec<f64>, exact: Mat<f64>| got.iter().zip(column(&exact)).fold(0.0_f64, |most, (g, e)| most.max((g - e).abs()));
        assert!(off(rows.times(&x), &a * b.subcols(0, 1)) < 1e-15 * size);
        assert!(off(rows.transposed_times(&x[..37]), a.transpose() * b.submatrix(0, 0, 37, 1)) < 1e-15 * size);
        assert_eq!(rows.at(&[3, 5]).times(&x), [rows.times(&x)[3], rows.times(&x)[5]]);
        let reached = rows.reach(&(0..37).map(|i| i < 2).collect::<Vec<bool>>());
        assert_eq!(reached.iter().flatten().filter(|first| **first == 0).count(), 5);
        assert_eq!(reached.iter().flatten().filter(|first| **first == 1).count(), 2);
    }
}
