//! Integration tests.
#![allow(clippy::unwrap_used, missing_docs)]

mod common;
mod full_contact;
mod hertz;
mod statuses;
mod scan;
