//! Shape optimisation and evolution by wear.
