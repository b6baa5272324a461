//! The pressure of a place that yields elastically and by wear: one implicit step of the wear in time.

use crate::invert::invert;
use crate::rule::LocalRule;

/// Most rules that wear at one place: those of the two bodies.
const MOST: usize = 2;

/// The pressure `p` with `stiffness p + step sum_i w_i'(p) = target > 0`, and `dp/d target`; `stiffness > 0` in mm/MPa, `step` in s,
/// `target` in mm. At most two rules.
///
/// Sums of first and second powers have a closed form, sums of others are solved by Newton's method on logarithms, convex and increasing, from above;
/// other rules in a bracket.
pub fn resisted_pressure(stiffness: f64, step: f64, rules: &[&LocalRule], target: f64) -> (f64, f64) {
    let mut terms = [(stiffness, 1.0), (0.0, 1.0), (0.0, 1.0)];
    for (term, rule) in terms[1..].iter_mut().zip(rules) {
        let Some((factor, exponent)) = rule.power() else { return by_bracket(stiffness, step, rules, target) };
        *term = (step * factor, exponent);
    }
    debug_assert!(rules.len() <= MOST, "two bodies meet at a place");
    let terms = || terms.iter().filter(|t| t.0 > 0.0);
    if terms().all(|t| t.1 == 1.0) {
        let sum: f64 = terms().map(|t| t.0).sum();
        return (target / sum, 1.0 / sum);
    }
    if terms().all(|t| t.1 == 1.0 || t.1 == 2.0) {
        let [linear, square] = [1.0, 2.0].map(|exponent| terms().filter(|t| t.1 == exponent).map(|t| t.0).sum::<f64>());
        let root = linear.hypot(2.0 * square.sqrt() * target.sqrt());
        return (2.0 * target / (linear + root), 1.0 / root);
    }
    let log_target = target.ln();
    let mut x = terms().map(|(c, e)| (log_target - c.ln()) / e).fold(f64::INFINITY, f64::min);
    let (mut value, mut slope) = (0.0, 1.0);
    for _ in 0..60 {
        (value, slope) = (0.0, 0.0);
        for (c, e) in terms() {
            let term = c * (e * x).exp();
            value += term;
            slope += e * term;
        }
        let change = (value.ln() - log_target) * value / slope;
        x -= change;
        if change.abs() <= 4.0 * f64::EPSILON * (1.0 + x.abs()) {
            break;
        }
    }
    let p = x.exp();
    let slope = if value > 0.0 { slope } else { 1.0 };
    (p, p / slope)
}

fn by_bracket(stiffness: f64, step: f64, rules: &[&LocalRule], target: f64) -> (f64, f64) {
    let sum = |p: f64| {
        let [rate, slope] = rules.iter().fold([0.0; 2], |[rate, slope], rule| [rate + rule.rate(p), slope + rule.slope(p)]);
        [stiffness * p + step * rate, stiffness + step * slope]
    };
    let (log_pressure, growth) = invert(&sum, target.ln());
    let p = log_pressure.exp();
    (p, growth * p / target)
}
