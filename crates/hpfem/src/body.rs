//! A body: mesh, material, supports and loads, reduced to its kept boundary.

use crate::additions::Additions;
use crate::assemble::{Assembly, LoadCase, edge_modes, points_for, rotation_about_origin};
use crate::basis::Table;
use crate::cell_matrix::map_cells;
use crate::check::unit_of_stiffness;
use crate::elimination::{Condensed, not_held};
use crate::error::Error;
use crate::field::Field;
use crate::interface::{InterfaceOperator, InterfaceState};
use crate::loads::edge_loads;
use crate::material::{Kinematics, Material};
use crate::mesh::Mesh;
use crate::plan::MEMORY_LIMIT;
use crate::rigid::{free_motions, rigid_columns};
use crate::sizes::{Ordered, whole_size};
use crate::space::{RigidEdge, Space, SpaceKind, Support};
use crate::trace::{Trace, TraceLoad};
use crate::triangle_matrix::TriangleTable;
use faer::Mat;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// The problem of one body.
pub struct BodyProblem<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Degree of every cell, `1..=`[`MAX_DEGREE`](crate::MAX_DEGREE).
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
    /// Load cases.
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
    /// Memory that the elimination was estimated to hold at once, bytes; bodies are refused by this number.
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
        let start = Instant::now();
        let Ordered { space, walk, kept_groups, plan, bytes } = Ordered::new(&problem, &additions)?;
        let (mesh, supports) = (problem.mesh, problem.supports);
        let foundations = additions.foundation_edges(mesh)?;
        if bytes > MEMORY_LIMIT {
            return Err(Error::TooLarge { unknowns: space.size.iter().sum(), bytes, limit: MEMORY_LIMIT });
        }
        let ordered = start.elapsed();
        let assembly = assembly(&problem, &space, &additions)?;
        let (columns, unit) = (assembly.columns, assembly.unit);
        let shared = assembly.shared_matrices()?;
        let results = map_cells(mesh.cells.len(), |work, c| assembly.cell(c, &plan.rank, &shared, &additions.body_forces, work));
        let mut elements = Vec::with_capacity(mesh.cells.len());
        let mut reaction_constant = Mat::zeros(3 * (supports.len() + additions.pins.len()), columns);
        let mut interior_work = Mat::<f64>::zeros(columns, columns);
        let on_foundations = foundations.iter().map(|(e, f)| Ok(assembly.foundation(*e, f, &plan.rank)));
        for result in results.into_iter().chain(on_foundations) {
            let cell = result?;
            if let Some(work) = cell.interior_work {
                let mut part = interior_work.as_mut().submatrix_mut(0, 0, work.nrows(), work.ncols());
                part += &work;
            }
            reaction_constant += &cell.constant;
            elements.push(cell.element);
        }
        let assembled = start.elapsed();
        let mut condensed = plan.run(elements, &space.size, &kept_groups, columns).map_err(|g| not_held(place(mesh, g)))?;
        condensed.work += &interior_work;
        let finite = |m: &Mat<f64>| m.col_iter().all(|c| c.iter().all(|v| v.is_finite()));
        if !(finite(&condensed.rhs) && finite(&condensed.work)) {
            let quantity = "a load, or what is left of it after elimination,".into();
            return Err(Error::OutOfRange { quantity, value: f64::NAN, range: "finite" });
        }
        let factored = start.elapsed();
        let mut offsets = vec![None; space.size.len()];
        let mut unknowns = 0;
        for g in &kept_groups {
            offsets[*g] = Some(unknowns);
            unknowns += space.size[*g];
        }
        let trace = Trace::new(mesh, &space, problem.kinematics, &walk, |g| offsets[g], unknowns);
        let rigid_motions = free_motions(mesh, &space, problem.kinematics, &additions.held(mesh)?);
        let rigid_modes = rigid_columns(mesh, &space, &kept_groups, &rigid_motions, unknowns, problem.kinematics);
        let mut frame = [None; 3];
        if let Some((group, rigid)) = &space.frame {
            let mut next = offsets[*group];
            for (k, slot) in frame.iter_mut().enumerate() {
                if rigid.free[k] {
                    *slot = next;
                    next = next.map(|n| n + 1);
                }
            }
        }
        let interface = InterfaceOperator {
            kinematics: problem.kinematics,
            trace,
            stiffness: faer::Scale(unit) * &condensed.stiffness,
            columns: faer::Scale(unit) * &condensed.rhs,
            work: faer::Scale(unit) * &condensed.work,
            rigid_modes,
            rigid_motions,
            load_cases: problem.load_cases.len(),
            frame,
            reaction_constant: faer::Scale(unit) * reaction_constant,
        };
        let effort = Effort {
            cells: mesh.cells.len(),
            unknowns: whole_size(mesh, &space),
            bytes,
            assemble: assembled - ordered,
            factor: ordered + factored - assembled,
        };
        Ok(Body { interface, effort, problem, additions, space, condensed, kept_groups })
    }

    /// The mesh of the body.
    pub fn mesh(&self) -> &'a Mesh {
        self.problem.mesh
    }

    /// Solves the body alone under the load-case factors (all motions held by supports or kept).
    pub fn solve(&self, cases: &[f64]) -> InterfaceState {
        let factors = self.interface.factors(cases);
        let n = self.interface.stiffness.nrows();
        let load = TraceLoad { unknowns: vec![0.0; n], ..TraceLoad::default() };
        let right = self.interface.right_hand_side(&load, &factors);
        let right = Mat::from_fn(n, 1, |i, _| right[i]);
        let x = self.interface.solve(&right, &self.interface.rigid_modes);
        InterfaceState { unknowns: (0..n).map(|i| x[(i, 0)]).collect(), factors, load }
    }

    /// Recovers the displacement of the whole body.
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
        self.condensed.back_substitute(&mut values, &self.space.size, &state.factors);
        let assembly = assembly(&self.problem, &self.space, &self.additions)?;
        let mesh = self.problem.mesh;
        let coefficients = map_cells(mesh.cells.len(), |work, c| {
            let local = self.space.local_modes(mesh, c);
            let boundary: Vec<f64> = assembly
                .targets(c, &local)
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

fn assembly<'b>(problem: &'b BodyProblem<'_>, space: &'b Space, additions: &'b Additions<'_>) -> Result<Assembly<'b>, Error> {
    let mesh = problem.mesh;
    let unit = unit_of_stiffness(problem);
    let highest = space.cell_degree.iter().copied().max().unwrap_or(0);
    let mut tables = vec![None; highest + 1];
    let mut triangle_tables: Vec<Option<Arc<TriangleTable>>> = vec![None; highest + 1];
    for (cell, degree) in mesh.cells.iter().zip(&space.cell_degree) {
        let points = points_for(*degree);
        if cell.is_triangle() {
            triangle_tables[*degree].get_or_insert_with(|| Arc::new(TriangleTable::new(*degree, points)));
        } else {
            tables[*degree].get_or_insert_with(|| Arc::new(Table::new(*degree, points)));
        }
    }
    let mut rotation = vec![Vec::new(); space.freedom.len()];
    for (g, freedom) in space.freedom.iter().enumerate() {
        if freedom.fixed.iter().all(Option::is_none) {
            continue;
        }
        rotation[g] = match g.checked_sub(mesh.vertices.len()) {
            None => vec![rotation_about_origin(mesh.vertices[g])],
            Some(e) => edge_modes(&mesh.edges[e].curve, space.edge_degree[e], rotation_about_origin),
        };
    }
    Ok(Assembly {
        mesh,
        space,
        kinematics: problem.kinematics,
        materials: problem.materials.iter().map(|m| m.scaled(1.0 / unit)).collect(),
        unit,
        tables,
        triangle_tables,
        edge_loads: edge_loads(mesh, problem.load_cases, &additions.segments)?,
        load_cases: problem.load_cases,
        rotation,
        columns: problem.load_cases.len() + 1 + 3 * (problem.supports.len() + additions.pins.len()),
    })
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
