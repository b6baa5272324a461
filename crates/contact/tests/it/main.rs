//! Integration tests.
#![allow(clippy::unwrap_used, missing_docs)]

mod common;
mod cattaneo_mindlin;
mod full_contact;
mod hertz;
mod sphere;
mod statuses;
