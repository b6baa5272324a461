//! A bracketed root by the secant (Illinois variant of the false position: Dowell and Jarratt 1971).

/// Two places with values of opposite sign; `b` is the last one that was tried.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    pub(crate) a: f64,
    pub(crate) value_a: f64,
    pub(crate) b: f64,
    pub(crate) value_b: f64,
}

impl Bracket {
    /// The next place to try: where the secant vanishes, if that lies inside.
    pub(crate) fn secant(&self) -> Option<f64> {
        let Bracket { a, value_a, b, value_b } = *self;
        let c = (a * value_b - b * value_a) / (value_b - value_a);
        (c > a.min(b) && c < a.max(b)).then_some(c)
    }

    /// The next place to try: that of the secant, or the middle.
    pub(crate) fn next(&self) -> f64 {
        self.secant().unwrap_or(0.5 * (self.a + self.b))
    }

    /// Takes in a place with its value. An end that stays twice counts half, so that it moves at last.
    pub(crate) fn take(&mut self, c: f64, value: f64) {
        if (value > 0.0) == (self.value_b > 0.0) {
            self.value_a *= 0.5;
        } else {
            (self.a, self.value_a) = (self.b, self.value_b);
        }
        (self.b, self.value_b) = (c, value);
    }
}

#[cfg(test)]
mod tests {
    use super::Bracket;

    #[test]
    fn a_root_is_met_although_one_end_would_never_move() {
        let f = |x: f64| x.powi(9) - 1e-3;
        let mut bracket = Bracket { a: 0.0, value_a: f(0.0), b: 2.0, value_b: f(2.0) };
        for _ in 0..60 {
            let c = bracket.next();
            bracket.take(c, f(c));
        }
        assert!((bracket.b - 1e-3_f64.powf(1.0 / 9.0)).abs() < 1e-14);
    }
}
