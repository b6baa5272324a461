//! The lowest rigid part of a gap: a small semi-infinite linear programme.
//!
//! Given a jump `m(s)` and closing velocities `phi_k(s)` on a curve, find `a` with `g = m + sum_k a_k phi_k >= 0` everywhere and the
//! least `int g dS`. With one mode of one sign this is `a = -min_s m / phi`. In general a dual simplex method exchanges touching
//! points: as many as modes, with non-negative weights `y` such that `int phi_k dS = sum_i y_i phi_k(s_i)`.

/// A jump and closing velocities on a curve with a parameter in `[0, length]`.
pub trait Curve {
    /// End of the parameter range.
    fn length(&self) -> f64;
    /// Ascending parameters fine enough to see every dip.
    fn samples(&self) -> Vec<f64>;
    /// `m` and all `phi_k` at a parameter.
    fn value(&self, s: f64) -> (f64, Vec<f64>);
    /// `int phi_k dS`.
    fn mean_modes(&self) -> Vec<f64>;
}

/// The lowest rigid part.
pub(crate) struct Lowest {
    /// Coordinates of the modes.
    pub coordinates: Vec<f64>,
    /// Largest change of `g` on the curve by changes of `m` of 1 at the touching points: `max_s sum_i |(phi(s) M^-1)_i|`, where row `i` of `M` holds
    /// `phi(s_i)`. Touching points that run into one another leave a rotation to their tangent: it is then large.
    pub amplification: f64,
    /// Largest `|m|`.
    pub scale: f64,
}

/// Solves the programme; `None` if it is infeasible or unbounded.
pub fn lowest_nonnegative(curve: &impl Curve) -> Option<Vec<f64>> {
    lowest(curve).map(|lowest| lowest.coordinates)
}

/// Solves the programme, and tells how its solution rests on the touching points.
pub(crate) fn lowest(curve: &impl Curve) -> Option<Lowest> {
    let objective = curve.mean_modes();
    let modes = objective.len();
    let samples = curve.samples();
    let values: Vec<(f64, Vec<f64>)> = samples.iter().map(|s| curve.value(*s)).collect();
    let mut touching = initial_basis(&values, &objective)?;
    let scale = values.iter().map(|v| v.0.abs()).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let mut best = None;
    for _ in 0..1000 {
        let matrix = nalgebra::DMatrix::from_fn(modes, modes, |i, k| touching[i].1[k]);
        let right = nalgebra::DVector::from_fn(modes, |i, _| -touching[i].0);
        let a: Vec<f64> = matrix.clone().lu().solve(&right)?.iter().copied().collect();
        let gap = |v: &(f64, Vec<f64>)| v.0 + a.iter().zip(&v.1).map(|(a, p)| a * p).sum::<f64>();
        let lowest = (0..values.len()).min_by(|i, j| gap(&values[*i]).total_cmp(&gap(&values[*j])))?;
        let between = [samples[lowest.saturating_sub(1)], samples[(lowest + 1).min(samples.len() - 1)]];
        let entering = curve.value(minimise(|s| gap(&curve.value(s)), between, samples[lowest]));
        let violation = gap(&entering);
        let transposed = matrix.transpose().lu();
        best = Some((a, transposed.clone()));
        if violation >= -1e-15 * scale {
            break;
        }
        // Ratio test: phi(entering) = sum z_i phi(touching_i), weights y_i.
        let z = transposed.solve(&nalgebra::DVector::from_row_slice(&entering.1))?;
        let y = transposed.solve(&nalgebra::DVector::from_row_slice(&objective))?;
        let leaving = (0..modes).filter(|i| z[*i] > 1e-14).min_by(|i, j| (y[*i] / z[*i]).total_cmp(&(y[*j] / z[*j])))?;
        touching[leaving] = entering;
    }
    let (coordinates, transposed) = best?;
    let spread = |phi: &[f64]| transposed.solve(&nalgebra::DVector::from_row_slice(phi)).map_or(f64::INFINITY, |z| z.lp_norm(1));
    let amplification = values.iter().map(|v| spread(&v.1)).fold(0.0, f64::max);
    Some(Lowest { coordinates, amplification, scale })
}

/// Touching points with non-negative weights, searched among a coarse subset of the samples.
fn initial_basis(values: &[(f64, Vec<f64>)], objective: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
    let modes = objective.len();
    let step = (values.len() / 24).max(1);
    let coarse: Vec<usize> = (0..values.len()).step_by(step).chain([values.len() - 1]).collect();
    let mut combination: Vec<usize> = (0..modes).collect();
    loop {
        let chosen: Vec<usize> = combination.iter().map(|i| coarse[*i]).collect();
        let matrix = nalgebra::DMatrix::from_fn(modes, modes, |k, i| values[chosen[i]].1[k]);
        if let Some(y) = matrix.lu().solve(&nalgebra::DVector::from_row_slice(objective))
            && y.iter().all(|v| v.is_finite() && *v >= 0.0)
        {
            return Some(chosen.iter().map(|i| values[*i].clone()).collect());
        }
        // Next combination in lexicographic order.
        let position = (0..modes).rev().find(|p| combination[*p] < coarse.len() - modes + p)?;
        combination[position] += 1;
        for later in position + 1..modes {
            combination[later] = combination[later - 1] + 1;
        }
    }
}

/// Minimum of a smooth function between two parameters, by golden section from a bracket, compared with its centre and ends.
fn minimise(f: impl Fn(f64) -> f64, [mut lower, mut upper]: [f64; 2], centre: f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let ends = [lower, upper, centre];
    for _ in 0..60 {
        let (x, y) = (upper - ratio * (upper - lower), lower + ratio * (upper - lower));
        if f(x) < f(y) { upper = y } else { lower = x }
    }
    let middle = 0.5 * (lower + upper);
    ends.into_iter().chain([middle]).min_by(|a, b| f(*a).total_cmp(&f(*b))).unwrap_or(middle)
}
