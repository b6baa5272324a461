//! What is left of a body when everything but its kept boundary is eliminated.

use crate::check::power_of_two_below;
use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::trace::{Trace, TraceLoad};
use faer::linalg::solvers::Solve;
use faer::{Mat, Scale, Side};

/// A body reduced to its kept boundary: `S u_c = f_c + sum_k a_k F_k`, with `S = K_cc - K_ci K_ii^-1 K_ic`.
///
/// Unknowns are the hierarchic coefficients of the trace (and the free motions of the rigid edge, last). The right-hand
/// columns `F_k` are the condensed load cases, then one column of prescribed displacements, then the reaction functionals, three a support
/// and then three a pin: `columns = load cases + 1 + 3 (supports + pins)`. Units follow the unknowns: mm, and rad for a rotation `theta`.
#[derive(Clone, Debug)]
pub struct InterfaceOperator {
    /// Kinematics of the body.
    pub kinematics: Kinematics,
    /// The kept boundary, the first of several.
    pub trace: Trace,
    /// The other kept boundaries, in the order of their names; their unknowns are numbered on.
    pub more_traces: Vec<Trace>,
    /// `S`, N/mm (N mm/rad for a rotation), symmetric, `unknowns x unknowns`; positive semidefinite, singular exactly for the rigid modes.
    pub stiffness: Mat<f64>,
    /// Condensed right-hand sides, `unknowns x columns`: N for load cases and prescribed displacements, N/mm for the forces among the
    /// reaction functionals and N for the moments.
    pub columns: Mat<f64>,
    /// `F_i,k^T K_ii^-1 F_i,l`, `columns x columns`, N mm between load cases.
    pub work: Mat<f64>,
    /// Rigid motions that the supports leave free, as kept unknowns, `unknowns x modes`.
    pub rigid_modes: Mat<f64>,
    /// The same motions in the plane: `[t_x, t_z, theta]` about the origin, mm and rad; one for every column of `rigid_modes`.
    pub rigid_motions: Vec<[f64; 3]>,
    /// Names of the load cases.
    pub load_cases: Vec<String>,
    /// Indices of the kept unknowns that are the free motions of the rigid edge, `[t_x, t_z, theta]` about its reference point; `None` if not free.
    pub frame: [Option<usize>; 3],
    /// Constant parts of the reactions, `reactions x columns`.
    pub(crate) reaction_constant: Mat<f64>,
}

/// The state of the kept unknowns under given contact loads and load-case factors.
#[derive(Clone, Debug)]
pub struct InterfaceState {
    /// Kept unknowns, mm (rad for a rotation).
    pub unknowns: Vec<f64>,
    /// Factors of the columns, one a column: load cases, 1 for the prescribed displacements, 0 for the reaction functionals.
    pub factors: Vec<f64>,
    /// Load on the kept boundary, N.
    pub load: TraceLoad,
}

impl InterfaceOperator {
    /// Factors of all columns for given factors of load cases by name, 0 for those not named; prescribed displacements count fully.
    ///
    /// # Errors
    /// [`Error::NoSuchLoadCase`].
    pub fn factors(&self, cases: &[(&str, f64)]) -> Result<Vec<f64>, Error> {
        let mut factors = self.factors_in_order(&[]);
        for (name, factor) in cases {
            factors[self.load_case(name)?] += factor;
        }
        Ok(factors)
    }

    /// The same for factors in the order of the load cases, 0 for those at the end that are left out.
    pub fn factors_in_order(&self, cases: &[f64]) -> Vec<f64> {
        let mut factors = vec![0.0; self.columns.ncols()];
        let known = self.load_cases.len();
        factors[..known].iter_mut().zip(cases).for_each(|(factor, given)| *factor = *given);
        factors[known] = 1.0;
        factors
    }

    /// Column of a load case.
    ///
    /// # Errors
    /// [`Error::NoSuchLoadCase`].
    pub fn load_case(&self, name: &str) -> Result<usize, Error> {
        let missing = || Error::NoSuchLoadCase { name: name.to_string(), known: self.load_cases.join(", ") };
        self.load_cases.iter().position(|known| known == name).ok_or_else(missing)
    }

    /// The column of the prescribed displacements, after those of the load cases.
    pub fn prescribed_column(&self) -> usize {
        self.load_cases.len()
    }

