//! The von Mises stress on the deformed bodies, as SVG.

use crate::body_field::{CellField, FieldFrame};
use crate::cell_grid::CellGrid;
use crate::report::line_plot::escaped;
use crate::report::short;

const WIDTH: f64 = 720.0;
/// Largest height of the drawn bodies.
const HEIGHT: f64 = 620.0;
const MARGIN: f64 = 18.0;
const TOP: f64 = 44.0;
const BOTTOM: f64 = 92.0;
/// Size of a piece of one colour, in units of the picture.
const PIECE: f64 = 6.0;
/// Number of colours.
const CLASSES: usize = 32;
/// Share of the area below and above which colours are clipped.
const CLIP: f64 = 0.02;
/// Dark blue over green to yellow, readable in grey and by colour-blind readers (viridis).
const COLOURS: [[f64; 3]; 9] = [
    [68.0, 1.0, 84.0],
    [71.0, 44.0, 122.0],
    [59.0, 81.0, 139.0],
    [44.0, 113.0, 142.0],
    [33.0, 144.0, 141.0],
    [39.0, 173.0, 129.0],
    [92.0, 200.0, 99.0],
    [170.0, 220.0, 50.0],
    [253.0, 231.0, 37.0],
];

/// A triangle or quadrilateral of one colour.
struct Piece {
    corners: Vec<[f64; 2]>,
    stress: f64,
    area: f64,
}

/// Draws a moment.
pub(crate) fn field_picture(frame: &FieldFrame, title: &str) -> String {
    let cells = || frame.bodies.iter().flat_map(|body| &body.cells);
    let rest = bounds(cells().flat_map(|cell| cell.position.iter().copied()));
    let size = (rest[1][0] - rest[0][0]).hypot(rest[1][1] - rest[0][1]);
    let largest = cells().flat_map(|cell| &cell.displacement).map(|u| u[0].hypot(u[2])).fold(0.0, f64::max);
    let magnified = if largest > 0.0 { round_number(0.03 * size / largest) } else { 1.0 };
    let moved = |cell: &CellField, k: usize| {
        [cell.position[k][0] + magnified * cell.displacement[k][0], cell.position[k][1] + magnified * cell.displacement[k][2]]
    };
    let [low, high] = bounds(cells().flat_map(|cell| (0..cell.position.len()).map(|k| moved(cell, k)).collect::<Vec<_>>()));
    let scale = ((WIDTH - 2.0 * MARGIN) / (high[0] - low[0])).min(HEIGHT / (high[1] - low[1]));
    let left = 0.5 * (WIDTH - scale * (high[0] - low[0]));
    let place = |x: [f64; 2]| [left + scale * (x[0] - low[0]), TOP + scale * (high[1] - x[1])];
    let mut pieces = Vec::new();
    let mut outlines = String::new();
    for cell in cells() {
        let at: Vec<[f64; 2]> = (0..cell.position.len()).map(|k| place(moved(cell, k))).collect();
        cut(cell, &at, &mut pieces);
        outlines += &outline(cell.grid, &at);
    }
    let [from, to] = clipped(&pieces);
    let mut paths = vec![String::new(); CLASSES];
    for piece in &pieces {
        let share = if to > from { (piece.stress - from) / (to - from) } else { 0.5 };
        let class = (share * CLASSES as f64).floor().clamp(0.0, CLASSES as f64 - 1.0) as usize;
        paths[class] += &format!("M{}Z", joined(piece.corners.iter().copied()));
    }
    let bottom = TOP + scale * (high[1] - low[1]);
    let height = (bottom + BOTTOM).round();
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\" \
         font-family=\"'DejaVu Sans', Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"#222\">\n<title>{0}</title>\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#fff\"/>\n\
         <text class=\"title\" x=\"{MARGIN}\" y=\"26\" font-size=\"15\" font-weight=\"bold\">{0}</text>\n",
        escaped(title)
    );
    out += "<g stroke-width=\"0.7\" stroke-linejoin=\"round\">\n";
    for (class, path) in paths.iter().enumerate().filter(|(_, path)| !path.is_empty()) {
        let colour = colour((class as f64 + 0.5) / CLASSES as f64);
        out += &format!("<path fill=\"{colour}\" stroke=\"{colour}\" d=\"{path}\"/>\n");
    }
    out += &format!("</g>\n<path d=\"{outlines}\" fill=\"none\" stroke=\"#fff\" stroke-opacity=\"0.3\" stroke-width=\"0.6\"/>\n");
    out += &legend(bottom + 22.0, from, to, magnified);
    out + "</svg>\n"
}

fn bounds(points: impl Iterator<Item = [f64; 2]>) -> [[f64; 2]; 2] {
    points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], x| {
        [[low[0].min(x[0]), low[1].min(x[1])], [high[0].max(x[0]), high[1].max(x[1])]]
    })
}

/// 1, 2 or 5 times a power of ten, not above the value.
fn round_number(value: f64) -> f64 {
    let decade = 10f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|m| m * decade).find(|rounded| *rounded <= value).unwrap_or(decade)
}

