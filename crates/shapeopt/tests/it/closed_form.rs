//! Contact systems in closed form: Winkler layer and elastic half-plane under a strip punch.

use contact::ContactSystem;
use faer::Mat;
use nalgebra::Vector3;
use shapeopt::WearProblem;
use wear::{Counterface, SurfacePoint, WearPair};

pub const HALF_WIDTH: f64 = 30.0;
pub const THICKNESS: f64 = 10.0;
pub const FORCE: f64 = 1000.0;
pub const SPEED: f64 = 5.0;

/// Equal cells over `-HALF_WIDTH..HALF_WIDTH`.
pub fn points(count: usize) -> Vec<SurfacePoint> {
    let h = 2.0 * HALF_WIDTH / count as f64;
    (0..count)
        .map(|i| SurfacePoint {
            position: Vector3::new(-HALF_WIDTH + h * (i as f64 + 0.5), 0.0, 0.0),
            normal: Vector3::z(),
            weight: h * THICKNESS,
            sliding_speed: SPEED,
            drag: Vector3::x(),
        })
        .collect()
}

/// System with the approach free under `FORCE` and, if `moment` is given, with the tilt free under it.
fn system(points: &[SurfacePoint], moment: Option<f64>, compliance: Mat<f64>) -> ContactSystem {
    let modes = 1 + usize::from(moment.is_some());
    // Approach and tilt close the gap by 1 and x.
    let influence = Mat::from_fn(points.len(), modes, |i, j| if j == 0 { -1.0 } else { -points[i].position.x });
    let mut load = vec![FORCE];
    load.extend(moment);
    ContactSystem {
        compliance,
        balance: influence.clone(),
        influence,
        stiffness: Mat::zeros(modes, modes),
        opening: vec![0.0; points.len()],
        load,
        symmetric: true,
    }
}

/// Springs of `foundation` MPa/mm.
pub fn winkler(points: &[SurfacePoint], moment: Option<f64>, foundation: f64) -> ContactSystem {
    let n = points.len();
    let compliance = Mat::from_fn(n, n, |i, j| if i == j { 1.0 / (foundation * points[i].weight) } else { 0.0 });
    system(points, moment, compliance)
}

/// Half-plane of reduced modulus `modulus` under cells of constant pressure:
/// `u(x) = -2/(pi E*) int p(s) log(|x - s| / L) ds`, `L` far beyond the punch.
pub fn half_plane(points: &[SurfacePoint], moment: Option<f64>, modulus: f64) -> ContactSystem {
    let n = points.len();
    let h = 2.0 * HALF_WIDTH / n as f64;
    let primitive = |d: f64| if d == 0.0 { 0.0 } else { d * (d.abs() / (100.0 * HALF_WIDTH)).ln() - d };
    let compliance = Mat::from_fn(n, n, |i, j| {
        let d = points[i].position.x - points[j].position.x;
        let integral = primitive(d + 0.5 * h) - primitive(d - 0.5 * h);
        -2.0 / (std::f64::consts::PI * modulus * h * THICKNESS) * integral
    });
    system(points, moment, compliance)
}

/// Half-plane under periodic pressure of period `2 HALF_WIDTH`: a wave of number `k` yields `2 / (E* k)` per pressure.
pub fn periodic_half_plane(points: &[SurfacePoint], modulus: f64) -> ContactSystem {
    let n = points.len();
    let h = 2.0 * HALF_WIDTH / n as f64;
    let compliance = Mat::from_fn(n, n, |i, j| {
        let waves: f64 = (1..=n / 2)
            .map(|m| {
                let k = std::f64::consts::PI * m as f64 / HALF_WIDTH;
                let pair = if 2 * m == n { 1.0 } else { 2.0 };
                pair * 2.0 / (modulus * k) * (k * h * (i as f64 - j as f64)).cos()
            })
            .sum();
        (waves + HALF_WIDTH / modulus) / (n as f64 * points[j].weight)
    });
    system(points, None, compliance)
}

/// Gap under which the given pressure meets the load with the rigid coordinates at zero.
pub fn gap_for(system: &ContactSystem, points: &[SurfacePoint], pressure: impl Fn(&SurfacePoint) -> f64) -> Vec<f64> {
    let row =
        |i: usize| -> f64 { points.iter().enumerate().map(|(j, p)| system.compliance[(i, j)] * p.weight * pressure(p)).sum() };
    (0..points.len()).map(|i| -row(i)).collect()
}

/// Archard-like wear of body 1 with `factor p^b v`.
pub fn rule(factor: f64, b: f64) -> WearPair {
    WearPair::archard([factor, 0.0], [1.0, 1.0], [b, b])
}

pub fn problem(points: Vec<SurfacePoint>, system: ContactSystem, wear: WearPair, gap: Vec<f64>) -> WearProblem {
    WearProblem::new(points, wear, Counterface::Fresh, gap, system)
}

/// Mean pressure.
pub fn mean(points: &[SurfacePoint], pressure: &[f64]) -> f64 {
    let area: f64 = points.iter().map(|p| p.weight).sum();
    points.iter().zip(pressure).map(|(p, v)| p.weight * v).sum::<f64>() / area
}
