//! What a solve found at the contact points and how it ended.

use crate::checked::listed;
use crate::coulomb::ContactState;
use crate::error::Error;
use crate::lcp::Point;
use crate::status::Status;

/// What a solve found and how it ended.
pub(crate) struct Ending {
    pub(crate) status: Status,
    pub(crate) states: Vec<ContactState>,
    /// Normal forces and free coordinates.
    pub(crate) point: Point,
    /// Shear forces.
    pub(crate) shear: Vec<f64>,
    pub(crate) opening: Vec<f64>,
    pub(crate) complementarity: f64,
    pub(crate) balance: f64,
    pub(crate) iterations: usize,
    pub(crate) took_over: bool,
}

/// Where a solve starts from.
pub(crate) struct Warm<'s> {
    /// Normal forces and free coordinates.
    pub(crate) point: Point,
    pub(crate) shear: &'s [f64],
    pub(crate) closed: &'s [bool],
    pub(crate) states: &'s [ContactState],
}

impl Warm<'_> {
    /// Refuses an earlier solution of other points or coordinates, and numbers that are none.
    pub(crate) fn fitting(self, points: usize, coordinates: usize) -> Result<Self, Error> {
        listed(EARLIER, &self.point.force, points)?;
        listed(EARLIER, self.shear, points)?;
        listed("motions of the earlier solution", &self.point.coordinates, coordinates)?;
        if let Some(given) = [self.closed.len(), self.states.len()].into_iter().find(|given| *given != points) {
            return Err(Error::Shape { name: EARLIER, wanted: [points, 1], given: [given, 1] });
        }
        Ok(self)
    }
}

const EARLIER: &str = "earlier solution";
