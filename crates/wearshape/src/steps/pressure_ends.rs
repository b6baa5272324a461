//! Ends of an optimal pressure that does not fill the contact surface, and of that part of it where the largest admissible pressure holds it down: the
//! pressure has kinks there, and the shape needs nodes.

use crate::stage::Stage;

/// Pieces of the surface in which one end is looked for.
const PIECES: usize = 400;
/// Ends nearer to those of the surface count as these.
const APART: f64 = 1e-6;

/// Places from -1 to 1 where the pressure begins or ends inside the surface, or to be capped, in order.
pub(crate) fn pressure_ends(stage: Stage<'_>, optimum: &wear::Optimum) -> Vec<f64> {
    let surface = &stage.patch.surface;
    let (lo, hi) = surface.range();
    let at = |t: f64| 0.5 * (lo * (1.0 - t) + hi * (1.0 + t));
    let kind = |t: f64| {
        let point = surface.along(at(t));
        (optimum.presses_at(&point), optimum.is_capped_at(&point))
    };
    let place = |i: usize| 2.0 * i as f64 / PIECES as f64 - 1.0;
    let mut ends = Vec::new();
    for i in 0..PIECES {
        let (mut low, mut high) = (place(i), place(i + 1));
        let before = kind(low);
        if before == kind(high) {
            continue;
        }
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if kind(middle) == before { low = middle } else { high = middle }
        }
        ends.push(0.5 * (low + high));
    }
    ends.retain(|t| t.abs() < 1.0 - APART);
    ends
}
