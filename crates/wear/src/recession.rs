//! Mean wear of a revolving counter-face along its closed tracks: W2' = (1/2pi) int w2' d(angle).

use crate::quadrature::{ORDER, legendre};
use crate::{Shape, Surface, SurfacePoint};

/// W2' in mm/s as a function of the track: constant on a drum, a polynomial in log r on a disc.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Recession {
    pub(crate) values: [f64; ORDER],
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
        Self { values: [0.0; ORDER], radii }
    }

    /// W2' of the track through a point.
    pub(crate) fn at(&self, point: &SurfacePoint) -> f64 {
        let Some(radii) = self.radii else {
            return self.values[0];
        };
        let r = point.position.x.hypot(point.position.y);
        let t = (r / radii[0]).ln() / (radii[1] / radii[0]).ln();
        // Barycentric interpolation at the Gauss points; weights (-1)^i sqrt(x (1 - x) w).
        let rule = legendre();
        let (mut above, mut below) = (0.0, 0.0);
        for i in 0..ORDER {
            let distance = t - rule.abscissa[i];
            if distance == 0.0 {
                return self.values[i];
            }
            let x = rule.abscissa[i];
            let weight = (x * (1.0 - x) * rule.weight[i]).sqrt() / distance;
            let signed = if i % 2 == 0 { weight } else { -weight };
            above += signed * self.values[i];
            below += signed;
        }
        above / below
    }
}
