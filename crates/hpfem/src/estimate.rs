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

/// Steps of a sequence that tell whether it falls evenly.
const STEPS: usize = 4;

/// Largest over smallest ratio of the sizes of steps that fall evenly.
const EVEN: f64 = 4.0;

/// Relative error of the last of a sequence of approximations of ever higher degree, from their differences in the Euclidean norm:
/// if the differences `d_k = |q_k - q_{k-1}|` fall by the factor `rho`, what is left is `d rho / (1 - rho)`. With two approximations
/// only, their difference. `rho` is the mean factor from the largest of the last three differences down to the last one, and `d` the largest of these three, each brought
/// to the last level by `rho`. Where the last four steps `q_k - q_{k-1}` (or three, if there are no more) go one way, at acute angles to each other, and their ratios differ by no more than
/// a factor of 4, as with energies, `rho` is kept in `[0.05, 0.9]`, otherwise in `[0.25, 0.9]`: differences that come and go by chance promise no fast fall.
/// A level that changed nothing tells nothing, as every second degree in symmetric problems: it is left out, unless the one before it changed
/// nothing either. The result is doubled: better twice too large than a little too small; on a fixed mesh with few layers it may still be half of the error.
/// If the last approximation is zero it is the last difference itself, in the unit of the quantities.
///
/// Energies get about twice their error, with three approximations 5 to 25 times. A displacement or stress at a point crosses its limit to and fro, and its estimate is a guess: on meshes
/// with layers towards every singular point (2688 estimates in an L-shape, levels 3 to 10) the error was larger in 4 % of them, at most 8 times, and half of the
/// estimates were more than 7 times too large; on one mesh for all degrees it was larger in a quarter of them, up to 23 times. A stress that vanishes, as on a free face, has no relative error:
/// give it together with others, as one list of quantities.
///
/// # Errors
/// [`Error::Count`] for fewer than two approximations, for two of different lengths and for empty ones; [`Error::OutOfRange`] for numbers that are
/// not finite.
pub fn sequence_estimate(sequence: &[Vec<f64>]) -> Result<f64, Error> {
    let [.., _, end] = sequence else {
        return Err(Error::Count { what: "approximations to compare".into(), given: sequence.len(), expected: 2 });
    };
    if let Some((i, other)) = sequence.iter().enumerate().find(|(_, other)| other.len() != end.len()) {
        let what = format!("quantities of approximation {i}, as many as of the last");
        return Err(Error::Count { what, given: other.len(), expected: end.len() });
    }
    sequence.iter().enumerate().try_for_each(|(i, values)| check_quantities(values, || format!("approximation {i}")))?;
    let step = |w: &[Vec<f64>]| -> Vec<f64> { w[0].iter().zip(&w[1]).map(|(a, b)| b - a).collect() };
    let mut steps: Vec<Vec<f64>> = sequence.windows(2).map(step).collect();
    let (size, last) = (norm(end), steps.last().map_or(0.0, |step| norm(step)));
    let nothing = |step: &Vec<f64>| norm(step) <= SAME * size;
    if size == 0.0 || steps.iter().rev().take(2).all(nothing) {
        return Ok(if size == 0.0 { last } else { last / size });
    }
    steps.retain(|step| !nothing(step));
    Ok(rest(&steps) / size)
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// What is left to go after steps of which each goes somewhere, doubled; the step itself of one alone.
fn rest(steps: &[Vec<f64>]) -> f64 {
    let sizes: Vec<f64> = steps.iter().rev().take(3).map(|step| norm(step)).collect();
    let last = sizes[0];
    if sizes.len() == 1 {
        return last;
    }
    let largest = sizes.iter().fold(0.0_f64, |most, size| most.max(*size));
    let least = if fall_evenly(&steps[steps.len().saturating_sub(STEPS)..]) { 0.05 } else { 0.25 };
    let rho = (last / largest).powf(1.0 / (sizes.len() - 1) as f64).clamp(least, 0.9);
    // Each difference brought to the last level: one alone may be small by chance.
    let steady = (0..).zip(&sizes).map(|(back, size)| size * rho.powi(back)).fold(0.0, f64::max);
    2.0 * steady * rho / (1.0 - rho)
}

/// Whether three steps or more go one way and change their size alike.
fn fall_evenly(steps: &[Vec<f64>]) -> bool {
    let one_way = steps.windows(2).all(|w| w[0].iter().zip(&w[1]).map(|(a, b)| a * b).sum::<f64>() > 0.0);
    let ratios = || steps.windows(2).map(|w| norm(&w[1]) / norm(&w[0]));
    let (least, most) = (ratios().fold(f64::INFINITY, f64::min), ratios().fold(0.0, f64::max));
    steps.len() > 2 && one_way && most <= EVEN * least
}
