//! Bisection: where something that holds at the lower end of a range ceases to.

/// The halves of `[low, high]` that are left after so many halvings: `before` holds at their lower end (or nowhere that was asked) and not at
/// their upper one (likewise). The middle of what is returned is the place, within `(high - low) / 2^(halvings + 1)`.
pub fn bisect([mut low, mut high]: [f64; 2], halvings: usize, mut before: impl FnMut(f64) -> bool) -> [f64; 2] {
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        if before(middle) { low = middle } else { high = middle }
    }
    [low, high]
}

#[cfg(test)]
mod tests {
    use super::bisect;

    #[test]
    fn the_place_is_met_within_the_last_half() {
        let [low, high] = bisect([0.0, 8.0], 30, |x| x * x < 2.0);
        assert!(low * low < 2.0 && high * high >= 2.0 && high - low == 8.0 / 2.0_f64.powi(30));
    }
}
