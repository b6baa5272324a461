//! The wearshape program.
