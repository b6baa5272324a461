//! The von Mises stress on the deformed bodies, as SVG.

use scene::short;
use wearshape::{CellField, CellGrid, FieldFrame};

use crate::isobands::{BAR, Isobands, Placed, UNIT};
use crate::section_plot::Section;
use crate::touch::Touch;

/// Size of a piece that is cut at the colours, in pixels.
pub(crate) const PIECE: f64 = 12.0;
/// Smallest cell whose edge is drawn, in pixels.
const SEEN: f64 = 18.0;
/// Room for the legend, in pixels.
pub(crate) const LEGEND: f64 = 90.0;

/// Draws a moment: the reported one with the bodies as they touch.
pub(crate) fn field_picture(frame: &FieldFrame, touch: Option<&Touch<'_>>, title: &str) -> String {
    let cells = || frame.bodies.iter().enumerate().flat_map(|(number, body)| body.cells.iter().map(move |cell| (number, cell)));
    let rest = bounds(cells().flat_map(|(_, cell)| cell.position.iter().copied()));
    let size = (rest[1][0] - rest[0][0]).hypot(rest[1][1] - rest[0][1]);
    let shifted = |number: usize, place: [f64; 2], u: [f64; 3], magnified: f64| {
        let [x, z] = touch.filter(|_| number == 0).map_or([0.0; 2], |touch| touch.shift(place, magnified));
        [magnified * u[0] + x, magnified * u[2] + z]
    };
    let length = |(number, cell): (usize, &CellField)| {
        let rows = cell.position.iter().zip(&cell.displacement);
        rows.map(|(place, u)| shifted(number, *place, *u, 1.0)).map(|[x, z]| x.hypot(z)).fold(0.0, f64::max)
    };
    let largest = cells().map(length).fold(0.0, f64::max);
    let magnified = if largest > 0.0 { round_number(0.03 * size / largest) } else { 1.0 };
    let moved = |number: usize, cell: &CellField, k: usize| {
        let [x, z] = shifted(number, cell.position[k], cell.displacement[k], magnified);
        [cell.position[k][0] + x, cell.position[k][1] + z]
    };
    let drawn: Vec<(&CellField, Vec<[f64; 2]>)> =
        cells().map(|(number, cell)| (cell, (0..cell.position.len()).map(|k| moved(number, cell, k)).collect())).collect();
    let [low, high] = bounds(drawn.iter().flat_map(|(_, at)| at.iter().copied()));
    let section = Section::without_axes([low[0], high[0]], [low[1], high[1]], LEGEND);
    let placed: Vec<Placed> = drawn
        .iter()
        .map(|(cell, at)| {
            (cell.grid, at.iter().zip(&cell.stress).map(|(x, stress)| (section.place(*x), stress.von_mises())).collect())
        })
        .collect();
    let bands = Isobands::of(&placed, PIECE);
    let outlines: String = placed.iter().map(|(grid, at)| outline(*grid, &at.iter().map(|s| s.0).collect::<Vec<_>>())).collect();
    let [right, top, bottom] = section.edges();
    let bar = bands.bar([right + 16.0, top + BAR], (bottom - top - BAR).min(320.0));
    let body = format!(
        "{}<path d=\"{outlines}\" fill=\"none\" stroke=\"#fff\" stroke-opacity=\"0.3\" stroke-width=\"0.6\"/>\n\
         <text x=\"{:.1}\" y=\"{:.1}\">MPa</text>\n{bar}",
        bands.svg(),
        right + 16.0,
        top + UNIT
    );
    let remark = format!("Displacements {} times. Colours span the middle 96 % of the area.", short(magnified));
    section.remarked(title, &remark, &body)
}

/// Least and greatest coordinates.
pub(crate) fn bounds(points: impl Iterator<Item = [f64; 2]>) -> [[f64; 2]; 2] {
    points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], x| {
        [[low[0].min(x[0]), low[1].min(x[1])], [high[0].max(x[0]), high[1].max(x[1])]]
    })
}

/// 1, 2 or 5 times a power of ten, not above the value.
fn round_number(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|rounded| *rounded <= value).unwrap_or(decade)
}

/// The edge of a cell, if it is large enough to be seen.
pub(crate) fn outline(grid: CellGrid, at: &[[f64; 2]]) -> String {
    let [low, high] = bounds(at.iter().copied());
    if (high[0] - low[0]).max(high[1] - low[1]) < SEEN {
        return String::new();
    }
    let points: Vec<String> = grid.outline().into_iter().map(|k| format!("{:.1} {:.1}", at[k][0], at[k][1])).collect();
    format!("M{}Z", points.join("L"))
}

#[cfg(test)]
mod tests {
    use super::{field_picture, round_number};
    use wearshape::{BodyField, CellField, CellGrid, FieldFrame, Stress};

    #[test]
    fn a_picture_has_its_title_and_says_how_the_bodies_are_drawn() {
        let cell = CellField {
            grid: CellGrid { degree: 1, triangle: false },
            position: vec![[0.0, 0.0], [5.0, 0.0], [0.0, 1.0], [5.0, 1.0]],
            displacement: vec![[0.0, 0.0, 1e-4]; 4],
            stress: vec![Stress { xx: 2.0, ..Stress::default() }; 4],
            ..CellField::default()
        };
        let body = BodyField { cells: vec![cell], ..BodyField::default() };
        let frame = FieldFrame { time: 0.0, moment: "", bodies: [body, BodyField::default()] };
        let picture = field_picture(&frame, None, "a < b");
        assert!(picture.contains("a &lt; b") && picture.contains("Displacements 1000 times"), "{picture}");
    }

    #[test]
    fn the_unit_stands_clear_of_the_numbers_of_the_bar_on_a_phone() {
        let cell = |value: f64| CellField {
            grid: CellGrid { degree: 1, triangle: false },
            position: vec![[value, 0.0], [value + 1.0, 0.0], [value, 5.0], [value + 1.0, 5.0]],
            displacement: vec![[0.0; 3]; 4],
            stress: vec![Stress { xx: value, ..Stress::default() }; 4],
            ..CellField::default()
        };
        let body = BodyField { cells: vec![cell(1.0), cell(2.0)], ..BodyField::default() };
        let frame = FieldFrame { time: 0.0, moment: "", bodies: [body, BodyField::default()] };
        let picture = field_picture(&frame, None, "a");
        // No number is not larger than another.
        let after = |text: &str, start: &str, end: &str| {
            let number = text.split(start).nth(1).and_then(|rest| rest.split(end).next()?.parse::<f64>().ok());
            number.unwrap_or(f64::NAN)
        };
        let line = |words: &str| picture.lines().find(|line| line.ends_with(&format!(">{words}</text>"))).unwrap_or("");
        let base = |words: &str| after(line(words), "y=\"", "\"");
        let letters = after(include_str!("page.css"), ".field text { font-size: ", "px");
        assert!(base("2.000") - base("MPa") > letters, "{picture}");
    }

    #[test]
    fn magnifications_are_round() {
        assert_eq!([0.73, 1.0, 4.9, 730.0].map(round_number), [0.5, 1.0, 2.0, 500.0]);
    }
}
