//! Natural modes: the lowest eigenvalues of `K u = omega^2 M u`.

use crate::error::Error;
use crate::field::Field;
use crate::sparse::SparseBody;
use faer::linalg::solvers::Solve;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::sparse::SparseColMat;
use faer::sparse::linalg::solvers::Llt;
use faer::{Mat, MatRef, Par, Side};

/// A natural mode.
#[derive(Clone)]
#[non_exhaustive]
pub struct Mode {
    /// Angular frequency squared, `omega^2 = lambda`, rad^2/s^2 with t, mm, s; zero to round-off for a rigid motion. For a potential the rate
    /// of decay, 1/s.
    pub eigenvalue: f64,
    /// Relative change of `lambda` in the last step of the iteration; zero where all modes were found at once.
    pub change: f64,
    /// The shape, `int rho u . u dV = 1`.
    pub field: Field,
}

/// Up to so many unknowns all modes are found at once by dense matrices.
const DENSE: usize = 200;

/// Steps of the iteration at most.
const STEPS: usize = 200;

/// Relative change of the eigenvalues at which the iteration ends, if round-off allows.
const SETTLED: f64 = 1e-13;

impl SparseBody {
    /// The `count` lowest natural modes with a density for every material, t/mm^3 with N and mm, ascending; rigid motions come first.
    ///
    /// Subspace iteration with Rayleigh-Ritz steps (Bathe 1971), `X <- (K + s M)^-1 M X` on a block of `2 count + 8` vectors, which finds
    /// multiple eigenvalues as often as they are there; the sparse Cholesky factors and the dense eigenproblem are faer's. Small bodies, and more
    /// than a quarter of all modes, are solved by dense matrices at once.
    ///
    /// # Errors
    /// As for [`SparseBody::mass`] and [`SparseBody::stiffness`]; [`Error::OutOfRange`] for more modes than unknowns;
    /// [`Error::NoStiffness`] if factorising fails; [`Error::NotConverged`].
    pub fn modes(&self, density: &[f64], count: usize) -> Result<Vec<Mode>, Error> {
        let n = self.unknowns();
        if count == 0 || count > n {
            let quantity = "the number of modes".into();
            return Err(Error::OutOfRange { quantity, value: count as f64, range: "from one to the number of unknowns" });
        }
        let mut pencil = Pencil { stiffness: self.stiffness()?.0, mass: self.mass(density)?, shift: 0.0 };
        let block = 2 * count + 8;
        if n <= DENSE || 2 * block >= n {
            let (values, x) = pencil.whole()?;
            return self.shapes(&values, &vec![0.0; count], &x);
        }
        // Eigenvalues are known to round-off of the largest one.
        let stiffest = (0..n).fold(0.0_f64, |m, i| m.max(pencil.stiffness[(i, i)] / pencil.mass[(i, i)]));
        let round_off = 4.0 * f64::EPSILON * stiffest;
        pencil.shift = 0.01 * self.slowest(density);
        let mut factors = pencil.factorised()?;
        let mut x = start(n, block, 0);
        let mut values: Vec<f64> = Vec::new();
        for step in 1..=STEPS {
            let (ritz, vectors) = pencil.rayleigh_ritz(&factors.solve(&pencil.mass * &x))?;
            let near = |old: &f64, new: &f64| (new - old).abs() / (new + pencil.shift).abs();
            let changes: Vec<f64> = values.iter().zip(&ritz).take(count).map(|(old, new)| near(old, new)).collect();
            let missing = block - vectors.ncols();
            (values, x) = (ritz, vectors);
            let settled = |(change, value): (&f64, &f64)| *change <= SETTLED.max(round_off / (value + pencil.shift).abs());
            if changes.len() == count && changes.iter().zip(&values).all(settled) {
                return self.shapes(&values, &changes, &x);
            }
            // Directions that were lost to round-off start anew.
            let fresh = start(n, missing, step);
            x = Mat::from_fn(n, block, |i, k| if k < block - missing { x[(i, k)] } else { fresh[(i, k + missing - block)] });
            // By now the first mode that strains the body is known well enough to shift closely below zero.
            let elastic = values.iter().copied().find(|value| *value > 1e4 * round_off);
            if let Some(first) = elastic.filter(|_| step == 4) {
                pencil.shift = 0.3 * first;
                factors = pencil.factorised()?;
                values.clear();
            }
        }
        Err(Error::NotConverged { what: "the natural modes", steps: STEPS })
    }

