//! From functional, q and wear rules to the pointwise law of the stationary pressure.

use crate::density::Density;
use crate::{Counterface, Functional, Problem, WearError, WearLaw};

/// Closest to 1 that s is told apart from 1: below it s - 1 is the rounding of decimal input such as b = 0.1, q = 10.
const SINGULAR: f64 = 1e-15;

/// What the functional asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Task {
    /// The density is known up to the multipliers.
    Density { density: Density, s: f64 },
    /// s = 1: a linear programme with cost g = v^speed_power.
    Linear { speed_power: f64 },
    /// Two bodies, b1 = b2, a1 != a2 and q != 1: theta is to be found.
    Theta { s: f64, k: f64, powers: [f64; 2] },
    /// Two bodies with b1 != b2 and q != 1: the norms A_i are to be found.
    Norms { s: [f64; 2], minus_1: [f64; 2] },
    /// Revolving counter-face that wears: body 2's mean wear along the track is to be found.
    Revolving,
}

/// The wear rules that matter, body 1 first.
pub(crate) fn wearing(problem: &Problem) -> Vec<(usize, WearLaw)> {
    let alone =
        problem.functional == Functional::Steady && problem.counterface == Counterface::Fresh;
    (0..2)
        .filter(|i| problem.wear.laws[*i].factor > 0.0 && !(alone && *i == 1))
        .map(|i| (i, problem.wear.laws[i]))
        .collect()
}

pub(crate) fn reduce(problem: &Problem) -> Result<Task, WearError> {
    let (functional, q) = (problem.functional, problem.q);
    match functional {
        Functional::Uniform => {
            return Ok(Task::Density {
                density: Density::Power {
                    k: 0.0,
                    speed_power: 0.0,
                },
                s: f64::INFINITY,
            });
        }
        Functional::FrictionPower => return Ok(single(functional, q, 1.0, 1.0)),
        _ => {}
    }
    let mut laws = wearing(problem);
    if laws.is_empty() {
        let unworn =
            problem.wear.laws[0] == problem.wear.laws[1] || problem.wear.laws[1].factor == 0.0;
        let fresh_counterface_only = problem.wear.laws[1].factor > 0.0;
        if fresh_counterface_only || !unworn {
            return Err(WearError::NoWear {
                functional: functional.word(),
                remedy: "give body 1 a wear factor or choose another functional or counterface",
            });
        }
        laws.push((0, problem.wear.laws[0]));
    }
    let (first, last) = (laws[0].1, laws[laws.len() - 1].1);
    let (a, b) = (
        [first.speed_exponent, last.speed_exponent],
        [first.pressure_exponent, last.pressure_exponent],
    );
    if functional == Functional::Steady {
        if problem.counterface == Counterface::Revolving
            && laws.last().is_some_and(|(i, _)| *i == 1)
        {
            return Ok(Task::Revolving);
        }
        if a[0] == a[1] && b[0] == b[1] {
            return Ok(single(Functional::WearPower, 1.0, a[0], b[0]));
        }
        let weights = [first.factor.ln(), last.factor.ln()];
        if b[0] == b[1] {
            let density = Density::Mixed {
                k: 1.0 / b[0],
                log_theta: weights[1] - weights[0],
                powers: a,
            };
            return Ok(Task::Density {
                density,
                s: b[0] + 1.0,
            });
        }
        let density = Density::Sum {
            log_weight: weights,
            powers: a,
            m: b,
        };
        return Ok(Task::Density {
            density,
            s: f64::NAN,
        });
    }
    if a[0] == a[1] && b[0] == b[1] {
        return Ok(single(functional, q, a[0], b[0]));
    }
    if b[0] == b[1] {
        if q.is_infinite() {
            return Err(WearError::OutOfRange {
                name: "q",
                value: q,
                wanted: "finite for two bodies with a1 != a2",
            });
        }
        let minus_1 = functional.s_minus_1(b[0], q);
        let s = functional.pressure_power(b[0]) * q;
        let powers = [a[0] * q, a[1] * q];
        if minus_1.abs() <= SINGULAR {
            return Err(WearError::MixedExponents {
                s1: s,
                s2: s,
                why: "s = 1 with a1 != a2 is not answered",
            });
        }
        let k = 1.0 / minus_1;
        if q == 1.0 || q == 0.0 {
            let log_theta = if q == 0.0 {
                0.0
            } else {
                last.factor.ln() - first.factor.ln()
            };
            return Ok(Task::Density {
                density: Density::Mixed {
                    k,
                    log_theta,
                    powers,
                },
                s,
            });
        }
        return Ok(Task::Theta { s, k, powers });
    }
    let s = b.map(|b| functional.pressure_power(b) * q);
    let minus_1 = b.map(|b| functional.s_minus_1(b, q));
    if q.is_infinite() || q == 0.0 {
        return Err(WearError::OutOfRange {
            name: "q",
            value: q,
            wanted: "finite and not 0 for two bodies with b1 != b2",
        });
    }
    if minus_1[0] * minus_1[1] <= 0.0 {
        return Err(WearError::MixedExponents {
            s1: s[0],
            s2: s[1],
            why: "s1 and s2 lie on different sides of 1",
        });
    }
    Ok(Task::Norms { s, minus_1 })
}

/// One effective body: p = (f / g^s)^k with g^s = v^(a q).
fn single(functional: Functional, q: f64, a: f64, b: f64) -> Task {
    let e = functional.pressure_power(b);
    if q.is_infinite() {
        return Task::Density {
            density: Density::Power {
                k: 0.0,
                speed_power: a / e,
            },
            s: q,
        };
    }
    let minus_1 = functional.s_minus_1(b, q);
    if minus_1.abs() <= SINGULAR {
        return Task::Linear { speed_power: a / e };
    }
    let k = 1.0 / minus_1;
    // s k = k + 1 without the rounding of s; a q k = (a / e) s k.
    let speed_power = if q == 0.0 { 0.0 } else { a * q * k };
    Task::Density {
        density: Density::Power { k, speed_power },
        s: e * q,
    }
}
