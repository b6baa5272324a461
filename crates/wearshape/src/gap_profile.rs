//! A measured gap: CSV with the columns s_mm and gap_um.

use std::ops::Range;

use meshing::Files;
use scene::{Fault, Gap, Place};

/// Reads the file of `contact.gap`.
pub(crate) fn read(files: Files<'_>, name: &str) -> Result<Gap, Fault> {
    let text = files(name).and_then(|bytes| String::from_utf8(bytes).map_err(|error| format!("it is no text: {error}")));
    let text = text.map_err(|error| {
        let message = format!("cannot read the gap profile {name}: {error}");
        Fault::at("contact.gap", "unreadable", message, "write 0, or the path of a CSV file, relative to the scene")
    })?;
    let mut reader = reader(&text);
    let mut record = csv::StringRecord::new();
    let mut columns: Option<(usize, usize)> = None;
    let (mut s, mut gap) = (Vec::new(), Vec::new());
    loop {
        let from = reader.position().byte() as usize;
        let more = reader.read_record(&mut record);
        let to = reader.position().byte() as usize;
        let wrong = |message: &str, remedy: &str| Fault {
            place: Some(Place::file(name, &text, written(&text, from..to))),
            ..Fault::at("contact.gap", "wrong-profile", message, remedy)
        };
        match more {
            Ok(true) if record.iter().all(str::is_empty) || record[0].starts_with('#') => continue,
            Ok(true) => {}
            Ok(false) => break,
            Err(error) => return Err(wrong(&format!("no CSV: {error}"), "write s_mm and gap_um, as in `-30.0,12.5`")),
        }
        let Some((s_at, gap_at)) = columns else {
            let find = |name: &str| record.iter().position(|field| field.trim_matches('"') == name);
            let (Some(s_at), Some(gap_at)) = (find("s_mm"), find("gap_um")) else {
                return Err(wrong("the first line does not name the columns s_mm and gap_um", "begin with `s_mm,gap_um`"));
            };
            columns = Some((s_at, gap_at));
            continue;
        };
        let number = |at: usize| record.get(at).and_then(|field| field.parse::<f64>().ok()).filter(|v| v.is_finite());
        let (Some(s_value), Some(gap_value)) = (number(s_at), number(gap_at)) else {
            return Err(wrong("this line has no two finite numbers", "write s_mm and gap_um, as in `-30.0,12.5`"));
        };
        s.push(s_value);
        gap.push(gap_value);
    }
    check(&s, &gap)?;
    Ok(Gap::Profile { s, gap })
}

/// Fields are parted by the first of comma, semicolon and tab that is seen outside the comments.
fn reader(text: &str) -> csv::Reader<&[u8]> {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.starts_with('#'));
    let delimiter = lines.find_map(|line| line.bytes().find(|byte| b",;\t".contains(byte))).unwrap_or(b',');
    let mut options = csv::ReaderBuilder::new();
    options.delimiter(delimiter).comment(Some(b'#')).trim(csv::Trim::All).has_headers(false).flexible(true);
    options.from_reader(text.as_bytes())
}

/// What the reader has passed, without the comments and empty lines before the record and the end of its line.
fn written(text: &str, passed: Range<usize>) -> Range<usize> {
    let text = &text[passed.clone()];
    let none = |line: &&str| line.trim().is_empty() || line.trim_start().starts_with('#');
    let skipped: usize = text.split_inclusive('\n').take_while(none).map(str::len).sum();
    passed.start + skipped..passed.start + text.trim_end().len().max(skipped)
}

/// A profile needs two points or more, increasing in s, and no negative gap.
pub(crate) fn check(s: &[f64], gap: &[f64]) -> Result<(), Fault> {
    let wrong = |message: String, remedy: &str| Err(Fault::at("contact.gap", "wrong-profile", message, remedy));
    if s.len() != gap.len() || s.len() < 2 {
        let message = format!("a gap profile with {} places and {} gaps", s.len(), gap.len());
        return wrong(message, "give two points or more, a gap for each place");
    }
    if let Some(at) = s.windows(2).position(|pair| pair[1].partial_cmp(&pair[0]) != Some(std::cmp::Ordering::Greater)) {
        return wrong(format!("s_mm does not increase from {} to {}", s[at], s[at + 1]), "sort the points by s_mm");
    }
    if let Some(value) = gap.iter().find(|value| value.is_nan() || **value < 0.0 || value.is_infinite()) {
        return wrong(format!("gap_um = {value} is negative"), "measure the gap from the highest point, so that it is 0 or more");
    }
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::read;
    use scene::{Fault, Gap, Place};

    fn of(text: &str) -> Result<Gap, Fault> {
        read(&|_| Ok(text.as_bytes().to_vec()), "gap.csv")
    }

    #[test]
    fn a_profile_may_be_parted_by_commas_semicolons_or_tabs_with_quotes_comments_and_other_columns() {
        let same = Gap::Profile { s: vec![-1.5, 2.0], gap: vec![0.0, 1e-3] };
        for text in [
            "s_mm,gap_um\n-1.5,0\n2,1e-3\n",
            "# measured, in a room\r\n\r\n\"s_mm\"; gap_um ;who\r\n-1.5; 0;\"me; too\"\r\n\r\n  # and\r\n2;1e-3\r\n",
            "who\tgap_um\ts_mm\nI\t0\t-1.5\n  \nI\t1e-3\t2",
            "\u{feff}s_mm,gap_um\n-1.5,0\n2,1e-3",
        ] {
            assert_eq!(of(text).unwrap(), same, "{text}");
        }
    }

    #[test]
    fn a_wrong_line_is_shown_where_it_stands() {
        for (text, line, shown) in [
            ("# one\n\n a,b \n1,2\n", 3, " a,b "),
            ("s_mm,gap_um\r\n0,1\r\n# what follows is wrong\r\n1,x\r\n2,3\r\n", 4, "1,x"),
            ("s_mm,gap_um\n0,1\n\n1", 4, "1"),
            ("s_mm;gap_um\n0;1\n1,5;2\n", 3, "1,5;2"),
            ("s_mm,gap_um\n0,1\n1,\"2\n3,4\n", 3, "1,\"2"),
        ] {
            let Some(Place::File(spot)) = of(text).unwrap_err().place else { panic!("no place for {text}") };
            let trimmed = shown.trim_end().chars().count();
            assert_eq!((spot.line, spot.column, spot.length, spot.text.as_str()), (line, 1, trimmed, shown), "{text}");
        }
    }
}
