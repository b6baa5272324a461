//! A gap as a function of the arc length, independent of the mesh it was found on.

use crate::shape::Shape;
use contact::Pair;
use hpfem::{barycentric_weights, gauss_lobatto, lagrange};

/// A piecewise polynomial gap over the arc length of the contact surface.
#[derive(Clone, Debug, PartialEq)]
pub struct GapCurve {
    pieces: Vec<Piece>,
}

#[derive(Clone, Debug, PartialEq)]
struct Piece {
    range: [f64; 2],
    nodes: Vec<f64>,
    barycentric: Vec<f64>,
    values: Vec<f64>,
}

impl GapCurve {
    /// The gap of a shape: between the break points of both bodies the interpolant in Gauss-Lobatto points four degrees above the bodies' own, since the normal
    /// of a curved edge makes the gap a little more than a polynomial of that degree.
    pub fn of(shape: &Shape, pair: &Pair<'_>) -> GapCurve {
        let pieces = pair.pieces().into_iter().map(|(range, degree)| {
            let nodes = gauss_lobatto(degree + 5).points;
            let value = |t: &f64| {
                let arc = range[0] + 0.5 * (1.0 + t) * (range[1] - range[0]);
                shape.gap(pair, &pair.at_arc(arc))
            };
            let values = nodes.iter().map(value).collect();
            Piece { range, barycentric: barycentric_weights(&nodes), nodes, values }
        });
        GapCurve { pieces: pieces.collect() }
    }

    /// Gap at an arc length from the start of the surface.
    pub fn at(&self, arc: f64) -> f64 {
        let number = self.pieces.partition_point(|p| p.range[1] < arc).min(self.pieces.len() - 1);
        let piece = &self.pieces[number];
        let t = (2.0 * (arc - piece.range[0]) / (piece.range[1] - piece.range[0]) - 1.0).clamp(-1.0, 1.0);
        lagrange(&piece.nodes, &piece.barycentric, t).iter().zip(&piece.values).map(|(l, v)| l * v).sum()
    }
}
