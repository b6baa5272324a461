//! The temperature of the bodies, as SVG.

use wearshape::{CellField, FieldFrame};

use crate::field_picture::{LEGEND, PIECE, bounds, outline};
use crate::isobands::{BAR, Isobands, Placed, UNIT};
use crate::section_plot::Section;

/// Draws the temperatures of a moment on the bodies as they are without load; none where there are none. A body that is not warmed is left grey.
pub(crate) fn heat_picture(frame: &FieldFrame, title: &str) -> Option<String> {
    let cells = || frame.bodies.iter().flat_map(|body| &body.cells);
    let warm = |cell: &&CellField| cell.temperature.len() == cell.position.len();
    let found = || cells().filter(warm).flat_map(|cell| cell.temperature.iter().copied());
    let range = found().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], t| [low.min(t), high.max(t)]);
    if !range.iter().all(|end| end.is_finite()) {
        return None;
    }
    let [low, high] = bounds(cells().flat_map(|cell| cell.position.iter().copied()));
    let section = Section::without_axes([low[0], high[0]], [low[1], high[1]], LEGEND);
    let on_paper = |cell: &CellField| cell.position.iter().map(|x| section.place(*x)).collect::<Vec<_>>();
    let placed: Vec<Placed> = cells()
        .filter(warm)
        .map(|cell| (cell.grid, on_paper(cell).into_iter().zip(cell.temperature.iter().copied()).collect()))
        .collect();
    let bands = Isobands::between(&placed, PIECE, range);
    let cold: String = cells()
        .filter(|cell| !warm(cell))
        .map(|cell| {
            let at = on_paper(cell);
            let points: Vec<String> =
                cell.grid.outline().into_iter().map(|k| format!("{:.1} {:.1}", at[k][0], at[k][1])).collect();
            format!("M{}Z", points.join("L"))
        })
        .collect();
    let grey = match cold.as_str() {
        "" => String::new(),
        cold => format!("<path d=\"{cold}\" fill=\"#d9d9d9\" stroke=\"#d9d9d9\" stroke-width=\"0.5\"/>\n"),
    };
    let outlines: String = cells().map(|cell| outline(cell.grid, &on_paper(cell))).collect();
    let [right, top, bottom] = section.edges();
    let bar = bands.bar([right + 16.0, top + BAR], (bottom - top - BAR).min(320.0));
    let body = format!(
        "{grey}{}<path d=\"{outlines}\" fill=\"none\" stroke=\"#fff\" stroke-opacity=\"0.3\" stroke-width=\"0.6\"/>\n\
         <text x=\"{:.1}\" y=\"{:.1}\">\u{b0}C</text>\n{bar}",
        bands.svg(),
        right + 16.0,
        top + UNIT
    );
    Some(section.remarked(title, "Bodies without their displacements.", &body))
}

#[cfg(test)]
mod tests {
    use super::heat_picture;
    use wearshape::{BodyField, CellField, CellGrid, FieldFrame};

    fn frame(temperature: Vec<f64>) -> FieldFrame {
        let cell = |left: f64, temperature| CellField {
            grid: CellGrid { degree: 1, triangle: false },
            position: vec![[left, 0.0], [left + 5.0, 0.0], [left, 1.0], [left + 5.0, 1.0]],
            temperature,
            ..CellField::default()
        };
        let body = |cell| BodyField { cells: vec![cell], ..BodyField::default() };
        FieldFrame { time: 0.0, moment: "", bodies: [body(cell(0.0, temperature)), body(cell(5.0, Vec::new()))] }
    }

    #[test]
    fn temperatures_are_drawn_where_they_are_known_and_the_rest_is_grey() {
        let picture = heat_picture(&frame(vec![20.0, 20.0, 80.0, 80.0]), "a < b").unwrap_or_default();
        assert!(picture.contains("a &lt; b") && picture.contains("#d9d9d9") && picture.contains(">80.0<"), "{picture}");
        assert!(heat_picture(&frame(Vec::new()), "cold").is_none());
    }
}
