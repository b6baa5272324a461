//! Places along the edges of drawn bodies, and the way out of the body there.

use wearshape::BodyOutline;

use crate::sheet::{Sheet, is_within};

/// Whether a place lies in a body.
fn within(body: &BodyOutline, place: [f64; 2]) -> bool {
    body.areas.iter().any(|area| is_within(&area.loops, place))
}

/// Points along lines about every so many pixels, with the unit normal out of the body, in pixels; none for the normal within it.
pub(crate) fn along(sheet: &Sheet, body: &BodyOutline, lines: &[Vec<[f64; 2]>], every: f64) -> Vec<([f64; 2], Option<[f64; 2]>)> {
    let mut out = Vec::new();
    for pair in lines.iter().flat_map(|line| line.windows(2)) {
        let [a, b] = [sheet.at(pair[0]), sheet.at(pair[1])];
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        let count = ((length / every).round() as usize).max(1);
        if length < 1e-9 {
            continue;
        }
        let normal = [(b[1] - a[1]) / length, -(b[0] - a[0]) / length];
        let middle = [0.5 * (pair[0][0] + pair[1][0]), 0.5 * (pair[0][1] + pair[1][1])];
        let off = 1e-3 * (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        // In mm the z axis points up.
        let inside = |side: f64| within(body, [middle[0] + side * off * normal[0], middle[1] - side * off * normal[1]]);
        let outwards = match (inside(1.0), inside(-1.0)) {
            (false, true) => Some(normal),
            (true, false) => Some(normal.map(|x| -x)),
            _ => None,
        };
        out.extend((0..count).map(|k| {
            let t = (k as f64 + 0.5) / count as f64;
            ([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])], outwards)
        }));
    }
    out
}
