//! Interpolating cubic splines of curves, with as many knots as an accuracy takes.

/// A curve of `N` coordinates, twice continuously differentiable, a cubic polynomial between successive knots.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline<const N: usize> {
    /// Knots, ascending.
    pub knots: Vec<f64>,
    /// One piece an interval: coefficients `c` of each coordinate, `sum_k c[k] (t - knot)^k` from the knot on its left.
    pub pieces: Vec<[[f64; 4]; N]>,
}

/// A spline and how far it is from its curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit<const N: usize> {
    /// The spline.
    pub spline: Spline<N>,
    /// Largest deviation of a coordinate at seven places in each interval; infinite where the curve is no number.
    pub deviation: f64,
}

/// Equal intervals to begin with.
const FIRST: usize = 32;
/// Most parts an interval is split into at once.
const MOST_PARTS: f64 = 4.0;
/// Most rounds of splitting, and most knots: a curve with noise above the tolerance has no end of them.
const ROUNDS: usize = 40;
const MOST: usize = 4096;
/// Places in an interval where the spline is compared.
const PLACES: usize = 7;

impl<const N: usize> Spline<N> {
    /// The spline through `values` at `knots` without a break of the third derivative at the second knot and the last but one ("not a knot"; de Boor
    /// 1978, chapter IV): through three of them the parabola, through two the line, through fewer nothing. What one list has more than the other
    /// does not count.
    pub fn through(mut knots: Vec<f64>, values: &[[f64; N]]) -> Spline<N> {
        knots.truncate(values.len());
        let values = &values[..knots.len()];
        let slopes: [Vec<f64>; N] = std::array::from_fn(|c| slopes(&knots, &values.iter().map(|v| v[c]).collect::<Vec<_>>()));
        let piece = |i: usize| {
            let h = knots[i + 1] - knots[i];
            std::array::from_fn(|c| {
                let (d, a, b) = ((values[i + 1][c] - values[i][c]) / h, slopes[c][i], slopes[c][i + 1]);
                [values[i][c], a, (3.0 * d - 2.0 * a - b) / h, (a + b - 2.0 * d) / (h * h)]
            })
        };
        let pieces = (0..knots.len().saturating_sub(1)).map(piece).collect();
        Spline { knots, pieces }
    }

    /// The spline of a curve over a range, with intervals split until no coordinate deviates by more than `tolerance`, or there are too
    /// many.
    pub fn fit(curve: impl Fn(f64) -> [f64; N], [from, to]: [f64; 2], tolerance: f64) -> Fit<N> {
        let mut knots: Vec<f64> =
            (0..=FIRST).map(|i| if i == FIRST { to } else { from + (to - from) * i as f64 / FIRST as f64 }).collect();
        let mut round = 0;
        loop {
            let values: Vec<[f64; N]> = knots.iter().map(|t| curve(*t)).collect();
            let spline = Spline::through(knots.clone(), &values);
            let deviations: Vec<f64> = (0..spline.pieces.len()).map(|i| spline.deviation(&curve, i)).collect();
            let deviation = deviations.iter().copied().fold(0.0, f64::max);
            round += 1;
            if deviation <= tolerance || deviation == f64::INFINITY || round > ROUNDS || knots.len() > MOST {
                return Fit { spline, deviation };
            }
            // The deviation falls with the fourth power of the interval.
            let parts = |deviation: f64| (deviation / tolerance).powf(0.25).ceil().clamp(2.0, MOST_PARTS) as usize;
            let split = deviations.iter().enumerate().filter(|(_, deviation)| **deviation > tolerance);
            let between: Vec<f64> = split
                .flat_map(|(i, deviation)| {
                    let (ends, parts) = ([knots[i], knots[i + 1]], parts(*deviation));
                    (1..parts).map(move |k| ends[0] + (ends[1] - ends[0]) * k as f64 / parts as f64)
                })
                .collect();
            knots.extend(between);
            knots.sort_unstable_by(f64::total_cmp);
        }
    }

