//! What a shape problem must fit before it is solved.

use crate::error::Error;
use crate::shape::{Gauge, RigidPart, ShapeProblem};
use hpfem::InterfaceOperator;
use nalgebra::DMatrix;

impl ShapeProblem<'_> {
    /// Checks gauge and rigid part against the rigid modes of body 1.
    pub(crate) fn check(&self) -> Result<(), Error> {
        let body = self.pair.shaped;
        let modes = body.rigid_modes.ncols();
        if !self.gauge.holds(body) {
            return wrong(
                "the gauge does not hold the shaped body: it needs a rigid edge, or a mean displacement for each rigid mode",
            );
        }
        let fits = |values: &[f64]| values.len() == modes && values.iter().all(|v| v.is_finite());
        let rigid = match &self.rigid {
            RigidPart::Smallest => true,
            RigidPart::Prescribed(values) => values.is_empty() || fits(values),
            RigidPart::SmallestAlong { start, direction } => fits(start) && fits(direction),
        };
        if !rigid {
            return wrong("the rigid part of the gap needs a finite number for each rigid mode of the shaped body");
        }
        if self.cases_shaped.iter().chain(self.cases_counter).any(|factor| !factor.is_finite()) {
            return wrong("a factor of a load case is not finite");
        }
        Ok(())
    }
}

/// Refuses a problem.
pub(crate) fn wrong<T>(what: &'static str) -> Result<T, Error> {
    Err(Error::ShapeInput { what })
}

impl Gauge {
    /// Whether no rigid mode of the body is left.
    fn holds(&self, body: &InterfaceOperator) -> bool {
        let modes = body.rigid_modes.ncols();
        match self {
            Gauge::Orthogonal => true,
            Gauge::MeanOf(columns) => columns.len() >= modes && columns.iter().all(|c| *c < body.columns.ncols()),
            Gauge::HeldEdge | Gauge::LoadedEdge(_) => {
                let held: Vec<usize> = body.frame.iter().flatten().copied().collect();
                let moved = DMatrix::from_fn(held.len(), modes, |i, m| body.rigid_modes[(held[i], m)]);
                modes == 0 || (held.len() >= modes && moved.rank(1e-12 * moved.amax()) == modes)
            }
        }
    }
}
