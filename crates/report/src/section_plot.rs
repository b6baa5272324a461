//! Pictures of a cross-section to scale: the frame, with or without axes, into which meshes and fields are drawn.

use crate::escape::escaped;
use crate::line_plot::ticks;

const LEFT: f64 = 72.0;
const TOP: f64 = 46.0;
const BOTTOM: f64 = 56.0;
/// Largest width and height of the drawing itself.
const ROOM: [f64; 2] = [620.0, 460.0];
/// The same without axes, and the margins then.
const BARE_ROOM: [f64; 2] = [570.0, 620.0];
const BARE_LEFT: f64 = 18.0;
const BARE_BOTTOM: f64 = 44.0;

/// A cross-section in millimetres on paper, both axes to the same scale.
pub struct Section {
    x: [f64; 2],
    z: [f64; 2],
    /// Pixels a millimetre.
    pub scale: f64,
    /// Room on the right for a legend.
    margin: f64,
    left: f64,
}

impl Section {
    /// The section that shows the given range with axes.
    pub fn new(x: [f64; 2], z: [f64; 2], margin: f64) -> Section {
        let scale = (ROOM[0] / (x[1] - x[0])).min(ROOM[1] / (z[1] - z[0]));
        Section { x, z, scale, margin, left: LEFT }
    }

    /// The section without axes: what it shows is not to scale with them.
    pub fn without_axes(x: [f64; 2], z: [f64; 2], margin: f64) -> Section {
        let scale = (BARE_ROOM[0] / (x[1] - x[0])).min(BARE_ROOM[1] / (z[1] - z[0]));
        Section { x, z, scale, margin, left: BARE_LEFT }
    }

    /// Pixels of a point in mm.
    pub fn place(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        [self.left + self.scale * (x - self.x[0]), TOP + self.scale * (self.z[1] - z)]
    }

    /// Right edge of the drawing and its top and bottom, in pixels.
    pub fn edges(&self) -> [f64; 3] {
        let [right, bottom] = self.place([self.x[1], self.z[0]]);
        [right, TOP, bottom]
    }

    /// The picture around a body of SVG, with axes named by the coordinates' symbols.
    pub fn picture(&self, title: &str, names: [&str; 2], body: &str) -> String {
        self.framed(title, BOTTOM, &format!("{body}{}", self.axes(names)))
    }

    /// The picture of a section without axes, with a remark below.
    pub fn remarked(&self, title: &str, remark: &str, body: &str) -> String {
        let [_, _, bottom] = self.edges();
        let y = bottom + 28.0;
        let remark =
            format!("<text class=\"small\" x=\"{BARE_LEFT}\" y=\"{y:.1}\" font-size=\"12\" fill=\"#555\">{remark}</text>\n");
        self.framed(title, BARE_BOTTOM, &format!("{body}{remark}"))
    }

    fn framed(&self, title: &str, below: f64, body: &str) -> String {
        let [right, _, bottom] = self.edges();
        // A narrow section still has room for its title.
        let width = (right + self.margin + 24.0).max(self.left + 10.0 * title.chars().count() as f64 + 24.0);
        let height = bottom + below;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" height=\"{height:.0}\" \
             font-family=\"'DejaVu Sans', Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"#222\" role=\"img\" aria-label=\"{0}\">\n\
             <title>{0}</title>\n<rect width=\"{width:.0}\" height=\"{height:.0}\" fill=\"#fff\"/>\n\
             <text class=\"title\" x=\"{1}\" y=\"26\" font-size=\"15\" font-weight=\"bold\">{0}</text>\n{body}</svg>\n",
            escaped(title),
            self.left
        )
    }

    fn axes(&self, names: [&str; 2]) -> String {
        let [right, _, bottom] = self.edges();
        let mut out = String::new();
        out +=
            &format!("<path d=\"M{LEFT} {TOP}V{bottom:.1}H{right:.1}\" fill=\"none\" stroke=\"#444\" stroke-width=\"1.2\"/>\n");
        let count = |length: f64| ((length * self.scale / 90.0) as usize).clamp(2, 8);
        for (value, label) in ticks(self.x, count(self.x[1] - self.x[0])) {
            let px = self.place([value, 0.0])[0];
            out += &format!("<path d=\"M{px:.1} {bottom:.1}v5\" stroke=\"#444\"/>");
            out += &format!("<text x=\"{px:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{label}</text>\n", bottom + 19.0);
        }
        for (value, label) in ticks(self.z, count(self.z[1] - self.z[0])) {
            let py = self.place([0.0, value])[1];
            out += &format!("<path d=\"M{LEFT} {py:.1}h-5\" stroke=\"#444\"/>");
            out += &format!("<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>\n", LEFT - 9.0, py + 4.5);
        }
        out += &format!(
            "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{} (mm)</text>\n",
            0.5 * (LEFT + right),
            bottom + 42.0,
            names[0]
        );
        out += &format!(
            "<text transform=\"translate(18 {:.1}) rotate(-90)\" text-anchor=\"middle\">{} (mm)</text>\n",
            0.5 * (TOP + bottom),
            names[1]
        );
        out
    }
}
