//! Elimination of all unknowns but the kept ones, front by front.
//!
//! A *group* is the set of unknowns of one vertex, one edge or one rigid frame; an *element* is a symmetric matrix on a few groups. At
//! first the elements are the cells with their interior already condensed. Eliminating a group merges all elements that
//! contain it into one dense front, factorises the part that nobody else contains (Cholesky) and leaves the Schur complement as a new
//! element (the multifrontal method, Duff and Reid 1983, on the quotient graph of p-version groups). What is left at the end lives on the
//! kept groups: their Schur complement `S = K_cc - K_ci K_ii^-1 K_ic` falls out by itself, and a body that floats freely
//! needs no special care as long as the kept groups hold it.

use crate::error::Error;
use crate::plan::Plan;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{BlockStructure, matmul as triangular_matmul};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, MatMut, MatRef, Par, Spec};

/// A symmetric matrix (lower triangle, columns one after the other) and right-hand sides on the unknowns of `groups`, in that order.
pub(crate) struct Element {
    pub(crate) groups: Vec<usize>,
    pub(crate) matrix: Vec<f64>,
    pub(crate) rhs: Mat<f64>,
}

/// One factorised front: `[L11; L21]` and the reduced right-hand sides `y = L11^-1 f`.
struct Front {
    groups: Vec<usize>,
    eliminated: usize,
    panel: Vec<f64>,
    reduced: Mat<f64>,
}

/// The factorised interior and the condensed kept part.
pub(crate) struct Condensed {
    fronts: Vec<Front>,
    /// Schur complement on the kept unknowns, both triangles filled.
    pub(crate) stiffness: Mat<f64>,
    /// Condensed right-hand sides.
    pub(crate) rhs: Mat<f64>,
    /// `f_i^T K_ii^-1 f_j` of the eliminated parts of the right-hand sides.
    pub(crate) work: Mat<f64>,
}

impl Plan {
    /// Runs the elimination on elements whose groups are sorted by [`Plan::rank`].
    ///
    /// # Errors
    /// The group whose pivot lost all stiffness.
    pub(crate) fn run(&self, elements: Vec<Element>, size: &[usize], kept: &[usize], columns: usize) -> Result<Condensed, usize> {
        let mut elements: Vec<Option<Element>> = elements.into_iter().map(Some).collect();
        let mut offset = vec![0; size.len()];
        let mut fronts = Vec::with_capacity(self.fronts.len());
        let mut work = Mat::zeros(columns, columns);
        for plan in &self.fronts {
            let n = place(&plan.groups, size, &mut offset);
            let ne = plan.groups[..plan.eliminated].iter().map(|g| size[*g]).sum();
            let mut front = Front {
                groups: plan.groups.clone(),
                eliminated: plan.eliminated,
                panel: vec![0.0; n * ne],
                reduced: Mat::zeros(ne, columns),
            };
            let mut rest = vec![0.0; (n - ne) * (n - ne)];
            let mut rhs = Mat::zeros(n, columns);
            for child in &plan.children {
                if let Some(element) = elements[*child].take() {
                    add(&element, size, &offset, n, &mut front.panel, &mut rest, &mut rhs);
                }
            }
            let mut panel = MatMut::from_column_major_slice_mut(&mut front.panel, n, ne);
            let trailing = MatMut::from_column_major_slice_mut(&mut rest, n - ne, n - ne);
            factor_panel(panel.as_mut()).map_err(|index| owner(&plan.groups, size, index))?;
            let (l11, l21) = panel.as_ref().split_at_row(ne);
            subtract_square(l21, trailing);
            let (mut f1, mut f2) = rhs.as_mut().split_at_row_mut(ne);
            solve_lower_triangular_in_place(l11, f1.as_mut(), Par::Seq);
            matmul(f2.as_mut(), Accum::Add, l21, f1.as_ref(), -1.0, Par::Seq);
            matmul(work.as_mut(), Accum::Add, f1.as_ref().transpose(), f1.as_ref(), 1.0, Par::Seq);
            front.reduced.copy_from(f1);
            let groups = plan.groups[plan.eliminated..].to_vec();
            elements.push(Some(Element { groups, matrix: rest, rhs: f2.to_owned() }));
            fronts.push(front);
        }
        let n = place(kept, size, &mut offset);
        let mut square = vec![0.0; n * n];
        let mut rhs = Mat::zeros(n, columns);
        for root in &self.roots {
            if let Some(element) = elements[*root].take() {
                add(&element, size, &offset, n, &mut [], &mut square, &mut rhs);
            }
        }
        let mut stiffness = MatRef::from_column_major_slice(&square, n, n).to_owned();
        for j in 0..n {
            for i in 0..j {
                stiffness[(i, j)] = stiffness[(j, i)];
            }
        }
        Ok(Condensed { fronts, stiffness, rhs, work })
    }
}

