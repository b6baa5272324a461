//! A shaft in its housing against the closed form of Persson: how far it touches, and how hard, by the load.

use std::f64::consts::PI;

use scene::Fault;

use crate::reproduce::made::{Made, plot, series};
use crate::reproduce::row::Row;
use crate::reproduce::run::{run, set};

/// Radius (mm), clearance and thickness (mm), outer radius of the housing (mm) and modulus `E/(1 - nu^2)` (MPa) of two bodies of steel.
const RADIUS: f64 = 25.0;
const CLEARANCE: f64 = 1e-4 * RADIUS;
const THICKNESS: f64 = 30.0;
const HOUSING: f64 = 40.0 * RADIUS;
const MODULUS: f64 = 210e3 / (1.0 - 0.3 * 0.3);

/// Half angles of contact that are compared, degrees.
const ANGLES: [f64; 7] = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0];

/// `E' dR t / F` and `R t p_max / F` of a half angle of contact eps (rad), with `b = tan(eps/2)`; A. Persson, dissertation, Gothenburg 1964, as in
/// M. Ciavarella and P. Decuzzi, Int. J. Solids Struct. 38 (2001) 4507-4523.
fn persson(eps: f64) -> [f64; 2] {
    let square = (0.5 * eps).tan().powi(2);
    let (b, side) = (square.sqrt(), (1.0 + square).sqrt());
    let clearance = (2.0 - 2.0 * square * square - square.ln_1p()) / (PI * square * (1.0 + square));
    let pressure = 2.0 * b / (PI * side) + ((side + b) / (side - b)).ln() / (2.0 * PI * square * (1.0 + square));
    [clearance, pressure]
}

/// Half angle and largest pressure at the loads that Persson has for the half angles.
pub(super) fn conformal() -> Result<Made, Fault> {
    let mut made = Made::default();
    let mut found = [Vec::new(), Vec::new()];
    for degrees in ANGLES {
        let [clearance, peak] = persson(degrees.to_radians());
        let force = MODULUS * CLEARANCE * THICKNESS / clearance;
        let solved = run("journal", &settings(force))?;
        made.ran(&solved);
        let contact = solved.solution.contact.as_ref();
        let half = contact.map_or(f64::NAN, |contact| match contact.ends[..] {
            [from, to] => (0.5 * (to - from) / RADIUS).to_degrees(),
            _ => f64::NAN,
        });
        let largest = contact.and_then(|contact| contact.p_max).map_or(f64::NAN, |p| p * RADIUS * THICKNESS / force);
        for (list, value) in found.iter_mut().zip([half, largest]) {
            list.push((1.0 / clearance, value));
        }
        for (what, unit, reference, ours) in [("half angle", "deg", degrees, half), ("R t p_max / F", "", peak, largest)] {
            made.rows.push(Row {
                quantity: format!("F/(E' dR t) = {:.4}: {what}", 1.0 / clearance),
                unit,
                reference: Some(reference),
                ours,
                ..Row::default()
            });
        }
    }
    let exact = |value: fn(f64) -> f64| -> Vec<(f64, f64)> {
        (8..=72).map(|degrees| f64::from(degrees).to_radians()).map(|eps| (1.0 / persson(eps)[0], value(eps))).collect()
    };
    let [halves, peaks] = found;
    let load = "F/(E' dR t)";
    let mut draw = |name: &str, title: &str, what: &str, exact: Vec<(f64, f64)>, found: Vec<(f64, f64)>| {
        let points = report::Series { marks: true, dashed: true, ..series("journal", found) };
        let curves = plot(title, load, what, vec![series("Persson", exact), points]);
        made.draw(name, &report::LinePlot { axes: [report::Axis::Logarithmic; 2], ..curves });
    };
    draw("half-angle", "Shaft in a housing: half angle of contact", "half angle (deg)", exact(f64::to_degrees), halves);
    draw("pressure", "Shaft in a housing: largest pressure", "R t p_max / F", exact(|eps| persson(eps)[1]), peaks);
    made.remarks.push(format!(
        "The closed form is of a plate without end and a clearance that is small against the radius; here the housing reaches out to {} radii and the clearance is 1e-4 of the radius.",
        HOUSING / RADIUS
    ));
    Ok(made)
}

/// The built-in scene with two bodies of steel, a large housing, no friction and this load.
fn settings(force: f64) -> Vec<String> {
    set(&[
        &format!("load.force={force}"),
        &format!("contact.clearance={CLEARANCE}"),
        "contact.friction=0",
        "body1.material.young=210e3",
        "body1.material.poisson=0.3",
        &format!("body1.geometry.ring.outer={HOUSING}"),
        "body2.geometry.ring.inner=0.25",
    ])
}
