//! The smoothest curve near measured rows: the natural cubic spline that minimises the integral of its squared second derivative among all whose
//! root mean square distance from the rows is at most a given one (Reinsch 1967, Numerische Mathematik 10, 177-183).

use shapeopt::Spline;

use super::rows::RowCurve;

/// How far a smooth curve is from its rows (um).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Residual {
    /// Root mean square.
    pub rms: f64,
    /// Largest.
    pub most: f64,
}

/// Weights of the residual tried, as powers of ten of the natural one, and how often their range is halved.
const POWERS: [f64; 2] = [-14.0, 14.0];
const HALVINGS: usize = 80;

/// The smoothest curve at most `most` (root mean square) from the rows (two at least, ascending), and how far it is.
pub(super) fn smoothed(s: &[f64], values: &[f64], most: f64) -> (RowCurve, Residual) {
    let system = System::new(s, values);
    let line = line(s, values);
    let straight = residual(values, &s.iter().map(|s| line[0] + line[1] * s).collect::<Vec<_>>());
    let (Some(system), false) = (system, straight.rms <= most) else {
        let (first, last) = (s.first().copied().unwrap_or(0.0), s.last().copied().unwrap_or(1.0));
        let piece = [[line[0] + line[1] * first, line[1], 0.0, 0.0]];
        return (RowCurve::of(Spline { knots: vec![first, last], pieces: vec![piece] }), straight);
    };
    let [mut low, mut high] = POWERS;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if residual(values, &system.solve(middle).0).rms <= most { low = middle } else { high = middle }
    }
    let (smooth, bends) = system.solve(low);
    let found = residual(values, &smooth);
    (RowCurve::of(natural(s, &smooth, &bends)), found)
}

fn residual(values: &[f64], smooth: &[f64]) -> Residual {
    let off = || values.iter().zip(smooth).map(|(a, b)| (a - b).abs());
    let mean = off().map(|off| off * off).sum::<f64>() / values.len().max(1) as f64;
    Residual { rms: mean.sqrt(), most: off().fold(0.0, f64::max) }
}

/// Value at 0 and slope of the straight line of least squares.
fn line(s: &[f64], values: &[f64]) -> [f64; 2] {
    let count = s.len().max(1) as f64;
    let [middle, mean] = [s, values].map(|v| v.iter().sum::<f64>() / count);
    let square: f64 = s.iter().map(|s| (s - middle).powi(2)).sum();
    let product: f64 = s.iter().zip(values).map(|(s, v)| (s - middle) * (v - mean)).sum();
    let slope = if square > 0.0 { product / square } else { 0.0 };
    [mean - slope * middle, slope]
}

/// The spline with these values and second derivatives at its knots.
fn natural(s: &[f64], values: &[f64], bends: &[f64]) -> Spline<1> {
    let piece = |i: usize| {
        let h = s[i + 1] - s[i];
        let slope = (values[i + 1] - values[i]) / h - h * (2.0 * bends[i] + bends[i + 1]) / 6.0;
        [[values[i], slope, 0.5 * bends[i], (bends[i + 1] - bends[i]) / (6.0 * h)]]
    };
    Spline { knots: s.to_vec(), pieces: (0..s.len() - 1).map(piece).collect() }
}

/// Reinsch's equations `(R + w Q^T Q) bends = Q^T values`, `smooth = values - w Q bends`, with the second derivatives at the inner rows: R holds
/// their integrals, Q takes second differences.
struct System<'v> {
    values: &'v [f64],
    steps: Vec<f64>,
    /// Weight of the power 0: the cube of the mean distance of rows.
    unit: f64,
}

