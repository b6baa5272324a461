//! Error against seconds as SVG, both axes logarithmic.

use super::super::picture::escape;
use super::front::front;
use super::outcome::{Ladder, Outcome};

const WIDTH: f64 = 620.0;
const HEIGHT: f64 = 380.0;
const LEFT: f64 = 66.0;
const TOP: f64 = 34.0;
const OURS: [&str; 3] = ["#1f4e9c", "#2e8bc0", "#6a8caf"];
const THEIRS: &str = "#c0392b";

/// The picture of a study.
pub(crate) fn picture(outcome: &Outcome) -> String {
    let points = || outcome.ladders.iter().flat_map(|ladder| &ladder.points);
    let x = Axis::new(points().map(|p| p.seconds), LEFT, LEFT + WIDTH);
    let y = Axis::new(points().map(|p| p.error), TOP + HEIGHT, TOP);
    let legend = 18.0 * outcome.ladders.len() as f64;
    let (width, height) = (LEFT + WIDTH + 20.0, TOP + HEIGHT + 46.0 + legend);
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {height}' width='{width}' height='{height}' \
         font-family='sans-serif' font-size='12'>\n<rect width='{width}' height='{height}' fill='#fff'/>\n\
         <text x='{LEFT}' y='20' font-size='14'>{}</text>\n",
        escape(&outcome.study.title)
    );
    for decade in x.decades() {
        let at = x.place(10f64.powi(decade));
        svg += &format!("<line x1='{at:.1}' y1='{TOP}' x2='{at:.1}' y2='{}' stroke='#ddd'/>\n", TOP + HEIGHT);
        svg += &format!("<text x='{at:.1}' y='{}' text-anchor='middle'>{}</text>\n", TOP + HEIGHT + 16.0, power(decade));
    }
    for decade in y.decades() {
        let at = y.place(10f64.powi(decade));
        svg += &format!("<line x1='{LEFT}' y1='{at:.1}' x2='{}' y2='{at:.1}' stroke='#ddd'/>\n", LEFT + WIDTH);
        svg += &format!("<text x='{}' y='{:.1}' text-anchor='end'>{}</text>\n", LEFT - 6.0, at + 4.0, power(decade));
    }
    svg += &format!("<rect x='{LEFT}' y='{TOP}' width='{WIDTH}' height='{HEIGHT}' fill='none' stroke='#888'/>\n");
    svg += &format!(
        "<text x='{}' y='{}' text-anchor='middle'>seconds, one thread</text>\n",
        LEFT + 0.5 * WIDTH,
        TOP + HEIGHT + 34.0
    );
    let middle = TOP + 0.5 * HEIGHT;
    svg += &format!("<text x='14' y='{middle}' text-anchor='middle' transform='rotate(-90 14 {middle})'>relative error</text>\n");
    for (number, ladder) in outcome.ladders.iter().enumerate() {
        let colour = if ladder.ours { OURS[number % OURS.len()] } else { THEIRS };
        let row = TOP + HEIGHT + 56.0 + 18.0 * number as f64;
        svg += &curve(ladder, &x, &y, colour);
        svg += &format!("<circle cx='{}' cy='{}' r='4' fill='{colour}'/>\n", LEFT + 6.0, row - 4.0);
        svg += &format!("<text x='{}' y='{row}'>{}</text>\n", LEFT + 18.0, escape(&ladder.name));
    }
    svg + "</svg>\n"
}

/// Marks of every level, and a line through those that no other level of the ladder beats.
fn curve(ladder: &Ladder, x: &Axis, y: &Axis, colour: &str) -> String {
    let mut svg = String::new();
    for point in &ladder.points {
        let (cx, cy) = (x.place(point.seconds), y.place(point.error));
        svg += &format!(
            "<circle cx='{cx:.1}' cy='{cy:.1}' r='3.4' fill='{colour}' fill-opacity='.55'><title>{}: {:.2e} s, {:.1e}</title></circle>\n",
            escape(&point.label),
            point.seconds,
            point.error
        );
    }
    let best = front(&ladder.points);
    let line: Vec<String> = best.iter().map(|p| format!("{:.1},{:.1}", x.place(p.seconds), y.place(p.error))).collect();
    svg + &format!("<polyline points='{}' fill='none' stroke='{colour}' stroke-width='1.8'/>\n", line.join(" "))
}

fn power(decade: i32) -> String {
    format!("10<tspan dy='-5' font-size='9'>{decade}</tspan>")
}

/// A logarithmic axis over whole decades.
struct Axis {
    low: i32,
    high: i32,
    from: f64,
    to: f64,
}

impl Axis {
    fn new(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (low, high) = values.filter(|v| *v > 0.0).fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(v), high.max(v)));
        let (low, high) = if low.is_finite() { (low, high) } else { (1.0, 10.0) };
        let low = low.log10().floor() as i32;
        Self { low, high: (high.log10().ceil() as i32).max(low + 1), from, to }
    }

    fn place(&self, value: f64) -> f64 {
        self.from + (self.to - self.from) * (value.log10() - f64::from(self.low)) / f64::from(self.high - self.low)
    }

    fn decades(&self) -> std::ops::RangeInclusive<i32> {
        self.low..=self.high
    }
}
