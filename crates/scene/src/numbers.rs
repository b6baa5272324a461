//! Numbers as text: short ones for sentences, exact ones for files.

/// A number with about six significant digits and no needless zeros.
pub fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return format!("{value}");
    }
    let magnitude = value.abs().log10().floor() as i32;
    if !(-4..7).contains(&magnitude) {
        let text = format!("{value:.4e}");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    trimmed(&format!("{value:.*}", (5 - magnitude).max(0) as usize)).to_string()
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A number in its shortest form that reads back to the same bits; `nan` where there is none.
pub fn number_text(number: f64) -> String {
    if number.is_nan() {
        return "nan".into();
    }
    if number == 0.0 {
        return "0".into();
    }
    let plain = format!("{number}");
    // The other form is never shorter by more than two here.
    if (1e-4..1e4).contains(&number.abs()) {
        return plain;
    }
    let scientific = format!("{number:e}");
    if plain.len() <= scientific.len() + 2 { plain } else { scientific }
}

/// Most characters of a number that a sentence keeps as they are.
const LONGEST: usize = 15;

/// The text with numbers of more characters rounded to six digits; names, paths and what stands in backticks are left alone.
pub fn with_short_numbers(text: &str) -> String {
    let part_of_number = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
    let part_of_name = |c: char| c.is_alphanumeric() || "_/`\"'".contains(c);
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    let mut quoted = false;
    while let Some(first) = rest.chars().next() {
        let length = rest.find(|c| !part_of_number(c)).unwrap_or(rest.len());
        if length == 0 {
            quoted ^= first == '`';
            out.push(first);
            rest = &rest[first.len_utf8()..];
            continue;
        }
        let (word, after) = rest.split_at(length);
        let number = word.trim_end_matches('.');
        let bounded = !quoted && !out.ends_with(part_of_name) && !after.starts_with(part_of_name);
        match number.parse::<f64>() {
            Ok(value) if bounded && number.len() > LONGEST => out += &format!("{}{}", short(value), &word[number.len()..]),
            _ => out += word,
        }
        rest = after;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{number_text, with_short_numbers};

    #[test]
    fn a_number_is_plain_unless_that_is_longer_by_more_than_two() {
        let digits = [1.0, -1.5, 9.999999999999998, 1.0 / 3.0, std::f64::consts::PI];
        for number in (-8..10).flat_map(|power| digits.map(|digit| digit * 10f64.powi(power))).chain([1e-4, 1e4]) {
            let (plain, scientific) = (format!("{number}"), format!("{number:e}"));
            let expected = if plain.len() <= scientific.len() + 2 { plain } else { scientific };
            assert_eq!(number_text(number), expected);
        }
        assert_eq!([1e-5, 1e5].map(number_text), ["1e-5", "1e5"]);
    }

    #[test]
    fn long_numbers_are_rounded_and_names_and_quotes_are_not() {
        let long = format!("x = {}, z = {}.", 1e-200, -100.0 * 3f64.sqrt());
        assert_eq!(with_short_numbers(&long), "x = 1e-200, z = -173.205.");
        assert_eq!(with_short_numbers(&format!("[{}, 2.5] mm", 1e200)), "[1e200, 2.5] mm");
        for kept in [
            "run-2024.0101.123456789012345/a.toml",
            "`load.force = 0.00000000000000000001`",
            "12 of 100000000000000",
            "ends. Two",
        ] {
            assert_eq!(with_short_numbers(kept), kept);
        }
    }
}
