//! Coefficients of the integrators.

use crate::wear_problem::Scheme;

/// Diagonally implicit Runge-Kutta method with the same diagonal in every stage; the last stage is the result.
pub(crate) struct Tableau {
    /// Rows of the matrix; the last is the row of weights.
    pub(crate) rows: &'static [&'static [f64]],
    /// Error estimate: factor of the rate at the start of the step, then those of the stages.
    pub(crate) error: &'static [f64],
    /// The estimated error of a step falls like the step to this power.
    pub(crate) power: f64,
    /// Order of the error at the end.
    pub(crate) order: f64,
}

/// `1 - 1/sqrt(2)`.
const G: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;
/// Factor of the second-order difference of rates at `0, G, 1` that gives the leading error of the quadrature:
/// `(1/3 - (1 - G) G^2 - G) / (G (1 - G))`.
const E: f64 = (1.0 / 3.0 - (1.0 - G) * G * G - G) / (G * (1.0 - G));

const BACKWARD_EULER: Tableau = Tableau { rows: &[&[1.0]], error: &[-0.5, 0.5], power: 2.0, order: 1.0 };

const SDIRK2: Tableau = Tableau { rows: &[&[G], &[1.0 - G, G]], error: &[-(1.0 - G) * E, E, -G * E], power: 3.0, order: 2.0 };

const SDIRK4: Tableau = Tableau {
    rows: &[
        &[0.25],
        &[0.5, 0.25],
        &[17.0 / 50.0, -1.0 / 25.0, 0.25],
        &[371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, 0.25],
        &[25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0, 0.25],
    ],
    error: &[0.0, -3.0 / 16.0, -27.0 / 32.0, 25.0 / 32.0, 0.0, 0.25],
    power: 4.0,
    order: 4.0,
};

impl Tableau {
    /// The coefficients of an implicit scheme; `None` for the explicit one.
    pub(crate) fn of(scheme: Scheme) -> Option<&'static Tableau> {
        match scheme {
            Scheme::BackwardEuler => Some(&BACKWARD_EULER),
            Scheme::Sdirk2 => Some(&SDIRK2),
            Scheme::Sdirk4 => Some(&SDIRK4),
            Scheme::Explicit => None,
        }
    }

    /// The common diagonal.
    pub(crate) fn diagonal(&self) -> f64 {
        self.rows[0][0]
    }

    /// Error of a step whose errors add up to `accuracy`, by the orders of both.
    pub(crate) fn tolerance(&self, accuracy: f64) -> f64 {
        accuracy.powf(self.power / self.order)
    }

    /// The weights.
    pub(crate) fn weights(&self) -> &'static [f64] {
        self.rows[self.rows.len() - 1]
    }
}
