//! The kept boundary as one path of edges: points, weights and the trace of the displacement.

use crate::boundary::{BoundaryPoint, boundary_point, has_cell_on_left};
use crate::curve::Curve;
use crate::freedom::rigid_rows;
use crate::kept::Kept;
use crate::kinematics::Kinematics;
use crate::legendre::shape_values;
use crate::mesh::Mesh;
use crate::quadrature::{gauss_lobatto, gauss_lobatto_jacobi};
use crate::space::Space;
use faer::Mat;

/// One edge of the path.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TraceEdge {
    /// Index of the edge in [`Mesh::edges`].
    pub edge: usize,
    /// The curve, walked along the path.
    pub curve: Curve,
    /// Degree of the displacement on the edge.
    pub degree: usize,
    /// Whether the edge's own direction is against the path.
    pub(crate) against: bool,
    /// Whether the body lies on the right of the path.
    pub(crate) body_right: bool,
    /// Arc length along the path at the start of the edge, mm.
    pub start: f64,
    /// Kept unknowns of each mode (start vertex, end vertex, modes 2..) and component: `(unknown, coefficient)`.
    unknowns: Vec<Vec<Vec<(usize, f64)>>>,
    /// Prescribed values of the same modes.
    prescribed: Vec<[f64; 2]>,
    /// Prescribed parts of the same modes: `(mode, support, motions)`, the motions being those of [`Trace::support_row`].
    fixed: Vec<(usize, usize, [[f64; 2]; 3])>,
}

/// The kept boundary: edges in order, and the Gauss-Lobatto points where contact is checked.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Trace {
    /// Edges along the path, which runs towards growing first coordinate.
    pub edges: Vec<TraceEdge>,
    /// The points in order along the path; a point shared by two edges is there once.
    pub points: Vec<TracePoint>,
    /// Number of kept unknowns, those of the rigid edge included.
    pub unknowns: usize,
    /// Whether the path ends where it starts; that point is there once, as the first.
    pub closed: bool,
    components: usize,
}

/// A Gauss-Lobatto point of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TracePoint {
    /// Edge of the path, an index into [`Trace::edges`].
    pub edge: usize,
    /// Parameter on the edge in `[-1, 1]`, walked along the path.
    pub parameter: f64,
    /// Arc length from the start of the path, mm.
    pub arc: f64,
    /// Position, normal, tangent.
    pub boundary: BoundaryPoint,
    /// Quadrature weight times the measure: the area that belongs to the point, mm^2, summed over the edges that share it.
    pub weight: f64,
}

impl TraceEdge {
    /// An edge of the path, at its start, with the body on its left.
    fn new(mesh: &Mesh, space: &Space, kept: &Kept, (edge, against): (usize, bool)) -> TraceEdge {
        let own = &mesh.edges[edge];
        let degree = space.edge_degree[edge];
        let curve = if against { own.curve.reversed() } else { own.curve };
        let (unknowns, prescribed, fixed) = (Vec::new(), Vec::new(), Vec::new());
        let mut trace = TraceEdge { edge, curve, degree, against, body_right: false, start: 0.0, unknowns, prescribed, fixed };
        let modes = (0..degree - 1).map(|m| (mesh.vertices.len() + edge, m));
        for (group, mode) in own.vertices.iter().map(|v| (*v, 0)).chain(modes) {
            trace.push_mode(mesh, space, kept, (group, mode));
        }
        trace
    }

    /// Adds what the next mode of the edge, that of a group, hangs on.
    fn push_mode(&mut self, mesh: &Mesh, space: &Space, kept: &Kept, (group, mode): (usize, usize)) {
        let number = self.unknowns.len();
        let mut columns = Vec::new();
        let mut value = [0.0; 2];
        for component in 0..space.components {
            let target = space.target(mesh, group, mode, component);
            let active = target.active.iter().filter_map(|(g, i, c)| kept.start[*g].map(|s| (s + i, *c)));
            columns.push(active.collect());
            value[component] = target.fixed.iter().map(|f| f.share * f.value).sum();
            // A support moved by a unit translation or rotation moves the prescribed part of its vertices alike.
            for part in target.fixed.iter().filter(|_| group < mesh.vertices.len()) {
                let motions = rigid_rows(mesh.vertices[group], [0.0, 0.0]).map(|m| {
                    let mut moved = [0.0; 2];
                    moved[component] = part.share * (part.axis[0] * m[0] + part.axis[1] * m[1]);
                    moved
                });
                self.fixed.push((number, part.support, motions));
            }
        }
        self.unknowns.push(columns);
        self.prescribed.push(value);
    }
}

