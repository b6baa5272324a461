//! A wear law from a table: rates measured at a few pressures, between them the monotone cubic of Fritsch and Carlson (SIAM J. Numer. Anal. 17 (1980)
//! 238-246), beyond the last the straight line that it ends with. The worn-in pressure of a clutch under it.
//!
//! A law must grow with the pressure from where it begins, or a rate would not tell its pressure; a table that does not is refused.

use wear::{Optimum, OwnRule, Problem, RigidMode, Shape, SlidingMotion, Surface, WearError, optimal_pressure};

/// Pressures (MPa), wear by distance (um/m) at them, and the slopes of the cubics there.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    pressure: Vec<f64>,
    wear: Vec<f64>,
    slope: Vec<f64>,
}

impl Table {
    /// The law of pairs `[pressure, wear]`, with no wear at no pressure where the table does not say it.
    pub(crate) fn new(pairs: &[[f64; 2]]) -> Result<Table, String> {
        let origin = [[0.0; 2]];
        let begins = pairs.first().is_none_or(|pair| pair[0] > 0.0);
        let pairs = [if begins { &origin[..] } else { &[] }, pairs].concat();
        if pairs.len() < 2 || pairs[0] != [0.0; 2] {
            return Err("a table needs a pressure above 0, and no wear without pressure".into());
        }
        for pair in pairs.windows(2) {
            let [[p, w], [next, more]] = [pair[0], pair[1]];
            // No wear up to a threshold, growth from there.
            let grows = more > w || (more == 0.0 && w == 0.0);
            if !(next > p && grows && next.is_finite() && more.is_finite()) {
                return Err(format!("wear has to grow with the pressure: {w} um/m at {p} MPa, then {more} um/m at {next} MPa"));
            }
        }
        let [pressure, wear] = [0, 1].map(|column| pairs.iter().map(|pair| pair[column]).collect::<Vec<f64>>());
        let slope = slopes(&pressure, &wear);
        if slope.last().is_none_or(|slope| *slope <= 0.0) {
            return Err("the table ends without wear".into());
        }
        Ok(Table { pressure, wear, slope })
    }

    /// Wear by distance (um/m) at a pressure, and its slope.
    pub(crate) fn at(&self, p: f64) -> [f64; 2] {
        let last = self.pressure.len() - 1;
        if p >= self.pressure[last] {
            return [self.wear[last] + self.slope[last] * (p - self.pressure[last]), self.slope[last]];
        }
        let i = self.pressure.partition_point(|known| *known <= p).clamp(1, last) - 1;
        let h = self.pressure[i + 1] - self.pressure[i];
        let t = (p - self.pressure[i]) / h;
        let ([w0, w1], [d0, d1]) = ([self.wear[i], self.wear[i + 1]], [h * self.slope[i], h * self.slope[i + 1]]);
        // Hermite's cubic by powers of t.
        let (second, third) = (3.0 * (w1 - w0) - 2.0 * d0 - d1, d0 + d1 - 2.0 * (w1 - w0));
        [w0 + t * (d0 + t * (second + t * third)), (d0 + t * (2.0 * second + 3.0 * t * third)) / h]
    }

    /// The rule `w' = wear(p) v`; 1 um/m is 1e-6.
    pub(crate) fn rule(self) -> OwnRule {
        OwnRule::new(move |pressure, sliding_speed| self.at(pressure).map(|value| 1e-6 * value * sliding_speed))
    }
}

/// Slopes at the pairs: weighted harmonic means of those of the pieces, which keep the cubics monotone; the end pieces one-sided, kept below three times theirs.
fn slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let h: Vec<f64> = x.windows(2).map(|x| x[1] - x[0]).collect();
    let chord: Vec<f64> = y.windows(2).zip(&h).map(|(y, h)| (y[1] - y[0]) / h).collect();
    let pieces = chord.len();
    let end = |near: usize, next: usize| {
        let slope = ((2.0 * h[near] + h[next]) * chord[near] - h[near] * chord[next]) / (h[near] + h[next]);
        slope.clamp(0.0, 3.0 * chord[near])
    };
    (0..=pieces)
        .map(|i| match i {
            _ if pieces == 1 => chord[0],
            0 => end(0, 1),
            i if i == pieces => end(pieces - 1, pieces - 2),
            i if chord[i - 1] <= 0.0 || chord[i] <= 0.0 => 0.0,
            i => {
                let [left, right] = [h[i - 1] + 2.0 * h[i], 2.0 * h[i - 1] + h[i]];
                (left + right) / (left / chord[i - 1] + right / chord[i])
            }
        })
        .collect()
}

/// Worn-in pressure of a clutch ring 20-120 mm under 50 kN.
pub(crate) fn clutch(table: Table) -> Result<Optimum, WearError> {
    let ring = Surface::new(Shape::Annulus { radii: [20.0, 120.0] }, SlidingMotion::about_z(100.0))?;
    optimal_pressure(&Problem::new(ring, table.rule(), vec![RigidMode::press_down(5e4)]))
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Mild up to 1 MPa, then ever more.
    let table = Table::new(&[[0.5, 0.1], [1.0, 0.22], [1.5, 0.6], [2.0, 1.5], [4.0, 8.0]])?;
    let optimum = clutch(table.clone())?;
    let feed = optimum.feed.as_ref().map_or(f64::NAN, |feed| feed[0]);
    println!("{:>6} {:>9} {:>14}", "r/mm", "p/MPa", "wear/(um/m)");
    for radius in [20.0, 40.0, 80.0, 120.0] {
        let point = wear::SurfacePoint {
            position: wear::nalgebra::Vector3::new(radius, 0.0, 0.0),
            sliding_speed: 100.0 * radius,
            ..optimum.points[0]
        };
        let p = optimum.pressure_at(&point);
        println!("{radius:>6} {p:>9.4} {:>14.5}", table.at(p)[0]);
        // In the steady state the whole ring recedes at one rate.
        let rate = 1e-6 * table.at(p)[0] * point.sliding_speed;
        assert!((rate / feed - 1.0).abs() < 1e-9, "{rate} {feed}");
    }
    let refused = Table::new(&[[0.5, 0.1], [1.0, 0.3], [1.5, 0.2]]).err();
    println!("refused: {}", refused.unwrap_or_default());
    Ok(())
}
