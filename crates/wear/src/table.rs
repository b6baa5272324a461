//! The wear rule from a table: specific wear rates measured at a few pressures.

use thiserror::Error;

use crate::OwnRule;

/// Wear by distance (mm of depth by mm of sliding) as a function of the pressure, through measured pairs: between them the monotone cubic of Fritsch
/// and Carlson (SIAM J. Numer. Anal. 17 (1980) 238-246), with no wear at no pressure before the first and beyond the last the straight line that it
/// ends with. Its rule is `w' = W(p) v`.
#[derive(Clone, Debug, PartialEq)]
pub struct TableLaw {
    pressure: Vec<f64>,
    wear: Vec<f64>,
    slope: Vec<f64>,
}

/// A table that no law goes through.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("row {row} of the table (counted from 0): {why}")]
pub struct TableError {
    /// Place of the pair.
    pub row: usize,
    /// The reason.
    pub why: &'static str,
}

impl TableLaw {
    /// The law of pairs `[p, W]`: pressures in MPa, wear by distance in mm/mm (1 um/m is 1e-6); a specific wear rate k in mm^3/(N mm) is W/p.
    ///
    /// # Errors
    /// [`TableError`] where the pressures do not increase, where W does not grow with the pressure from where it begins (a rate would not tell its
    /// pressure), and where there is no pair with wear; it names the pair.
    pub fn new(pairs: &[[f64; 2]]) -> Result<TableLaw, TableError> {
        let origin = [[0.0; 2]];
        let begins = pairs.first().is_none_or(|pair| pair[0] > 0.0);
        let pairs = [if begins { &origin[..] } else { &[] }, pairs].concat();
        let shift = usize::from(begins);
        let wrong = |row: usize, why| Err(TableError { row: row.saturating_sub(shift), why });
        if pairs[0] != [0.0; 2] {
            return wrong(0, "the first pressure is not greater than 0, or wears at no pressure");
        }
        for (row, pair) in pairs.windows(2).enumerate() {
            let [[p, w], [next, more]] = [pair[0], pair[1]];
            if !(next > p && next.is_finite()) {
                return wrong(row + 1, "its pressure is not greater than the one before it");
            }
            // No wear up to a threshold, growth from there.
            let grows = more > w || (more == 0.0 && w == 0.0);
            if !(grows && more.is_finite()) {
                return wrong(row + 1, "its wear by distance, k p, is not greater than the one before it");
            }
        }
        if pairs.last().is_none_or(|pair| pair[1] == 0.0) {
            return wrong(pairs.len() - 1, "it is the last one, and nothing wears up to it");
        }
        let [pressure, wear] = [0, 1].map(|column| pairs.iter().map(|pair| pair[column]).collect::<Vec<f64>>());
        let slope = slopes(&pressure, &wear);
        Ok(TableLaw { pressure, wear, slope })
    }

    /// Wear by distance (mm/mm) at a pressure, and its slope (1/MPa).
    pub fn at(&self, p: f64) -> [f64; 2] {
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

    /// The largest pressure of the table (MPa), up to which the law is known.
    pub fn largest_pressure(&self) -> f64 {
        self.pressure[self.pressure.len() - 1]
    }
}

impl From<TableLaw> for OwnRule {
    fn from(table: TableLaw) -> OwnRule {
        let numbers = [table.pressure.as_slice(), &table.wear].concat();
        // Nothing wears below the first of them that wears: no pressure of a steady state passes it.
        let bends = table.pressure.iter().zip(&table.wear).filter(|(_, wear)| **wear > 0.0).map(|(p, _)| *p).collect();
        let rate = move |pressure, sliding_speed| table.at(pressure).map(|value| value * sliding_speed);
        let mut rule = OwnRule::named("from a table", numbers, rate);
        rule.bends = bends;
        rule
    }
}

/// Slopes at the pairs: weighted harmonic means of those of the pieces, which keep the cubics monotone; the end pieces one-sided, kept within three
/// times theirs, the last one above zero.
fn slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let h: Vec<f64> = x.windows(2).map(|x| x[1] - x[0]).collect();
    let chord: Vec<f64> = y.windows(2).zip(&h).map(|(y, h)| (y[1] - y[0]) / h).collect();
    let pieces = chord.len();
    let end = |near: usize, next: usize, least: f64| {
        let slope = ((2.0 * h[near] + h[next]) * chord[near] - h[near] * chord[next]) / (h[near] + h[next]);
        slope.clamp(least * chord[near], 3.0 * chord[near])
    };
    (0..=pieces)
        .map(|i| match i {
            _ if pieces == 1 => chord[0],
            0 => end(0, 1, 0.0),
            // Beyond the table wear goes on growing, or a rate would not tell its pressure.
            i if i == pieces => end(pieces - 1, pieces - 2, 0.1),
            i if chord[i - 1] <= 0.0 || chord[i] <= 0.0 => 0.0,
            i => {
                let [left, right] = [h[i - 1] + 2.0 * h[i], 2.0 * h[i - 1] + h[i]];
                (left + right) / (left / chord[i - 1] + right / chord[i])
            }
        })
        .collect()
}
