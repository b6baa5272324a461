//! Contact on interface operators.
