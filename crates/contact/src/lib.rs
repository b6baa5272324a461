//! Unilateral frictional contact of elastic bodies on their interface operators.
//!
//! Signs: body 1 is shaped, body 2 the counter-face; the normal `n` points out of body 2 into body 1, the gap is positive when
//! open, the pressure positive in compression; traction on body 1 is `p n + mu p tau`, on body 2 the opposite.

mod error;
mod pair;

pub use error::Error;
pub use pair::{ContactPoint, Pair, Side, contact_traction, normal};
