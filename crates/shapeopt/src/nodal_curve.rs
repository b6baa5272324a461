//! A gap given at the contact points, as a curve for the choice of the rigid part.

use contact::{ContactOperator, Pair};

use crate::rigid_part::Curve;
use crate::shape::closing;

/// Values (mm) at the contact points, polynomials in between.
pub struct NodalCurve<'a> {
    /// The bodies.
    pub pair: &'a Pair<'a>,
    /// Their contact.
    pub operator: &'a ContactOperator<'a>,
    /// Gap at the contact points (mm).
    pub gap: &'a [f64],
}

impl Curve for NodalCurve<'_> {
    fn length(&self) -> f64 {
        self.pair.trace().length()
    }

    fn samples(&self) -> Vec<f64> {
        let trace = self.pair.trace();
        let mut samples: Vec<f64> = trace
            .edges
            .iter()
            .flat_map(|edge| {
                let n = 4 * (edge.degree + 1);
                let (start, length) = (edge.start, edge.curve.length());
                (0..n).map(move |i| start + length * i as f64 / n as f64)
            })
            .collect();
        samples.push(trace.length());
        samples
    }

    fn value(&self, arc: f64) -> (f64, Vec<f64>) {
        (self.operator.value_at(self.gap, arc), closing(self.pair, &self.pair.at_arc(arc)))
    }

    fn mean_modes(&self) -> Vec<f64> {
        let mut sums = vec![0.0; self.pair.shaped.rigid_modes.ncols()];
        for point in self.operator.points() {
            for (sum, phi) in sums.iter_mut().zip(closing(self.pair, point)) {
                *sum += point.weight * phi;
            }
        }
        sums
    }
}
