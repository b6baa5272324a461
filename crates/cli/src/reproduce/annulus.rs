//! Figures 18 to 23 and 27: the annular punch.

use report::{Axis, Section, Series, numbers_row, table};
use scene::Fault;

use crate::reproduce::closed_form::{RADII, effective_radius, ring_force, ring_pressure};
use crate::reproduce::made::{Made, plot, series};
use crate::reproduce::row::Row;
use crate::reproduce::run::{Run, column, run, set};

pub(super) const SCENE: &str = "annular-punch";
const RADIUS: &str = "radius (mm)";

fn stationary(made: &mut Made, functional: &str, b: &str, q: &str) -> Result<Run, Fault> {
    let solved = run(
        SCENE,
        &[format!("optimum.functional={functional}"), format!("optimum.q={q}"), format!("wear.b={b}"), "tasks=[pressure]".into()],
    )?;
    made.ran(&solved);
    Ok(solved)
}

/// Figure 18.
pub(super) fn geometry() -> Result<Made, Fault> {
    let mut made = Made::default();
    let solved = run(SCENE, &set(&["tasks=[pressure]"]))?;
    made.ran(&solved);
    let section = Section::new([0.0, 150.0], [0.0, 115.0], 0.0);
    let mut body = String::new();
    for (r, z, fill) in [([20.0, 120.0], [50.0, 100.0], "#cfe3f3"), ([10.0, 140.0], [0.0, 50.0], "#eeeeee")] {
        let ([left, top], [right, bottom]) = (section.place([r[0], z[1]]), section.place([r[1], z[0]]));
        body += &format!(
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"{fill}\" stroke=\"#2b4a63\"/>\n",
            right - left,
            bottom - top
        );
    }
    let mut say = |at: [f64; 2], text: &str| {
        let [px, py] = section.place(at);
        body += &format!("<text x=\"{px:.1}\" y=\"{py:.1}\" text-anchor=\"middle\">{text}</text>\n");
    };
    say([70.0, 78.0], "body 1: punch, r = 20 to 120 mm");
    say([70.0, 70.0], "height 50 mm (ours), held against turning on top");
    say([75.0, 27.0], "body 2: disc, r = 10 to 140 mm, height 50 mm (ours)");
    say([75.0, 19.0], "turns with 2.5 rad/s, held on its bottom");
    say([70.0, 106.0], "100 MPa");
    for r in [30.0, 50.0, 90.0, 110.0] {
        let ([px, from], [_, to]) = (section.place([r, 110.0]), section.place([r, 101.5]));
        body += &format!("<path d=\"M{px:.1} {from:.1}V{to:.1}m-4 -8l4 8l4 -8\" fill=\"none\" stroke=\"#222\"/>\n");
    }
    let [axis, top] = section.place([0.0, 115.0]);
    let bottom = section.place([0.0, 0.0])[1];
    body += &format!("<path d=\"M{axis:.1} {top:.1}V{bottom:.1}\" stroke=\"#d55e00\" stroke-dasharray=\"12 4 2 4\"/>\n");
    made.file("geometry.svg", section.picture("Annular punch on a disc: half section", ["r", "z"], &body));
    let rows = [[1.0, 20.0, 120.0, 50.0, 100.0], [2.0, 10.0, 140.0, 0.0, 50.0]];
    let names = ["body", "inner_mm", "outer_mm", "bottom_mm", "top_mm"];
    made.file("geometry.csv", table(&names, rows.iter().map(|row| numbers_row(row))));
    made.rows.push(Row {
        quantity: "load: mean pressure on the ring".into(),
        unit: "MPa",
        paper: Some((100.0, "section 7.4")),
        ours: solved.pressure().p_mean.unwrap_or(f64::NAN),
        ..Row::default()
    });
    made.rows.push(Row {
        quantity: "load: force".into(),
        unit: "N",
        reference: Some(ring_force()),
        ours: solved.pressure().force.unwrap_or(f64::NAN),
        note: "100 MPa times pi (120^2 - 20^2) mm^2".into(),
        ..Row::default()
    });
    made.remarks.push(
        "Inner and outer radius of the punch are the paper's; its height and the whole disc are ours, the text has no numbers."
            .into(),
    );
    Ok(made)
}

