//! The gap between two circles of different radii that touch at one place: a shaft in its housing.
//!
//! ```text
//!   body 1 around body 2: they touch at the top      body 1 inside body 2: at the bottom
//!          . - ~ - .   R1 = R2 + c                          . - ~ - .   R1 = R2 - c
//! ```
//! With the clearance `c = |R1 - R2|` the ray from the centre of body 2 at an angle phi from the touch meets body 1's circle at the distance
//!
//! - `rho = -c cos phi + sqrt(R1^2 - c^2 sin^2 phi)` where body 1 is the hole, and the gap along body 2's normal is `g = rho - R2`;
//! - `rho = c cos phi + sqrt(R1^2 - c^2 sin^2 phi)` where body 1 is the shaft, and the gap is `g = R2 - rho`.
//!
//! Two round bodies that touch from outside have `rho = d cos phi - sqrt(R1^2 - d^2 sin^2 phi)` with `d = R1 + R2`, and the gap is `g = rho - R2`.
//!
//! Near the touch that is the parabola of Hertz, `s^2/2 (1/R_shaft - 1/R_hole)`, from outside `s^2/2 (1/R1 + 1/R2)`, with `s = R2 phi`.

use std::f64::consts::PI;

/// Two circles that touch on the line through their centres, along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Circles {
    /// Radii of body 1 and body 2 (mm).
    radii: [f64; 2],
    /// Angle (rad, from the z axis towards +x) at s = 0 on body 2, and whether it falls with s.
    middle: f64,
    backwards: bool,
    /// Whether both are round bodies that touch from outside.
    outside: bool,
}

impl Circles {
    /// Circles of body 1 and 2 by their radii; s = 0 on body 2 lies at the angle `middle`, which falls with s if `backwards`.
    pub(crate) fn new(radii: [f64; 2], middle: f64, backwards: bool) -> Circles {
        Circles { radii, middle, backwards, outside: false }
    }

    /// Circles that touch from outside, at the top of body 2.
    pub(crate) fn outside(radii: [f64; 2], middle: f64) -> Circles {
        Circles { radii, middle, backwards: false, outside: true }
    }

    /// Where they touch (arc length from the middle of the surface), and the radius of the cylinder on a plane with the same gap there (mm).
    pub(crate) fn touch(&self) -> (f64, f64) {
        let [first, second] = self.radii;
        let s = second * (self.middle - self.top());
        let curvature = if self.outside { 1.0 / first + 1.0 / second } else { (1.0 / first - 1.0 / second).abs() };
        (if self.backwards { s } else { -s }, 1.0 / curvature)
    }

    /// The angle on body 2 where they touch.
    fn top(&self) -> f64 {
        if self.outside || self.radii[0] > self.radii[1] { 0.0 } else { PI }
    }

    /// The gap (mm) along body 2's normal at an arc length from the middle of the contact surface on body 2.
    pub(crate) fn gap(&self, s: f64) -> f64 {
        let [first, second] = self.radii;
        let hole = first > second;
        let turned = s / second;
        let phi = self.middle - self.top() + if self.backwards { -turned } else { turned };
        if self.outside {
            let distance = first + second;
            let across = distance * phi.sin();
            let root = ((first - across) * (first + across)).max(0.0).sqrt();
            return across * across / (first + root) - 2.0 * distance * (0.5 * phi).sin().powi(2);
        }
        let clearance = (first - second).abs();
        let across = clearance * phi.sin();
        let flattened = across * across / (first + ((first - across) * (first + across)).sqrt());
        let rise = 2.0 * clearance * (0.5 * phi).sin().powi(2);
        if hole { rise - flattened } else { rise + flattened }
    }
}

#[cfg(test)]
mod tests {
    use super::Circles;
    use std::f64::consts::PI;

    #[test]
    fn the_ray_from_the_centre_of_body_2_ends_on_the_circle_of_body_1() {
        for (radii, touch, lower) in [([26.0, 24.0], 0.0, -2.0), ([24.0, 26.0], PI, -2.0), ([25.05, 25.0], 0.0, -0.05)] {
            for phi in [-1.3_f64, -0.2, 0.0, 1e-3, 0.7, 1.2] {
                let angle = touch + phi;
                let gap = Circles::new(radii, touch + 0.1, false).gap(radii[1] * (phi - 0.1));
                let reach = if touch == 0.0 { radii[1] + gap } else { radii[1] - gap };
                let point = [reach * angle.sin(), reach * angle.cos()];
                let off = point[0].hypot(point[1] - lower) - radii[0];
                assert!(off.abs() < 1e-13 * radii[0], "{radii:?} {phi}: {off:e}");
            }
        }
    }

    #[test]
    fn from_outside_the_ray_ends_on_the_circle_of_body_1_too() {
        for radii in [[10.0_f64, 25.0], [25.0, 10.0], [10.0, 10.0]] {
            let circles = Circles::outside(radii, 0.01);
            let distance = radii[0] + radii[1];
            for s in [-2.0_f64, -0.3, 0.0, 1e-3, 2.5] {
                let (angle, reach) = (0.01 + s / radii[1], radii[1] + circles.gap(s));
                let off = (reach * angle.sin()).hypot(reach * angle.cos() - distance) - radii[0];
                assert!(off.abs() < 1e-13 * distance, "{radii:?} {s}: {off:e}");
            }
            let (s, radius) = circles.touch();
            let parabola = 0.5 * 1e-6 * (1.0 / radii[0] + 1.0 / radii[1]);
            assert!(
                (circles.gap(s + 1e-3) / parabola - 1.0).abs() < 1e-6 && (1e-6 / (2.0 * radius) / parabola - 1.0).abs() < 1e-12
            );
        }
    }

    #[test]
    fn near_the_touch_the_gap_is_the_parabola_of_hertz() {
        for radii in [[26.0, 24.0_f64], [24.0, 26.0]] {
            let touch = if radii[0] > radii[1] { 0.0 } else { PI };
            let s = 1e-3;
            let parabola = 0.5 * s * s * (1.0 / 24.0 - 1.0 / 26.0);
            for backwards in [false, true] {
                let gap = Circles::new(radii, touch, backwards).gap(s);
                assert!((gap / parabola - 1.0).abs() < 1e-8, "{gap:e} {parabola:e}");
            }
        }
    }
}
