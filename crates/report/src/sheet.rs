//! A sheet to scale for drawings of scenes: lines, areas and arrows in mm, signs in pixels, and a legend below.

use crate::escape::escaped;
use crate::wrapped::wrapped;

/// Width of the sheet and of the drawing on it, and the most the drawing is high (pixels).
const WIDTH: f64 = 600.0;
const ROOM: [f64; 2] = [470.0, 400.0];
/// Room above the drawing for arrows, below the title.
const ABOVE: f64 = 56.0;
/// Letters in a line of the title and of the legend, and the distance of lines.
const LETTERS: [usize; 2] = [52, 48];
const ROW: f64 = 23.0;

/// What stands before a line of the legend.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Mark {
    /// A filled area.
    Fill(&'static str),
    /// A thick line.
    Line(&'static str),
    /// An arrow.
    Arrow(&'static str),
    /// An arrow that goes into the sheet.
    Into(&'static str),
    /// A hatched line.
    Hatch,
    /// Nothing.
    None,
}

/// A sheet under construction.
pub(crate) struct Sheet {
    low: [f64; 2],
    high: [f64; 2],
    scale: f64,
    left: f64,
    body: String,
    /// Points of what is drawn in lines, from which words stay away (pixels).
    taken: Vec<[f64; 2]>,
    /// The lines around the areas, an area each, and its holes (pixels).
    areas: Vec<Vec<Vec<[f64; 2]>>>,
}

/// A part of the sheet (pixels).
#[derive(Clone, Copy)]
pub(crate) struct SheetBox {
    pub(crate) middle: [f64; 2],
    /// Half its width and its height.
    pub(crate) half: [f64; 2],
}

/// Distance of the points that stand for a line, and how far words stay away from them to the sides and up and down (pixels).
const STEP: f64 = 3.0;
const APART: [f64; 2] = [9.0, 3.0];
/// Room below the drawing, above the legend.
const BELOW: f64 = 31.0;

impl Sheet {
    /// A sheet that shows all of some points (mm).
    pub(crate) fn new(points: impl Iterator<Item = [f64; 2]>) -> Sheet {
        let (low, high) = points.fold(([f64::MAX; 2], [f64::MIN; 2]), |(low, high), p| {
            ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
        });
        let scale = (ROOM[0] / (high[0] - low[0])).min(ROOM[1] / (high[1] - low[1]));
        let left = 0.5 * (WIDTH - scale * (high[0] - low[0]));
        Sheet { low, high, scale, left, body: String::new(), taken: Vec::new(), areas: Vec::new() }
    }

    /// Pixels of a place in mm; the title is not counted.
    pub(crate) fn at(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        [self.left + self.scale * (x - self.low[0]), ABOVE + self.scale * (self.high[1] - z)]
    }

    fn path(&self, points: &[[f64; 2]], closed: bool) -> String {
        let places: Vec<String> = points.iter().map(|p| self.at(*p)).map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
        format!("M{}{}", places.join("L"), if closed { "Z" } else { "" })
    }

    /// Filled areas within closed lines.
    pub(crate) fn area(&mut self, loops: &[Vec<[f64; 2]>], fill: &str) {
        // Areas that share a side are drawn one by one; a hole is a line within another of the same area.
        let path: String = loops.iter().map(|line| self.path(line, true)).collect();
        self.areas.push(loops.iter().map(|line| line.iter().map(|p| self.at(*p)).collect()).collect());
        self.body +=
            &format!("<path d=\"{path}\" fill=\"{fill}\" fill-rule=\"evenodd\" stroke=\"{fill}\" stroke-width=\"0.6\"/>\n");
    }

    /// A line in mm.
    pub(crate) fn line(&mut self, points: &[[f64; 2]], colour: &str, width: f64, dash: &str) {
        let dash = if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
        let path = self.path(points, false);
        points.windows(2).for_each(|pair| self.take(self.at(pair[0]), self.at(pair[1])));
        self.body += &format!("<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"{dash}/>\n");
    }

    /// An arrow between pixels.
    pub(crate) fn arrow(&mut self, from: [f64; 2], to: [f64; 2], colour: &str) {
        self.take(from, to);
        let [left, right] = head_corners(from, to);
        self.take(left, right);
        self.body += &arrow(from, to, colour);
    }

    /// Keeps words away from a line between pixels.
    pub(crate) fn take(&mut self, from: [f64; 2], to: [f64; 2]) {
        let count = ((to[0] - from[0]).hypot(to[1] - from[1]) / STEP).ceil().max(1.0) as usize;
        let at = |k: usize| [0, 1].map(|c| from[c] + (to[c] - from[c]) * k as f64 / count as f64);
        self.taken.extend((0..=count).map(at));
    }

    /// Keeps words away from others.
    pub(crate) fn take_box(&mut self, SheetBox { middle: [x, y], half: [wide, high] }: SheetBox) {
        [-high, 0.0, high].into_iter().for_each(|off| self.take([x - wide, y + off], [x + wide, y + off]));
    }

    /// Whether a place (pixels) lies on an area.
    pub(crate) fn is_on_area(&self, place: [f64; 2]) -> bool {
        self.areas.iter().any(|loops| is_within(loops, place))
    }

    /// How much is drawn where words would stand; more than all of it beyond the sheet.
    pub(crate) fn crowd(&self, SheetBox { middle, half }: SheetBox) -> usize {
        let bottom = self.at(self.low)[1] + BELOW;
        let beyond =
            middle[0] - half[0] < 0.0 || middle[0] + half[0] > WIDTH || middle[1] - half[1] < 0.0 || middle[1] + half[1] > bottom;
        let near = |point: &&[f64; 2]| (0..2).all(|k| (point[k] - middle[k]).abs() < half[k] + APART[k]);
        self.taken.iter().filter(near).count() + if beyond { self.taken.len() + 1 } else { 0 }
    }

    /// An arc with a head, anti-clockwise for a sweep greater than 0, about a centre in mm with a radius in mm.
    pub(crate) fn turning(&mut self, centre: [f64; 2], radius: f64, sweep: f64, colour: &str) {
        let from = 0.5 * std::f64::consts::PI - 0.5 * sweep;
        let point = |k: usize| {
            let t = from + sweep * k as f64 / 24.0;
            [centre[0] + radius * t.cos(), centre[1] + radius * t.sin()]
        };
        let points: Vec<[f64; 2]> = (0..=24).map(point).collect();
        self.line(&points, colour, 2.2, "");
        let [before, last] = [self.at(points[23]), self.at(points[24])];
        self.body += &head(before, last, colour);
    }

    /// A sign in pixels.
    pub(crate) fn sign(&mut self, svg: &str) {
        self.body += svg;
    }

    /// A short hatch at pixels, away from the body along a unit vector.
    pub(crate) fn hatch(&mut self, points: &[[f64; 2]], out: [f64; 2]) {
        let along = [-out[1], out[0]];
        let [right, down] = [0, 1].map(|k| 9.0 * out[k] - 6.0 * along[k]);
        points.iter().for_each(|[x, y]| self.take([*x, *y], [x + right, y + down]));
        let strokes: String = points.iter().map(|[x, y]| format!("M{x:.1} {y:.1}l{right:.1} {down:.1}")).collect();
        self.body += &format!("<path class=\"ink\" d=\"{strokes}\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.2\"/>\n");
    }

    /// The picture with its title and a legend.
    pub(crate) fn picture(self, title: &str, legend: &[(Mark, String)]) -> String {
        let lines = wrapped(title, LETTERS[0]);
        let down = 22.0 * lines.len() as f64;
        let bottom = self.at(self.low)[1] + 30.0;
        let mut rows = String::new();
        let mut y = bottom + 16.0;
        for (mark, text) in legend {
            rows += &drawn(mark, y - 5.0);
            for line in wrapped(text, LETTERS[1]) {
                rows += &format!("<text x=\"56\" y=\"{y:.1}\">{}</text>\n", escaped(&line));
                y += ROW;
            }
        }
        let height = y + down;
        let heading: String = lines
            .iter()
            .enumerate()
            .map(|(row, line)| {
                format!(
                    "<text class=\"title\" x=\"18\" y=\"{}\" font-size=\"17\" font-weight=\"bold\">{}</text>\n",
                    26.0 + 22.0 * row as f64,
                    escaped(line)
                )
            })
            .collect();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" width=\"{WIDTH}\" height=\"{height:.0}\" role=\"img\" aria-label=\"{0}\" \
             font-family=\"'DejaVu Sans', Helvetica, Arial, sans-serif\" font-size=\"15\" fill=\"#222\">\n<title>{0}</title>\n\
             <rect class=\"paper\" width=\"{WIDTH}\" height=\"{height:.0}\" fill=\"#fff\"/>\n{heading}<g transform=\"translate(0 {down})\">\n{1}{rows}</g>\n</svg>\n",
            escaped(title),
            self.body
        )
    }
}

/// Whether a place lies within closed lines by the rule of even and odd.
pub(crate) fn is_within(loops: &[Vec<[f64; 2]>], [x, z]: [f64; 2]) -> bool {
    let crossings = |line: &Vec<[f64; 2]>| {
        let ends = line.iter().zip(line.iter().cycle().skip(1));
        ends.filter(|(a, b)| (a[1] > z) != (b[1] > z) && x < a[0] + (z - a[1]) / (b[1] - a[1]) * (b[0] - a[0])).count()
    };
    loops.iter().map(crossings).sum::<usize>() % 2 == 1
}

/// A mark before a line of the legend.
fn drawn(mark: &Mark, y: f64) -> String {
    match mark {
        Mark::Fill(fill) => {
            format!("<rect x=\"18\" y=\"{:.1}\" width=\"28\" height=\"14\" fill=\"{fill}\" stroke=\"#555\"/>\n", y - 7.0)
        }
        Mark::Line(colour) => format!("<path d=\"M18 {y:.1}h28\" stroke=\"{colour}\" stroke-width=\"4\"/>\n"),
        Mark::Arrow(colour) => arrow([18.0, y], [46.0, y], colour),
        Mark::Into(colour) => into_sheet([32.0, y], 8.0, colour),
        Mark::None => String::new(),
        Mark::Hatch => format!(
            "<path class=\"ink\" d=\"M18 {0:.1}h28M22 {0:.1}l-5 8M30 {0:.1}l-5 8M38 {0:.1}l-5 8M46 {0:.1}l-5 8\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.2\"/>\n",
            y - 3.0
        ),
    }
}

/// An arrow that goes into the sheet, seen along it: a ring with a cross.
pub(crate) fn into_sheet([x, y]: [f64; 2], radius: f64, colour: &str) -> String {
    let cross = radius * std::f64::consts::FRAC_1_SQRT_2;
    format!(
        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2.2\"/>\n\
         <path d=\"M{0:.1} {1:.1}L{2:.1} {3:.1}M{0:.1} {3:.1}L{2:.1} {1:.1}\" stroke=\"{colour}\" stroke-width=\"2.2\"/>\n",
        x - cross,
        y - cross,
        x + cross,
        y + cross
    )
}

fn arrow(from: [f64; 2], to: [f64; 2], colour: &str) -> String {
    let [[a, b], [c, d]] = [from, to];
    format!("<path d=\"M{a:.1} {b:.1}L{c:.1} {d:.1}\" stroke=\"{colour}\" stroke-width=\"2.2\"/>\n{}", head(from, to, colour))
}

/// The head of an arrow that ends at the second point.
fn head(from: [f64; 2], to: [f64; 2], colour: &str) -> String {
    let [ux, uy] = along(from, to);
    let [[a, b], [c, d]] = head_corners(from, to);
    let tip = [to[0] + ux, to[1] + uy];
    format!("<path d=\"M{:.1} {:.1}L{a:.1} {b:.1}L{c:.1} {d:.1}Z\" fill=\"{colour}\"/>\n", tip[0], tip[1])
}

/// The corners of a head on both sides of its line.
fn head_corners(from: [f64; 2], to: [f64; 2]) -> [[f64; 2]; 2] {
    let [ux, uy] = along(from, to);
    [1.0, -1.0].map(|side| [to[0] - 10.0 * ux - 4.5 * side * uy, to[1] - 10.0 * uy + 4.5 * side * ux])
}

/// The unit vector from a point to another.
fn along(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = dx.hypot(dy).max(1e-9);
    [dx / length, dy / length]
}
