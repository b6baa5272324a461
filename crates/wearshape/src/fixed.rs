//! Error estimates on a fixed discretisation, whose degree and layers need not go together.
//!
//! Degrees alone do not see an error that few layers leave: from some degree on they change nothing, and their differences say that all is well. So
//! there is one level more, with fewer layers, which shows what these are worth; the series of degrees keeps its layers. Where both fall together
//! their errors may cancel, and the ratio of such differences says nothing. The pressure of a contact is compared over its inner 95 %, which cells
//! next to the ends leave with the third layer. The constants are measured, on 800 discretisations of seven scenes; random ones, none of them
//! among those, tell how right they are ([estimates](../../../docs/estimates.md)).

use crate::level::Level;
use crate::series::share;

/// Layers that the level beside the others lacks.
const LESS: usize = 2;
/// Error that the layers leave, of the difference that so many make: each layer takes the error to a third.
const LAYERS: f64 = 0.1;
/// Layers from which on the level beside has none of its smallest cells in the inner 95 % of the surface.
const OUTSIDE: usize = 5;
/// Degree up to which a series begins with cells of degree 1 or 2, which lock: its first difference says little of the ratio, and the level beside
/// has the degree of the last.
const COARSE: usize = 6;
/// Ratio of successive differences below which a series of a gap, or one with such cells, is not believed.
const FASTEST: f64 = 0.05;
/// The error of a pressure swings about zero from degree to degree: the rest of the series is no more than so many times its last difference,
/// without and with coarse cells.
const SWING: [f64; 2] = [1.5, 0.5];
/// An energy is off by the square of what the pressure is off by, times something between this and 1, with and without layers. Its differences may
/// vanish by chance.
const SQUARE: [f64; 2] = [0.05, 0.1];
/// Below this no estimate is made.
const ROUND_OFF: f64 = 1e-14;

/// The levels that tell the error of a fixed discretisation, the coarsest first, itself the last: up to three whose degree rises by 2.
pub(crate) fn levels(fixed: Level) -> Vec<Level> {
    with_layers(fixed, 0)
}

/// The same for a run in time, which takes too long for a level beside: its levels have fewer layers too, so that their differences fall like the
/// larger of both errors.
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

/// The level beside those, with fewer layers, and which of the three it is compared with; none where there is nothing to leave out, or no three
/// levels.
pub(crate) fn beside(fixed: Level) -> Option<(Level, usize)> {
    let layers = fixed.layers.saturating_sub(LESS);
    let (down, with) = if fixed.degree <= COARSE { (0, 2) } else { (2, 1) };
    (fixed.degree > 4 && fixed.layers > 0).then(|| (Level { degree: fixed.degree - down, layers, ..fixed }, with))
}

/// Relative differences of a quantity between the levels of a fixed discretisation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Differences {
    /// Between the first and the second level.
    pub older: f64,
    /// Between the second and the last one.
    pub newer: f64,
    /// Between the level beside and the one that it is compared with; 0 without it.
    pub layers: f64,
}

impl Differences {
    /// Rest of the series over its last difference; of a ratio no smaller than the least.
    fn share(self, least: f64) -> f64 {
        share((self.newer / self.older).max(least))
    }
}

/// The least ratio that is believed in a series with coarse cells.
fn least(fixed: Level) -> f64 {
    if fixed.degree <= COARSE { FASTEST } else { 0.0 }
}

/// Rest of the series over its last difference where the error falls like a power of the degree, no faster than its square: without layers.
fn algebraic(fixed: Level) -> f64 {
    let before = fixed.degree as f64 / (fixed.degree as f64 - 2.0);
    1.0 / (before * before - 1.0)
}

/// Estimated error of a gap: that of the degree or that of the layers, of which the larger rules.
pub(crate) fn error_of_gap(fixed: Level, differences: Differences) -> f64 {
    let share = differences.share(FASTEST);
    let share = if fixed.layers < 2 { share.max(algebraic(fixed)) } else { share };
    (differences.newer * share).max(LAYERS * differences.layers).max(ROUND_OFF)
}