    fn deviation(&self, curve: &impl Fn(f64) -> [f64; N], i: usize) -> f64 {
        let places = (1..=PLACES).map(|k| k as f64 / (PLACES + 1) as f64);
        let far = places.map(|share| {
            let t = (1.0 - share) * self.knots[i] + share * self.knots[i + 1];
            let (a, b) = (curve(t), self.at(t));
            (0..N).map(|c| (a[c] - b[c]).abs()).map(|far| if far.is_nan() { f64::INFINITY } else { far }).fold(0.0, f64::max)
        });
        far.fold(0.0, f64::max)
    }

    /// Point at a parameter; nan without a piece.
    pub fn at(&self, t: f64) -> [f64; N] {
        if self.pieces.is_empty() {
            return [f64::NAN; N];
        }
        let i = self.knots.partition_point(|knot| *knot <= t).clamp(1, self.pieces.len()) - 1;
        let x = t - self.knots[i];
        self.pieces[i].map(|[a, b, c, d]| a + x * (b + x * (c + x * d)))
    }

    /// Control points over the knots with the ends fourfold, by the polar form of the pieces.
    pub fn control_points(&self) -> Vec<[f64; N]> {
        if self.pieces.is_empty() {
            return Vec::new();
        }
        let last = self.pieces.len() - 1;
        let knot = |i: usize| self.knots[i.saturating_sub(3).min(self.knots.len() - 1)];
        let point = |i: usize| {
            // Point i belongs to the padded knots i+1, i+2, i+3, and to every piece they bound.
            let piece = i.saturating_sub(2).min(last);
            let [a, b, c] = [1, 2, 3].map(|k| knot(i + k) - self.knots[piece]);
            self.pieces[piece]
                .map(|[c0, c1, c2, c3]| c0 + c1 * (a + b + c) / 3.0 + c2 * (a * b + a * c + b * c) / 3.0 + c3 * a * b * c)
        };
        (0..self.pieces.len() + 3).map(point).collect()
    }

    /// The knots with the ends fourfold.
    pub fn padded_knots(&self) -> Vec<f64> {
        let [first, .., last] = self.knots[..] else { return Vec::new() };
        [first; 3].into_iter().chain(self.knots.iter().copied()).chain([last; 3]).collect()
    }
}

/// Slopes at the knots: continuity of the second derivative inside, not-a-knot conditions at the ends; a tridiagonal system.
fn slopes(t: &[f64], f: &[f64]) -> Vec<f64> {
    let n = t.len();
    if n < 4 {
        return few(t, f);
    }
    let h: Vec<f64> = t.windows(2).map(|p| p[1] - p[0]).collect();
    let d: Vec<f64> = f.windows(2).zip(&h).map(|(p, h)| (p[1] - p[0]) / h).collect();
    let (mut lower, mut diagonal, mut upper, mut right) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    for i in 1..n - 1 {
        (lower[i], diagonal[i], upper[i]) = (h[i], 2.0 * (h[i - 1] + h[i]), h[i - 1]);
        right[i] = 3.0 * (h[i] * d[i - 1] + h[i - 1] * d[i]);
    }
    let end = |h0: f64, h1: f64, d0: f64, d1: f64| ((3.0 * h0 + 2.0 * h1) * h1 * d0 + h0 * h0 * d1) / (h0 + h1);
    (diagonal[0], upper[0], right[0]) = (h[1], h[0] + h[1], end(h[0], h[1], d[0], d[1]));
    let (a, b) = (n - 2, n - 3);
    (lower[n - 1], diagonal[n - 1], right[n - 1]) = (h[a] + h[b], h[b], end(h[a], h[b], d[a], d[b]));
    for i in 1..n {
        let factor = lower[i] / diagonal[i - 1];
        diagonal[i] -= factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
    }
    let mut m = vec![0.0; n];
    m[n - 1] = right[n - 1] / diagonal[n - 1];
    for i in (0..n - 1).rev() {
        m[i] = (right[i] - upper[i] * m[i + 1]) / diagonal[i];
    }
    m
}

