//! Serde over the tree of a scene: an error knows the exact key or value that caused it.

use std::fmt::Display;

use serde::de::value::StrDeserializer;
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error as _, Expected, IntoDeserializer, MapAccess, SeqAccess, Unexpected,
    VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;

use crate::fault::did_you_mean;
use crate::tree::{Entry, Node, Origin, Value};

/// Why a tree is not a scene. Serde hands it up through one function a type, boxed so that each of them is small.
#[derive(Debug, Clone)]
pub(crate) struct Mismatch {
    /// Kind of error in one word.
    pub(crate) code: &'static str,
    /// What is wrong.
    pub(crate) message: String,
    /// What to write instead.
    pub(crate) remedy: String,
    /// Dotted key, built up from the inside.
    pub(crate) path: Vec<String>,
    /// The key or value to blame.
    pub(crate) origin: Option<Origin>,
}

impl Mismatch {
    fn new(code: &'static str, message: String, remedy: String) -> Box<Self> {
        Box::new(Mismatch { code, message, remedy, path: Vec::new(), origin: None })
    }

    fn at(mut self: Box<Self>, origin: &Origin) -> Box<Self> {
        self.origin.get_or_insert_with(|| origin.clone());
        self
    }

    fn under(mut self: Box<Self>, key: &str) -> Box<Self> {
        self.path.insert(0, key.to_string());
        self
    }

    /// Wrong is the key itself.
    fn in_key(self: Box<Self>, entry: &Entry) -> Box<Self> {
        self.at(&entry.origin).under(&entry.key)
    }

    /// Wrong is the value of a key. A missing key is blamed on the table's own key, a wrong value on the value.
    fn in_value(mut self: Box<Self>, entry: &Entry) -> Box<Self> {
        if self.code == "missing-key" && self.path.is_empty() {
            self.origin = Some(entry.origin.clone());
        }
        self.under(&entry.key)
    }
}

/// What to write, in words of a scene where serde has its own.
fn write(expected: &dyn Expected) -> String {
    let expected = expected.to_string();
    match expected.as_str() {
        "f64" => "write a number".to_string(),
        "usize" | "u64" => "write a whole number, 0 or more".to_string(),
        "a string" => "write text in double quotes".to_string(),
        "a map" => "write a table, as in { name = ... }".to_string(),
        "a sequence" => "write a list, as in [...]".to_string(),
        _ => match (expected.strip_prefix("an array of length "), expected.strip_prefix("struct ")) {
            (Some(length), _) => format!("write a list of {length}"),
            (_, Some(table)) => format!("write a table, as in {}", table_like(table)),
            _ => format!("write {expected}"),
        },
    }
}

/// A table of the kind that serde knows by the name of its type.
fn table_like(table: &str) -> &'static str {
    match table {
        "Body" => "{ material = { ... }, geometry = { ... }, support = { ... } }",
        "Contact" => "{ edges = [\"bottom\", \"top\"], friction = 0.25 }",
        "Load" => "{ edge = \"top\", as = \"pressure\", force = \"10 kN\" }",
        "Sliding" => "{ speed = \"5 mm/s\" }",
        "Wear" => "{ beta = [2e-4, 0], a = 1, b = 1 }",
        "Schedule" => "{ time = [0, 10], force = [1, 2] }",
        "Spin" => "{ omega = \"3000 rpm\" }",
        "FieldPath" => "{ name = \"bore\", body = 2, from = [100, 0], to = [200, 0] }",
        "Heat" => "{ share = 0.1, reference = \"20 degC\" }",
        "EdgeHeat" => "{ convection = \"100 W/(m2 K)\", ambient = \"20 degC\" }",
        "Optimum" => "{ functional = \"steady\" }",
        "Mesh" => "{ degree = 8, layers = 8 }",
        "Output" => "{ fields = true }",
        "MeshFile" => "{ file = \"body.msh\" }",
        "Rectangle" => "{ x = [-30, 30], z = [0, 100] }",
        "Ring" => "{ inner = 100, outer = 200 }",
        "RingSegment" => "{ inner = 200, outer = 220, x = [-100, 100] }",
        "ShoeBlock" => "{ radius = 200, half_angle = \"30 deg\", top = 300 }",
        "HalfDisc" => "{ radius = 50, centre = [0, 50] }",
        _ => "{ key = value }",
    }
}

