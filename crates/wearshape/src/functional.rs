//! The functional in the words of the theory, and its exponents.

use scene::Functional;

/// The power e of the pressure in the functional.
pub(crate) fn power(functional: Functional, b: f64) -> f64 {
    kind(functional).pressure_power(b)
}

/// s - 1 = e q - 1, rounded once.
pub(crate) fn s_minus_1(functional: Functional, b: f64, q: f64) -> f64 {
    kind(functional).s_minus_1(b, q)
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
