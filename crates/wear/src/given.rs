//! The numbers given with a problem, and what one per cent more of each does to its data.

use crate::Problem;
use crate::mode::MAX_MODES;
use crate::surface::Shape;

/// A number given with a problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// Resultant of the mode with this index: force or moment.
    Resultant(usize),
    /// Friction coefficient mu, also in beta mu^b where the factors are made of it.
    Friction,
    /// Wear factor beta or k of body 0 or 1.
    WearFactor(usize),
    /// Pressure exponent b of body 0 or 1, at constant beta or k.
    PressureExponent(usize),
    /// Speed exponent a of body 0 or 1.
    SpeedExponent(usize),
    /// Sliding speed: of translation and rotation alike.
    SlidingSpeed,
    /// Thickness of an arc or strip.
    Thickness,
    /// Largest admissible pressure p_max.
    PressureCap,
}

/// Changes of the data of a problem, per unit of a relative change of one given number.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Change {
    /// dF of each mode.
    pub(crate) resultants: [f64; MAX_MODES],
    /// d mu.
    pub(crate) friction: f64,
    /// d log of the factors beta~.
    pub(crate) log_factors: [f64; 2],
    /// db.
    pub(crate) pressure_exponents: [f64; 2],
    /// da.
    pub(crate) speed_exponents: [f64; 2],
    /// d log v.
    pub(crate) log_speed: f64,
    /// d log of all area weights.
    pub(crate) log_thickness: f64,
    /// d log p_max.
    pub(crate) log_cap: f64,
}

impl Given {
    /// The numbers of a problem that are not zero (one per cent more of nothing is nothing), in the order of the variants.
    pub(crate) fn all(problem: &Problem) -> Vec<Given> {
        let laws = problem.wear.powers();
        // Without any factor the exponents of body 1 still give the pressure.
        let counts = |i: usize| laws[i].factor > 0.0 || (i == 0 && laws[1].factor == 0.0);
        let bodies = || (0..2).filter(|i| counts(*i));
        let mut all: Vec<Given> =
            (0..problem.modes.len()).filter(|k| problem.modes[*k].resultant != 0.0).map(Given::Resultant).collect();
        all.extend(Some(Given::Friction).filter(|_| problem.friction > 0.0));
        all.extend((0..2).filter(|i| laws[*i].factor > 0.0).map(Given::WearFactor));
        all.extend(bodies().map(Given::PressureExponent));
        all.extend(bodies().filter(|i| laws[*i].speed_exponent != 0.0).map(Given::SpeedExponent));
        let motion = problem.surface.motion();
        let moves = motion.velocity.norm() + motion.angular_velocity.norm() > 0.0;
        all.extend(Some(Given::SlidingSpeed).filter(|_| moves || problem.surface.is_listed()));
        let thick = matches!(problem.surface.shape(), Shape::Arc { .. } | Shape::Strip { .. });
        all.extend(Some(Given::Thickness).filter(|_| thick));
        all.extend(problem.p_max.map(|_| Given::PressureCap));
        all
    }

    /// What a relative change of this number does to the data.
    pub(crate) fn change(self, problem: &Problem) -> Change {
        let mut change = Change::default();
        let laws = problem.wear.powers();
        let driven = problem.wear.friction_driven;
        match self {
            Given::Resultant(k) => change.resultants[k] = problem.modes[k].resultant,
            Given::Friction => {
                change.friction = problem.friction;
                if driven {
                    change.log_factors = laws.map(|law| law.pressure_exponent);
                }
            }
            Given::WearFactor(i) => change.log_factors[i] = 1.0,
            Given::PressureExponent(i) => {
                let b = laws[i].pressure_exponent;
                change.pressure_exponents[i] = b;
                if driven && problem.friction > 0.0 {
                    change.log_factors[i] = b * problem.friction.ln();
                }
            }
            Given::SpeedExponent(i) => change.speed_exponents[i] = laws[i].speed_exponent,
            Given::SlidingSpeed => change.log_speed = 1.0,
            Given::Thickness => change.log_thickness = 1.0,
            Given::PressureCap => change.log_cap = 1.0,
        }
        change
    }
}

impl Change {
    /// d log w' of a body's wear rate at fixed pressure.
    pub(crate) fn log_rate(&self, problem: &Problem, body: usize, log_pressure: f64, log_speed: f64) -> f64 {
        self.log_factors[body]
            + times(self.speed_exponents[body], log_speed)
            + problem.wear.powers()[body].speed_exponent * self.log_speed
            + times(self.pressure_exponents[body], log_pressure)
    }
}

/// factor * logarithm with 0 * (-inf) = 0.
pub(crate) fn times(factor: f64, logarithm: f64) -> f64 {
    if factor == 0.0 { 0.0 } else { factor * logarithm }
}