/// The number that a text with a decimal comma means, as "0.25" of "0,25", with what follows it.
pub(crate) fn decimal_comma(text: &str) -> Option<String> {
    let (whole, rest) = text.trim().split_once(',')?;
    let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let number = !whole.is_empty() && whole.trim_start_matches(['+', '-']).bytes().all(|b| b.is_ascii_digit());
    (number && digits > 0 && !rest.contains([',', '.'])).then(|| format!("{whole}.{rest}"))
}

impl Display for Mismatch {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Mismatch {}

impl serde::de::Error for Box<Mismatch> {
    /// A message of two lines is the message and the remedy.
    fn custom<T: Display>(text: T) -> Self {
        let text = text.to_string();
        let (message, remedy) = text.split_once('\n').unwrap_or((&text, ""));
        Mismatch::new("wrong-value", message.to_string(), remedy.to_string())
    }

    fn invalid_type(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        let meant = if let Unexpected::Str(text) = found { decimal_comma(text) } else { None };
        let remedy = meant.map_or_else(|| write(expected), |meant| format!("write a decimal point, not a comma: {meant}"));
        Mismatch::new("wrong-type", format!("wrong type: found {found}"), remedy)
    }

    fn invalid_value(found: Unexpected<'_>, expected: &dyn Expected) -> Self {
        Mismatch::new("wrong-value", format!("wrong value: found {found}"), write(expected))
    }

    fn invalid_length(length: usize, expected: &dyn Expected) -> Self {
        Mismatch::new("wrong-type", format!("wrong number of entries: found {length}"), write(expected))
    }

    fn unknown_variant(variant: &str, expected: &'static [&'static str]) -> Self {
        Mismatch::new("unknown-word", format!("unknown word `{variant}`"), did_you_mean(variant, expected))
    }

    fn unknown_field(field: &str, expected: &'static [&'static str]) -> Self {
        Mismatch::new("unknown-key", format!("unknown key `{field}`"), did_you_mean(field, expected))
    }

    fn missing_field(field: &'static str) -> Self {
        Mismatch::new("missing-key", format!("the key `{field}` is missing"), format!("add `{field} = ...`"))
    }
}