    fn shapes(&self, values: &[f64], changes: &[f64], x: &Mat<f64>) -> Result<Vec<Mode>, Error> {
        let none = vec![0.0; self.problem().load_cases.len()];
        let mode = |k: usize| {
            let field = self.field_with(x.col_as_slice(k), &none, 0.0)?;
            Ok(Mode { eigenvalue: values[k], change: changes[k], field })
        };
        (0..changes.len()).map(mode).collect()
    }

    /// The order of the lowest eigenvalues of a compact body, `E / (rho L^2)`.
    fn slowest(&self, density: &[f64]) -> f64 {
        let problem = self.problem();
        let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, f64::max);
        let modulus = largest(&mut problem.materials.iter().map(|m| m.size(problem.kinematics)));
        let extent = |k: usize| {
            let along = || problem.mesh.vertices.iter().map(|x| x[k]);
            along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
        };
        modulus / (largest(&mut density.iter().copied()) * extent(0).max(extent(1)).powi(2))
    }
}

/// The matrices of an eigenproblem, shifted.
struct Pencil {
    stiffness: SparseColMat<usize, f64>,
    mass: SparseColMat<usize, f64>,
    shift: f64,
}

impl Pencil {
    /// All eigenvalues and vectors with unit mass, by dense matrices: with `M = L L^T`, those of `L^-1 K L^-T`.
    fn whole(&self) -> Result<(Vec<f64>, Mat<f64>), Error> {
        let place = || "the mass of the modes".to_string();
        let mass = self.mass.to_dense().llt(Side::Lower).map_err(|_| Error::NoStiffness { place: place() })?;
        let l = mass.L();
        let half = solved(l, &self.stiffness.to_dense());
        let whole = solved(l, &half.transpose().to_owned());
        let eigen =
            whole.self_adjoint_eigen(Side::Lower).map_err(|_| Error::NotConverged { what: "the natural modes", steps: 0 })?;
        let values = (0..whole.nrows()).map(|k| eigen.S()[k]).collect();
        let mut vectors = eigen.U().to_owned();
        solve_upper_triangular_in_place(l.transpose(), vectors.as_mut(), Par::Seq);
        Ok((values, vectors))
    }

    /// Factors of `K + s M`.
    fn factorised(&self) -> Result<Llt<usize, f64>, Error> {
        let shifted = &self.stiffness + &(faer::Scale(self.shift) * &self.mass);
        let place = "the shifted stiffness of the modes".to_string();
        shifted.sp_cholesky(Side::Lower).map_err(|_| Error::NoStiffness { place })
    }

    /// Eigenvalues of the pencil on the span of some vectors, ascending, and their vectors with unit mass.
    fn rayleigh_ritz(&self, y: &Mat<f64>) -> Result<(Vec<f64>, Mat<f64>), Error> {
        let failed = || Error::NotConverged { what: "the natural modes", steps: 0 };
        // Columns of one length, so that the small mass matrix has a diagonal of ones.
        let my = &self.mass * y;
        let length: Vec<f64> = (0..y.ncols()).map(|k| (y.col(k).transpose() * my.col(k)).sqrt()).collect();
        let unit = |m: &Mat<f64>| Mat::from_fn(m.nrows(), m.ncols(), |i, k| m[(i, k)] / length[k]);
        let (y, my) = (unit(y), unit(&my));
        // The mass matrix may be near singular on the span: its own eigenvectors say what is independent.
        let mass = (y.transpose() * &my).self_adjoint_eigen(Side::Lower).map_err(|_| failed())?;
        let (d, q) = (mass.S(), mass.U());
        let largest = d[d.dim() - 1];
        let kept: Vec<usize> = (0..d.dim()).filter(|k| d[*k] > 1e-13 * largest).collect();
        let basis = Mat::from_fn(q.nrows(), kept.len(), |i, k| q[(i, kept[k])] / d[kept[k]].sqrt());
        let z = &y * &basis;
        let small = z.transpose() * (&self.stiffness * &z);
        let ritz = small.self_adjoint_eigen(Side::Lower).map_err(|_| failed())?;
        let values = (0..kept.len()).map(|k| ritz.S()[k]).collect();
        Ok((values, &z * ritz.U()))
    }
}

/// `L^-1 A`.
fn solved(l: MatRef<'_, f64>, a: &Mat<f64>) -> Mat<f64> {
    let mut x = a.clone();
    solve_lower_triangular_in_place(l, x.as_mut(), Par::Seq);
    x
}

/// Vectors without structure, the same in every run; others for every `seed`.
fn start(rows: usize, columns: usize, seed: usize) -> Mat<f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64.wrapping_mul(2 * seed as u64 + 1);
    Mat::from_fn(rows, columns, |_, _| {
        // xorshift64 (Marsaglia 2003).
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state as f64 / u64::MAX as f64 - 0.5
    })
}
