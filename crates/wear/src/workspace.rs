//! Memory that many solutions share.

use crate::stage::Node;
use crate::{Optimum, SurfacePoint};

/// Buffers for `optimal_pressure_with`: after the first call a sweep that gives its answers back allocates nothing for problems with
/// one mode.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    pub(crate) nodes: Vec<Node>,
    pub(crate) rates: Vec<[f64; 2]>,
    pub(crate) gap: Vec<f64>,
    pub(crate) spare: Vectors,
}

/// The vectors of an `Optimum`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Vectors {
    pub(crate) points: Vec<SurfacePoint>,
    pub(crate) pressure: Vec<f64>,
    pub(crate) log_pressure: Vec<f64>,
    pub(crate) multipliers: Vec<f64>,
    pub(crate) feed: Vec<f64>,
    pub(crate) resultants: Vec<f64>,
}

impl Workspace {
    /// Takes back the vectors of an answer that is no longer needed.
    pub fn recycle(&mut self, optimum: Optimum) {
        self.spare = Vectors {
            points: optimum.points,
            pressure: optimum.pressure,
            log_pressure: optimum.log_pressure,
            multipliers: optimum.multipliers,
            feed: optimum.feed.unwrap_or_default(),
            resultants: optimum.resultants,
        };
    }
}
