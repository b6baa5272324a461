//! Quantities of a scene: a bare number in N, mm, MPa, s, rad, or a string with a unit. Kept in base units.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::{Serialize, Serializer};

/// One unit: its name, and the factor to the base unit as numerator and denominator, so that "5 um" rounds once.
type Unit = (&'static str, f64, f64);

/// What a quantity measures: the word for messages, the base unit, the units known.
struct Dimension {
    word: &'static str,
    base: &'static str,
    units: &'static [Unit],
}

const LENGTH: Dimension = Dimension {
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
    ],
};
const FORCE: Dimension = Dimension {
    word: "force",
    base: "N",
    units: &[
        ("N", 1.0, 1.0),
        ("kN", 1e3, 1.0),
        ("MN", 1e6, 1.0),
        ("mN", 1.0, 1e3),
    ],
};
const PRESSURE: Dimension = Dimension {
    word: "pressure or modulus",
    base: "MPa",
    units: &[
        ("MPa", 1.0, 1.0),
        ("GPa", 1e3, 1.0),
        ("kPa", 1.0, 1e3),
        ("Pa", 1.0, 1e6),
        ("bar", 1.0, 10.0),
        ("N/mm^2", 1.0, 1.0),
    ],
};
const ANGLE: Dimension = Dimension {
    word: "angle",
    base: "rad",
    units: &[
        ("rad", 1.0, 1.0),
        ("deg", std::f64::consts::PI, 180.0),
        ("mrad", 1.0, 1e3),
    ],
};
const SPEED: Dimension = Dimension {
    word: "speed",
    base: "mm/s",
    units: &[
        ("mm/s", 1.0, 1.0),
        ("m/s", 1e3, 1.0),
        ("um/s", 1.0, 1e3),
        ("m/min", 1e3, 60.0),
        ("km/h", 1e6, 3600.0),
    ],
};
const ANGULAR_SPEED: Dimension = Dimension {
    word: "angular speed",
    base: "rad/s",
    units: &[
        ("rad/s", 1.0, 1.0),
        ("rpm", std::f64::consts::PI, 30.0),
        ("1/min", std::f64::consts::PI, 30.0),
        ("deg/s", std::f64::consts::PI, 180.0),
    ],
};
const TIME: Dimension = Dimension {
    word: "time",
    base: "s",
    units: &[
        ("s", 1.0, 1.0),
        ("ms", 1.0, 1e3),
        ("min", 60.0, 1.0),
        ("h", 3600.0, 1.0),
    ],
};
const MOMENT: Dimension = Dimension {
    word: "moment",
    base: "N mm",
    units: &[
        ("N mm", 1.0, 1.0),
        ("N m", 1e3, 1.0),
        ("kN mm", 1e3, 1.0),
        ("kN m", 1e6, 1.0),
        ("Nmm", 1.0, 1.0),
        ("Nm", 1e3, 1.0),
    ],
};
const WEAR_FACTOR: Dimension = Dimension {
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
    fn expected(&self) -> String {
        let units: Vec<&str> = self
            .units
            .iter()
            .map(|unit| unit.0)
            .filter(|unit| unit.is_ascii())
            .collect();
        format!(
            "a {} as a number in {}, or a string with one of the units {}",
            self.word,
            self.base,
            units.join(", ")
        )
    }

    /// The value in the base unit, and whether a unit was written.
    fn parse(&self, text: &str) -> Result<(f64, bool), String> {
        let trimmed = text.trim();
        let end = number_end(trimmed);
        let number: f64 = trimmed[..end].parse().map_err(|_| {
            format!(
                "\"{text}\" is not a {}: no number at its beginning\nwrite {}",
                self.word,
                self.expected()
            )
        })?;
        let unit = normal(&trimmed[end..]);
        if unit.is_empty() {
            return Ok((number, false));
        }
        match self.units.iter().find(|known| normal(known.0) == unit) {
            Some((_, numerator, denominator)) => Ok((number * numerator / denominator, true)),
            None => {
                let unit = trimmed[end..].trim();
                Err(format!(
                    "wrong unit: `{unit}` does not measure a {}\nwrite {}",
                    self.word,
                    self.expected()
                ))
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
                next.is_ascii_digit()
                    || (matches!(next, b'+' | b'-')
                        && bytes.get(at + 2).is_some_and(u8::is_ascii_digit))
            });
        if exponent {
            at += 2;
        } else if bytes[at].is_ascii_digit()
            || bytes[at] == b'.'
            || (at == 0 && matches!(bytes[at], b'+' | b'-'))
        {
            at += 1;
        } else {
            break;
        }
    }
    at
}

