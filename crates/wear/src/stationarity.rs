//! The condition a stationary pressure satisfies at every point below the cap, sum_i Q_i v^(A_i) p^(m_i) = f, and its change with the data.

use crate::answer::Optimum;
use crate::density::Density;
use crate::given::{Change, times};
use crate::reduce::wearing_powers;
use crate::{Functional, Problem, WearLaw};

/// One term Q v^A p^m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    /// The body whose rule it comes from; `None` for the friction power.
    pub(crate) body: Option<usize>,
    /// log Q up to a number common to both terms.
    log_weight: f64,
    /// A.
    power: f64,
    /// m.
    pub(crate) m: f64,
    /// d log Q / d log beta~ = dA/da = dm/db: the q of the functional, 1 for the steady state, 0 for q = 0.
    q: f64,
    /// Power e of the pressure in the functional, of which Q is a multiple; `None` for the steady state.
    e: Option<f64>,
}

impl Term {
    /// d log Q + dA log v + A d log v + dm log p.
    pub(crate) fn change(&self, change: &Change, log_pressure: f64, log_speed: f64) -> f64 {
        let Some(body) = self.body else { return self.power * change.log_speed };
        let db = change.pressure_exponents[body];
        self.q * change.log_factors[body]
            + self.e.map_or(0.0, |e| db / e)
            + times(self.q * change.speed_exponents[body], log_speed)
            + self.power * change.log_speed
            + times(self.q * db, log_pressure)
    }

    /// log of the term.
    fn log_size(&self, log_pressure: f64, log_speed: f64) -> f64 {
        self.log_weight + times(self.power, log_speed) + self.m * log_pressure
    }
}

/// Shares of the terms in their sum.
pub(crate) fn shares(terms: &[Term], log_pressure: f64, log_speed: f64) -> Vec<f64> {
    if terms.len() == 1 {
        return vec![1.0];
    }
    let sizes: Vec<f64> = terms.iter().map(|term| term.log_size(log_pressure, log_speed)).collect();
    let largest = sizes.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = sizes.iter().map(|size| (size - largest).exp()).sum();
    sizes.iter().map(|size| (size - largest).exp() / sum).collect()
}

/// The terms of a problem's condition. `None` where the pressure is not given by them: q infinite, uniform pressure, s = 1, a
/// function of one's own.
pub(crate) fn terms(problem: &Problem, optimum: &Optimum) -> Option<Vec<Term>> {
    let (functional, q) = (&problem.functional, problem.q);
    let alone = Term { body: None, log_weight: 0.0, power: 0.0, m: 0.0, q: 0.0, e: None };
    match optimum.law.density {
        Density::Exponential | Density::BangBang { .. } | Density::Given(_) => return None,
        Density::Power { k: 0.0, .. } => return None,
        _ if *functional == Functional::FrictionPower => return Some(vec![Term { power: q, m: q - 1.0, ..alone }]),
        _ if q == 0.0 && *functional != Functional::Steady => return Some(vec![Term { m: -1.0, ..alone }]),
        Density::Receding { .. } => return Some(vec![of_rule(functional, 1.0, 0, &problem.wear.powers()[0])]),
        Density::Power { .. } | Density::Mixed { .. } | Density::Sum { .. } => {}
    }
    let mut terms: Vec<Term> = wearing_powers(problem).map(|(i, law)| of_rule(functional, q, i, &law)).collect();
    if terms.is_empty() {
        terms.push(of_rule(functional, q, 0, &problem.wear.powers()[0]));
    }
    if terms.len() == 2 {
        let weights = match optimum.law.density {
            Density::Mixed { log_theta, .. } => [0.0, log_theta],
            Density::Sum { log_weight, .. } => log_weight,
            // Equal rules: the terms are as the factors.
            Density::Power { .. }
            | Density::Exponential
            | Density::BangBang { .. }
            | Density::Given(_)
            | Density::Receding { .. } => problem.wear.powers().map(|law| law.factor.ln()),
        };
        terms.iter_mut().zip(weights).for_each(|(term, weight)| term.log_weight = weight);
    }
    Some(terms)
}

fn of_rule(functional: &Functional, q: f64, body: usize, law: &WearLaw) -> Term {
    let (a, b) = (law.speed_exponent, law.pressure_exponent);
    if *functional == Functional::Steady {
        return Term { body: Some(body), log_weight: 0.0, power: a, m: b, q: 1.0, e: None };
    }
    let e = functional.pressure_power(b);
    Term { body: Some(body), log_weight: 0.0, power: a * q, m: functional.s_minus_1(b, q), q, e: Some(e) }
}
