//! Elimination of all unknowns but the kept ones, front by front.
//!
//! A *group* is the set of unknowns of one vertex, one edge or one rigid frame; an *element* is a symmetric matrix on a few groups. At
//! first the elements are the cells with their interior already condensed. Eliminating a group merges all elements that
//! contain it into one dense front, factorises the part that nobody else contains (Cholesky) and leaves the Schur complement as a new
//! element (the multifrontal method, Duff and Reid 1983, on the quotient graph of p-version groups). What is left at the end lives on the
//! kept groups: their Schur complement `S = K_cc - K_ci K_ii^-1 K_ic` falls out by itself, and a body that floats freely
//! needs no special care as long as the kept groups hold it.
//!
//! Right-hand sides are one more kept group: in `[K F; F^T 0]` eliminating the interior leaves `S`, the condensed right-hand sides
//! `F_c - K_ci K_ii^-1 F_i`, and in the corner `-F_i^T K_ii^-1 F_i`. Elements without loads do not have the group.

use crate::cell_matrix::Elements;
use crate::dense::{factor_panel, subtract_square};
use crate::front::{FrontPlan, Plan};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, MatMut, MatRef, Par};

/// Number of buffers of merged elements kept for the next ones, and their largest length: a store that only grows costs more than it saves.
const SPARE: usize = 4;
const SPARE_LENGTH: usize = 1 << 17;

/// The factorised interior and the condensed kept part.
pub(crate) struct Condensed {
    plan: Plan,
    /// `[L11; L21]` of every front, columns one after the other; empty if they were not to be kept.
    panels: Vec<Vec<f64>>,
    /// Schur complement on the kept unknowns, both triangles filled.
    pub(crate) stiffness: Mat<f64>,
    /// Condensed right-hand sides.
    pub(crate) rhs: Mat<f64>,
    /// `f_i^T K_ii^-1 f_j` of the eliminated parts of the right-hand sides.
    pub(crate) work: Mat<f64>,
}

impl Plan {
    /// Runs the elimination on elements whose groups are sorted by [`Plan::rank`]. The last of the `kept` groups is that of the right-hand
    /// sides; `factors` tells whether the fronts are kept for [`Condensed::back_substitute`].
    ///
    /// # Errors
    /// The group whose pivot lost all stiffness.
    pub(crate) fn run(
        self,
        elements: &mut Elements<'_>,
        size: &[usize],
        kept: &[usize],
        factors: bool,
    ) -> Result<Condensed, usize> {
        let cells = elements.groups.len();
        let unknowns = |groups: &[usize]| groups.iter().map(|g| size[*g]).sum::<usize>();
        let panel_size = |plan: &FrontPlan| unknowns(&plan.groups) * unknowns(&plan.groups[..plan.eliminated]);
        let (mut panels, mut panel) = (Vec::new(), Vec::new());
        if !factors {
            panel = vec![0.0; self.fronts.iter().map(panel_size).max().unwrap_or(0)];
        }
        let mut front = Front { size, offset: vec![0; size.len()], n: 0, panel, rest: Vec::new() };
        let mut merged: Vec<Vec<f64>> = Vec::with_capacity(self.fronts.len());
        let (mut spare, mut buffer) = (Vec::new(), Vec::new());
        for plan in &self.fronts {
            front.open(&plan.groups, plan.eliminated, &mut spare);
            for child in &plan.children {
                if let Some(child) = child.checked_sub(cells) {
                    let matrix = std::mem::take(&mut merged[child]);
                    front.add(&matrix, self.fronts[child].left());
                    if matrix.len() <= SPARE_LENGTH {
                        spare.push(matrix);
                    }
                } else {
                    front.add(elements.matrix(*child, &mut buffer), &elements.groups[*child]);
                    elements.release(*child);
                }
            }
            merged.push(front.factor().map_err(|index| owner(&plan.groups, size, index))?);
            if factors {
                panels.push(std::mem::take(&mut front.panel));
            }
        }
        front.open(kept, 0, &mut Vec::new());
        for root in &self.roots {
            match root.checked_sub(cells) {
                Some(child) => front.add(&merged[child], self.fronts[child].left()),
                None => front.add(elements.matrix(*root, &mut buffer), &elements.groups[*root]),
            }
        }
        let (n, square) = (front.n, front.rest);
        let own = n - kept.last().map_or(0, |g| size[*g]);
        let (columns, at) = (n - own, |i: usize, j: usize| square[i.min(j) * n + i.max(j)]);
        Ok(Condensed {
            panels,
            stiffness: Mat::from_fn(own, own, at),
            rhs: Mat::from_fn(own, columns, |i, j| at(i, own + j)),
            work: Mat::from_fn(columns, columns, |i, j| -at(own + i, own + j)),
            plan: self,
        })
    }
}

