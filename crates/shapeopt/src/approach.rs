//! The force behind a prescribed approach: the fixed point of the paper's displacement-controlled iteration, found as a scalar root.

/// A force with what it took to find it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ApproachForce {
    /// Force, N.
    pub force: f64,
    /// Shapes solved for.
    pub passes: usize,
    /// What is left of the approach, over the approach.
    pub residual: f64,
}

/// Most shapes solved for.
const MOST_PASSES: usize = 200;

/// Relative accuracy of the approach.
const ACCURACY: f64 = 1e-13;

/// The force whose smallest shape needs exactly the prescribed approach; `None` if no force does.
///
/// Paczelt and Mroz (2007, Appendix A, step 3) control the pressure `p = p* v(s)` under a prescribed displacement by taking `p*` from the
/// contact solve on the last gap, and give the new gap `g = m(p) - Delta phi` its smallest rigid part. Where that iteration stands still the
/// contact solve under the approach `d` returns `p` itself on `g`, and this is so exactly if the rigid part of the smallest shape is the
/// approach: then the unloaded bodies, brought together by `d`, deform by `m` and just touch everywhere. So the fixed point solves one
/// equation for the force `F` that scales the pressure,
///
/// ```text
/// Delta(F) = d,    Delta(F) = -min_s (m(s; F) + theta (x - x0)) / phi    (rotation held at theta)
///                  Delta(F) = closing at x0 of the lowest rigid part     (rotation free under a moment)
/// ```
///
/// and no contact is solved: pressures that are infinite at the start, as under a flat punch, do no harm. With one free mode and a
/// pressure that is homogeneous in the force, `m(F) = F m(1)`, hence `F = d / Delta(1)`: the second pass confirms it. Otherwise `Delta` grows
/// with `F` (it is the largest of functions that grow), and a bracketed secant finds the root.
///
/// `needed` returns `Delta(F)` in mm, or `None` where `F` is too small for any pressure to balance the moment. `trial` is a first force.
///
/// # Errors
/// Those of `needed`.
pub fn force_of_approach<E>(
    approach: f64,
    trial: f64,
    mut needed: impl FnMut(f64) -> Result<Option<f64>, E>,
) -> Result<Option<ApproachForce>, E> {
    let (mut low, mut high): (Option<[f64; 2]>, Option<[f64; 2]>) = (None, None);
    let (mut force, mut above) = (trial, None);
    for passes in 1..=MOST_PASSES {
        let excess = needed(force)?.map(|delta| delta - approach);
        if let Some(excess) = excess.filter(|excess| excess.abs() <= ACCURACY * approach) {
            return Ok(Some(ApproachForce { force, passes, residual: excess / approach }));
        }
        // Illinois: an end that stays a second time counts half.
        match excess {
            Some(excess) if excess > 0.0 => {
                if above == Some(true) {
                    low = low.map(|[f, e]| [f, 0.5 * e]);
                }
                (high, above) = (Some([force, excess]), Some(true));
            }
            _ => {
                if above == Some(false) {
                    high = high.map(|[f, e]| [f, 0.5 * e]);
                }
                (low, above) = (Some([force, excess.unwrap_or(f64::NEG_INFINITY)]), Some(false));
            }
        }
        let next = match (low, high) {
            (Some([a, ea]), Some([b, eb])) if ea.is_finite() => (a * eb - b * ea) / (eb - ea),
            (Some([a, _]), Some([b, _])) => 0.5 * (a + b),
            // In proportion, as if homogeneous.
            (Some([f, e]), None) | (None, Some([f, e])) if e + approach > 0.0 => f * approach / (e + approach),
            (Some([f, _]), None) => 2.0 * f,
            (None, Some([f, _])) => 0.5 * f,
            (None, None) => return Ok(None),
        };
        let outside = low.is_some_and(|[a, _]| next <= a) || high.is_some_and(|[b, _]| next >= b);
        if !next.is_finite() || next <= 0.0 {
            return Ok(None);
        }
        if outside {
            // Between neighbours: round-off of the shape, if it is small.
            let [f, e] =
                [low, high].into_iter().flatten().min_by(|x, y| x[1].abs().total_cmp(&y[1].abs())).unwrap_or([force, f64::NAN]);
            let residual = e / approach;
            return Ok((residual.abs() <= 1e3 * ACCURACY).then_some(ApproachForce { force: f, passes, residual }));
        }
        force = next;
    }
    Ok(None)
}
