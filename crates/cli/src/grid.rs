//! The points of a sweep: all combinations of the values of some keys.

use scene::{Fault, Place};
use serde_json::{Map, Value, json};

/// More points than this are a slip of the keyboard.
const MOST: usize = 10_000_000;

/// One key with its values as text.
#[derive(Debug, Clone, PartialEq)]
struct Over {
    /// Dotted key.
    key: String,
    /// Right-hand sides of `--set`.
    values: Vec<String>,
}

/// A grid of keys. The last key turns fastest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Grid {
    keys: Vec<Over>,
    /// Number of points.
    pub(crate) count: usize,
}

impl Grid {
    /// The grid of some `--over` options.
    pub(crate) fn read(over: &[String]) -> Result<Grid, Fault> {
        let keys = over.iter().map(|over| read_over(over)).collect::<Result<Vec<Over>, Fault>>()?;
        let count = keys.iter().map(|over| over.values.len()).try_fold(1usize, |n, m| n.checked_mul(m));
        let Some(count) = count.filter(|count| *count <= MOST) else {
            return Err(Fault::new("wrong-flag", "the grid has more than ten million points", "give fewer values"));
        };
        Ok(Grid { keys, count })
    }

    /// Keys and values at a point.
    pub(crate) fn at(&self, mut point: usize) -> Vec<(&str, &str)> {
        let mut values = vec![("", ""); self.keys.len()];
        for (place, over) in self.keys.iter().enumerate().rev() {
            values[place] = (&over.key, &over.values[point % over.values.len()]);
            point /= over.values.len();
        }
        values
    }

    /// The `--set` options of a point: those given, then its own.
    pub(crate) fn settings(&self, point: usize, set: &[String]) -> Vec<String> {
        set.iter().cloned().chain(self.at(point).into_iter().map(|(key, value)| format!("{key}={value}"))).collect()
    }

    /// Keys with all their values.
    pub(crate) fn document(&self) -> Value {
        self.keys.iter().map(|over| (over.key.clone(), json!(over.values))).collect::<Map<_, _>>().into()
    }
}

/// `key=from:to:count` or `key=a,b,c`; commas inside brackets and quotes do not separate.
fn read_over(text: &str) -> Result<Over, Fault> {
    let wrong = |message: String| Fault {
        place: Some(Place::Flag(format!("--over {text}"))),
        ..Fault::new("wrong-flag", message, "write --over optimum.q=0.5:3:20 or --over contact.friction=0,.1,.25")
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
        if count == 0 || !from.is_finite() || !to.is_finite() {
            return Err(wrong(format!("`{values}` has no values")));
        }
        let last = (count - 1).max(1) as f64;
        let value = |i: usize| {
            let t = i as f64 / last;
            if i + 1 == count && count > 1 { to } else { from + (to - from) * t }
        };
        return Ok(Over { key, values: (0..count).map(|i| scene::number_text(value(i))).collect() });
    }
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
    let values: Vec<String> = list.iter().map(|value| value.trim().to_string()).collect();
    if values.iter().any(String::is_empty) {
        return Err(wrong(format!("--over {text} has an empty value")));
    }
    Ok(Over { key, values })
}
