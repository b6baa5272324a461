//! Contact of bodies that are given as matrices: by boundary elements, another program, or a formula.

use crate::checked::{listed, positive, sized, symmetric};
use crate::coulomb::ContactState;
use crate::ending::{Ending, Warm};
use crate::error::Error;
use crate::lcp::{Complementarity, Point};
use crate::load::{ContactLoad, Friction};
use crate::matrices::Matrices;
use crate::operator::ContactOperator;
use crate::plain::{Held, Plain, Unloaded};
use crate::products::{add, times, transposed_times};
use crate::status::Status;
use crate::system::ContactSystem;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// Motions of the bodies beside their deformation (an approach, a tilt, a rigid shift), each with its balance of force or moment
/// `forces + Psi^T lambda + Psi_t^T sigma = K y`.
#[derive(Clone, Debug)]
pub struct Motions {
    /// `Psi`, `points x motions`: opening by a unit of each motion; -1 at all points for an approach.
    pub opening: Mat<f64>,
    /// `Psi_t`, `points x motions`: slip by a unit of each motion; read only where there is shear.
    pub slip: Mat<f64>,
    /// `K`, `motions x motions`, symmetric: stiffness of supports and springs, zero for free rigid motions.
    pub stiffness: Mat<f64>,
}

impl Motions {
    /// No motions: the compliance holds the bodies.
    pub fn none(points: usize) -> Motions {
        Motions::free(Mat::zeros(points, 0), Mat::zeros(points, 0))
    }

    /// Motions without stiffness, by the opening and the slip (`points x motions`) they make.
    pub fn free(opening: Mat<f64>, slip: Mat<f64>) -> Motions {
        let count = opening.ncols();
        Motions { opening, slip, stiffness: Mat::zeros(count, count) }
    }
}

/// A contact as plain matrices, for compliances that no body of `hpfem` stands behind; the solvers are those of [`ContactOperator`].
///
/// At `n` points, with nodal normal forces `lambda >= 0` and nodal shear forces `sigma` on body 1 (traction times the point's weight) and
/// motions `y`:
///
/// ```text
/// opening = gap + C lambda + C_nt sigma + Psi y >= 0,   lambda . opening = 0
/// slip    = C_nt^T lambda + C_tt sigma + Psi_t y
/// K y     = forces + Psi^T lambda + Psi_t^T sigma
/// ```
///
/// Any consistent units. A prescribed motion `y` belongs to the gap, `gap + Psi y`, and to the slip before, `slip_before - Psi_t y`.
#[derive(Clone, Debug)]
pub struct MatrixContact {
    matrices: Matrices,
    stiffness: Mat<f64>,
    guided: Vec<bool>,
    weights: Vec<f64>,
}

/// Solution of a [`MatrixContact`]; arrays hold one value a contact point.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct MatrixSolution {
    /// How the solve ended.
    pub status: Status,
    /// Pressure, at least 0 in compression: nodal force over weight.
    pub pressure: Vec<f64>,
    /// Shear traction on body 1 along the point's tangent.
    pub shear: Vec<f64>,
    /// Nodal normal force `lambda`.
    pub nodal_force: Vec<f64>,
    /// Nodal shear force `sigma`.
    pub nodal_shear: Vec<f64>,
    /// Opening, zero in contact.
    pub opening: Vec<f64>,
    /// Slip; empty for a compliance without shear.
    pub slip: Vec<f64>,
    /// State of each point; without friction, points in contact count as sticking.
    pub states: Vec<ContactState>,
    /// Whether the point is in contact.
    pub closed: Vec<bool>,
    /// Motions `y`.
    pub motions: Vec<f64>,
    /// Largest relative violation of `p >= 0`, `opening >= 0`, `p opening = 0`.
    pub complementarity: f64,
    /// Largest relative residual of the balances of the motions; the drag along a motion that nothing resists is left to a guide, and not counted.
    pub balance: f64,
    /// Linear systems solved.
    pub iterations: usize,
    /// Whether the exact active-set method had to take over from the augmented Lagrangian.
    pub took_over: bool,
}

