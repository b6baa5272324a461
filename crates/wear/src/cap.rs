//! Whether a pressure cap is too low for the load.

use crate::mode::MAX_MODES;
use crate::stage::Stage;
use crate::{Shape, Surface, SurfacePoint};

/// Points of the surface along each parameter, and steps of the search.
const POINTS: usize = 100;
const STEPS: usize = 1000;
/// What lies above this is left to the numbers: the lowest cap of `rectangular-punch` is 1.1e-5 too high by the sums over the points.
const CERTAIN: f64 = 0.9999;
/// Square of what is round-off in a sum of slopes.
const ROUND_OFF: f64 = 1e-24;

/// Whether no pressure 0 <= p <= p_max has the resultants F_k = int psi_k p dS, by Farkas' lemma: there are multipliers with lambda . F = 1 and
/// h(lambda) = p_max int max(lambda . psi, 0) dS < 1. h is convex; Polyak's steps along its subgradient find such multipliers.
pub(crate) fn is_too_low(stage: &Stage<'_>) -> bool {
    let (Some(cap), law) = (stage.problem.p_max, &stage.law) else { return false };
    let count = law.count;
    let load: [f64; MAX_MODES] = std::array::from_fn(|k| if k < count { law.resultant(k) / law.scale[k] } else { 0.0 });
    let size: f64 = load.iter().map(|f| f * f).sum();
    let weighed = |point: &SurfacePoint| {
        let psi = law.mode_values(point).psi;
        std::array::from_fn::<f64, MAX_MODES, _>(|k| if k < count { cap * point.weight * psi[k] / law.scale[k] } else { 0.0 })
    };
    let points: Vec<[f64; MAX_MODES]> = points(&stage.problem.surface).iter().map(weighed).collect();
    let mut multipliers = load.map(|f| f / size);
    for _ in 0..STEPS {
        let (mut value, mut slope) = (0.0, [0.0; MAX_MODES]);
        for point in &points {
            let product: f64 = multipliers.iter().zip(point).map(|(y, psi)| y * psi).sum();
            if product > 0.0 {
                value += product;
                slope.iter_mut().zip(point).for_each(|(sum, psi)| *sum += psi);
            }
        }
        if value < CERTAIN {
            return true;
        }
        let whole: f64 = slope.iter().map(|g| g * g).sum();
        // Along lambda . F = 1, where one mode has round-off alone.
        let off = slope.iter().zip(&load).map(|(g, f)| g * f).sum::<f64>() / size;
        slope.iter_mut().zip(&load).for_each(|(g, f)| *g -= off * f);
        let steepness: f64 = slope.iter().map(|g| g * g).sum();
        if !(steepness > ROUND_OFF * whole && value.is_finite()) {
            return false;
        }
        let step = (value - (2.0 * CERTAIN - 1.0)) / steepness;
        multipliers.iter_mut().zip(slope).for_each(|(y, g)| *y -= step * g);
    }
    false
}

/// The middles of equal parts of the parameters, their weights areas.
fn points(surface: &Surface) -> Vec<SurfacePoint> {
    if let Shape::Points(points) = surface.shape() {
        return points.clone();
    }
    let middles = |[from, to]: [f64; 2]| {
        let step = (to - from) / POINTS as f64;
        (0..POINTS).map(move |i| (from + (i as f64 + 0.5) * step, step))
    };
    let outer: Vec<(f64, f64)> = surface.outer_range().map_or(vec![(0.0, 1.0)], |range| middles(range).collect());
    let line = |(outer, width): (f64, f64)| {
        middles(surface.inner_range()).map(move |(inner, step)| {
            let point = surface.at(inner, outer);
            SurfacePoint { weight: point.weight * width * step, ..point }
        })
    };
    outer.into_iter().flat_map(line).collect()
}
