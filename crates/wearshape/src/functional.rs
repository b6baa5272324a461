//! The functional in the words of the theory, and its exponents.

use scene::Functional;
use wear::FunctionalRow;

/// The power e of the pressure in the functional.
pub(crate) fn power(functional: Functional, b: f64) -> f64 {
    kind(functional).pressure_power(b)
}

/// s - 1 = e q - 1, rounded once.
pub(crate) fn s_minus_1(functional: Functional, b: f64, q: f64) -> f64 {
    kind(functional).s_minus_1(b, q)
}

/// The row of a functional in the table of the theory: its word, what it needs, its pressure in a sentence.
pub fn functional_row(functional: Functional) -> &'static FunctionalRow {
    kind(functional).row()
}

/// The functional in the words of the theory.
pub(crate) fn kind(functional: Functional) -> wear::Functional {
    match functional {
        Functional::Steady => wear::Functional::Steady,
        Functional::WearVolume => wear::Functional::WearVolume,
        Functional::FrictionPower => wear::Functional::FrictionPower,
        Functional::WearPower => wear::Functional::WearPower,
        Functional::Uniform => wear::Functional::Uniform,
    }
}

#[cfg(test)]
mod tests {
    use super::{Functional, functional_row, kind};
    use crate::words::word;

    #[test]
    fn the_words_of_scenes_are_those_of_the_table() {
        let all =
            [Functional::Steady, Functional::WearVolume, Functional::FrictionPower, Functional::WearPower, Functional::Uniform];
        for functional in all {
            assert_eq!(word(&functional), functional_row(functional).word);
        }
        let met = |row: &wear::Functional| all.iter().any(|functional| kind(*functional) == *row);
        assert!(wear::Functional::ALL.iter().all(met), "a functional of the theory that no scene can name");
    }
}