/// Figure 19: (62), by the wear volume with b = 1.
pub(super) fn singular_pressures() -> Result<Made, Fault> {
    let mut made = Made::default();
    for (name, qs, from) in [("a", ["1.05", "1.1", "1.25", "1.5"], 0), ("b", ["0.95", "0.9", "0.75", "0.5"], 1)] {
        let mut curves = Vec::new();
        for q in qs {
            let solved = stationary(&mut made, "wear-volume", "1", q)?;
            let end = solved.at(column::pressure, RADII[from]);
            curves.push(series(format!("b q = {q}"), scaled(solved.curve(column::pressure), 1.0 / end)));
            let q: f64 = q.parse().unwrap_or(f64::NAN);
            made.rows.push(Row {
                quantity: format!("b q = {q}: p(70) over p({})", RADII[from]),
                reference: Some((RADII[from] / 70.0).powf(q / (q - 1.0))),
                ours: solved.at(column::pressure, 70.0) / end,
                note: if from == 1 { "(62); b q < 1: a maximum of the wear volume".into() } else { "(62)".into() },
                ..Row::default()
            });
        }
        let title = format!("Annular punch, stationary wear volume, a = b = 1, b q {} 1", if from == 0 { ">" } else { "<" });
        let mut picture = plot(&title, RADIUS, &format!("p / p({} mm)", RADII[from]), curves);
        picture.axes[1] = Axis::Logarithmic;
        made.draw(name, &picture);
    }
    let limit = stationary(&mut made, "wear-volume", "1", "1")?;
    for atom in limit.pressure().limit_measure.iter().take(1) {
        made.rows.push(Row {
            quantity: "b q -> 1 from above: radius of the whole load".into(),
            unit: "mm",
            paper: Some((20.0, "section 7.2")),
            ours: atom.x,
            ..Row::default()
        });
    }
    for (q, said) in [("1.0001", RADII[0]), ("0.9999", RADII[1])] {
        let solved = stationary(&mut made, "friction-power", "1", q)?;
        let exponent = q.parse::<f64>().unwrap_or(f64::NAN);
        made.rows.push(Row {
            quantity: format!("friction power, q = {q}: torque over mu F0"),
            unit: "mm",
            paper: Some((said, "(68), limit q -> 1")),
            reference: Some(effective_radius(exponent / (exponent - 1.0))),
            ours: solved.pressure().effective_radius.unwrap_or(f64::NAN),
            note: if said > 100.0 {
                "the largest torque: this branch maximises the friction power".into()
            } else {
                String::new()
            },
            ..Row::default()
        });
    }
    Ok(made)
}

fn scaled(curve: Vec<(f64, f64)>, factor: f64) -> Vec<(f64, f64)> {
    curve.into_iter().map(|(x, y)| (x, factor * y)).collect()
}

const EXPONENTS: [&str; 8] = ["1.05", "1.2", "1.4", "1.6", "1.7", "1.8", "1.9", "2"];

/// Both functionals over b with q = 1: solid the wear volume, dashed the wear power.
fn by_exponent(made: &mut Made, y_label: &str, shown: fn(&wearshape::Profile) -> &Vec<f64>) -> Result<Vec<Run>, Fault> {
    let mut curves: Vec<Series> = Vec::new();
    let mut runs = Vec::new();
    for (functional, word, dashed) in [("wear-volume", "W", false), ("wear-power", "D_w", true)] {
        for b in EXPONENTS {
            let solved = stationary(made, functional, b, "1")?;
            curves.push(Series { dashed, ..series(format!("{word}, b = {b}"), solved.curve(shown)) });
            runs.push(solved);
        }
    }
    let mut picture = plot("Annular punch, a = 1, q = 1: wear volume (W) and wear power (D_w)", RADIUS, y_label, curves);
    picture.axes[1] = Axis::Logarithmic;
    made.draw_within("curves", &picture, [1.0, f64::INFINITY]);
    Ok(runs)
}

