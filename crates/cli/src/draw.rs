//! A fault as the user sees it: a picture in the terminal, or one JSON document.

use annotate_snippets::renderer::{AnsiColor, Effects};
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use scene::{Fault, Place, Spot, bounded, visible};

/// Longest line that is quoted whole, and the characters before the place and in all of what is quoted of a longer one.
const LINE: usize = 160;
const PART: [usize; 2] = [50, 110];

/// The picture for a terminal: message, place, the line with a caret, remedy.
pub(crate) fn render(fault: &Fault, colour: bool) -> String {
    let title = Level::ERROR.primary_title(told(&fault.message));
    let picture = match &fault.place {
        Some(Place::File(spot)) => title.element(snippet(spot)),
        Some(Place::Flag(flag)) => title.element(Origin::path(told(flag))),
        None => Group::with_title(title),
    };
    let styled = Renderer::styled().help(AnsiColor::Green.on_default().effects(Effects::BOLD));
    let renderer = if colour { styled } else { Renderer::plain() };
    let mut out = renderer.render(&[picture]) + "\n";
    if let Some(Place::File(spot)) = &fault.place {
        // The column in the file, of which a part may be quoted.
        let at = |column: usize| format!("{}:{}:{column}", told(&spot.file), spot.line);
        out = out.replacen(&at(quoted(spot).0.chars().count() + 1), &at(spot.column), 1);
    }
    if !fault.remedy.is_empty() {
        let remedy = Level::HELP.with_name("remedy").primary_title(told(&fault.remedy));
        out += &(renderer.render(&[Group::with_title(remedy)]) + "\n");
    }
    out
}

/// A text of the fault as it is shown: of bounded length, and nothing in it acts.
fn told(text: &str) -> String {
    visible(&bounded(text)).into_owned()
}

/// What is quoted of the line of a place: before it, at it and after it; of a long line what is around the place.
fn quoted(spot: &Spot) -> (String, String, String) {
    // Bytes up to a number of characters.
    let bytes = |count: usize| spot.text.char_indices().nth(count).map_or(spot.text.len(), |(at, _)| at);
    let start = spot.column - 1;
    let long = bytes(LINE) < spot.text.len();
    let from = if long { start.saturating_sub(PART[0]) } else { 0 };
    let to = if long { bytes(from + PART[1]) } else { spot.text.len() };
    let (begin, end) = (bytes(start), bytes(start + spot.length).min(to));
    let before = format!("{}{}", if from > 0 { "\u{2026}" } else { "" }, visible(&spot.text[bytes(from)..begin]));
    let after = format!("{}{}", visible(&spot.text[end..to]), if to < spot.text.len() { "\u{2026}" } else { "" });
    (before, visible(&spot.text[begin..end]).into_owned(), after)
}

/// The line of a place with what is wrong in it underlined.
fn snippet(spot: &Spot) -> Snippet<'static, annotate_snippets::Annotation<'static>> {
    let (before, wrong, after) = quoted(spot);
    let span = before.len()..before.len() + wrong.len();
    let annotation = AnnotationKind::Primary.span(span);
    Snippet::source(before + &wrong + &after).line_start(spot.line).path(told(&spot.file)).annotation(annotation)
}