/// Right-hand sides eliminated after the factorisation.
#[derive(Clone)]
pub(crate) struct Forward {
    /// `y = L11^-1 f` of every front, a column a right-hand side; empty where the loads have not come.
    parts: Vec<Mat<f64>>,
    /// `y . y_k` with the right-hand sides of the factorisation, `those x these`.
    pub(crate) work: Mat<f64>,
}

impl Forward {
    /// `y . y` of the right-hand side number `k` with another one.
    pub(crate) fn dot(&self, k: usize, other: &Forward) -> f64 {
        let pairs = self.parts.iter().zip(&other.parts).filter(|(a, b)| a.ncols() > 0 && b.ncols() > 0);
        pairs.map(|(a, b)| a.col(k).iter().zip(b.col(0).iter()).map(|(a, b)| a * b).sum::<f64>()).sum()
    }
}

impl Condensed {
    /// Eliminates more right-hand sides, as many as `many`. `values` holds one matrix a group, a column a right-hand side, empty for zero; on return
    /// those of the kept groups are condensed. Only fronts on the way from the loads to the kept groups are visited.
    pub(crate) fn forward(&self, values: &mut [Mat<f64>], size: &[usize], [columns, many]: [usize; 2]) -> Forward {
        let mut forward = Forward { parts: Vec::with_capacity(self.panels.len()), work: Mat::zeros(columns, many) };
        for (front, panel) in self.plan.fronts.iter().zip(&self.panels) {
            let (gone, left) = front.groups.split_at(front.eliminated);
            if gone.iter().all(|g| values[*g].ncols() == 0) {
                forward.parts.push(Mat::new());
                continue;
            }
            let ne = gone.iter().map(|g| size[*g]).sum();
            let mut y = Mat::<f64>::zeros(ne, many);
            let mut at = 0;
            for g in gone {
                let value = std::mem::replace(&mut values[*g], Mat::new());
                if value.ncols() > 0 {
                    y.as_mut().subrows_mut(at, size[*g]).copy_from(&value);
                }
                at += size[*g];
            }
            let rest = left.iter().map(|g| size[*g]).sum::<usize>();
            let (l11, l21) = MatRef::from_column_major_slice(panel, ne + rest, ne).split_at_row(ne);
            solve_lower_triangular_in_place(l11, y.as_mut(), Par::Seq);
            let shed = l21 * y.as_ref();
            let mut at = 0;
            for g in left {
                let part = shed.as_ref().subrows(at, size[*g]);
                if *g + 1 == size.len() {
                    forward.work += part;
                } else {
                    if values[*g].ncols() == 0 {
                        values[*g] = Mat::zeros(size[*g], many);
                    }
                    values[*g] -= part;
                }
                at += size[*g];
            }
            forward.parts.push(y);
        }
        forward
    }

    /// Recovers the eliminated unknowns: `values` holds one matrix a group, a column a state, those of the kept groups filled in; that of the
    /// right-hand sides holds the factors they are combined with, negative. Right-hand sides eliminated later come with their factors in `added`.
    pub(crate) fn back_substitute(&self, values: &mut [Mat<f64>], size: &[usize], added: &[(Vec<f64>, &Forward)]) {
        let states = values.last().map_or(0, Mat::ncols);
        for (number, (front, panel)) in self.plan.fronts.iter().zip(&self.panels).enumerate().rev() {
            let (gone, left) = front.groups.split_at(front.eliminated);
            let mut known = Mat::<f64>::zeros(left.iter().map(|g| size[*g]).sum(), states);
            let mut at = 0;
            for g in left {
                known.as_mut().subrows_mut(at, size[*g]).copy_from(&values[*g]);
                at += size[*g];
            }
            let ne = gone.iter().map(|g| size[*g]).sum();
            let mut x = Mat::zeros(ne, states);
            let (l11, l21) = MatRef::from_column_major_slice(panel, ne + known.nrows(), ne).split_at_row(ne);
            matmul(x.as_mut(), Accum::Replace, l21.transpose(), known.as_ref(), -1.0, Par::Seq);
            for (factors, forward) in added.iter().filter(|(_, forward)| forward.parts[number].ncols() > 0) {
                for (j, factor) in factors.iter().enumerate() {
                    let part = forward.parts[number].col(0);
                    x.col_as_slice_mut(j).iter_mut().zip(part.iter()).for_each(|(x, y)| *x += factor * y);
                }
            }
            solve_upper_triangular_in_place(l11.transpose(), x.as_mut(), Par::Seq);
            let mut at = 0;
            for g in gone {
                values[*g] = x.as_ref().subrows(at, size[*g]).to_owned();
                at += size[*g];
            }
        }
    }
}

