//! What rigid edge, supports, pins and the axis of revolution take of the freedom of vertices and edges.

use crate::boundary::{edge_modes, has_cell_on_left};
use crate::error::Error;
use crate::freedom::{AXIS, FREE, Freedom, Pin, RigidEdge, Support, rigid_rows};
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
        let scale = largest_displacement(problem)?;
        for (number, support) in problem.supports.iter().enumerate() {
            let directions = directions(mesh, support)?;
            for (e, direction) in directions {
                let given = Given { number, support, direction, scale, rigid: problem.rigid_edge.as_ref() };
                holding.hold(mesh, e, edge_degree[e], &given)?;
            }
        }
        holding.pin(&problem.pins, problem.supports.len(), scale)?;
        // A potential need not vanish on the axis.
        if problem.kinematics.has_hoop_strain() {
            holding.hold_axis(mesh, scale)?;
        }
        Ok(holding)
    }

    /// Ties vertices and edges to the rigid edge.
    fn tie(&mut self, mesh: &Mesh, rigid: &RigidEdge) -> Result<(), Error> {
        for e in mesh.boundary(&rigid.boundary)? {
            let [a, b] = mesh.edges[e].vertices;
            [a, b, mesh.vertices.len() + e].iter().for_each(|g| self.freedom[*g].slaved = true);
        }
        Ok(())
    }

    /// Holds an edge of a support and its vertices.
    fn hold(&mut self, mesh: &Mesh, edge: usize, degree: usize, given: &Given<'_>) -> Result<(), Error> {
        let Given { number, support, direction, scale, .. } = *given;
        let values = mesh.edges[edge].vertices.map(|v| support.displacement(mesh.vertices[v]));
        let twice = |what: &str, [x, z]: [f64; 2], [value, known]: [f64; 2]| {
            let (boundary, place) = (support.boundary.clone(), format!("{what}({x:.6}, {z:.6})"));
            Error::HeldTwice { boundary, place, value, known }
        };
        for (v, value) in mesh.edges[edge].vertices.into_iter().zip(values) {
            if self.freedom[v].slaved {
                given.check_tied(mesh.vertices[v], value)?;
                continue;
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
    fn pin(&mut self, pins: &[Pin], supports: usize, scale: f64) -> Result<(), Error> {
        for (number, pin) in pins.iter().enumerate() {
            let d = pin.direction.vector().unwrap_or([1.0, 0.0]);
            if self.freedom[pin.vertex].slaved {
                return Err(Error::TiedAndHeld { boundary: "a pin".into(), place: format!("vertex {}", pin.vertex) });
            }
            let boundary = "a pin".to_string();
            let place = format!("vertex {}", pin.vertex);
            let twice = |known| Error::HeldTwice { boundary, place, value: 0.0, known };
            self.freedom[pin.vertex].fix(d, supports + number, 0.0, scale).map_err(twice)?;
        }
        Ok(())
    }

    /// Holds what lies on the axis of revolution.
    fn hold_axis(&mut self, mesh: &Mesh, scale: f64) -> Result<(), Error> {
        let on_axis = axis_vertices(mesh);
        let vertices = mesh.vertices.len();
        for v in (0..vertices).filter(|v| on_axis[*v]) {
            let twice = |known| {
                let boundary = "the axis of revolution".to_string();
                Error::HeldTwice { boundary, place: format!("vertex {v}"), value: 0.0, known }
            };
            self.freedom[v].fix([1.0, 0.0], AXIS, 0.0, scale).map_err(twice)?;
        }
        for (e, edge) in mesh.edges.iter().enumerate() {
            if edge.vertices.iter().all(|v| on_axis[*v]) && edge.curve.is_straight() {
                self.freedom[vertices + e].fix([1.0, 0.0], AXIS, 0.0, f64::INFINITY).unwrap_or_default();
            }
        }
        Ok(())
    }
}

/// A support on one of its edges.
struct Given<'g> {
    number: usize,
    support: &'g Support,
    /// The direction it holds there.
    direction: [f64; 2],
    /// The largest displacement that any support prescribes, mm.
    scale: f64,
    rigid: Option<&'g RigidEdge>,
}

impl Given<'_> {
    /// Refuses a support that holds a vertex of the rigid edge against one of the edge's free motions, or moves it.
    fn check_tied(&self, x: [f64; 2], value: f64) -> Result<(), Error> {
        let Some(rigid) = self.rigid else { return Ok(()) };
        let rows = rigid_rows(x, rigid.reference);
        let lever = (x[0] - rigid.reference[0]).hypot(x[1] - rigid.reference[1]);
        let size = [1.0, 1.0, lever.max(f64::MIN_POSITIVE)];
        let moves = |k: usize| (rows[k][0] * self.direction[0] + rows[k][1] * self.direction[1]).abs() > 1e-9 * size[k];
        if value != 0.0 || (0..3).any(|k| rigid.free[k] && moves(k)) {
            let place = format!("({:.6}, {:.6})", x[0], x[1]);
            return Err(Error::TiedAndHeld { boundary: self.support.boundary.clone(), place });
        }
        Ok(())
    }
}

