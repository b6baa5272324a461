//! The extent of the contact surface in its own coordinate, and where it is cut.

use hpfem::Curve;

/// Extent of the contact surface, shared by both bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// On an arc about the centre, angles from the z axis towards +x.
    Angles([f64; 2]),
    /// On a horizontal line.
    X([f64; 2]),
    /// On a horizontal line that a round body touches at one place and faces across a gap.
    Round {
        /// From and to.
        x: [f64; 2],
        /// Where it touches.
        touch: f64,
        /// Radius of the round body.
        radius: f64,
    },
}

impl Extent {
    /// First and last coordinate.
    pub fn ends(&self) -> [f64; 2] {
        match self {
            Extent::Angles(angles) => *angles,
            Extent::X(x) | Extent::Round { x, .. } => *x,
        }
    }

    /// Coordinates of the ends of a line or arc of the contact edge, the one at `t = -1` first; angles next to those of the contact.
    pub fn range(&self, curve: &Curve) -> [f64; 2] {
        use std::f64::consts::{FRAC_PI_2, PI, TAU};
        match (self, curve) {
            (Extent::Angles(angles), Curve::Arc { from, to, .. }) => {
                let middle = 0.5 * (angles[0] + angles[1]);
                let own = FRAC_PI_2 - 0.5 * (from + to);
                let own = (own - middle + PI).rem_euclid(TAU) - PI + middle;
                [own - 0.5 * (from - to), own + 0.5 * (from - to)]
            }
            _ => [curve.point(-1.0)[0], curve.point(1.0)[0]],
        }
    }

    /// Parameter of a place on a line or arc of the contact edge; outside of [-1, 1] or no number where it is not on it.
    pub fn parameter(&self, curve: &Curve, place: f64) -> f64 {
        use std::f64::consts::{FRAC_PI_2, PI, TAU};
        match (self, curve) {
            (Extent::Round { .. }, Curve::Arc { centre, radius, from, to }) => {
                let angle = ((place - centre[0]) / radius).asin() - FRAC_PI_2;
                let middle = 0.5 * (from + to);
                let own = (angle - middle + PI).rem_euclid(TAU) - PI;
                2.0 * own / (to - from)
            }
            _ => {
                let [a, b] = self.range(curve);
                (2.0 * place - a - b) / (b - a)
            }
        }
    }
}

/// Where the contact surface is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut<'a> {
    /// The standing choice.
    Plain,
    /// Elsewhere, for an independent solution.
    Shifted,
    /// Also at ends of contact, given by their place on the surface from -1 to 1, with layers around them.
    Ends(&'a [f64]),
}

impl<'a> Cut<'a> {
    /// The ends of contact that it cuts at; none of the standing choices.
    pub fn ends(self) -> &'a [f64] {
        match self {
            Cut::Ends(ends) => ends,
            _ => &[],
        }
    }
}
