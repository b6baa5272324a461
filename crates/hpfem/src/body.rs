//! A body: mesh, material, supports and loads, reduced to its kept boundary.

use crate::assembly::Assembly;
use crate::basis::LocalModes;
use crate::cell_heat::CellHeats;
use crate::cell_matrix::map_cells;
use crate::edge_load::Loads;
use crate::effort::{Clock, Effort, still};
use crate::elimination::{Condensed, Forward};
use crate::error::Error;
use crate::field::{Field, FieldParts};
use crate::interface::{InterfaceOperator, InterfaceState};
use crate::interiors::Interiors;
use crate::kept::Kept;
use crate::known_heat::TemperatureCase;
use crate::mesh::Mesh;
use crate::problem::BodyProblem;
use crate::reduce::{Keep, Reduction, reduce};
use crate::rigid::motion_words;
use crate::space::{Space, Target};
use crate::trace::TraceLoad;
use faer::Mat;
use std::sync::Arc;

/// A body whose interior is eliminated. It owns its problem, can be sent to a thread, and is cheap to clone but for its interface
/// operator: the factors are shared.
#[derive(Clone)]
pub struct Body {
    /// The reduced body.
    pub interface: InterfaceOperator,
    /// Sizes and times of the reduction.
    pub effort: Effort,
    /// The problem, with the load cases added later.
    pub(crate) problem: BodyProblem,
    pub(crate) factored: Arc<Factored>,
    /// The load cases added after the factorisation, which follow those it was made with.
    pub(crate) added: Vec<Arc<Forward>>,
}

/// What is known once a body is factorised.
pub(crate) struct Factored {
    pub(crate) space: Space,
    pub(crate) condensed: Condensed,
    pub(crate) kept: Kept,
    /// Number of load cases at the time.
    pub(crate) cases: usize,
    /// What the temperatures that it was made for do to its cells.
    pub(crate) heats: Option<CellHeats>,
    /// How the interiors of its cells follow from their boundaries, where that was kept.
    pub(crate) interiors: Option<Interiors>,
    /// Tells it from all others.
    pub(crate) identity: Arc<()>,
}

impl Body {
    /// Assembles the body and eliminates everything but the kept boundary and the rigid edge.
    ///
    /// # Errors
    /// Unknown boundary names, folded cells, degrees out of range, displacements that contradict each other, a body that nothing holds;
    /// [`Error::TouchingApart`] or [`Error::Pieces`] for one held in part alone, since its cells share no edge where they touch.
    pub fn new(problem: BodyProblem) -> Result<Body, Error> {
        Body::timed(problem, still)
    }

    /// As [`Body::new`]; [`Body::effort`] holds the seconds that the two parts of the reduction take by `clock`.
    ///
    /// # Errors
    /// As for [`Body::new`].
    pub fn timed(problem: BodyProblem, clock: Clock) -> Result<Body, Error> {
        let reduction = reduce(&problem, Keep::Fronts, clock, None)?;
        Ok(Body::of(problem, reduction))
    }

    /// As [`Body::timed`], for a body that temperatures of another one are to load, by the thermal expansion of each material (1/K): [`Body::heated`] then
    /// takes what it finds here, and gives the same numbers without it. Temperatures that are `known` already take less, but serve for themselves alone.
    ///
    /// # Errors
    /// As for [`Body::new`], and those of a temperature as for [`Body::heated`].
    pub fn for_heat(
        problem: BodyProblem,
        temperature: &Body,
        known: Option<&[TemperatureCase]>,
        expansion: &[f64],
        clock: Clock,
    ) -> Result<Body, Error> {
        let reduction = reduce(&problem, Keep::Fronts, clock, Some(temperature.warm(known, expansion)?))?;
        Ok(Body::of(problem, reduction))
    }

    /// As [`Body::timed`], for a body of temperature that is to load another one: how the inside of each cell follows from its boundary is kept, which takes
    /// memory, and [`Body::for_heat`], [`Body::heated`] and [`Body::field`] take less time with it.
    ///
    /// # Errors
    /// As for [`Body::new`].
    pub fn of_temperature(problem: BodyProblem, clock: Clock) -> Result<Body, Error> {
        let reduction = reduce(&problem, Keep::Interiors, clock, None)?;
        Ok(Body::of(problem, reduction))
    }

    fn of(problem: BodyProblem, reduction: Reduction) -> Body {
        let Reduction { interface, effort, space, condensed, kept, heats, interiors } = reduction;
        let cases = problem.load_cases.len();
        let factored = Arc::new(Factored { space, condensed, kept, cases, heats, interiors, identity: Arc::default() });
        Body { interface, effort, problem, factored, added: Vec::new() }
    }

    /// The interface operator alone, without what it takes to recover displacements inside: the factors of the fronts are dropped as the
    /// elimination goes on, which takes less memory. It is refused by the same estimate, which counts them.
    ///
    /// # Errors
    /// As for [`Body::new`].
    pub fn interface(problem: &BodyProblem) -> Result<(InterfaceOperator, Effort), Error> {
        Body::interface_timed(problem, still)
    }

