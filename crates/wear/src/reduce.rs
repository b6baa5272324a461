//! From functional, q and wear rules to the pointwise law of the stationary pressure.

use crate::condition::Condition;
use crate::density::Density;
use crate::threshold::ThresholdLaw;
use crate::{Counterface, Functional, Problem, Rule, Shape, WearError, WearLaw};

/// Closest to 1 that s is told apart from 1: below it s - 1 is the rounding of decimal input such as b = 0.1, q = 10.
const SINGULAR: f64 = 1e-15;

/// What the functional asks for.
#[derive(Clone, Debug)]
pub(crate) enum Task {
    /// The density is known up to the multipliers.
    Density { density: Density, s: f64 },
    /// s = 1: a linear programme with cost g = v^speed_power.
    Linear { speed_power: f64 },
    /// Two bodies whose terms in (17) have a ratio that depends on the pressure itself (q != 1).
    Ratio(Ratio),
    /// Revolving counter-face that wears: body 2's mean wear along the track is to be found.
    Revolving,
}

/// Two wearing bodies and q != 1: Q_2/Q_1 = exp(delta) is the unknown of a scalar equation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ratio {
    pub(crate) s: [f64; 2],
    /// s_i - 1.
    pub(crate) m: [f64; 2],
    /// a_i q.
    pub(crate) powers: [f64; 2],
    /// log(e_2/e_1) + q log(c_2/c_1).
    pub(crate) base: f64,
}

impl Ratio {
    /// The pointwise law for a given ratio of the two terms.
    pub(crate) fn density(&self, delta: f64) -> Density {
        let (m, powers) = (self.m, self.powers);
        if m[0] == m[1] {
            Density::Mixed { k: 1.0 / m[0], log_theta: delta, powers }
        } else {
            Density::Sum { log_weight: [0.0, delta], powers, m }
        }
    }
}

/// The wear rules that matter, body 1 first.
pub(crate) fn wearing(problem: &Problem) -> impl Iterator<Item = (usize, &Rule)> {
    let alone = problem.functional == Functional::Steady && problem.counterface == Counterface::Fresh;
    problem.wear.rules.iter().enumerate().filter(move |(i, rule)| rule.wears() && !(alone && *i == 1))
}

/// The power laws among the wear rules that matter.
pub(crate) fn wearing_powers(problem: &Problem) -> impl Iterator<Item = (usize, WearLaw)> {
    wearing(problem).filter_map(|(i, rule)| Some((i, *rule.power()?)))
}

pub(crate) fn reduce(problem: &Problem) -> Result<Task, WearError> {
    let (functional, q) = (&problem.functional, problem.q);
    match functional {
        Functional::Uniform => {
            return Ok(Task::Density { density: Density::Power { k: 0.0, speed_power: 0.0 }, s: f64::INFINITY });
        }
        Functional::FrictionPower => return Ok(single(functional, q, 1.0, 1.0)),
        Functional::Own(own) => return Ok(given(Condition::Functional(own.clone(), problem.friction))),
        Functional::Steady | Functional::WearVolume | Functional::WearPower => {}
    }
    if wearing(problem).any(|(_, rule)| rule.power().is_none()) {
        return of_no_power(problem);
    }
    let given = problem.wear.powers();
    let (first, last) = match (wearing_powers(problem).next(), wearing_powers(problem).last()) {
        (Some(first), Some(last)) => (first, last),
        // No factor at all: the exponents of body 1 still give a pressure.
        _ if given[1].factor == 0.0 => ((0, given[0]), (0, given[0])),
        _ => {
            return Err(WearError::NoWear {
                functional: functional.word(),
                remedy: "give body 1 a wear factor or choose another functional or counterface",
            });
        }
    };
    let rules = [first.1, last.1];
    if *functional == Functional::Steady {
        return Ok(if recedes(problem, last.0) { Task::Revolving } else { steady(&rules) });
    }
    powers(functional, q, &rules)
}

/// Whether body 2 is the last body that wears and recedes by its mean along tracks that the surface does not cover.
fn recedes(problem: &Problem, last: usize) -> bool {
    let tracks_covered = matches!(problem.surface.shape(), Shape::Annulus { .. });
    problem.counterface == Counterface::Revolving && last == 1 && !tracks_covered
}

/// The condition of a rule or functional that is no power of the pressure.
fn given(condition: Condition) -> Task {
    Task::Density { density: Density::Given(condition), s: f64::NAN }
}

