//! The contact shape that produces a wanted pressure, and its evolution by wear.

mod error;
mod rigid_part;
mod shape;

pub use error::Error;
pub use rigid_part::{Curve, lowest_nonnegative};
pub use shape::{Gauge, RigidPart, Shape, ShapeProblem, SurfacePlace, closing, solve_shape};
