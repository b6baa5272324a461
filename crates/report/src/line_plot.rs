//! Line plots as SVG, for print and screen: no script, no network, no font file.

use crate::escape::escaped;
use crate::reach::{Reach, reach};
use crate::wrapped::wrapped;

/// How an axis counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// Evenly.
    Linear,
    /// In decades.
    Logarithmic,
}

/// One curve.
#[derive(Debug, Clone)]
pub struct Series {
    /// Name in the legend; none for a single curve.
    pub name: String,
    /// Points; a point that is not finite interrupts the curve.
    pub points: Vec<(f64, f64)>,
    /// Marks at the points.
    pub marks: bool,
    /// Dashed line.
    pub dashed: bool,
}

/// A plot.
#[derive(Debug, Clone)]
pub struct LinePlot {
    /// Line above the plot.
    pub title: String,
    /// Name and unit along x.
    pub x_label: String,
    /// Name and unit along y.
    pub y_label: String,
    /// Kind of the axes along x and y.
    pub axes: [Axis; 2],
    /// Whether y begins at zero when all values are positive.
    pub from_zero: bool,
    /// The curves.
    pub series: Vec<Series>,
}

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 450.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 48.0;
const BOTTOM: f64 = 62.0;
/// Most letters in a line of the title.
const TITLE: usize = 66;
/// Width of a letter of the numbers at the axes.
const LETTER: f64 = 8.3;
/// Colour of named parts of the x axis.
const ZONE: &str = "#e69f00";
/// Colours that colour-blind readers tell apart (Okabe and Ito).
const COLOURS: [&str; 8] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000", "#7f7f7f"];

struct Scale {
    kind: Axis,
    low: f64,
    high: f64,
    ticks: Vec<f64>,
}

impl Scale {
    fn new(values: impl Iterator<Item = f64>, kind: Axis, from_zero: bool, count: usize) -> Scale {
        let usable = |v: &f64| v.is_finite() && (kind == Axis::Linear || *v > 0.0);
        let (mut low, mut high) = values.filter(usable).fold((f64::MAX, f64::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)));
        if low > high {
            (low, high) = if kind == Axis::Linear { (0.0, 1.0) } else { (0.1, 1.0) };
        }
        if kind == Axis::Logarithmic {
            let (from, to) = (low.log10().floor() as i32, high.log10().ceil() as i32);
            let to = if to == from { from + 1 } else { to };
            let step = ((to - from) / count as i32).max(1);
            let ticks = (from..=to).step_by(step as usize).map(|e| 10f64.powi(e)).collect();
            return Scale { kind, low: 10f64.powi(from), high: 10f64.powi(to), ticks };
        }
        if from_zero && low >= 0.0 {
            low = 0.0;
        }
        // A curve that is constant to round-off is drawn as constant.
        if high - low <= 1e-9 * high.abs().max(low.abs()) {
            let half = if high == 0.0 { 1.0 } else { 0.1 * high.abs() };
            (low, high) = (low - half, high + half);
        }
        let raw = (high - low) / count as f64;
        let magnitude = 10f64.powf(raw.log10().floor());
        let step = [1.0, 2.0, 2.5, 5.0, 10.0].map(|m| m * magnitude).into_iter().find(|s| *s >= raw * 0.999);
        let step = step.unwrap_or(10.0 * magnitude);
        let (from, to) = ((low / step + 1e-9).floor(), (high / step - 1e-9).ceil());
        let ticks = (from as i64..=to as i64).map(|i| i as f64 * step).collect();
        Scale { kind, low: from * step, high: to * step, ticks }
    }

    fn share(&self, value: f64) -> f64 {
        match self.kind {
            Axis::Linear => (value - self.low) / (self.high - self.low),
            Axis::Logarithmic => (value / self.low).log10() / (self.high / self.low).log10(),
        }
    }

    fn label(&self, tick: f64) -> String {
        if self.kind == Axis::Logarithmic {
            let exponent = tick.log10().round() as i32;
            if (-2..=3).contains(&exponent) {
                return plain(tick);
            }
            return format!("10<tspan dy=\"-5\" font-size=\"10\">{}</tspan>", plain(f64::from(exponent)));
        }
        let step = self.ticks.get(1).map_or(1.0, |second| second - self.ticks[0]);
        let largest = self.low.abs().max(self.high.abs());
        if !(1e-3..1e6).contains(&largest) {
            return format!("{tick:.2e}").replace('-', "\u{2212}");
        }
        let decimals = (-(step.log10() - 1e-9).floor()).max(0.0) as usize;
        let fine = (step * 10f64.powi(decimals as i32)).fract().abs() > 1e-6;
        format!("{tick:.*}", decimals + usize::from(fine)).replace('-', "\u{2212}")
    }
}

