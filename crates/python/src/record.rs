//! Tables as numpy's records: the columns of a profile or of a run in time, row by row in one piece of memory.

use report::CONTACT_COLUMNS;
use wearshape::Profile;

/// The type of an `f64` in numpy's words.
pub(crate) const F64: &str = if cfg!(target_endian = "little") { "<f8" } else { ">f8" };
/// Characters of the longest status; a text of numpy holds four bytes a character.
const STATUS: usize = 8;

/// Rows of records.
pub(crate) struct Records {
    /// The memory, in words of 8 bytes.
    pub(crate) words: Vec<u64>,
    /// Name and type of each field.
    pub(crate) fields: Vec<(String, String)>,
    /// Bytes of a row.
    pub(crate) size: usize,
    /// Rows.
    pub(crate) count: usize,
}

impl Records {
    /// The columns of contact.csv: numbers, then the status as a text.
    pub(crate) fn of_profile(profile: &Profile) -> Records {
        let back: &[report::ContactColumn] = &[("pressure_back_MPa", |p, k| p.pressure_back[k])];
        let back = if profile.pressure_back.is_empty() { &[] } else { back };
        let columns: Vec<_> = CONTACT_COLUMNS.iter().chain(back).collect();
        let mut fields: Vec<(String, String)> = columns.iter().map(|(name, _)| (name.to_string(), F64.into())).collect();
        let order = if cfg!(target_endian = "little") { '<' } else { '>' };
        fields.push(("status".into(), format!("{order}U{STATUS}")));
        let count = profile.s.len();
        let words_of_row = columns.len() + STATUS / 2;
        let mut words = Vec::with_capacity(count * words_of_row);
        for row in 0..count {
            words.extend(columns.iter().map(|(_, value)| value(profile, row).to_bits()));
            words.extend(text_words(profile.status[row].word()));
        }
        Records { words, fields, size: words_of_row * size_of::<u64>(), count }
    }

    /// Named columns of numbers, as many rows as the shortest has.
    pub(crate) fn of_columns(columns: &[(String, Vec<f64>)]) -> Records {
        let fields = columns.iter().map(|(name, _)| (name.clone(), F64.into())).collect();
        let count = columns.iter().map(|(_, values)| values.len()).min().unwrap_or(0);
        let words = (0..count).flat_map(|row| columns.iter().map(move |(_, values)| values[row].to_bits())).collect();
        Records { words, fields, size: columns.len() * size_of::<u64>(), count }
    }
}

/// A text of numpy: its characters, then zeros, two a word.
fn text_words(text: &str) -> [u64; STATUS / 2] {
    let mut words = [0; STATUS / 2];
    for (place, character) in text.chars().take(STATUS).enumerate() {
        let first = (place % 2 == 0) == cfg!(target_endian = "little");
        words[place / 2] |= u64::from(u32::from(character)) << if first { 0 } else { 32 };
    }
    words
}
