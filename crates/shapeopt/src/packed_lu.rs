//! `P A = L U` in the memory of `A` itself: what steps in time factorise again and again, both factors in one matrix.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::factor::{lu_in_place, lu_in_place_scratch};
use faer::linalg::lu::partial_pivoting::solve::{solve_in_place, solve_in_place_scratch};
use faer::perm::PermRef;
use faer::{Mat, MatMut, get_global_parallelism};

/// A square matrix, factorised with row pivots.
pub(crate) struct PackedLu {
    /// `U`, and below its diagonal `L`, whose own is 1.
    factors: Mat<f64>,
    /// The rows in their new order, and the place of each row in it.
    rows: Vec<usize>,
    places: Vec<usize>,
}

impl PackedLu {
    pub(crate) fn new(mut matrix: Mat<f64>) -> PackedLu {
        let (n, par) = (matrix.nrows(), get_global_parallelism());
        let (mut rows, mut places) = (vec![0; n], vec![0; n]);
        let mut memory = MemBuffer::new(lu_in_place_scratch::<usize, f64>(n, n, par, Default::default()));
        let stack = MemStack::new(&mut memory);
        lu_in_place(matrix.as_mut(), &mut rows, &mut places, par, stack, Default::default());
        PackedLu { factors: matrix, rows, places }
    }

    /// Rows of the matrix.
    pub(crate) fn size(&self) -> usize {
        self.rows.len()
    }

    /// The solution with a right-hand side, in its place.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        let (n, par) = (self.size(), get_global_parallelism());
        let mut memory = MemBuffer::new(solve_in_place_scratch::<usize, f64>(n, 1, par));
        let stack = MemStack::new(&mut memory);
        let (order, right) =
            (PermRef::new_checked(&self.rows, &self.places, n), MatMut::from_column_major_slice_mut(right, n, 1));
        solve_in_place(self.factors.as_ref(), self.factors.as_ref(), order, right, par, stack);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_is_that_of_the_matrix_though_its_pivots_stand_anywhere() {
        for n in [1, 2, 7, 60] {
            let entry = |i: usize, j: usize| if i + j + 1 == n { 5.0 } else { ((3 * i + 7 * j * j + 1) as f64).sin() / n as f64 };
            let wanted: Vec<f64> = (0..n).map(|i| (i as f64 + 0.5).cos()).collect();
            let mut x: Vec<f64> = (0..n).map(|i| (0..n).map(|j| entry(i, j) * wanted[j]).sum()).collect();
            PackedLu::new(Mat::from_fn(n, n, entry)).solve(&mut x);
            assert!(x.iter().zip(&wanted).all(|(x, wanted)| (x - wanted).abs() < 1e-13), "{n}: {x:?}");
        }
    }
}
