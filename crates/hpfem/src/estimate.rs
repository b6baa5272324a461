//! Error estimates from a sequence of degrees.

use crate::bisect::bisect;
use crate::error::Error;

/// Steps of the last difference beyond which no limit is believed: energies that grow like a logarithm have none.
const FARTHEST: f64 = 1e4;

/// Relative difference of two approximations that is round-off.
const SAME: f64 = 1e-14;

/// Energy of the exact solution and error of the last of three, extrapolated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EnergyEstimate {
    /// Extrapolated energy, in the unit of the given ones.
    pub energy: f64,
    /// Relative error of the last solution in the energy norm, `sqrt(|U - U_3| / |U|)`.
    pub error: f64,
}

/// Extrapolates three strain energies `(unknowns, energy)` of rising degree (Szabo and Babuska 1991, eq. (4.41)): if the error
/// falls like a power of the number of unknowns,
///
/// ```text
/// (U - U_3)/(U - U_2) = ((U - U_2)/(U - U_1))^Q,   Q = ln(N_2/N_3) / ln(N_1/N_2).
/// ```
///
/// With exponential convergence the estimate is on the safe side, but for meshes with few layers towards a singular point (measured: .7 to .9 of the error).
/// None if the energies do not approach a limit monotonically, or so slowly that the last step tells none; none too where the last degree alone changed nothing,
/// as every second one does in symmetric problems.
pub fn energy_estimate(solutions: [(usize, f64); 3]) -> Option<EnergyEstimate> {
    let [(n1, u1), (n2, u2), (n3, u3)] = solutions.map(|(n, u)| (n as f64, u));
    let q = (n2 / n3).ln() / (n1 / n2).ln();
    let (first, second) = (u2 - u1, u3 - u2);
    if u3 == u2 && u2 == u1 {
        return Some(EnergyEstimate { energy: u3, error: 0.0 });
    }
    if !(first * second > 0.0 && q.is_finite() && q > 0.0) {
        return None;
    }
    // With x = (U - U_3)/(U_3 - U_2): x / (1 + x) = ((1 + x) / (1 + x + first/second))^q. The left side grows from 0 to 1; so does the
    // right one from below 1; their difference changes sign once if the steps shrink fast enough.
    let ratio = first / second;
    let rest = |x: f64| x / (1.0 + x) - ((1.0 + x) / (1.0 + x + ratio)).powf(q);
    let mut high = 1.0;
    while rest(high) < 0.0 {
        high *= 2.0;
        if high > FARTHEST {
            return None;
        }
    }
    [_, high] = bisect([0.0, high], 200, |middle| rest(middle) < 0.0);
    let energy = u3 + high * second;
    Some(EnergyEstimate { energy, error: ((energy - u3) / energy).abs().sqrt() })
}

/// Refuses an approximation without quantities, of which nothing converges, and one that is not finite.
pub(crate) fn check_quantities(values: &[f64], place: impl Fn() -> String) -> Result<(), Error> {
    if values.is_empty() {
        return Err(Error::Count { what: format!("quantities of {}, at least one", place()), given: 0, expected: 1 });
    }
    match values.iter().position(|v| !v.is_finite()) {
        Some(i) => Err(Error::OutOfRange { quantity: format!("quantity {i} of {}", place()), value: values[i], range: "finite" }),
        None => Ok(()),
    }
}

/// Relative error of the last of a sequence of approximations of ever higher degree, from their differences in the Euclidean norm:
/// if the differences `d_k = |q_k - q_{k-1}|` fall by the factor `rho`, what is left is `d rho / (1 - rho)`. With two approximations
/// only, their difference; `rho` is the geometric mean of the last two ratios and is kept in `[0.05, 0.9]`, so that one lucky small difference does not
/// end a run. A level that changed nothing tells nothing, as every second degree in symmetric problems: it is left out, unless the one before it changed
/// nothing either. The result is doubled: better twice too large than a little too small; on a fixed mesh with few layers it may still be half of the error.
/// If the last approximation is zero it is the last difference itself, in the unit of the quantities.
///
/// # Errors
/// [`Error::Count`] for fewer than two approximations, for two of different lengths and for empty ones; [`Error::OutOfRange`] for numbers that are
/// not finite.
pub fn sequence_estimate(sequence: &[Vec<f64>]) -> Result<f64, Error> {
    let [.., before, end] = sequence else {
        return Err(Error::Count { what: "approximations to compare".into(), given: sequence.len(), expected: 2 });
    };
    if let Some((i, other)) = sequence.iter().enumerate().find(|(_, other)| other.len() != end.len()) {
        let what = format!("quantities of approximation {i}, as many as of the last");
        return Err(Error::Count { what, given: other.len(), expected: end.len() });
    }
    sequence.iter().enumerate().try_for_each(|(i, values)| check_quantities(values, || format!("approximation {i}")))?;
    let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let difference = |a: &[f64], b: &[f64]| norm(&a.iter().zip(b).map(|(a, b)| a - b).collect::<Vec<_>>());
    let mut differences: Vec<f64> = sequence.windows(2).map(|w| difference(&w[0], &w[1])).collect();
    let (size, last) = (norm(end), difference(before, end));
    let nothing = |difference: &f64| *difference <= SAME * size;
    if size == 0.0 || differences.iter().rev().take(2).all(nothing) {
        return Ok(if size == 0.0 { last } else { last / size });
    }
    differences.retain(|difference| !nothing(difference));
    let (n, last) = (differences.len(), differences[differences.len() - 1]);
    if n == 1 {
        return Ok(last / size);
    }
    let ratios = &differences[n.saturating_sub(3)..];
    let rho = (last / ratios[0]).powf(1.0 / (ratios.len() - 1) as f64).clamp(0.05, 0.9);
    // The larger of the last two differences, brought to the last level: one difference alone may be small by chance.
    let steady = last.max(rho * differences[n - 2]);
    Ok(2.0 * steady * rho / (1.0 - rho) / size)
}
