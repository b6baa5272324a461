//! A curve through the rows of a profile: cubic where they are those of a smooth curve, with a corner where they have one.

use shapeopt::Spline;

/// Rows to each side among which a turn is compared, and the share of all their turns from which one is a corner. Rows that lie on a smooth curve
/// share their turns: of seven on a parabola each has a seventh, of the four at its end a quarter. A row by itself has all, the two of a chamfer
/// have half each.
const WINDOW: usize = 3;
const CORNER: f64 = 0.4;

/// Jump of the slope, over the steepest, from which a corner asks for nodes; distance of rows, over all of them, up to which they are as close as those of layers; and
/// how many are many.
const MUCH: f64 = 0.05;
const CLOSE: f64 = 1e-3;
const MANY: usize = 12;

/// A curve through rows, or near them: splines between corners, constant beyond both ends.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RowCurve {
    /// Where each piece ends, ascending.
    ends: Vec<f64>,
    pieces: Vec<Spline<1>>,
}

impl RowCurve {
    /// The curve through rows (two at least, ascending): between corners a cubic spline, twice continuously differentiable ("not a knot": de Boor
    /// 1978, chapter IV), a parabola through three rows, a line through two.
    pub(crate) fn through(s: &[f64], values: &[f64]) -> RowCurve {
        let last = s.len().saturating_sub(1);
        let mut corners: Vec<usize> = vec![0];
        corners.extend(corners_of(s, values));
        corners.push(last);
        let piece = |ends: &[usize]| {
            let rows = ends[0]..=ends[1];
            let values: Vec<[f64; 1]> = values[rows.clone()].iter().map(|value| [*value]).collect();
            few(&s[rows.clone()], &values).unwrap_or_else(|| Spline::through(s[rows].to_vec(), &values))
        };
        RowCurve { ends: corners[1..].iter().map(|row| s[*row]).collect(), pieces: corners.windows(2).map(piece).collect() }
    }

    /// One spline.
    pub(super) fn of(spline: Spline<1>) -> RowCurve {
        RowCurve { ends: spline.knots.last().copied().into_iter().collect(), pieces: vec![spline] }
    }

    /// The value at a place; beyond the ends that of the end.
    pub(crate) fn at(&self, s: f64) -> f64 {
        let Some((first, last)) = self.pieces.first().and_then(|piece| piece.knots.first()).zip(self.ends.last()) else {
            return 0.0;
        };
        let s = s.max(*first).min(*last);
        let number = self.ends.partition_point(|end| *end < s).min(self.pieces.len() - 1);
        self.pieces[number].at(s)[0]
    }

    /// The rows on a surface: places and values.
    pub(super) fn rows(&self, [from, to]: [f64; 2]) -> (Vec<f64>, Vec<f64>) {
        let mut knots = self.knots();
        knots.dedup();
        knots.into_iter().filter(|s| (from..=to).contains(s)).map(|s| (s, self.at(s))).unzip()
    }

    /// Where the slope jumps by much: between pieces, and where they begin and end, for nothing changes beyond. Not between rows as close as those of layers, whose
    /// digits turn the slope, nor at the last of many rows, before which a shape is steep without a corner.
    pub(super) fn corners(&self) -> Vec<f64> {
        let mut rows = self.knots();
        rows.dedup();
        let [Some(first), Some(last)] = [rows.first(), rows.last()].map(Option::<&f64>::copied) else { return Vec::new() };
        let slope = |k: usize| (self.at(rows[k + 1]) - self.at(rows[k])) / (rows[k + 1] - rows[k]);
        let steepest = (0..rows.len() - 1).fold(0.0, |most: f64, k| most.max(slope(k).abs()));
        let is_corner = |s: &f64| {
            let k = rows.partition_point(|row| row < s);
            if k == 0 || k + 1 >= rows.len() {
                return true;
            }
            let closest = (rows[k] - rows[k - 1]).min(rows[k + 1] - rows[k]);
            let is_last = rows.len() > MANY && k.min(rows.len() - 1 - k) <= WINDOW;
            !is_last && closest > CLOSE * (last - first) && (slope(k) - slope(k - 1)).abs() > MUCH * steepest
        };
        std::iter::once(first).chain(self.ends.iter().copied()).filter(is_corner).collect()
    }

    /// The places of the rows.
    pub(crate) fn knots(&self) -> Vec<f64> {
        self.pieces.iter().flat_map(|piece| piece.knots.iter().copied()).collect()
    }
}

/// Rows at which the slope jumps by more than a smooth curve's would.
fn corners_of(s: &[f64], values: &[f64]) -> Vec<usize> {
    let slopes: Vec<f64> = s.windows(2).zip(values.windows(2)).map(|(s, v)| (v[1] - v[0]) / (s[1] - s[0])).collect();
    let turns: Vec<f64> = slopes.windows(2).map(|slope| (slope[1] - slope[0]).abs()).collect();
    // Slopes of a straight line differ by the round-off of its rows.
    let steepest = slopes.iter().fold(0.0_f64, |most, slope| most.max(slope.abs()));
    let is_corner = |i: &usize| {
        let near = &turns[i.saturating_sub(WINDOW)..(i + WINDOW + 1).min(turns.len())];
        turns[*i] > 1e-9 * steepest && turns[*i] > CORNER * near.iter().sum::<f64>()
    };
    (0..turns.len()).filter(is_corner).map(|i| i + 1).collect()
}

