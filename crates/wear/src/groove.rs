//! The groove that a ball wears into a revolving disc.
//!
//! Each point of the disc at the distance `y` from the middle of its track passes the contact once a turn, along a chord of it. Where body 2 would
//! wear by `w(r)` (mm) if it stood still under the ball, the groove is as deep as
//! ```text
//!   G(y) = 1/(2 pi R_t) int w(sqrt(x^2 + y^2)) dx = 1/(pi R_t) int_y^inf w(r) r / sqrt(r^2 - y^2) dr     (Abel transform)
//! ```
//! with the radius `R_t` of the track, which is long against the contact. About the axis of the ball its mean on a circle is
//! `(2/pi) int_0^(pi/2) G(r sin f) df`: all of it that an axisymmetric contact knows.

use nalgebra::DMatrix;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Places on a quarter of a circle for its mean.
const PLACES: usize = 64;

/// A track on a disc, under a contact that is known on circles.
#[derive(Clone, Debug)]
pub struct Groove {
    length: f64,
    /// Squares of the radii (mm^2).
    squares: Vec<f64>,
}

impl Groove {
    /// The track of a radius (mm) under a contact with points at ascending radii (mm); between them its wear is linear in the square of the radius.
    pub fn new(track_radius: f64, radii: &[f64]) -> Groove {
        Groove { length: TAU * track_radius, squares: radii.iter().map(|r| r * r).collect() }
    }

    /// Depth (mm) at a distance (mm) from the middle of the track, from the wear (mm) that the contact points would make standing still;
    /// none where the list ends before them.
    pub fn depth(&self, wear: &[f64], y: f64) -> f64 {
        let mut depth = 0.0;
        self.chord(y, |j, length| depth += length * wear.get(j).copied().unwrap_or(0.0));
        depth / self.length
    }

    /// Mean depth on the circle of each contact point (row) of the groove by a wear of 1 at each of them (column).
    pub fn mean(&self) -> DMatrix<f64> {
        let n = self.squares.len();
        let mut mean = DMatrix::zeros(n, n);
        let share = 1.0 / (PLACES as f64 * self.length);
        for i in 0..n {
            let radius = self.squares[i].sqrt();
            for place in 0..PLACES {
                let angle = FRAC_PI_2 * (place as f64 + 0.5) / PLACES as f64;
                self.chord(radius * angle.sin(), |j, length| mean[(i, j)] += share * length);
            }
        }
        mean
    }

    /// What each contact point adds to an integral along the chord at a distance from the middle: its number and the weight of its value.
    fn chord(&self, y: f64, mut add: impl FnMut(usize, f64)) {
        let w = y * y;
        for j in 1..self.squares.len() {
            let [from, to] = [self.squares[j - 1], self.squares[j]];
            if to <= w || to <= from {
                continue;
            }
            // Integrals of 1 and s over 1/sqrt(s), with s the square of the radius less w.
            let [a, b] = [(from.max(w) - w).sqrt(), (to - w).sqrt()];
            let (of_one, of_s) = (2.0 * (b - a), 2.0 / 3.0 * (b.powi(3) - a.powi(3)));
            let outer = (of_s - (from - w) * of_one) / (to - from);
            add(j - 1, of_one - outer);
            add(j, outer);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Groove;
    use std::f64::consts::{PI, TAU};

    fn radii() -> Vec<f64> {
        (0..=200).map(|i| 0.02 * f64::from(i)).collect()
    }

    #[test]
    fn a_paraboloid_wears_the_groove_of_its_abel_transform() {
        // w = 1 - r^2/9 up to 3: int w dx = 4/3 (9 - y^2)^(3/2) / 9.
        let (radii, track) = (radii(), 50.0);
        let wear: Vec<f64> = radii.iter().map(|r| (1.0 - r * r / 9.0).max(0.0)).collect();
        let groove = Groove::new(track, &radii);
        for y in [0.0, 0.7, 1.9, 2.9] {
            let exact = 4.0 / 27.0 * (9.0_f64 - y * y).powf(1.5) / (TAU * track);
            approx::assert_relative_eq!(groove.depth(&wear, y), exact, max_relative = 1e-10);
        }
        assert_eq!(groove.depth(&wear, 3.5), 0.0);
        // What is worn off the disc is what the contact wears.
        let n = 4000;
        let y = |i: usize| 3.0 * (i as f64 + 0.5) / n as f64;
        let volume: f64 = (0..n).map(|i| 2.0 * TAU * track * groove.depth(&wear, y(i)) * 3.0 / n as f64).sum();
        approx::assert_relative_eq!(volume, PI * 9.0 / 2.0, max_relative = 1e-6);
    }

    #[test]
    fn the_mean_on_a_circle_is_that_of_the_groove() {
        let radii = radii();
        let wear: Vec<f64> = radii.iter().map(|r| (1.0 - r * r / 9.0).max(0.0)).collect();
        let groove = Groove::new(20.0, &radii);
        let mean = groove.mean() * nalgebra::DVector::from_column_slice(&wear);
        approx::assert_relative_eq!(mean[0], groove.depth(&wear, 0.0), max_relative = 1e-12);
        for i in [40, 100, 190] {
            let n = 20_000;
            let angle = |k: usize| TAU * (k as f64 + 0.5) / n as f64;
            let exact: f64 = (0..n).map(|k| groove.depth(&wear, (radii[i] * angle(k).sin()).abs()) / n as f64).sum();
            approx::assert_relative_eq!(mean[i], exact, max_relative = 1e-4);
        }
    }
}