/// Figure 20.
pub(super) fn pressure_by_exponent() -> Result<Made, Fault> {
    let mut made = Made::default();
    let runs = by_exponent(&mut made, "pressure (MPa)", column::pressure)?;
    for (number, solved) in runs.iter().enumerate() {
        let (word, b) = (["W", "D_w"][number / 8], EXPONENTS[number % 8]);
        if !["1.05", "1.2", "2"].contains(&b) {
            continue;
        }
        let value: f64 = b.parse().unwrap_or(f64::NAN);
        let e = if word == "W" { 1.0 / (value - 1.0) } else { 1.0 / value };
        for radius in RADII {
            made.rows.push(Row {
                quantity: format!("{word}, b = {b}: pressure at r = {radius} mm"),
                unit: "MPa",
                reference: Some(ring_pressure(e, radius)),
                ours: solved.at(column::pressure, radius),
                note: if word == "W" { "(47)".into() } else { "(59)".into() },
                ..Row::default()
            });
        }
    }
    made.remarks.push("Curve only: the text prints the ratios of table-wr but no pressures.".into());
    Ok(made)
}

/// Figure 21.
pub(super) fn wear_rate_by_exponent() -> Result<Made, Fault> {
    let mut made = Made::default();
    let runs = by_exponent(&mut made, "wear rate (\u{b5}m/s)", column::wear_rate)?;
    for (number, solved) in runs.iter().enumerate() {
        let (word, b) = (["W", "D_w"][number / 8], EXPONENTS[number % 8]);
        if !["1.05", "2"].contains(&b) {
            continue;
        }
        let rates = solved.curve(column::wear_rate);
        let (low, high) = rates.iter().fold((f64::MAX, 0.0_f64), |(lo, hi), point| (lo.min(point.1), hi.max(point.1)));
        let value: f64 = b.parse().unwrap_or(f64::NAN);
        made.rows.push(Row {
            quantity: format!("{word}, b = {b}: largest over smallest wear rate"),
            paper: (word == "D_w").then_some((1.0, "section 7.4: uniform")),
            reference: Some(if word == "W" { 6.0_f64.powf(1.0 / (value - 1.0)) } else { 1.0 }),
            ours: high / low,
            note: if word == "W" { "(48)".into() } else { "(60)".into() },
            ..Row::default()
        });
    }
    Ok(made)
}

/// The wear power with a = b = 1 over q: p ~ r^-e, e = q / (2q - 1).
fn by_q(name: &str, qs: &[&str]) -> Result<Made, Fault> {
    let mut made = Made::default();
    let mut curves = Vec::new();
    for q in qs {
        let solved = stationary(&mut made, "wear-power", "1", q)?;
        curves.push(series(format!("q = {q}"), solved.curve(column::pressure)));
        let number: f64 = q.parse().unwrap_or(f64::INFINITY);
        let e = if number.is_infinite() { 0.5 } else { number / (2.0 * number - 1.0) };
        for radius in RADII {
            made.rows.push(Row {
                quantity: format!("q = {q}: pressure at r = {radius} mm"),
                unit: "MPa",
                reference: Some(ring_pressure(e, radius)),
                ours: solved.at(column::pressure, radius),
                ..Row::default()
            });
        }
        let worst = number < 0.5;
        made.rows.push(Row {
            quantity: format!("q = {q}: torque over mu F0"),
            unit: "mm",
            reference: Some(effective_radius(e)),
            ours: solved.pressure().effective_radius.unwrap_or(f64::NAN),
            note: if worst { "s < 1: the worst pressure, not the best".into() } else { String::new() },
            ..Row::default()
        });
    }
    let mut picture = plot("Annular punch, stationary wear power, a = b = 1", RADIUS, "pressure (MPa)", curves);
    picture.axes[1] = Axis::Logarithmic;
    made.draw(name, &picture);
    Ok(made)
}

