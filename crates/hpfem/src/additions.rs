//! What a body may have besides supports and edge tractions: pins, elastic foundations, body forces, tractions on parts of boundaries,
//! displacements that vary along a support.

use crate::assemble::{Assembly, BoundaryTraction, OwnElement};
use crate::basis::points_for;
use crate::body::BodyProblem;
use crate::boundary::boundary_point;
use crate::error::Error;
use crate::freedom::Direction;
use crate::legendre::shape_functions;
use crate::material::Kinematics;
use crate::mesh::Mesh;
use crate::quadrature::gauss;
use crate::space::{Space, Target};
use faer::Mat;

/// A place and the direction in which it is held.
pub(crate) type HeldPlace = ([f64; 2], [f64; 2]);

/// A vertex held at zero in one direction, to stop rigid motions. Its reaction is number `supports + index`; on a body whose loads
/// balance it vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// The vertex, an index into [`Mesh::vertices`].
    pub vertex: usize,
    /// [`Direction::First`] or [`Direction::Second`].
    pub direction: Direction,
}

/// An elastic foundation: the boundary is pulled back by `-normal (u . n) n - tangential (u . t) t` per area. In torsion the
/// tangential stiffness acts on `u_phi`.
#[derive(Clone, Debug, PartialEq)]
pub struct Foundation {
    /// Name of the boundary.
    pub boundary: String,
    /// Stiffness along the normal, pressure per length, MPa/mm; zero or positive.
    pub normal: f64,
    /// Stiffness along the tangent, MPa/mm; zero or positive.
    pub tangential: f64,
}

/// A force per volume, N/mm^3, as a function of the position, `[f_x, f_z]`, in torsion `[f_phi, _]`; it belongs to a load case.
pub struct BodyForce<'a> {
    /// Number of the load case, an index into [`BodyProblem::load_cases`].
    pub case: usize,
    /// The force, N/mm^3.
    pub force: Force<'a>,
}

/// A force density, N/mm^3, as a function of the position, mm.
pub type Force<'a> = Box<dyn Fn([f64; 2]) -> [f64; 2] + Sync + 'a>;

/// A traction on the part of a boundary between two arc lengths; it belongs to a load case. The quadrature ends where the traction
/// does, so that a jump inside an edge costs no accuracy of the load (the stress has a singular point there that the mesh must resolve).
pub struct SegmentTraction<'a> {
    /// Number of the load case, an index into [`BodyProblem::load_cases`].
    pub case: usize,
    /// Name of the boundary, one open path.
    pub boundary: String,
    /// Arc lengths, mm, from the end of the path with the smaller coordinates (first coordinate first); beyond the path it is cut off.
    pub range: [f64; 2],
    /// The traction, MPa, as in [`EdgeTraction`](crate::EdgeTraction).
    pub traction: BoundaryTraction<'a>,
}

/// A displacement that varies along a support, added to its constant [`value`](crate::Support::value): met at the vertices, interpolated
/// at the Gauss-Lobatto points of every edge.
pub struct SupportDisplacement<'a> {
    /// Number of the support, an index into [`BodyProblem::supports`].
    pub support: usize,
    /// The displacement along the support's direction as a function of the position, mm.
    pub displacement: Box<dyn Fn([f64; 2]) -> f64 + Sync + 'a>,
}

/// Pins, foundations, body forces and the like of a body; see [`Body::with`](crate::Body::with).
#[derive(Default)]
pub struct Additions<'a> {
    /// Pinned vertices.
    pub pins: Vec<Pin>,
    /// Elastic foundations.
    pub foundations: Vec<Foundation>,
    /// Body forces.
    pub body_forces: Vec<BodyForce<'a>>,
    /// Tractions on parts of boundaries.
    pub segments: Vec<SegmentTraction<'a>>,
    /// Displacements that vary along supports.
    pub displacements: Vec<SupportDisplacement<'a>>,
}

