//! What the cells of a body are assembled from.

use crate::basis::{BoundaryModes, points_for};
use crate::boundary::edge_modes;
use crate::check::unit_of_stiffness;
use crate::edge_load::Loads;
use crate::freedom::rotation_about_origin;
use crate::kinematics::Kinematics;
use crate::mesh::Mesh;
use crate::moduli::Moduli;
use crate::problem::BodyProblem;
use crate::space::{Space, Target};
use crate::triangle_matrix::TriangleTable;
use std::sync::Arc;

/// Everything needed to assemble a cell.
pub(crate) struct Assembly<'a> {
    pub(crate) mesh: &'a Mesh,
    pub(crate) space: &'a Space,
    pub(crate) kinematics: Kinematics,
    /// Moduli of the materials in units of `unit`.
    pub(crate) moduli: Vec<Moduli>,
    /// Stiffnesses and loads are divided by this power of two.
    pub(crate) unit: f64,
    pub(crate) triangle_tables: Vec<Option<Arc<TriangleTable>>>,
    pub(crate) loads: Loads<'a>,
    /// Rigid rotation about the origin, modal coefficients of each group with prescribed parts, for the moments of reactions.
    pub(crate) rotation: Vec<Vec<[f64; 2]>>,
    /// Number of right-hand-side columns: load cases, one for prescribed displacements, reactions.
    pub(crate) columns: usize,
}

impl<'a> Assembly<'a> {
    pub(crate) fn new(problem: &'a BodyProblem, space: &'a Space, loads: Loads<'a>) -> Assembly<'a> {
        let mesh = &*problem.mesh;
        let unit = unit_of_stiffness(problem);
        let highest = space.cell_degree.iter().copied().max().unwrap_or(0);
        let mut triangle_tables: Vec<Option<Arc<TriangleTable>>> = vec![None; highest + 1];
        for (cell, degree) in mesh.cells.iter().zip(&space.cell_degree) {
            let points = points_for(*degree);
            if cell.is_triangle() {
                triangle_tables[*degree].get_or_insert_with(|| Arc::new(TriangleTable::new(*degree, points)));
            }
        }
        let mut rotation = vec![Vec::new(); space.freedom.len()];
        for (g, freedom) in space.freedom.iter().enumerate() {
            if freedom.fixed.iter().all(Option::is_none) && !space.reacts(freedom) {
                continue;
            }
            rotation[g] = match g.checked_sub(mesh.vertices.len()) {
                None => vec![rotation_about_origin(mesh.vertices[g])],
                Some(e) => edge_modes(&mesh.edges[e].curve, space.edge_degree[e], rotation_about_origin),
            };
        }
        Assembly {
            mesh,
            space,
            kinematics: problem.kinematics,
            moduli: problem.materials.iter().map(|m| m.scaled(1.0 / unit).moduli(problem.kinematics)).collect(),
            unit,
            triangle_tables,
            columns: loads.cases + problem.columns() - problem.load_cases.len(),
            loads,
            rotation,
        }
    }
}

impl Assembly<'_> {
    /// The group of the right-hand sides, which follows those of the space.
    pub(crate) fn columns_group(&self) -> usize {
        self.space.size.len()
    }

    /// Targets of the cell's local boundary unknowns, components fastest.
    pub(crate) fn targets(&self, cell: usize, modes: &BoundaryModes) -> Vec<Target> {
        let c = &self.mesh.cells[cell];
        let mut targets = Vec::with_capacity(self.space.components * modes.len());
        let mut push = |group, mode| {
            (0..self.space.components).for_each(|k| targets.push(self.space.target(self.mesh, group, mode, k)));
        };
        c.vertices().iter().for_each(|v| push(*v, 0));
        for (local_edge, edge) in c.sides() {
            (0..modes.edge(local_edge).len()).for_each(|m| push(self.mesh.vertices.len() + edge, m));
        }
        targets
    }
}