/// The one JSON document of a failed `--json` call.
pub(crate) fn json(fault: &Fault) -> serde_json::Value {
    let mut error = serde_json::Map::new();
    error.insert("code".into(), fault.code.into());
    error.insert("message".into(), bounded(&fault.message).into());
    match &fault.place {
        Some(Place::File(spot)) => {
            error.insert("file".into(), spot.file.clone().into());
            error.insert("line".into(), spot.line.into());
            error.insert("column".into(), spot.column.into());
        }
        Some(Place::Flag(flag)) => {
            error.insert("flag".into(), flag.clone().into());
        }
        None => {}
    }
    if let Some(key) = &fault.key {
        error.insert("key".into(), bounded(key).into());
    }
    error.insert("remedy".into(), bounded(&fault.remedy).into());
    serde_json::json!({ "error": error })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The picture of a fault in the middle of a text.
    fn picture(text: &str, wrong: &str) -> String {
        let start = text.find(wrong).unwrap_or(0);
        let place = Some(Place::file("shoe.toml", text, start..start + wrong.len()));
        render(&Fault { place, ..Fault::new("wrong", "this is wrong", "write something else") }, false)
    }

    #[test]
    fn a_fault_is_drawn_with_place_line_caret_and_remedy() {
        let drawn = picture("a = 1\nb = wrong\n", "wrong");
        let wanted = "error: this is wrong\n --> shoe.toml:2:5\n  |\n2 | b = wrong\n  |     ^^^^^\n";
        assert!(drawn.starts_with(wanted), "{drawn}");
        assert!(drawn.ends_with("remedy: write something else\n"), "{drawn}");
    }

    #[test]
    fn carets_stand_below_what_is_wrong_behind_tabs_and_wide_characters() {
        for (text, wrong, column) in [("\tb = wrong", "wrong", 6), ("t\u{ef}tle = \"\u{5f62}\u{72b6}\", wrong", "wrong", 15)] {
            let drawn = picture(text, wrong);
            let lines: Vec<&str> = drawn.lines().collect();
            let width = |text: &str| text.chars().map(|c| if c > '\u{2000}' { 2 } else { 1 }).sum::<usize>();
            let line = lines.iter().find(|line| line.starts_with("1 | ")).copied().unwrap_or_default();
            let carets = lines.iter().find(|line| line.contains('^')).copied().unwrap_or_default();
            let at = |line: &str, what: &str| width(line.split(what).next().unwrap_or_default());
            assert_eq!(at(line, "wrong"), at(carets, "^"), "{drawn}");
            assert!(drawn.contains(&format!("shoe.toml:1:{column}\n")), "{drawn}");
        }
    }

    #[test]
    fn a_fault_of_an_empty_text_or_behind_its_end_has_a_picture() {
        assert!(picture("", "").contains("--> shoe.toml:1:1"));
        let behind = Fault { place: Some(Place::file("x.toml", "a =", 3..4)), ..Fault::new("x", "no value", "") };
        let drawn = render(&behind, false);
        assert!(drawn.contains("--> x.toml:1:4") && drawn.contains("1 | a =\n"), "{drawn}");
        assert!(!drawn.contains("remedy") && drawn.contains('^'), "{drawn}");
    }

    #[test]
    fn colour_is_said_in_escapes_and_plain_text_has_none() {
        let flag = Fault { place: Some(Place::Flag("--set x".into())), ..Fault::new("x", "wrong", "right") };
        let plain = render(&flag, false);
        assert!(plain.contains("--> --set x\n") && !plain.contains('\x1b'), "{plain}");
        assert!(render(&flag, true).contains("\x1b["));
    }

    #[test]
    fn of_a_long_line_what_is_around_the_place_is_quoted() {
        let text = format!("a = [{}, wrong, {}]\n", "1, ".repeat(200_000), "2, ".repeat(200_000));
        let drawn = picture(&text, "wrong");
        assert!(drawn.len() < 1000 && drawn.contains("1, , wrong, 2,"), "{drawn}");
        assert!(drawn.contains("shoe.toml:1:600008\n"), "{drawn}");
        let lines: Vec<&str> = drawn.lines().collect();
        let at = |what: &str| lines.iter().find_map(|line| Some(line.split_once(what)?.0.chars().count()));
        assert_eq!(at("wrong, 2"), at("^"), "{drawn}");
        assert_eq!(drawn.matches('\u{2026}').count(), 2, "{drawn}");
    }

    #[test]
    fn nothing_in_a_fault_acts_on_a_terminal() {
        let esc = "\u{1b}]0;owned\u{7}";
        let text = format!("x = '{esc}' wrong\n");
        let start = text.find("wrong").unwrap_or(0);
        let place = Some(Place::file(esc, &text, start..start + 5));
        let drawn = render(&Fault { place, ..Fault::new("wrong", esc, esc) }, false);
        assert!(!drawn.contains(['\u{1b}', '\u{7}']) && drawn.matches("\\u{1b}]0;owned\\u{7}").count() == 4, "{drawn}");
    }
}