impl Additions<'_> {
    /// Refuses what cannot be.
    pub(crate) fn check(&self, problem: &BodyProblem<'_>) -> Result<(), Error> {
        let (mesh, cases) = (problem.mesh, problem.load_cases.len());
        for pin in &self.pins {
            if pin.vertex >= mesh.vertices.len() {
                let what = "pinned vertex, vertices".into();
                return Err(Error::Count { what, given: pin.vertex + 1, expected: mesh.vertices.len() });
            }
            if pin.direction == Direction::Normal {
                return Err(Error::NotStraight { what: "a pin along the normal", boundary: format!("vertex {}", pin.vertex) });
            }
        }
        for f in &self.foundations {
            for value in [f.normal, f.tangential] {
                if !(value.is_finite() && value >= 0.0) {
                    let quantity = format!("the stiffness of the foundation of \"{}\"", f.boundary);
                    return Err(Error::OutOfRange { quantity, value, range: "zero or positive" });
                }
            }
        }
        let used = |what: &str, given: Option<usize>, expected: usize| match given {
            Some(number) if number >= expected => Err(Error::Count { what: what.into(), given: number + 1, expected }),
            _ => Ok(()),
        };
        used("load case of a body force, load cases", self.body_forces.iter().map(|f| f.case).max(), cases)?;
        used("load case of a traction on a part, load cases", self.segments.iter().map(|f| f.case).max(), cases)?;
        let supports = self.displacements.iter().map(|d| d.support).max();
        used("support of a displacement, supports", supports, problem.supports.len())?;
        for segment in &self.segments {
            let [a, b] = segment.range;
            if !(a.is_finite() && b.is_finite() && a < b) {
                let quantity = format!("the length of a loaded part of \"{}\"", segment.boundary);
                return Err(Error::OutOfRange { quantity, value: b - a, range: "positive and finite" });
            }
        }
        Ok(())
    }

    /// Edges on foundations.
    pub(crate) fn foundation_edges(&self, mesh: &Mesh) -> Result<Vec<(usize, &Foundation)>, Error> {
        let mut edges = Vec::new();
        for f in &self.foundations {
            edges.extend(mesh.boundary(&f.boundary)?.into_iter().map(|e| (e, f)));
        }
        Ok(edges)
    }

    /// Places and directions that foundations hold elastically.
    pub(crate) fn held(&self, mesh: &Mesh) -> Result<Vec<HeldPlace>, Error> {
        let mut held = Vec::new();
        for (e, f) in self.foundation_edges(mesh)? {
            for t in [-0.9, 0.0, 0.9] {
                let (p, _) = boundary_point(&mesh.edges[e].curve, t, false);
                let directions = [(f.normal, p.outward), (f.tangential, p.tangent)];
                held.extend(directions.iter().filter(|(k, _)| *k > 0.0).map(|(_, d)| (p.position, *d)));
            }
        }
        Ok(held)
    }
}

impl Assembly<'_> {
    /// The stiffness of a foundation on one edge, as an element of its own on groups sorted by rank.
    pub(crate) fn foundation(&self, edge: usize, foundation: &Foundation, groups: &[usize]) -> OwnElement {
        let own = &self.mesh.edges[edge];
        let components = self.space.components;
        let degree = self.space.edge_degree[edge];
        let rule = gauss(points_for(degree));
        let n = components * (degree + 1);
        let mut k = Mat::<f64>::zeros(n, n);
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let (p, length) = boundary_point(&own.curve, *t, false);
            let weight = w * length * self.kinematics.measure(p.position[0]) / self.unit;
            let shapes = shape_functions(degree, *t).0;
            let stiffness = |c: usize, d: usize| match self.kinematics {
                Kinematics::Torsion => foundation.tangential,
                _ => foundation.normal * p.outward[c] * p.outward[d] + foundation.tangential * p.tangent[c] * p.tangent[d],
            };
            for j in 0..n {
                for i in 0..n {
                    let shape = shapes[i / components] * shapes[j / components];
                    k[(i, j)] += weight * shape * stiffness(i % components, j % components);
                }
            }
        }
        let targets: Vec<Target> = (0..=degree)
            .flat_map(|m| {
                let (group, mode) = if m < 2 { (own.vertices[m], 0) } else { (self.mesh.vertices.len() + edge, m - 2) };
                (0..components).map(move |c| (group, mode, c))
            })
            .map(|(group, mode, c)| self.space.target(self.mesh, group, mode, c))
            .collect();
        let (matrix, constant) = self.on_groups(k.as_ref(), &targets, groups, &[]);
        OwnElement { matrix, constant, interior_work: None }
    }
}

/// Groups of an edge with unknowns, the rigid edge's included.
pub(crate) fn edge_groups(mesh: &Mesh, space: &Space, edge: usize) -> Vec<usize> {
    let [a, b] = mesh.edges[edge].vertices;
    let mut groups = vec![a, b, mesh.vertices.len() + edge];
    if let Some((frame, _)) = &space.frame
        && groups.iter().any(|g| space.freedom[*g].slaved)
    {
        groups.push(*frame);
    }
    groups.retain(|g| space.size[*g] > 0);
    groups
}
