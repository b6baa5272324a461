//! Curves of cell edges: exact lines and circular arcs, and polynomial curves for splines, graphs and imported meshes.

use crate::error::Error;
use crate::legendre::legendre;
use crate::quadrature::{barycentric_weights, gauss, gauss_lobatto, lagrange};
use std::f64::consts::{PI, TAU};

/// Highest degree of [`Curve::Polynomial`].
pub const CURVE_DEGREE: usize = 8;

/// `sqrt(2 (2k - 1))` of the modes `N_k = (P_k - P_{k-2}) / sqrt(2 (2k - 1))`, `k = 2..=8`.
const MODE_SCALES: [f64; CURVE_DEGREE - 1] = [
    2.449_489_742_783_178,
    3.162_277_660_168_379_5,
    3.741_657_386_773_941_3,
    4.242_640_687_119_285,
    4.690_415_759_823_43,
    5.099_019_513_592_785,
    5.477_225_575_051_661,
];

/// Relative difference of two lengths by quadrature of which the finer one is exact to round-off.
const ALIKE: f64 = 1e-7;

/// Halvings of a curve whose speed is not smooth, as at a cusp.
const HALVINGS: usize = 12;

/// Parts of a curve between [`Curve::between_ends`].
const LOOKED_AT: u32 = 32;

/// A plane curve with a parameter `t` in `[-1, 1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
        /// Centre of the circle, mm.
        centre: [f64; 2],
        /// Radius, mm, positive.
        radius: f64,
        /// Angle from the first axis at `t = -1`, radians, anti-clockwise.
        from: f64,
        /// Angle at `t = +1`, radians.
        to: f64,
    },
    /// Polynomial curve in the crate's own shape functions, `x(t) = N_0 start + N_1 end + sum_k modes[k - 2] N_k(t)` with
    /// `k = 2..=8`; see [`shape_functions`](crate::shape_functions).
    Polynomial {
        /// Start, `t = -1`.
        start: [f64; 2],
        /// End, `t = +1`.
        end: [f64; 2],
        /// Coefficients of the modes 2, 3, ..., mm.
        modes: [[f64; 2]; CURVE_DEGREE - 1],
    },
}

