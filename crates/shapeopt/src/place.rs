//! A place on the contact surface with its arc length.

use contact::ContactPoint;
use hpfem::Trace;

/// A place on the contact surface where a traction is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePlace {
    /// Position, mm.
    pub position: [f64; 2],
    /// Unit normal out of body 2 into body 1.
    pub normal: [f64; 2],
    /// Arc length from the start of the contact surface, mm: that of [`Pair::at_arc`](contact::Pair::at_arc), from 0 to the length of
    /// [`Pair::trace`](contact::Pair::trace). A place on the other body's boundary has that of the nearest point of the surface.
    pub arc: f64,
}

impl From<&ContactPoint> for SurfacePlace {
    fn from(point: &ContactPoint) -> SurfacePlace {
        SurfacePlace { position: point.position, normal: point.normal, arc: point.arc }
    }
}

impl SurfacePlace {
    /// The place of a point on or near the surface that a trace runs along.
    pub(crate) fn near(trace: &Trace, position: [f64; 2], normal: [f64; 2]) -> SurfacePlace {
        SurfacePlace { position, normal, arc: nearest_arc(trace, position) }
    }
}

/// Most Newton steps along an edge.
const STEPS: usize = 20;

/// Arc length of the point of a path that is nearest to a position.
fn nearest_arc(trace: &Trace, x: [f64; 2]) -> f64 {
    let mut nearest = [f64::INFINITY, 0.0];
    for edge in &trace.edges {
        let ends = [edge.curve.point(-1.0), edge.curve.point(1.0)];
        let chord = difference(ends[1], ends[0]);
        let share = (product(difference(x, ends[0]), chord) / product(chord, chord)).clamp(0.0, 1.0);
        let length = edge.curve.length();
        let foot = [0, 1].map(|k| ends[0][k] + share * chord[k]);
        let off = difference(x, foot);
        // An edge is nowhere farther from its chord than its own length.
        if off[0].hypot(off[1]) > nearest[0] + length {
            continue;
        }
        let mut arc = share * length;
        // Newton's method on the part of the difference along the edge; no step on its ends if the nearest point lies beyond.
        for _ in 0..STEPS {
            let t = edge.curve.parameter_at_length(arc);
            let d = edge.curve.derivative(t);
            let next = (arc + product(difference(x, edge.curve.point(t)), d) / d[0].hypot(d[1])).clamp(0.0, length);
            let moved = (next - arc).abs();
            arc = next;
            if moved <= 1e-15 * length {
                break;
            }
        }
        let off = difference(x, edge.curve.point(edge.curve.parameter_at_length(arc)));
        let distance = off[0].hypot(off[1]);
        if distance < nearest[0] {
            nearest = [distance, edge.start + arc];
        }
    }
    nearest[1]
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn product(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
