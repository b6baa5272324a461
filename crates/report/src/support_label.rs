//! The directions in which an edge is held, written beside it where nothing else is drawn.

use crate::sheet::{Sheet, SheetBox};

/// Width of a letter and height of a line (pixels).
const LETTER: [f64; 2] = [9.0, 13.0];
/// Distance of the words from their edge, which may be hatched: below or above it, and how much more to its sides (pixels).
const BESIDE: [f64; 2] = [14.0, 5.0];
/// How much farther away they may stand where there is no room beside the edge (pixels).
const FARTHER: [f64; 4] = [14.0, 28.0, 42.0, 56.0];

/// The words, and the places along the edge with the unit normals out of the body (pixels); none for an edge within the body.
pub(crate) struct SupportLabel {
    pub(crate) text: String,
    pub(crate) places: Vec<([f64; 2], Option<[f64; 2]>)>,
}

impl SupportLabel {
    /// Half the width and the height of the words.
    fn half(&self) -> [f64; 2] {
        [0.5 * LETTER[0] * self.text.chars().count() as f64, 0.5 * LETTER[1]]
    }

    /// Their middle where they begin so far beside a place along a direction.
    fn beside(&self, place: [f64; 2], [dx, dy]: [f64; 2], farther: f64) -> [f64; 2] {
        let [wide, high] = self.half();
        let far = farther + BESIDE[0] + (BESIDE[1] + wide) * dx.abs() + high * dy.abs();
        [place[0] + far * dx, place[1] + far * dy]
    }

    /// Where their middle may be: beside the edge from its middle to its ends, beyond its ends, farther away from it, and on its other side.
    fn candidates(&self, sheet: &Sheet) -> Vec<[f64; 2]> {
        let count = self.places.len();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|place| (2 * place + 1).abs_diff(count));
        let along = |side: f64, farther: f64| {
            let places = order.iter().map(|place| self.places[*place]);
            let middles = places.map(|(at, out)| self.beside(at, out.unwrap_or([1.0, 0.0]).map(|d| side * d), farther));
            middles.collect::<Vec<[f64; 2]>>()
        };
        let mut all = along(1.0, 0.0);
        if let [(first, _), (second, _), ..] = self.places.as_slice()
            && let [.., (before, _), (last, _)] = self.places.as_slice()
        {
            all.extend([(first, second), (last, before)].map(|(end, inner)| {
                let length = (end[0] - inner[0]).hypot(end[1] - inner[1]).max(1e-9);
                self.beside(*end, [0, 1].map(|k| (end[k] - inner[k]) / length), 0.0)
            }));
        }
        // On another body they would seem to be of that one.
        all.extend(FARTHER.iter().flat_map(|far| along(1.0, *far)).filter(|middle| !sheet.is_on_area(*middle)));
        all.extend(along(-1.0, 0.0));
        all
    }

    /// Writes the words at the first place that is free, or else where the least is drawn.
    pub(crate) fn put(&self, sheet: &mut Sheet) {
        let half = self.half();
        let around = |middle: &[f64; 2]| SheetBox { middle: *middle, half };
        let all = self.candidates(sheet);
        let free = all.iter().find(|middle| sheet.crowd(around(middle)) == 0);
        let Some(best) = free.or_else(|| all.iter().min_by_key(|middle| sheet.crowd(around(middle)))) else { return };
        // On a body the words stand on its colour, which is the same on dark paper.
        let class = if sheet.is_on_area(*best) { " class=\"on\"" } else { "" };
        let [x, y] = *best;
        sheet.sign(&format!("<text{class} x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>\n", y + 5.0, self.text));
        sheet.take_box(around(best));
    }
}

#[cfg(test)]
mod tests {
    use super::SupportLabel;
    use crate::sheet::Sheet;

    /// Where the words of an edge along the bottom of a sheet stand beside what was drawn before.
    fn written(before: fn(&mut Sheet)) -> [f64; 2] {
        let mut sheet = Sheet::new([[0.0, 0.0], [470.0, 400.0]].into_iter());
        before(&mut sheet);
        let edge = (0..20).map(|k| ([200.0 + 10.0 * f64::from(k), 300.0], Some([0.0, 1.0]))).collect();
        SupportLabel { text: "x, z".into(), places: edge }.put(&mut sheet);
        let svg = sheet.picture("t", &[]);
        let number = |name: &str| {
            let (_, rest) = svg
                .split_once("text-anchor=\"middle\">x, z")
                .map_or(("", ""), |(head, _)| head.rsplit_once(name).unwrap_or_default());
            rest.split('"').next().and_then(|number| number.parse().ok()).unwrap_or(f64::NAN)
        };
        [number(" x=\""), number(" y=\"")]
    }

    #[test]
    fn words_stand_beside_the_middle_of_their_edge_and_aside_where_something_is_drawn() {
        let [x, y] = written(|_| {});
        assert!((x - 295.0).abs() < 6.0 && y > 310.0 && y < 330.0, "{x} {y}");
        let [x, _] = written(|sheet| sheet.arrow([295.0, 300.0], [295.0, 340.0], "#000"));
        assert!((x - 295.0).abs() > 20.0 && (x - 295.0).abs() < 60.0, "{x}");
        // Arrows all along leave room beyond an end.
        let [x, _] = written(|sheet| {
            (0..20).for_each(|k| sheet.arrow([195.0 + 10.0 * f64::from(k), 310.0], [195.0 + 10.0 * f64::from(k), 340.0], "#000"))
        });
        assert!(!(190.0..=400.0).contains(&x), "{x}");
    }
}
