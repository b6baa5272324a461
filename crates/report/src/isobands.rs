//! Filled contours of a field given on grids of points.

use std::fmt::Write;

use crate::reach::by_value;
use wearshape::CellGrid;

/// Colours of the bands from low to high: cividis-like steps that colour-blind readers and grey printers tell apart.
const BANDS: [&str; 12] = [
    "#00224e", "#0b3066", "#2b446c", "#434e6c", "#575d6d", "#6a6c71", "#7d7c78", "#928c78", "#a89d74", "#bfaf6c", "#d8c35c",
    "#fdea45",
];

/// Share of the area below and above which values are drawn in the outermost colours.
const CLIP: f64 = 0.02;

/// How far below the top of a drawing the unit of its bar is written, and the bar begins, in pixels: letters are larger on a phone.
pub(crate) const UNIT: f64 = 2.0;
pub(crate) const BAR: f64 = 22.0;

/// A point on paper (pixels) with a value.
pub(crate) type Sample = ([f64; 2], f64);

/// A cell's grid with its points on paper.
pub type Placed = (CellGrid, Vec<Sample>);

/// Filled contours under construction: one path a band.
pub struct Isobands {
    low: f64,
    high: f64,
    paths: Vec<String>,
}

impl Isobands {
    /// The bands of cells cut into pieces of about a size in pixels, between the 2 and 98 per cent quantiles of their values by area: at the
    /// corners of a held, loaded or sharp edge a stress is infinite, and its largest number means nothing.
    pub fn of(cells: &[Placed], size: f64) -> Isobands {
        let pieces: Vec<Vec<Sample>> = cells.iter().flat_map(|cell| pieces(cell, size)).collect();
        let [low, high] = quantiles(&pieces);
        let mut bands = Isobands::new(low, high);
        pieces.iter().for_each(|piece| bands.piece(piece));
        bands
    }

    /// The bands of cells cut into pieces of about a size in pixels, between two values.
    pub(crate) fn between(cells: &[Placed], size: f64, [low, high]: [f64; 2]) -> Isobands {
        let wide = high - low > 1e-9 * high.abs().max(low.abs());
        let mut bands = if wide { Isobands::new(low, high) } else { Isobands::new(low - 0.5, high + 0.5) };
        cells.iter().flat_map(|cell| pieces(cell, size)).for_each(|piece| bands.piece(&piece));
        bands
    }

    /// Bands of equal width between two values; what lies beyond is drawn in the outermost colours.
    fn new(low: f64, high: f64) -> Isobands {
        Isobands { low, high, paths: vec![String::new(); BANDS.len()] }
    }

    /// Number of the band of a value.
    fn band(&self, value: f64) -> usize {
        let share = (value - self.low) / (self.high - self.low);
        ((share * BANDS.len() as f64).floor().max(0.0) as usize).min(BANDS.len() - 1)
    }

