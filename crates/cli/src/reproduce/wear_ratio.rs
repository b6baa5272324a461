//! The table of section 7.4: wear volume rate of the stationary wear volume over that of the stationary wear power.

use report::Series;
use scene::Fault;

use crate::reproduce::annulus::SCENE;
use crate::reproduce::closed_form::{RADII, power_integral};
use crate::reproduce::made::{Made, plot};
use crate::reproduce::row::Row;
use crate::reproduce::run::run;

/// b and the printed ratio.
const PRINTED: [(&str, f64); 8] = [
    ("1.05", 0.3790),
    ("1.2", 0.6209),
    ("1.4", 0.8157),
    ("1.6", 0.8957),
    ("1.7", 0.9173),
    ("1.8", 0.9328),
    ("1.9", 0.9442),
    ("2.0", 0.9529),
];

/// `int r^(1-e) dr` over the punch in units of the inner radius.
fn moment(e: f64) -> f64 {
    power_integral(1.0 - e, 1.0, RADII[1] / RADII[0])
}

/// (49) over (61) for a = q = 1: `w_r = I_W^(1-b) I_D^b / S`.
fn ratio(b: f64) -> f64 {
    moment(1.0 / (b - 1.0)).powf(1.0 - b) * moment(1.0 / b).powf(b) / moment(0.0)
}

/// Table 7.4.
pub(super) fn table() -> Result<Made, Fault> {
    let mut made = Made::default();
    let mut points = Vec::new();
    for (b, printed) in PRINTED {
        let mut rates = [0.0; 2];
        for (rate, functional) in rates.iter_mut().zip(["wear-volume", "wear-power"]) {
            let solved =
                run(SCENE, &[format!("optimum.functional={functional}"), format!("wear.b={b}"), "tasks=[pressure]".into()])?;
            made.ran(&solved);
            *rate = solved.pressure().wear_volume_rate.unwrap_or(f64::NAN);
        }
        let ours = rates[0] / rates[1];
        let number: f64 = b.parse().unwrap_or(f64::NAN);
        // The table has four digits.
        let truncated = (ours * 1e4).floor() / 1e4 == printed && (ours * 1e4).round() / 1e4 != printed;
        made.rows.push(Row {
            quantity: format!("b = {b}: w_r"),
            paper: Some((printed, "section 7.4")),
            reference: Some(ratio(number)),
            ours,
            note: if truncated { "the printed number is cut off after four digits, not rounded".into() } else { String::new() },
            ..Row::default()
        });
        points.push((number, ours));
    }
    let ours = Series { name: "computed".into(), points, marks: true, dashed: false };
    let printed = PRINTED.iter().map(|(b, value)| (b.parse().unwrap_or(f64::NAN), *value)).collect();
    let printed = Series { name: "printed".into(), points: printed, marks: true, dashed: true };
    let title = "Wear volume rate: stationary wear volume over stationary wear power";
    made.draw("curves", &plot(title, "exponent b", "ratio w_r", vec![ours, printed]));
    made.remarks.push("(58) as printed, with I_W where I_Dw belongs, would give ratios of 1e-29 to 0.014; the printed table is that of the corrected formula.".into());
    Ok(made)
}
