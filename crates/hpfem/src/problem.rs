//! The problem of one body: mesh, degrees, materials, supports and loads.

use crate::basis::SpaceKind;
use crate::boundary::BoundaryPoint;
use crate::freedom::{RigidEdge, Support};
use crate::material::{Kinematics, Material};
use crate::mesh::Mesh;

/// The problem of one body.
pub struct BodyProblem<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// Degree of every cell, one a cell, `1..=`[`MAX_DEGREE`](crate::MAX_DEGREE).
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
    /// Load cases; their factors are given later, to [`Body::solve`](crate::Body::solve).
    pub load_cases: &'a [LoadCase<'a>],
    /// Name of the boundary whose unknowns are kept; `None` solves the body alone.
    pub kept: Option<&'a str>,
}

/// A traction on a named boundary, force per area, MPa, as a function of the point: `[t_x, t_z]`, in torsion `[t_phi, _]`.
pub struct EdgeTraction<'a> {
    /// Name of the boundary.
    pub boundary: String,
    /// The traction, MPa; it must be smooth on each edge for the quadrature to be accurate.
    pub traction: BoundaryTraction<'a>,
}

/// A traction, MPa, as a function of the boundary point.
pub type BoundaryTraction<'a> = Box<dyn Fn(&BoundaryPoint) -> [f64; 2] + Sync + 'a>;

/// Tractions that act together; the interface operator keeps one column a load case.
pub type LoadCase<'a> = Vec<EdgeTraction<'a>>;
