#![doc = include_str!("../README.md")]
#![warn(clippy::missing_errors_doc, clippy::wildcard_enum_match_arm)]

mod acting;
mod approach;
mod edge;
mod error;
mod evolution;
mod evolution_status;
mod gap_curve;
mod gap_difference;
mod gap_rate;
mod implicit_stage;
mod nodal_curve;
mod pace;
mod packed_lu;
mod place;
mod reversal_start;
mod reversed_pressure;
mod reversing;
mod rigid_part;
mod rigid_wear;
mod run_in;
mod settling;
mod shape;
mod spline;
mod stage_contact;
mod tableau;
mod tolerance;
mod turns;
mod wear_problem;
mod wear_state;
mod wear_step;

/// What the signatures are made of: contact systems and pairs, matrices, reduced bodies, rules and surfaces.
pub use {contact, faer, hpfem, wear};

pub use approach::{ApproachForce, force_of_approach};
pub use edge::{EdgeLoad, is_held_elastically};
pub use error::Error;
pub use evolution::Evolution;
pub use evolution_status::EvolutionStatus;
pub use gap_curve::GapCurve;
pub use gap_difference::{Measure, difference_of_gaps};
pub use nodal_curve::NodalCurve;
pub use place::SurfacePlace;
pub use reversing::{Reversing, ReversingProblem, steady_reversing};
pub use rigid_part::{Curve, lowest_nonnegative};
pub use run_in::RunIn;
pub use settling::Settling;
pub use shape::{Gauge, Integration, RigidPart, Shape, ShapeProblem, closing, solve_shape};
pub use spline::{Fit, Spline};
pub use tolerance::{Tolerance, tolerances};
pub use wear_problem::{Interval, LoadStage, Scheme, Stepping, Times, Until, WearProblem};
pub use wear_state::{Entering, WearState};