/// Estimated errors of the energy, the pressure and the twist of a contact. Energies come closer with every degree and every layer, so that both errors
/// add.
pub(crate) fn errors_of_contact(fixed: Level, [energy, pressure, twist]: [Differences; 3]) -> [f64; 3] {
    let scalar = |of: Differences| {
        let share = of.share(least(fixed));
        let share = if fixed.layers == 0 { share.max(algebraic(fixed)) } else { share };
        (of.newer * share + LAYERS * of.layers).max(ROUND_OFF)
    };
    let swing = SWING[usize::from(fixed.degree <= COARSE)];
    let share = pressure.share(least(fixed)).min(swing);
    let of_pressure = match fixed.layers >= OUTSIDE {
        true => pressure.newer * share + LAYERS * pressure.layers,
        false => pressure.newer * share.max(swing.min(1.0)),
    };
    let of_pressure = of_pressure.max(ROUND_OFF);
    let square = SQUARE[usize::from(fixed.layers == 0)] * of_pressure * of_pressure;
    [scalar(energy).max(square), of_pressure, scalar(twist)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fixed(degree: usize, layers: usize) -> Level {
        Level { layers, ..Level::of(degree, false) }
    }

    /// The levels of a model error: of the degree, and of the layers, each falling like a geometric series.
    fn model(level: Level) -> f64 {
        0.3_f64.powi(level.degree as i32) + 0.01 * 0.3_f64.powi(level.layers as i32)
    }

    /// What levels with these errors differ by, and the error of the last.
    fn seen(fixed: Level, model: impl Fn(Level) -> f64) -> (Differences, f64) {
        let errors: Vec<f64> = levels(fixed).into_iter().map(&model).collect();
        let layers = beside(fixed).map_or(0.0, |(level, with)| (model(level) - errors[with]).abs());
        (Differences { older: (errors[0] - errors[1]).abs(), newer: (errors[1] - errors[2]).abs(), layers }, errors[2].abs())
    }

    #[test]
    fn the_error_of_a_gap_is_seen_where_layers_limit_it_and_where_degrees_do() {
        for (degree, layers) in [(16, 12), (10, 6), (10, 3), (8, 8), (12, 2), (20, 20), (8, 20)] {
            let (differences, error) = seen(fixed(degree, layers), model);
            let effectivity = error / error_of_gap(fixed(degree, layers), differences);
            assert!((0.2..1.5).contains(&effectivity), "{degree} {layers}: {effectivity}");
        }
    }

    #[test]
    fn a_coarse_first_level_and_layers_that_are_few_hide_no_error() {
        // What a punch of degree 10 with 5 layers and a brake block of degree 8 with 9 differ by, and are off by.
        let punch = Differences { older: 3.0e-4, newer: 2.3e-5, layers: 3.4e-5 };
        let block = Differences { older: 4.5e-4, newer: 3.4e-6, layers: 2.7e-9 };
        for (level, differences, error) in [(fixed(10, 5), punch, 3.1e-6), (fixed(8, 9), block, 3.1e-7)] {
            let effectivity = error / error_of_gap(level, differences);
            assert!((0.1..2.0).contains(&effectivity), "{level:?}: {effectivity}");
        }
    }

    #[test]
    fn energies_without_layers_fall_like_a_power() {
        let power = |level: Level| (level.degree as f64).powf(-2.7);
        for degree in [5, 6, 8, 10, 14] {
            let (energy, error) = seen(fixed(degree, 0), power);
            let none = Differences { older: 0.0, newer: 0.0, layers: 0.0 };
            let effectivity = error / errors_of_contact(fixed(degree, 0), [energy, none, none])[0];
            assert!((0.1..2.0).contains(&effectivity), "{degree}: {effectivity}");
        }
    }

    #[test]
    fn an_energy_that_stands_still_by_chance_is_no_better_than_its_pressure_squared() {
        let chance = Differences { older: 1e-5, newer: 1e-12, layers: 0.0 };
        let pressure = Differences { older: 1e-2, newer: 4e-3, layers: 0.0 };
        let [energy, ..] = errors_of_contact(fixed(12, 0), [chance, pressure, chance]);
        assert!(energy > 5e-7, "{energy:e}");
    }

    #[test]
    fn levels_of_low_degree_and_few_layers_stay_within_range() {
        assert_eq!(levels(fixed(3, 1)).len(), 2);
        assert_eq!(levels(fixed(1, 0)), [fixed(1, 0)]);
        assert_eq!(levels(fixed(8, 4))[0], fixed(4, 4));
        assert_eq!(levels_of_wear(fixed(8, 4))[0], fixed(4, 0));
        assert_eq!(levels_of_wear(fixed(3, 1)).len(), 2);
        assert_eq!(beside(fixed(8, 1)), Some((fixed(6, 0), 1)));
        assert_eq!(beside(fixed(6, 4)), Some((fixed(6, 2), 2)));
        assert_eq!(beside(fixed(8, 0)), None);
    }
}