/// The line through two rows, or the parabola through three.
fn few(s: &[f64], values: &[[f64; 1]]) -> Option<Spline<1>> {
    let slope = |i: usize| (values[i + 1][0] - values[i][0]) / (s[i + 1] - s[i]);
    match s.len() {
        2 => Some(Spline { knots: s.to_vec(), pieces: vec![[[values[0][0], slope(0), 0.0, 0.0]]] }),
        3 => {
            let bend = (slope(1) - slope(0)) / (s[2] - s[0]);
            let first = [values[0][0], slope(0) - bend * (s[1] - s[0]), bend, 0.0];
            let second = [values[1][0], slope(1) - bend * (s[2] - s[1]), bend, 0.0];
            Some(Spline { knots: s.to_vec(), pieces: vec![[first], [second]] })
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::RowCurve;

    fn rows(count: usize, curve: impl Fn(f64) -> f64) -> (Vec<f64>, Vec<f64>) {
        let s: Vec<f64> = (0..count).map(|i| -30.0 + 60.0 * i as f64 / (count - 1) as f64).collect();
        let values = s.iter().map(|s| curve(*s)).collect();
        (s, values)
    }

    fn largest_error(count: usize, curve: impl Fn(f64) -> f64) -> f64 {
        let (s, values) = rows(count, &curve);
        let through = RowCurve::through(&s, &values);
        (0..=997).map(|i| -30.0 + 60.0 * f64::from(i) / 997.0).map(|s| (through.at(s) - curve(s)).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn rows_of_a_smooth_curve_give_it_back_with_the_fourth_power_of_their_distance() {
        let curve = |s: f64| 10.0 * (1.0 - (0.1 * s).cos());
        let [coarse, fine] = [41, 81].map(|count| largest_error(count, curve));
        assert!(coarse < 2e-3 && coarse / fine > 12.0, "{coarse:e} {fine:e}");
        // Five rows of a parabola are enough for all of it.
        assert!(largest_error(5, |s| 0.01 * s * s) < 1e-13);
    }

    #[test]
    fn corners_stay_corners_and_straight_sides_straight() {
        let chamfer = |s: f64| (s.abs() - 25.0).max(0.0);
        assert!(largest_error(61, chamfer) < 1e-13);
        let at = |s: &[f64], values: &[f64], x: f64| RowCurve::through(s, values).at(x);
        let (s, values) = ([-30.0, -25.0, 25.0, 30.0], [5.0, 0.0, 0.0, 5.0]);
        assert_eq!([-27.5, 0.0, 28.0].map(|x| at(&s, &values, x)), [2.5, 0.0, 3.0]);
        assert_eq!(at(&[0.0, 1.0, 3.0], &[1.0, 0.0, 4.0], 2.0), 2.0);
        // A parabola on both sides of a corner.
        assert!(largest_error(61, |s| 1.0 + 0.2 * s.abs() + 1e-3 * s * s) < 1e-12);
    }

    #[test]
    fn corners_that_ask_for_nodes_are_those_of_a_wedge_or_a_chamfer_and_none_of_a_shape() {
        let corners = |count: usize, curve: &dyn Fn(f64) -> f64| {
            let (s, values) = rows(count, curve);
            RowCurve::through(&s, &values).corners()
        };
        assert_eq!(corners(3, &|s| s.abs()), [-30.0, 0.0, 30.0]);
        assert_eq!(corners(61, &|s| (s.abs() - 20.0).max(0.0)), [-30.0, -20.0, 20.0, 30.0]);
        assert_eq!(corners(61, &|s| 0.01 * s * s), [-30.0, 30.0]);
        // Steep at its ends, as a shape is.
        assert_eq!(corners(61, &|s| (31.0 * 31.0 - s * s).ln()), [-30.0, 30.0]);
        // Rows as close as those of layers, with the digits that they have.
        let s: Vec<f64> = (-20..=20).map(|k: i32| f64::from(k.signum()) * 30.0 * 0.5_f64.powi(20 - k.abs())).collect();
        let values: Vec<f64> = s.iter().map(|s| (1e3 * (s / 30.0).powi(2)).round()).collect();
        assert!(RowCurve::through(&s, &values).corners().iter().all(|corner| corner.abs() == 30.0 || corner.abs() > 0.05));
    }

    #[test]
    fn every_row_is_met_and_beyond_both_ends_nothing_changes() {
        let (s, values) = rows(23, |s| (0.7 * s).sin() + if s > 3.0 { 2.0 } else { 0.0 });
        let through = RowCurve::through(&s, &values);
        for (s, value) in s.iter().zip(&values) {
            assert!((through.at(*s) - value).abs() < 1e-13, "{s}");
        }
        assert_eq!([through.at(-31.0), through.at(31.0)], [through.at(-30.0), through.at(30.0)]);
    }
}
