//! How the interiors of cells without loads inside follow from their boundaries, kept for all that asks for them again.
//!
//! The unknowns inside are `u_i = E u_b` with `E = -K_ii^-1 K_ib`; with the factor `[L_11; L_21]` that is `-L_11^-T L_21^T`. It takes less memory than the
//! factor does.

use crate::congruence::Congruence;
use faer::linalg::triangular_solve::solve_upper_triangular_in_place;
use faer::{Mat, MatRef, Par};

/// Those of the first cell of each class of similar cells.
pub(crate) struct Interiors {
    /// Of each cell that is the first of its class.
    cells: Vec<Option<Interior>>,
}

/// That of a cell.
struct Interior {
    /// Degrees of its edges.
    edges: [usize; 4],
    /// `E`, `interior x boundary` unsigned modes, one component after the other.
    from_boundary: Mat<f64>,
}

impl Interiors {
    /// Those of the classes, one each.
    pub(crate) fn new(congruence: &Congruence, of_classes: Vec<Mat<f64>>) -> Interiors {
        let mut cells: Vec<Option<Interior>> = congruence.class.iter().map(|_| None).collect();
        for (class, from_boundary) in congruence.classes.iter().zip(of_classes) {
            cells[class.first] = Some(Interior { edges: class.edges, from_boundary });
        }
        Interiors { cells }
    }

    /// That of a cell with edges of these degrees, where it is known.
    pub(crate) fn of(&self, cell: usize, edges: [usize; 4]) -> Option<&Mat<f64>> {
        self.cells[cell].as_ref().filter(|interior| interior.edges == edges).map(|interior| &interior.from_boundary)
    }
}

/// `E` of a cell, from its stiffness with the first `ni` columns factorised.
pub(crate) fn from_boundary(k: MatRef<'_, f64>, ni: usize) -> Mat<f64> {
    let (l11, l21) = k.subcols(0, ni).split_at_row(ni);
    let mut inside = Mat::from_fn(ni, l21.nrows(), |i, j| -l21[(j, i)]);
    solve_upper_triangular_in_place(l11.transpose(), inside.as_mut(), Par::Seq);
    inside
}