impl MatrixContact {
    /// A contact of a compliance: the relative displacement of body 1 against body 2 at the points by unit forces there, the sum over both
    /// bodies. For `n` weights it is `n x n`, along the normals, or, for friction, `2n x 2n`, along the `n` normals, then the `n` tangents:
    /// `[C, C_nt; C_nt^T, C_tt]`. A weight is the area of the surface that belongs to a point.
    ///
    /// The compliance need not be positive definite as a whole: that of a half-plane is so only up to a constant, which an approach takes up.
    ///
    /// # Errors
    /// [`Error::Shape`], [`Error::NotFinite`], [`Error::NotSymmetric`], [`Error::NotPositive`] (a weight, or an entry on the diagonal), with the
    /// name of the matrix.
    pub fn from_compliance(compliance: &Mat<f64>, weights: &[f64], motions: &Motions) -> Result<MatrixContact, Error> {
        let n = weights.len();
        positive("weights", weights.iter().copied())?;
        let shear = n > 0 && compliance.nrows() == 2 * n;
        let compliance = symmetric("compliance", compliance, if shear { 2 * n } else { n })?;
        positive("compliance", (0..compliance.nrows()).map(|i| compliance[(i, i)]))?;
        let count = motions.opening.ncols();
        sized("opening by the motions", &motions.opening, [n, count])?;
        sized("slip by the motions", &motions.slip, [n, count])?;
        let stiffness = symmetric("stiffness of the motions", &motions.stiffness, count)?;
        let block = |i: usize, j: usize| compliance.submatrix(i * n, j * n, n, n).to_owned();
        let matrices = Matrices {
            normal: block(0, 0),
            normal_by_shear: shear.then(|| block(0, 1)),
            tangential: shear.then(|| block(1, 1)),
            influence: motions.opening.clone(),
            shear_influence: shear.then(|| motions.slip.clone()),
        };
        Ok(MatrixContact { matrices, stiffness, guided: vec![false; count], weights: weights.to_vec() })
    }

    /// A contact of a stiffness: nodal forces by unit displacements of the points, in the order of [`MatrixContact::from_compliance`], which takes
    /// its inverse. Of two elastic bodies the compliances add up, not the stiffnesses.
    ///
    /// # Errors
    /// [`Error::NotDefinite`], and as [`MatrixContact::from_compliance`].
    pub fn from_stiffness(stiffness: &Mat<f64>, weights: &[f64], motions: &Motions) -> Result<MatrixContact, Error> {
        let n = weights.len();
        let size = if n > 0 && stiffness.nrows() == 2 * n { 2 * n } else { n };
        let stiffness = symmetric("stiffness", stiffness, size)?;
        let factor = stiffness.llt(Side::Lower).map_err(|_| Error::NotDefinite)?;
        let inverse = factor.solve(Mat::<f64>::identity(size, size));
        let compliance = Mat::from_fn(size, size, |i, j| 0.5 * (inverse[(i, j)] + inverse[(j, i)]));
        MatrixContact::from_compliance(&compliance, weights, motions)
    }

    /// Number of contact points.
    pub fn points(&self) -> usize {
        self.weights.len()
    }

    /// Whether the compliance has shear, which friction needs.
    pub fn has_shear(&self) -> bool {
        self.matrices.tangential.is_some()
    }

    /// Solves for a gap (one value a point, positive open) under forces (one a motion), from an earlier solution if there is one.
    ///
    /// # Errors
    /// [`Error::Gap`], [`Error::Drag`], [`Error::ShearNotPrepared`]; [`Error::Shape`] and [`Error::NotFinite`] for forces or an earlier solution
    /// that do not fit.
    pub fn solve(
        &self,
        gap: &[f64],
        forces: &[f64],
        friction: &Friction,
        warm_start: Option<&MatrixSolution>,
    ) -> Result<MatrixSolution, Error> {
        let plain = self.plain(gap, forces, friction)?;
        let warm = warm_start.map(|solution| self.warm(solution)).transpose()?;
        let ending = plain.solve(friction, warm, &|mu, read| self.with_friction([gap, forces], friction, mu, read))?;
        Ok(self.solution(ending))
    }

    /// The contact with its shear in the compliance, for laws that add to it (wear).
    ///
    /// # Errors
    /// As [`MatrixContact::solve`].
    pub fn system(&self, forces: &[f64], friction: &Friction) -> Result<ContactSystem, Error> {
        Ok(ContactSystem::of(self.plain(&vec![0.0; self.points()], forces, friction)?.problem))
    }

