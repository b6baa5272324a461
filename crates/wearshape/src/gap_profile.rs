//! A measured gap: CSV with the columns s_mm and gap_um, or both in other units of length.

use std::ops::Range;

use meshing::Files;
use scene::{Fault, Gap, GapSum, Place, Rows};

/// Units of length in the names of columns: as powers of ten of a metre.
const UNITS: [(&str, i32); 7] = [("mm", -3), ("um", -6), ("µm", -6), ("μm", -6), ("m", 0), ("cm", -2), ("nm", -9)];
/// What may part the fields of a line; none stands for blanks.
const SEPARATORS: [Option<char>; 4] = [Some(';'), Some('\t'), Some(','), None];
/// Share of the contact surface that a profile may miss at its ends: the digits of a file.
const MISSED: f64 = 1e-6;

const ROW: &str = "write s_mm and gap_um, as in `-30.0,12.5`";

/// The columns of a profile: places (mm) and gaps (um).
pub(crate) type Columns = (Vec<f64>, Vec<f64>);

/// Reads the file that a key names.
pub(crate) fn read(files: Files<'_>, name: &str, key: &str) -> Result<Columns, Fault> {
    let unreadable = |error: String, remedy: &str| {
        Fault::at(key, "unreadable", format!("cannot read the gap profile {name}: {error}"), remedy)
    };
    let bytes = files(name).map_err(|error| unreadable(error, "write 0, or the path of a CSV file, relative to the scene"))?;
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) || bytes.contains(&0) {
        return Err(unreadable("it is UTF-16 text, or none".into(), "save it as UTF-8"));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..byte].iter().filter(|b| **b == b'\n').count() + 1;
        unreadable(format!("line {line} is not UTF-8 text"), "save it as UTF-8")
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let wrong = |at: Range<usize>, [message, remedy]: [String; 2]| Fault {
        place: Some(Place::file(name, text, at)),
        ..Fault::at(key, "wrong-profile", message, remedy)
    };
    let mut lines = lines(text);
    let Some((at, first)) = lines.next() else {
        return Err(wrong(0..0, words("the file has no lines", "begin with `s_mm,gap_um`")));
    };
    let header = Header::of(first).map_err(|why| wrong(at, why))?;
    let (mut mark, mut rows) = (None, Vec::<[f64; 2]>::new());
    for (at, line) in lines {
        let row = header.row(line, &mut mark).map_err(|why| wrong(at.clone(), why))?;
        let Some([s, gap]) = row else { continue };
        let gap = if (-ROUND_OFF..0.0).contains(&gap) { 0.0 } else { gap };
        check_row([s, gap], rows.last().map(|[s, _]| *s)).map_err(|why| wrong(at, why))?;
        rows.push([s, gap]);
    }
    check_count(rows.len(), rows.len(), key)?;
    Ok(rows.into_iter().map(|[s, gap]| (s, gap)).unzip())
}

/// Whether a file that was read is one of a run, which says more of a surface than measuring does: its gap is the whole one.
pub(crate) fn is_of_run(files: Files<'_>, name: &str) -> bool {
    let Some(text) = files(name).ok().and_then(|bytes| String::from_utf8(bytes).ok()) else { return false };
    let header = text.lines().next().unwrap_or_default();
    ["opening_um", "nominal_x_mm"].iter().any(|name| header.split(',').any(|field| field.trim() == *name))
}

fn words(message: impl Into<String>, remedy: &str) -> [String; 2] {
    [message.into(), remedy.into()]
}

/// The lines but comments and empty ones, each with its place.
fn lines(text: &str) -> impl Iterator<Item = (Range<usize>, &str)> {
    let mut from = 0;
    let all = text.split_inclusive('\n').map(move |line| {
        let start = from;
        from += line.len();
        let line = line.trim_end();
        (start..start + line.len(), line)
    });
    all.filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with('#'))
}

/// The fields of a line, without quotes; none where a quote is left open.
fn fields(line: &str, separator: Option<char>) -> Option<Vec<String>> {
    let Some(separator) = separator else {
        return Some(line.split_whitespace().map(|field| field.trim_matches('"').to_string()).collect());
    };
    let (mut fields, mut field, mut quoted) = (Vec::new(), String::new(), false);
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            c if c == separator && !quoted => fields.push(std::mem::take(&mut field).trim().to_string()),
            c => field.push(c),
        }
    }
    fields.push(field.trim().to_string());
    (!quoted).then_some(fields)
}

