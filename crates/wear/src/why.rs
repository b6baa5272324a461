//! Reasons why a load has no answer, each with what kind of pressure it speaks of.

use std::fmt;

/// What a load lacks that has no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unbalanced {
    /// No pressure p >= 0 of those asked for carries it.
    NoPressure,
    /// Pressures carry it, and none of them is stationary.
    NoStationaryPressure,
    /// More than one pressure carries it, and none is better than another.
    ManyPressures,
}

impl fmt::Display for Unbalanced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Unbalanced::NoPressure => "no pressure p >= 0 balances the load",
            Unbalanced::NoStationaryPressure => "no stationary pressure balances the load",
            Unbalanced::ManyPressures => "more than one pressure balances the load",
        })
    }
}

/// Why a load has no answer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Why {
    pub(crate) kind: Unbalanced,
    pub(crate) words: &'static str,
}

/// With one mode below s = 1.
pub(crate) const ALL_CLOSED: Why =
    stationary("with s < 1 the stationary pressure needs a load that closes every point of the surface");
/// A moment below s = 1.
pub(crate) const ON_THE_EDGE: Why =
    stationary("with s < 1 no stationary pressure carries this moment (its limit has a force on the edge)");
/// A rule whose rate stays below a bound.
pub(crate) const BOUNDED: Why = stationary(
    "the wear rate stays below a bound, and the pressure carries less than that wherever the rate is below it by more than round-off",
);
/// A surface of which a part rests.
pub(crate) const AT_REST: Why = stationary("nothing wears at a point that does not slide, and no pressure there is large enough");
/// The axis of rotation cannot carry.
pub(crate) const AT_THE_AXIS: Why = stationary("the pressure is not integrable at the axis of rotation");
/// The wear determines no pressure.
pub(crate) const BELOW: Why = Why {
    kind: Unbalanced::ManyPressures,
    words: "the whole surface stays below the threshold of the wear rule, where nothing moves",
};
/// Friction alone takes the load.
pub(crate) const SELF_LOCKING: Why = none("the friction carries the load: self-locking");
/// A moment that the surface is too small for.
pub(crate) const BEYOND_THE_EDGE: Why = none("the moment is at or beyond the edge of the surface");
/// A cap of the pressure under the whole surface.
pub(crate) const CAPPED: Why = none("the load is larger than the surface carries under p_max");

/// A reason why no pressure at all carries a load.
pub(crate) const fn none(words: &'static str) -> Why {
    Why { kind: Unbalanced::NoPressure, words }
}

/// A reason why no stationary pressure carries a load.
const fn stationary(words: &'static str) -> Why {
    Why { kind: Unbalanced::NoStationaryPressure, words }
}
