//! Where a sense of sliding begins to open: the other one alone touches beyond.

/// Ends nearer than this to those of the surface, from -1 to 1, count as these.
const APART: f64 = 1e-6;

/// Which senses touch at a point.
fn touching(pressure: &[Vec<f64>; 2], i: usize) -> [bool; 2] {
    [pressure[0][i] > 0.0, pressure[1][i] > 0.0]
}

/// Places from -1 to 1 on a surface of this length at which a sense begins to open, ascending.
///
/// Beside such an end the pressure that vanishes goes like the root of the distance, and its square like the distance: the last two points under
/// pressure tell where it is, between the last of them and the first without.
pub(super) fn ends_of(pressure: &[Vec<f64>; 2], arcs: &[f64], length: f64) -> Vec<f64> {
    let n = arcs.len();
    let mut ends = Vec::new();
    for i in 1..n {
        let (before, after) = (touching(pressure, i - 1), touching(pressure, i));
        for side in [0, 1] {
            if before[side] == after[side] {
                continue;
            }
            // From the last point under pressure away from it.
            let (last, first, inner) =
                if before[side] { (i - 1, i, i.checked_sub(2)) } else { (i, i - 1, Some(i + 1).filter(|k| *k < n)) };
            let square = |k: usize| pressure[side][k].powi(2);
            let reach = inner
                .filter(|k| square(*k) > square(last))
                .map_or(0.0, |k| (arcs[last] - arcs[k]).abs() * square(last) / (square(k) - square(last)));
            let room = (arcs[first] - arcs[last]).abs();
            let arc = arcs[last] + reach.min(room) * (arcs[first] - arcs[last]).signum();
            ends.push(2.0 * arc / length - 1.0);
        }
    }
    ends.sort_unstable_by(f64::total_cmp);
    ends.dedup_by(|a, b| (*a - *b).abs() < APART);
    ends.retain(|end| end.abs() < 1.0 - APART);
    ends
}

/// How far ends are from nodes; none where there are more or fewer of them.
pub(super) fn moved(nodes: &[f64], ends: &[f64]) -> Option<f64> {
    let most = nodes.iter().zip(ends).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    (nodes.len() == ends.len()).then_some(most)
}

#[cfg(test)]
mod tests {
    use super::{ends_of, moved};

    #[test]
    fn ends_are_where_the_root_of_a_pressure_vanishes() {
        let arcs: Vec<f64> = (0..=40).map(|i| 0.05 * f64::from(i)).collect();
        let forward: Vec<f64> = arcs.iter().map(|s| (1.52 - s).max(0.0).sqrt()).collect();
        let backward: Vec<f64> = arcs.iter().map(|s| (s - 0.48).max(0.0).sqrt()).collect();
        let ends = ends_of(&[forward, backward], &arcs, 2.0);
        assert_eq!(ends.len(), 2);
        assert!((ends[0] + 0.52).abs() < 1e-9 && (ends[1] - 0.52).abs() < 1e-9, "{ends:?}");
        let full = vec![1.0; arcs.len()];
        assert!(ends_of(&[full.clone(), full], &arcs, 2.0).is_empty());
    }

    #[test]
    fn ends_that_come_or_go_have_not_moved_by_a_distance() {
        assert_eq!(moved(&[0.1, 0.5], &[0.1, 0.75]), Some(0.25));
        assert_eq!(moved(&[0.1], &[0.1, 0.75]), None);
    }
}