    /// Whole right-hand side, N, one value a kept unknown: contact load plus condensed columns.
    pub fn right_hand_side(&self, load: &TraceLoad, factors: &[f64]) -> Vec<f64> {
        (0..self.stiffness.nrows())
            .map(|i| load.unknowns[i] + factors.iter().enumerate().map(|(k, a)| a * self.columns[(i, k)]).sum::<f64>())
            .collect()
    }

    /// Solves for the kept unknowns (mm, `unknowns x cases`) under contact loads (N, `unknowns x cases`) with the rigid coordinates at zero: every
    /// rigid mode is made orthogonal to `gauge` (`unknowns x modes`, `gauge^T rigid_modes` regular), and the load's resultant along the
    /// rigid modes is balanced through `gauge` as well. Without rigid modes this is plain `S^-1 f`.
    ///
    /// Solved as the bordered system `[S G; G^T 0]`, factorised by pivoted LU.
    pub fn solve(&self, right: &Mat<f64>, gauge: &Mat<f64>) -> Mat<f64> {
        let n = self.stiffness.nrows();
        let r = self.rigid_modes.ncols();
        // In units of a power of two, so that equal problems in other units go through the same square roots.
        let scale = (0..n).map(|i| self.stiffness[(i, i)]).fold(0.0, f64::max);
        let unit = 1.0 / power_of_two_below(scale);
        if r == 0
            && let Ok(llt) = (Scale(unit) * &self.stiffness).llt(Side::Lower)
        {
            return llt.solve(Scale(unit) * right);
        }
        // Scale the border like the stiffness so that pivoting sees comparable rows.
        let scale = (0..n).map(|i| self.stiffness[(i, i)]).fold(0.0, f64::max);
        let size = gauge.as_ref().norm_max().max(f64::MIN_POSITIVE);
        let border = Mat::from_fn(n + r, n + r, |i, j| match (i < n, j < n) {
            (true, true) => self.stiffness[(i, j)],
            (true, false) => gauge[(i, j - n)] / size * scale,
            (false, true) => gauge[(j, i - n)] / size * scale,
            (false, false) => 0.0,
        });
        let full = Mat::from_fn(n + r, right.ncols(), |i, j| if i < n { right[(i, j)] } else { 0.0 });
        let x = border.partial_piv_lu().solve(&full);
        x.submatrix(0, 0, n, right.ncols()).to_owned()
    }

    /// [`InterfaceOperator::solve`] for one right-hand side, the answer orthogonal to the rigid modes.
    pub fn solve_one(&self, right: &[f64]) -> Vec<f64> {
        let right = Mat::from_fn(right.len(), 1, |i, _| right[i]);
        self.solve(&right, &self.rigid_modes).col_as_slice(0).to_vec()
    }

    /// Work of column `k` in a state: `F_k . u` of the whole body. For a load case this is the work of its loads, N mm; for a
    /// functional, its value, N or N mm.
    pub fn column_work(&self, k: usize, state: &InterfaceState) -> f64 {
        let boundary: f64 = state.unknowns.iter().enumerate().map(|(i, u)| u * self.columns[(i, k)]).sum();
        let interior: f64 = state.factors.iter().enumerate().map(|(l, a)| a * self.work[(k, l)]).sum();
        boundary + interior
    }

    /// Strain energy `1/2 f . u`, N mm, of a state without prescribed displacements and eigenstrains.
    pub fn strain_energy(&self, state: &InterfaceState) -> f64 {
        let contact: f64 = state.load.unknowns.iter().zip(&state.unknowns).map(|(f, u)| f * u).sum();
        let loads: f64 = (0..self.load_cases.len()).map(|k| state.factors[k] * self.column_work(k, state)).sum();
        0.5 * (contact + loads)
    }

    /// Force and moment (about the origin) that support number `support` exerts on the body: `[x, z, moment]`, N and N mm; in torsion
    /// the third is zero and the first is the sum of the circumferential nodal forces.
    pub fn reaction(&self, support: usize, state: &InterfaceState) -> [f64; 3] {
        std::array::from_fn(|k| {
            let r = 3 * support + k;
            let constant: f64 = state.factors.iter().enumerate().map(|(l, a)| a * self.reaction_constant[(r, l)]).sum();
            let direct = state.load.supports.get(support).map_or(0.0, |l| l[k]);
            self.column_work(self.prescribed_column() + 1 + r, state) + constant - direct
        })
    }
}
