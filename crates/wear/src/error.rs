//! What can be wrong with a wear problem, with the numbers in the message.

use thiserror::Error;

use crate::mode::{RigidMode, RigidMotion};
use crate::why::Unbalanced;

/// Wrong input, or a problem that has no answer. Every message carries the numbers that led to it.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum WearError {
    /// A number is outside its range.
    #[error("{name} = {value} is out of range: it must be {wanted}")]
    OutOfRange {
        /// Field word of the quantity.
        name: &'static str,
        /// The value given.
        value: f64,
        /// The range it must lie in.
        wanted: &'static str,
    },
    /// The surface has no points or no area.
    #[error("the surface has no area ({points} points, area {area} mm^2)")]
    EmptySurface {
        /// Number of points.
        points: usize,
        /// Total area in mm^2.
        area: f64,
    },
    /// No mode, more modes than a body has, or modes that cannot be told apart on this surface.
    #[error("the {count} rigid modes are not usable: {why}")]
    Modes {
        /// Number of modes given.
        count: usize,
        /// The reason.
        why: &'static str,
    },
    /// No pressure p >= 0 on the surface carries the prescribed resultants, none that is stationary does, or one of many: the kind says which.
    #[error("{kind} of {}: {why}", resultants(modes))]
    Infeasible {
        /// The modes with their prescribed resultants.
        modes: Vec<RigidMode>,
        /// What the load lacks.
        kind: Unbalanced,
        /// The reason: moment beyond the edge, self-locking, no pressing force.
        why: &'static str,
    },
    /// With these exponents there is no (or no single) stationary pressure.
    #[error("no unique stationary pressure: {why} (s1 = {s1}, s2 = {s2})")]
    MixedExponents {
        /// s of body 1.
        s1: f64,
        /// s of body 2.
        s2: f64,
        /// The reason.
        why: &'static str,
    },
    /// No body wears, so that the wear functional says nothing about the pressure.
    #[error("no body wears, so {functional} does not determine the pressure; {remedy}")]
    NoWear {
        /// Field word of the functional.
        functional: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// A rule that is no power of the pressure says too little for this functional or counter-face.
    #[error("{functional} is not answered for a wear rule that is no power of the pressure; {remedy}")]
    OwnRule {
        /// Field word of the functional.
        functional: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// With s < 1 the pressure rises so steeply towards an edge that doubles cannot resolve it.
    #[error(
        "with s < 1 the peak at the edge is narrower than round-off (smallest over largest f = {ratio:.1e}); nearly all of the load \
         is a force on the edge: use a smaller moment or s > 1"
    )]
    Unresolved {
        /// Smallest over largest value of f = lambda . phi.
        ratio: f64,
    },
    /// The pressure rises so steeply over so much of the surface that its integrals need more nodes than are made.
    #[error(
        "the pressure is so steep that its integrals over the surface need more than {nodes} nodes; give exponents of the wear \
         rule nearer to 1, or a load that presses more of it"
    )]
    TooSteep {
        /// Most nodes that are made.
        nodes: usize,
    },
    /// The iteration did not reach its tolerance.
    #[error("not converged after {iterations} iterations, relative residual {residual:.1e}")]
    NotConverged {
        /// Number of iterations done.
        iterations: usize,
        /// Relative residual of the balance.
        residual: f64,
    },
}

/// The prescribed resultants with their units.
fn resultants(modes: &[RigidMode]) -> String {
    let one = |mode: &RigidMode| match mode.motion {
        RigidMotion::Translation { .. } | RigidMotion::Expansion => format!("{} N", mode.resultant),
        RigidMotion::Rotation { .. } => format!("{} N mm", mode.resultant),
    };
    modes.iter().map(one).collect::<Vec<_>>().join(" and ")
}
