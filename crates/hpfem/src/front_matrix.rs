//! The front at work.
//!
//! What a front eliminates stands in its panel, the square of what it leaves in the place of its merged element. Neither is cleared before:
//! the first element that has a column writes it whole, the others are added.

use crate::dense::{factor_panel, subtract_product};
use crate::front::FrontPlan;
use faer::{MatMut, MatRef};
use pulp::{Arch, Simd, WithSimd};

/// Rows of an element and of a front that go together: first row in the element, first row in the front, number.
type Run = [usize; 3];

/// Where groups stand in a front; memory that lives from front to front.
pub(crate) struct FrontMap<'s> {
    /// Number of unknowns of each group.
    size: &'s [usize],
    /// First unknown of each group of the front.
    offset: Vec<usize>,
    runs: Vec<Run>,
    /// Which columns of the front have been written.
    written: Vec<bool>,
}

impl FrontMap<'_> {
    pub(crate) fn new(size: &[usize]) -> FrontMap<'_> {
        FrontMap { size, offset: vec![0; size.len()], runs: Vec::new(), written: Vec::new() }
    }

    /// Finds the runs of an element; groups that follow each other in both make one. Returns the rows of the element.
    fn align(&mut self, groups: &[usize]) -> usize {
        self.runs.clear();
        let mut rows = 0;
        for g in groups {
            let (to, length) = (self.offset[*g], self.size[*g]);
            match self.runs.last_mut() {
                Some([_, first, before]) if *first + *before == to => *before += length,
                _ => self.runs.push([rows, to, length]),
            }
            rows += length;
        }
        rows
    }
}

/// The front at work, a symmetric matrix of which the lower triangle counts.
pub(crate) struct Front<'f, 's> {
    map: &'f mut FrontMap<'s>,
    /// Number of unknowns, and of those that disappear.
    n: usize,
    ne: usize,
    /// The leading columns, those of the groups that disappear, one after the other.
    panel: &'f mut [f64],
    /// The trailing square, columns one after the other.
    rest: &'f mut [f64],
}

impl<'f, 's> Front<'f, 's> {
    /// A front of which nothing is written yet; the lengths of `panel` and `rest` are those it asks for.
    pub(crate) fn open(map: &'f mut FrontMap<'s>, plan: &FrontPlan, panel: &'f mut [f64], rest: &'f mut [f64]) -> Front<'f, 's> {
        let (mut n, mut ne) = (0, 0);
        for (i, g) in plan.groups.iter().enumerate() {
            map.offset[*g] = n;
            n += map.size[*g];
            if i < plan.eliminated {
                ne = n;
            }
        }
        map.written.clear();
        map.written.resize(n, false);
        Front { map, n, ne, panel, rest }
    }

    /// Adds an element. Front and element sort their groups by rank, so lower stays lower and rows come in runs.
    pub(crate) fn add(&mut self, matrix: &[f64], groups: &[usize]) {
        let rows = self.map.align(groups);
        let FrontMap { runs, written, .. } = &mut *self.map;
        Arch::new().dispatch(Addition {
            matrix,
            rows,
            runs,
            written,
            n: self.n,
            ne: self.ne,
            panel: self.panel,
            rest: self.rest,
        });
    }

    /// Columns that no element has are zero.
    pub(crate) fn complete(&mut self) {
        for target in (0..self.n).filter(|target| !self.map.written[*target]) {
            column(self.panel, self.rest, [self.n, self.ne], target).fill(0.0);
        }
    }

    /// Factorises the panel and leaves the Schur complement in the rest.
    ///
    /// # Errors
    /// The unknown whose pivot lost all stiffness.
    pub(crate) fn factor(mut self) -> Result<(), usize> {
        self.complete();
        let (n, ne) = (self.n, self.ne);
        factor_panel(self.panel, n)?;
        let l21 = MatRef::from_column_major_slice(self.panel, n, ne).subrows(ne, n - ne);
        subtract_product(l21, MatMut::from_column_major_slice_mut(self.rest, n - ne, n - ne));
        Ok(())
    }
}

/// A column of a front from the diagonal on.
#[inline(always)]
fn column<'a>(panel: &'a mut [f64], rest: &'a mut [f64], [n, ne]: [usize; 2], target: usize) -> &'a mut [f64] {
    match target.checked_sub(ne) {
        None => &mut panel[target * n + target..(target + 1) * n],
        Some(k) => &mut rest[k * (n - ne) + k..(k + 1) * (n - ne)],
    }
}

/// An element to be added to a front.
struct Addition<'a> {
    matrix: &'a [f64],
    rows: usize,
    runs: &'a [Run],
    written: &'a mut [bool],
    n: usize,
    ne: usize,
    panel: &'a mut [f64],
    rest: &'a mut [f64],
}

impl WithSimd for Addition<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Addition { matrix, rows, runs, written, n, ne, panel, rest } = self;
        for (number, [from, to, length]) in runs.iter().enumerate() {
            for c in 0..*length {
                let (row, target) = (from + c, to + c);
                let source = &matrix[(from + c) * rows..(from + c + 1) * rows];
                let out = column(panel, rest, [n, ne], target);
                let own = [[row, target, length - c]];
                let runs = own.iter().chain(&runs[number + 1..]);
                if std::mem::replace(&mut written[target], true) {
                    for [from, to, length] in runs {
                        let out = &mut out[to - target..to - target + length];
                        out.iter_mut().zip(&source[*from..from + length]).for_each(|(o, s)| *o += s);
                    }
                } else {
                    let mut done = 0;
                    for [from, to, length] in runs {
                        out[done..to - target].fill(0.0);
                        done = to - target + length;
                        out[to - target..done].copy_from_slice(&source[*from..from + length]);
                    }
                    out[done..].fill(0.0);
                }
            }
        }
    }
}
