//! A wear rule given as a function, for a law that is no power of the pressure: its inverse, the pressure that wears at a given rate.

/// Wear rate of body 1 and its slope, `[w', dw'/dp]` in mm/s and mm/(s MPa), from pressure (MPa) and sliding speed (mm/s). It must be
/// zero up to some pressure p0 >= 0, continuous, and grow from there without bound.
pub type WearRule = fn(pressure: f64, sliding_speed: f64) -> [f64; 2];

/// log p with w'(p, v) = exp(log_rate), and d log p / d log w': bracketing, then Newton kept inside the bracket.
pub(crate) fn invert(rule: WearRule, log_rate: f64, speed: f64) -> (f64, f64) {
    let defect = |u: f64| {
        let [rate, slope] = rule(u.exp(), speed);
        (rate.ln() - log_rate, slope * u.exp() / rate)
    };
    let [mut low, mut high] = bracket(&|u| defect(u).0);
    let mut u = 0.5 * (low + high);
    let mut slope = f64::INFINITY;
    for _ in 0..200 {
        let (value, growth) = defect(u);
        // Below a threshold 0/0: there the pressure does not change with the rate.
        slope = if growth.is_nan() { f64::INFINITY } else { growth };
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

/// Logarithms of two pressures between which the defect of the rate changes its sign, as far as a pressure is a number.
fn bracket(defect: &dyn Fn(f64) -> f64) -> [f64; 2] {
    let (mut low, mut high) = (-1.0, 1.0);
    let mut step = 1.0;
    while defect(high) < 0.0 && high < 700.0 {
        (low, high) = (high, high + step);
        step *= 2.0;
    }
    step = 1.0;
    // Below a threshold the rate is zero and its logarithm -inf: that is low enough.
    while defect(low) >= 0.0 && low > -700.0 {
        low -= step;
        step *= 2.0;
    }
    [low, high]
}
