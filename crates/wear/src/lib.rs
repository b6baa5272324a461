//! Wear rules, functionals and optimal pressures.