/// Slopes of the parabola or the line through three or two points.
fn few(t: &[f64], f: &[f64]) -> Vec<f64> {
    let slope = |i: usize, j: usize| (f[j] - f[i]) / (t[j] - t[i]);
    match t.len() {
        3 => {
            let (a, b, c) = (slope(0, 1), slope(1, 2), slope(0, 2));
            vec![a + c - b, a + b - c, b + c - a]
        }
        2 => vec![slope(0, 1); 2],
        n => vec![0.0; n],
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::Spline;

    #[test]
    fn few_knots_have_a_parabola_or_a_line_and_a_curve_of_no_numbers_no_small_deviation() {
        let parabola = Spline::through(vec![0.0, 1.0, 3.0], &[[0.0], [1.0], [9.0]]);
        let line = Spline::through(vec![0.0, 1.0, 3.0], &[[0.0], [2.0]]);
        for t in [0.0, 0.5, 2.0, 3.0] {
            assert!((parabola.at(t)[0] - t * t).abs() < 1e-14 && (line.at(t)[0] - 2.0 * t).abs() < 1e-14, "{t}");
        }
        let none = Spline::<1>::through(vec![0.0], &[[1.0]]);
        assert!(none.at(0.0)[0].is_nan() && none.control_points().is_empty() && none.padded_knots().is_empty());
        for wrong in [f64::NAN, f64::INFINITY] {
            let fit = Spline::fit(|t: f64| [if t > 0.305 && t < 0.31 { wrong } else { t }], [0.0, 1.0], 1e-9);
            assert_eq!(fit.deviation, f64::INFINITY);
        }
    }

    #[test]
    fn a_cubic_is_its_own_spline() {
        let cubic = |t: f64| [1.0 - 2.0 * t + 0.5 * t * t - 0.25 * t * t * t];
        let knots = vec![-1.0, -0.7, 0.1, 0.4, 1.5, 2.0];
        let values: Vec<[f64; 1]> = knots.iter().map(|t| cubic(*t)).collect();
        let spline = Spline::through(knots, &values);
        for i in 0..=60 {
            let t = -1.0 + 0.05 * f64::from(i);
            assert!((spline.at(t)[0] - cubic(t)[0]).abs() < 1e-14, "{t}");
        }
    }

    #[test]
    fn an_arc_and_a_root_are_met_within_the_tolerance_between_the_checked_places_too() {
        let curve = |t: f64| [200.0 * t.sin(), 200.0 * t.cos(), 1e-3 * (t + 0.5).powf(1.5)];
        let fit = Spline::fit(curve, [-0.5, 0.5], 1e-9);
        assert!(fit.deviation <= 1e-9);
        for i in 0..=9973 {
            let t = -0.5 + f64::from(i) / 9973.0;
            let far = (0..3).map(|c| (fit.spline.at(t)[c] - curve(t)[c]).abs()).fold(0.0, f64::max);
            assert!(far < 1.2e-9, "{far:e} at {t}");
        }
        assert!(fit.spline.knots.len() < 1000, "{}", fit.spline.knots.len());
    }

    #[test]
    fn a_curve_rougher_than_the_tolerance_ends_with_the_deviation_it_has() {
        let fit = Spline::fit(|t: f64| [1e12 * t.sin()], [0.0, 1.0], 1e-9);
        assert!(fit.deviation > 1e-9 && fit.deviation < 1e-2, "{:e}", fit.deviation);
        assert!(fit.spline.pieces.len() < 10_000, "{}", fit.spline.pieces.len());
    }

    #[test]
    fn control_points_give_the_spline_back_by_de_boor() {
        let fit = Spline::fit(|t: f64| [t.exp(), (3.0 * t).sin()], [0.0, 2.0], 1e-7);
        let (knots, points) = (fit.spline.padded_knots(), fit.spline.control_points());
        assert_eq!(knots.len(), points.len() + 4);
        for i in 0..=500 {
            let t = 2.0 * f64::from(i) / 500.0;
            let k = knots.partition_point(|u| *u <= t).clamp(4, points.len()) - 1;
            let mut d: Vec<[f64; 2]> = points[k - 3..=k].to_vec();
            for r in 1..=3 {
                for j in (r..=3).rev() {
                    let (a, b) = (knots[j + k - 3], knots[j + 1 + k - r]);
                    let w = (t - a) / (b - a);
                    d[j] = [0, 1].map(|c| (1.0 - w) * d[j - 1][c] + w * d[j][c]);
                }
            }
            let at = fit.spline.at(t);
            assert!((0..2).all(|c| (d[3][c] - at[c]).abs() < 1e-12), "{t}: {d:?} {at:?}");
        }
    }
}