struct QuantityVisitor(&'static Dimension);

impl Visitor<'_> for QuantityVisitor {
    type Value = (f64, bool);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.expected())
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<(f64, bool), E> {
        Ok((number as f64, false))
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<(f64, bool), E> {
        if number.is_finite() {
            return Ok((number, false));
        }
        Err(E::custom(format!(
            "{number} is not a {}\nwrite a finite number",
            self.0.word
        )))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<(f64, bool), E> {
        self.0
            .parse(text)
            .map_err(E::custom)
            .and_then(|(number, unit)| {
                if number.is_finite() {
                    return Ok((number, unit));
                }
                Err(E::custom(format!(
                    "\"{text}\" is too large for a number\nwrite a finite {}",
                    self.0.word
                )))
            })
    }
}

fn schema_of(dimension: &Dimension) -> Schema {
    json_schema!({
        "description": dimension.expected(),
        "anyOf": [{ "type": "number" }, { "type": "string", "pattern": "^\\s*[-+.0-9]" }]
    })
}

macro_rules! quantity {
    ($(#[$doc:meta])* $name:ident, $dimension:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
        pub(crate) struct $name(pub(crate) f64);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(QuantityVisitor(&$dimension)).map(|(number, _)| $name(number))
            }
        }

        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_f64(self.0)
            }
        }

        impl JsonSchema for $name {
            fn schema_name() -> Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                schema_of(&$dimension)
            }
        }
    };
}

quantity!(
    /// A length in mm.
    Length, LENGTH
);
quantity!(
    /// A force in N.
    Force, FORCE
);
quantity!(
    /// A pressure or modulus in MPa.
    Pressure, PRESSURE
);
quantity!(
    /// An angle in rad.
    Angle, ANGLE
);
quantity!(
    /// A speed in mm/s.
    Speed, SPEED
);
quantity!(
    /// An angular speed in rad/s.
    AngularSpeed, ANGULAR_SPEED
);
quantity!(
    /// A time in s.
    Time, TIME
);
quantity!(
    /// A moment in N mm.
    Moment, MOMENT
);

/// A wear factor. A bare number has the unit that the exponents a and b give it; a unit fixes a = b = 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct WearFactor {
    /// The number in N, mm, s.
    pub(crate) value: f64,
    /// Whether it was written with a unit of specific wear rate.
    pub(crate) has_unit: bool,
}

impl<'de> Deserialize<'de> for WearFactor {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (value, has_unit) = deserializer.deserialize_any(QuantityVisitor(&WEAR_FACTOR))?;
        Ok(WearFactor { value, has_unit })
    }
}

impl Serialize for WearFactor {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.value)
    }
}

impl JsonSchema for WearFactor {
    fn schema_name() -> Cow<'static, str> {
        "WearFactor".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        schema_of(&WEAR_FACTOR)
    }
}

/// One value, or one for each body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Pair<T> {
    /// One value; what it means for body 2 is said by the key.
    One(T),
    /// Body 1, body 2.
    Two([T; 2]),
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Pair<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PairVisitor<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for PairVisitor<T> {
            type Value = Pair<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("one value, or a list of two: [body 1, body 2]")
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Pair<T>, E> {
                T::deserialize(de::value::I64Deserializer::new(number)).map(Pair::One)
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Pair<T>, E> {
                T::deserialize(de::value::F64Deserializer::new(number)).map(Pair::One)
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Pair<T>, E> {
                T::deserialize(de::value::StrDeserializer::new(text)).map(Pair::One)
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, mut list: A) -> Result<Pair<T>, A::Error> {
                let first = list
                    .next_element()?
                    .ok_or_else(|| de::Error::invalid_length(0, &self))?;
                let second = list
                    .next_element()?
                    .ok_or_else(|| de::Error::invalid_length(1, &self))?;
                if list.next_element::<de::IgnoredAny>()?.is_some() {
                    return Err(de::Error::invalid_length(3, &self));
                }
                Ok(Pair::Two([first, second]))
            }
        }
        deserializer.deserialize_any(PairVisitor(std::marker::PhantomData))
    }
}

impl<T: Serialize> Serialize for Pair<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Pair::One(value) => value.serialize(serializer),
            Pair::Two(values) => values.serialize(serializer),
        }
    }
}

impl<T: JsonSchema> JsonSchema for Pair<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("PairOf{}", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<T>();
        json_schema!({ "anyOf": [one, { "type": "array", "items": one, "minItems": 2, "maxItems": 2 }] })
    }
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
        assert_eq!(
            ANGLE.parse("30 deg").map(|p| p.0),
            Ok(30.0 * std::f64::consts::PI / 180.0)
        );
        assert_eq!(MOMENT.parse("-5 kN*mm"), Ok((-5e3, true)));
        assert_eq!(
            WEAR_FACTOR.parse("1.33e-7 mm^3/(N m)"),
            Ok((1.33e-10, true))
        );
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