/// A column: where it stands, and the power of ten of its unit (m).
type Column = (usize, i32);

/// What the first line says: how fields are parted, how many there are, and which are s and the gap.
struct Header {
    separator: Option<char>,
    count: usize,
    columns: [Column; 2],
}

impl Header {
    fn of(line: &str) -> Result<Header, [String; 2]> {
        let mut why = None;
        for separator in SEPARATORS {
            let Some(names) = fields(line, separator) else { continue };
            match [column(&names, "s_"), column(&names, "gap_")] {
                [Ok(Some(s)), Ok(Some(gap))] => return Ok(Header { separator, count: names.len(), columns: [s, gap] }),
                [Err(twice), _] | [_, Err(twice)] => why = why.or(Some(twice)),
                _ => {}
            }
        }
        let message = "the first line does not name the columns s_mm and gap_um";
        let remedy = "begin with `s_mm,gap_um`; their units may also be m, cm, um or nm, as in `s_m,gap_mm`";
        Err(why.unwrap_or_else(|| words(message, remedy)))
    }

    /// s (mm) and gap (um) of a line; none if it is empty but for what parts its fields. `mark` is the decimal mark so far.
    fn row(&self, line: &str, mark: &mut Option<char>) -> Result<Option<[f64; 2]>, [String; 2]> {
        let Some(fields) = fields(line, self.separator) else {
            return Err(words("no CSV: a quote is not closed", "close it with `\"`"));
        };
        if fields.iter().all(String::is_empty) {
            return Ok(None);
        }
        if fields.len() != self.count {
            let many = |count: usize| format!("{count} field{}", if count == 1 { "" } else { "s" });
            let message = format!("this line has {}, the first one {}", many(fields.len()), many(self.count));
            let remedy = match self.separator {
                Some(',') if fields.len() > self.count => {
                    "give every line the fields of the first; where numbers have a decimal comma, part fields by `;`"
                }
                _ => "give every line the fields of the first",
            };
            return Err(words(message, remedy));
        }
        let [s, gap] = self.columns.map(|(at, power)| (number(&fields[at], mark), power));
        Ok(Some([scaled(s.0?, s.1 + 3), scaled(gap.0?, gap.1 + 6)]))
    }
}

/// The one column whose name is the given beginning and a unit of length.
fn column(names: &[String], beginning: &str) -> Result<Option<Column>, [String; 2]> {
    let power = |name: &str| UNITS.iter().find(|(unit, _)| *unit == name).map(|(_, power)| *power);
    let mut found = names.iter().enumerate().filter_map(|(at, name)| Some((at, power(name.strip_prefix(beginning)?)?)));
    let first = found.next();
    match (first, found.next()) {
        (Some((one, _)), Some((two, _))) => {
            let message = format!("two columns say the same: `{}` and `{}`", names[one], names[two]);
            Err(words(message, "name each of s_mm and gap_um once"))
        }
        _ => Ok(first),
    }
}

/// A number with a decimal point or a decimal comma, the same throughout a file.
fn number(field: &str, mark: &mut Option<char>) -> Result<f64, [String; 2]> {
    let marks: Vec<char> = field.chars().filter(|c| matches!(c, '.' | ',')).collect();
    if let Some(first) = marks.first() {
        if marks.len() > 1 {
            let message = format!("`{field}` has more than one decimal mark, so there are not two finite numbers");
            return Err(words(message, "write numbers without marks between thousands"));
        }
        if mark.get_or_insert(*first) != first {
            let message = format!("`{field}` has a decimal {}, numbers before it another mark", mark_name(*first));
            return Err(words(message, "write all numbers with a decimal point, or all with a comma"));
        }
    }
    let value = field.replace(',', ".").parse::<f64>().ok().filter(|value| value.is_finite());
    value.ok_or_else(|| words(format!("this line has no two finite numbers: found `{field}`"), ROW))
}

fn mark_name(mark: char) -> &'static str {
    if mark == ',' { "comma" } else { "point" }
}

/// A number times a power of ten, rounded once.
fn scaled(value: f64, power: i32) -> f64 {
    if power < 0 { value / 10f64.powi(-power) } else { value * 10f64.powi(power) }
}

