//! What the computed pressures are compared with: the paper's closed forms with their errata applied, by plain quadrature that shares
//! nothing with the solver.

/// `int_a^b f`, by 64 panels of 16 Gauss points.
pub(super) fn integral(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let rule = hpfem::gauss(16);
    let half = (b - a) / 128.0;
    let panel = |i: usize| {
        let middle = a + half * (2 * i + 1) as f64;
        rule.points.iter().zip(&rule.weights).map(|(t, w)| w * half * f(middle + half * t)).sum::<f64>()
    };
    (0..64).map(panel).sum()
}

/// `int_a^b r^e dr`.
pub(super) fn power_integral(e: f64, a: f64, b: f64) -> f64 {
    let n = e + 1.0;
    if n.abs() < 1e-12 { (b / a).ln() } else { (b.powf(n) - a.powf(n)) / n }
}

/// The drum of sections 5.1 to 5.3 under F0 = 10 kN.
pub(super) struct Drum {
    /// Largest pressure of `p = p_0 cos^k` from the true balance `int p cos R t da = F0` (friction drops out for even p).
    pub(super) balanced: f64,
    /// The same with the printed balance of (29)-(34), `int p R t da = F0`.
    pub(super) printed: f64,
}

/// Half angle of the block shoe, rad.
pub(super) const HALF_ANGLE: f64 = std::f64::consts::FRAC_PI_6;
/// R t of the drum, mm^2.
pub(super) const ARC_FACTOR: f64 = 200.0 * 10.0;
/// Load of both drum brakes, N.
pub(super) const DRUM_FORCE: f64 = 10_000.0;

/// Pressure at the middle for `p ~ cos^k`.
pub(super) fn drum(k: f64) -> Drum {
    let by = |power: f64| DRUM_FORCE / (ARC_FACTOR * integral(|a| a.cos().powf(power), -HALF_ANGLE, HALF_ANGLE));
    Drum { balanced: by(k + 1.0), printed: by(k) }
}

/// Multipliers of the translating punch, `p = sqrt((lambda_F + lambda_M x) / (3 beta v))` for b = 2: (40) with q = 1.
pub(super) struct Punch {
    /// lambda_F, mm/s.
    pub(super) force: f64,
    /// lambda_M, rad/s.
    pub(super) moment: f64,
    /// Pressure at x = -L/2 and L/2, MPa.
    pub(super) ends: [f64; 2],
}

/// The punch of section 6 (L = 60 mm, t = 10 mm, F0 = 1 kN, `beta~ v` = 2e-4 mu^2 5) under a moment in N mm: with
/// `p = A sqrt(1 + kappa xi)`, `xi = 2x/L`, the moment gives kappa by bisection and the force gives A.
pub(super) fn punch(moment: f64) -> Punch {
    let (half, thickness, force, wear) = (30.0, 10.0, 1000.0, 2e-4 * 0.25 * 0.25 * 5.0);
    let root = |kappa: f64, xi: f64| (1.0 + kappa * xi).max(0.0).sqrt();
    // xi = sin(t) keeps the integrand smooth where the pressure ends.
    let mean = |kappa: f64, weight: fn(f64) -> f64| {
        let quarter = std::f64::consts::FRAC_PI_2;
        integral(|t: f64| weight(t.sin()) * root(kappa, t.sin()) * t.cos(), -quarter, quarter)
    };
    let arm = |kappa: f64| mean(kappa, |xi| xi) / mean(kappa, |_| 1.0) * half;
    let [low, high] = hpfem::bisect([-1.0, 1.0], 200, |middle| arm(middle) < moment / force);
    let kappa = if moment == 0.0 { 0.0 } else { 0.5 * (low + high) };
    let size = force / (half * thickness * mean(kappa, |_| 1.0));
    let lambda = 3.0 * wear * size * size;
    Punch { force: lambda, moment: lambda * kappa / half, ends: [-1.0, 1.0].map(|xi| size * root(kappa, xi)) }
}

/// Radii of the annular punch, mm.
pub(super) const RADII: [f64; 2] = [20.0, 120.0];

/// Force on the annular punch, N: 100 MPa on its ring.
pub(super) fn ring_force() -> f64 {
    100.0 * std::f64::consts::PI * (RADII[1].powi(2) - RADII[0].powi(2))
}

/// The radius where `r^-e` is largest: powers relative to it never overflow.
fn fullest(e: f64) -> f64 {
    if e < 0.0 { RADII[1] } else { RADII[0] }
}

/// `int x^n dx` over the ring in units of a radius.
fn ring_integral(n: f64, unit: f64) -> f64 {
    power_integral(n, RADII[0] / unit, RADII[1] / unit)
}

/// `p = A r^-e` on the ring: the pressure at a radius, from (47), (54), (59) with A = F0 / (2 pi int r^(1-e) dr).
pub(super) fn ring_pressure(e: f64, radius: f64) -> f64 {
    let unit = fullest(e);
    ring_force() / (std::f64::consts::TAU * ring_integral(1.0 - e, unit) * unit * unit) * (radius / unit).powf(-e)
}

/// Torque over mu times force for `p ~ r^-e`.
pub(super) fn effective_radius(e: f64) -> f64 {
    let unit = fullest(e);
    unit * ring_integral(2.0 - e, unit) / ring_integral(1.0 - e, unit)
}
