//! Error estimates on a fixed discretisation, whose degree and layers need not go together.
//!
//! Coarser levels do not tell its error: from some degree on degrees alone change nothing that few layers leave, and where both fall together their
//! errors may cancel. So there is one level beside it that is finer in both, and what they differ by is the estimated error, as long as the finer
//! one is the better of the two: the saturation assumption (Bank and Weiser 1985). Random scenes tell how right that is
//! ([estimates](../../../docs/estimates.md)).
//!
//! A run in time takes too long for a finer one: coarser levels with fewer layers tell its error. A contact has coarser levels too, on which its ends
//! are found.

use crate::level::Level;
use crate::series::share;

/// Degrees and layers that the level beside has more.
const MORE: usize = 2;
/// Layers beyond which cells are about as small as round-off of their places: more of them make a level worse.
const DEEPEST: usize = 16;
/// Ratio of successive differences below which a series is not believed.
const FASTEST: f64 = 0.05;
/// Below this no estimate is made.
const ROUND_OFF: f64 = 1e-14;

/// The level that tells the error of a fixed discretisation; beyond the last degrees that there are it is a coarser one, which differs by more.
pub(crate) fn beside(fixed: Level) -> Level {
    if fixed.degree + MORE <= hpfem::MAX_DEGREE {
        Level { degree: fixed.degree + MORE, layers: (fixed.layers + MORE).min(DEEPEST), ..fixed }
    } else {
        Level { degree: fixed.degree - MORE, layers: fixed.layers.saturating_sub(MORE), ..fixed }
    }
}

/// Estimated error of a quantity that differs so much from the level beside.
pub(crate) fn error(difference: f64) -> f64 {
    difference.max(ROUND_OFF)
}

/// The levels of a contact, the coarsest first, the fixed one last: its ends are found on the coarser ones, whose degree rises by 2.
pub(crate) fn levels_of_contact(fixed: Level) -> Vec<Level> {
    with_layers(fixed, 0)
}

/// The levels of a run in time, the coarsest first, the fixed one last: up to three whose degree rises by 2, and whose layers rise too, so that their
/// differences fall like the larger of both errors.
pub(crate) fn levels_of_wear(fixed: Level) -> Vec<Level> {
    let layers = match fixed.layers {
        // Two levels tell no error, and share their bodies with those of other tasks.
        _ if fixed.degree <= 4 => 0,
        0 | 1 => 0,
        2 | 3 => 1,
        _ => 2,
    };
    with_layers(fixed, layers)
}

/// Up to three levels whose degree rises by 2 and whose layers rise by so many.
fn with_layers(fixed: Level, layers: usize) -> Vec<Level> {
    let below = [2, 1, 0].into_iter().filter(|down| fixed.degree > 2 * down);
    below.map(|down| Level { degree: fixed.degree - 2 * down, layers: fixed.layers - layers * down, ..fixed }).collect()
}

/// Estimated error of the last of three levels of a run in time, from the differences of successive ones.
pub(crate) fn error_in_time(fixed: Level, older: f64, newer: f64) -> f64 {
    let share = share((newer / older).max(FASTEST));
    let share = if fixed.layers < 2 { share.max(algebraic(fixed)) } else { share };
    (newer * share).max(ROUND_OFF)
}

/// Rest of the series over its last difference where the error falls like a power of the degree, no faster than its square: without layers.
fn algebraic(fixed: Level) -> f64 {
    let before = fixed.degree as f64 / (fixed.degree as f64 - 2.0);
    1.0 / (before * before - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fixed(degree: usize, layers: usize) -> Level {
        Level { layers, ..Level::of(degree, false) }
    }

    /// A model error: of the degree, and of the layers, each falling like a geometric series.
    fn model(level: Level) -> f64 {
        0.5_f64.powi(level.degree as i32) + 0.01 * 0.5_f64.powi(level.layers as i32)
    }

    #[test]
    fn an_error_is_seen_where_layers_limit_it_and_where_degrees_do() {
        for (degree, layers) in [(16, 12), (10, 6), (10, 0), (8, 8), (12, 2), (14, 14), (8, 20), (1, 0)] {
            let level = fixed(degree, layers);
            let effectivity = model(level) / error((model(level) - model(beside(level))).abs());
            assert!((1.0..1.5).contains(&effectivity), "{degree} {layers}: {effectivity}");
        }
    }

    #[test]
    fn the_level_beside_is_finer_while_there_is_one() {
        assert_eq!(beside(fixed(8, 0)), fixed(10, 2));
        assert_eq!(beside(fixed(22, 15)), fixed(24, 16));
        assert_eq!(beside(fixed(22, 30)), fixed(24, 16));
        assert_eq!(beside(fixed(23, 1)), fixed(21, 0));
    }

    #[test]
    fn levels_of_low_degree_and_few_layers_stay_within_range() {
        assert_eq!(levels_of_wear(fixed(8, 4))[0], fixed(4, 0));
        assert_eq!(levels_of_wear(fixed(3, 1)).len(), 2);
        assert_eq!(levels_of_wear(fixed(1, 0)), [fixed(1, 0)]);
    }
}
