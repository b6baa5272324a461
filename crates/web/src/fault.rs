//! What is wrong with a scene, for the page.

use scene::{Fault, Place};
use serde_json::{Value, json};

/// Message, key, remedy, and the place in the text: line and column from 1, and how many characters.
pub(crate) fn fault(fault: Fault) -> Value {
    let Fault { code, message, key, place, remedy } = fault;
    let place = match place {
        Some(Place::File(spot)) => json!({ "line": spot.line, "column": spot.column, "length": spot.length, "text": spot.text }),
        Some(Place::Flag(_)) | None => Value::Null,
    };
    json!({ "code": code, "message": message, "key": key, "remedy": remedy, "place": place })
}
