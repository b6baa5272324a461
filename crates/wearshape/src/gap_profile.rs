//! A measured gap: CSV with the columns s_mm and gap_um.

use meshing::Files;
use scene::{Fault, Gap, Place};

/// Reads the file of `contact.gap`.
pub(crate) fn read(files: Files<'_>, name: &str) -> Result<Gap, Fault> {
    let text = files(name).and_then(|bytes| String::from_utf8(bytes).map_err(|error| format!("it is no text: {error}")));
    let text = text.map_err(|error| {
        let message = format!("cannot read the gap profile {name}: {error}");
        Fault::at("contact.gap", "unreadable", message, "write 0, or the path of a CSV file, relative to the scene")
    })?;
    let mut offset = 0;
    let mut columns: Option<(usize, usize)> = None;
    let (mut s, mut gap) = (Vec::new(), Vec::new());
    for line in text.split_inclusive('\n') {
        let span = offset..offset + line.trim_end().len();
        offset += line.len();
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let wrong = |message: &str, remedy: &str| Fault {
            place: Some(Place::file(name, &text, span.clone())),
            ..Fault::at("contact.gap", "wrong-profile", message, remedy)
        };
        let fields: Vec<&str> = line.split([',', ';', '\t']).map(str::trim).collect();
        let Some((s_at, gap_at)) = columns else {
            let find = |name: &str| fields.iter().position(|field| field.trim_matches('"') == name);
            let (Some(s_at), Some(gap_at)) = (find("s_mm"), find("gap_um")) else {
                return Err(wrong("the first line does not name the columns s_mm and gap_um", "begin with `s_mm,gap_um`"));
            };
            columns = Some((s_at, gap_at));
            continue;
        };
        let number = |at: usize| fields.get(at).and_then(|field| field.parse::<f64>().ok()).filter(|v| v.is_finite());
        let (Some(s_value), Some(gap_value)) = (number(s_at), number(gap_at)) else {
            return Err(wrong("this line has no two finite numbers", "write s_mm and gap_um, as in `-30.0,12.5`"));
        };
        s.push(s_value);
        gap.push(gap_value);
    }
    check(&s, &gap)?;
    Ok(Gap::Profile { s, gap })
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
