//! p-version finite elements for plane and axisymmetric linear elasticity, with every body reduced to the boundary that matters.
//!
//! Cells are curved quadrilaterals with exact lines and arcs (blending) and hierarchic shape functions (integrated
//! Legendre polynomials). A [`Body`] is assembled once; interiors and everything but a kept boundary are eliminated, and what
//! is left is a small dense [`InterfaceOperator`], from which displacements, energies and reactions follow without the mesh.
//!
//! Units are the user's own, as long as they are consistent.

mod adapt;
mod additions;
mod assemble;
mod basis;
mod blocks;
mod body;
mod body_force;
mod cell_matrix;
mod check;
mod congruence;
mod curve;
mod element;
mod elimination;
mod error;
mod estimate;
mod field;
mod gmsh;
mod gmsh_read;
mod interface;
mod legendre;
mod material;
mod mesh;
mod quadrature;
mod refine;
mod remesh;
mod rigid;
mod singular;
mod space;
mod trace;

pub use adapt::{AdaptStatus, Adapted, adapt, graded_level};
pub use additions::{Additions, BodyForce, Force, Foundation, Pin};
pub use assemble::{BoundaryPoint, EdgeTraction, LoadCase};
pub use blocks::{Named, Ruled, Side};
pub use body::{Body, BodyProblem, Effort};
pub use curve::{CURVE_DEGREE, Curve};
pub use error::Error;
pub use estimate::{EnergyEstimate, energy_estimate, sequence_estimate};
pub use field::{Field, PointState};
pub use gmsh::{GmshError, GmshMesh};
pub use interface::{InterfaceOperator, InterfaceState};
pub use legendre::{legendre, shape_functions};
pub use material::{Kinematics, Material, Moduli};
pub use mesh::{CELL_EDGES, Cell, Edge, Mesh, Quad};
pub use quadrature::{Quadrature, barycentric_weights, gauss, gauss_lobatto, gauss_lobatto_jacobi, lagrange};
pub use singular::{Face, Sector, SingularVertex, corner_exponent, singular_vertices};
pub use space::{Direction, MAX_DEGREE, RigidEdge, SpaceKind, Support};
pub use trace::{Trace, TraceEdge, TraceLoad, TracePoint};
