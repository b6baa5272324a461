//! The points of a sweep: all combinations of the values of some keys.

use std::borrow::Cow;

use scene::{Fault, Place};
use serde_json::{Map, Value, json};

/// More points than this are a slip of the keyboard.
const MOST: usize = 10_000_000;
/// Ranges with more values than this are told by their ends.
const MOST_TOLD: usize = 1000;

/// One key with its values as text: right-hand sides of `--set`.
#[derive(Debug, Clone, PartialEq)]
struct Over {
    /// Dotted key.
    key: String,
    values: Values,
}

#[derive(Debug, Clone, PartialEq)]
enum Values {
    /// As they were typed.
    List(Vec<String>),
    /// Evenly spaced, both ends included.
    Range { from: f64, to: f64, count: usize },
}

impl Values {
    fn count(&self) -> usize {
        match self {
            Values::List(values) => values.len(),
            Values::Range { count, .. } => *count,
        }
    }

    fn at(&self, place: usize) -> Cow<'_, str> {
        match self {
            Values::List(values) => Cow::Borrowed(values.get(place).map_or("", String::as_str)),
            Values::Range { from, to, count } => {
                let t = place as f64 / (count - 1).max(1) as f64;
                let value = if place + 1 == *count && *count > 1 { *to } else { from + (to - from) * t };
                Cow::Owned(scene::number_text(value))
            }
        }
    }
}

/// A grid of keys. The last key turns fastest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Grid {
    keys: Vec<Over>,
    /// Number of points.
    pub(crate) count: usize,
}

/// Two keys of which one is the other, or a part of it.
fn overlapping(keys: &[Over]) -> Option<(&str, &str)> {
    let within = |part: &str, whole: &str| part.strip_prefix(whole).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
    keys.iter().enumerate().find_map(|(i, one)| {
        let mut before = keys[..i].iter();
        before
            .find(|other| within(&one.key, &other.key) || within(&other.key, &one.key))
            .map(|other| (other.key.as_str(), one.key.as_str()))
    })
}

impl Grid {
    /// The grid of some `--over` options; its points are counted before any of them is made.
    pub(crate) fn read(over: &[String]) -> Result<Grid, Fault> {
        let keys = over.iter().map(|over| read_over(over)).collect::<Result<Vec<Over>, Fault>>()?;
        if let Some((one, other)) = overlapping(&keys) {
            let message = match one == other {
                true => format!("--over gives `{one}` twice: no point of the grid has both values"),
                false => format!("--over gives `{one}` and `{other}`, which replace each other"),
            };
            let place = Some(Place::Flag(format!("--over {}", over.join(" --over "))));
            return Err(Fault { place, ..Fault::new("wrong-flag", message, "give each key once, with all its values") });
        }
        let count = keys.iter().map(|over| over.values.count()).try_fold(1usize, |n, m| n.checked_mul(m));
        let Some(count) = count.filter(|count| *count <= MOST) else {
            let place = Some(Place::Flag(format!("--over {}", over.join(" --over "))));
            return Err(Fault {
                place,
                ..Fault::new("wrong-flag", "the grid has more than ten million points", "give fewer values")
            });
        };
        Ok(Grid { keys, count })
    }

    /// The keys.
    pub(crate) fn keys(&self) -> Vec<&str> {
        self.keys.iter().map(|over| over.key.as_str()).collect()
    }

