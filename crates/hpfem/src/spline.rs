//! Cubic splines through points, as the curves of consecutive edges.

use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::distance;

impl Curve {
    /// The interpolating cubic spline through points (mm) in order, one curve between each two; positions, directions and curvatures are
    /// continuous. The parameter is the length of the chords; at both ends the third derivative is continuous one knot further
    /// in ("not a knot", de Boor 1978, ch. IV), so that the error falls with the fourth power of the spacing up to the ends. Three points
    /// give a parabola, two a line.
    ///
    /// # Errors
    /// [`Error::Count`] for fewer than two points; [`Error::OutOfRange`] if a coordinate is not finite or two neighbours coincide.
    pub fn spline(points: &[[f64; 2]]) -> Result<Vec<Curve>, Error> {
        if points.len() < 2 {
            return Err(Error::Count { what: "points of a spline".into(), given: points.len(), expected: 2 });
        }
        let steps: Vec<f64> = points.windows(2).map(|w| distance(w[0], w[1])).collect();
        if let Some(i) = steps.iter().position(|h| !(h.is_finite() && *h > 0.0)) {
            let quantity = format!("the distance between points {i} and {} of a spline", i + 1);
            return Err(Error::OutOfRange { quantity, value: steps[i], range: "positive and finite" });
        }
        if points.len() == 2 {
            return Ok(vec![Curve::Line { start: points[0], end: points[1] }]);
        }
        let bends = [0, 1].map(|c| second_derivatives(&steps, &points.iter().map(|p| p[c]).collect::<Vec<f64>>()));
        let piece = |i: usize| {
            Curve::interpolated(3, |t| {
                let (a, b, h) = (0.5 * (1.0 - t), 0.5 * (1.0 + t), steps[i]);
                std::array::from_fn(|c| {
                    let bend = (a * a * a - a) * bends[c][i] + (b * b * b - b) * bends[c][i + 1];
                    a * points[i][c] + b * points[i + 1][c] + h * h / 6.0 * bend
                })
            })
        };
        Ok((0..steps.len()).map(piece).collect())
    }
}

/// Second derivatives `m` at the knots: `h_{i-1} m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_i m_{i+1} = 6 (slope_i - slope_{i-1})`, the first and
/// last from `m_0 = m_1 - h_0 / h_1 (m_2 - m_1)` and its mirror image.
fn second_derivatives(h: &[f64], y: &[f64]) -> Vec<f64> {
    let n = y.len();
    let slope = |i: usize| (y[i + 1] - y[i]) / h[i];
    if n == 3 {
        return vec![2.0 * (slope(1) - slope(0)) / (h[0] + h[1]); 3];
    }
    // Rows 1 .. n - 2: below, diagonal, above, right side.
    let mut rows: Vec<[f64; 4]> =
        (1..n - 1).map(|i| [h[i - 1], 2.0 * (h[i - 1] + h[i]), h[i], 6.0 * (slope(i) - slope(i - 1))]).collect();
    let (first, last) = (h[0] / h[1], h[n - 2] / h[n - 3]);
    rows[0][1] += h[0] * (1.0 + first);
    rows[0][2] -= h[0] * first;
    rows[n - 3][1] += h[n - 2] * (1.0 + last);
    rows[n - 3][0] -= h[n - 2] * last;
    for i in 1..rows.len() {
        let factor = rows[i][0] / rows[i - 1][1];
        rows[i][1] -= factor * rows[i - 1][2];
        rows[i][3] -= factor * rows[i - 1][3];
    }
    let mut m = vec![0.0; n];
    for i in (0..rows.len()).rev() {
        let next = if i + 1 < rows.len() { rows[i][2] * m[i + 2] } else { 0.0 };
        m[i + 1] = (rows[i][3] - next) / rows[i][1];
    }
    m[0] = m[1] - first * (m[2] - m[1]);
    m[n - 1] = m[n - 2] + last * (m[n - 2] - m[n - 3]);
    m
}
