//! The files of a solution in memory.
#![allow(clippy::unwrap_used, missing_docs)]

mod files;
mod table;
