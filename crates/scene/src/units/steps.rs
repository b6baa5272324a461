//! One value, or a list of values taken one after the other.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::{Serialize, Serializer};

/// Values in their order; a single one may be written without a list.
#[derive(Debug, Clone, PartialEq)]
pub struct Steps<T>(pub Vec<T>);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Steps<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct StepsVisitor<T>(std::marker::PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for StepsVisitor<T> {
            type Value = Steps<T>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("one value, or a list of values in the order in which they are taken")
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Steps<T>, E> {
                T::deserialize(de::value::I64Deserializer::new(number)).map(|value| Steps(vec![value]))
            }

            fn visit_f64<E: de::Error>(self, number: f64) -> Result<Steps<T>, E> {
                T::deserialize(de::value::F64Deserializer::new(number)).map(|value| Steps(vec![value]))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Steps<T>, E> {
                T::deserialize(de::value::StrDeserializer::new(text)).map(|value| Steps(vec![value]))
            }

            fn visit_seq<A: de::SeqAccess<'de>>(self, mut list: A) -> Result<Steps<T>, A::Error> {
                let mut values = Vec::new();
                while let Some(value) = list.next_element()? {
                    values.push(value);
                }
                if values.is_empty() {
                    return Err(de::Error::invalid_length(0, &self));
                }
                Ok(Steps(values))
            }
        }
        deserializer.deserialize_any(StepsVisitor(std::marker::PhantomData))
    }
}

impl<T: Serialize> Serialize for Steps<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0.as_slice() {
            [one] => one.serialize(serializer),
            many => many.serialize(serializer),
        }
    }
}