impl<'de> Deserializer<'de> for &'de Node {
    type Error = Box<Mismatch>;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Mismatch>> {
        match &self.value {
            Value::Bool(flag) => visitor.visit_bool(*flag),
            Value::Integer(number) => visitor.visit_i64(*number),
            Value::Float(number) => visitor.visit_f64(*number),
            Value::Text(text) => visitor.visit_borrowed_str(text),
            Value::List(items) => whole_list(items, visitor),
            Value::Table(entries) => visitor.visit_map(TableReader { entries, next: 0 }),
        }
        .map_err(|error| error.at(&self.origin))
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Mismatch>> {
        match &self.value {
            Value::List(items) => whole_list(items, visitor).map_err(|error| error.at(&self.origin)),
            _ => Err(self.is_not(&visitor)),
        }
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, _len: usize, visitor: V) -> Result<V::Value, Box<Mismatch>> {
        self.deserialize_seq(visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Mismatch>> {
        match &self.value {
            Value::Table(entries) => visitor.visit_map(TableReader { entries, next: 0 }).map_err(|error| error.at(&self.origin)),
            _ => Err(self.is_not(&visitor)),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Box<Mismatch>> {
        visitor.visit_some(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Box<Mismatch>> {
        // Not as a list too, whose entries serde would take for the keys in their order.
        self.deserialize_map(visitor)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _name: &'static str, visitor: V) -> Result<V::Value, Box<Mismatch>> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        words: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Box<Mismatch>> {
        if let Value::Text(text) = &self.value {
            let word: StrDeserializer<'_, Box<Mismatch>> = text.as_str().into_deserializer();
            return visitor.visit_enum(word).map_err(|error| error.at(&self.origin));
        }
        let entry = self.alternative(words)?;
        visitor.visit_enum(VariantReader { entry })
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf
        unit unit_struct tuple_struct identifier ignored_any
    }
}

impl Node {
    /// The one key of a table that says which of some alternatives holds.
    fn alternative(&self, words: &[&str]) -> Result<&Entry, Box<Mismatch>> {
        let Value::Table(entries) = &self.value else {
            let message = "wrong type: a word is wanted here".to_string();
            return Err(Mismatch::new("wrong-type", message, format!("one of: {}", words.join(", "))).at(&self.origin));
        };
        match entries.as_slice() {
            [entry] => Ok(entry),
            [] => {
                let error = Mismatch::new("missing-key", "an empty table".into(), format!("one of: {}", words.join(", ")));
                Err(error.at(&self.origin))
            }
            [first, second, ..] => {
                let message = format!("both `{}` and `{}` are given, of which only one can hold", first.key, second.key);
                let error = Mismatch::new("two-alternatives", message, format!("keep one of: {}", words.join(", ")));
                Err(error.at(&second.origin))
            }
        }
    }

    /// It is of another type than is wanted.
    fn is_not(&self, wanted: &dyn Expected) -> Box<Mismatch> {
        let found = match &self.value {
            Value::Bool(flag) => Unexpected::Bool(*flag),
            Value::Integer(number) => Unexpected::Signed(*number),
            Value::Float(number) => Unexpected::Float(*number),
            Value::Text(text) => Unexpected::Str(text),
            Value::List(_) => Unexpected::Seq,
            Value::Table(_) => Unexpected::Map,
        };
        Box::<Mismatch>::invalid_type(found, wanted).at(&self.origin)
    }
}

/// Reads a list to its end: a type of fixed length would leave out what comes after.
fn whole_list<'de, V: Visitor<'de>>(items: &'de [Node], visitor: V) -> Result<V::Value, Box<Mismatch>> {
    let mut list = ListReader { items, next: 0 };
    let read = visitor.visit_seq(&mut list)?;
    if list.next < items.len() { Err(too_many(items.len(), list.next)) } else { Ok(read) }
}

fn too_many(found: usize, wanted: usize) -> Box<Mismatch> {
    let message = format!("wrong number of entries: found {found}");
    Mismatch::new("wrong-type", message, format!("write a list of {wanted}"))
}

struct ListReader<'de> {
    items: &'de [Node],
    next: usize,
}

impl<'de> SeqAccess<'de> for ListReader<'de> {
    type Error = Box<Mismatch>;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Box<Mismatch>> {
        let Some(node) = self.items.get(self.next) else {
            return Ok(None);
        };
        self.next += 1;
        seed.deserialize(node).map(Some).map_err(|error| error.under(&(self.next - 1).to_string()))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.items.len() - self.next)
    }
}

struct TableReader<'de> {
    entries: &'de [Entry],
    next: usize,
}

impl<'de> MapAccess<'de> for TableReader<'de> {
    type Error = Box<Mismatch>;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Box<Mismatch>> {
        let Some(entry) = self.entries.get(self.next) else {
            return Ok(None);
        };
        let key: StrDeserializer<'_, Box<Mismatch>> = entry.key.as_str().into_deserializer();
        seed.deserialize(key).map(Some).map_err(|error| error.in_key(entry))
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Box<Mismatch>> {
        let Some(entry) = self.entries.get(self.next) else {
            return Err(Box::<Mismatch>::custom("a value was read twice"));
        };
        self.next += 1;
        seed.deserialize(&entry.node).map_err(|error| error.in_value(entry))
    }
}

struct VariantReader<'de> {
    entry: &'de Entry,
}

impl<'de> EnumAccess<'de> for VariantReader<'de> {
    type Error = Box<Mismatch>;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), Box<Mismatch>> {
        let key: StrDeserializer<'_, Box<Mismatch>> = self.entry.key.as_str().into_deserializer();
        let variant = seed.deserialize(key).map_err(|error| error.in_key(self.entry))?;
        Ok((variant, self))
    }
}

impl<'de> VariantAccess<'de> for VariantReader<'de> {
    type Error = Box<Mismatch>;

    fn unit_variant(self) -> Result<(), Box<Mismatch>> {
        let message = format!("`{}` takes no keys of its own", self.entry.key);
        Err(Mismatch::new("wrong-type", message, format!("write \"{}\"", self.entry.key)).at(&self.entry.origin))
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Box<Mismatch>> {
        seed.deserialize(&self.entry.node).map_err(|error| error.in_value(self.entry))
    }

    fn tuple_variant<V: Visitor<'de>>(self, _len: usize, visitor: V) -> Result<V::Value, Box<Mismatch>> {
        self.entry.node.deserialize_seq(visitor).map_err(|error| error.under(&self.entry.key))
    }

    fn struct_variant<V: Visitor<'de>>(self, _fields: &'static [&'static str], visitor: V) -> Result<V::Value, Box<Mismatch>> {
        self.entry.node.deserialize_map(visitor).map_err(|error| error.under(&self.entry.key))
    }
}
