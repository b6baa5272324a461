//! Reasons why a load has no answer that are said in more than one place, and of what kind of pressure they speak.

/// Why a load has no stationary pressure below s = 1: with one mode.
pub(crate) const ALL_CLOSED: &str = "with s < 1 the stationary pressure needs a load that closes every point of the surface";
/// Why a moment has no stationary pressure below s = 1.
pub(crate) const ON_THE_EDGE: &str = "with s < 1 no stationary pressure carries this moment (its limit has a force on the edge)";
/// Why a rule whose rate stays below a bound has no steady pressure.
pub(crate) const BOUNDED: &str = "the wear rate stays below a bound, and the pressure carries less than that wherever the rate is below it by more than round-off";
/// Why a surface of which a part rests has no steady pressure.
pub(crate) const AT_REST: &str = "nothing wears at a point that does not slide, and no pressure there is large enough";
/// Why the axis of rotation cannot carry.
pub(crate) const AT_THE_AXIS: &str = "the pressure is not integrable at the axis of rotation";
/// Why the wear determines no pressure.
pub(crate) const BELOW: &str = "the whole surface stays below the threshold of the wear rule, where nothing moves";

/// What is said of a load before the reason.
pub(crate) fn opening(why: &str) -> &'static str {
    match why {
        ALL_CLOSED | ON_THE_EDGE | BOUNDED | AT_REST | AT_THE_AXIS => "no stationary pressure balances the load",
        BELOW => "more than one pressure balances the load",
        _ => "no pressure p >= 0 balances the load",
    }
}
