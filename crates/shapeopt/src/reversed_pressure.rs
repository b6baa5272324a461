//! The two pressures of a point that slides forward part of the time and backward the rest, by their difference and their mean wear rate.
//!
//! With `share` of the time forward the pressures `p+` and `p-` of a point with the mean rate `f` lie on the curve
//! `share w'(p+) + (1 - share) w'(p-) = f`. Their difference `p+ - p-` runs along it from `-p-(f)`, where the point carries nothing forward, to
//! `p+(f)`, where it carries nothing backward, and both pressures follow it with slopes between 0 and 1 whatever the exponent of the rule.

use crate::gap_rate::GapRate;

/// Halvings at most of the interval in which a pressure lies.
const HALVINGS: usize = 200;

/// Both pressures with their derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Pressures {
    /// `p+`, `p-`.
    pub(crate) value: [f64; 2],
    /// By the difference asked for: 0 beyond the ends of the curve.
    pub(crate) by_difference: [f64; 2],
    /// By the mean rate.
    pub(crate) by_rate: [f64; 2],
}

impl Pressures {
    /// Difference reached.
    pub(crate) fn difference(&self) -> f64 {
        self.value[0] - self.value[1]
    }

    /// Whether the difference asked for was beyond an end of the curve.
    pub(crate) fn ended(&self) -> bool {
        self.by_difference == [0.0; 2]
    }
}

/// The pressures of point `i` whose difference is nearest to the one asked for, at a mean rate.
pub(crate) fn pressures(rate: &GapRate, i: usize, share: f64, difference: f64, mean: f64) -> Pressures {
    let shares = [share, 1.0 - share];
    if mean <= 0.0 {
        return Pressures::default();
    }
    // Alone each sense has this pressure; without a limit where it takes no part in the wear.
    let alone = shares.map(|part| if part > 0.0 { rate.inverse(i, 0.0, part, mean).0 } else { f64::INFINITY });
    let slope = |side: usize, p: f64| if shares[side] > 0.0 { shares[side] * rate.local_slope(i, p) } else { 0.0 };
    for (side, sign) in [(0, 1.0), (1, -1.0)] {
        if sign * difference >= alone[side] {
            let mut ended = Pressures::default();
            ended.value[side] = alone[side];
            ended.by_rate[side] = 1.0 / slope(side, alone[side]);
            return ended;
        }
    }
    let value = between(rate, i, [shares, alone], difference, mean);
    let slopes = [slope(0, value[0]), slope(1, value[1])];
    let part = match slopes {
        [first, _] if first.is_infinite() => 0.0,
        [_, second] if second.is_infinite() => 1.0,
        [first, second] => second / (first + second),
    };
    Pressures { value, by_difference: [part, part - 1.0], by_rate: [1.0 / (slopes[0] + slopes[1]); 2] }
}

/// Both pressures within the curve, by the shares of the senses and the pressures that they have alone.
fn between(rate: &GapRate, i: usize, [shares, alone]: [[f64; 2]; 2], difference: f64, mean: f64) -> [f64; 2] {
    if shares[0] == 0.0 {
        return [alone[1] + difference, alone[1]];
    }
    if shares[1] == 0.0 {
        return [alone[0], alone[0] - difference];
    }
    let unit = rate.local(i, 1.0);
    if rate.is_linear() && unit > 0.0 {
        let whole = mean / unit;
        return [whole + shares[1] * difference, whole - shares[0] * difference];
    }
    // The smaller of the two is at least 0; the sum of the rates grows with it.
    let at = |low: f64| if difference >= 0.0 { [low + difference, low] } else { [low, low - difference] };
    let excess = |low: f64| {
        let [first, second] = at(low);
        shares[0] * rate.local(i, first) + shares[1] * rate.local(i, second) - mean
    };
    let (mut low, mut high) = (0.0, alone[0].max(alone[1]));
    let mut smaller = 0.5 * high;
    for _ in 0..HALVINGS {
        let off = excess(smaller);
        if off > 0.0 {
            high = smaller
        } else {
            low = smaller
        }
        let [first, second] = at(smaller);
        let slope = shares[0] * rate.local_slope(i, first) + shares[1] * rate.local_slope(i, second);
        let newton = smaller - off / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - smaller).abs() <= 2.0 * f64::EPSILON * next || high <= low {
            return at(next);
        }
        smaller = next;
    }
    at(smaller)
}

#[cfg(test)]
mod tests {
    use super::*;
    use wear::{Counterface, WearPair};

    #[test]
    fn both_pressures_have_the_mean_rate_and_the_difference_asked_for() {
        for b in [0.3, 1.0, 2.5] {
            let wear = WearPair::archard([1e-7, 3e-7], [1.0; 2], [b, 0.7]);
            for counterface in [Counterface::Fresh, Counterface::Congruent] {
                let rate = GapRate::new(&wear, counterface, &[5.0], &[1.0], None);
                for share in [0.2, 0.5] {
                    let mean = share * rate.local(0, 3.0) + (1.0 - share) * rate.local(0, 1.0);
                    let at = |difference: f64, mean: f64| pressures(&rate, 0, share, difference, mean);
                    let found = at(2.0, mean);
                    approx::assert_relative_eq!(found.value[0], 3.0, max_relative = 1e-12);
                    approx::assert_relative_eq!(found.value[1], 1.0, max_relative = 1e-11);
                    let h = 1e-6;
                    for side in [0, 1] {
                        let by = (at(2.0 + h, mean).value[side] - at(2.0 - h, mean).value[side]) / (2.0 * h);
                        approx::assert_relative_eq!(found.by_difference[side], by, max_relative = 1e-6);
                        let [up, down] = [1.0 + h, 1.0 - h].map(|factor| at(2.0, mean * factor).value[side]);
                        approx::assert_relative_eq!(found.by_rate[side], (up - down) / (2.0 * h * mean), max_relative = 1e-6);
                    }
                    // Beyond the end the other sense carries nothing.
                    let ended = at(1e3, mean);
                    assert!(ended.ended() && ended.value[1] == 0.0);
                    approx::assert_relative_eq!(share * rate.local(0, ended.value[0]), mean, max_relative = 1e-12);
                }
            }
        }
    }
}