    /// Adds a convex polygon with a value at each corner, linear on each of the triangles at its first corner.
    fn piece(&mut self, corners: &[Sample]) {
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
    pub fn svg(&self) -> String {
        let drawn = self.paths.iter().zip(BANDS).filter(|(path, _)| !path.is_empty());
        drawn
            .map(|(path, colour)| format!("<path d=\"{path}\" fill=\"{colour}\" stroke=\"{colour}\" stroke-width=\"0.5\"/>\n"))
            .collect()
    }

    /// The bar that tells the colours apart: from its upper left corner, with a label at every second step.
    pub fn bar(&self, [left, top]: [f64; 2], height: f64) -> String {
        let count = BANDS.len();
        let decade = ((self.high - self.low) / count as f64).max(f64::MIN_POSITIVE).log10().floor();
        let label = |value: f64| match decade {
            -4.0..4.0 => format!("{value:.*}", (1.0 - decade).clamp(0.0, 6.0) as usize),
            _ => format!("{value:.2e}"),
        };
        let step = height / count as f64;
        let mut out = String::new();
        for (band, colour) in BANDS.iter().enumerate() {
            let y = top + height - (band + 1) as f64 * step;
            out += &format!("<rect x=\"{left:.1}\" y=\"{y:.1}\" width=\"16\" height=\"{:.1}\" fill=\"{colour}\"/>\n", step + 0.3);
        }
        for mark in (0..=count).step_by(2) {
            let y = top + height - mark as f64 * step + 4.5;
            let value = self.low + (self.high - self.low) * mark as f64 / count as f64;
            out += &format!("<text x=\"{:.1}\" y=\"{y:.1}\">{}</text>\n", left + 22.0, label(value).replace('-', "\u{2212}"));
        }
        out
    }
}

/// Cuts a cell into pieces of about one size, between points of its grid.
fn pieces((grid, at): &Placed, size: f64) -> Vec<Vec<Sample>> {
    let p = grid.degree;
    let length = |step: &dyn Fn(usize) -> usize| {
        let nodes: Vec<[f64; 2]> = (0..=p).map(|i| at[step(i)].0).collect();
        nodes.windows(2).map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum::<f64>()
    };
    let count = |length: f64| ((length / size).ceil() as usize).clamp(1, p);
    // A triangle has its third side instead of a last row and a last column.
    let [row, column] = match grid.triangle {
        true => [length(&|i| grid.at(p - i, i)); 2],
        false => [length(&|i| grid.at(i, p)), length(&|j| grid.at(p, j))],
    };
    let (along, up) = (count(length(&|i| grid.at(i, 0)).max(row)), count(length(&|j| grid.at(0, j)).max(column)));
    grid.pieces(along, up).into_iter().map(|nodes| nodes.into_iter().map(|k| at[k]).collect()).collect()
}

/// Values below and above which lies the clipped share of the area.
fn quantiles(pieces: &[Vec<Sample>]) -> [f64; 2] {
    let share = |piece: &Vec<Sample>| {
        let p = |k: usize| piece[k % piece.len()].0;
        let area = 0.5 * (0..piece.len()).map(|k| p(k)[0] * p(k + 1)[1] - p(k)[1] * p(k + 1)[0]).sum::<f64>();
        (piece.iter().map(|corner| corner.1).sum::<f64>() / piece.len() as f64, area.abs())
    };
    let mut shares: Vec<(f64, f64)> = pieces.iter().map(share).filter(|share| share.0.is_finite()).collect();
    by_value(&mut shares);
    let total: f64 = shares.iter().map(|share| share.1).sum();
    let at = |part: f64| {
        let mut sum = 0.0;
        let found = shares.iter().find(|share| {
            sum += share.1;
            sum >= part * total
        });
        found.or(shares.last()).map_or(0.0, |share| share.0)
    };
    let [low, high] = [at(CLIP), at(1.0 - CLIP)];
    if high - low > 1e-9 * high.abs().max(low.abs()) { [low, high] } else { [low - 1.0, high + 1.0] }
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
    use super::{Isobands, Placed, cut};
    use wearshape::CellGrid;

    #[test]
    fn a_peak_on_a_small_area_does_not_take_the_colours_from_the_rest() {
        let cell = |left: f64, width: f64, value: f64| -> Placed {
            let corners = [[left, 0.0], [left + width, 0.0], [left, 10.0], [left + width, 10.0]];
            (CellGrid { degree: 1, triangle: false }, corners.map(|x| (x, value)).to_vec())
        };
        let bands = Isobands::of(&[cell(0.0, 50.0, 1.0), cell(50.0, 50.0, 2.0), cell(100.0, 1.0, 1e6)], 6.0);
        assert_eq!((bands.low, bands.high), (1.0, 2.0));
        let bar = bands.bar([0.0, 0.0], 100.0);
        assert!(bar.contains(">1.000<") && bar.contains(">2.000<"), "{bar}");
        // One value everywhere is a picture too.
        assert!(!Isobands::of(&[cell(0.0, 50.0, 3.0)], 6.0).svg().is_empty());
    }

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
