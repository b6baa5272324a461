//! The pointwise law of a stationary pressure: log p as a function of log f and log v.

use crate::condition::Condition;
use crate::log_sum::log_sum;

/// Solution of the stationarity condition (17) at a point, up to a common factor for `Power` and `Mixed`.
#[derive(Clone, Debug)]
pub(crate) enum Density {
    /// p ~ (f / g^s)^k = f^k v^(-speed_power): one effective body.
    Power { k: f64, speed_power: f64 },
    /// p ~ (f / (v^(powers 0) + theta v^(powers 1)))^k: two bodies with b1 = b2, a1 != a2.
    Mixed { k: f64, log_theta: f64, powers: [f64; 2] },
    /// p ~ exp(correction / base) of f = base + correction: the limit s -> 1 where g is the pivot mode itself.
    Exponential,
    /// p = p_max where f > g = v^speed_power, else 0: s = 1 under a pressure cap.
    BangBang { speed_power: f64 },
    /// x(p, v) = f for a wear rule or a functional given as a function.
    Given(Condition),
    /// exp(log_weight) v^power p^m = f - recession of body 2.
    Receding { log_weight: f64, power: f64, m: f64 },
    /// sum_i exp(log_weight_i) v^(powers_i) p^(m_i) = f: two bodies with b1 != b2, or two rules in the steady state.
    Sum { log_weight: [f64; 2], powers: [f64; 2], m: [f64; 2] },
}

impl Density {
    /// log p and its slope d log p / d log f. `log_ratio` is log(v / v_ref), `log_speed` is log v.
    pub(crate) fn log_shape(&self, log_f: f64, log_speed: f64, log_ratio: f64) -> (f64, f64) {
        match *self {
            Self::Power { k, speed_power } => {
                let force = if k == 0.0 { 0.0 } else { k * log_f };
                let speed = if speed_power == 0.0 { 0.0 } else { speed_power * log_ratio };
                (force - speed, k)
            }
            // Exponential is given its exponent in place of log f; BangBang only its cap.
            Self::Exponential => (log_f, 1.0),
            Self::BangBang { .. } => (0.0, 0.0),
            Self::Given(ref condition) => condition.invert(log_f, log_speed.exp()),
            Self::Receding { log_weight, power, m } => ((log_f - log_weight - times(power, log_speed)) / m, 1.0 / m),
            Self::Mixed { k, log_theta, powers } => {
                let resistance = log_sum([times(powers[0], log_speed), log_theta + times(powers[1], log_speed)]);
                (k * (log_f - resistance), k)
            }
            Self::Sum { log_weight, powers, m } => {
                let q = [log_weight[0] + times(powers[0], log_speed), log_weight[1] + times(powers[1], log_speed)];
                // Newton on u -> log sum exp(q_i + m_i u) - log f, convex (m > 0) or concave in the sense of -u (m < 0):
                // from the side where one term alone reaches f the iteration is monotone.
                let single = [(log_f - q[0]) / m[0], (log_f - q[1]) / m[1]];
                let mut u = if m[0] > 0.0 { single[0].min(single[1]) } else { single[0].max(single[1]) };
                let mut slope = m[0];
                for _ in 0..100 {
                    let terms = [q[0] + m[0] * u, q[1] + m[1] * u];
                    let value = log_sum(terms);
                    let share = (terms[1] - value).exp();
                    slope = m[0] * (1.0 - share) + m[1] * share;
                    let step = (value - log_f) / slope;
                    if !step.is_finite() {
                        break;
                    }
                    u -= step;
                    if step.abs() <= 4.0 * f64::EPSILON * (1.0 + u.abs()) {
                        break;
                    }
                }
                (u, 1.0 / slope)
            }
        }
    }

    /// Exponent of p in f where f -> 0; of a function of one's own it is not known.
    pub(crate) fn front_exponent(&self) -> f64 {
        match *self {
            Self::Power { k, .. } | Self::Mixed { k, .. } => k,
            Self::Exponential | Self::BangBang { .. } | Self::Given(_) => 0.0,
            Self::Receding { m, .. } => 1.0 / m,
            Self::Sum { m, .. } => 1.0 / if m[0] > 0.0 { m[0].min(m[1]) } else { m[0].max(m[1]) },
        }
    }

    /// Logarithms of the pressures at which a rule given as a function is known to bend.
    pub(crate) fn log_bends(&self) -> &[f64] {
        match self {
            Self::Given(condition) => condition.log_bends(),
            Self::Power { .. }
            | Self::Mixed { .. }
            | Self::Exponential
            | Self::BangBang { .. }
            | Self::Receding { .. }
            | Self::Sum { .. } => &[],
        }
    }

    /// True when p is known up to a factor: multiplying f by a constant multiplies p by a constant.
    pub(crate) fn scale_free(&self) -> bool {
        matches!(self, Self::Power { .. } | Self::Mixed { .. } | Self::Exponential)
    }

    /// True when a larger f makes p smaller, of laws with an absolute factor: two bodies with s < 1.
    pub(crate) fn falls_with_force(&self) -> bool {
        matches!(*self, Self::Sum { m, .. } if m[0] < 0.0)
    }

    /// True when a larger v makes p smaller.
    pub(crate) fn falls_with_speed(&self) -> bool {
        match *self {
            Self::Power { speed_power, .. } | Self::BangBang { speed_power } => speed_power >= 0.0,
            Self::Exponential | Self::Given(_) => true,
            Self::Receding { power, .. } => power >= 0.0,
            Self::Mixed { k, powers, .. } => k * (powers[0] + powers[1]) >= 0.0,
            Self::Sum { m, powers, .. } => (powers[0] + powers[1]) * m[0] >= 0.0,
        }
    }
}

/// exponent * log v with 0 * (-inf) = 0.
fn times(exponent: f64, log_speed: f64) -> f64 {
    if exponent == 0.0 { 0.0 } else { exponent * log_speed }
}
