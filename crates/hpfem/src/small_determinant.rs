//! Determinants of small complex matrices, many in a row, in one store.

use nalgebra::Complex;

type C = Complex<f64>;

/// A square matrix that is written and eliminated in the same place again and again.
#[derive(Debug, Default)]
pub(crate) struct SmallMatrix {
    /// Column by column.
    values: Vec<C>,
    size: usize,
}

impl SmallMatrix {
    /// Makes it zero, with so many rows and columns.
    pub(crate) fn clear(&mut self, size: usize) {
        self.size = size;
        self.values.clear();
        self.values.resize(size * size, C::new(0.0, 0.0));
    }

    /// The entry of a row and a column.
    pub(crate) fn at(&mut self, row: usize, column: usize) -> &mut C {
        &mut self.values[column * self.size + row]
    }

    /// Its determinant, by elimination with the largest pivot of each column; the entries are lost.
    pub(crate) fn determinant(&mut self) -> C {
        let size = self.size;
        let mut product = C::new(1.0, 0.0);
        for step in 0..size {
            let (done, right) = self.values.split_at_mut((step + 1) * size);
            let column = &mut done[step * size..];
            let larger = |a: usize, b: usize| if column[b].l1_norm() > column[a].l1_norm() { b } else { a };
            let pivot = (step..size).fold(step, larger);
            let diagonal = column[pivot];
            if diagonal == C::new(0.0, 0.0) {
                return diagonal;
            }
            if pivot != step {
                column.swap(pivot, step);
                right.chunks_exact_mut(size).for_each(|other| other.swap(pivot, step));
                product = -product;
            }
            product *= diagonal;
            let inverse = C::new(1.0, 0.0) / diagonal;
            column[step + 1..].iter_mut().for_each(|value| *value *= inverse);
            for other in right.chunks_exact_mut(size) {
                let factor = other[step];
                other[step + 1..].iter_mut().zip(&column[step + 1..]).for_each(|(value, share)| *value -= factor * share);
            }
        }
        product
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::{C, SmallMatrix};

    #[test]
    fn a_determinant_is_that_of_a_dense_factorisation() {
        let mut small = SmallMatrix::default();
        for size in [0, 1, 2, 4, 7, 12] {
            let entry = |i: usize, j: usize| C::new((3.0 * i as f64 + 1.7 * (j * j) as f64).sin(), (0.3 + (i * j) as f64).cos());
            small.clear(size);
            (0..size).for_each(|i| (0..size).for_each(|j| *small.at(i, j) = entry(i, j)));
            let dense = DMatrix::from_fn(size, size, entry).determinant();
            assert!((small.determinant() - dense).norm() <= 1e-13 * (1.0 + dense.norm()), "{size}");
        }
        small.clear(3);
        assert_eq!(small.determinant(), C::new(0.0, 0.0));
    }
}
