//! What can be measured, in which units, and how a string with a unit is read.

use crate::read::decimal_comma;

/// One unit: its name, and the factor to the base unit as numerator and denominator, so that "5 um" rounds once.
pub(crate) type Unit = (&'static str, f64, f64);

/// What a quantity measures: the word for messages, the base unit, the units known.
pub(crate) struct Dimension {
    pub(crate) word: &'static str,
    pub(crate) base: &'static str,
    pub(crate) units: &'static [Unit],
}

pub(crate) const LENGTH: Dimension = Dimension {
    word: "length",
    base: "mm",
    units: &[
        ("mm", 1.0, 1.0),
        ("m", 1e3, 1.0),
        ("cm", 10.0, 1.0),
        ("um", 1.0, 1e3),
        ("µm", 1.0, 1e3),
        ("nm", 1.0, 1e6),
        ("in", 25.4, 1.0),
        ("km", 1e6, 1.0),
    ],
};
pub(crate) const FORCE: Dimension =
    Dimension { word: "force", base: "N", units: &[("N", 1.0, 1.0), ("kN", 1e3, 1.0), ("MN", 1e6, 1.0), ("mN", 1.0, 1e3)] };
pub(crate) const PRESSURE: Dimension = Dimension {
    word: "pressure or modulus",
    base: "MPa",
    units: &[("MPa", 1.0, 1.0), ("GPa", 1e3, 1.0), ("kPa", 1.0, 1e3), ("Pa", 1.0, 1e6), ("bar", 1.0, 10.0), ("N/mm^2", 1.0, 1.0)],
};
pub(crate) const ANGLE: Dimension = Dimension {
    word: "angle",
    base: "rad",
    units: &[("rad", 1.0, 1.0), ("deg", std::f64::consts::PI, 180.0), ("mrad", 1.0, 1e3)],
};
pub(crate) const SPEED: Dimension = Dimension {
    word: "speed",
    base: "mm/s",
    units: &[("mm/s", 1.0, 1.0), ("m/s", 1e3, 1.0), ("um/s", 1.0, 1e3), ("m/min", 1e3, 60.0), ("km/h", 1e6, 3600.0)],
};
pub(crate) const ANGULAR_SPEED: Dimension = Dimension {
    word: "angular speed",
    base: "rad/s",
    units: &[
        ("rad/s", 1.0, 1.0),
        ("rpm", std::f64::consts::PI, 30.0),
        ("1/min", std::f64::consts::PI, 30.0),
        ("deg/s", std::f64::consts::PI, 180.0),
    ],
};
pub(crate) const TIME: Dimension =
    Dimension { word: "time", base: "s", units: &[("s", 1.0, 1.0), ("ms", 1.0, 1e3), ("min", 60.0, 1.0), ("h", 3600.0, 1.0)] };
pub(crate) const MOMENT: Dimension = Dimension {
    word: "moment",
    base: "N mm",
    units: &[("N mm", 1.0, 1.0), ("N m", 1e3, 1.0), ("kN mm", 1e3, 1.0), ("kN m", 1e6, 1.0), ("Nmm", 1.0, 1.0), ("Nm", 1e3, 1.0)],
};
pub(crate) const DENSITY: Dimension = Dimension {
    word: "density",
    base: "t/mm^3",
    units: &[
        ("kg/m^3", 1.0, 1e12),
        ("kg/m3", 1.0, 1e12),
        ("g/cm^3", 1.0, 1e9),
        ("g/cm3", 1.0, 1e9),
        ("t/m^3", 1.0, 1e9),
        ("t/m3", 1.0, 1e9),
        ("t/mm^3", 1.0, 1.0),
    ],
};
pub(crate) const VOLUME: Dimension =
    Dimension { word: "volume", base: "mm^3", units: &[("mm^3", 1.0, 1.0), ("cm^3", 1e3, 1.0), ("um^3", 1.0, 1e9)] };
pub(crate) const FREQUENCY: Dimension = Dimension {
    word: "frequency",
    base: "cycles a second",
    units: &[("Hz", 1.0, 1.0), ("kHz", 1e3, 1.0), ("1/s", 1.0, 1.0), ("1/min", 1.0, 60.0), ("1/h", 1.0, 3600.0)],
};
pub(crate) const TEMPERATURE: Dimension =
    Dimension { word: "temperature", base: "degC", units: &[("degC", 1.0, 1.0), ("°C", 1.0, 1.0)] };
pub(crate) const CONDUCTIVITY: Dimension = Dimension {
    word: "conductivity",
    base: "mW/(mm K)",
    units: &[("W/(m K)", 1.0, 1.0), ("mW/(mm K)", 1.0, 1.0), ("W/(mm K)", 1e3, 1.0), ("W/m/K", 1.0, 1.0)],
};
pub(crate) const EXPANSION: Dimension = Dimension {
    word: "thermal expansion",
    base: "1/K",
    units: &[("1/K", 1.0, 1.0), ("/K", 1.0, 1.0), ("um/(m K)", 1.0, 1e6), ("ppm/K", 1.0, 1e6), ("1/degC", 1.0, 1.0)],
};
pub(crate) const HEAT_TRANSFER: Dimension = Dimension {
    word: "coefficient of heat transfer",
    base: "mW/(mm^2 K)",
    units: &[
        ("W/(m2 K)", 1.0, 1e3),
        ("W/(m^2 K)", 1.0, 1e3),
        ("kW/(m2 K)", 1.0, 1.0),
        ("kW/(m^2 K)", 1.0, 1.0),
        ("mW/(mm2 K)", 1.0, 1.0),
        ("mW/(mm^2 K)", 1.0, 1.0),
        ("W/(mm2 K)", 1e3, 1.0),
        ("W/(mm^2 K)", 1e3, 1.0),
    ],
};
pub(crate) const HEAT_FLUX: Dimension = Dimension {
    word: "heat flux",
    base: "mW/mm^2",
    units: &[
        ("W/m2", 1.0, 1e3),
        ("W/m^2", 1.0, 1e3),
        ("kW/m2", 1.0, 1.0),
        ("kW/m^2", 1.0, 1.0),
        ("mW/mm2", 1.0, 1.0),
        ("mW/mm^2", 1.0, 1.0),
        ("W/mm2", 1e3, 1.0),
        ("W/mm^2", 1e3, 1.0),
        ("W/cm2", 10.0, 1.0),
        ("W/cm^2", 10.0, 1.0),
    ],
};
pub(crate) const WEAR_FACTOR: Dimension = Dimension {
    word: "wear factor",
    base: "mm^2/N (for a = b = 1)",
    units: &[
        ("mm^3/(N mm)", 1.0, 1.0),
        ("mm^3/(N m)", 1.0, 1e3),
        ("mm^3/N/m", 1.0, 1e3),
        ("m^3/(N m)", 1e6, 1.0),
        ("mm^2/N", 1.0, 1.0),
        ("m^2/N", 1e6, 1.0),
        ("1/MPa", 1.0, 1.0),
        ("1/Pa", 1e6, 1.0),
    ],
};

impl Dimension {
    fn with_article(&self) -> String {
        format!("{} {}", if self.word.starts_with('a') { "an" } else { "a" }, self.word)
    }

    /// What to write.
    pub(crate) fn expected(&self) -> String {
        let units: Vec<&str> = self.units.iter().map(|unit| unit.0).filter(|unit| unit.is_ascii()).collect();
        format!("{} as a number in {}, or a string with one of the units {}", self.with_article(), self.base, units.join(", "))
    }

    /// The value in the base unit, and whether a unit was written.
    pub(crate) fn parse(&self, text: &str) -> Result<(f64, bool), String> {
        let trimmed = text.trim();
        let end = number_end(trimmed);
        let number: f64 = trimmed[..end].parse().map_err(|_| {
            format!("\"{text}\" is not {}: no number at its beginning\nwrite {}", self.with_article(), self.expected())
        })?;
        if let Some(meant) = decimal_comma(trimmed) {
            return Err(format!("\"{text}\" has a decimal comma\nwrite a decimal point, not a comma: \"{meant}\""));
        }
        let unit = normal(&trimmed[end..]);
        if unit.is_empty() {
            return Ok((number, false));
        }
        match self.units.iter().find(|known| normal(known.0) == unit) {
            Some((_, numerator, denominator)) => Ok((number * numerator / denominator, true)),
            None => {
                let unit = trimmed[end..].trim();
                Err(format!("wrong unit: `{unit}` does not measure {}\nwrite {}", self.with_article(), self.expected()))
            }
        }
    }
}

/// Units compare without blanks, dots and asterisks between factors.
fn normal(unit: &str) -> String {
    unit.chars()
        .filter(|c| !c.is_whitespace() && !matches!(c, '*' | '·'))
        .collect::<String>()
        .replace('²', "^2")
        .replace('³', "^3")
}

/// Length of the number at the beginning of a text.
fn number_end(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let exponent = at > 0
            && matches!(bytes[at], b'e' | b'E')
            && bytes.get(at + 1).is_some_and(|next| {
                next.is_ascii_digit() || (matches!(next, b'+' | b'-') && bytes.get(at + 2).is_some_and(u8::is_ascii_digit))
            });
        if exponent {
            at += 2;
        } else if bytes[at].is_ascii_digit() || bytes[at] == b'.' || (at == 0 && matches!(bytes[at], b'+' | b'-')) {
            at += 1;
        } else {
            break;
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_convert_with_one_rounding() {
        let length = |text| LENGTH.parse(text).map(|(value, _)| value);
        assert_eq!(length("5 um"), Ok(0.005));
        assert_eq!(length("2in"), Ok(50.8));
        assert_eq!(length(".5m"), Ok(500.0));
        assert_eq!(PRESSURE.parse("210 GPa"), Ok((210e3, true)));
        assert_eq!(ANGLE.parse("30 deg").map(|p| p.0), Ok(30.0 * std::f64::consts::PI / 180.0));
        assert_eq!(MOMENT.parse("-5 kN*mm"), Ok((-5e3, true)));
        assert_eq!(WEAR_FACTOR.parse("1.33e-7 mm^3/(N m)"), Ok((1.33e-10, true)));
        assert_eq!(FORCE.parse("1e3"), Ok((1e3, false)));
    }

    #[test]
    fn a_wrong_unit_is_refused_with_the_known_ones() {
        let message = LENGTH.parse("10 kg").err();
        assert!(message.is_some_and(|m| m.contains("`kg`") && m.contains("mm, m, cm")));
        assert!(FORCE.parse("much").is_err());
        assert!(FORCE.parse("").is_err());
    }
}