/// Where some body wears by a rule that is no power of the pressure: in the steady state the sum of the rates is the rigid wear; a convex functional
/// of one body's rate has its own condition.
fn of_no_power(problem: &Problem) -> Result<Task, WearError> {
    let functional = problem.functional.word();
    let wearing: Vec<(usize, &Rule)> = wearing(problem).collect();
    if problem.functional != Functional::Steady {
        return match wearing[..] {
            [(_, Rule::Threshold(law))] => above_threshold(problem, law),
            _ => {
                let remedy = "ask for the steady state, or give a functional of your own with its derivatives";
                Err(WearError::OwnRule { functional, remedy })
            }
        };
    }
    if wearing.last().is_some_and(|(last, _)| recedes(problem, *last)) {
        let remedy = "on a revolving counter-face that wears both rules must be powers of the pressure";
        return Err(WearError::OwnRule { functional, remedy });
    }
    Ok(given(Condition::of_rules(wearing.into_iter().map(|(_, rule)| rule.clone()).collect())))
}

/// A functional (p^d w')^q of the one body that wears, by a rule with a threshold: convex for q b >= 1, with a condition that can be solved for the
/// pressure ("Under a threshold" in README).
fn above_threshold(problem: &Problem, law: &ThresholdLaw) -> Result<Task, WearError> {
    let (functional, q) = (problem.functional.word(), problem.q);
    let [_, d] = problem.functional.row().exponents;
    let least = q * law.law.pressure_exponent;
    // Without the factor p the functional of q b = 1 is linear above the threshold.
    if q.is_finite() && (least > 1.0 || (least == 1.0 && d > 0.0)) {
        return Ok(given(Condition::Threshold(*law, [d, q])));
    }
    let remedy = "take a finite q with q b > 1, where it is convex, or the steady state";
    Err(WearError::OwnRule { functional, remedy })
}

/// The steady state: sum_i c_i v^(a_i) p^(b_i) = f.
fn steady(rules: &[WearLaw; 2]) -> Task {
    let (a, b) = (rules.map(|law| law.speed_exponent), rules.map(|law| law.pressure_exponent));
    if a[0] == a[1] && b[0] == b[1] {
        return single(&Functional::WearPower, 1.0, a[0], b[0]);
    }
    let weights = rules.map(|law| law.factor.ln());
    if b[0] == b[1] {
        let density = Density::Mixed { k: 1.0 / b[0], log_theta: weights[1] - weights[0], powers: a };
        return Task::Density { density, s: b[0] + 1.0 };
    }
    Task::Density { density: Density::Sum { log_weight: weights, powers: a, m: b }, s: f64::NAN }
}

/// Wear volume and wear power with their q.
fn powers(functional: &Functional, q: f64, rules: &[WearLaw; 2]) -> Result<Task, WearError> {
    let (a, b) = (rules.map(|law| law.speed_exponent), rules.map(|law| law.pressure_exponent));
    if a[0] == a[1] && b[0] == b[1] {
        return Ok(single(functional, q, a[0], b[0]));
    }
    if q == 0.0 {
        // sum_i e_i int log p under the load: p = const / f whatever the rules.
        return Ok(Task::Density { density: Density::Power { k: -1.0, speed_power: 0.0 }, s: 0.0 });
    }
    if q.is_infinite() {
        let wanted = "finite for two bodies with different rules";
        return Err(WearError::OutOfRange { name: "q", value: q, wanted });
    }
    let s = b.map(|b| functional.pressure_power(b) * q);
    let m = b.map(|b| functional.s_minus_1(b, q));
    if m[0] * m[1] <= 0.0 || m[0].abs().min(m[1].abs()) <= SINGULAR {
        let why = "s1 and s2 must lie on the same side of 1";
        return Err(WearError::MixedExponents { s1: s[0], s2: s[1], why });
    }
    let e = b.map(|b| functional.pressure_power(b));
    let base = (e[1] / e[0]).ln() + q * (rules[1].factor.ln() - rules[0].factor.ln());
    Ok(Task::Ratio(Ratio { s, m, powers: [a[0] * q, a[1] * q], base }))
}

/// One effective body: p = (f / g^s)^k with g^s = v^(a q).
fn single(functional: &Functional, q: f64, a: f64, b: f64) -> Task {
    let e = functional.pressure_power(b);
    if q.is_infinite() {
        return Task::Density { density: Density::Power { k: 0.0, speed_power: a / e }, s: q };
    }
    let minus_1 = functional.s_minus_1(b, q);
    if minus_1.abs() <= SINGULAR {
        return Task::Linear { speed_power: a / e };
    }
    let k = 1.0 / minus_1;
    // s k = k + 1 without the rounding of s; a q k = (a / e) s k.
    let speed_power = if q == 0.0 { 0.0 } else { a * q * k };
    Task::Density { density: Density::Power { k, speed_power }, s: e * q }
}