/// The largest displacement that supports prescribe at vertices and between them, mm.
fn largest_displacement(problem: &BodyProblem) -> Result<f64, Error> {
    let mesh = &problem.mesh;
    let mut largest = 0.0_f64;
    for support in &problem.supports {
        for e in mesh.boundary(&support.boundary)? {
            let ends = mesh.edges[e].vertices.map(|v| mesh.vertices[v]);
            let between = mesh.edges[e].curve.between_ends().filter(|_| support.varying.is_some());
            for value in ends.into_iter().chain(between).map(|x| support.displacement(x)) {
                if !value.is_finite() {
                    let quantity = format!("the displacement of support \"{}\"", support.boundary);
                    return Err(Error::OutOfRange { quantity, value, range: "finite" });
                }
                largest = largest.max(value.abs());
            }
        }
    }
    Ok(largest)
}

/// The edges of a support, each with the direction in which it is held. Edges in one line share one normal, that of the longest: two that differ by
/// round-off would hold their common vertex in both directions.
fn directions(mesh: &Mesh, support: &Support) -> Result<Vec<(usize, [f64; 2])>, Error> {
    let edges = mesh.boundary(&support.boundary)?;
    if let Some(direction) = support.direction.vector() {
        return Ok(edges.into_iter().map(|e| (e, direction)).collect());
    }
    let cells = mesh.edge_cells();
    let extent = mesh.vertices.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    let mut normals = Vec::new();
    for e in edges {
        if !mesh.edges[e].curve.is_straight() {
            return Err(Error::NotStraight { what: "a support along the normal", boundary: support.boundary.clone() });
        }
        let [p, q] = mesh.edges[e].vertices.map(|v| mesh.vertices[v]);
        let length = (q[0] - p[0]).hypot(q[1] - p[1]);
        // Out of the body: on the right of an edge that has its cell on the left.
        let side = if has_cell_on_left(mesh, cells[e][0]) { 1.0 } else { -1.0 };
        normals.push((e, length, [side * (q[1] - p[1]) / length, -side * (q[0] - p[0]) / length]));
    }
    let mut longest: Vec<(f64, [f64; 2])> = normals.iter().map(|(_, length, n)| (*length, *n)).collect();
    longest.sort_by(|a, b| b.0.total_cmp(&a.0));
    let shared = |(e, length, n): (usize, f64, [f64; 2])| {
        let round_off = 1e-9 + 64.0 * f64::EPSILON * extent / length;
        let alike = |m: &[f64; 2]| m[0] * n[0] + m[1] * n[1] > 0.0 && (m[0] * n[1] - m[1] * n[0]).abs() <= round_off;
        (e, longest.iter().map(|(_, m)| *m).find(alike).unwrap_or(n))
    };
    Ok(normals.into_iter().map(shared).collect())
}

/// Which vertices lie on the axis of revolution, to round-off of the mesh's size.
fn axis_vertices(mesh: &Mesh) -> Vec<bool> {
    let size = mesh.vertices.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    mesh.vertices.iter().map(|x| x[0].abs() <= 1e-14 * size).collect()
}
