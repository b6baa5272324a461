//! Integration tests of the library.
#![allow(clippy::unwrap_used, missing_docs)]

mod own_rule;
mod sensitivity;
