//! The largest value of a function that is known at samples.

/// Sections of an interval, after which what is left of it is round-off.
const SECTIONS: usize = 60;

/// Place and value of the largest of a function's values at ascending places, or of the function between the neighbours of that place, where it has one
/// maximum: the value to round-off, the place to its root. `[NaN, -inf]` without any. What one list has more than the other does not count.
pub fn maximum(places: &[f64], values: &[f64], value: &dyn Fn(f64) -> f64) -> [f64; 2] {
    let count = places.len().min(values.len());
    let Some(most) = (0..count).max_by(|a, b| values[*a].total_cmp(&values[*b])) else {
        return [f64::NAN, f64::NEG_INFINITY];
    };
    let between = maximum_between(value, [places[most.saturating_sub(1)], places[(most + 1).min(count - 1)]]);
    let (here, there) = (values[most], value(between));
    if there > here { [between, there] } else { [places[most], here] }
}

/// Place between two others at which a function with one maximum there is largest, by golden section (Kiefer, Proc. Amer. Math. Soc. 4, 1953, 502-506);
/// the middle of what is left after 60 of them, the width times 3e-13.
pub fn maximum_between(value: &dyn Fn(f64) -> f64, [mut lower, mut upper]: [f64; 2]) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    for _ in 0..SECTIONS {
        let (x, y) = (upper - ratio * (upper - lower), lower + ratio * (upper - lower));
        if value(x) > value(y) { upper = y } else { lower = x }
    }
    0.5 * (lower + upper)
}

#[cfg(test)]
mod tests {
    use super::maximum;

    #[test]
    fn a_maximum_between_samples_is_found_and_one_at_a_sample_is_its_own() {
        let places: Vec<f64> = (0..11).map(|i| 0.1 * f64::from(i)).collect();
        let found = |value: &dyn Fn(f64) -> f64| maximum(&places, &places.iter().map(|x| value(*x)).collect::<Vec<_>>(), value);
        for top in [0.33, 0.07, 0.999] {
            let [at, most] = found(&|x| 2.0 - (x - top).powi(2));
            assert!((at - top).abs() < 1e-7 && (most - 2.0).abs() < 1e-15, "{at} {most}");
        }
        assert_eq!((found(&|x| x), found(&|x| -x), found(&|x| -(x - 0.5).abs())), ([1.0, 1.0], [0.0, 0.0], [0.5, 0.0]));
        assert_eq!(maximum(&[], &[], &|x| x)[1], f64::NEG_INFINITY);
        assert_eq!(maximum(&[0.0, 1.0], &[1.0, 0.0, 9.0], &|x| 1.0 - x), [0.0, 1.0]);
        assert_eq!(maximum(&[], &[1.0], &|x| x)[1], f64::NEG_INFINITY);
    }
}