/// Round values of a range with their labels.
pub(crate) fn ticks(range: [f64; 2], count: usize) -> Vec<(f64, String)> {
    let scale = Scale::new(range.into_iter(), Axis::Linear, false, count);
    let size = range[1] - range[0];
    let within = |tick: &f64| *tick >= range[0] - 1e-9 * size && *tick <= range[1] + 1e-9 * size;
    scale.ticks.iter().filter(|tick| within(tick)).map(|tick| (*tick, scale.label(*tick))).collect()
}

fn plain(value: f64) -> String {
    format!("{value}").replace('-', "\u{2212}")
}

/// A part of the x axis with a name: where a contact sticks.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Zone {
    /// From and to along x.
    pub(crate) range: [f64; 2],
    /// Its name.
    pub(crate) name: &'static str,
}

/// Where the y axis of a plot is cut; none where it holds its curves.
pub(crate) fn cut(plot: &LinePlot) -> Option<Reach> {
    let linear = plot.axes == [Axis::Linear; 2];
    reach(plot.series.iter().map(|series| series.points.as_slice())).filter(|_| linear)
}

/// Draws a plot.
pub fn line_plot(plot: &LinePlot) -> String {
    zoned_plot(plot, &[])
}

/// Draws a plot with named parts of its x axis.
pub(crate) fn zoned_plot(plot: &LinePlot, zones: &[Zone]) -> String {
    let all = |pick: fn(&(f64, f64)) -> f64| plot.series.iter().flat_map(move |s| s.points.iter().map(pick));
    let x = Scale::new(all(|p| p.0), plot.axes[0], false, 7);
    let x = Scale { ..tight(x, all(|p| p.0)) };
    let cut = cut(plot);
    let high = cut.map_or(f64::INFINITY, |cut| cut.high);
    let y = Scale::new(all(|p| p.1).map(|y| y.min(high)), plot.axes[1], plot.from_zero, 6);
    let place = |point: (f64, f64)| {
        let px = LEFT + x.share(point.0) * (WIDTH - LEFT - RIGHT);
        let py = HEIGHT - BOTTOM - y.share(if cut.is_some() { point.1.min(y.high) } else { point.1 }) * (HEIGHT - TOP - BOTTOM);
        (px, py)
    };
    let legend = Legend::new(&plot.series, &place);
    let width = WIDTH + if legend.beside { legend.width + 12.0 } else { beyond(&x, plot.axes[0]) };
    let (mut out, end) = head(&plot.title, width);
    let (bottom, right) = (HEIGHT - BOTTOM, WIDTH - RIGHT);
    for zone in zones {
        let [from, to] = zone.range.map(|at| place((at, y.low)).0);
        out += &format!(
            "<path d=\"M{from:.2} {TOP}H{to:.2}V{bottom}H{from:.2}Z\" fill=\"{ZONE}\" fill-opacity=\"0.22\"/>\n\
             <text x=\"{:.2}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
            0.5 * (from + to),
            bottom - 8.0,
            zone.name
        );
    }
    out += "<g stroke=\"#e3e3e3\" stroke-width=\"1\">\n";
    for tick in x.ticks.iter().filter(|t| inside(x.share(**t))) {
        let px = place((*tick, y.low)).0;
        out += &format!("<path d=\"M{px:.2} {TOP}V{bottom}\"/>\n");
    }
    for tick in &y.ticks {
        let py = place((x.low, *tick)).1;
        out += &format!("<path d=\"M{LEFT} {py:.2}H{right}\"/>\n");
    }
    out += "</g>\n<g>\n";
    for tick in x.ticks.iter().filter(|t| inside(x.share(**t))) {
        let px = place((*tick, y.low)).0;
        out += &format!("<text x=\"{px:.2}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", bottom + 19.0, x.label(*tick));
    }
    for tick in &y.ticks {
        let py = place((x.low, *tick)).1 + 4.5;
        out += &format!("<text x=\"{}\" y=\"{py:.2}\" text-anchor=\"end\">{}</text>\n", LEFT - 8.0, y.label(*tick));
    }
    let (middle_x, middle_y) = (0.5 * (LEFT + right), 0.5 * (TOP + bottom));
    out += &format!("<text x=\"{middle_x}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", HEIGHT - 18.0, escaped(&plot.x_label));
    out += &format!(
        "<text transform=\"translate(20 {middle_y}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n</g>\n",
        escaped(&plot.y_label)
    );
    out += &format!("<path d=\"M{LEFT} {TOP}V{bottom}H{right}\" fill=\"none\" stroke=\"#444\" stroke-width=\"1.2\"/>\n");
    for (number, series) in plot.series.iter().enumerate() {
        out += &curve(series, COLOURS[number % COLOURS.len()], &place, plot.axes);
    }
    out += &legend.draw(&plot.series);
    if let Some(cut) = cut {
        out += &format!("<text x=\"{}\" y=\"{}\" font-size=\"12\" fill=\"#555\">{}</text>\n", LEFT + 8.0, TOP + 14.0, cut.note());
    }
    out + end
}