/// The front at work, a symmetric matrix of which the lower triangle counts.
struct Front<'s> {
    /// Number of unknowns of each group.
    size: &'s [usize],
    /// First unknown of each group of the front.
    offset: Vec<usize>,
    /// Number of unknowns.
    n: usize,
    /// The leading columns, those of the groups that disappear, one after the other.
    panel: Vec<f64>,
    /// The trailing square, columns one after the other.
    rest: Vec<f64>,
}

impl Front<'_> {
    /// An empty front on the groups, the first `eliminated` of which disappear.
    fn open(&mut self, groups: &[usize], eliminated: usize, spare: &mut Vec<Vec<f64>>) {
        self.n = 0;
        for g in groups {
            self.offset[*g] = self.n;
            self.n += self.size[*g];
        }
        let gone = groups[..eliminated].iter().map(|g| self.size[*g]).sum();
        clear(&mut self.panel, self.n, gone);
        self.rest = zeros(spare, self.n - gone);
    }

    /// Adds an element. Front and element sort their groups by rank, so lower stays lower and rows come in runs.
    fn add(&mut self, matrix: &[f64], groups: &[usize]) {
        let (size, offset, n) = (self.size, &self.offset[..], self.n);
        let (panel, rest) = (&mut self.panel[..], &mut self.rest[..]);
        let ne = panel.len().checked_div(n).unwrap_or(0);
        // Runs of rows: first row in the element, first row in the front, length. Groups that follow each other in both make one run.
        let mut runs: Vec<(usize, usize, usize)> = Vec::with_capacity(groups.len());
        let mut rows = 0;
        for g in groups {
            match runs.last_mut() {
                Some((_, to, length)) if *to + *length == offset[*g] => *length += size[*g],
                _ => runs.push((rows, offset[*g], size[*g])),
            }
            rows += size[*g];
        }
        for (number, (from, to, length)) in runs.iter().enumerate() {
            for c in 0..*length {
                let column = &matrix[(from + c) * rows..(from + c + 1) * rows];
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
    }

    /// Factorises the panel and returns the Schur complement of the rest.
    ///
    /// # Errors
    /// The unknown whose pivot lost all stiffness.
    fn factor(&mut self) -> Result<Vec<f64>, usize> {
        let n = self.n;
        factor_panel(&mut self.panel, n)?;
        let ne = self.panel.len().checked_div(n).unwrap_or(0);
        let l21 = MatRef::from_column_major_slice(&self.panel, n, ne).subrows(ne, n - ne);
        subtract_square(l21, MatMut::from_column_major_slice_mut(&mut self.rest, n - ne, n - ne));
        Ok(std::mem::take(&mut self.rest))
    }
}

/// A square whose lower triangle is zero, in the smallest spare buffer that is large enough or a new one.
fn zeros(spare: &mut Vec<Vec<f64>>, n: usize) -> Vec<f64> {
    spare.sort_by_key(|b| std::cmp::Reverse(b.capacity()));
    spare.truncate(SPARE);
    let fit = spare.iter().rposition(|b| b.capacity() >= n * n);
    let mut buffer = fit.map_or_else(Vec::new, |fit| spare.remove(fit));
    clear(&mut buffer, n, n);
    buffer
}

/// Makes a buffer `columns` columns of `rows` numbers that are zero from the diagonal on.
fn clear(buffer: &mut Vec<f64>, rows: usize, columns: usize) {
    if buffer.capacity() < rows * columns {
        *buffer = vec![0.0; rows * columns];
        return;
    }
    buffer.resize(rows * columns, 0.0);
    (0..columns).for_each(|j| buffer[j * rows + j..(j + 1) * rows].fill(0.0));
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
