//! A body: mesh, material, supports and loads, reduced to its kept boundary.

use crate::additions::Additions;
use crate::assemble::{Assembly, LoadCase};
use crate::basis::SpaceKind;
use crate::cell_matrix::{Elements, map_cells};
use crate::elimination::{Condensed, not_held};
use crate::error::Error;
use crate::field::Field;
use crate::freedom::{RigidEdge, Support};
use crate::interface::{InterfaceOperator, InterfaceState};
use crate::material::{Kinematics, Material};
use crate::mesh::Mesh;
use crate::plan::MEMORY_LIMIT;
use crate::rigid::{free_motions, rigid_columns};
use crate::sizes::{Ordered, whole_size};
use crate::space::Space;
use crate::trace::{Trace, TraceLoad};
use faer::Mat;
use std::time::{Duration, Instant};

/// The problem of one body.
pub struct BodyProblem<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Degree of every cell, one a cell, `1..=`[`MAX_DEGREE`](crate::MAX_DEGREE).
    pub degrees: Vec<usize>,
    /// Tensor or trunk space.
    pub space: SpaceKind,
    /// Plane stress, plane strain, axisymmetric or torsion.
    pub kinematics: Kinematics,
    /// Materials, by the index of the cells.
    pub materials: &'a [Material],
    /// Prescribed displacement components.
    pub supports: &'a [Support],
    /// A boundary that moves as a rigid line.
    pub rigid_edge: Option<RigidEdge>,
    /// Load cases; their factors are given later, to [`Body::solve`].
    pub load_cases: &'a [LoadCase<'a>],
    /// Name of the boundary whose unknowns are kept; `None` solves the body alone.
    pub kept: Option<&'a str>,
}

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
    kept_groups: Vec<usize>,
}

