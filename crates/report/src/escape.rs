//! Texts in SVG and HTML.

/// Text that may stand in SVG or HTML; what acts in it is written as what it is, so that both stay well-formed.
pub(crate) fn escaped(text: &str) -> String {
    scene::visible(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A key that a narrow column may break between its words.
pub(crate) fn breakable(key: &str) -> String {
    escaped(key).replace('_', "_<wbr>").replace('.', ".<wbr>")
}
