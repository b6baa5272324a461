//! A fault as the user sees it: a picture in the terminal, or one JSON document.

use scene::{Fault, Place};

/// The picture for a terminal: message, place, the line with a caret, remedy.
pub(crate) fn render(fault: &Fault, colour: bool) -> String {
    let (bold, red, blue, green, plain) =
        if colour { ("\x1b[1m", "\x1b[1;31m", "\x1b[34m", "\x1b[32m", "\x1b[0m") } else { ("", "", "", "", "") };
    let mut out = format!("{red}error{plain}{bold}: {}{plain}\n", fault.message);
    match &fault.place {
        Some(Place::File(spot)) => {
            let margin = spot.line.to_string().len();
            let pad = " ".repeat(margin);
            let tabs: String = spot.text.chars().take(spot.column - 1).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
            let carets = "^".repeat(spot.length);
            out += &format!("{pad}{blue}-->{plain} {}:{}:{}\n", spot.file, spot.line, spot.column);
            out += &format!("{pad} {blue}|{plain}\n");
            out += &format!("{blue}{} |{plain} {}\n", spot.line, spot.text);
            out += &format!("{pad} {blue}|{plain} {tabs}{red}{carets}{plain}\n");
        }
        Some(Place::Flag(flag)) => out += &format!(" {blue}-->{plain} {flag}\n"),
        None => {}
    }
    if !fault.remedy.is_empty() {
        out += &format!("{green}remedy{plain}: {}\n", fault.remedy);
    }
    out
}

/// The one JSON document of a failed `--json` call.
pub(crate) fn json(fault: &Fault) -> serde_json::Value {
    let mut error = serde_json::Map::new();
    error.insert("code".into(), fault.code.into());
    error.insert("message".into(), fault.message.clone().into());
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
        error.insert("key".into(), key.clone().into());
    }
    error.insert("remedy".into(), fault.remedy.clone().into());
    serde_json::json!({ "error": error })
}
