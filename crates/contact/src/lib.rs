#![doc = include_str!("../README.md")]
#![warn(clippy::wildcard_enum_match_arm)]

mod active_set;
mod assemble;
mod checked;
mod complementarity;
mod coulomb;
mod displacement;
mod eigenvalues;
mod embedded;
mod ending;
mod error;
mod facing;
mod following;
mod free_ends;
mod growth;
mod heat;
mod heat_growth;
mod heat_speed;
mod heated_system;
mod held;
mod held_points;
mod interpolate;
mod lcp;
mod line_search;
mod linear;
mod load;
mod matrices;
mod matrix_contact;
mod maximum;
mod operator;
mod pair;
mod pivoting;
mod plain;
mod point;
mod positioning;
mod problem;
mod products;
mod response;
mod rows;
mod segment;
mod side;
mod solution;
mod stage;
mod status;
mod system;
mod tresca;
mod twist;
mod uniqueness;
mod verdict;
mod zones;

/// The matrices of [`MatrixContact`] and [`ContactSystem`].
pub use faer;
/// The bodies of [`Pair`].
pub use hpfem;
/// The matrices of [`Start`] and [`Nodes`].
pub use nalgebra;

pub use coulomb::ContactState;
pub use eigenvalues::eigenvalues;
pub use error::Error;
pub use free_ends::FreeEnds;
pub use heat::{HeatSplit, HeatedSurface, SharedHeat, share_heat, share_known_heat};
pub use heat_speed::SpeedFactors;
pub use heated_system::{HeatExchange, HeatedSystem};
pub use held::HeldContact;
pub use interpolate::piecewise_linear;
pub use load::{ContactLoad, Friction, MomentBalance, Motion};
pub use matrix_contact::{MatrixContact, MatrixSolution, Motions};
pub use maximum::{maximum, maximum_between};
pub use operator::{ContactOperator, UnitResponses};
pub use pair::{Pair, contact_traction, normal};
pub use plain::Unloaded;
pub use point::ContactPoint;
pub use positioning::{Nodes, Positioned, Positioning, Rebuilt, Start, UNBOUNDED, held_between, position_ends, position_nodes};
pub use problem::{ContactProblem, solve};
pub use side::Side;
pub use solution::ContactSolution;
pub use status::Status;
pub use system::ContactSystem;
pub use twist::{TorsionOperator, Turn, TwistSolution, TwistStatus};
pub use uniqueness::Uniqueness;
pub use zones::{inner_places, without_slivers};
