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
}

impl Sheet {
    /// A sheet that shows all of some points (mm).
    pub(crate) fn new(points: impl Iterator<Item = [f64; 2]>) -> Sheet {
        let (low, high) = points.fold(([f64::MAX; 2], [f64::MIN; 2]), |(low, high), p| {
            ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
        });
        let scale = (ROOM[0] / (high[0] - low[0])).min(ROOM[1] / (high[1] - low[1]));
        let left = 0.5 * (WIDTH - scale * (high[0] - low[0]));
        Sheet { low, high, scale, left, body: String::new() }
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
        self.body +=
            &format!("<path d=\"{path}\" fill=\"{fill}\" fill-rule=\"evenodd\" stroke=\"{fill}\" stroke-width=\"0.6\"/>\n");
    }

    /// A line in mm.
    pub(crate) fn line(&mut self, points: &[[f64; 2]], colour: &str, width: f64, dash: &str) {
        let dash = if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
        let path = self.path(points, false);
        self.body += &format!("<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"{dash}/>\n");
    }

    /// An arrow between pixels.
    pub(crate) fn arrow(&mut self, from: [f64; 2], to: [f64; 2], colour: &str) {
        self.body += &arrow(from, to, colour);
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
        let strokes: String = points
            .iter()
            .map(|[x, y]| {
                let along = [-out[1], out[0]];
                format!("M{x:.1} {y:.1}l{:.1} {:.1}", 9.0 * out[0] - 6.0 * along[0], 9.0 * out[1] - 6.0 * along[1])
            })
            .collect();
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
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = dx.hypot(dy).max(1e-9);
    let [ux, uy] = [dx / length, dy / length];
    let corner = |side: f64| [to[0] - 10.0 * ux - 4.5 * side * uy, to[1] - 10.0 * uy + 4.5 * side * ux];
    let ([a, b], [c, d]) = (corner(1.0), corner(-1.0));
    let tip = [to[0] + ux, to[1] + uy];
    format!("<path d=\"M{:.1} {:.1}L{a:.1} {b:.1}L{c:.1} {d:.1}Z\" fill=\"{colour}\"/>\n", tip[0], tip[1])
}
