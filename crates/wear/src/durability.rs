//! Time and sliding distance to a given wear depth in the steady state.

use crate::{Optimum, Problem, SurfacePoint, wear_rate};

/// Time (s) until body 1 has lost `depth` (mm, along the normal) at a point, at the wear rate of the optimum there. `None` where body
/// 1 does not wear.
pub fn time_to_depth(problem: &Problem, optimum: &Optimum, point: &SurfacePoint, depth: f64) -> Option<f64> {
    if !problem.wear.wears(0) {
        return None;
    }
    let rate = wear_rate(&problem.wear.laws[0], optimum.pressure_at(point), point.sliding_speed);
    (rate > 0.0).then(|| depth / rate)
}

/// Sliding distance (mm) travelled past the point in that time.
pub fn distance_to_depth(problem: &Problem, optimum: &Optimum, point: &SurfacePoint, depth: f64) -> Option<f64> {
    time_to_depth(problem, optimum, point, depth).map(|time| time * point.sliding_speed)
}
