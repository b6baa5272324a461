//! Median and quartiles.

/// Middle of several numbers, and the range of the half of them around it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spread {
    pub(crate) median: f64,
    pub(crate) quartiles: [f64; 2],
}

impl Spread {
    /// Of at least one number; quantiles between two of them are interpolated (Hyndman and Fan 1996, type 7).
    pub(crate) fn of(numbers: &[f64]) -> Option<Spread> {
        let mut sorted = numbers.to_vec();
        sorted.sort_by(f64::total_cmp);
        let last = sorted.len().checked_sub(1)?;
        let at = |share: f64| {
            let place = share * last as f64;
            let (below, above) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
            below + (above - below) * place.fract()
        };
        Some(Spread { median: at(0.5), quartiles: [at(0.25), at(0.75)] })
    }
}

/// Ratios of what stands in the same place of two lists, the second over the first.
pub(crate) fn ratios(first: &[f64], second: &[f64]) -> Vec<f64> {
    first.iter().zip(second).map(|(first, second)| second / first).collect()
}

/// Geometric mean; of nothing 1.
pub(crate) fn geometric_mean(numbers: &[f64]) -> f64 {
    let sum: f64 = numbers.iter().map(|number| number.ln()).sum();
    if numbers.is_empty() { 1.0 } else { (sum / numbers.len() as f64).exp() }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_of_five_numbers_are_the_second_and_the_fourth() {
        let spread = Spread::of(&[5.0, 1.0, 4.0, 2.0, 3.0]).unwrap();
        assert_eq!(spread, Spread { median: 3.0, quartiles: [2.0, 4.0] });
    }

    #[test]
    fn between_two_numbers_they_are_interpolated() {
        assert_eq!(Spread::of(&[1.0, 3.0]), Some(Spread { median: 2.0, quartiles: [1.5, 2.5] }));
        assert_eq!(Spread::of(&[7.0]), Some(Spread { median: 7.0, quartiles: [7.0, 7.0] }));
        assert_eq!(Spread::of(&[]), None);
    }

    #[test]
    fn ratios_are_of_neighbours_in_time_so_that_a_slow_minute_drops_out() {
        // A machine that is three times slower in the second pair.
        let spread = Spread::of(&ratios(&[1.0, 3.0, 1.0], &[0.5, 1.5, 0.5])).unwrap();
        assert_eq!(spread, Spread { median: 0.5, quartiles: [0.5, 0.5] });
    }

    #[test]
    fn a_half_and_a_double_are_nothing_on_the_whole() {
        assert!((geometric_mean(&[0.5, 2.0]) - 1.0).abs() < 1e-15);
        assert_eq!(geometric_mean(&[]), 1.0);
    }
}