impl Condensed {
    /// Recovers the eliminated unknowns: `values` holds one vector a group, those of the kept groups filled in; the right-hand
    /// side is the combination of columns with the given `factors`.
    pub(crate) fn back_substitute(&self, values: &mut [Vec<f64>], size: &[usize], factors: &[f64]) {
        for front in self.fronts.iter().rev() {
            let (gone, left) = front.groups.split_at(front.eliminated);
            let known: Vec<f64> = left.iter().flat_map(|g| values[*g].iter().copied()).collect();
            let ne = front.reduced.nrows();
            let mut x = Mat::from_fn(ne, 1, |i, _| {
                factors.iter().enumerate().map(|(c, factor)| factor * front.reduced[(i, c)]).sum::<f64>()
            });
            let known = Mat::from_fn(known.len(), 1, |i, _| known[i]);
            let panel = MatRef::from_column_major_slice(&front.panel, ne + known.nrows(), ne);
            let (l11, l21) = panel.split_at_row(ne);
            matmul(x.as_mut(), Accum::Add, l21.transpose(), known.as_ref(), -1.0, Par::Seq);
            solve_upper_triangular_in_place(l11.transpose(), x.as_mut(), Par::Seq);
            let mut at = 0;
            for g in gone {
                values[*g] = (at..at + size[*g]).map(|i| x[(i, 0)]).collect();
                at += size[*g];
            }
        }
    }
}

/// Factorises the leading `ne` unknowns in place: on return the first columns hold `[L11; L21]`, the trailing lower triangle the
/// Schur complement.
///
/// # Errors
/// The index of the pivot that is not positive beyond round-off.
pub(crate) fn factor_leading(matrix: MatMut<'_, f64>, ne: usize) -> Result<(), usize> {
    let (mut panel, trailing) = matrix.split_at_col_mut(ne);
    factor_panel(panel.as_mut())?;
    let l21 = panel.as_ref().get(ne.., ..);
    subtract_square(l21, trailing.split_at_row_mut(ne).1);
    Ok(())
}

/// Widths of a panel up to this are factorised in narrow blocks; the plain Cholesky of faer is slow for small matrices.
const NARROW_PANEL: usize = 160;
/// Width of the blocks.
const BLOCK: usize = 16;

