//! The extent of the contact surface in its own coordinate, and where it is cut.

use hpfem::Curve;

/// Extent of the contact surface in its own coordinate, shared by both bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// On an arc: from and to as angles (rad) at its centre, from the z axis towards +x: `x = R sin(angle)`, `z = R cos(angle)`.
    Angles([f64; 2]),
    /// On arcs of two radii that face each other by the angle, each about its own centre.
    Circles {
        /// From and to as angles (rad), as of [`Extent::Angles`].
        angles: [f64; 2],
        /// Centre [x, z] and radius (mm) of the arc of body 1 and of body 2.
        circles: [([f64; 2], f64); 2],
    },
    /// On two round bodies that touch from outside, body 1 above body 2: points face each other by the arc length from there.
    Convex {
        /// From and to as angles on body 2 (rad), as of [`Extent::Angles`].
        angles: [f64; 2],
        /// Centre [x, z] and radius (mm) of the arc of body 1 and of body 2.
        circles: [([f64; 2], f64); 2],
    },
    /// On a horizontal line, from and to (mm).
    X([f64; 2]),
    /// On a horizontal line that a round body touches at one place and faces across a gap.
    Round {
        /// From and to (mm).
        x: [f64; 2],
        /// Where it touches (mm).
        touch: f64,
        /// Radius of the round body (mm).
        radius: f64,
    },
}

impl Extent {
    /// First and last coordinate (rad or mm).
    pub fn ends(&self) -> [f64; 2] {
        match self {
            Extent::Angles(angles) | Extent::Circles { angles, .. } | Extent::Convex { angles, .. } => *angles,
            Extent::X(x) | Extent::Round { x, .. } => *x,
        }
    }

    /// What a point of the contact surface of a body (0 or 1) faces on the other one: on arcs of two radii the point at its angle or arc length, else
    /// itself.
    pub(crate) fn facing(&self, body: usize, x: [f64; 2]) -> [f64; 2] {
        match self {
            Extent::Circles { circles, .. } => {
                let ((own, radius), (other, wanted)) = (circles[body], circles[1 - body]);
                [0, 1].map(|k| other[k] + (x[k] - own[k]) * wanted / radius)
            }
            Extent::Convex { circles, .. } => {
                let ((own, radius), (other, wanted)) = (circles[body], circles[1 - body]);
                let side = if body == 0 { -1.0 } else { 1.0 };
                let angle = (x[0] - own[0]).atan2(side * (x[1] - own[1])) * radius / wanted;
                [other[0] + wanted * angle.sin(), other[1] - side * wanted * angle.cos()]
            }
            Extent::Angles(_) | Extent::X(_) | Extent::Round { .. } => x,
        }
    }

    /// A coordinate as a body (0 or 1) counts it on its own arc: the angle there.
    pub(crate) fn own(&self, body: usize, place: f64) -> f64 {
        match self {
            Extent::Convex { circles, .. } if body == 0 => std::f64::consts::PI - place * circles[1].1 / circles[0].1,
            _ => place,
        }
    }

    /// Coordinates of the ends of a line or arc of the contact edge, the one at `t = -1` first; angles next to those of the contact.
    pub(crate) fn range(&self, curve: &Curve) -> [f64; 2] {
        use std::f64::consts::{FRAC_PI_2, PI, TAU};
        match (self, curve) {
            (Extent::Angles(angles) | Extent::Circles { angles, .. }, Curve::Arc { from, to, .. }) => {
                let middle = 0.5 * (angles[0] + angles[1]);
                let own = FRAC_PI_2 - 0.5 * (from + to);
                let own = (own - middle + PI).rem_euclid(TAU) - PI + middle;
                [own - 0.5 * (from - to), own + 0.5 * (from - to)]
            }
            (Extent::Convex { circles, .. }, Curve::Arc { centre, from, to, .. }) => {
                let [first, second] = circles.map(|(c, _)| (c[0] - centre[0]).hypot(c[1] - centre[1]));
                // From the bottom of body 1, or the top of body 2.
                let (about, factor) = if first < second { (PI, -circles[0].1 / circles[1].1) } else { (0.0, 1.0) };
                let own = (FRAC_PI_2 - 0.5 * (from + to) - about + PI).rem_euclid(TAU) - PI;
                [factor * (own - 0.5 * (from - to)), factor * (own + 0.5 * (from - to))]
            }
            _ => [curve.point(-1.0)[0], curve.point(1.0)[0]],
        }
    }

