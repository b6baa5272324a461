//! Points that cut a line: between two ends, merged, halved, evenly or growing.

/// Share of the contact below which two points of it are meant to be one: a mesh file has fewer digits than its geometry.
pub(crate) const SAME: f64 = 1e-6;

/// How far apart, over the contact, points of both bodies may lie that are one: curves in mesh files are polynomials, circles of the third degree off by 6e-10.
pub(crate) const READ: f64 = 1e-8;

/// Cuts every interval between the given points into equal pieces no longer than `step`.
pub(crate) fn subdivide(points: &[f64], step: f64) -> Vec<f64> {
    let mut cuts = vec![points[0]];
    for pair in points.windows(2) {
        let pieces = ((pair[1] - pair[0]) / step * (1.0 - 1e-9)).ceil().max(1.0) as usize;
        for i in 1..=pieces {
            let t = i as f64 / pieces as f64;
            cuts.push(if i == pieces { pair[1] } else { (1.0 - t) * pair[0] + t * pair[1] });
        }
    }
    cuts
}

/// Longest interval.
pub(crate) fn widest(cuts: &[f64]) -> f64 {
    cuts.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
}

/// Ascending points with near duplicates removed.
pub(crate) fn merged(mut points: Vec<f64>) -> Vec<f64> {
    points.sort_unstable_by(f64::total_cmp);
    let scale = points.last().copied().unwrap_or(0.0) - points.first().copied().unwrap_or(0.0);
    points.dedup_by(|b, a| (*b - *a).abs() <= 1e-9 * scale);
    points
}

/// The points and the middles between them.
pub(crate) fn halved(points: &[f64]) -> Vec<f64> {
    let last = points.last().copied();
    points.windows(2).flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]).chain(last).collect()
}

/// Points between two ends whose distances double from both ends inwards, `first` at the ends and `most` at most.
pub(crate) fn growing(from: f64, to: f64, first: f64, most: f64) -> Vec<f64> {
    let (mut left, mut right) = (vec![from], vec![to]);
    let mut step = first;
    // Halves that meet leave no piece between them, whatever the round-off.
    while (to - from) * (1.0 - 1e-9) > 2.0 * step + left[left.len() - 1] - from + to - right[right.len() - 1] {
        left.push(left[left.len() - 1] + step);
        right.push(right[right.len() - 1] - step);
        step = (2.0 * step).min(most);
    }
    let middle = subdivide(&[left[left.len() - 1], right[right.len() - 1]], step);
    left.pop();
    left.extend(middle);
    right.pop();
    left.extend(right.into_iter().rev());
    left
}

/// Parameters in [-1, 1] of points between two ends.
pub(crate) fn parameters(points: &[f64], [from, to]: [f64; 2]) -> Vec<f64> {
    points.iter().map(|x| (2.0 * x - from - to) / (to - from)).collect()
}
