//! Curves of cell edges: exact lines and circular arcs.

/// A plane curve with a parameter `t` in `[-1, 1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// Straight segment, `x(t) = (1-t)/2 a + (1+t)/2 b`.
    Line {
        /// Start, `t = -1`.
        start: [f64; 2],
        /// End, `t = +1`.
        end: [f64; 2],
    },
    /// Circular arc `x(t) = centre + radius (cos a, sin a)` whose angle `a` runs linearly in `t`. Any angle, either sense.
    Arc {
        /// Centre of the circle.
        centre: [f64; 2],
        /// Radius, positive.
        radius: f64,
        /// Angle from the first axis at `t = -1`, radians, anti-clockwise.
        from: f64,
        /// Angle at `t = +1`.
        to: f64,
    },
}

impl Curve {
    /// Position at `t`.
    pub fn point(&self, t: f64) -> [f64; 2] {
        match *self {
            Curve::Line { start, end } => {
                let (a, b) = (0.5 * (1.0 - t), 0.5 * (1.0 + t));
                [a * start[0] + b * end[0], a * start[1] + b * end[1]]
            }
            Curve::Arc { centre, radius, from, to } => {
                let angle = 0.5 * ((1.0 - t) * from + (1.0 + t) * to);
                [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()]
            }
        }
    }

    /// Derivative `dx/dt` at `t`.
    pub fn derivative(&self, t: f64) -> [f64; 2] {
        match *self {
            Curve::Line { start, end } => [0.5 * (end[0] - start[0]), 0.5 * (end[1] - start[1])],
            Curve::Arc { radius, from, to, .. } => {
                let angle = 0.5 * ((1.0 - t) * from + (1.0 + t) * to);
                let rate = 0.5 * (to - from) * radius;
                [-rate * angle.sin(), rate * angle.cos()]
            }
        }
    }

    /// The part from `t = a` to `t = b` as a curve of its own; `a > b` turns it round.
    pub fn part(&self, a: f64, b: f64) -> Curve {
        match *self {
            Curve::Line { .. } => Curve::Line { start: self.point(a), end: self.point(b) },
            Curve::Arc { centre, radius, from, to } => {
                let angle = |t: f64| 0.5 * ((1.0 - t) * from + (1.0 + t) * to);
                Curve::Arc { centre, radius, from: angle(a), to: angle(b) }
            }
        }
    }

    /// The same curve walked the other way.
    pub fn reversed(&self) -> Curve {
        match *self {
            Curve::Line { start, end } => Curve::Line { start: end, end: start },
            Curve::Arc { centre, radius, from, to } => Curve::Arc { centre, radius, from: to, to: from },
        }
    }

    /// Length of the curve.
    pub fn length(&self) -> f64 {
        match *self {
            Curve::Line { start, end } => (end[0] - start[0]).hypot(end[1] - start[1]),
            Curve::Arc { radius, from, to, .. } => radius * (to - from).abs(),
        }
    }
}
