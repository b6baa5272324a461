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

/// Units compare without blanks, dots and asterisks between factors; `m2`, `m²` and `m^2` are one, and so are both letters mu.
fn normal(unit: &str) -> String {
    let mut normal = String::new();
    for c in unit.chars().filter(|c| !c.is_whitespace() && !matches!(c, '*' | '·')) {
        let power = match c {
            '²' => '2',
            '³' => '3',
            'μ' => 'µ',
            c => c,
        };
        if matches!(power, '2' | '3') && normal.ends_with(char::is_alphabetic) {
            normal.push('^');
        }
        normal.push(power);
    }
    normal
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

/// The schema of a quantity.
#[cfg(feature = "schema")]
pub(crate) fn schema_of(dimension: &Dimension) -> schemars::Schema {
    schemars::json_schema!({
        "description": dimension.expected(),
        "anyOf": [{ "type": "number" }, { "type": "string", "pattern": pattern(dimension) }]
    })
}

/// The regular expression of a number with one of the units, or with none.
#[cfg(feature = "schema")]
pub(crate) fn pattern(dimension: &Dimension) -> String {
    let units: Vec<String> = dimension.units.iter().map(|unit| unit_pattern(unit.0)).collect();
    format!("^\\s*[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?\\s*({})?\\s*$", units.join("|"))
}

/// A unit, with blanks, dots or asterisks between its factors and raised digits, as they are read.
#[cfg(feature = "schema")]
fn unit_pattern(unit: &str) -> String {
    let unit = unit.replace('/', "\\s*/\\s*").replace(' ', "[\\s*·]*").replace('(', "\\(").replace(')', "\\)");
    unit.replace("^2", "(\\^?2|²)").replace("^3", "(\\^?3|³)").replace('µ', "[µμ]")
}

#[cfg(test)]
mod tests {
    use super::super::quantities::{ANGLE, FORCE, LENGTH, MOMENT, PRESSURE, WEAR_FACTOR};

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
        for (same, other) in [("3 N/mm2", "3 N/mm^2"), ("3 N/mm²", "3 MPa")] {
            assert_eq!(PRESSURE.parse(same), PRESSURE.parse(other));
        }
        assert_eq!(WEAR_FACTOR.parse("1e-7 mm3/(N m)"), WEAR_FACTOR.parse("1e-7 mm^3/(N m)"));
        assert_eq!(length("5 \u{b5}m"), length("5 \u{3bc}m"), "micro sign and Greek mu");
    }

    #[test]
    fn a_wrong_unit_is_refused_with_the_known_ones() {
        let message = LENGTH.parse("10 kg").err();
        assert!(message.is_some_and(|m| m.contains("`kg`") && m.contains("mm, m, cm")));
        assert!(FORCE.parse("much").is_err());
        assert!(FORCE.parse("").is_err());
    }
}
