//! Pins and rollers in the drawing of a scene.

use wearshape::BodyOutline;

use crate::sheet::Sheet;

/// Pixels that a pin may lie beyond the drawing and still be drawn in its place.
const BEYOND: f64 = 2.0;

/// A pin that would leave the bodies small is not part of the picture.
pub(crate) fn is_near(pin: [f64; 2], points: impl Iterator<Item = [f64; 2]>) -> bool {
    let [mut low, mut high] = [[f64::MAX; 2], [f64::MIN; 2]];
    for p in points {
        for k in 0..2 {
            (low[k], high[k]) = (low[k].min(p[k]), high[k].max(p[k]));
        }
    }
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    (0..2).all(|k| pin[k] > low[k] - 0.5 * size && pin[k] < high[k] + 0.5 * size)
}

/// An edge that turns about a pin: the edge, the pin on its stand, and the lines that tie them; of a far pin the way to it.
pub(crate) fn pin(sheet: &mut Sheet, body: &BodyOutline, edge: &str, at: [f64; 2], near: bool) {
    let lines = body.edge(edge).to_vec();
    lines.iter().for_each(|line| sheet.line(line, "#333", 3.2, ""));
    let ends: Vec<[f64; 2]> = lines.iter().flat_map(|line| line.first().into_iter().chain(line.last())).copied().collect();
    let Some(start) = ends.first().copied() else { return };
    if !near {
        let [x, y] = sheet.at(start);
        let [fx, fy] = sheet.at(at);
        let far = (fx - x).hypot(fy - y);
        let to = [x + 60.0 * (fx - x) / far, y + 60.0 * (fy - y) / far];
        sheet.arrow([x, y], to, "#333");
        sheet.sign(&format!("<text x=\"{:.1}\" y=\"{:.1}\">pin at ({}, {})</text>\n", to[0] + 6.0, to[1], at[0], at[1]));
        return;
    }
    for end in &ends {
        let [a, b] = [*end, at].map(|p| sheet.at(p));
        if (a[0] - b[0]).hypot(a[1] - b[1]) > BEYOND {
            sheet.line(&[*end, at], "#333", 1.0, "3 3");
        }
    }
    let [x, y] = sheet.at(at);
    // The stand of the pin: a triangle on hatched ground.
    sheet.sign(&format!(
        "<path class=\"ink\" d=\"M{:.1} {:.1}l-9 -15h18z\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.4\"/>\n",
        x, y
    ));
    sheet.hatch(&[-6.0, 0.0, 6.0].map(|off| [x + off, y - 15.0]), [0.0, -1.0]);
    sheet.sign(&format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\" fill=\"#fff\" stroke=\"#333\" stroke-width=\"1.8\"/>\n"));
    sheet.sign(&format!("<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">pin</text>\n", x - 13.0, y - 8.0));
}

/// An edge on a roller: wheels between the edge and the track along which it is free to run.
pub(crate) fn roller(sheet: &mut Sheet, edge: &[Vec<[f64; 2]>], out: [f64; 2], angle: f64) {
    edge.iter().for_each(|line| sheet.line(line, "#333", 3.2, ""));
    let points: Vec<[f64; 2]> = edge.iter().flatten().map(|p| sheet.at(*p)).collect();
    let count = points.len().max(1) as f64;
    let middle: [f64; 2] = std::array::from_fn(|k| points.iter().map(|p| p[k]).sum::<f64>() / count);
    // Upwards in mm is downwards in pixels; across the track towards the outside of the body.
    let along = [angle.cos(), -angle.sin()];
    let across = [-along[1], along[0]];
    let side = if across[0] * out[0] + across[1] * out[1] < 0.0 { -1.0 } else { 1.0 };
    let across = across.map(|x| side * x);
    let place = |off: f64, far: f64| [0, 1].map(|k| middle[k] + off * along[k] + far * across[k]);
    for off in [-11.0, 0.0, 11.0] {
        let [x, y] = place(off, 7.0);
        sheet.sign(&format!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\" fill=\"#fff\" stroke=\"#333\" stroke-width=\"1.6\"/>\n"
        ));
    }
    let ([ax, ay], [bx, by]) = (place(-22.0, 12.5), place(22.0, 12.5));
    sheet.sign(&format!(
        "<path class=\"ink\" d=\"M{ax:.1} {ay:.1}L{bx:.1} {by:.1}\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.6\"/>\n"
    ));
    sheet.hatch(&[-16.0, -5.0, 6.0, 17.0].map(|off| place(off, 12.5)), across);
}