/// A gap (um) below zero by no more is one of 0 that a computer wrote: an atom has a hundred thousand times as much.
const ROUND_OFF: f64 = 1e-9;

/// What is wrong with a row after the place before it.
fn check_row([s, gap]: [f64; 2], before: Option<f64>) -> Result<(), [String; 2]> {
    let remedy = "write finite numbers";
    if !s.is_finite() {
        return Err(words(format!("s_mm = {s} is no place"), remedy));
    }
    if let Some(before) = before.filter(|before| *before >= s) {
        return Err(words(format!("s_mm does not increase from {before} to {s}"), "sort the points by s_mm, each place once"));
    }
    if !gap.is_finite() {
        return Err(words(format!("gap_um = {gap} is no gap"), remedy));
    }
    if gap < 0.0 {
        let message = format!("gap_um = {gap} is negative");
        return Err(words(message, "measure the gap from the highest point, so that it is 0 or more"));
    }
    Ok(())
}

/// "1 place", "2 places".
fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn check_count(places: usize, gaps: usize, key: &str) -> Result<(), Fault> {
    if places == gaps && places >= 2 {
        return Ok(());
    }
    let message = format!("a gap profile with {} and {}", counted(places, "place"), counted(gaps, "gap"));
    Err(Fault::at(key, "wrong-profile", message, "give two points or more, a gap for each place"))
}

/// Checks the columns of a profile in the scene: two points or more, increasing in s, and no negative gap.
pub(crate) fn check(s: &[f64], gap: &[f64], key: &str) -> Result<(), Fault> {
    check_count(s.len(), gap.len(), key)?;
    let mut before = None;
    for (row, (s, gap)) in s.iter().zip(gap).enumerate() {
        check_row([*s, *gap], before).map_err(|[message, remedy]| {
            let column = if message.starts_with("s_mm") { "s_mm" } else { "gap_um" };
            Fault::at(format!("{key}.{column}.{row}"), "wrong-profile", message, remedy)
        })?;
        before = Some(*s);
    }
    Ok(())
}