    /// Keys and values at a point.
    pub(crate) fn at(&self, mut point: usize) -> Vec<(&str, Cow<'_, str>)> {
        let mut values: Vec<(&str, Cow<'_, str>)> = Vec::with_capacity(self.keys.len());
        for over in self.keys.iter().rev() {
            values.push((&over.key, over.values.at(point % over.values.count())));
            point /= over.values.count();
        }
        values.reverse();
        values
    }

    /// The values at a point for people: as they were typed, those of a range in few digits.
    pub(crate) fn label(&self, point: usize) -> Vec<String> {
        let told = |(over, (_, value)): (&Over, (&str, Cow<'_, str>))| match &over.values {
            Values::List(_) => value.into_owned(),
            Values::Range { .. } => value.parse().map_or_else(|_| value.to_string(), scene::short),
        };
        self.keys.iter().zip(self.at(point)).map(told).collect()
    }

    /// The `--set` options of a point: those given, then its own.
    pub(crate) fn settings(&self, point: usize, set: &[String]) -> Vec<String> {
        set.iter().cloned().chain(self.at(point).into_iter().map(|(key, value)| format!("{key}={value}"))).collect()
    }

    /// Keys with the values that are no bare numbers, and so may have a unit.
    pub(crate) fn words(&self) -> impl Iterator<Item = (&str, &str)> {
        let lists = self.keys.iter().filter_map(|over| match &over.values {
            Values::List(values) => Some(values.iter().map(|value| (over.key.as_str(), value.as_str()))),
            Values::Range { .. } => None,
        });
        lists.flatten().filter(|(_, value)| value.parse::<f64>().is_err())
    }

    /// Keys with all their values, or with the ends and the count of a long range.
    pub(crate) fn document(&self) -> Value {
        let values = |values: &Values| match values {
            Values::Range { from, to, count } if *count > MOST_TOLD => json!({ "from": from, "to": to, "count": count }),
            values => (0..values.count()).map(|place| values.at(place)).collect(),
        };
        self.keys.iter().map(|over| (over.key.clone(), values(&over.values))).collect::<Map<_, _>>().into()
    }
}

/// `key=from:to:count`, the ends with units or without, or `key=a,b,c`; commas inside brackets and quotes do not separate.
fn read_over(text: &str) -> Result<Over, Fault> {
    let wrong = |message: String| Fault {
        place: Some(Place::Flag(format!("--over {text}"))),
        ..Fault::new(
            "wrong-flag",
            message,
            "write --over optimum.q=0.5:3:20, --over contact.friction=0,.1,.25 or --over load.force=\"1 kN:10 kN:4\"",
        )
    };
    let Some((key, values)) = text.split_once('=') else {
        return Err(wrong(format!("--over {text} has no `=`")));
    };
    let key = key.trim().to_string();
    if key.is_empty() {
        return Err(wrong(format!("--over {text} has no key")));
    }
    let parts: Vec<&str> = values.split(':').collect();
    if let [from, to, count] = parts[..]
        && let (Ok(from), Ok(to)) = (from.trim().parse::<f64>(), to.trim().parse::<f64>())
    {
        let count: usize = count.trim().parse().map_err(|_| wrong(format!("`{count}` is no number of values")))?;
        if !from.is_finite() || !to.is_finite() {
            return Err(wrong(format!("`{values}` has an end that is not finite")));
        }
        if count == 0 {
            return Err(wrong(format!("`{values}` has no values")));
        }
        return Ok(Over { key, values: Values::Range { from, to, count } });
    }
    if let Some(values) = range_with_unit(values).map_err(&wrong)? {
        return Ok(Over { key, values: Values::List(values) });
    }
    let values: Vec<String> = list(values);
    if values.iter().any(String::is_empty) {
        return Err(wrong(format!("--over {text} has an empty value")));
    }
    Ok(Over { key, values: Values::List(values) })
}

/// Evenly spaced values with a unit, as in `1 kN:10 kN:4` or `1:10 kN:4`; none where that is not what is written.
fn range_with_unit(values: &str) -> Result<Option<Vec<String>>, String> {
    let parts: Vec<&str> = values.split(':').map(|part| part.trim().trim_matches(['"', '\''])).collect();
    let [from, to, count] = parts[..] else {
        return Ok(None);
    };
    let (Some((from, first)), Some((to, unit))) = (number_and_unit(from), number_and_unit(to)) else {
        return Ok(None);
    };
    if !(first == unit || first.is_empty()) {
        return Err(format!("a range from {first} to {unit} has two units"));
    }
    let count: usize = count.parse().map_err(|_| format!("`{count}` is no number of values"))?;
    if count == 0 || count > MOST_TOLD {
        return Err(format!("a range with a unit has 1 to {MOST_TOLD} values; longer ones are written in base units"));
    }
    let range = Values::Range { from, to, count };
    Ok(Some((0..count).map(|place| format!("{} {unit}", range.at(place))).collect()))
}

/// A number and the unit behind it, which may be empty.
fn number_and_unit(text: &str) -> Option<(f64, &str)> {
    // The unit begins at the first letter that is no exponent.
    let end = text
        .char_indices()
        .find(|(place, c)| {
            c.is_alphabetic()
                && !(matches!(c, 'e' | 'E') && text[place + 1..].starts_with(|c: char| c.is_ascii_digit() || "+-".contains(c)))
        })
        .map_or(text.len(), |(place, _)| place);
    let (number, unit) = text.split_at(end);
    Some((number.trim().parse().ok().filter(|number: &f64| number.is_finite())?, unit.trim()))
}

/// The texts in a value as it was typed: all of it, or the words of its list or table, in quotes or bare.
pub(crate) fn texts(value: &str) -> Vec<String> {
    if !value.starts_with(['[', '{', '"', '\'']) {
        return vec![value.to_string()];
    }
    let (mut words, mut quote) = (vec![String::new()], None);
    for c in value.chars() {
        let ends = match quote {
            Some(open) => c == open,
            None => "[]{},=\"'".contains(c),
        };
        if ends {
            quote = Some(c).filter(|c| quote.is_none() && "\"'".contains(*c));
            words.push(String::new());
        } else if let Some(last) = words.last_mut() {
            last.push(c);
        }
    }
    words.into_iter().map(|word| word.trim().to_string()).filter(|word| !word.is_empty()).collect()
}

/// The parts of a list; commas inside brackets and quotes do not separate.
fn list(values: &str) -> Vec<String> {
    let mut list = vec![String::new()];
    let (mut depth, mut quote) = (0i32, None);
    for c in values.chars() {
        match (c, quote) {
            ('"' | '\'', None) => quote = Some(c),
            (c, Some(q)) if c == q => quote = None,
            ('[' | '{', None) => depth += 1,
            (']' | '}', None) => depth -= 1,
            (',', None) if depth == 0 => {
                list.push(String::new());
                continue;
            }
            _ => {}
        }
        if let Some(last) = list.last_mut() {
            last.push(c);
        }
    }
    list.iter().map(|value| value.trim().to_string()).collect()
}
