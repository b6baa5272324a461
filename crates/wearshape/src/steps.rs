//! The steps that are computed, each on what stands below it.

pub(crate) mod answer;
pub(crate) mod approach;
pub(crate) mod contact;
pub(crate) mod diagnosis;
pub(crate) mod ends;
pub(crate) mod ends_profile;
pub(crate) mod ends_scope;
pub(crate) mod free_ends;
pub(crate) mod hertz_trial;
pub(crate) mod pressure;
pub(crate) mod pressure_ends;
pub(crate) mod recover;
pub(crate) mod round;
pub(crate) mod round_trip;
pub(crate) mod shape;
pub(crate) mod sharp_edges;
pub(crate) mod tolerance;
pub(crate) mod torsion;
pub(crate) mod twist;
pub(crate) mod wear;