/// Sizes and times of a reduction.
#[derive(Clone, Copy, Debug, Default)]
pub struct Effort {
    /// Number of cells.
    pub cells: usize,
    /// Number of unknowns of the whole body.
    pub unknowns: usize,
    /// Memory that the reduction was estimated to hold at once, see [`Sizes::bytes`](crate::Sizes::bytes); bodies are refused by this number.
    pub bytes: u64,
    /// Time to make the element matrices, condense them and prepare the loads.
    pub assemble: Duration,
    /// Time to order and eliminate the skeleton.
    pub factor: Duration,
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
        let Reduction { interface, effort, space, condensed, kept_groups } = reduce(&problem, &additions, true)?;
        Ok(Body { interface, effort, problem, additions, space, condensed, kept_groups })
    }

    /// The interface operator alone, without what it takes to recover displacements inside: the factors of the fronts are dropped as the
    /// elimination goes on, which takes less memory. It is refused by the same estimate, which counts them.
    ///
    /// # Errors
    /// As for [`Body::new`].
    pub fn interface(problem: &BodyProblem<'_>) -> Result<(InterfaceOperator, Effort), Error> {
        let reduction = reduce(problem, &Additions::default(), false)?;
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
        for g in &self.kept_groups {
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
            let forces = &self.additions.body_forces;
            if !forces.is_empty() {
                let interior = assembly.body_load(c, forces, work)?.interior;
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

/// A reduced body, its problem aside.
struct Reduction {
    interface: InterfaceOperator,
    effort: Effort,
    space: Space,
    condensed: Condensed,
    kept_groups: Vec<usize>,
}

/// Reduces a body; `factors` tells whether the factorised fronts are kept.
fn reduce(problem: &BodyProblem<'_>, additions: &Additions<'_>, factors: bool) -> Result<Reduction, Error> {
    let start = Instant::now();
    let ordered = Ordered::new(problem, additions)?;
    let mesh = problem.mesh;
    if ordered.bytes > MEMORY_LIMIT {
        let unknowns = ordered.space.size.iter().sum();
        return Err(Error::TooLarge { unknowns, bytes: ordered.bytes, limit: MEMORY_LIMIT });
    }
    let after_order = start.elapsed();
    let Ordered { space, walk, edge_loads, foundations, congruence, groups, size, kept, plan, bytes } = ordered;
    let assembly = Assembly::new(problem, &space, additions, edge_loads);
    let (columns, unit) = (assembly.columns, assembly.unit);
    let shared = assembly.shared_matrices(congruence)?;
    let forces = &additions.body_forces;
    let results = map_cells(mesh.cells.len(), |work, c| assembly.own_element(c, &groups[c], &shared, forces, work));
    let on_foundations = foundations.iter().zip(&groups[mesh.cells.len()..]);
    let on_foundations = on_foundations.map(|((e, f), groups)| Ok(Some(assembly.foundation(*e, f, groups))));
    let mut own = Vec::with_capacity(groups.len());
    let mut reaction_constant = Mat::zeros(3 * (problem.supports.len() + additions.pins.len()), columns);
    let mut interior_work = Mat::<f64>::zeros(columns, columns);
    for result in results.into_iter().chain(on_foundations) {
        let Some(element) = result? else {
            own.push(None);
            continue;
        };
        if let Some(work) = element.interior_work {
            let mut part = interior_work.as_mut().submatrix_mut(0, 0, work.nrows(), work.ncols());
            part += &work;
        }
        if let Some(constant) = element.constant {
            reaction_constant += &constant;
        }
        own.push(Some(element.matrix));
    }
    let assembled = start.elapsed();
    let mut elements = Elements::new(&assembly, &groups, shared, own);
    let mut condensed = plan.run(&mut elements, &size, &kept, factors).map_err(|g| not_held(place(mesh, g)))?;
    condensed.work += &interior_work;
    let finite = |m: &Mat<f64>| m.col_iter().all(|c| c.iter().all(|v| v.is_finite()));
    if !(finite(&condensed.rhs) && finite(&condensed.work)) {
        let quantity = "a load, or what is left of it after elimination,".into();
        return Err(Error::OutOfRange { quantity, value: f64::NAN, range: "finite" });
    }
    let factored = start.elapsed();
    let kept_groups = kept[..kept.len() - 1].to_vec();
    let mut offsets = vec![None; space.size.len()];
    let mut unknowns = 0;
    for g in &kept_groups {
        offsets[*g] = Some(unknowns);
        unknowns += space.size[*g];
    }
    let trace = Trace::new(mesh, &space, problem.kinematics, &walk, |g| offsets[g], unknowns);
    let rigid_motions = free_motions(mesh, &space, problem.kinematics, &additions.held(mesh)?);
    let rigid_modes = rigid_columns(mesh, &space, &kept_groups, &rigid_motions, unknowns, problem.kinematics);
    let interface = InterfaceOperator {
        kinematics: problem.kinematics,
        trace,
        stiffness: faer::Scale(unit) * &condensed.stiffness,
        columns: faer::Scale(unit) * &condensed.rhs,
        work: faer::Scale(unit) * &condensed.work,
        rigid_modes,
        rigid_motions,
        load_cases: problem.load_cases.len(),
        frame: frame_unknowns(&space, &offsets),
        reaction_constant: faer::Scale(unit) * reaction_constant,
    };
    let effort = Effort {
        cells: mesh.cells.len(),
        unknowns: whole_size(mesh, &space),
        bytes,
        assemble: assembled - after_order,
        factor: after_order + factored - assembled,
    };
    Ok(Reduction { interface, effort, space, condensed, kept_groups })
}

/// Kept unknowns of the free motions of the rigid edge.
fn frame_unknowns(space: &Space, offsets: &[Option<usize>]) -> [Option<usize>; 3] {
    let mut frame = [None; 3];
    if let Some((group, rigid)) = &space.frame {
        let mut next = offsets[*group];
        for (slot, _) in frame.iter_mut().zip(rigid.free).filter(|(_, free)| *free) {
            *slot = next;
            next = next.map(|n| n + 1);
        }
    }
    frame
}

/// Words for the place of a group.
fn place(mesh: &Mesh, group: usize) -> String {
    let at = |x: [f64; 2]| format!("({:.4}, {:.4})", x[0], x[1]);
    match group.checked_sub(mesh.vertices.len()) {
        None => format!("the vertex at {}", at(mesh.vertices[group])),
        Some(e) if e < mesh.edges.len() => {
            format!("the edge around {}", at(mesh.edges[e].curve.point(0.0)))
        }
        Some(_) => "the rigid edge".to_string(),
    }
}
