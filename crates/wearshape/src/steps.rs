//! The steps that are computed, each on what stands below it.

pub mod answer;
pub mod approach;
pub mod contact;
pub mod diagnosis;
pub mod ends;
pub mod ends_profile;
pub mod ends_scope;
pub mod free_ends;
pub mod hertz_trial;
pub mod pressure;
pub mod pressure_ends;
pub mod recover;
pub mod round;
pub mod round_trip;
pub mod sensitivity;
pub mod shape;
pub mod sharp_edges;
pub mod tolerance;
pub mod torsion;
pub mod twist;
pub mod wear;
