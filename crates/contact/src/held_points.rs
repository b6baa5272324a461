//! The compliance at some of the contact points, and that of a few more of them.

use crate::matrices::Matrices;
use crate::products::rows_of;
use crate::response::Response;
use crate::rows::Rows;
use faer::Mat;
use std::sync::Arc;

/// Points, and the compliance at these alone.
pub(crate) struct HeldPoints {
    pub(crate) at: Vec<usize>,
    pub(crate) matrices: Arc<Matrices>,
}

impl HeldPoints {
    /// The same points and some more, which stand after them: unit forces at these alone are solved for. `influence` is the opening, and where shear was
    /// asked for the slip, by the coordinates at all points.
    pub(crate) fn and(&self, more: &[usize], responses: &[Response], influence: (&Mat<f64>, Option<&Mat<f64>>)) -> HeldPoints {
        let at = [&self.at[..], more].concat();
        let known = &*self.matrices;
        let mut normal = grown(&known.normal, more.len());
        let mut normal_by_shear = known.normal_by_shear.as_ref().map(|known| grown(known, more.len()));
        let mut tangential = known.tangential.as_ref().map(|known| grown(known, more.len()));
        for r in responses {
            let pick = |all: &Rows| (all.at(&at), all.at(more));
            let (rows, new) = pick(&r.normal);
            let under = r.under(&new, &at);
            add_symmetric(&mut normal, &rows.product(&under));
            let Some((slides, sliding)) = r.tangential.as_ref().map(pick) else { continue };
            let under_shear = r.under(&sliding, &at);
            if let Some(sum) = &mut normal_by_shear {
                // What shear opens, and what normal forces slide: work is reciprocal (Betti).
                add_crossed(sum, &rows.product(&under_shear), &slides.product(&under));
            }
            if let Some(sum) = &mut tangential {
                add_symmetric(sum, &slides.product(&under_shear));
            }
        }
        let shear_influence = influence.1.map(|all| rows_of(all, &at));
        let influence = rows_of(influence.0, &at);
        let matrices = Matrices { normal, normal_by_shear, tangential, influence, shear_influence };
        HeldPoints { at, matrices: Arc::new(matrices) }
    }
}

/// A matrix with so many more rows and columns, of zeros.
fn grown(known: &Mat<f64>, more: usize) -> Mat<f64> {
    let mut matrix = Mat::zeros(known.nrows() + more, known.ncols() + more);
    matrix.as_mut().submatrix_mut(0, 0, known.nrows(), known.ncols()).copy_from(known);
    matrix
}

/// Adds the last columns of a symmetric matrix, and its last rows.
fn add_symmetric(sum: &mut Mat<f64>, columns: &Mat<f64>) {
    let old = sum.ncols() - columns.ncols();
    for j in 0..columns.ncols() {
        for i in 0..old {
            sum[(i, old + j)] += columns[(i, j)];
            sum[(old + j, i)] += columns[(i, j)];
        }
        for i in 0..columns.ncols() {
            sum[(old + i, old + j)] += 0.5 * (columns[(old + i, j)] + columns[(old + j, i)]);
        }
    }
}

/// Adds the last columns of a matrix, and the columns of its transpose that make its last rows.
fn add_crossed(sum: &mut Mat<f64>, columns: &Mat<f64>, rows: &Mat<f64>) {
    let old = sum.ncols() - columns.ncols();
    for j in 0..columns.ncols() {
        for i in 0..old {
            sum[(i, old + j)] += columns[(i, j)];
        }
        for i in 0..old + columns.ncols() {
            sum[(old + j, i)] += rows[(i, j)];
        }
    }
}