impl Trace {
    pub(crate) fn new(mesh: &Mesh, space: &Space, kinematics: Kinematics, (kept, walk): (&Kept, &[(usize, bool)])) -> Trace {
        let neighbours = mesh.edge_cells();
        let mut trace = Trace {
            edges: Vec::new(),
            points: Vec::new(),
            unknowns: kept.unknowns,
            closed: is_closed(mesh, walk),
            components: space.components,
        };
        let mut arc = 0.0;
        for (edge, against) in walk {
            let body_right = has_cell_on_left(mesh, neighbours[*edge][0]) == *against;
            let edge = TraceEdge { body_right, start: arc, ..TraceEdge::new(mesh, space, kept, (*edge, *against)) };
            arc += edge.curve.length();
            trace.edges.push(edge);
        }
        trace.place_points(kinematics);
        trace
    }

    /// Gauss-Lobatto points of every edge; on an edge that starts or ends on the axis of revolution Gauss-Lobatto-Jacobi points.
    fn place_points(&mut self, kinematics: Kinematics) {
        for number in 0..self.edges.len() {
            let edge = &self.edges[number];
            let radius = |t: f64| edge.curve.point(t)[0];
            let on_axis = |t: f64| kinematics.is_revolved() && radius(t).abs() <= 1e-12 * radius(-t).abs();
            let [starts, ends] = [-1.0, 1.0].map(on_axis);
            let n = edge.degree + 1;
            let rule = match (starts, ends) {
                (true, _) => gauss_lobatto_jacobi(n),
                (false, true) => gauss_lobatto_jacobi(n).reversed(),
                (false, false) => gauss_lobatto(n),
            };
            for (i, (t, w)) in rule.points.iter().zip(&rule.weights).enumerate() {
                let (boundary, length) = self.boundary_point(number, *t);
                // The Jacobi weight 1 + t or 1 - t already holds the radius: r is that times a smooth factor.
                let factor = match (starts, ends) {
                    (true, _) if i == 0 => edge.curve.derivative(-1.0)[0],
                    (true, _) => radius(*t) / (1.0 + t),
                    (false, true) if i + 1 == n => -edge.curve.derivative(1.0)[0],
                    (false, true) => radius(*t) / (1.0 - t),
                    (false, false) => boundary.position[0],
                };
                let weight = w * length * kinematics.measure(factor);
                let arc = edge.start + edge.curve.length_until(*t);
                if self.closed && number + 1 == self.edges.len() && i + 1 == n {
                    if let Some(first) = self.points.first_mut() {
                        first.weight += weight;
                    }
                } else if i == 0 && number > 0 {
                    if let Some(shared) = self.points.last_mut() {
                        shared.weight += weight;
                    }
                } else {
                    self.points.push(TracePoint { edge: number, parameter: *t, arc, boundary, weight });
                }
            }
        }
    }

    /// Whether all edges name kept unknowns and supports that there are, for all their modes, and all points lie on the edges.
    pub(crate) fn is_sound(&self, components: usize, supports: usize) -> bool {
        let edge = |e: &TraceEdge| {
            let modes = e.unknowns.len();
            let named = e.unknowns.iter().flatten().flatten().all(|(u, _)| *u < self.unknowns);
            let components = e.unknowns.iter().all(|mode| mode.len() == self.components);
            let fixed = e.fixed.iter().all(|(mode, support, _)| *mode < modes && *support < supports);
            named && components && fixed && modes.checked_sub(1) == Some(e.degree) && e.prescribed.len() == modes
        };
        let point = |p: &TracePoint| p.edge < self.edges.len() && p.parameter.abs() <= 1.0 && p.weight >= 0.0;
        self.components == components && self.edges.iter().all(edge) && self.points.iter().all(point)
    }

