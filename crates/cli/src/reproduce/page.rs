//! The page that shows all items: validation.md.

use crate::reproduce::row::rows_markdown;
use crate::reproduce::{ITEMS, Made};

/// Pictures shown on the page.
const SHOWN: [&str; 16] = [
    "fig4/curves",
    "fig7/curves",
    "fig8/a",
    "fig9/mesh",
    "fig10/curves",
    "fig11/b",
    "fig13/curves",
    "fig14/a",
    "fig15/b",
    "fig17/a",
    "fig20/curves",
    "fig22/curves",
    "fig24/shape",
    "fig26/von-mises",
    "table-wr/curves",
    "errata/drum",
];

const HEAD: &str = "# The paper's figures and tables, recomputed

I. Paczelt, Z. Mroz: Optimal shapes of contact interfaces due to sliding wear in the steady relative motion, International Journal of
Solids and Structures 44 (2007) 895-925. Written by `cargo xtask validation`, which calls `wearshape reproduce all`; do not edit.

`wearshape reproduce fig4` computes one item anew and writes its curves (CSV), pictures (SVG), rows and the commands that repeat each
curve by itself. \"paper says\" stands only where the paper's text states a number; its figures are curves without numbers. The independent
value is a closed form by plain quadrature, or another way to the same number, and shares nothing with the solver. \"Formula as printed\"
is the paper's formula taken literally where it is in error; see [the theory's errata](theory-errata.md).
";

/// The page and the pictures it shows, as paths beside it.
pub(crate) fn page(all: &[(&str, &Made)]) -> Vec<(String, String)> {
    let mut text = String::from(HEAD);
    let mut files = Vec::new();
    for (name, made) in all {
        let sentence = ITEMS.iter().find(|item| item.name == *name).map_or("", |item| item.sentence);
        text += &format!("\n## {name}\n\n{sentence}.\n\n");
        for file in made.files.iter().filter(|file| file.name.ends_with(".svg")) {
            let stem = file.name.trim_end_matches(".svg");
            if SHOWN.contains(&format!("{name}/{stem}").as_str()) {
                let place = format!("validation/{name}-{stem}.svg");
                text += &format!("![{sentence}]({place})\n\n");
                files.push((place, file.text.clone()));
            }
        }
        text += &rows_markdown(&made.rows);
        for remark in &made.remarks {
            text += &format!("\n{remark}\n");
        }
    }
    files.push(("validation.md".into(), text));
    files
}
