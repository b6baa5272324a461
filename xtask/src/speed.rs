//! Processor seconds and peak memory of the program on many scenes: against an earlier revision, and by its own stages.
//!
//! On a shared machine single seconds say little. Two programs take turns on one scene after another, and what counts are the ratios of the pairs of
//! runs that stood next to each other, by their median and quartiles; processor seconds (user and system) instead of the clock's.

mod against;
mod case;
mod page;
mod process;
mod profile;
mod revision;
mod row;
mod spread;

pub(crate) use against::run as against;
pub(crate) use profile::run as profile;