    fn plain(&self, gap: &[f64], forces: &[f64], friction: &Friction) -> Result<Plain<'_>, Error> {
        let n = self.points();
        if gap.len() != n || gap.iter().any(|g| !g.is_finite()) {
            return Err(Error::Gap { given: gap.len(), points: n });
        }
        let count = self.guided.len();
        listed("forces along the motions", forces, count)?;
        let unloaded = Unloaded { opening: gap.to_vec(), slip: vec![0.0; n], forces: forces.to_vec() };
        let held = Held { stiffness: self.stiffness.clone(), free: (0..count).collect(), guided: self.guided.clone() };
        Plain::new(&self.matrices, friction, unloaded, &held)
    }

    /// Gives the problem of another coefficient of friction to `read`.
    fn with_friction(&self, acting: [&[f64]; 2], friction: &Friction, mu: f64, read: &mut dyn FnMut(&Complementarity<'_>)) {
        let Friction::Sliding { drag, .. } = friction else { return };
        let friction = Friction::Sliding { coefficient: mu, drag: drag.clone() };
        if let Ok(plain) = self.plain(acting[0], acting[1], &friction) {
            read(&plain.problem);
        }
    }

    fn warm<'s>(&self, solution: &'s MatrixSolution) -> Result<Warm<'s>, Error> {
        let point = Point { force: solution.nodal_force.clone(), coordinates: solution.motions.clone() };
        let MatrixSolution { nodal_shear, closed, states, .. } = solution;
        Warm { point, shear: nodal_shear, closed, states }.fitting(self.points(), self.guided.len())
    }

    fn solution(&self, ending: Ending) -> MatrixSolution {
        let over_weight = |v: &[f64]| v.iter().zip(&self.weights).map(|(v, w)| v / w).collect::<Vec<f64>>();
        let (force, motions) = (ending.point.force, ending.point.coordinates);
        let matrices = &self.matrices;
        let mut slip = Vec::new();
        if let (Some(by_shear), Some(tangential), Some(sliding)) =
            (&matrices.normal_by_shear, &matrices.tangential, &matrices.shear_influence)
        {
            slip = transposed_times(by_shear, &force);
            add(&mut slip, &times(tangential, &ending.shear));
            add(&mut slip, &times(sliding, &motions));
        }
        MatrixSolution {
            status: ending.status,
            pressure: over_weight(&force),
            shear: over_weight(&ending.shear),
            nodal_force: force,
            nodal_shear: ending.shear,
            opening: ending.opening,
            slip,
            closed: ending.states.iter().map(|s| *s != ContactState::Open).collect(),
            states: ending.states,
            motions,
            complementarity: ending.complementarity,
            balance: ending.balance,
            iterations: ending.iterations,
            took_over: ending.took_over,
        }
    }
}

impl ContactOperator<'_> {
    /// The contact as plain matrices, its motions those that the load leaves free, and what the load does before any contact force acts: the gap
    /// of the matrices is the gap plus `opening`, their slip before the slip before less `slip`, their forces `forces`.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn matrices(&self, load: &ContactLoad) -> Result<(MatrixContact, Unloaded), Error> {
        let n = self.points().len();
        let acting = self.acting(&vec![0.0; n], load)?;
        let (held, mut unloaded) = (acting.held, acting.unloaded);
        let pick = |m: &Mat<f64>| Mat::from_fn(n, held.free.len(), |i, j| m[(i, held.free[j])]);
        let all = self.unit.matrices();
        let matrices = Matrices {
            influence: pick(&all.influence),
            shear_influence: all.shear_influence.as_ref().map(pick),
            ..(**all).clone()
        };
        unloaded.forces = held.free.iter().map(|j| unloaded.forces[*j]).collect();
        let count = held.free.len();
        let contact = MatrixContact {
            matrices,
            stiffness: Mat::from_fn(count, count, |i, j| held.stiffness[(held.free[i], held.free[j])]),
            guided: held.free.iter().map(|j| held.guided[*j]).collect(),
            weights: self.points().iter().map(|p| p.weight).collect(),
        };
        Ok((contact, unloaded))
    }
}
