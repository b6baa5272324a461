//! A contact surface without its sliding.

use wear::Shape;

/// Kind of contact surface, by how body 2 passes under it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PatchKind {
    /// Plane strip or plane surface over which a long plate slides.
    Plane,
    /// Full ring on a turning disc.
    Ring,
    /// Arc or sector under which a drum, shaft or disc turns.
    Turning,
}

/// A contact surface without its sliding.
pub(super) struct Found {
    /// Its shape.
    pub shape: Shape,
    /// How body 2 passes under it.
    pub kind: PatchKind,
    /// Point [x, z] about which body 2 turns in the plane.
    pub centre: [f64; 2],
    /// The key to blame for it.
    pub key: &'static str,
    /// Body 1's circle, where it is another than body 2's.
    pub other: Option<Other>,
}

impl Found {
    /// A surface without bodies.
    pub(super) fn bare(shape: Shape, kind: PatchKind, key: &'static str) -> Found {
        Found { shape, kind, centre: [0.0, 0.0], key, other: None }
    }
}

/// The circle of body 1, where it is another than body 2's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Other {
    pub circle: Round,
    /// Whether both bodies are round and touch from outside, instead of one inside the other.
    pub convex: bool,
}

/// A circle: centre [x, z] and radius (mm).
pub(crate) type Round = ([f64; 2], f64);