/// Room that the last number along x takes beyond the picture; exponents are short.
fn beyond(x: &Scale, kind: Axis) -> f64 {
    let last = x.ticks.iter().rev().find(|tick| inside(x.share(**tick)) && kind == Axis::Linear);
    let end = |tick: &f64| LEFT + x.share(*tick) * (WIDTH - LEFT - RIGHT) + 0.5 * LETTER * x.label(*tick).chars().count() as f64;
    last.map_or(0.0, |tick| (end(tick) - WIDTH).ceil().max(0.0))
}

/// The beginning of the picture with its title in as many lines as it takes, and its end.
fn head(title: &str, width: f64) -> (String, &'static str) {
    let lines = wrapped(title, TITLE);
    let below = 19.0 * (lines.len() - 1) as f64;
    let height = HEIGHT + below;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         role=\"img\" aria-label=\"{0}\" \
         font-family=\"'DejaVu Sans', Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"#222\">\n\
         <title>{0}</title>\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n",
        escaped(title)
    );
    for (row, line) in lines.iter().enumerate() {
        let y = 26.0 + 19.0 * row as f64;
        out += &format!("<text x=\"{LEFT}\" y=\"{y}\" font-size=\"15\" font-weight=\"bold\">{}</text>\n", escaped(line));
    }
    if lines.len() == 1 {
        return (out, "</svg>\n");
    }
    (out + &format!("<g transform=\"translate(0 {below})\">\n"), "</g>\n</svg>\n")
}

/// Along x the curve fills the frame: the scale ends with the data, ticks beyond are dropped.
fn tight(scale: Scale, values: impl Iterator<Item = f64>) -> Scale {
    if scale.kind == Axis::Logarithmic {
        return scale;
    }
    let (low, high) = values.filter(|v| v.is_finite()).fold((f64::MAX, f64::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)));
    if high > low { Scale { low, high, ..scale } } else { scale }
}

fn inside(share: f64) -> bool {
    (-1e-9..=1.0 + 1e-9).contains(&share)
}

fn curve(series: &Series, colour: &str, place: &impl Fn((f64, f64)) -> (f64, f64), axes: [Axis; 2]) -> String {
    let drawable = |p: &(f64, f64)| {
        p.0.is_finite() && p.1.is_finite() && (axes[0] == Axis::Linear || p.0 > 0.0) && (axes[1] == Axis::Linear || p.1 > 0.0)
    };
    let mut path = String::new();
    let mut pen_down = false;
    let mut marks = String::new();
    for point in &series.points {
        if !drawable(point) {
            pen_down = false;
            continue;
        }
        let (px, py) = place(*point);
        path += &format!("{}{px:.2} {py:.2}", if pen_down { "L" } else { "M" });
        pen_down = true;
        if series.marks {
            marks += &format!("<circle cx=\"{px:.2}\" cy=\"{py:.2}\" r=\"3.2\"/>");
        }
    }
    let dash = if series.dashed { " stroke-dasharray=\"7 5\"" } else { "" };
    let line =
        format!("<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\" stroke-linejoin=\"round\"{dash}/>\n");
    if marks.is_empty() { line } else { format!("{line}<g fill=\"{colour}\">{marks}</g>\n") }
}

/// Where the names of the curves stand: in a corner that no curve touches, beside the plot when there is none or they are many.
struct Legend {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    beside: bool,
}

/// Pixels of a curve, about every four of them: a line between points far apart is drawn as well.
fn dense(points: &[(f64, f64)], place: &impl Fn((f64, f64)) -> (f64, f64)) -> Vec<(f64, f64)> {
    // What a logarithmic axis cannot show has no place.
    let places: Vec<(f64, f64)> =
        points.iter().map(|point| place(*point)).filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
    let between = |pair: &[(f64, f64)]| {
        let [(ax, ay), (bx, by)] = [pair[0], pair[1]];
        let count = ((bx - ax).hypot(by - ay) / 4.0).ceil() as usize;
        (1..count).map(move |k| k as f64 / count as f64).map(move |t| (ax + t * (bx - ax), ay + t * (by - ay)))
    };
    places.windows(2).flat_map(between).chain(places.iter().copied()).collect()
}

