//! Curves as SVG: ours as a line, the reference as circles, the difference below.

const WIDTH: f64 = 460.0;
const UPPER: f64 = 220.0;
const LOWER: f64 = 70.0;
const LEFT: f64 = 64.0;
const TOP: f64 = 26.0;
const BETWEEN: f64 = 18.0;

/// One picture of two curves over the same places.
pub(crate) fn curves(title: &str, at: &[f64], ours: &[f64], theirs: &[f64]) -> String {
    let difference: Vec<f64> = ours.iter().zip(theirs).map(|(a, b)| a - b).collect();
    let height = TOP + UPPER + BETWEEN + LOWER + 26.0;
    let mut svg = format!(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{}' height='{height}' font-family='sans-serif' font-size='11'>\n\
         <text x='{LEFT}' y='16' font-size='13'>{}</text>\n",
        LEFT + WIDTH + 12.0,
        escape(title)
    );
    let x = Axis::new(at, LEFT, LEFT + WIDTH);
    let values = ours.iter().chain(theirs).copied().collect::<Vec<_>>();
    let upper = Axis::new(&values, TOP + UPPER, TOP);
    let lower = Axis::new(&difference, TOP + UPPER + BETWEEN + LOWER, TOP + UPPER + BETWEEN);
    svg += &frame(&upper, TOP, UPPER);
    svg += &frame(&lower, TOP + UPPER + BETWEEN, LOWER);
    svg += &line(&x, &upper, at, ours, "#1f4e9c");
    for (s, value) in at.iter().zip(theirs) {
        let (cx, cy) = (x.place(*s), upper.place(*value));
        svg += &format!("<circle cx='{cx:.2}' cy='{cy:.2}' r='2.6' fill='none' stroke='#c0392b'/>\n");
    }
    svg += &line(&x, &lower, at, &difference, "#444");
    let bottom = height - 10.0;
    svg += &format!(
        "<text x='{LEFT}' y='{bottom}'>{:.4}</text><text x='{}' y='{bottom}' text-anchor='end'>{:.4} mm</text>\n</svg>",
        x.low,
        LEFT + WIDTH,
        x.high
    );
    svg
}

/// A linear map of values onto a stretch of the picture.
struct Axis {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Axis {
    fn new(values: &[f64], from: f64, to: f64) -> Self {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // A curve that is constant but for round-off is drawn as such, in the middle.
        let size = low.abs().max(high.abs());
        let room = if high - low > 1e-9 * size { 0.0 } else { (0.5 * size).max(1e-300) };
        Self { low: low - room, high: high + room, from, to }
    }

    fn place(&self, value: f64) -> f64 {
        self.from + (self.to - self.from) * (value - self.low) / (self.high - self.low)
    }
}

fn frame(axis: &Axis, top: f64, height: f64) -> String {
    let right = LEFT - 4.0;
    format!(
        "<rect x='{LEFT}' y='{top}' width='{WIDTH}' height='{height}' fill='none' stroke='#bbb'/>\n\
         <text x='{right}' y='{}' text-anchor='end'>{}</text><text x='{right}' y='{}' text-anchor='end'>{}</text>\n",
        top + 9.0,
        readable(axis.high),
        top + height,
        readable(axis.low)
    )
}

fn line(x: &Axis, y: &Axis, at: &[f64], values: &[f64], colour: &str) -> String {
    let points: Vec<String> =
        at.iter().zip(values).map(|(s, value)| format!("{:.2},{:.2}", x.place(*s), y.place(*value))).collect();
    format!("<polyline points='{}' fill='none' stroke='{colour}' stroke-width='1.4'/>\n", points.join(" "))
}

/// Four digits, with an exponent only where it is shorter.
fn readable(value: f64) -> String {
    match value.abs() {
        size if size == 0.0 || (1e-2..1e5).contains(&size) => {
            let digits = (3 - size.max(1e-2).log10().floor() as i32).clamp(0, 5) as usize;
            format!("{value:.digits$}")
        }
        _ => format!("{value:.2e}"),
    }
}

/// Text inside HTML or SVG.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axis_ends_are_readable() {
        assert_eq!([5.4546, 116.8, 12345.6, 0.05, 0.0].map(readable), ["5.455", "116.8", "12346", "0.05000", "0.00000"]);
        assert_eq!([3.642e-14, 2.5e7].map(readable), ["3.64e-14", "2.50e7"]);
    }
}
