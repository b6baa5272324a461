//! p-version finite elements for plane and axisymmetric linear elasticity, with every body reduced to the boundary that matters.
//!
//! # The method
//!
//! Cells are curved quadrilaterals and triangles with exact lines and arcs. A quadrilateral is the image of the square `[-1, 1]^2` under the blended map
//! (Gordon and Hall 1973) of its four edge curves `e_0 .. e_3` and corners `v_i`,
//!
//! ```text
//! X(xi, eta) = (1-eta)/2 e_0(xi) + (1+eta)/2 e_2(xi) + (1-xi)/2 e_3(eta) + (1+xi)/2 e_1(eta) - (bilinear map of the corners).
//! ```
//!
//! The displacement is a sum of products `N_i(xi) N_j(eta)` of integrated Legendre polynomials (Szabo and Babuska 1991),
//! `N_k = (P_k - P_{k-2}) / sqrt(2 (2k-1))`: corner, edge and interior modes up to degree 24, odd edge modes with a sign where a cell walks
//! the edge backwards. A triangle has the complete polynomials of its degree and the same modes on its edges.
//!
//! Equilibrium is `int sigma(u) : eps(v) dV = int f . v dV + int t . v dA` for all `v`, the strains being
//!
//! ```text
//! plane          eps = (u_x,x  u_z,z  u_x,z + u_z,x)
//! axisymmetric   eps = (u_r,r  u_z,z  u_r,z + u_z,r  u_r / r)          dV = 2 pi r dr dz
//! torsion        gamma = (u_phi,r - u_phi / r   u_phi,z)               dV = 2 pi r dr dz
//! ```
//!
//! Interior modes are eliminated cell by cell, all other unknowns front by front, but those of one named boundary, which are kept:
//! `S u_c = f_c`, `S = K_cc - K_ci K_ii^-1 K_ic`. This [`InterfaceOperator`] holds the whole linear body; its displacements, energies
//! and reactions follow without the mesh, and a body that floats needs no special care. In plane problems congruent and similar cells share
//! one condensed matrix (quadrilaterals between lines and arcs, straight triangles). The order of elimination is minimum degree for few cells,
//! nested dissection for many, and the cheaper of the two in between; it depends on mesh and degrees alone.
//!
//! # Where to start
//!
//! [`Mesh::new`] or [`Mesh::ruled`] or [`GmshMesh::read`], then [`Body::new`], [`Body::solve`], [`Body::field`], [`Field::at`];
//! [`Body::interface`] gives the interface operator alone, in less memory, and [`Body::sizes`] the sizes and the memory beforehand.
//! [`singular_vertices`] and [`adapt`] choose mesh and degrees for an accuracy. The README has a whole program and an extension guide.
//!
//! # Conventions
//!
//! Coordinates are (x, z), or (r, z) with the axis of revolution at r = 0. Corners run anti-clockwise. Normals point out of the body.
//! Moments and rotations are positive from the first axis to the second. Units are the user's own, as long as they are consistent; the
//! ones named in these pages, N, mm, MPa = N/mm^2 and rad, are one such choice. All forces are totals over the thickness or the full turn. Results scale bit for bit with powers of two, and are the same bits for any
//! number of threads.

mod adapt;
mod amalgamation;
mod assembly;
mod basis;
mod bisect;
mod blocks;
mod body;
mod boundary;
mod cell_matrix;
mod cell_point;
mod check;
mod congruence;
mod curve;
mod cut;
mod dense;
mod dissection;
mod edge_load;
mod effort;
mod element;
mod elimination;
mod error;
mod estimate;
mod field;
mod foundation;
mod freedom;
mod front;
mod gmsh;
mod gmsh_error;
mod gmsh_read;
mod holding;
mod interface;
mod kept;
mod kinematics;
mod later_load;
mod legendre;
mod load_case;
mod loads;
mod locate;
mod material;
mod mesh;
mod minimum_degree;
mod moduli;
mod ordered;
mod own_element;
mod plan;
mod problem;
mod quadrature;
mod reduce;
mod refine;
mod refine_edges;
mod remesh;
mod rigid;
mod singular;
mod sizes;
mod sliding_edge;
mod space;
mod spline;
mod split;
mod stress;
mod trace;
mod triangle;
mod triangle_matrix;
mod volume_load;

pub use adapt::{AdaptStatus, Adapted, adapt, graded_level};
pub use basis::{MAX_DEGREE, SpaceKind};
pub use bisect::bisect;
pub use blocks::{Named, Ruled, Side};
pub use body::Body;
pub use boundary::BoundaryPoint;
pub use curve::{CURVE_DEGREE, Curve};
pub use effort::{Clock, Effort};
pub use error::Error;
pub use estimate::{EnergyEstimate, energy_estimate, sequence_estimate};
pub use field::{Field, PointState};
pub use freedom::{Direction, Foundation, Pin, Profile, RigidEdge, Support};
pub use gmsh::GmshMesh;
pub use gmsh_error::GmshError;
pub use interface::{InterfaceOperator, InterfaceState};
pub use kinematics::Kinematics;
pub use legendre::{legendre, shape_functions};
pub use load_case::{BodyForce, BodyPoint, BodyStrain, BoundaryTraction, EdgeTraction, Eigenstrain, Load, LoadCase, PointForce};
pub use material::{MAX_POISSON, Material, Orthotropic};
pub use mesh::{CELL_EDGES, Cell, Edge, Mesh, Quad};
pub use moduli::Moduli;
pub use problem::BodyProblem;
pub use quadrature::{Quadrature, barycentric_weights, gauss, gauss_lobatto, gauss_lobatto_jacobi, lagrange};
pub use singular::{Constants, Corner, Face, Sector, SingularVertex, corner_exponent, singular_vertices};
pub use sizes::Sizes;
pub use sliding_edge::{SlidingEdge, sliding_edge};
pub use stress::Stress;
pub use trace::{Trace, TraceEdge, TraceLoad, TracePoint};

/// The program of the README, compiled and run with the documentation tests.
#[doc = include_str!("../README.md")]
#[cfg(doctest)]
pub struct ReadmeProgram;
