//! Errors over places, and seconds at equal error.

/// One level of one program.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Point {
    /// What it is: degree and layers, or degree and cell size.
    pub(crate) label: String,
    pub(crate) unknowns: f64,
    pub(crate) seconds: f64,
    pub(crate) error: f64,
}

/// The points that no other point beats in both seconds and error, cheapest first.
pub(crate) fn front<'a>(points: impl IntoIterator<Item = &'a Point>) -> Vec<Point> {
    let mut sorted: Vec<Point> = points.into_iter().cloned().collect();
    sorted.sort_by(|a, b| a.seconds.total_cmp(&b.seconds).then(a.error.total_cmp(&b.error)));
    let mut front: Vec<Point> = Vec::new();
    for point in sorted {
        if front.last().is_none_or(|last| point.error < last.error) {
            front.push(point);
        }
    }
    front
}

/// Seconds at an error between two points of a front, linear in the logarithms; none outside.
pub(crate) fn seconds_at(front: &[Point], error: f64) -> Option<f64> {
    front.windows(2).find_map(|pair| {
        let (a, b) = (&pair[0], &pair[1]);
        let inside = b.error <= error && error <= a.error;
        let share = (a.error / error).ln() / (a.error / b.error).ln();
        inside.then(|| (a.seconds.ln() + share * (b.seconds / a.seconds).ln()).exp())
    })
}

/// Relative L2 difference over evenly weighted places, after the best combination of modes is taken out.
pub(crate) fn relative_l2(values: &[f64], truth: &[f64], modes: &[Vec<f64>]) -> f64 {
    let difference: Vec<f64> = values.iter().zip(truth).map(|(a, b)| a - b).collect();
    let rest = super::super::compare::without_modes(&difference, modes);
    let square = |values: &[f64]| values.iter().map(|v| v * v).sum::<f64>();
    (square(&rest) / square(truth)).sqrt()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn point(seconds: f64, error: f64) -> Point {
        Point { label: String::new(), unknowns: 0.0, seconds, error }
    }

    #[test]
    fn a_level_that_another_beats_in_both_is_not_on_the_front() {
        let points = [point(1.0, 1e-2), point(2.0, 2e-2), point(3.0, 1e-4)];
        assert_eq!(front(&points), [point(1.0, 1e-2), point(3.0, 1e-4)]);
    }

    #[test]
    fn seconds_are_interpolated_in_logarithms_and_never_beyond_the_ends() {
        let points = [point(1.0, 1e-2), point(100.0, 1e-4)];
        assert!((seconds_at(&points, 1e-3).unwrap() - 10.0).abs() < 1e-12);
        assert!(seconds_at(&points, 1e-5).is_none() && seconds_at(&points, 1e-1).is_none());
    }

    #[test]
    fn a_rigid_difference_is_no_error_and_a_wave_is() {
        let truth = [1.0, 2.0, 3.0, 2.0];
        let mode = vec![1.0; 4];
        let moved: Vec<f64> = truth.iter().map(|v| v + 7.0).collect();
        assert!(relative_l2(&moved, &truth, std::slice::from_ref(&mode)) < 1e-15);
        let wave: Vec<f64> = truth.iter().zip([1e-3, -1e-3, 1e-3, -1e-3]).map(|(v, w)| v + w).collect();
        assert!((relative_l2(&wave, &truth, &[mode]) - 2e-3 / 18.0_f64.sqrt()).abs() < 1e-12);
    }
}