    /// As [`Body::interface`], with the seconds that the two parts of the reduction take by `clock`.
    ///
    /// # Errors
    /// As for [`Body::new`].
    pub fn interface_timed(problem: &BodyProblem, clock: Clock) -> Result<(InterfaceOperator, Effort), Error> {
        let reduction = reduce(problem, Keep::Interface, clock, None)?;
        Ok((reduction.interface, reduction.effort))
    }

    /// The problem of the body, with the load cases added later.
    pub fn problem(&self) -> &BodyProblem {
        &self.problem
    }

    /// The mesh of the body.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.problem.mesh
    }

    /// Solves the body alone under load cases by name, each with its factor; cases not named do not act. All motions are held by
    /// supports, or the loads balance: then the answer has no part of a rigid motion, as far as the kept unknowns tell.
    ///
    /// # Errors
    /// [`Error::NoSuchLoadCase`]; [`Error::OutOfRange`] for a factor that is not finite, and for factors under which displacements or their work are beyond all
    /// numbers; [`Error::Unbalanced`] if the loads work on a motion that nothing holds.
    pub fn solve(&self, cases: &[(&str, f64)]) -> Result<InterfaceState, Error> {
        let factors = self.interface.factors(cases)?;
        let n = self.interface.stiffness.nrows();
        let load = TraceLoad { unknowns: vec![0.0; n], ..TraceLoad::default() };
        let right = self.interface.right_hand_side(&load, &factors);
        let state = InterfaceState { unknowns: self.interface.solve_one(&right), factors, load };
        self.check_size(&right, &state)?;
        self.check_balance(&right, &state)?;
        Ok(state)
    }

    /// Refuses factors whose loads, displacements or work are beyond all numbers.
    fn check_size(&self, right: &[f64], state: &InterfaceState) -> Result<(), Error> {
        let interface = &self.interface;
        let acting: Vec<usize> = (0..interface.load_cases.len()).filter(|k| state.factors[*k] != 0.0).collect();
        // Work between temperatures is not computed.
        let known = acting.iter().all(|k| acting.iter().all(|l| !interface.work[(*k, *l)].is_nan()));
        let work = known.then(|| 2.0 * interface.strain_energy(state));
        let wrong = right.iter().chain(&state.unknowns).copied().chain(work).find(|value| !value.is_finite());
        wrong.map_or(Ok(()), |value| {
            let largest = acting.iter().fold(0.0_f64, |m, k| m.max(state.factors[*k].abs()));
            let quantity = format!("a load, displacement or work under factors of load cases up to {largest:e}");
            Err(Error::OutOfRange { quantity, value, range: "finite" })
        })
    }

    /// Refuses loads that work on a motion `m` that nothing holds, beyond what quadrature and the space leave. A turn of curved cells is
    /// not in the space: its image has the energy `m . S m`, and by Cauchy and Schwarz balanced loads work on it by no more than the
    /// product of the energy norms of the image and of the answer.
    fn check_balance(&self, right: &[f64], state: &InterfaceState) -> Result<(), Error> {
        let interface = &self.interface;
        let modes = &interface.rigid_modes;
        // The size of the loads, by what they do to the body held at its kept unknowns and by what is left on those.
        let inner: f64 = state.factors.iter().enumerate().map(|(k, a)| a * a * interface.work[(k, k)]).sum();
        let stiff = (0..right.len()).fold(0.0_f64, |m, i| m.max(interface.stiffness[(i, i)]));
        let strained = modes.transpose() * &interface.stiffness * modes;
        let work = 2.0 * interface.strain_energy(state).abs();
        for (k, motion) in interface.rigid_motions.iter().enumerate() {
            let image = (work * strained[(k, k)].max(0.0)).sqrt();
            let products = right.iter().enumerate().map(|(i, f)| f * modes[(i, k)]);
            let (load, size) = products.fold((0.0, 0.0), |(sum, size), p| (sum + p, size + p.abs()));
            let largest = (0..right.len()).fold(0.0_f64, |m, i| m.max(modes[(i, k)].abs()));
            if load.abs() > 2.0 * image + 1e-6 * size.max(inner.max(0.0).sqrt() * stiff.sqrt() * largest) {
                let motion = motion_words(interface.kinematics, std::slice::from_ref(motion));
                return Err(Error::Unbalanced { motion, load });
            }
        }
        Ok(())
    }

    /// Recovers the displacement of the whole body, mm, in a state of its kept unknowns.
    ///
    /// # Errors
    /// As for [`Body::new`]; cells are assembled again. [`Error::OtherLoads`] for a state from before a load was added, [`Error::Count`] for one of
    /// another body.
    pub fn field(&self, state: &InterfaceState) -> Result<Field, Error> {
        let mut fields = self.fields(std::slice::from_ref(state))?;
        Ok(fields.remove(0))
    }

    /// The same for several states; each cell is assembled once for all of them. Prescribed displacements count by their factor, so that a state
    /// with the factor 0 is what its loads alone add to another one.
    ///
    /// # Errors
    /// As for [`Body::field`].
    pub fn fields(&self, states: &[InterfaceState]) -> Result<Vec<Field>, Error> {
        let values = states.iter().map(|state| self.group_values(state)).collect::<Result<Vec<_>, Error>>()?;
        let space = &self.factored.space;
        let prescribed = self.interface.prescribed_column();
        let mesh = &*self.problem.mesh;
        let loads = Loads::new(mesh, &self.problem.load_cases)?;
        let assembly = Assembly::new(&self.problem, space, loads);
        let coefficients = map_cells(mesh.cells.len(), |work, c| {
            let targets = assembly.targets(c, &space.boundary_modes(mesh, c));
            let boundary = |(values, state): (&Vec<Vec<f64>>, &InterfaceState)| -> Vec<f64> {
                let of = |t: &Target| {
                    let active: f64 = t.active.iter().map(|(g, i, c)| c * values[*g][*i]).sum();
                    active + state.factors[prescribed] * t.fixed.iter().map(|f| f.share * f.value).sum::<f64>()
                };
                targets.iter().map(of).collect()
            };
            let boundaries: Vec<Vec<f64>> = values.iter().zip(states).map(boundary).collect();
            let mut all = assembly.recover((c, self.factored.interiors.as_ref()), &boundaries, work)?;
            if assembly.loads.inside(c) {
                let interior = assembly.inner_load(c, work)?.interior;
                for (u, state) in all.iter_mut().zip(states) {
                    for (i, u) in u.iter_mut().take(interior.nrows()).enumerate() {
                        *u += (0..interior.ncols()).map(|k| state.factors[k] * interior[(i, k)]).sum::<f64>();
                    }
                }
            }
            Ok(all)
        });
        let mut fields: Vec<Vec<(LocalModes, Vec<f64>)>> = vec![Vec::with_capacity(mesh.cells.len()); states.len()];
        for (cell, all) in coefficients.into_iter().collect::<Result<Vec<_>, Error>>()?.into_iter().enumerate() {
            fields.iter_mut().zip(all).for_each(|(field, u)| field.push((space.local_modes(mesh, cell), u)));
        }
        let field = |(cells, state): (Vec<_>, &InterfaceState)| {
            Field::new(FieldParts { problem: &self.problem, space, factors: &state.factors, cells })
        };
        Ok(fields.into_iter().zip(states).map(field).collect())
    }

    /// The unknowns of every group in a state of the kept ones, by back substitution.
    fn group_values(&self, state: &InterfaceState) -> Result<Vec<Vec<f64>>, Error> {
        self.check_state(state)?;
        let values = self.values_of_groups(&[state]);
        Ok(values.into_iter().map(|values| values.col_as_slice(0).to_vec()).collect())
    }

    /// Refuses a state of other loads or of another body.
    pub(crate) fn check_state(&self, state: &InterfaceState) -> Result<(), Error> {
        let (columns, unknowns) = (self.interface.columns.ncols(), self.factored.kept.unknowns);
        if state.factors.len() != columns {
            return Err(Error::OtherLoads { given: state.factors.len(), expected: columns });
        }
        if state.unknowns.len() != unknowns {
            let what = "kept unknowns of the state".into();
            return Err(Error::Count { what, given: state.unknowns.len(), expected: unknowns });
        }
        Ok(())
    }

    /// The same in several states, which are this body's, a column each.
    pub(crate) fn values_of_groups(&self, states: &[&InterfaceState]) -> Vec<Mat<f64>> {
        let columns = self.interface.columns.ncols();
        let Factored { space, condensed, kept, cases, .. } = &*self.factored;
        let many = states.len();
        let mut values: Vec<Mat<f64>> = space.size.iter().map(|size| Mat::zeros(*size, many)).collect();
        let mut at = 0;
        for g in &kept.groups {
            values[*g] = Mat::from_fn(space.size[*g], many, |i, j| states[j].unknowns[at + i]);
            at += space.size[*g];
        }
        // The factorisation knows the load cases of its time, then all other columns.
        let later = *cases..*cases + self.added.len();
        let first: Vec<usize> = (0..columns).filter(|k| !later.contains(k)).collect();
        let mut size = space.size.clone();
        size.push(first.len());
        values.push(Mat::from_fn(first.len(), many, |k, j| -states[j].factors[first[k]]));
        let factors = |k: usize| states.iter().map(|state| state.factors[k]).collect();
        let added: Vec<(Vec<f64>, &Forward)> = later.map(factors).zip(self.added.iter().map(|f| &**f)).collect();
        condensed.back_substitute(&mut values, &size, &added);
        values
    }
}
