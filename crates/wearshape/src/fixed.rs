//! Error estimates on a fixed discretisation, whose degree and layers need not go together.
//!
//! Degrees alone do not see an error that few layers leave: from some degree on they change nothing, and their differences say that all is well. The
//! levels that tell the error of a gap have fewer layers too, so that their differences fall like the larger of both errors. The pressure of a
//! contact is compared over its inner 95 %, which cells next to the ends leave with the third layer; its levels keep their layers, and one more
//! with fewer layers shows what these are worth. The constants are measured, on 800 discretisations of seven scenes and a campaign of random ones
//! ([estimates](../../../docs/estimates.md)).

use crate::level::Level;
use crate::series::share;

/// Layers that the level beside those of a contact lacks.
const LESS: usize = 2;
/// Error that the layers leave, of the difference that so many make: each layer takes the error to a third.
const LAYERS: f64 = 0.1;
/// Layers from which on the level beside has none of its smallest cells in the inner 95 % of the surface.
const OUTSIDE: usize = 5;
/// Degree up to which a series begins with cells of degree 1 or 2, which lock: its first difference says little of the ratio.
const COARSE: usize = 6;
/// Ratio of successive differences below which a series with such cells is not believed.
const FASTEST: f64 = 0.05;
/// The error of a pressure swings about zero from degree to degree: the rest of the series is no more than so many times its last difference,
/// without and with coarse cells.
const SWING: [f64; 2] = [1.5, 0.5];
/// An energy is off by the square of what the pressure is off by, times something between this and 1. Its differences may vanish by chance.
const SQUARE: f64 = 0.05;
/// Below this no estimate is made.
const ROUND_OFF: f64 = 1e-14;

/// The levels that tell the error of a fixed discretisation's gap, the coarsest first, itself the last.
pub(crate) fn levels_of_gap(fixed: Level) -> Vec<Level> {
    let layers = match fixed.layers {
        // Two levels tell no error, and share their bodies with those of a contact.
        _ if fixed.degree <= 4 => 0,
        0 | 1 => 0,
        2 | 3 => 1,
        _ => 2,
    };
    levels(fixed, layers)
}

/// The same for a contact.
pub(crate) fn levels_of_contact(fixed: Level) -> Vec<Level> {
    levels(fixed, 0)
}

/// Up to three levels whose degree rises by 2 and whose layers rise by so many.
fn levels(fixed: Level, layers: usize) -> Vec<Level> {
    let below = [2, 1, 0].into_iter().filter(|down| fixed.degree > 2 * down);
    below.map(|down| Level { degree: fixed.degree - 2 * down, layers: fixed.layers - layers * down, ..fixed }).collect()
}

/// The level beside those of a contact, with fewer layers than the last but one; none where there is nothing to leave out, or no three levels.
pub(crate) fn beside(fixed: Level) -> Option<Level> {
    let layers = fixed.layers.saturating_sub(LESS);
    (fixed.degree > 4 && fixed.layers > 0).then(|| Level { degree: fixed.degree - 2, layers, ..fixed })
}

/// Relative differences of a quantity between the levels of a fixed discretisation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Differences {
    /// Between the first and the second level.
    pub older: f64,
    /// Between the second and the last one.
    pub newer: f64,
    /// Between the second one and that beside it.
    pub layers: f64,
}

impl Differences {
    /// Rest of the series over its last difference.
    fn share(self, fixed: Level) -> f64 {
        let ratio = self.newer / self.older;
        share(if fixed.degree <= COARSE { ratio.max(FASTEST) } else { ratio })
    }
}

/// Estimated error of a gap.
pub(crate) fn error_of_gap(fixed: Level, differences: Differences) -> f64 {
    let share = differences.share(fixed);
    // Without layers the error falls like a power of the degree, no faster than its square.
    let before = (fixed.degree as f64) / (fixed.degree as f64 - 2.0);
    let share = if fixed.layers < 2 { share.max(1.0 / (before * before - 1.0)) } else { share };
    (differences.newer * share).max(ROUND_OFF)
}

/// Estimated errors of the energy, the pressure and the twist of a contact.
pub(crate) fn errors_of_contact(fixed: Level, [energy, pressure, twist]: [Differences; 3]) -> [f64; 3] {
    let scalar = |of: Differences| (of.newer * of.share(fixed) + LAYERS * of.layers).max(ROUND_OFF);
    let swing = SWING[usize::from(fixed.degree <= COARSE)];
    let share = pressure.share(fixed).min(swing);
    let of_pressure = match fixed.layers >= OUTSIDE {
        true => pressure.newer * share + LAYERS * pressure.layers,
        false => pressure.newer * share.max(swing.min(1.0)),
    };
    let of_pressure = of_pressure.max(ROUND_OFF);
    [scalar(energy).max(SQUARE * of_pressure * of_pressure), of_pressure, scalar(twist)]
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

    #[test]
    fn the_error_of_a_gap_is_seen_where_layers_limit_it_and_where_degrees_do() {
        for (degree, layers) in [(16, 12), (10, 6), (10, 3), (8, 8), (12, 2), (20, 20), (8, 20)] {
            let level = fixed(degree, layers);
            let errors: Vec<f64> = levels_of_gap(level).into_iter().map(model).collect();
            let differences = Differences { older: errors[0] - errors[1], newer: errors[1] - errors[2], layers: 0.0 };
            let effectivity = errors[2] / error_of_gap(level, differences);
            assert!((0.2..1.5).contains(&effectivity), "{degree} {layers}: {effectivity}");
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
        assert_eq!(levels_of_gap(fixed(3, 1)).len(), 2);
        assert_eq!(levels_of_contact(fixed(1, 0)), [fixed(1, 0)]);
        assert_eq!(levels_of_gap(fixed(8, 4))[0], fixed(4, 0));
        assert_eq!(beside(fixed(8, 1)), Some(fixed(6, 0)));
        assert_eq!(beside(fixed(8, 0)), None);
    }
}
