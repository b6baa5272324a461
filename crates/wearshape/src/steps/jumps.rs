//! Jumps of a wanted pressure: that of the uniform pressure under a force off the middle ends inside the surface without falling to zero first.
//!
//! Such an end is a node of the mesh, and round-off would put that node on either side. The node carries what both sides give it,
//! `p_- W_- + p_+ W_+` with the areas `W` that either edge lends to it, so that the forces of the nodes are those of the pressure.

use contact::Pair;
use hpfem::TraceEdge;

use crate::stage::Stage;

/// Distances from an end (of half the surface) at which a pressure is compared with itself: one that goes like `x^k` differs there by the factor `1e4^k`.
const BESIDE: [f64; 2] = [1e-6, 1e-10];
/// Largest difference of the logarithms of both pressures of a jump.
const FLAT: f64 = 1e-3;
/// Share of the surface within which a place is at a jump.
const AT: f64 = 1e-9;

/// A jump.
struct Jump {
    position: [f64; 2],
    /// Along the surface, from the first side to the second.
    direction: [f64; 2],
    /// Pressures (MPa) on both sides.
    sides: [f64; 2],
}

/// The jumps of a wanted pressure inside the surface.
pub(crate) struct Jumps {
    jumps: Vec<Jump>,
    /// Distance (mm) within which a place is at a jump.
    near: f64,
}

impl Jumps {
    /// Those among the ends (from -1 to 1) of a pressure.
    pub(crate) fn among(ends: &[f64], stage: Stage<'_>, optimum: &wear::Optimum) -> Jumps {
        let surface = &stage.patch.surface;
        let (lo, hi) = surface.range();
        let point = |t: f64| surface.along(0.5 * (lo * (1.0 - t) + hi * (1.0 + t)));
        let position = |t: f64| [point(t).position.x, point(t).position.z];
        let pressed = |end: f64, side: f64| BESIDE.map(|off| optimum.log_pressure_at(&point(end + side * off)));
        let jumps = ends.iter().filter_map(|end| {
            let sides = [-1.0, 1.0].map(|side| pressed(*end, side));
            let loaded = sides.iter().find(|[far, _]| far.is_finite())?;
            let [before, after] = [-1.0, 1.0].map(|side| position(end + side * BESIDE[0]));
            let direction = [after[0] - before[0], after[1] - before[1]];
            let jump = Jump { position: position(*end), direction, sides: sides.map(|[_, near]| near.exp()) };
            ((loaded[0] - loaded[1]).abs() < FLAT).then_some(jump)
        });
        let [from, to] = [-1.0, 1.0].map(position);
        Jumps { jumps: jumps.collect(), near: AT * (to[0] - from[0]).hypot(to[1] - from[1]) }
    }

    /// The pressure (MPa) at a position that is at a jump, by what the edges of a pair lend to it; without a pair the mean of both sides.
    pub(crate) fn pressure(&self, x: [f64; 2], pair: Option<&Pair<'_>>) -> Option<f64> {
        let off = |jump: &&Jump| (x[0] - jump.position[0]).hypot(x[1] - jump.position[1]);
        let jump = self.jumps.iter().find(|jump| off(jump) <= self.near)?;
        let [before, after] = pair.and_then(|pair| self.areas(pair, jump)).unwrap_or([1.0; 2]);
        Some((before * jump.sides[0] + after * jump.sides[1]) / (before + after))
    }

    /// Areas, up to a common factor, that the edges before and after a jump lend to its node.
    fn areas(&self, pair: &Pair<'_>, jump: &Jump) -> Option<[f64; 2]> {
        let along = |edge: &TraceEdge, t: f64| {
            let d = edge.curve.derivative(t);
            (d[0] * jump.direction[0] + d[1] * jump.direction[1]).signum() * t
        };
        let area = |side: f64| {
            let ends = pair.trace().edges.iter().flat_map(|edge| [-1.0, 1.0].map(|t| (edge, t)));
            // The edge before the jump ends there, the one after it begins.
            let (edge, t) = ends.filter(|(edge, t)| along(edge, *t) == -side).find(|(edge, t)| {
                let [x, z] = edge.curve.point(*t);
                (x - jump.position[0]).hypot(z - jump.position[1]) <= self.near
            })?;
            let [x, z] = edge.curve.derivative(t);
            // The last weight of the Gauss-Lobatto rule of n + 1 points is 2 / (n (n + 1)).
            Some(x.hypot(z) / (edge.degree * (edge.degree + 1)) as f64)
        };
        Some([area(-1.0)?, area(1.0)?])
    }
}
