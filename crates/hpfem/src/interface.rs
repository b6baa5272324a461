//! What is left of a body when everything but its kept boundary is eliminated.

use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::mesh::names;
use crate::trace::{Trace, TraceLoad};
use faer::Mat;

/// A body reduced to its kept boundary: `S u_c = f_c + sum_k a_k F_k`, with `S = K_cc - K_ci K_ii^-1 K_ic`.
///
/// Unknowns are the hierarchic coefficients of the trace (and the free motions of the rigid edge, last). The right-hand
/// columns `F_k` are the condensed load cases, then one column of prescribed displacements, then the reaction functionals, three a support
/// and then three a pin: `columns = load cases + 1 + 3 (supports + pins)`. Units follow the unknowns: mm, and rad for a rotation `theta`.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "InterfaceParts", into = "InterfaceParts")
)]
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

/// All that an [`InterfaceOperator`] is made of, as plain data: from another program, or from a file (feature `serde`). The fields are those of
/// the operator.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct InterfaceParts {
    /// Kinematics of the body.
    pub kinematics: Kinematics,
    /// The kept boundaries, one at least.
    pub traces: Vec<Trace>,
    /// `S`, `unknowns x unknowns`, symmetric.
    #[cfg_attr(feature = "serde", serde(with = "crate::matrix_text"))]
    pub stiffness: Mat<f64>,
    /// Condensed right-hand sides, `unknowns x columns`.
    #[cfg_attr(feature = "serde", serde(with = "crate::matrix_text"))]
    pub columns: Mat<f64>,
    /// Work between the columns, `columns x columns`; NaN where it was not computed, between temperatures of [`Body::heated`](crate::Body::heated).
    #[cfg_attr(feature = "serde", serde(with = "crate::matrix_text"))]
    pub work: Mat<f64>,
    /// Rigid motions as kept unknowns, `unknowns x modes`.
    #[cfg_attr(feature = "serde", serde(with = "crate::matrix_text"))]
    pub rigid_modes: Mat<f64>,
    /// The same motions in the plane, one a mode.
    pub rigid_motions: Vec<[f64; 3]>,
    /// Names of the load cases.
    pub load_cases: Vec<String>,
    /// Kept unknowns of the rigid edge.
    pub frame: [Option<usize>; 3],
    /// Constant parts of the reactions, `reactions x columns`, `columns = load cases + 1 + reactions`.
    #[cfg_attr(feature = "serde", serde(with = "crate::matrix_text"))]
    pub reaction_constant: Mat<f64>,
}

impl InterfaceParts {
    /// What in the parts names unknowns, edges or cases that there are not.
    fn inconsistent(&self, n: usize) -> Option<&'static str> {
        let components = self.kinematics.components();
        let frame: Vec<usize> = self.frame.iter().flatten().copied().collect();
        let twice = |list: &[usize]| list.iter().enumerate().any(|(i, a)| list[..i].contains(a));
        let names = &self.load_cases;
        let faults = [
            (
                self.traces.iter().any(|t| !t.is_sound(components, self.reaction_constant.nrows() / 3)),
                "a kept boundary names unknowns, modes, edges or places that there are not",
            ),
            (
                frame.iter().any(|unknown| *unknown >= n) || twice(&frame),
                "the rigid edge names an unknown that there is not, or one twice",
            ),
            (names.iter().enumerate().any(|(i, a)| names[..i].contains(a)), "two load cases have one name"),
            (!self.reaction_constant.nrows().is_multiple_of(3), "reactions come in threes, one a support or pin"),
            (self.rigid_motions.iter().flatten().any(|v| !v.is_finite()), "a rigid motion is not finite"),
        ];
        faults.into_iter().find(|(fault, _)| *fault).map(|(_, what)| what)
    }

    /// Refuses parts that do not fit together.
    fn check(&self) -> Result<(), Error> {
        let n = self.stiffness.nrows();
        let columns = self.columns.ncols();
        let counts = [
            ("columns of the stiffness", self.stiffness.ncols(), n),
            ("rows of the right-hand sides", self.columns.nrows(), n),
            ("rows of the rigid modes", self.rigid_modes.nrows(), n),
            ("rigid motions", self.rigid_motions.len(), self.rigid_modes.ncols()),
            ("rows of the work", self.work.nrows(), columns),
            ("columns of the work", self.work.ncols(), columns),
            ("columns of the reactions", self.reaction_constant.ncols(), columns),
            ("right-hand sides", columns, self.load_cases.len() + 1 + self.reaction_constant.nrows()),
        ];
        let traces = self.traces.iter().map(|trace| ("kept unknowns of a boundary", trace.unknowns, n));
        if let Some((what, given, expected)) = counts.into_iter().chain(traces).find(|(_, given, expected)| given != expected) {
            return Err(Error::Count { what: what.into(), given, expected });
        }
        if let Some(what) = self.inconsistent(n) {
            return Err(Error::Inconsistent { what });
        }
        let matrices = [&self.stiffness, &self.columns, &self.rigid_modes, &self.reaction_constant];
        let mut numbers = matrices.iter().flat_map(|m| m.col_iter()).flat_map(|c| c.iter());
        // Work that was not computed is no number.
        let mut work = self.work.col_iter().flat_map(|c| c.iter());
        if let Some(value) = numbers.find(|v| !v.is_finite()).or(work.find(|v| v.is_infinite())) {
            return Err(Error::OutOfRange { quantity: "a number of the operator".into(), value: *value, range: "finite" });
        }
        let size = self.stiffness.norm_max();
        let skew = (0..n).map(|i| (0..i).fold(0.0_f64, |m, j| m.max((self.stiffness[(i, j)] - self.stiffness[(j, i)]).abs())));
        match skew.fold(0.0, f64::max) {
            skew if skew > 1e-9 * size => {
                Err(Error::OutOfRange { quantity: "the skewness of the stiffness".into(), value: skew, range: "zero" })
            }
            _ => Ok(()),
        }
    }
}

