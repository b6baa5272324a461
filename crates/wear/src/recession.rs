//! Mean wear of a revolving counter-face along its closed tracks: W2' = (1/2pi) int w2' d(angle).

use crate::quadrature::{ORDER, legendre};
use crate::{Shape, Surface, SurfacePoint};

/// Most rings, and how far apart their radii are at most in log r unless there are as many.
const MOST: usize = 8;
const WIDTH: f64 = 3.0;

/// W2' in mm/s as a function of the track: constant on a drum, on a disc a polynomial in log r on each of some rings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Recession {
    /// At the Gauss points of the rings, from the inner one outwards.
    pub(crate) values: [f64; MOST * ORDER],
    /// Inner and outer radius where the tracks are circles about the z axis.
    pub(crate) radii: Option<[f64; 2]>,
}

impl Recession {
    pub(crate) fn none(surface: &Surface) -> Self {
        let radii = match surface.shape() {
            Shape::Sector { radii, .. } => Some(*radii).filter(|radii| radii[0] > 0.0),
            Shape::Points(_)
            | Shape::Arc { .. }
            | Shape::Strip { .. }
            | Shape::Annulus { .. }
            | Shape::Rectangle { .. }
            | Shape::Ellipse { .. } => None,
        };
        Self { values: [0.0; MOST * ORDER], radii }
    }

    /// Number of rings: as many as make W2' a polynomial on each to round-off.
    fn rings(&self) -> usize {
        let width = self.radii.map_or(0.0, |[inner, outer]| (outer / inner).ln());
        ((width / WIDTH).ceil() as usize).clamp(1, MOST)
    }

    /// Radii of the tracks whose values are kept, as logarithms of their ratio to the inner one; none on a drum.
    pub(crate) fn tracks(&self) -> Vec<f64> {
        let Some([inner, outer]) = self.radii else { return Vec::new() };
        let (rings, width) = (self.rings(), (outer / inner).ln());
        let track = |n: usize| width * ((n / ORDER) as f64 + legendre().abscissa[n % ORDER]) / rings as f64;
        (0..rings * ORDER).map(track).collect()
    }

    /// W2' of the track through a point.
    pub(crate) fn at(&self, point: &SurfacePoint) -> f64 {
        let Some(radii) = self.radii else {
            return self.values[0];
        };
        let r = point.position.x.hypot(point.position.y);
        let rings = self.rings();
        let along = (r / radii[0]).ln() / (radii[1] / radii[0]).ln() * rings as f64;
        let ring = (along.max(0.0) as usize).min(rings - 1);
        let t = along - ring as f64;
        let values = &self.values[ring * ORDER..(ring + 1) * ORDER];
        // Barycentric interpolation at the Gauss points; weights (-1)^i sqrt(x (1 - x) w).
        let rule = legendre();
        let (mut above, mut below) = (0.0, 0.0);
        for (i, value) in values.iter().copied().enumerate() {
            let distance = t - rule.abscissa[i];
            if distance == 0.0 {
                return value;
            }
            let x = rule.abscissa[i];
            let weight = (x * (1.0 - x) * rule.weight[i]).sqrt() / distance;
            let signed = if i % 2 == 0 { weight } else { -weight };
            above += signed * value;
            below += signed;
        }
        above / below
    }
}
