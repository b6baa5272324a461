//! The surface to machine into body 1: nominal surface plus gap along the normal, as points and as a spline.

use shapeopt::{Fit, Spline};

/// Evenly spaced points of the table.
const POINTS: usize = 1001;
/// Largest deviation of the spline from the computed surface: mm, and relative to the coordinates of large surfaces, which have no
/// more digits.
const DEVIATION: [f64; 2] = [5e-10, 1e-12];

/// A point of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Arc length from the middle along the nominal surface, or r (mm).
    pub s: f64,
    /// Nominal place (x, z), mm.
    pub nominal: [f64; 2],
    /// Unit normal out of body 2 into body 1.
    pub normal: [f64; 2],
    /// Gap along the normal, mm.
    pub gap: f64,
}

impl SurfacePoint {
    /// Place of the finished surface (x, z), mm.
    pub fn finished(&self) -> [f64; 2] {
        [0, 1].map(|k| self.nominal[k] + self.gap * self.normal[k])
    }
}

/// The finished surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Machined {
    /// Evenly spaced points.
    pub points: Vec<SurfacePoint>,
    /// Finished x, finished z and gap (mm) over s.
    pub fit: Fit<3>,
    /// The rigid datum: where the gap is least, 0 unless the rigid part is prescribed.
    pub datum: SurfacePoint,
    /// Where most is taken off: the largest gap.
    pub deepest: SurfacePoint,
}

impl Machined {
    /// The finished surface over a range of s.
    pub fn new(surface: impl Fn(f64) -> SurfacePoint, [from, to]: [f64; 2]) -> Machined {
        let last = POINTS - 1;
        let at = |i: usize| if i == last { to } else { from + (to - from) * i as f64 / last as f64 };
        let points: Vec<SurfacePoint> = (0..POINTS).map(|i| surface(at(i))).collect();
        let curve = |s: f64| {
            let point = surface(s);
            let [x, z] = point.finished();
            [x, z, point.gap]
        };
        let size = points.iter().flat_map(SurfacePoint::finished).fold(0.0, |most: f64, x| most.max(x.abs()));
        let fit = Spline::fit(curve, [from, to], DEVIATION[0].max(DEVIATION[1] * size));
        let known = || fit.spline.knots.iter().map(|s| surface(*s)).chain(points.iter().copied());
        let extreme = |sign: f64| known().min_by(|a, b| (sign * a.gap).total_cmp(&(sign * b.gap))).unwrap_or(points[0]);
        Machined { datum: extreme(1.0), deepest: extreme(-1.0), points, fit }
    }
}
