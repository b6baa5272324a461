//! Fluxes that are smooth along the surface: polynomials of the arc length.

use contact::faer::Mat;

/// Polynomials, the constant among them.
const MODES: usize = 16;

/// The first polynomials of the arc length at points (arc length, area), `points x polynomials`, orthonormal by the areas: by the recurrence
/// `b_k+1 P_k+1 = (s - a_k) P_k - b_k P_k-1` of Stieltjes, where sums over the points stand for integrals (Gautschi, Orthogonal Polynomials, 2004, 2.2.3).
pub(super) fn smooth(points: &[(f64, f64)]) -> Mat<f64> {
    let n = points.len();
    let length = points.iter().map(|(arc, _)| *arc).fold(f64::MIN_POSITIVE, f64::max);
    let product = |p: &[f64], q: &[f64]| (0..n).map(|i| points[i].1 * p[i] * q[i]).sum::<f64>();
    let mut found: Vec<Vec<f64>> = Vec::new();
    let mut next = vec![1.0; n];
    while found.len() < MODES.min(n) {
        let norm = product(&next, &next).sqrt();
        let p: Vec<f64> = next.iter().map(|value| value / norm).collect();
        let along: Vec<f64> = points.iter().zip(&p).map(|((arc, _), value)| arc / length * value).collect();
        let a = product(&along, &p);
        let before = found.last().map_or(0.0, |before| product(&along, before));
        let at = |i: usize| along[i] - a * p[i] - found.last().map_or(0.0, |last| before * last[i]);
        next = (0..n).map(at).collect();
        found.push(p);
    }
    Mat::from_fn(n, found.len(), |i, k| found[k][i])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_orthonormal_on_uneven_points() {
        let arc = |i: usize| 20.0 * (i as f64 / 40.0).powi(3);
        let weight = |i: usize| 0.5 * (arc((i + 1).min(40)) - arc(i.max(1) - 1));
        let points: Vec<(f64, f64)> = (0..=40).map(|i| (arc(i), weight(i))).collect();
        let smooth = smooth(&points);
        for j in 0..smooth.ncols() {
            for k in 0..=j {
                let product: f64 = (0..points.len()).map(|i| points[i].1 * smooth[(i, j)] * smooth[(i, k)]).sum();
                assert!((product - f64::from(u8::from(j == k))).abs() < 1e-9, "{j} {k} {product}");
            }
        }
    }
}