impl Curve {
    /// The polynomial of the given degree (at most [`CURVE_DEGREE`]) that meets `position(t)` at the Gauss-Lobatto points.
    ///
    /// With `y = x - linear part`, which vanishes at the ends, `c_k = int y' N_k' dt = -sqrt((2k-1)/2) int y P_{k-1}' dt`, and the
    /// Gauss-Lobatto rule of `degree + 1` points is exact for it.
    pub fn interpolated(degree: usize, position: impl Fn(f64) -> [f64; 2]) -> Curve {
        let degree = degree.clamp(1, CURVE_DEGREE);
        let (start, end) = (position(-1.0), position(1.0));
        let mut modes = [[0.0; 2]; CURVE_DEGREE - 1];
        let rule = gauss_lobatto(degree + 1);
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let x = position(*t);
            let (a, b) = (0.5 * (1.0 - t), 0.5 * (1.0 + t));
            let bubble: [f64; 2] = std::array::from_fn(|i| x[i] - (a * start[i] + b * end[i]));
            let p = legendre(degree, *t);
            // P_j' = P_{j-2}' + (2j - 1) P_{j-1}.
            let mut slope = vec![0.0; degree + 1];
            for j in 1..degree {
                slope[j] = (2 * j - 1) as f64 * p[j - 1] + if j >= 2 { slope[j - 2] } else { 0.0 };
            }
            for k in 2..=degree {
                let scale = (0.5 * (2 * k - 1) as f64).sqrt();
                (0..2).for_each(|i| modes[k - 2][i] -= w * scale * slope[k - 1] * bubble[i]);
            }
        }
        Curve::Polynomial { start, end, modes }
    }

    /// The polynomial through points at equally spaced parameters, the first at the start, the last at the end: the edges of
    /// mesh files of order `points.len() - 1`. Two give a [`Curve::Line`].
    ///
    /// # Errors
    /// [`Error::Count`] for fewer than two points or more than `CURVE_DEGREE + 1`; [`Error::OutOfRange`] for a coordinate that is not finite
    /// and for neighbours on one place.
    pub fn through(points: &[[f64; 2]]) -> Result<Curve, Error> {
        let n = points.len();
        if let Some(value) = points.iter().flatten().find(|v| !v.is_finite()) {
            return Err(Error::OutOfRange {
                quantity: "a coordinate of a point of a curve".into(),
                value: *value,
                range: "finite",
            });
        }
        if let Some(i) = points.windows(2).position(|two| two[0] == two[1]) {
            let [x, z] = points[i];
            let quantity = format!("the distance between points {i} and {} of a curve, at ({x}, {z})", i + 1);
            return Err(Error::OutOfRange { quantity, value: 0.0, range: "positive" });
        }
        if let [start, end] = *points {
            return Ok(Curve::Line { start, end });
        }
        if !(2..=CURVE_DEGREE + 1).contains(&n) {
            let (what, expected) = if n < 2 { ("at least", 2) } else { ("at most", CURVE_DEGREE + 1) };
            return Err(Error::Count { what: format!("points of a curve, {what} {expected}"), given: n, expected });
        }
        let places: Vec<f64> = (0..n).map(|i| (2 * i) as f64 / (n - 1) as f64 - 1.0).collect();
        let weights = barycentric_weights(&places);
        Ok(Curve::interpolated(n - 1, |t| {
            let l = lagrange(&places, &weights, t);
            std::array::from_fn(|i| l.iter().zip(points).map(|(l, p)| l * p[i]).sum())
        }))
    }

    /// The graph `z(x)` from `x = from` to `x = to`, interpolated with degree [`CURVE_DEGREE`]. Cut the graph at its kinks and
    /// where it bends quickly: the error of a piece falls like its width to the ninth power.
    pub fn graph(from: f64, to: f64, z: impl Fn(f64) -> f64) -> Curve {
        Curve::interpolated(CURVE_DEGREE, |t| {
            let x = 0.5 * ((1.0 - t) * from + (1.0 + t) * to);
            [x, z(x)]
        })
    }

    /// This curve with a profile laid on it: every point is moved by `offset(position)` (mm) along the normal on the left of the walk,
    /// and the result interpolated with degree [`CURVE_DEGREE`]. For worn or machined shapes, cut as for [`Curve::graph`].
    pub fn with_profile(&self, offset: impl Fn([f64; 2]) -> f64) -> Curve {
        Curve::interpolated(CURVE_DEGREE, |t| {
            let (x, d) = (self.point(t), self.derivative(t));
            let step = offset(x) / d[0].hypot(d[1]);
            [x[0] - step * d[1], x[1] + step * d[0]]
        })
    }

    /// Whether the length grows in proportion to the parameter.
    fn has_constant_speed(&self) -> bool {
        matches!(self, Curve::Line { .. } | Curve::Arc { .. })
    }

    /// Whether the curve is a straight line.
    pub fn is_straight(&self) -> bool {
        matches!(self, Curve::Line { .. })
    }

    /// Position at `t`, mm.
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
            Curve::Polynomial { start, end, ref modes } => {
                let (a, b) = (0.5 * (1.0 - t), 0.5 * (1.0 + t));
                let mut x = [a * start[0] + b * end[0], a * start[1] + b * end[1]];
                let mut p = [1.0, t];
                for (k, mode) in (2..).zip(modes) {
                    let next = next_legendre(k, t, p);
                    let shape = (next - p[0]) / ((2 * (2 * k - 1)) as f64).sqrt();
                    (0..2).for_each(|i| x[i] += shape * mode[i]);
                    p = [p[1], next];
                }
                x
            }
        }
    }

    /// Derivative `dx/dt` at `t`, mm.
    pub fn derivative(&self, t: f64) -> [f64; 2] {
        match *self {
            Curve::Line { start, end } => [0.5 * (end[0] - start[0]), 0.5 * (end[1] - start[1])],
            Curve::Arc { radius, from, to, .. } => {
                let angle = 0.5 * ((1.0 - t) * from + (1.0 + t) * to);
                let rate = 0.5 * (to - from) * radius;
                [-rate * angle.sin(), rate * angle.cos()]
            }
            Curve::Polynomial { start, end, ref modes } => {
                let mut d = [0.5 * (end[0] - start[0]), 0.5 * (end[1] - start[1])];
                let mut p = [1.0, t];
                for (k, mode) in (2..).zip(modes) {
                    let slope = (0.5 * (2 * k - 1) as f64).sqrt() * p[1];
                    (0..2).for_each(|i| d[i] += slope * mode[i]);
                    p = [p[1], next_legendre(k, t, p)];
                }
                d
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
            Curve::Polynomial { .. } => Curve::interpolated(CURVE_DEGREE, |t| self.point(0.5 * ((1.0 - t) * a + (1.0 + t) * b))),
        }
    }

    /// The same curve walked the other way.
    pub fn reversed(&self) -> Curve {
        match *self {
            Curve::Line { start, end } => Curve::Line { start: end, end: start },
            Curve::Arc { centre, radius, from, to } => Curve::Arc { centre, radius, from: to, to: from },
            Curve::Polynomial { start, end, mut modes } => {
                modes.iter_mut().skip(1).step_by(2).flatten().for_each(|c| *c = -*c);
                Curve::Polynomial { start: end, end: start, modes }
            }
        }
    }

    /// Places between the ends, evenly in the parameter, at which what may be wrong somewhere on the curve is looked for.
    pub(crate) fn between_ends(&self) -> impl Iterator<Item = [f64; 2]> {
        (1..LOOKED_AT).map(|k| self.point(2.0 * f64::from(k) / f64::from(LOOKED_AT) - 1.0))
    }

    /// Position and derivative at `t` at once, up to round-off those of [`Curve::point`] and [`Curve::derivative`].
    pub(crate) fn jet(&self, t: f64) -> ([f64; 2], [f64; 2]) {
        match self {
            Curve::Line { .. } => (self.point(t), self.derivative(t)),
            Curve::Arc { centre, radius, from, to } => {
                let (sin, cos) = (0.5 * ((1.0 - t) * from + (1.0 + t) * to)).sin_cos();
                let rate = 0.5 * (to - from) * radius;
                ([centre[0] + radius * cos, centre[1] + radius * sin], [-rate * sin, rate * cos])
            }
            Curve::Polynomial { start, end, modes } => {
                let (a, b) = (0.5 * (1.0 - t), 0.5 * (1.0 + t));
                let mut x = [0, 1].map(|i| a * start[i] + b * end[i]);
                let mut d = [0, 1].map(|i| 0.5 * (end[i] - start[i]));
                let mut p = [1.0, t];
                for ((k, mode), scale) in (2..).zip(modes).zip(MODE_SCALES) {
                    let next = next_legendre(k, t, p);
                    let (shape, slope) = ((next - p[0]) / scale, 0.5 * scale * p[1]);
                    for i in 0..2 {
                        x[i] += shape * mode[i];
                        d[i] += slope * mode[i];
                    }
                    p = [p[1], next];
                }
                (x, d)
            }
        }
    }

    /// A bound for the distance from the chord at the same parameter, by component: at most `radius (to - from)^2 / 8` on an arc, whose
    /// second derivative is `radius ((to - from) / 2)^2`, and `|N_k| <= 2 / sqrt(2 (2k-1))` for the modes of a polynomial.
    pub(crate) fn bulge(&self) -> [f64; 2] {
        match self {
            Curve::Line { .. } => [0.0; 2],
            Curve::Arc { radius, from, to, .. } => [(radius * (to - from) * (to - from) / 8.0).min(2.0 * radius); 2],
            Curve::Polynomial { modes, .. } => {
                let bound = |i: usize| modes.iter().zip(MODE_SCALES).map(|(m, scale)| m[i].abs() * 2.0 / scale).sum();
                [bound(0), bound(1)]
            }
        }
    }

    /// The same curve between other ends: a line between them, a part of the same circle if they lie on it up to 1e-10 of the
    /// length, otherwise the polynomial to which the shifts of the ends are added linearly.
    pub(crate) fn with_ends(&self, start: [f64; 2], end: [f64; 2]) -> Curve {
        if self.point(-1.0) == start && self.point(1.0) == end {
            return *self;
        }
        match *self {
            Curve::Line { .. } => Curve::Line { start, end },
            Curve::Arc { centre, radius, from, to } => {
                let near = 1e-10 * self.length() + 1e-14 * (radius + centre[0].abs() + centre[1].abs());
                let on = |x: [f64; 2]| ((x[0] - centre[0]).hypot(x[1] - centre[1]) - radius).abs() <= near;
                // The angle of a point next to a given one.
                let angle = |x: [f64; 2], near: f64| {
                    let a = (x[1] - centre[1]).atan2(x[0] - centre[0]);
                    near + (a - near + PI).rem_euclid(TAU) - PI
                };
                if on(start) && on(end) {
                    return Curve::Arc { centre, radius, from: angle(start, from), to: angle(end, to) };
                }
                self.interpolated_between(start, end)
            }
            Curve::Polynomial { modes, .. } => Curve::Polynomial { start, end, modes },
        }
    }

    /// The polynomial of degree [`CURVE_DEGREE`] through the points of the curve, each moved by its share of the shifts of the ends.
    fn interpolated_between(&self, start: [f64; 2], end: [f64; 2]) -> Curve {
        let (a, b) = (self.point(-1.0), self.point(1.0));
        Curve::interpolated(CURVE_DEGREE, |t| {
            let (x, low, high) = (self.point(t), 0.5 * (1.0 - t), 0.5 * (1.0 + t));
            [0, 1].map(|i| x[i] + low * (start[i] - a[i]) + high * (end[i] - b[i]))
        })
    }

    /// Length of the curve, mm, up to round-off.
    pub fn length(&self) -> f64 {
        match *self {
            Curve::Line { start, end } => (end[0] - start[0]).hypot(end[1] - start[1]),
            Curve::Arc { radius, from, to, .. } => radius * (to - from).abs(),
            Curve::Polynomial { .. } => self.length_until(1.0),
        }
    }

    /// Length of the part before `t`, mm.
    pub fn length_until(&self, t: f64) -> f64 {
        if !self.has_constant_speed() {
            return self.length_between([-1.0, t], HALVINGS);
        }
        0.5 * (1.0 + t) * self.length()
    }

    /// Length between two parameters by Gauss quadrature with 24 points, in halves where 12 points tell another one: the difference of both is about the root of the error
    /// that is left.
    fn length_between(&self, [from, to]: [f64; 2], halvings: usize) -> f64 {
        let by = |points: usize| {
            let rule = gauss(points);
            let speed = |s: f64| {
                let d = self.derivative(0.5 * (to - from) * (1.0 + s) + from);
                d[0].hypot(d[1])
            };
            0.5 * (to - from) * rule.points.iter().zip(&rule.weights).map(|(s, w)| w * speed(*s)).sum::<f64>()
        };
        let (length, coarse) = (by(24), by(12));
        if halvings == 0 || (length - coarse).abs() <= ALIKE * length.abs() {
            return length;
        }
        let middle = 0.5 * (from + to);
        [[from, middle], [middle, to]].into_iter().map(|part| self.length_between(part, halvings - 1)).sum()
    }

    /// The parameter at which the length before it is `length` (mm), clamped to the curve.
    pub fn parameter_at_length(&self, length: f64) -> f64 {
        let total = self.length();
        let mut t = (2.0 * length / total - 1.0).clamp(-1.0, 1.0);
        if !self.has_constant_speed() {
            for _ in 0..30 {
                let d = self.derivative(t);
                let step = (self.length_until(t) - length) / d[0].hypot(d[1]);
                t = (t - step).clamp(-1.0, 1.0);
                if step.abs() < 1e-15 {
                    break;
                }
            }
        }
        t
    }
}

/// `P_k(t)` from `[P_{k-2}, P_{k-1}]`.
fn next_legendre(k: usize, t: f64, p: [f64; 2]) -> f64 {
    ((2 * k - 1) as f64 * t * p[1] - (k - 1) as f64 * p[0]) / k as f64
}
