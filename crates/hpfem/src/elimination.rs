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
use crate::front::{FrontPlan, Plan};
use crate::front_matrix::{Front, FrontMap};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, MatRef, Par};

/// Rows and columns of a tile when a matrix is mirrored.
const TILE: usize = 32;

/// The factorised interior and the condensed kept part.
pub(crate) struct Condensed {
    plan: Plan,
    /// `[L11; L21]` of every front, columns one after the other; empty if they were not to be kept.
    panels: Vec<Vec<f64>>,
    /// Schur complement on the kept unknowns, both triangles filled, in the unit asked for; empty once it is taken.
    pub(crate) stiffness: Mat<f64>,
    /// Condensed right-hand sides.
    pub(crate) rhs: Mat<f64>,
    /// `f_i^T K_ii^-1 f_j` of the eliminated parts of the right-hand sides.
    pub(crate) work: Mat<f64>,
}

impl Plan {
    /// Runs the elimination on elements whose groups are sorted by [`Plan::rank`]. The last of the `kept` groups is that of the right-hand
    /// sides; `factors` tells whether the fronts are kept for [`Condensed::back_substitute`]. The stiffness comes times `unit`.
    ///
    /// # Errors
    /// The group whose pivot lost all stiffness.
    pub(crate) fn run(
        self,
        elements: &mut Elements<'_>,
        size: &[usize],
        kept: &[usize],
        (factors, unit): (bool, f64),
    ) -> Result<Condensed, usize> {
        let cells = elements.groups.len();
        let unknowns = |groups: &[usize]| groups.iter().map(|g| size[*g]).sum::<usize>();
        let panel_size = |plan: &FrontPlan| unknowns(&plan.groups) * unknowns(&plan.groups[..plan.eliminated]);
        let mut panel = vec![0.0; self.fronts.iter().map(panel_size).max().unwrap_or(0)];
        let mut panels = Vec::new();
        let places = self.places(size, cells);
        let mut merged = vec![0.0; places.length];
        let mut map = FrontMap::new(size);
        let mut buffer = Vec::new();
        for (number, plan) in self.fronts.iter().enumerate() {
            let panel = &mut panel[..panel_size(plan)];
            let [before, own, after] = places.split(number, &mut merged);
            let mut front = Front::open(&mut map, plan, panel, own);
            for child in &plan.children {
                if let Some(child) = child.checked_sub(cells) {
                    front.add(places.child(child, number, [before, after]), self.fronts[child].left());
                } else {
                    front.add(elements.matrix(*child, &mut buffer), &elements.groups[*child]);
                    elements.release(*child);
                }
            }
            front.factor().map_err(|index| owner(&plan.groups, size, index))?;
            if factors {
                panels.push(panel.to_vec());
            }
        }
        let n = unknowns(kept);
        let root = FrontPlan { children: Vec::new(), groups: kept.to_vec(), eliminated: 0 };
        let mut square = vec![0.0; n * n];
        let mut front = Front::open(&mut map, &root, &mut [], &mut square);
        for element in &self.roots {
            match element.checked_sub(cells) {
                Some(child) => front.add(&merged[places.parts[child].clone()], self.fronts[child].left()),
                None => front.add(elements.matrix(*element, &mut buffer), &elements.groups[*element]),
            }
        }
        front.complete();
        drop(merged);
        let own = n - kept.last().map_or(0, |g| size[*g]);
        let (columns, at) = (n - own, |i: usize, j: usize| square[i.min(j) * n + i.max(j)]);
        Ok(Condensed {
            panels,
            stiffness: mirrored(&square, [n, own], unit),
            rhs: Mat::from_fn(own, columns, |i, j| at(i, own + j)),
            work: Mat::from_fn(columns, columns, |i, j| -at(own + i, own + j)),
            plan: self,
        })
    }
}

/// The leading `own` rows and columns of a symmetric matrix with `n` of them, of which the lower triangle counts, times a number.
fn mirrored(lower: &[f64], [n, own]: [usize; 2], unit: f64) -> Mat<f64> {
    let mut whole = Mat::zeros(own, own);
    for j in 0..own {
        let from = &lower[j * n + j..j * n + own];
        whole.col_as_slice_mut(j)[j..].iter_mut().zip(from).for_each(|(to, from)| *to = unit * from);
    }
    // Tile by tile: rows of the one are columns of the other.
    for rows in (0..own).step_by(TILE) {
        for columns in (rows..own).step_by(TILE) {
            for j in columns..own.min(columns + TILE) {
                let to = &mut whole.col_as_slice_mut(j)[rows..j.min(rows + TILE)];
                to.iter_mut().enumerate().for_each(|(i, to)| *to = unit * lower[(rows + i) * n + j]);
            }
        }
    }
    whole
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
    /// Each right-hand side by itself.
    pub(crate) fn columns(self) -> Vec<Forward> {
        if self.work.ncols() == 1 {
            return vec![self];
        }
        let column = |m: &Mat<f64>, k: usize| if m.ncols() > 0 { m.subcols(k, 1).to_owned() } else { Mat::new() };
        let of =
            |k: usize| Forward { parts: self.parts.iter().map(|part| column(part, k)).collect(), work: column(&self.work, k) };
        (0..self.work.ncols()).map(of).collect()
    }

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
        let mut forward = Forward { parts: Vec::with_capacity(self.plan.fronts.len()), work: Mat::zeros(columns, many) };
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