/// Cholesky factorisation of the leading columns `[A11; A21]` of a symmetric matrix, in place: `[L11; L21]`.
///
/// # Errors
/// The index of the pivot that is not positive beyond round-off.
fn factor_panel(mut panel: MatMut<'_, f64>) -> Result<(), usize> {
    let (n, ne) = (panel.nrows(), panel.ncols());
    if ne == 0 {
        return Ok(());
    }
    let diagonal: Vec<f64> = (0..ne).map(|i| panel[(i, i)]).collect();
    let block = if ne <= NARROW_PANEL { BLOCK } else { ne };
    let mut buffer = MemBuffer::new(cholesky_in_place_scratch::<f64>(block, Par::Seq, Spec::default()));
    for start in (0..ne).step_by(block) {
        let width = block.min(ne - start);
        let (done, rest) = panel.as_mut().split_at_col_mut(start);
        let mut columns = rest.subcols_mut(0, width).subrows_mut(start, n - start);
        if start > 0 {
            let left = done.as_ref().subrows(start, n - start);
            matmul(columns.as_mut(), Accum::Add, left, left.subrows(0, width).transpose(), -1.0, Par::Seq);
        }
        let (mut top, below) = columns.split_at_row_mut(width);
        cholesky_in_place(top.as_mut(), Default::default(), Par::Seq, MemStack::new(&mut buffer), Spec::default())
            .map_err(|LltError::NonPositivePivot { index }| start + index)?;
        solve_lower_triangular_in_place(top.as_ref(), below.transpose_mut(), Par::Seq);
    }
    // A pivot that is round-off of the diagonal it came from means a motion that nothing holds.
    let lost = (0..ne).find(|i| panel[(*i, *i)].powi(2) <= 1e-13 * diagonal[*i]);
    lost.map_or(Ok(()), Err)
}

/// `A22 - L21 L21^T`, lower triangle.
fn subtract_square(l21: MatRef<'_, f64>, a22: MatMut<'_, f64>) {
    triangular_matmul(
        a22,
        BlockStructure::TriangularLower,
        Accum::Add,
        l21,
        BlockStructure::Rectangular,
        l21.transpose(),
        BlockStructure::Rectangular,
        -1.0,
        Par::Seq,
    );
}

/// Sets the offsets of the groups in a front and returns its size.
fn place(groups: &[usize], size: &[usize], offset: &mut [usize]) -> usize {
    let mut n = 0;
    for g in groups {
        offset[*g] = n;
        n += size[*g];
    }
    n
}

/// Adds an element into a front of `n` unknowns whose leading columns are `panel` and whose trailing square is `rest`. Both sort their
/// groups by rank, so lower stays lower and rows come in runs.
fn add(element: &Element, size: &[usize], offset: &[usize], n: usize, panel: &mut [f64], rest: &mut [f64], rhs: &mut Mat<f64>) {
    let ne = panel.len().checked_div(n).unwrap_or(0);
    // Runs of rows: first row in the element, first row in the front, length. Groups that follow each other in both make one run.
    let mut runs: Vec<(usize, usize, usize)> = Vec::with_capacity(element.groups.len());
    let mut rows = 0;
    for g in &element.groups {
        match runs.last_mut() {
            Some((_, to, length)) if *to + *length == offset[*g] => *length += size[*g],
            _ => runs.push((rows, offset[*g], size[*g])),
        }
        rows += size[*g];
    }
    for (number, (from, to, length)) in runs.iter().enumerate() {
        for c in 0..*length {
            let column = &element.matrix[(from + c) * rows..(from + c + 1) * rows];
            let target = to + c;
            let (out, shift) = match target.checked_sub(ne) {
                None => (&mut panel[target * n..(target + 1) * n], 0),
                Some(k) => (&mut rest[k * (n - ne)..(k + 1) * (n - ne)], ne),
            };
            let mut add = |from: usize, to: usize, length: usize| {
                let target = &mut out[to - shift..to - shift + length];
                target.iter_mut().zip(&column[from..from + length]).for_each(|(o, s)| *o += s);
            };
            add(from + c, target, length - c);
            runs[number + 1..].iter().for_each(|(from, to, length)| add(*from, *to, *length));
        }
    }
    let mut row = 0;
    for g in &element.groups {
        for c in 0..rhs.ncols() {
            for i in 0..size[*g] {
                rhs[(offset[*g] + i, c)] += element.rhs[(row + i, c)];
            }
        }
        row += size[*g];
    }
}

/// The group that owns unknown `index` of a front.
fn owner(groups: &[usize], size: &[usize], index: usize) -> usize {
    let mut n = 0;
    for g in groups {
        n += size[*g];
        if index < n {
            return *g;
        }
    }
    groups.last().copied().unwrap_or(0)
}

/// Turns a lost pivot into a sentence about the place.
pub(crate) fn not_held(place: String) -> Error {
    Error::NotHeld { place }
}
