//! What unit loads on a kept boundary do to each other: a compliance, by half of the work of solving for them.

use crate::interface_factor::{Border, Form, InterfaceFactor};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Accum, Mat, MatRef, Par};

/// Loads that are solved for at once.
const STRIP: usize = 64;

/// Loads `B` on the kept unknowns, half solved: with `S = L L^T`, `W = L^-1 B`, and the compliance `B^T S^-1 B` is `W^T W`. Of a body that its supports
/// leave free `S^-1` is that of the bordered system.
pub struct HalfSolved {
    form: Half,
}

/// Solved as far as the factor lets it.
enum Half {
    /// By strips of loads; `K^T B` and `(G^T K)^-1 K^T B` where there is a border.
    Definite { strips: Vec<Strip>, unit: f64, along: Option<[Mat<f64>; 2]> },
    /// The loads, and all that they move.
    Solved { loads: Vec<Vec<(usize, f64)>>, moved: Mat<f64> },
}

/// Some columns of `W` from number `at` on, with the unknowns from place `first` on: none of these loads does anything before.
struct Strip {
    at: usize,
    first: usize,
    solved: Mat<f64>,
}

impl InterfaceFactor {
    /// Half of the solution for loads, one after the other, by their few entries (kept unknown, load). Loads on unknowns that are held do nothing. The later
    /// in the order of the factor neighbouring loads begin, the less they cost.
    ///
    /// # Panics
    /// For an unknown that is not among the kept ones.
    pub fn half_solved(&self, loads: &[&[(usize, f64)]]) -> HalfSolved {
        let form = match &self.form {
            Form::Definite { factor, unit, border } => {
                let mut places = vec![None; self.unknowns()];
                self.order.iter().enumerate().for_each(|(place, unknown)| places[*unknown] = Some(place));
                let strip = |(number, loads)| Strip::new(factor.as_ref(), number * STRIP, loads, &places);
                let along = border.as_ref().map(|border| border.along(loads, &places));
                Half::Definite { strips: loads.chunks(STRIP).enumerate().map(strip).collect(), unit: *unit, along }
            }
            Form::Bordered { .. } => {
                let mut right = Mat::zeros(self.unknowns(), loads.len());
                let entries = loads.iter().enumerate().flat_map(|(j, load)| load.iter().map(move |(k, value)| (*k, j, *value)));
                entries.for_each(|(k, j, value)| right[(k, j)] += value);
                Half::Solved { loads: loads.iter().map(|load| load.to_vec()).collect(), moved: self.solve(&right) }
            }
        };
        HalfSolved { form }
    }
}

impl Strip {
    fn new(factor: MatRef<'_, f64>, at: usize, loads: &[&[(usize, f64)]], places: &[Option<usize>]) -> Strip {
        let placed =
            |load: &&[(usize, f64)]| load.iter().filter_map(|(k, value)| Some((places[*k]?, *value))).collect::<Vec<_>>();
        let loads: Vec<Vec<(usize, f64)>> = loads.iter().map(placed).collect();
        let first = loads.iter().flatten().map(|(place, _)| *place).min().unwrap_or(factor.nrows());
        let unknowns = factor.nrows() - first;
        let mut solved = Mat::<f64>::zeros(unknowns, loads.len());
        for (j, load) in loads.iter().enumerate() {
            let column = solved.col_as_slice_mut(j);
            load.iter().for_each(|(place, value)| column[place - first] += value);
        }
        solve_lower_triangular_in_place(factor.submatrix(first, first, unknowns, unknowns), solved.as_mut(), Par::Seq);
        Strip { at, first, solved }
    }
}

impl Border {
    /// `K^T B` and `(G^T K)^-1 K^T B` of loads.
    fn along(&self, loads: &[&[(usize, f64)]], places: &[Option<usize>]) -> [Mat<f64>; 2] {
        [&self.solved, &self.moved].map(|motions| {
            Mat::from_fn(motions.ncols(), loads.len(), |k, j| {
                loads[j].iter().filter_map(|(u, value)| Some(value * motions[(places[*u]?, k)])).sum()
            })
        })
    }
}

impl HalfSolved {
    /// Adds their compliance, `loads x loads` (mm/N of loads of 1 N), to one that is symmetric, which it stays to the bit.
    ///
    /// # Panics
    /// Where the sum is of another size.
    pub fn add(&self, sum: &mut Mat<f64>) {
        self.add_along(self, true, sum);
        for j in 0..sum.ncols() {
            (j + 1..sum.nrows()).for_each(|i| sum[(j, i)] = sum[(i, j)]);
        }
    }

    /// Adds what these loads are moved along by others on the same body, `these x others` (mm/N of loads of 1 N).
    ///
    /// # Panics
    /// Where the sum is of another size, or the others are of another body.
    pub fn add_by(&self, others: &HalfSolved, sum: &mut Mat<f64>) {
        self.add_along(others, false, sum);
    }

    /// The same, `lower` below and on the diagonal alone.
    fn add_along(&self, others: &HalfSolved, lower: bool, sum: &mut Mat<f64>) {
        match (&self.form, &others.form) {
            (Half::Definite { strips, unit, along }, Half::Definite { strips: by, along: by_along, .. }) => {
                let pairs = by.iter().flat_map(|by| strips.iter().map(move |strip| (strip, by)));
                for (strip, by) in pairs.filter(|(strip, by)| !lower || strip.at >= by.at) {
                    let mut to = sum.as_mut().submatrix_mut(strip.at, by.at, strip.loads(), by.loads());
                    let first = strip.first.max(by.first);
                    matmul(to.as_mut(), Accum::Add, strip.from(first).transpose(), by.from(first), *unit, Par::Seq);
                    if let Some(([along, _], [_, moved])) = along.as_ref().zip(by_along.as_ref()) {
                        let (along, moved) = (along.subcols(strip.at, strip.loads()), moved.subcols(by.at, by.loads()));
                        matmul(to, Accum::Add, along.transpose(), moved, -*unit, Par::Seq);
                    }
                }
            }
            (Half::Solved { loads, .. }, Half::Solved { moved, .. }) => {
                for (j, i) in (0..moved.ncols()).flat_map(|j| (0..loads.len()).map(move |i| (j, i))) {
                    sum[(i, j)] += loads[i].iter().map(|(k, value)| value * moved[(*k, j)]).sum::<f64>();
                }
            }
            (Half::Definite { .. }, Half::Solved { .. }) | (Half::Solved { .. }, Half::Definite { .. }) => {
                unreachable!("both are of one factor")
            }
        }
    }
}

impl Strip {
    fn loads(&self) -> usize {
        self.solved.ncols()
    }

    /// From an unknown on.
    fn from(&self, first: usize) -> MatRef<'_, f64> {
        self.solved.subrows(first - self.first, self.solved.nrows() - (first - self.first))
    }
}
