//! Numbers of a scene as text, in the base units or in others.

/// In which units a scene is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Writing {
    /// N, mm, MPa, s: bare numbers.
    Base,
    /// Strings in kN, m, GPa, N m, m/s, ms, W/(m K), W/(m2 K).
    Other,
}

impl Writing {
    /// A number; in the other unit, which is ten to a power of base units, its decimal point moves and no digit changes.
    fn number(self, value: f64, power: i32, unit: &str) -> String {
        if self == Writing::Base {
            return format!("{value:?}");
        }
        let text = format!("{value:e}");
        let (digits, exponent) = text.split_once('e').unwrap();
        format!("\"{digits}e{} {unit}\"", exponent.parse::<i32>().unwrap() - power)
    }

    pub(super) fn length(self, value: f64) -> String {
        self.number(value, 3, "m")
    }

    pub(super) fn lengths(self, [first, second]: [f64; 2]) -> String {
        format!("[{}, {}]", self.length(first), self.length(second))
    }

    pub(super) fn young(self, value: f64) -> String {
        self.number(value, 3, "GPa")
    }

    pub(super) fn force(self, value: f64) -> String {
        self.number(value, 3, "kN")
    }

    pub(super) fn moment(self, value: f64) -> String {
        self.number(value, 3, "N m")
    }

    pub(super) fn speed(self, value: f64) -> String {
        self.number(value, 3, "m/s")
    }

    pub(super) fn conductivity(self, value: f64) -> String {
        self.number(value, 0, "W/(m K)")
    }

    /// Convection or conductance.
    pub(super) fn film(self, value: f64) -> String {
        self.number(value, -3, "W/(m2 K)")
    }

    pub(super) fn time(self, value: f64) -> String {
        self.number(value, -3, "ms")
    }
}
