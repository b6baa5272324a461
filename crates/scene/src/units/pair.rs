//! One value for both bodies, or one for each.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::{Serialize, Serializer};

/// One value, or one for each body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pair<T> {
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
                let first = list.next_element()?.ok_or_else(|| de::Error::invalid_length(0, &self))?;
                let second = list.next_element()?.ok_or_else(|| de::Error::invalid_length(1, &self))?;
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
