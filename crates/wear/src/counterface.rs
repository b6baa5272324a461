//! How the counter-face passes under body 1, and how deep it wears.

/// The way body 2's points pass through the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counterface {
    /// Long fresh plate under a translating punch: its profile is stationary in the punch frame and drops out of the gap rate.
    Fresh,
    /// Ring on ring: each point of body 2 always meets the same pressure; the wear rates add.
    Congruent,
    /// Drum under a shoe, disc under a pad: body 2 recedes uniformly along its closed track by the mean of its wear over a turn.
    Revolving,
}
