//! What rigid edge, supports, pins and the axis of revolution take of the freedom of vertices and edges.

use crate::boundary::edge_modes;
use crate::error::Error;
use crate::freedom::{AXIS, Direction, FREE, Freedom, Pin, RigidEdge, Support};
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
    /// Boundaries that do not exist or are not straight where they must be, displacements that are not finite or contradict each other.
    pub(crate) fn new(problem: &BodyProblem, edge_degree: &[usize]) -> Result<Holding, Error> {
        let mesh = &*problem.mesh;
        let freedom = vec![FREE; mesh.vertices.len() + mesh.edges.len()];
        let mut holding = Holding { freedom, mode_freedom: HashMap::new() };
        if let Some(rigid) = &problem.rigid_edge {
            holding.tie(mesh, rigid)?;
        }
        for (number, support) in problem.supports.iter().enumerate() {
            for e in mesh.boundary(&support.boundary)? {
                holding.hold(mesh, e, edge_degree[e], (number, support))?;
            }
        }
        holding.pin(&problem.pins, problem.supports.len())?;
        // A potential need not vanish on the axis.
        if problem.kinematics.has_hoop_strain() {
            holding.hold_axis(mesh)?;
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

    /// Holds an edge of a support, given with its number, and its vertices.
    fn hold(&mut self, mesh: &Mesh, edge: usize, degree: usize, (number, support): (usize, &Support)) -> Result<(), Error> {
        let direction = direction(mesh, support, edge)?;
        let values = mesh.edges[edge].vertices.map(|v| support.displacement(mesh.vertices[v]));
        let scale = values[0].abs().max(values[1].abs());
        let twice = |what: &str, [x, z]: [f64; 2], [value, known]: [f64; 2]| {
            let (boundary, place) = (support.boundary.clone(), format!("{what}({x:.6}, {z:.6})"));
            Error::HeldTwice { boundary, place, value, known }
        };
        for (v, value) in mesh.edges[edge].vertices.into_iter().zip(values) {
            if !value.is_finite() {
                let quantity = format!("the displacement of support \"{}\" at vertex {v}", support.boundary);
                return Err(Error::OutOfRange { quantity, value, range: "finite" });
            }
            let fixed = self.freedom[v].fix(direction, number, value, scale);
            fixed.map_err(|known| twice("", mesh.vertices[v], [value, known]))?;
        }
        let group = mesh.vertices.len() + edge;
        // Modes of an edge follow the same axes with values of their own.
        if support.varying.is_some() {
            self.mode_freedom.entry(group).or_insert_with(|| vec![self.freedom[group]; degree - 1]);
        }
        if let Some(modes) = self.mode_freedom.get_mut(&group) {
            let curve = &mesh.edges[edge].curve;
            let values = match support.varying.is_none() {
                true => vec![[0.0; 2]; modes.len()],
                false => edge_modes(curve, degree, |x| [support.displacement(x), 0.0]),
            };
            for (mode, [value, _]) in modes.iter_mut().zip(values) {
                let fixed = mode.fix(direction, number, value, scale);
                fixed.map_err(|known| twice("the edge around ", curve.point(0.0), [value, known]))?;
            }
        }
        // The modes of an edge with a constant displacement vanish, whatever holds them first.
        self.freedom[group].fix(direction, number, 0.0, f64::INFINITY).unwrap_or_default();
        Ok(())
    }

    /// Holds pinned vertices; their reactions follow those of the supports.
    fn pin(&mut self, pins: &[Pin], supports: usize) -> Result<(), Error> {
        for (number, pin) in pins.iter().enumerate() {
            let d = if pin.direction == Direction::Second { [0.0, 1.0] } else { [1.0, 0.0] };
            let boundary = "a pin".to_string();
            let place = format!("vertex {}", pin.vertex);
            let twice = |known| Error::HeldTwice { boundary, place, value: 0.0, known };
            self.freedom[pin.vertex].fix(d, supports + number, 0.0, 0.0).map_err(twice)?;
        }
        Ok(())
    }

    /// Holds what lies on the axis of revolution.
    fn hold_axis(&mut self, mesh: &Mesh) -> Result<(), Error> {
        let on_axis = axis_vertices(mesh);
        let vertices = mesh.vertices.len();
        for v in (0..vertices).filter(|v| on_axis[*v]) {
            let twice = |known| {
                let boundary = "the axis of revolution".to_string();
                Error::HeldTwice { boundary, place: format!("vertex {v}"), value: 0.0, known }
            };
            self.freedom[v].fix([1.0, 0.0], AXIS, 0.0, 0.0).map_err(twice)?;
        }
        for (e, edge) in mesh.edges.iter().enumerate() {
            if edge.vertices.iter().all(|v| on_axis[*v]) && edge.curve.is_straight() {
                self.freedom[vertices + e].fix([1.0, 0.0], AXIS, 0.0, f64::INFINITY).unwrap_or_default();
            }
        }
        Ok(())
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