impl TryFrom<InterfaceParts> for InterfaceOperator {
    type Error = Error;

    fn try_from(parts: InterfaceParts) -> Result<InterfaceOperator, Error> {
        InterfaceOperator::from_parts(parts)
    }
}

impl From<InterfaceOperator> for InterfaceParts {
    fn from(operator: InterfaceOperator) -> InterfaceParts {
        operator.into_parts()
    }
}

/// The state of the kept unknowns under given contact loads and load-case factors.
#[derive(Clone, Debug, PartialEq)]
pub struct InterfaceState {
    /// Kept unknowns, mm (rad for a rotation).
    pub unknowns: Vec<f64>,
    /// Factors of the columns, one a column: load cases, 1 for the prescribed displacements, 0 for the reaction functionals.
    pub factors: Vec<f64>,
    /// Load on the kept boundary, N.
    pub load: TraceLoad,
}

impl InterfaceOperator {
    /// An operator from its parts.
    ///
    /// # Errors
    /// [`Error::Count`] and [`Error::Inconsistent`] for parts that do not fit together; [`Error::OutOfRange`] for a stiffness that is not symmetric or numbers that
    /// are not finite.
    pub fn from_parts(parts: InterfaceParts) -> Result<InterfaceOperator, Error> {
        parts.check()?;
        let InterfaceParts { kinematics, traces, stiffness, columns, work, rigid_modes, rigid_motions, .. } = parts;
        let mut traces = traces.into_iter();
        let none = || Error::Count { what: "kept boundaries".into(), given: 0, expected: 1 };
        let trace = traces.next().ok_or_else(none)?;
        let (more_traces, load_cases, frame) = (traces.collect(), parts.load_cases, parts.frame);
        let reaction_constant = parts.reaction_constant;
        Ok(InterfaceOperator {
            kinematics,
            trace,
            more_traces,
            stiffness,
            columns,
            work,
            rigid_modes,
            rigid_motions,
            load_cases,
            frame,
            reaction_constant,
        })
    }

    /// The parts of the operator.
    pub fn into_parts(self) -> InterfaceParts {
        let mut traces = vec![self.trace];
        traces.extend(self.more_traces);
        InterfaceParts {
            kinematics: self.kinematics,
            traces,
            stiffness: self.stiffness,
            columns: self.columns,
            work: self.work,
            rigid_modes: self.rigid_modes,
            rigid_motions: self.rigid_motions,
            load_cases: self.load_cases,
            frame: self.frame,
            reaction_constant: self.reaction_constant,
        }
    }

    /// Factors of all columns for given factors of load cases by name, 0 for those not named; prescribed displacements count fully.
    ///
    /// # Errors
    /// [`Error::NoSuchLoadCase`]; [`Error::OutOfRange`] for a factor that is not finite.
    pub fn factors(&self, cases: &[(&str, f64)]) -> Result<Vec<f64>, Error> {
        let mut factors = self.factors_in_order(&[]);
        for (name, factor) in cases {
            let sum = &mut factors[self.load_case(name)?];
            *sum += factor;
            if !sum.is_finite() {
                let quantity = format!("the factor of load case \"{name}\"");
                return Err(Error::OutOfRange { quantity, value: *sum, range: "finite" });
            }
        }
        Ok(factors)
    }

