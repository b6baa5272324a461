//! Mutations that know words, numbers and lines, so that what comes of a sound text gets past its parser.

use std::ops::Range;

use crate::random::Random;

/// What a number may become instead.
const NUMBERS: [&str; 16] = [
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "0.5",
    "1e308",
    "-1e308",
    "1e-320",
    "nan",
    "inf",
    "-inf",
    "18446744073709551616",
    "9223372036854775807",
    "1e9",
    "0.9999999999999999",
];
/// What a word may become instead.
const WORDS: [&str; 8] = ["", "\"\"", "true", "[]", "{}", "\u{1b}[31m", "\u{0}", "\u{fffd}\u{202e}"];
/// An input grows no longer than this.
const LONGEST: usize = 200_000;

/// An input of the corpus, changed in one to six places, with pieces of the others.
pub(crate) fn mutated(corpus: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut input = random.one_of(corpus).clone();
    for _ in 0..=random.below(6) {
        let other = random.one_of(corpus);
        change(&mut input, other, random);
    }
    input.truncate(LONGEST);
    input
}

fn change(input: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    match random.below(20) {
        0..=6 => replace(input, is_number, random, |random, old| number(old, random)),
        7..=9 => exchange(input, random),
        10..=12 => borrow(input, other, random),
        13 => replace(input, |_| true, random, |random, _| random.one_of(&WORDS).as_bytes().to_vec()),
        14 => lines(input, random, |_, _| Vec::new()),
        15 => lines(input, random, |_, line| [line, line].concat()),
        16 => {
            let from = pieces(other, |byte| byte != b'\n');
            lines(input, random, |random, line| {
                let new = from.get(random.below(from.len())).map_or(&[][..], |at| &other[at.clone()]);
                [line, new, b"\n"].concat()
            });
        }
        17 => input.truncate(random.below(input.len())),
        18 => {
            let at = random.below(input.len());
            if let Some(byte) = input.get_mut(at) {
                *byte ^= 1 << random.below(8);
            }
        }
        _ => {
            let from = random.below(other.len());
            let length = random.below(64).min(other.len() - from);
            let at = random.below(input.len());
            input.splice(at..at, other[from..from + length].iter().copied());
        }
    }
}

/// Runs of bytes of one kind.
fn pieces(text: &[u8], of: impl Fn(u8) -> bool) -> Vec<Range<usize>> {
    let (mut found, mut start) = (Vec::new(), None);
    for (at, byte) in text.iter().enumerate() {
        match (of(*byte), start) {
            (true, None) => start = Some(at),
            (false, Some(from)) => {
                found.push(from..at);
                start = None;
            }
            _ => {}
        }
    }
    found.extend(start.map(|from| from..text.len()));
    found
}

/// Words, keys and numbers.
fn words(text: &[u8]) -> Vec<Range<usize>> {
    pieces(text, |byte| byte.is_ascii_alphanumeric() || b"_.+-".contains(&byte))
}

fn is_number(word: &[u8]) -> bool {
    word.iter().any(u8::is_ascii_digit) && word.iter().all(|byte| b"0123456789.+-eE_".contains(byte))
}

/// A number scaled, or another one.
fn number(old: &[u8], random: &mut Random) -> Vec<u8> {
    let value = std::str::from_utf8(old).ok().and_then(|text| text.parse::<f64>().ok());
    let Some(value) = value.filter(|_| random.below(3) > 0) else { return random.one_of(&NUMBERS).as_bytes().to_vec() };
    let exponent = random.below(19) as i32 - 9;
    match (random.below(3), old.contains(&b'.') || old.contains(&b'e')) {
        (0, _) => format!("{}", -value),
        // A whole number nearby: an index, a count.
        (1, false) => format!("{}", value + exponent as f64),
        (_, false) if exponent >= 0 => format!("{}", value * 10_f64.powi(exponent)),
        _ => format!("{:e}", value * 10_f64.powi(exponent)),
    }
    .into_bytes()
}

/// Puts something else in the place of a word.
fn replace(input: &mut Vec<u8>, of: impl Fn(&[u8]) -> bool, random: &mut Random, new: impl Fn(&mut Random, &[u8]) -> Vec<u8>) {
    let found: Vec<_> = words(input).into_iter().filter(|at| of(&input[at.clone()])).collect();
    if let Some(at) = found.get(random.below(found.len())) {
        let new = new(random, &input[at.clone()]);
        input.splice(at.clone(), new);
    }
}

/// Exchanges two words.
fn exchange(input: &mut Vec<u8>, random: &mut Random) {
    let found = words(input);
    if found.len() < 2 {
        return;
    }
    let mut places = [random.below(found.len()), random.below(found.len())];
    places.sort_unstable();
    let [first, second] = places.map(|place| found[place].clone());
    if first != second {
        let [one, two] = [&first, &second].map(|at| input[at.clone()].to_vec());
        input.splice(second, one);
        input.splice(first, two);
    }
}

/// Puts a word of another input in the place of one of the same kind.
fn borrow(input: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let theirs = words(other);
    let Some(theirs) = theirs.get(random.below(theirs.len())).map(|at| &other[at.clone()]) else { return };
    let kind = is_number(theirs);
    replace(input, |word| is_number(word) == kind, random, |_, _| theirs.to_vec());
}

/// Puts something else in the place of a line.
fn lines(input: &mut Vec<u8>, random: &mut Random, new: impl Fn(&mut Random, &[u8]) -> Vec<u8>) {
    let found = pieces(input, |byte| byte != b'\n');
    if let Some(at) = found.get(random.below(found.len())) {
        let whole = at.start..(at.end + 1).min(input.len());
        let new = new(random, &input[whole.clone()]);
        input.splice(whole, new);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_seed_gives_the_same_inputs_and_most_differ_from_the_corpus() {
        let corpus = vec![b"a = 1.5\nb = { c = [2, 3] }\n".to_vec(), b"title = \"x\"\nd = 1e3\n".to_vec()];
        let draw = |seed| {
            let mut random = Random::new(seed);
            (0..1000).map(|_| mutated(&corpus, &mut random)).collect::<Vec<_>>()
        };
        assert_eq!(draw(7), draw(7));
        assert_ne!(draw(7), draw(8));
        assert!(draw(7).iter().filter(|input| !corpus.contains(input)).count() > 900);
    }

    #[test]
    fn nothing_to_change_is_no_fault() {
        let corpus = vec![Vec::new(), b"\n".to_vec(), b"7".to_vec()];
        let mut random = Random::new(1);
        let found: std::collections::BTreeSet<_> = (0..2000).map(|_| mutated(&corpus, &mut random)).collect();
        assert!(found.len() > 100 && found.contains(&Vec::new()), "{}", found.len());
    }

    #[test]
    fn words_and_numbers_are_told_apart() {
        let text = b"wear.b = -1.5e3 # \"5 mm/s\"";
        let found: Vec<&[u8]> = words(text).into_iter().map(|at| &text[at]).collect();
        assert_eq!(found, [&b"wear.b"[..], b"-1.5e3", b"5", b"mm", b"s"]);
        assert_eq!(found.iter().map(|word| is_number(word)).collect::<Vec<_>>(), [false, true, true, false, false]);
    }
}
