//! Pins, elastic foundations, forces per volume, tractions on parts of boundaries and displacements that vary along supports.

use crate::freedom::Direction;
use crate::problem::BoundaryTraction;

/// A vertex held at zero in one direction, to stop rigid motions. Its reaction is number `supports + index`; on a body whose loads
/// balance it vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// The vertex, an index into [`Mesh::vertices`](crate::Mesh::vertices).
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
    /// Number of the load case, an index into [`BodyProblem::load_cases`](crate::BodyProblem::load_cases).
    pub case: usize,
    /// The force, N/mm^3.
    pub force: Force<'a>,
}

/// A force density, N/mm^3, as a function of the position, mm.
pub type Force<'a> = Box<dyn Fn([f64; 2]) -> [f64; 2] + Sync + 'a>;

/// A traction on the part of a boundary between two arc lengths; it belongs to a load case. The quadrature ends where the traction
/// does, so that a jump inside an edge costs no accuracy of the load (the stress has a singular point there that the mesh must resolve).
pub struct SegmentTraction<'a> {
    /// Number of the load case, an index into [`BodyProblem::load_cases`](crate::BodyProblem::load_cases).
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
    /// Number of the support, an index into [`BodyProblem::supports`](crate::BodyProblem::supports).
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