/// Figure 22.
pub(super) fn pressure_by_q() -> Result<Made, Fault> {
    let mut made = by_q("curves", &["0.55", "0.6", "0.75", "1", "2", "10"])?;
    let limit = stationary(&mut made, "wear-power", "1", "0.5")?;
    for atom in limit.pressure().limit_measure.iter().take(1) {
        made.rows.push(Row {
            quantity: "q = 0.5: radius of the whole load".into(),
            unit: "mm",
            paper: Some((20.0, "section 7.5")),
            ours: atom.x,
            note: "the limit from above; at q = 0.5 itself there is no pressure".into(),
            ..Row::default()
        });
    }
    Ok(made)
}

/// Figure 23.
pub(super) fn pressure_by_small_q() -> Result<Made, Fault> {
    let mut made = by_q("curves", &["0.3", "0.4", "0.45", "0.48"])?;
    let near = stationary(&mut made, "wear-power", "1", "0.4999")?;
    made.rows.push(Row {
        quantity: "q = 0.4999: torque over mu F0".into(),
        unit: "mm",
        paper: Some((120.0, "section 7.5: singular at r_e")),
        reference: Some(effective_radius(0.4999 / (2.0 * 0.4999 - 1.0))),
        ours: near.pressure().effective_radius.unwrap_or(f64::NAN),
        ..Row::default()
    });
    Ok(made)
}

/// Figure 27.
pub(super) fn steady_shape() -> Result<Made, Fault> {
    let mut made = Made::default();
    let solved = run(SCENE, &set(&["optimum.functional=wear-power", "optimum.q=1"]))?;
    made.ran(&solved);
    made.draw(
        "curves",
        &plot(
            "Annular punch: shape of uniform wear, a = b = 1",
            RADIUS,
            "gap (\u{b5}m)",
            vec![series("", solved.curve(column::gap))],
        ),
    );
    let shape = solved.solution.shape.clone().unwrap_or_default();
    made.rows.push(Row {
        quantity: "passes of the shape".into(),
        paper: Some((5.0, "caption of Fig. 27")),
        ours: shape.iterations as f64,
        note: "under a given force the shape follows from the wanted pressure in one linear pass".into(),
        ..Row::default()
    });
    made.rows.push(Row {
        quantity: "largest gap".into(),
        unit: "um",
        ours: shape.gap_max.unwrap_or(f64::NAN),
        note: "at the outer edge; heights are ours, curve only".into(),
        ..Row::default()
    });
    let rates = solved.curve(column::wear_rate);
    let (low, high) = rates.iter().fold((f64::MAX, 0.0_f64), |(lo, hi), point| (lo.min(point.1), hi.max(point.1)));
    made.rows.push(Row {
        quantity: "largest over smallest wear rate".into(),
        paper: Some((1.0, "section 7.5, Fig. 27")),
        ours: high / low,
        ..Row::default()
    });
    let worn = run(SCENE, &set(&["tasks=[wear]"]))?;
    made.ran(&worn);
    let difference: f64 = {
        let (a, b) = (worn.curve(column::gap), solved.curve(column::gap));
        let most = b.iter().map(|point| point.1).fold(0.0, f64::max);
        let rest: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a.1 - b.1).collect();
        let mean = rest.iter().sum::<f64>() / rest.len() as f64;
        rest.iter().map(|d| (d - mean).abs()).fold(0.0, f64::max) / most
    };
    made.rows.push(Row {
        quantity: "shape against wear in time from a flat start, max |dg| / max g".into(),
        reference: Some(0.0),
        ours: difference,
        note: "what the accuracy of 1e-6 leaves".into(),
        ..Row::default()
    });
    Ok(made)
}