    /// Total arc length, mm.
    pub fn length(&self) -> f64 {
        self.edges.last().map_or(0.0, |e| e.start + e.curve.length())
    }

    /// The boundary point at parameter `t` of an edge of the path, and the length factor `|dx/dt|`, mm.
    ///
    /// # Panics
    /// For an edge that the path does not have, as all that takes an edge here.
    pub fn boundary_point(&self, edge: usize, t: f64) -> (BoundaryPoint, f64) {
        let e = &self.edges[edge];
        boundary_point(&e.curve, t, e.body_right)
    }

    /// Edge and parameter of the point at arc length `arc` (mm) from the start.
    ///
    /// # Panics
    /// For a body without a kept boundary.
    pub fn locate(&self, arc: f64) -> (usize, f64) {
        let edge = self.edges.partition_point(|e| e.start <= arc).saturating_sub(1);
        let e = &self.edges[edge];
        (edge, e.curve.parameter_at_length(arc - e.start))
    }

    /// The displacement at parameter `t` of an edge as a linear function of the kept unknowns: for each component the pairs
    /// `(unknown, coefficient)`, and the part that is prescribed, mm.
    pub fn displacement_row(&self, edge: usize, t: f64) -> ([Vec<(usize, f64)>; 2], [f64; 2]) {
        let e = &self.edges[edge];
        let own = if e.against { -t } else { t };
        let mut rows = [Vec::with_capacity(e.degree + 1), Vec::with_capacity(e.degree + 1)];
        let mut constant = [0.0; 2];
        for (mode, shape) in shape_values(e.degree, own).enumerate() {
            for component in 0..self.components {
                rows[component].extend(e.unknowns[mode][component].iter().map(|(u, c)| (*u, c * shape)));
                constant[component] += shape * e.prescribed[mode][component];
            }
        }
        (rows, constant)
    }

    /// The displacement at parameter `t` of an edge for given kept unknowns, mm.
    ///
    /// # Panics
    /// For fewer unknowns than the body has.
    pub fn displacement(&self, edge: usize, t: f64, unknowns: &[f64]) -> [f64; 2] {
        let [by_unknowns, prescribed] = self.displacement_parts(edge, t, unknowns);
        std::array::from_fn(|k| by_unknowns[k] + prescribed[k])
    }

    /// The same without what is prescribed, as rigid motions and differences of states have none.
    pub fn relative_displacement(&self, edge: usize, t: f64, unknowns: &[f64]) -> [f64; 2] {
        self.displacement_parts(edge, t, unknowns)[0]
    }

    fn displacement_parts(&self, edge: usize, t: f64, unknowns: &[f64]) -> [[f64; 2]; 2] {
        let e = &self.edges[edge];
        let own = if e.against { -t } else { t };
        let [mut by_unknowns, mut prescribed] = [[0.0; 2]; 2];
        for (mode, shape) in shape_values(e.degree, own).enumerate() {
            for component in 0..self.components {
                let active = &e.unknowns[mode][component];
                active.iter().for_each(|(u, c)| by_unknowns[component] += c * shape * unknowns[*u]);
                prescribed[component] += shape * e.prescribed[mode][component];
            }
        }
        [by_unknowns, prescribed]
    }

    /// Displacement at a place when a support moves by unit translations along the two axes and by a unit rotation about the origin,
    /// all kept unknowns being held: `(support, motions)`. A force at the place works on it, and the support reacts.
    pub fn support_row(&self, edge: usize, t: f64) -> Vec<(usize, [[f64; 2]; 3])> {
        let e = &self.edges[edge];
        if e.fixed.is_empty() {
            return Vec::new();
        }
        let shapes: Vec<f64> = shape_values(e.degree, if e.against { -t } else { t }).collect();
        e.fixed.iter().map(|(mode, support, m)| (*support, m.map(|m| m.map(|v| v * shapes[*mode])))).collect()
    }