/// Cuts a cell into pieces of about one size, between points of its grid.
fn cut(cell: &CellField, at: &[[f64; 2]], pieces: &mut Vec<Piece>) {
    let (grid, p) = (cell.grid, cell.grid.degree);
    let length =
        |points: &[usize]| points.windows(2).map(|p| (at[p[1]][0] - at[p[0]][0]).hypot(at[p[1]][1] - at[p[0]][1])).sum::<f64>();
    let count = |size: f64| ((size / PIECE).ceil() as usize).clamp(1, p);
    let side = |step: &dyn Fn(usize) -> usize| length(&(0..=p).map(step).collect::<Vec<_>>());
    // A triangle has its third side instead of a last row and a last column.
    let [row, column] = match grid.triangle {
        true => [side(&|i| grid.at(p - i, i)); 2],
        false => [side(&|i| grid.at(i, p)), side(&|j| grid.at(p, j))],
    };
    let (along, up) = (count(side(&|i| grid.at(i, 0)).max(row)), count(side(&|j| grid.at(0, j)).max(column)));
    for nodes in grid.pieces(along, up) {
        let corners: Vec<[f64; 2]> = nodes.iter().map(|k| at[*k]).collect();
        let twice = corners.windows(2).map(|p| cross(corners[0], p[0], p[1])).sum::<f64>();
        let stress = nodes.iter().map(|k| cell.stress[*k].von_mises()).sum::<f64>() / nodes.len() as f64;
        pieces.push(Piece { corners, stress, area: 0.5 * twice.abs() });
    }
}

/// Twice the signed area of a triangle.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

/// The edge of a cell, if it is large enough to be seen.
fn outline(grid: CellGrid, at: &[[f64; 2]]) -> String {
    let [low, high] = bounds(at.iter().copied());
    if (high[0] - low[0]).max(high[1] - low[1]) < 3.0 * PIECE {
        return String::new();
    }
    format!("M{}Z", joined(grid.outline().into_iter().map(|k| at[k])))
}

/// Points of a path.
fn joined(points: impl Iterator<Item = [f64; 2]>) -> String {
    points.map(|[x, y]| format!("{x:.1} {y:.1}")).collect::<Vec<_>>().join("L")
}

/// Stresses below and above which lies the clipped share of the area.
fn clipped(pieces: &[Piece]) -> [f64; 2] {
    let mut order: Vec<&Piece> = pieces.iter().collect();
    order.sort_by(|a, b| a.stress.total_cmp(&b.stress));
    let total: f64 = order.iter().map(|piece| piece.area).sum();
    let at = |share: f64| {
        let mut sum = 0.0;
        let found = order.iter().find(|piece| {
            sum += piece.area;
            sum >= share * total
        });
        found.or(order.last()).map_or(0.0, |piece| piece.stress)
    };
    [at(CLIP), at(1.0 - CLIP)]
}

fn colour(share: f64) -> String {
    let place = share.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let below = (place.floor() as usize).min(COLOURS.len() - 2);
    let part = place - below as f64;
    let [r, g, b] = [0, 1, 2].map(|k| ((1.0 - part) * COLOURS[below][k] + part * COLOURS[below + 1][k]).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn legend(top: f64, from: f64, to: f64, magnified: f64) -> String {
    let width = (WIDTH - 2.0 * MARGIN) / CLASSES as f64;
    let mut out = String::new();
    for class in 0..CLASSES {
        let left = MARGIN + width * class as f64;
        let colour = colour((class as f64 + 0.5) / CLASSES as f64);
        out += &format!("<rect x=\"{left:.2}\" y=\"{top:.1}\" width=\"{:.2}\" height=\"12\" fill=\"{colour}\"/>", width + 0.3);
    }
    out += "\n";
    let anchors = [("start", MARGIN, from), ("middle", 0.5 * WIDTH, 0.5 * (from + to)), ("end", WIDTH - MARGIN, to)];
    for (anchor, x, value) in anchors {
        let value = value_text(value);
        out += &format!("<text x=\"{x}\" y=\"{:.1}\" text-anchor=\"{anchor}\">{value} MPa</text>\n", top + 31.0);
    }
    out + &format!(
        "<text class=\"small\" x=\"{MARGIN}\" y=\"{:.1}\" font-size=\"12\" fill=\"#555\">Displacements {} times. Colours span the middle 96 % of the area.</text>\n",
        top + 53.0,
        short(magnified)
    )
}

/// Three significant digits.
fn value_text(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    short(rounded)
}

#[cfg(test)]
mod tests {
    use super::{colour, field_picture, round_number};
    use crate::body_field::{BodyField, CellField, FieldFrame};
    use crate::cell_grid::CellGrid;
    use hpfem::Stress;

    fn cell(left: f64, size: f64, stress: f64) -> CellField {
        CellField {
            grid: CellGrid { degree: 1, triangle: false },
            position: vec![[left, 0.0], [left + size, 0.0], [left, 1.0], [left + size, 1.0]],
            displacement: vec![[0.0; 3]; 4],
            stress: vec![Stress { xx: stress, ..Stress::default() }; 4],
        }
    }

    #[test]
    fn a_peak_on_a_small_area_does_not_take_the_colours_from_the_rest() {
        let body =
            BodyField { cells: vec![cell(0.0, 5.0, 1.0), cell(5.0, 5.0, 2.0), cell(10.0, 0.1, 1e6)], ..BodyField::default() };
        let frame = FieldFrame { time_s: 0.0, moment: "", bodies: [body, BodyField::default()] };
        let picture = field_picture(&frame, "a < b");
        assert!(picture.contains(">1 MPa<") && picture.contains(">2 MPa<") && !picture.contains("1e6"), "{picture}");
        assert!(picture.contains("a &lt; b"));
    }

    #[test]
    fn magnifications_are_round_and_colours_end_in_dark_and_bright() {
        assert_eq!([0.73, 1.0, 4.9, 730.0].map(round_number), [0.5, 1.0, 2.0, 500.0]);
        assert_eq!((colour(-1.0).as_str(), colour(2.0).as_str()), ("#440154", "#fde725"));
    }
}
