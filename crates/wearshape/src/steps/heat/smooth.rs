//! Fluxes that are smooth along the surface: polynomials of the arc length, and powers of the distance from its ends, where pressures may be infinite.

use contact::faer::Mat;

/// How much of the heat beyond a known one bends the bodies.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Smooth {
    /// What a proof takes, whose pressure is all but known.
    Little,
    /// What is surely not as fine as the points.
    Coarse,
    /// What deviations of the pressure in time take: the longest grow first.
    Deviations,
    /// What speeds and tolerances take, which ask for waves along the surface and for its ends.
    Waves,
}

impl Smooth {
    /// Number of polynomials, the constant among them, and powers of the distance from each end: together they are near any power in between.
    fn terms(self) -> (usize, &'static [f64]) {
        match self {
            Smooth::Little => (6, &[]),
            Smooth::Coarse => (12, &[]),
            Smooth::Deviations => (30, &[]),
            Smooth::Waves => (30, &[-0.5, 0.5]),
        }
    }
}

/// Part of a flux beyond those before that counts as another one.
const ANOTHER: f64 = 1e-6;

/// Fluxes at points (arc length, area), `points x fluxes`, orthonormal by the areas, sums over the points standing for integrals. The next polynomial is made
/// of the arc length times the last one, as in the procedure of Stieltjes (Gautschi, Orthogonal Polynomials, 2004, 2.2.3).
pub(super) fn smooth(points: &[(f64, f64)], wanted: Smooth) -> Mat<f64> {
    let n = points.len();
    let (polynomials, powers) = wanted.terms();
    let length = points.iter().map(|(arc, _)| *arc).fold(f64::MIN_POSITIVE, f64::max);
    let mut found: Vec<Vec<f64>> = Vec::new();
    let mut next = vec![1.0; n];
    for _ in 0..polynomials.min(n) {
        add(&mut found, next, points);
        let Some(last) = found.last() else { break };
        next = points.iter().zip(last).map(|((arc, _), value)| arc / length * value).collect();
    }
    for from in [0.0, length] {
        let distance = |arc: f64| (arc - from).abs() / length;
        // The end itself is as far from it as the middle between it and the next point.
        let nearest = points.iter().map(|(arc, _)| distance(*arc)).filter(|d| *d > 0.0).fold(1.0, f64::min);
        for power in powers {
            add(&mut found, points.iter().map(|(arc, _)| distance(*arc).max(0.5 * nearest).powf(*power)).collect(), points);
        }
    }
    Mat::from_fn(n, found.len(), |i, k| found[k][i])
}

/// Adds what of a flux is orthogonal to those before, if it is more than round-off.
fn add(found: &mut Vec<Vec<f64>>, mut flux: Vec<f64>, points: &[(f64, f64)]) {
    let product = |p: &[f64], q: &[f64]| points.iter().zip(p).zip(q).map(|(((_, area), p), q)| area * p * q).sum::<f64>();
    let whole = product(&flux, &flux).sqrt();
    // Twice is enough.
    for _ in 0..2 {
        for before in found.iter() {
            let part = product(before, &flux);
            flux.iter_mut().zip(before).for_each(|(value, before)| *value -= part * before);
        }
    }
    let norm = product(&flux, &flux).sqrt();
    if norm > ANOTHER * whole {
        flux.iter_mut().for_each(|value| *value /= norm);
        found.push(flux);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_orthonormal_on_uneven_points() {
        let arc = |i: usize| 20.0 * (i as f64 / 40.0).powi(3);
        let weight = |i: usize| 0.5 * (arc((i + 1).min(40)) - arc(i.max(1) - 1));
        let points: Vec<(f64, f64)> = (0..=40).map(|i| (arc(i), weight(i))).collect();
        let smooth = smooth(&points, Smooth::Waves);
        for j in 0..smooth.ncols() {
            for k in 0..=j {
                let product: f64 = (0..points.len()).map(|i| points[i].1 * smooth[(i, j)] * smooth[(i, k)]).sum();
                assert!((product - f64::from(u8::from(j == k))).abs() < 1e-9, "{j} {k} {product}");
            }
        }
    }
}
