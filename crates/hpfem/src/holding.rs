//! What rigid edge, supports, pins and the axis of revolution take of the freedom of vertices and edges.

use crate::additions::{Additions, Pin, SupportDisplacement};
use crate::boundary::edge_modes;
use crate::error::Error;
use crate::freedom::{AXIS, Direction, FREE, Freedom, RigidEdge, Support};
use crate::mesh::Mesh;
use crate::problem::BodyProblem;
use std::collections::HashMap;

/// Freedom of all vertices and edges.
pub(crate) struct Holding {
    /// Freedom of each vertex, then of each edge.
    pub(crate) freedom: Vec<Freedom>,
    /// Freedom of the single modes of those edges along which a prescribed displacement varies, by group.
    pub(crate) mode_freedom: HashMap<usize, Vec<Freedom>>,
}

impl Holding {
    /// What a problem holds on edges of the given degrees.
    ///
    /// # Errors
    /// Boundaries that do not exist or are not straight where they must be, displacements that are not finite.
    pub(crate) fn new(problem: &BodyProblem<'_>, additions: &Additions<'_>, edge_degree: &[usize]) -> Result<Holding, Error> {
        let mesh = problem.mesh;
        let freedom = vec![FREE; mesh.vertices.len() + mesh.edges.len()];
        let mut holding = Holding { freedom, mode_freedom: HashMap::new() };
        if let Some(rigid) = &problem.rigid_edge {
            holding.tie(mesh, rigid)?;
        }
        for (number, support) in problem.supports.iter().enumerate() {
            let varying = additions.displacements.iter().filter(|d| d.support == number).collect();
            let given = Given { number, support, varying };
            for e in mesh.boundary(&support.boundary)? {
                holding.hold(mesh, e, edge_degree[e], &given)?;
            }
        }
        holding.pin(&additions.pins, problem.supports.len());
        if problem.kinematics.is_revolved() {
            holding.hold_axis(mesh);
        }
        Ok(holding)
    }

    /// Ties vertices and edges to the rigid edge.
    fn tie(&mut self, mesh: &Mesh, rigid: &RigidEdge) -> Result<(), Error> {
        let edges = mesh.boundary(&rigid.boundary)?;
        if edges.iter().any(|e| !mesh.edges[*e].curve.is_straight()) {
            return Err(Error::NotStraight { what: "a rigid edge", boundary: rigid.boundary.clone() });
        }
        for e in edges {
            let [a, b] = mesh.edges[e].vertices;
            [a, b, mesh.vertices.len() + e].iter().for_each(|g| self.freedom[*g].slaved = true);
        }
        Ok(())
    }

    /// Holds an edge of a support and its vertices.
    fn hold(&mut self, mesh: &Mesh, edge: usize, degree: usize, given: &Given<'_, '_>) -> Result<(), Error> {
        let direction = direction(mesh, given.support, edge)?;
        for v in mesh.edges[edge].vertices {
            let value = given.displacement(mesh.vertices[v]);
            if !value.is_finite() {
                let quantity = format!("the displacement of support \"{}\" at vertex {v}", given.support.boundary);
                return Err(Error::OutOfRange { quantity, value, range: "finite" });
            }
            self.freedom[v].fix(direction, given.number, value);
        }
        let group = mesh.vertices.len() + edge;
        // Modes of an edge follow the same axes with values of their own.
        if !given.varying.is_empty() {
            self.mode_freedom.entry(group).or_insert_with(|| vec![self.freedom[group]; degree - 1]);
        }
        if let Some(modes) = self.mode_freedom.get_mut(&group) {
            let values = match given.varying.is_empty() {
                true => vec![[0.0; 2]; modes.len()],
                false => edge_modes(&mesh.edges[edge].curve, degree, |x| [given.displacement(x), 0.0]),
            };
            modes.iter_mut().zip(values).for_each(|(mode, value)| mode.fix(direction, given.number, value[0]));
        }
        self.freedom[group].fix(direction, given.number, 0.0);
        Ok(())
    }

    /// Holds pinned vertices; their reactions follow those of the supports.
    fn pin(&mut self, pins: &[Pin], supports: usize) {
        for (number, pin) in pins.iter().enumerate() {
            let d = if pin.direction == Direction::Second { [0.0, 1.0] } else { [1.0, 0.0] };
            self.freedom[pin.vertex].fix(d, supports + number, 0.0);
        }
    }

    /// Holds what lies on the axis of revolution.
    fn hold_axis(&mut self, mesh: &Mesh) {
        let on_axis = axis_vertices(mesh);
        let vertices = mesh.vertices.len();
        for v in (0..vertices).filter(|v| on_axis[*v]) {
            self.freedom[v].fix([1.0, 0.0], AXIS, 0.0);
        }
        for (e, edge) in mesh.edges.iter().enumerate() {
            if edge.vertices.iter().all(|v| on_axis[*v]) && edge.curve.is_straight() {
                self.freedom[vertices + e].fix([1.0, 0.0], AXIS, 0.0);
            }
        }
    }
}

/// A support with its number and the displacements that vary along it.
struct Given<'g, 'a> {
    number: usize,
    support: &'g Support,
    varying: Vec<&'g SupportDisplacement<'a>>,
}

impl Given<'_, '_> {
    /// The prescribed displacement at a place, mm.
    fn displacement(&self, x: [f64; 2]) -> f64 {
        self.support.value + self.varying.iter().map(|d| (d.displacement)(x)).sum::<f64>()
    }
}

/// Direction in which a support holds one of its edges.
fn direction(mesh: &Mesh, support: &Support, edge: usize) -> Result<[f64; 2], Error> {
    match support.direction {
        Direction::First => Ok([1.0, 0.0]),
        Direction::Second => Ok([0.0, 1.0]),
        Direction::Normal if !mesh.edges[edge].curve.is_straight() => {
            Err(Error::NotStraight { what: "a support along the normal", boundary: support.boundary.clone() })
        }
        Direction::Normal => {
            let [p, q] = mesh.edges[edge].vertices.map(|v| mesh.vertices[v]);
            let length = (q[0] - p[0]).hypot(q[1] - p[1]);
            Ok([(q[1] - p[1]) / length, -(q[0] - p[0]) / length])
        }
    }
}

/// Which vertices lie on the axis of revolution, to round-off of the mesh's size.
fn axis_vertices(mesh: &Mesh) -> Vec<bool> {
    let size = mesh.vertices.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    mesh.vertices.iter().map(|x| x[0].abs() <= 1e-14 * size).collect()
}