impl<'v> System<'v> {
    /// None for two rows, which have a line.
    fn new(s: &[f64], values: &'v [f64]) -> Option<System<'v>> {
        let steps: Vec<f64> = s.windows(2).map(|s| s[1] - s[0]).collect();
        let mean = steps.iter().sum::<f64>() / steps.len().max(1) as f64;
        (steps.len() > 1).then_some(System { values, steps, unit: mean.powi(3) })
    }

    /// Column `j` of Q: its three numbers, in rows j, j + 1, j + 2.
    fn column(&self, j: usize) -> [f64; 3] {
        let [a, b] = [self.steps[j], self.steps[j + 1]].map(f64::recip);
        [a, -a - b, b]
    }

    /// Smooth values and second derivatives at all rows, by the power of ten of the weight.
    fn solve(&self, power: f64) -> (Vec<f64>, Vec<f64>) {
        let weight = self.unit * 10f64.powf(power);
        let count = self.steps.len() - 1;
        let columns: Vec<[f64; 3]> = (0..count).map(|j| self.column(j)).collect();
        // Diagonal, first and second off-diagonal.
        let row = |j: usize| {
            let (own, h) = (columns[j], [self.steps[j], self.steps[j + 1]]);
            let next = columns.get(j + 1).map_or(0.0, |next| own[1] * next[0] + own[2] * next[1]);
            let after = columns.get(j + 2).map_or(0.0, |after| own[2] * after[0]);
            let square: f64 = own.iter().map(|c| c * c).sum();
            [(h[0] + h[1]) / 3.0 + weight * square, h[1] / 6.0 + weight * next, weight * after]
        };
        let right = |j: usize| (0..3).map(|k| columns[j][k] * self.values[j + k]).sum();
        let inner = banded((0..count).map(row).collect(), (0..count).map(right).collect());
        let mut smooth = self.values.to_vec();
        for (j, bend) in inner.iter().enumerate() {
            (0..3).for_each(|k| smooth[j + k] -= weight * columns[j][k] * bend);
        }
        let bends = std::iter::once(0.0).chain(inner).chain([0.0]).collect();
        (smooth, bends)
    }
}

/// Solves a symmetric positive definite system of five diagonals: the diagonal and two above it in each row.
fn banded(mut rows: Vec<[f64; 3]>, mut x: Vec<f64>) -> Vec<f64> {
    let count = rows.len();
    for i in 0..count {
        let [pivot, one, two] = rows[i];
        for (k, factor) in [(1, one / pivot), (2, two / pivot)] {
            if i + k < count {
                let eliminated = x[i];
                x[i + k] -= factor * eliminated;
                rows[i + k][0] -= factor * if k == 1 { one } else { two };
                if k == 1 {
                    rows[i + 1][1] -= factor * two;
                }
            }
        }
    }
    for i in (0..count).rev() {
        let [pivot, one, two] = rows[i];
        let next = |k: usize| x.get(i + k).copied().unwrap_or(0.0);
        x[i] = (x[i] - one * next(1) - two * next(2)) / pivot;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::smoothed;

    /// Rows of a parabola with a made-up roughness of known root mean square, the same in every run.
    fn rough(count: usize, amplitude: f64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let s: Vec<f64> = (0..count).map(|i| -30.0 + 60.0 * i as f64 / (count - 1) as f64).collect();
        let mut state = 12345_u32;
        let mut noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / f64::from(1_u32 << 24) - 0.5
        };
        let smooth: Vec<f64> = s.iter().map(|s| 0.02 * s * s).collect();
        let values = smooth.iter().map(|v| v + amplitude * noise()).collect();
        (s, smooth, values)
    }

    #[test]
    fn a_measured_parabola_comes_back_from_under_its_roughness() {
        let (s, truth, values) = rough(401, 7.0);
        let rms = (values.iter().zip(&truth).map(|(v, t)| (v - t).powi(2)).sum::<f64>() / 401.0).sqrt();
        let (curve, residual) = smoothed(&s, &values, rms);
        assert!((residual.rms / rms - 1.0).abs() < 1e-9, "{residual:?} {rms}");
        let off = s.iter().zip(&truth).map(|(s, t)| (curve.at(*s) - t).powi(2)).sum::<f64>() / 401.0;
        // Twenty times less than the roughness in the mean square, and no rows beyond it.
        assert!(off < rms * rms / 20.0, "{off:e}");
        assert!(residual.most > rms && residual.most < 4.5);
    }

    #[test]
    fn the_residual_is_the_one_asked_for_and_nothing_smooth_is_bent() {
        let (s, _, values) = rough(64, 3.0);
        for most in [1e-6, 0.1, 1.0] {
            let (curve, residual) = smoothed(&s, &values, most);
            assert!(residual.rms <= most && residual.rms > 0.999 * most, "{residual:?} {most}");
            let off = s.iter().zip(&values).map(|(s, v)| (curve.at(*s) - v).abs()).fold(0.0, f64::max);
            assert!((off - residual.most).abs() < 1e-9);
        }
        let line: Vec<f64> = s.iter().map(|s| 3.0 + 0.5 * s).collect();
        let (curve, residual) = smoothed(&s, &line, 0.1);
        assert!(residual.most < 1e-12 && (curve.at(7.7) - 6.85).abs() < 1e-12);
    }
}
