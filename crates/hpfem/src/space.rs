//! Degrees of freedom: degrees of cells and edges, and what supports and rigid edges leave of them.

use crate::basis::{BoundaryModes, LocalModes, MAX_DEGREE, SpaceKind};
use crate::error::Error;
use crate::freedom::{AXIS, Freedom, RigidEdge, rigid_rows};
use crate::holding::Holding;
use crate::mesh::Mesh;
use crate::problem::BodyProblem;
use std::collections::HashMap;

/// Numbering of the unknowns. Group `v` belongs to vertex `v`, group `vertices + e` to edge `e`, the last group to the rigid
/// edge.
pub(crate) struct Space {
    pub(crate) components: usize,
    pub(crate) kind: SpaceKind,
    pub(crate) cell_degree: Vec<usize>,
    /// Minimum of the degrees of the cells that share the edge.
    pub(crate) edge_degree: Vec<usize>,
    pub(crate) freedom: Vec<Freedom>,
    /// Freedom of the single modes of those edges along which a prescribed displacement varies.
    mode_freedom: HashMap<usize, Vec<Freedom>>,
    /// Number of active unknowns of each group.
    pub(crate) size: Vec<usize>,
    pub(crate) frame: Option<(usize, RigidEdge)>,
}

/// How one local unknown of a cell hangs on active unknowns.
#[derive(Clone, Debug, Default)]
pub(crate) struct Target {
    /// `(group, index in group, coefficient)`.
    pub(crate) active: Vec<(usize, usize, f64)>,
    /// Prescribed parts.
    pub(crate) fixed: Vec<Fixed>,
}

/// Share of a prescribed component in a local unknown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fixed {
    pub(crate) support: usize,
    pub(crate) value: f64,
    /// The axis of the prescribed component.
    pub(crate) axis: [f64; 2],
    /// Component of the axis along this local unknown.
    pub(crate) share: f64,
    /// Group of the vertex or edge.
    pub(crate) group: usize,
    /// Mode in the group.
    pub(crate) mode: usize,
}

impl Space {
    /// # Errors
    /// Degrees out of range, boundaries that do not exist or are not straight where they must be, displacements that are not finite.
    pub(crate) fn new(problem: &BodyProblem) -> Result<Space, Error> {
        let (mesh, cell_degree, components) = (&problem.mesh, problem.degrees.clone(), problem.kinematics.components());
        if let Some(cell) = (0..mesh.cells.len()).find(|c| !(1..=MAX_DEGREE).contains(&cell_degree[*c])) {
            return Err(Error::Degree { cell, degree: cell_degree[cell] });
        }
        let mut edge_degree = vec![MAX_DEGREE; mesh.edges.len()];
        for (cell, degree) in mesh.cells.iter().zip(&cell_degree) {
            cell.sides().for_each(|(_, e)| edge_degree[e] = edge_degree[e].min(*degree));
        }
        let Holding { freedom, mode_freedom } = Holding::new(problem, &edge_degree)?;
        let vertices = mesh.vertices.len();
        let mut size: Vec<usize> = freedom
            .iter()
            .enumerate()
            .map(|(g, f)| f.free(components) * if g < vertices { 1 } else { edge_degree[g - vertices] - 1 })
            .collect();
        let frame = problem.rigid_edge.as_ref().map(|r| (size.len(), r.clone()));
        size.extend(frame.iter().map(|(_, rigid)| rigid.free.iter().filter(|f| **f).count()));
        Ok(Space { components, kind: problem.space, cell_degree, edge_degree, freedom, mode_freedom, size, frame })
    }

    /// Order of the modes of a cell.
    pub(crate) fn local_modes(&self, mesh: &Mesh, cell: usize) -> LocalModes {
        self.modes_of(mesh, cell, self.edge_degrees(mesh, cell), mesh.cells[cell].against)
    }

    /// Degrees of a cell's four edges; 1, no modes, for the edge that a triangle does not have.
    pub(crate) fn edge_degrees(&self, mesh: &Mesh, cell: usize) -> [usize; 4] {
        mesh.cells[cell].edges.map(|e| e.map_or(1, |e| self.edge_degree[e]))
    }

    /// Boundary modes of a cell.
    pub(crate) fn boundary_modes(&self, mesh: &Mesh, cell: usize) -> BoundaryModes {
        BoundaryModes::new(mesh.cells[cell].vertices().len(), self.edge_degrees(mesh, cell))
    }

    /// Order of the modes of a cell whose edges had the given degrees and directions.
    pub(crate) fn modes_of(&self, mesh: &Mesh, cell: usize, edges: [usize; 4], against: [bool; 4]) -> LocalModes {
        let degree = self.cell_degree[cell];
        if mesh.cells[cell].is_triangle() {
            return LocalModes::triangle(degree, edges, against);
        }
        LocalModes::new(degree, edges, against, self.kind == SpaceKind::Trunk)
    }

    /// Groups of a cell's corners and edges that have unknowns, the rigid edge's group included.
    pub(crate) fn cell_groups(&self, mesh: &Mesh, cell: usize) -> Vec<usize> {
        let c = &mesh.cells[cell];
        let vertices = mesh.vertices.len();
        let mut groups: Vec<usize> = c.vertices().iter().copied().chain(c.sides().map(|(_, e)| vertices + e)).collect();
        if let Some((group, _)) = &self.frame
            && groups.iter().any(|g| self.freedom[*g].slaved)
        {
            groups.push(*group);
        }
        groups.retain(|g| self.size[*g] > 0);
        groups
    }

    /// Whether a support prescribes something on a vertex or edge.
    pub(crate) fn is_supported(&self, group: usize) -> bool {
        self.freedom[group].fixed.iter().flatten().any(|(support, _)| *support != AXIS)
    }

    /// Targets of component `component` of mode `mode` (0 for a vertex value) of a vertex or edge group.
    pub(crate) fn target(&self, mesh: &Mesh, group: usize, mode: usize, component: usize) -> Target {
        let mut target = Target::default();
        let freedom = &self.freedom[group];
        let is_vertex = group < mesh.vertices.len();
        if freedom.slaved {
            if let (true, Some((frame, rigid))) = (is_vertex, &self.frame) {
                let x = mesh.vertices[group];
                let rows = rigid_rows(x, rigid.reference);
                let mut index = 0;
                for (k, row) in rows.iter().enumerate() {
                    if rigid.free[k] {
                        if row[component] != 0.0 {
                            target.active.push((*frame, index, row[component]));
                        }
                        index += 1;
                    }
                }
            }
            return target;
        }
        let free = freedom.free(self.components);
        let fixed = self.mode_freedom.get(&group).and_then(|modes| modes.get(mode)).unwrap_or(freedom).fixed;
        for (axis, fixed) in fixed.into_iter().enumerate().take(self.components) {
            let share = freedom.axes[axis][component];
            if share == 0.0 {
                continue;
            }
            match fixed {
                Some((AXIS, _)) => {}
                None => target.active.push((group, mode * free + freedom.index(axis), share)),
                Some((support, value)) => {
                    target.fixed.push(Fixed { support, value, axis: freedom.axes[axis], share, group, mode });
                }
            }
        }
        target
    }
}