    /// Parameter of a place on a line or arc of the contact edge; outside of [-1, 1] or no number where it is not on it.
    pub(crate) fn parameter(&self, curve: &Curve, place: f64) -> f64 {
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
    /// By the geometry alone.
    Plain,
    /// Elsewhere, for an independent solution.
    Shifted,
    /// Also at ends of contact, given by their place `t` from -1 to 1: `from + (1 + t) / 2 (to - from)`, with layers around them.
    Ends(&'a [f64]),
    /// Also at ends of contact and corners of the gap, given alike, with as many layers around each as around singular points.
    Corners(&'a [f64]),
    /// Also at places, given alike and ascending, that ends of contact pass as the bodies wear; the first and the last are where they end, with layers.
    Passed(&'a [f64]),
}

impl<'a> Cut<'a> {
    /// The ends of contact, and the places that they pass; none of the other cuts.
    pub fn ends(self) -> &'a [f64] {
        match self {
            Cut::Ends(ends) | Cut::Corners(ends) | Cut::Passed(ends) => ends,
            Cut::Plain | Cut::Shifted => &[],
        }
    }

    /// The same cut at other places.
    #[must_use]
    pub fn at(self, places: &'a [f64]) -> Cut<'a> {
        match self {
            Cut::Ends(_) => Cut::Ends(places),
            Cut::Corners(_) => Cut::Corners(places),
            Cut::Passed(_) => Cut::Passed(places),
            Cut::Plain | Cut::Shifted => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TURN: f64 = std::f64::consts::TAU;

    /// An arc about `centre` between two angles from the z axis, walked either way.
    fn arc(centre: [f64; 2], radius: f64, [from, to]: [f64; 2]) -> Curve {
        Curve::Arc { centre, radius, from: 0.25 * TURN - from, to: 0.25 * TURN - to }
    }

    /// The coordinate of a parameter and back, and the ends at -1 and 1.
    fn holds_both_ways(extent: Extent, curve: &Curve, coordinate: impl Fn([f64; 2]) -> f64) {
        let [a, b] = extent.range(curve);
        for (t, end) in [(-1.0, a), (1.0, b)] {
            assert!((coordinate(curve.point(t)) - end).abs() < 1e-12, "{extent:?}: {end} at t = {t}");
        }
        for t in [-1.0, -0.7, 0.0, 0.31, 1.0] {
            let place = coordinate(curve.point(t));
            assert!((extent.parameter(curve, place) - t).abs() < 1e-11, "{extent:?}: place {place} of t = {t}");
        }
    }

    #[test]
    fn parameter_of_a_coordinate_is_where_the_curve_has_it() {
        let about = |centre: [f64; 2]| move |x: [f64; 2]| (x[0] - centre[0]).atan2(x[1] - centre[1]);
        for ends in [[-0.4, 0.1], [0.1, -0.4]] {
            holds_both_ways(Extent::Angles([-0.5, 0.5]), &arc([3.0, -1.0], 20.0, ends), about([3.0, -1.0]));
            holds_both_ways(
                Extent::X([-9.0, 9.0]),
                &Curve::Line { start: [20.0 * ends[0], 4.0], end: [20.0 * ends[1], 4.0] },
                |x| x[0],
            );
        }
        // A round body from above: its lowest point is at x = 2; equal steps of the arc are no equal steps of x.
        let round = Extent::Round { x: [-1.0, 5.0], touch: 2.0, radius: 10.0 };
        for ends in [[0.5 * TURN - 0.2, 0.5 * TURN + 0.1], [0.5 * TURN + 0.1, 0.5 * TURN - 0.2]] {
            holds_both_ways(round, &arc([2.0, 10.0], 10.0, ends), |x| x[0]);
        }
        holds_both_ways(round, &Curve::Line { start: [5.0, 0.0], end: [-1.0, 0.0] }, |x| x[0]);
    }

    /// A shoe inside its drum lies around the angle pi; the arc of a full ring may be numbered a turn away.
    #[test]
    fn angles_are_those_next_to_the_contact() {
        let extent = Extent::Angles([0.5 * TURN - 0.5, 0.5 * TURN + 0.5]);
        for turns in [-1.0, 0.0, 2.0] {
            let ends = [3.0, 3.3].map(|angle| angle + turns * TURN);
            let [a, b] = extent.range(&arc([0.0; 2], 5.0, ends));
            assert!((a - 3.0).abs() < 1e-12 && (b - 3.3).abs() < 1e-12, "{a} {b}");
        }
    }

    #[test]
    fn arcs_of_a_round_body_may_be_numbered_a_turn_away() {
        let round = Extent::Round { x: [-1.0, 1.0], touch: 0.0, radius: 10.0 };
        for turns in [-1.0, 0.0, 2.0] {
            let ends = [0.5, 0.52].map(|share| (share + turns) * TURN);
            assert!((round.parameter(&arc([0.0, 10.0], 10.0, ends), 0.0) + 1.0).abs() < 1e-12, "{turns} turns");
        }
    }

    #[test]
    fn points_of_two_circles_face_each_other_by_their_angle() {
        let circles = [([0.0, -2.0], 26.0), ([0.0, 0.0], 24.0)];
        let extent = Extent::Circles { angles: [-0.5, 0.5], circles };
        let [first, second] = circles.map(|(centre, radius)| arc(centre, radius, [-0.5, 0.5]));
        for t in [-1.0, -0.3, 0.8] {
            assert!((extent.parameter(&second, extent.range(&first)[0]) + 1.0).abs() < 1e-12);
            for (body, [own, other]) in [[first, second], [second, first]].into_iter().enumerate() {
                let (x, y) = (extent.facing(body, own.point(t)), other.point(t));
                assert!((x[0] - y[0]).hypot(x[1] - y[1]) < 1e-13 * 26.0, "{x:?} {y:?}");
            }
        }
    }

    #[test]
    fn points_of_two_round_bodies_face_each_other_by_the_arc_length() {
        let circles = [([1.0, 30.0], 10.0), ([1.0, 0.0], 20.0)];
        let extent = Extent::Convex { angles: [-0.2, 0.2], circles };
        let second = arc(circles[1].0, 20.0, [-0.2, 0.15]);
        let first = arc(circles[0].0, 10.0, [0.5 * TURN + 0.4, 0.5 * TURN - 0.3]);
        for t in [-1.0, -0.3, 0.8] {
            let (x, y) = (first.point(t), second.point(t));
            assert!((extent.facing(0, x)[0] - y[0]).abs() < 1e-13 * 26.0 && (extent.facing(1, y)[1] - x[1]).abs() < 1e-12);
        }
        for curve in [first, second] {
            let [a, b] = extent.range(&curve);
            assert!((a + 0.2).abs() < 1e-14 && (b - 0.15).abs() < 1e-14, "{a} {b}");
        }
        assert!((extent.own(0, 0.1) - (0.5 * TURN - 0.2)).abs() < 1e-14);
    }

    #[test]
    fn a_place_off_the_curve_has_a_parameter_beyond_its_ends() {
        let curve = Curve::Line { start: [1.0, 0.0], end: [2.0, 0.0] };
        assert!(Extent::X([0.0, 5.0]).parameter(&curve, 2.5) > 1.0);
        assert!(Extent::X([0.0, 5.0]).parameter(&curve, 0.5) < -1.0);
        let round = Extent::Round { x: [-1.0, 1.0], touch: 0.0, radius: 10.0 };
        assert!(round.parameter(&arc([0.0, 10.0], 10.0, [0.5 * TURN, 0.6 * TURN]), 30.0).is_nan());
    }
}
