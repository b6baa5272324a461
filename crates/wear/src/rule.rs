//! The steady state of any wear rule given as a function: the one place to add a law that is not a power of p.

use crate::density::Density;
use crate::solve::balance_any;
use crate::stage::Stage;
use crate::{Functional, Optimum, Problem, WearError, Workspace};

/// Wear rate of body 1 and its slope, `[w', dw'/dp]` in mm/s and mm/(s MPa), from pressure (MPa) and sliding speed (mm/s). It must be
/// zero up to some pressure p0 >= 0 and grow from there.
pub type WearRule = fn(pressure: f64, sliding_speed: f64) -> [f64; 2];

/// Steady state of body 1 under a rule: w'(p, v) = V . phi with int psi p dS = F, p = 0 where V . phi <= 0. The problem's own wear
/// factors are not used; body 2 is taken as fresh.
///
/// Where the whole surface stays below the threshold nothing moves and the pressure is not determined by wear; such a load is refused.
pub fn steady_pressure_of_rule(problem: &Problem, rule: WearRule) -> Result<Optimum, WearError> {
    problem.check()?;
    let problem = Problem { functional: Functional::Steady, ..problem.clone() };
    let mut work = Workspace::default();
    let mut stage = Stage::new(&problem, Density::Rule { rule })?;
    let balanced = balance_any(&mut stage, &mut work.nodes)?;
    Ok(crate::report::report(&mut stage, &mut work, &balanced, f64::NAN))
}

/// log p with w'(p, v) = exp(log_rate), and d log p / d log w': bracketing, then Newton kept inside the bracket.
pub(crate) fn invert(rule: WearRule, log_rate: f64, speed: f64) -> (f64, f64) {
    let defect = |u: f64| {
        let [rate, slope] = rule(u.exp(), speed);
        (rate.ln() - log_rate, slope * u.exp() / rate)
    };
    let (mut low, mut high) = (-1.0, 1.0);
    let mut step = 1.0;
    while defect(high).0 < 0.0 && high < 700.0 {
        (low, high) = (high, high + step);
        step *= 2.0;
    }
    step = 1.0;
    // Below a threshold the rate is zero and its logarithm -inf: that is low enough.
    while defect(low).0 >= 0.0 && low > -700.0 {
        low -= step;
        step *= 2.0;
    }
    let mut u = 0.5 * (low + high);
    let mut slope = 1.0;
    for _ in 0..200 {
        let (value, growth) = defect(u);
        slope = growth;
        if value > 0.0 {
            high = u
        } else {
            low = u
        }
        let newton = u - value / growth;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        let moved = (next - u).abs();
        u = next;
        if moved <= 1e-15 * (1.0 + u.abs()) {
            break;
        }
    }
    (u, 1.0 / slope)
}
