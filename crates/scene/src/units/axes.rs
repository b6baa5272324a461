//! One value for all directions, or one for each axis of a material.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::{Serialize, Serializer};

/// One value, or three: of the axes 1, 2 and 3, or of the pairs 12, 13 and 23 of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axes<T> {
    /// All directions are alike.
    One(T),
    /// Axes 1, 2 and 3, or their pairs 12, 13 and 23.
    Three([T; 3]),
}

impl<T: Copy> Axes<T> {
    /// The three values.
    pub fn each(self) -> [T; 3] {
        match self {
            Axes::One(value) => [value; 3],
            Axes::Three(values) => values,
        }
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Axes<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct AxesVisitor<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for AxesVisitor<T> {
            type Value = Axes<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("one value, or a list of three by the axes of the material")
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Axes<T>, E> {
                T::deserialize(de::value::I64Deserializer::new(number)).map(Axes::One)
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Axes<T>, E> {
                T::deserialize(de::value::F64Deserializer::new(number)).map(Axes::One)
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Axes<T>, E> {
                T::deserialize(de::value::StrDeserializer::new(text)).map(Axes::One)
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, mut list: A) -> Result<Axes<T>, A::Error> {
                let mut values = Vec::new();
                while let Some(value) = list.next_element()? {
                    values.push(value);
                }
                let given = values.len();
                <[T; 3]>::try_from(values).map(Axes::Three).map_err(|_| de::Error::invalid_length(given, &self))
            }
        }
        deserializer.deserialize_any(AxesVisitor(std::marker::PhantomData))
    }
}

impl<T: Serialize> Serialize for Axes<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Axes::One(value) => value.serialize(serializer),
            Axes::Three(values) => values.serialize(serializer),
        }
    }
}