    /// The same for factors in the order of the load cases, 0 for those at the end that are left out; more than there are cases count for nothing.
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
        let missing = || Error::NoSuchLoadCase { name: name.to_string(), known: names(&self.load_cases) };
        self.load_cases.iter().position(|known| known == name).ok_or_else(missing)
    }

    /// The column of the prescribed displacements, after those of the load cases.
    pub fn prescribed_column(&self) -> usize {
        self.load_cases.len()
    }

    /// Whole right-hand side, N, one value a kept unknown: contact load plus condensed columns. A load has one value a kept unknown too: without any it is
    /// `TraceLoad { unknowns: vec![0.0; trace.unknowns], ..TraceLoad::default() }`.
    ///
    /// # Panics
    /// For a load or factors of another body.
    pub fn right_hand_side(&self, load: &TraceLoad, factors: &[f64]) -> Vec<f64> {
        (0..self.stiffness.nrows())
            .map(|i| load.unknowns[i] + factors.iter().enumerate().map(|(k, a)| a * self.columns[(i, k)]).sum::<f64>())
            .collect()
    }

    /// Solves for the kept unknowns (mm, `unknowns x cases`) under contact loads (N, `unknowns x cases`) with the rigid coordinates at zero: every
    /// rigid mode is made orthogonal to `gauge` (`unknowns x modes`, `gauge^T rigid_modes` regular), and the load's resultant along the
    /// rigid modes is balanced through `gauge` as well. Without rigid modes this is plain `S^-1 f`.
    ///
    /// For loads that come one after the other, [`InterfaceOperator::factor`] once.
    ///
    /// # Panics
    /// For loads or a gauge of another body.
    pub fn solve(&self, right: &Mat<f64>, gauge: &Mat<f64>) -> Mat<f64> {
        let (given, unknowns) = (right.nrows(), self.stiffness.nrows());
        assert!(given == unknowns, "a right-hand side of {given} numbers for {unknowns} kept unknowns");
        self.factor(gauge, (0..self.stiffness.nrows()).collect()).solve(right)
    }

    /// [`InterfaceOperator::solve`] for one right-hand side, the answer orthogonal to the rigid modes.
    ///
    /// # Panics
    /// For a right-hand side of another body.
    pub fn solve_one(&self, right: &[f64]) -> Vec<f64> {
        let right = Mat::from_fn(right.len(), 1, |i, _| right[i]);
        self.solve(&right, &self.rigid_modes).col_as_slice(0).to_vec()
    }

    /// Work of column `k` in a state: `F_k . u` of the whole body. For a load case this is the work of its loads, N mm; for a
    /// functional, its value, N or N mm. NaN between temperatures of [`Body::heated`](crate::Body::heated), whose work is not computed.
    ///
    /// # Panics
    /// For a column that the body does not have, with their number; a state of another body.
    pub fn column_work(&self, k: usize, state: &InterfaceState) -> f64 {
        let known = self.columns.ncols();
        assert!(
            k < known,
            "column {k} of an interface operator that has {known}, counted from 0: see load_case and prescribed_column"
        );
        self.assert_own(state);
        let boundary: f64 = state.unknowns.iter().enumerate().map(|(i, u)| u * self.columns[(i, k)]).sum();
        let acting = state.factors.iter().enumerate().filter(|(_, a)| **a != 0.0);
        boundary + acting.map(|(l, a)| a * self.work[(k, l)]).sum::<f64>()
    }

    /// Work of the contact load and the load cases over two, `1/2 f . u`, N mm: the strain energy, that of elastic foundations with it, of a
    /// state without prescribed displacements and eigenstrains. Work of reactions on prescribed displacements is not counted, so that with these
    /// it is no energy (0 where nothing else acts); [`Field::strain_energy`](crate::Field::strain_energy) knows both, but no foundations.
    ///
    /// # Panics
    /// For a state of another body, or from before a load was added.
    pub fn strain_energy(&self, state: &InterfaceState) -> f64 {
        self.assert_own(state);
        let contact: f64 = state.load.unknowns.iter().zip(&state.unknowns).map(|(f, u)| f * u).sum();
        let acting = (0..self.load_cases.len()).filter(|k| state.factors[*k] != 0.0);
        let loads: f64 = acting.map(|k| state.factors[k] * self.column_work(k, state)).sum();
        0.5 * (contact + loads)
    }

    /// Ends the program for a state of another body, whose numbers would be taken for others.
    fn assert_own(&self, state: &InterfaceState) {
        let (given, unknowns) = (state.unknowns.len(), self.stiffness.nrows());
        assert!(given == unknowns, "a state of {given} kept unknowns for an interface operator that has {unknowns}");
        let (given, columns) = (state.factors.len(), self.columns.ncols());
        assert!(given == columns, "a state of {given} factors for an interface operator that has {columns} columns");
    }

    /// Force and moment (about the origin) that support number `support` exerts on the body: `[x, z, moment]`, N and N mm. In bodies of revolution the axial force alone
    /// is one, in torsion and for a potential the first number: the sum of the circumferential nodal forces, which is no torque, or of the fluxes.
    ///
    /// # Panics
    /// For a support that the body does not have, or a state of another body.
    pub fn reaction(&self, support: usize, state: &InterfaceState) -> [f64; 3] {
        let known = self.reaction_constant.nrows() / 3;
        assert!(
            support < known,
            "support {support} of an interface operator that has {known}, its pins included, counted from 0"
        );
        std::array::from_fn(|k| {
            let r = 3 * support + k;
            let constant: f64 = state.factors.iter().enumerate().map(|(l, a)| a * self.reaction_constant[(r, l)]).sum();
            let direct = state.load.supports.get(support).map_or(0.0, |l| l[k]);
            self.column_work(self.prescribed_column() + 1 + r, state) + constant - direct
        })
    }
}
