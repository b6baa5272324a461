//! What every page begins and ends with. A browser asks no network for it, and runs no script in it but ours.

use serde_json::Value;

use crate::json::inert;

/// The script as it stands in the page.
const SCRIPT: &str = concat!("\n", include_str!("page.js"));

/// The letters of base 64.
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Up to the content; the title is escaped.
pub(crate) fn begin(title: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-{}'; \
         style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <link rel=\"icon\" href=\"data:,\">\n<title>{title}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n",
        hash(SCRIPT),
        include_str!("page.css")
    )
}

/// What the script draws, and the script.
pub(crate) fn end(data: &Value) -> String {
    // `<` cannot end the element early: it is written as an escape.
    let data = inert(data.to_string()).replace('<', "\\u003c");
    format!(
        "<script type=\"application/json\" id=\"data\">{data}</script>\n<script>{SCRIPT}</script>\n</main>\n</body>\n</html>\n"
    )
}

/// SHA-256 in base 64, by which a page names the script that may run.
fn hash(script: &str) -> String {
    let digits = scene::sha256(script);
    let byte = |place: usize| digits.get(2 * place..2 * place + 2).and_then(|pair| u32::from_str_radix(pair, 16).ok());
    let bytes: Vec<u32> = (0..32).filter_map(byte).collect();
    // Four letters for three bytes; the last two bytes have three and a sign of equality.
    let letters = |three: &[u32]| {
        let bits = three.iter().fold(0, |bits, byte| bits << 8 | byte) << (8 * (3 - three.len()));
        let letter = move |place: usize| char::from(LETTERS[(bits >> (18 - 6 * place)) as usize & 63]);
        (0..=three.len()).map(letter).collect::<String>()
    };
    bytes.chunks(3).map(letters).collect::<String>() + "="
}

#[cfg(test)]
mod tests {
    use super::hash;

    #[test]
    fn a_script_is_named_by_its_hash() {
        assert_eq!(hash(""), "47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
    }
}
