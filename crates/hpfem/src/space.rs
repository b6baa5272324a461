//! Degrees of freedom: degrees of cells and edges, and what supports and rigid edges leave of them.

use crate::basis::{BoundaryModes, LocalModes, MAX_DEGREE, SpaceKind};
use crate::boundary::edge_modes;
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
    /// Number of the reaction of the rigid edge, if it has one.
    edge_reaction: Option<usize>,
    /// Modes of the curved edges of the rigid edge under its motions `t_x`, `t_z`, `theta`, by group.
    bent: BentModes,
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
        let bent = bent_edges(problem, &edge_degree)?;
        let edge_reaction = problem.reacting_edge();
        let kind = problem.space;
        Ok(Space { components, kind, cell_degree, edge_degree, freedom, mode_freedom, size, frame, edge_reaction, bent })
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

    /// Whether a support prescribes something on a vertex or edge, or the rigid edge with a reaction moves it.
    pub(crate) fn is_supported(&self, group: usize) -> bool {
        let freedom = &self.freedom[group];
        self.reacts(freedom) || freedom.fixed.iter().flatten().any(|(support, _)| *support != AXIS)
    }

    /// Whether what moves with the rigid edge counts for a reaction.
    pub(crate) fn reacts(&self, freedom: &Freedom) -> bool {
        freedom.slaved && self.edge_reaction.is_some()
    }

    /// Targets of component `component` of mode `mode` (0 for a vertex value) of a vertex or edge group.
    pub(crate) fn target(&self, mesh: &Mesh, group: usize, mode: usize, component: usize) -> Target {
        let mut target = Target::default();
        let freedom = &self.freedom[group];
        if freedom.slaved {
            return self.moved_along(mesh, group, mode, component);
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

    /// Target of what moves with the rigid edge.
    fn moved_along(&self, mesh: &Mesh, group: usize, mode: usize, component: usize) -> Target {
        let mut target = Target::default();
        let Some((frame, rigid)) = &self.frame else { return target };
        let rows = if group < mesh.vertices.len() {
            Some(rigid_rows(mesh.vertices[group], rigid.reference))
        } else {
            self.bent.get(&group).and_then(|modes| modes.get(mode)).copied()
        };
        let free = (0..3).filter(|k| rigid.free[*k]);
        for (index, k) in free.enumerate() {
            let share = rows.map_or(0.0, |rows| rows[k][component]);
            if share != 0.0 {
                target.active.push((*frame, index, share));
            }
        }
        if let Some(support) = self.edge_reaction {
            let axis = std::array::from_fn(|k| if k == component { 1.0 } else { 0.0 });
            target.fixed.push(Fixed { support, value: 0.0, axis, share: 1.0, group, mode });
        }
        target
    }
}

/// Of each curved edge of a rigid edge, by its group: the values of its modes under the three motions.
type BentModes = HashMap<usize, Vec<[[f64; 2]; 3]>>;

/// Modes of the curved edges of a rigid edge under its three motions; along a straight one the modes vanish.
fn bent_edges(problem: &BodyProblem, edge_degree: &[usize]) -> Result<BentModes, Error> {
    let mut bent = HashMap::new();
    let (mesh, Some(rigid)) = (&problem.mesh, &problem.rigid_edge) else { return Ok(bent) };
    for e in mesh.boundary(&rigid.boundary)? {
        let curve = &mesh.edges[e].curve;
        if !curve.is_straight() {
            let of = |k: usize| edge_modes(curve, edge_degree[e], |x| rigid_rows(x, rigid.reference)[k]);
            let [x, z, turn] = [of(0), of(1), of(2)];
            let modes = turn.iter().enumerate().map(|(m, turn)| [x[m], z[m], *turn]).collect();
            bent.insert(mesh.vertices.len() + e, modes);
        }
    }
    Ok(bent)
}
