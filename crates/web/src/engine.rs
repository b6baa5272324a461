//! What is kept between questions.

use wearshape::{Bodies, Problem, Solution};

use crate::outside;

/// The bodies that were factorised, and what was solved last.
pub(crate) struct Engine {
    pub(crate) bodies: Bodies,
    pub(crate) solved: Option<(Problem, Solution)>,
}

impl Default for Engine {
    fn default() -> Self {
        outside::listen_to_faults();
        Engine { bodies: Bodies::default(), solved: None }
    }
}
