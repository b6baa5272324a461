//! What several levels leave behind: the error by degree, the times.

use crate::fe::bodies::Level;
use crate::solution::Rung;

/// What the first levels of a ladder say about the error of a quantity: `change` and `estimate` of a level by its number.
pub(super) fn rungs(
    ladder: &[Level],
    solved: usize,
    quantity: &'static str,
    change: impl Fn(usize) -> f64,
    estimate: impl Fn(usize) -> Option<f64>,
) -> Vec<Rung> {
    let rung = |(i, level): (usize, &Level)| Rung {
        quantity,
        degree: level.degree,
        change: (i > 0).then(|| change(i)),
        estimate: estimate(i),
    };
    ladder.iter().take(solved).enumerate().map(rung).collect()
}

/// Sums up the times of several levels by stage, in order of appearance.
pub(super) fn add_times(levels: &[Vec<(String, f64)>], times: &mut Vec<(String, f64)>) {
    for (name, seconds) in levels.iter().flatten() {
        match times.iter_mut().find(|(known, _)| known == name) {
            Some((_, total)) => *total += seconds,
            None => times.push((name.clone(), *seconds)),
        }
    }
}
