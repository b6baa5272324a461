//! Numbers for the first screen and for sentences: four digits.

/// A number with four digits, plain where that is short; what lies midway but for round-off is midway.
pub(crate) fn brief(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value:.0}").replace("-0", "0");
    }
    let rounded = rounded(rounded(value, 11), 3);
    let magnitude = rounded.abs().log10().floor() as i32;
    if (-4..7).contains(&magnitude) { format!("{rounded}") } else { format!("{rounded:e}") }
}

/// A number with so many digits behind its first one.
fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.digits$e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::brief;

    #[test]
    fn four_digits_are_enough_to_read() {
        assert_eq!([5.454545, 1.0863569, 521788.07, 0.0, -12.60001].map(brief), ["5.455", "1.086", "521800", "0", "-12.6"]);
        assert_eq!([135.75, 135.75 - 1e-13].map(brief), ["135.8"; 2]);
        assert_eq!([1.0864e-12, 1.0864e12, 0.00012345].map(brief), ["1.086e-12", "1.086e12", "0.0001234"]);
    }
}
