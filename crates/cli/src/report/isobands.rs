//! Filled contours of a field given on grids of points.

use std::fmt::Write;

/// Colours of the bands from low to high: cividis-like steps that colour-blind readers and grey printers tell apart.
pub(crate) const BANDS: [&str; 12] = [
    "#00224e", "#0b3066", "#2b446c", "#434e6c", "#575d6d", "#6a6c71", "#7d7c78", "#928c78", "#a89d74", "#bfaf6c", "#d8c35c",
    "#fdea45",
];

/// A point on paper (pixels) with a value.
pub(crate) type Sample = ([f64; 2], f64);

/// Filled contours under construction: one path a band.
pub(crate) struct Isobands {
    low: f64,
    high: f64,
    paths: Vec<String>,
}

impl Isobands {
    /// Bands of equal width between two values; what lies beyond is drawn in the outermost colours.
    pub(crate) fn new(low: f64, high: f64) -> Isobands {
        Isobands { low, high, paths: vec![String::new(); BANDS.len()] }
    }

    /// Number of the band of a value.
    fn band(&self, value: f64) -> usize {
        let share = (value - self.low) / (self.high - self.low);
        ((share * BANDS.len() as f64).floor().max(0.0) as usize).min(BANDS.len() - 1)
    }

    /// Adds a convex polygon with a value at each corner, linear on each of the triangles at its first corner.
    pub(crate) fn piece(&mut self, corners: &[Sample]) {
        let Some((first, rest)) = corners.split_first() else { return };
        let band = self.band(first.1);
        if rest.iter().all(|corner| self.band(corner.1) == band) {
            self.polygon(band, &corners.iter().map(|corner| corner.0).collect::<Vec<_>>());
            return;
        }
        rest.windows(2).for_each(|pair| self.triangle([*first, pair[0], pair[1]]));
    }

    fn triangle(&mut self, corners: [Sample; 3]) {
        let bands = corners.map(|corner| self.band(corner.1));
        let (first, last) = (bands.into_iter().min().unwrap_or(0), bands.into_iter().max().unwrap_or(0));
        let step = (self.high - self.low) / BANDS.len() as f64;
        for band in first..=last {
            let mut rest: Vec<Sample> = corners.to_vec();
            if band > first {
                rest = cut(&rest, self.low + band as f64 * step, 1.0);
            }
            if band < last {
                rest = cut(&rest, self.low + (band + 1) as f64 * step, -1.0);
            }
            if rest.len() > 2 {
                let points: Vec<[f64; 2]> = rest.iter().map(|sample| sample.0).collect();
                self.polygon(band, &points);
            }
        }
    }

    fn polygon(&mut self, band: usize, points: &[[f64; 2]]) {
        let tenth = |x: f64| (10.0 * x).round() / 10.0;
        let size = |k: usize| {
            let range = points.iter().fold((f64::MAX, f64::MIN), |(lo, hi), p| (lo.min(p[k]), hi.max(p[k])));
            range.1 - range.0
        };
        // What is smaller than a tenth of a pixel cannot be seen; thin stripes side by side can.
        if size(0) < 0.1 && size(1) < 0.1 {
            return;
        }
        for (number, [x, y]) in points.iter().enumerate() {
            let _ = write!(self.paths[band], "{}{} {}", if number == 0 { "M" } else { "L" }, tenth(*x), tenth(*y));
        }
        self.paths[band].push('Z');
    }

    /// The bands as SVG; a thin line of their own colour closes the seams.
    pub(crate) fn svg(&self) -> String {
        let drawn = self.paths.iter().zip(BANDS).filter(|(path, _)| !path.is_empty());
        drawn
            .map(|(path, colour)| format!("<path d=\"{path}\" fill=\"{colour}\" stroke=\"{colour}\" stroke-width=\"0.5\"/>\n"))
            .collect()
    }

    /// The bar that tells the colours apart: from its upper left corner, with a label at every second step.
    pub(crate) fn bar(&self, [left, top]: [f64; 2], height: f64, label: &dyn Fn(f64) -> String) -> String {
        let count = BANDS.len();
        let step = height / count as f64;
        let mut out = String::new();
        for (band, colour) in BANDS.iter().enumerate() {
            let y = top + height - (band + 1) as f64 * step;
            out += &format!("<rect x=\"{left:.1}\" y=\"{y:.1}\" width=\"16\" height=\"{:.1}\" fill=\"{colour}\"/>\n", step + 0.3);
        }
        for mark in (0..=count).step_by(2) {
            let y = top + height - mark as f64 * step + 4.5;
            let value = self.low + (self.high - self.low) * mark as f64 / count as f64;
            out += &format!("<text x=\"{:.1}\" y=\"{y:.1}\">{}</text>\n", left + 22.0, label(value));
        }
        out
    }
}

/// The part of a convex polygon where `sign (value - level) >= 0`.
fn cut(polygon: &[Sample], level: f64, sign: f64) -> Vec<Sample> {
    let mut kept = Vec::new();
    for (i, here) in polygon.iter().enumerate() {
        let next = polygon[(i + 1) % polygon.len()];
        let (from, to) = (sign * (here.1 - level), sign * (next.1 - level));
        if from >= 0.0 {
            kept.push(*here);
        }
        if (from < 0.0) != (to < 0.0) {
            let t = from / (from - to);
            let between = |k: usize| here.0[k] + t * (next.0[k] - here.0[k]);
            kept.push(([between(0), between(1)], level));
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::{Isobands, cut};

    #[test]
    fn cutting_a_triangle_at_a_level_keeps_the_side_asked_for() {
        let triangle = [([0.0, 0.0], 0.0), ([2.0, 0.0], 2.0), ([0.0, 2.0], 2.0)];
        let above = cut(&triangle, 1.0, 1.0);
        assert_eq!(above.iter().map(|s| s.0).collect::<Vec<_>>(), [[1.0, 0.0], [2.0, 0.0], [0.0, 2.0], [0.0, 1.0]]);
        assert_eq!(cut(&triangle, 1.0, -1.0).len(), 3);
    }

    #[test]
    fn values_beyond_the_range_are_drawn_in_the_outermost_colours() {
        let mut bands = Isobands::new(0.0, 12.0);
        bands.piece(&[([0.0, 0.0], -50.0), ([9.0, 0.0], -50.0), ([9.0, 9.0], 50.0), ([0.0, 9.0], 50.0)]);
        assert!(bands.paths.iter().all(|path| !path.is_empty()));
    }
}
