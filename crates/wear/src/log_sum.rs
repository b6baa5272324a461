//! Sums of numbers that are known by their logarithms.

/// log(exp(a) + exp(b)) without overflow.
pub(crate) fn log_sum(terms: [f64; 2]) -> f64 {
    let (hi, lo) = if terms[0] >= terms[1] { (terms[0], terms[1]) } else { (terms[1], terms[0]) };
    if lo == f64::NEG_INFINITY || hi == f64::INFINITY { hi } else { hi + (lo - hi).exp().ln_1p() }
}