/// Names that still find room in a corner.
const NAMES_INSIDE: usize = 6;

impl Legend {
    fn new(series: &[Series], place: &impl Fn((f64, f64)) -> (f64, f64)) -> Legend {
        let longest = series.iter().map(|series| series.name.chars().count()).max().unwrap_or(0);
        let width = if longest == 0 { 0.0 } else { 44.0 + 7.4 * longest as f64 };
        let height = 10.0 + 19.0 * series.len() as f64;
        let (right, bottom) = (WIDTH - RIGHT - width - 6.0, HEIGHT - BOTTOM - height - 6.0);
        let corners = [[right, TOP + 6.0], [LEFT + 8.0, TOP + 6.0], [right, bottom], [LEFT + 8.0, bottom]];
        let drawn: Vec<(f64, f64)> = series.iter().flat_map(|series| dense(&series.points, place)).collect();
        let touched = |[left, top]: &[f64; 2]| {
            let within = |(px, py): &&(f64, f64)| {
                *px > left - 6.0 && *px < left + width + 6.0 && *py > top - 6.0 && *py < top + height + 6.0
            };
            drawn.iter().filter(within).count()
        };
        let free = corners.into_iter().find(|corner| touched(corner) == 0);
        let [left, top] = free.unwrap_or(corners[0]);
        if width > 0.0 && (free.is_none() || series.len() > NAMES_INSIDE) {
            return Legend { left: WIDTH - RIGHT + 12.0, top: TOP, width, height, beside: true };
        }
        Legend { left, top, width, height, beside: false }
    }

    fn draw(&self, series: &[Series]) -> String {
        if self.width == 0.0 {
            return String::new();
        }
        let Legend { left, top, width, height, .. } = self;
        let mut out = format!(
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"#fff\" fill-opacity=\"0.88\" stroke=\"#ccc\"/>\n",
        );
        for (number, series) in series.iter().enumerate() {
            let y = top + 14.0 + 19.0 * number as f64;
            let dash = if series.dashed { " stroke-dasharray=\"7 5\"" } else { "" };
            out += &format!(
                "<path d=\"M{:.1} {y:.1}h24\" stroke=\"{}\" stroke-width=\"2\"{dash}/><text x=\"{:.1}\" y=\"{:.1}\">{}</text>\n",
                left + 7.0,
                COLOURS[number % COLOURS.len()],
                left + 37.0,
                y + 4.5,
                escaped(&series.name)
            );
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, HEIGHT, Legend, LinePlot, Series, WIDTH, line_plot};

    fn named(points: Vec<(f64, f64)>) -> Series {
        Series { name: "a name".into(), points, marks: true, dashed: false }
    }

    #[test]
    fn a_long_number_at_the_end_of_the_axis_stands_within_the_picture() {
        let until = |end: f64| {
            let series = vec![Series { name: String::new(), ..named(vec![(0.0, 1.0), (end, 2.0)]) }];
            let [x_label, y_label, title] = [""; 3].map(String::from);
            line_plot(&LinePlot { title, x_label, y_label, axes: [Axis::Linear; 2], from_zero: true, series })
        };
        // Seven letters of which half stand beyond the end of the axis, 24 pixels before the end of the picture.
        assert!(until(1e-9).contains(">1.00e\u{2212}9<") && until(1e-9).contains("width=\"726\""), "{}", until(1e-9));
        assert!(until(100.0).contains("width=\"720\""), "{}", until(100.0));
    }

    #[test]
    fn names_stand_in_a_corner_that_no_line_between_points_crosses() {
        let place = |point: (f64, f64)| (WIDTH * point.0, HEIGHT * (1.0 - point.1));
        let rising = [named(vec![(0.12, 0.2), (0.95, 0.85)]), named(vec![(0.12, 0.2), (0.95, 0.5)])];
        let legend = Legend::new(&rising, &place);
        assert!(!legend.beside && legend.left < 0.2 * WIDTH, "no point lies there, and yet the line does: {}", legend.left);
        let crossed = [named(vec![(0.12, 0.2), (0.95, 0.85)]), named(vec![(0.12, 0.85), (0.95, 0.2)])];
        assert!(Legend::new(&crossed, &place).beside);
        // What has no place on a logarithmic axis is not in the way.
        let infinite = [named(vec![(0.12, f64::NEG_INFINITY), (0.2, 0.5)])];
        assert!(!Legend::new(&infinite, &place).beside);
    }
}