    /// Matrix that takes kept unknowns to the displacement component along `direction(point)` at the given places
    /// `(edge, t)`: `places x unknowns`.
    pub fn component_matrix(&self, places: &[(usize, f64)], direction: impl Fn(&BoundaryPoint) -> [f64; 2]) -> Mat<f64> {
        let mut matrix = Mat::zeros(places.len(), self.unknowns);
        for (i, (edge, t)) in places.iter().enumerate() {
            let d = direction(&self.boundary_point(*edge, *t).0);
            let (rows, _) = self.displacement_row(*edge, *t);
            for (row, d) in rows.iter().zip(d) {
                row.iter().for_each(|(u, c)| matrix[(i, *u)] += d * c);
            }
        }
        matrix
    }

    /// Consistent load of a traction (MPa) on the path, `int N^T t dA`, N, by Gauss quadrature with `extra` points beyond the degree plus two on
    /// every edge.
    pub fn load(&self, kinematics: Kinematics, extra: usize, traction: impl Fn(&BoundaryPoint) -> [f64; 2]) -> TraceLoad {
        let mut load = TraceLoad { unknowns: vec![0.0; self.unknowns], ..TraceLoad::default() };
        for (number, edge) in self.edges.iter().enumerate() {
            let rule = crate::quadrature::gauss(edge.degree + 2 + extra);
            for (t, w) in rule.points.iter().zip(&rule.weights) {
                let (point, length) = self.boundary_point(number, *t);
                let weight = w * length * kinematics.measure(point.position[0]);
                self.add_force_at(&mut load, (number, *t), point.position, traction(&point).map(|v| weight * v));
            }
        }
        load
    }

    /// Adds a force, N along the two axes, at a place `(edge, parameter)` of the path to a load.
    pub fn add_force(&self, load: &mut TraceLoad, (edge, t): (usize, f64), force: [f64; 2]) {
        self.add_force_at(load, (edge, t), self.edges[edge].curve.point(t), force);
    }

    fn add_force_at(&self, load: &mut TraceLoad, (edge, t): (usize, f64), x: [f64; 2], force: [f64; 2]) {
        let e = &self.edges[edge];
        let shapes: Vec<f64> = shape_values(e.degree, if e.against { -t } else { t }).collect();
        for (unknowns, shape) in e.unknowns.iter().zip(&shapes) {
            for (row, force) in unknowns.iter().zip(force) {
                row.iter().for_each(|(u, c)| load.unknowns[*u] += force * (c * shape));
            }
        }
        for (mode, support, motions) in &e.fixed {
            if load.supports.len() <= *support {
                load.supports.resize(support + 1, [0.0; 3]);
            }
            for (total, m) in load.supports[*support].iter_mut().zip(motions) {
                *total += shapes[*mode] * (force[0] * m[0] + force[1] * m[1]);
            }
        }
        for (total, m) in load.resultant.iter_mut().zip(rigid_rows(x, [0.0, 0.0])) {
            *total += force[0] * m[0] + force[1] * m[1];
        }
    }
}

/// Whether a walk along edges ends at the vertex where it starts.
fn is_closed(mesh: &Mesh, walk: &[(usize, bool)]) -> bool {
    let end = |(edge, against): &(usize, bool), last: bool| mesh.edges[*edge].vertices[usize::from(*against != last)];
    match walk {
        [first, .., last] => end(first, false) == end(last, true),
        _ => false,
    }
}

/// A load on the kept boundary.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TraceLoad {
    /// Load on the kept unknowns, N (N mm on a rotation), one value an unknown.
    pub unknowns: Vec<f64>,
    /// Part that goes straight into prescribed unknowns, by support: force along the two axes, N, and moment about the origin, N mm.
    pub supports: Vec<[f64; 3]>,
    /// Resultant force along the two axes, N, and moment about the origin, N mm (`x cross f`, anti-clockwise with the second axis up).
    pub resultant: [f64; 3],
}