/// Refuses a profile that ends before the contact surface does; `surface` is its first and last place (mm).
pub(crate) fn covers(gap: &Gap, surface: [f64; 2]) -> Result<(), Fault> {
    let (Gap::Profile { s, .. } | Gap::Sum(GapSum { profile: Some(Rows::Columns { s, .. }), .. })) = gap else { return Ok(()) };
    let [Some(first), Some(last)] = [s.first(), s.last()] else { return Ok(()) };
    let [from, to] = surface;
    let near = MISSED * (to - from);
    if *first <= from + near && *last >= to - near {
        return Ok(());
    }
    let covered = (last.min(to) - first.max(from)).max(0.0);
    let message = format!(
        "the gap profile covers {} mm of the contact surface of {} mm: it goes from s_mm = {} to {}, the surface from {} to {}",
        scene::short(covered),
        scene::short(to - from),
        scene::short(*first),
        scene::short(*last),
        scene::short(from),
        scene::short(to)
    );
    let remedy = format!("give the gap over the whole surface: from s_mm = {from} to {to}");
    Err(Fault::at("contact.gap", "short-profile", message, remedy))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::{covers, read};
    use scene::{Fault, Gap, Place};

    fn of(text: &str) -> Result<Gap, Fault> {
        read(&|_| Ok(text.as_bytes().to_vec()), "gap.csv", "contact.gap").map(|(s, gap)| Gap::Profile { s, gap })
    }

    #[test]
    fn a_gap_that_a_run_wrote_with_its_round_off_below_zero_is_zero() {
        let same = Gap::Profile { s: vec![-1.5, 2.0], gap: vec![0.0, 1e-3] };
        assert_eq!(of("s_mm,gap_um\n-1.5,-1.73e-15\n2,1e-3\n"), Ok(same));
        assert!(of("s_mm,gap_um\n-1.5,-1e-6\n2,1e-3\n").is_err_and(|fault| fault.message.contains("is negative")));
    }

    #[test]
    fn a_profile_may_be_parted_by_commas_semicolons_tabs_or_blanks_with_quotes_comments_and_other_columns() {
        let same = Gap::Profile { s: vec![-1.5, 2.0], gap: vec![0.0, 1e-3] };
        for text in [
            "s_mm,gap_um\n-1.5,0\n2,1e-3\n",
            "# measured, in a room\r\n\r\n\"s_mm\"; gap_um ;who\r\n-1.5; 0;\"me; too\"\r\n\r\n  # and\r\n2;1e-3;\r\n",
            "who\tgap_um\ts_mm\nI\t0\t-1.5\n  \nI\t1e-3\t2",
            "\u{feff}s_mm,gap_um\n-1.5,0\n2,1e-3",
            "\u{feff}# of Monday\r\ns_mm;gap_um\r\n-1,5;0\r\n2,0;0,001\r\n;\r\n",
            "s_mm,gap_um\n\"-1,5\",0\n2,\"0,001\"\n",
            "  s_mm   gap_um\n  -1.5   0.0\n   2.0   1.0e-3\n",
            "gap_mm;s_m\n0;-1.5e-3\n1e-6;0.002\n",
            "s_cm\tgap_nm\n-,15\t0\n,2\t1\n",
        ] {
            assert_eq!(of(text).unwrap(), same, "{text}");
        }
    }

    #[test]
    fn a_wrong_line_is_shown_where_it_stands() {
        for (text, line, shown) in [
            ("# one\n\n a,b \n1,2\n", 3, " a,b"),
            ("s_mm,gap_um\r\n0,1\r\n# what follows is wrong\r\n1,x\r\n2,3\r\n", 4, "1,x"),
            ("s_mm,gap_um\n0,1\n\n1", 4, "1"),
            ("s_mm,gap_um\n0,1\n1,5,2\n", 3, "1,5,2"),
            ("s_mm;gap_um\n0;1\n1,5\n", 3, "1,5"),
            ("s_mm;gap_um\n0;1\n1;2;\n", 3, "1;2;"),
            ("s_mm;gap_um\n0;1.000,5\n1;2\n", 2, "0;1.000,5"),
            ("s_mm;gap_um\n0;1.5\n1;2,5\n", 3, "1;2,5"),
            ("s_mm,gap_um\n0,1\n1,\"2\n3,4\n", 3, "1,\"2"),
            ("s_mm,gap_um\n0,1\n0,2\n", 3, "0,2"),
            ("s_mm,gap_um\n0,1\n1,-2\n", 3, "1,-2"),
            ("s_mm,gap_um\n0,1\n1,nan\n", 3, "1,nan"),
            ("s_mm,gap_um\n0,1\ninf,0\n", 3, "inf,0"),
            ("s_mm,s_m,gap_um\n0,0,1\n1,1,2\n", 1, "s_mm,s_m,gap_um"),
            ("s_mm,gap_ft\n0,1\n1,2\n", 1, "s_mm,gap_ft"),
        ] {
            let Some(Place::File(spot)) = of(text).unwrap_err().place else { panic!("no place for {text}") };
            assert_eq!(
                (spot.line, spot.column, spot.length, spot.text.trim_end()),
                (line, 1, shown.chars().count(), shown),
                "{text}"
            );
        }
    }

    #[test]
    fn other_encodings_than_utf_8_are_refused_by_name() {
        let utf16: Vec<u8> = "\u{feff}s_mm;gap_um\n0;1\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        let fault = read(&|_| Ok(utf16.clone()), "gap.csv", "contact.gap").unwrap_err();
        assert!(fault.message.contains("UTF-16") && fault.remedy.contains("UTF-8"), "{fault:?}");
        let fault = read(&|_| Ok(b"s_mm,gap_um\n0,1\n# \xb5m\n".to_vec()), "gap.csv", "contact.gap").unwrap_err();
        assert!(fault.message.contains("line 3") && fault.remedy.contains("UTF-8"), "{fault:?}");
    }

    #[test]
    fn a_profile_shorter_than_the_surface_is_refused_unless_by_the_digits_of_a_file() {
        let profile = |from: f64, to: f64| Gap::Profile { s: vec![from, to], gap: vec![0.0, 1.0] };
        for (from, to) in [(-30.0, 30.0), (-99.0, 31.0), (-29.99997, 30.0)] {
            assert_eq!(covers(&profile(from, to), [-30.0, 30.0]), Ok(()));
        }
        let fault = covers(&profile(-3.0, 3.0), [-30.0, 30.0]).unwrap_err();
        assert!(fault.message.contains("6 mm of the contact surface of 60 mm"), "{fault:?}");
        assert!(covers(&profile(-30.0, 29.99), [-30.0, 30.0]).is_err());
    }
}
