//! Pictures read from a folder, which anybody may have written: into a page go only those made of what this crate draws with.

/// The elements of our pictures.
const ELEMENTS: [&str; 8] = ["circle", "g", "path", "rect", "svg", "text", "title", "tspan"];

/// Their attributes but for `aria-label` and `xmlns`.
const ATTRIBUTES: [&str; 31] = [
    "class",
    "cx",
    "cy",
    "d",
    "dx",
    "dy",
    "fill",
    "fill-opacity",
    "fill-rule",
    "font-family",
    "font-size",
    "font-style",
    "font-weight",
    "height",
    "opacity",
    "paint-order",
    "r",
    "role",
    "rx",
    "stroke",
    "stroke-dasharray",
    "stroke-linecap",
    "stroke-linejoin",
    "stroke-opacity",
    "stroke-width",
    "text-anchor",
    "transform",
    "viewBox",
    "width",
    "x",
    "y",
];

/// Whether a text is one picture of known elements with known attributes, none of which can name another file or hold a script.
pub(crate) fn is_harmless(svg: &str) -> bool {
    let mut open: Vec<&str> = Vec::new();
    let mut begun = false;
    let mut rest = svg;
    while let Some((text, tag)) = rest.split_once('<') {
        let Some((tag, after)) = tag.split_once('>') else { return false };
        rest = after;
        if open.is_empty() && (begun || !text.trim().is_empty()) {
            return false;
        }
        if let Some(name) = tag.strip_prefix('/') {
            if open.pop() != Some(name) {
                return false;
            }
            continue;
        }
        let (tag, closed) = tag.strip_suffix('/').map_or((tag, false), |tag| (tag, true));
        let name = tag.split_whitespace().next().unwrap_or("");
        let known = tag.starts_with(name) && ELEMENTS.contains(&name) && (name == "svg") == open.is_empty();
        if !known || !attributes(&tag[name.len()..]) {
            return false;
        }
        begun = true;
        if !closed {
            open.push(name);
        }
    }
    begun && open.is_empty() && rest.trim().is_empty()
}

/// Whether a text is a list of known attributes with values as we write them.
fn attributes(text: &str) -> bool {
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        let Some((name, value)) = rest.split_once("=\"") else { return false };
        let Some((value, after)) = value.split_once('"') else { return false };
        if !sound(name, value) || !(after.is_empty() || after.starts_with(char::is_whitespace)) {
            return false;
        }
        rest = after.trim_start();
    }
    true
}

fn sound(name: &str, value: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || " .,-+#%'_".contains(c) || (name == "transform" && "()".contains(c));
    match name {
        "aria-label" => true,
        "xmlns" => value == "http://www.w3.org/2000/svg",
        _ => ATTRIBUTES.contains(&name) && value.chars().all(plain),
    }
}

#[cfg(test)]
mod tests {
    use super::is_harmless;
    use crate::{Axis, LinePlot, Series, line_plot};

    #[test]
    fn our_own_pictures_are_harmless_whatever_their_titles_say() {
        let points = vec![(1.0, 2.0), (10.0, 3e-7)];
        let series = Series { name: "<script>alert(1)</script>\u{1b}".into(), points, marks: true, dashed: true };
        let plot = LinePlot {
            title: "\" onload=\"alert(1)\" <svg> \u{7}".into(),
            x_label: "x".into(),
            y_label: "y".into(),
            axes: [Axis::Logarithmic; 2],
            from_zero: false,
            series: vec![series],
        };
        let svg = line_plot(&plot);
        assert!(is_harmless(&svg) && !svg.contains(scene::acts), "{svg}");
    }

    #[test]
    fn scripts_and_other_files_are_not() {
        let inside = |text: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{text}</svg>\n");
        assert!(is_harmless(&inside("<g><path d=\"M1 2L3 4\"/></g>")));
        for text in [
            "<script>alert(1)</script>",
            "<image href=\"http://x\"/>",
            "<g onload=\"alert(1)\"></g>",
            "<rect fill=\"url(http://x)\"/>",
            "<rect style=\"fill:red\"/>",
            "<rect fill='red'/>",
            "<g>",
            "</svg><svg>",
            "<!-- -->",
            "<path d=\"M1 2\"onload=\"x\"/>",
            "<foreignObject></foreignObject>",
            "<a></a>",
        ] {
            assert!(!is_harmless(&inside(text)), "{text}");
        }
        for text in ["", "text", "<svg", "<svg></svg>text", "<svg></svg><svg></svg>", "<g></g>", "<svg/onload=\"x\"></svg>"] {
            assert!(!is_harmless(text), "{text}");
        }
    }
}
