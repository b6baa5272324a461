//! A body: mesh, material, supports and loads, reduced to its kept boundary.

use crate::additions::Additions;
use crate::assembly::Assembly;
use crate::cell_matrix::map_cells;
use crate::effort::{Clock, Effort, still};
use crate::elimination::Condensed;
use crate::error::Error;
use crate::field::Field;
use crate::interface::{InterfaceOperator, InterfaceState};
use crate::kept::Kept;
use crate::mesh::Mesh;
use crate::problem::BodyProblem;
use crate::reduce::{Reduction, reduce};
use crate::space::Space;
use crate::trace::TraceLoad;
use faer::Mat;

/// A body whose interior is eliminated.
pub struct Body<'a> {
    /// The reduced body.
    pub interface: InterfaceOperator,
    /// Sizes and times of the reduction.
    pub effort: Effort,
    problem: BodyProblem<'a>,
    additions: Additions<'a>,
    space: Space,
    condensed: Condensed,
    kept: Kept,
}

impl<'a> Body<'a> {
    /// Assembles the body and eliminates everything but the kept boundary and the rigid edge.
    ///
    /// # Errors
    /// Unknown boundary names, folded cells, degrees out of range, a body that nothing holds.
    pub fn new(problem: BodyProblem<'a>) -> Result<Body<'a>, Error> {
        Body::with(problem, Additions::default())
    }

    /// As [`Body::new`], with pins, elastic foundations, body forces, tractions on parts of boundaries and displacements that vary. The strain energy of such a body includes its foundations;
    /// reactions of pins are numbered after those of the supports.
    ///
    /// # Errors
    /// As for [`Body::new`]; pins, load cases or boundaries that do not exist, negative foundations.
    pub fn with(problem: BodyProblem<'a>, additions: Additions<'a>) -> Result<Body<'a>, Error> {
        Body::timed(problem, additions, still)
    }

    /// As [`Body::with`]; [`Body::effort`] holds the seconds that the two parts of the reduction take by `clock`.
    ///
    /// # Errors
    /// As for [`Body::with`].
    pub fn timed(problem: BodyProblem<'a>, additions: Additions<'a>, clock: Clock) -> Result<Body<'a>, Error> {
        let Reduction { interface, effort, space, condensed, kept } = reduce(&problem, &additions, true, clock)?;
        Ok(Body { interface, effort, problem, additions, space, condensed, kept })
    }

    /// The interface operator alone, without what it takes to recover displacements inside: the factors of the fronts are dropped as the
    /// elimination goes on, which takes less memory. It is refused by the same estimate, which counts them.
    ///
    /// # Errors
    /// As for [`Body::new`].
    pub fn interface(problem: &BodyProblem<'_>) -> Result<(InterfaceOperator, Effort), Error> {
        Body::interface_timed(problem, still)
    }

    /// As [`Body::interface`], with the seconds that the two parts of the reduction take by `clock`.
    ///
    /// # Errors
    /// As for [`Body::new`].
    pub fn interface_timed(problem: &BodyProblem<'_>, clock: Clock) -> Result<(InterfaceOperator, Effort), Error> {
        let reduction = reduce(problem, &Additions::default(), false, clock)?;
        Ok((reduction.interface, reduction.effort))
    }

    /// The mesh of the body.
    pub fn mesh(&self) -> &'a Mesh {
        self.problem.mesh
    }

    /// Solves the body alone under the load-case factors, one a load case (all motions held by supports or kept).
    ///
    /// # Panics
    /// With fewer factors than load cases.
    pub fn solve(&self, cases: &[f64]) -> InterfaceState {
        let factors = self.interface.factors(cases);
        let n = self.interface.stiffness.nrows();
        let load = TraceLoad { unknowns: vec![0.0; n], ..TraceLoad::default() };
        let right = self.interface.right_hand_side(&load, &factors);
        let right = Mat::from_fn(n, 1, |i, _| right[i]);
        let x = self.interface.solve(&right, &self.interface.rigid_modes);
        InterfaceState { unknowns: (0..n).map(|i| x[(i, 0)]).collect(), factors, load }
    }

    /// Recovers the displacement of the whole body, mm, in a state of its kept unknowns.
    ///
    /// # Errors
    /// As for [`Body::new`]; cells are assembled again.
    pub fn field(&self, state: &InterfaceState) -> Result<Field<'a>, Error> {
        let mut values: Vec<Vec<f64>> = vec![Vec::new(); self.space.size.len()];
        let mut at = 0;
        for g in &self.kept.groups {
            values[*g] = state.unknowns[at..at + self.space.size[*g]].to_vec();
            at += self.space.size[*g];
        }
        let mut size = self.space.size.clone();
        size.push(state.factors.len());
        values.push(state.factors.iter().map(|f| -f).collect());
        self.condensed.back_substitute(&mut values, &size);
        let assembly = Assembly::new(&self.problem, &self.space, &self.additions, Vec::new());
        let mesh = self.problem.mesh;
        let coefficients = map_cells(mesh.cells.len(), |work, c| {
            let local = self.space.local_modes(mesh, c);
            let boundary: Vec<f64> = assembly
                .targets(c, &self.space.boundary_modes(mesh, c))
                .iter()
                .map(|t| {
                    let active: f64 = t.active.iter().map(|(g, i, c)| c * values[*g][*i]).sum();
                    active + t.fixed.iter().map(|f| f.share * f.value).sum::<f64>()
                })
                .collect();
            let mut u = assembly.recover(c, &boundary, work)?;
            if !assembly.body_forces.is_empty() {
                let interior = assembly.body_load(c, work)?.interior;
                for (i, u) in u.iter_mut().take(interior.nrows()).enumerate() {
                    *u += (0..interior.ncols()).map(|k| state.factors[k] * interior[(i, k)]).sum::<f64>();
                }
            }
            Ok((local, u))
        });
        let coefficients = coefficients.into_iter().collect::<Result<Vec<_>, Error>>()?;
        Ok(Field::new(mesh, self.problem.kinematics, self.problem.materials, &self.space, coefficients))
    }
}
