//! The pressure over a surface of two dimensions, as SVG.

use wearshape::{PressureMap, PressureResult};

use crate::brief::brief;
use crate::isobands::{BAR, Isobands, Placed, UNIT};
use crate::section_plot::Section;

/// Size of a piece that is cut at the colours, and room for the legend, in pixels.
const PIECE: f64 = 9.0;
const LEGEND: f64 = 90.0;

/// Draws the map with a cross at the largest pressure; no colour is clipped.
pub(crate) fn map_picture(map: &PressureMap, pressure: &PressureResult, title: &str) -> String {
    let range = |k: usize| map.position.iter().fold([f64::MAX, f64::MIN], |[low, high], p| [low.min(p[k]), high.max(p[k])]);
    let section = Section::new(range(0), range(1), LEGEND);
    let places = map.position.iter().map(|p| section.place(*p));
    let cell: Placed = (map.grid, places.zip(map.pressure.iter().copied()).collect());
    let values = || map.pressure.iter().copied();
    let (low, high) = (values().fold(f64::MAX, f64::min), values().fold(f64::MIN, f64::max));
    let bands = Isobands::between(&[cell], PIECE, [low, high]);
    let [right, top, bottom] = section.edges();
    let mut body = bands.svg();
    if let (Some([x, y, _]), Some(most)) = (pressure.p_max_at, pressure.p_max) {
        let [px, py] = section.place([x, y]);
        let (anchor, side) = if px > 0.5 * right { ("end", -12.0) } else { ("start", 12.0) };
        let down = if py < top + 20.0 { 18.0 } else { -8.0 };
        body += &format!(
            "<path d=\"M{0:.1} {1:.1}l10 10m0 -10l-10 10\" stroke=\"#d55e00\" stroke-width=\"2.5\" fill=\"none\"/>\n\
             <text class=\"on\" x=\"{2:.1}\" y=\"{3:.1}\" text-anchor=\"{anchor}\" fill=\"#222\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\">{4} MPa</text>\n",
            px - 5.0,
            py - 5.0,
            px + side,
            py + down,
            brief(most)
        );
    }
    body += &format!("<text x=\"{:.1}\" y=\"{:.1}\">MPa</text>\n", right + 16.0, top + UNIT);
    body += &bands.bar([right + 16.0, top + BAR], (bottom - top - BAR).clamp(60.0, 320.0));
    section.picture(title, ["x", "y"], &body)
}

#[cfg(test)]
mod tests {
    use super::map_picture;
    use wearshape::{CellGrid, PressureMap, PressureResult};

    #[test]
    fn the_map_shows_the_largest_pressure_at_its_place() {
        let grid = CellGrid { degree: 1, triangle: false };
        let position = vec![[0.0, 0.0], [10.0, 0.0], [0.0, 5.0], [10.0, 5.0]];
        let map = PressureMap { grid, position, pressure: vec![1.0, 2.0, 3.0, 6.77] };
        let pressure = PressureResult { p_max: Some(6.77), p_max_at: Some([10.0, 5.0, 0.0]), ..PressureResult::default() };
        let picture = map_picture(&map, &pressure, "a < b");
        assert!(picture.contains(">6.77 MPa<") && picture.contains("a &lt; b") && picture.contains("role=\"img\""), "{picture}");
    }
}
