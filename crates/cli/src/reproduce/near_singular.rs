//! Figures 24 and 25: meshes and shapes of the annular punch next to the singular exponent.

use scene::Fault;

use crate::reproduce::annulus::SCENE;
use crate::reproduce::closed_form::{RADII, effective_radius, ring_pressure};
use crate::reproduce::made::{Made, plot, series};
use crate::reproduce::row::Row;
use crate::reproduce::run::{column, highest, run, set};
use crate::reproduce::section::meshes;

/// Figure 24.
pub(super) fn inner() -> Result<Made, Fault> {
    near("0.505", RADII[0])
}

/// Figure 25.
pub(super) fn outer() -> Result<Made, Fault> {
    near("0.495", RADII[1])
}

fn near(q: &str, end: f64) -> Result<Made, Fault> {
    let mut made = Made::default();
    let settings = set(&["optimum.functional=wear-power", &format!("optimum.q={q}")]);
    let solved = run(SCENE, &settings)?;
    made.ran(&solved);
    let gap = solved.curve(column::gap);
    let title = format!("Annular punch, q = {q}: optimal shape");
    made.draw("shape", &plot(&title, "radius (mm)", "gap (\u{b5}m)", vec![series("", gap.clone())]));
    let layers: Vec<String> = settings.iter().cloned().chain(["mesh.degree=8".into(), "mesh.layers=6".into()]).collect();
    let cells = meshes(&mut made, SCENE, &layers, "Annular punch on a disc: mesh with six layers")?;
    let number: f64 = q.parse().unwrap_or(f64::NAN);
    let e = number / (2.0 * number - 1.0);
    made.rows.push(Row {
        quantity: format!("pressure at r = {end} mm"),
        unit: "MPa",
        reference: Some(ring_pressure(e, end)),
        ours: solved.at(column::pressure, end),
        note: "(54) without its stray power b".into(),
        ..Row::default()
    });
    made.rows.push(Row {
        quantity: "torque over mu F0".into(),
        unit: "mm",
        reference: Some(effective_radius(e)),
        ours: solved.pressure().effective_radius.unwrap_or(f64::NAN),
        ..Row::default()
    });
    let (radius, most) = highest(&gap);
    made.rows.push(Row {
        quantity: "largest gap".into(),
        unit: "um",
        ours: most,
        note: format!("at r = {radius} mm; curve only, heights are ours"),
        ..Row::default()
    });
    // Within a tenth of the width from the loaded end.
    let reach = 0.1 * (RADII[1] - RADII[0]);
    let near: Vec<f64> = gap.iter().filter(|point| (point.0 - end).abs() <= reach + 1e-9).map(|point| point.1).collect();
    let part = near.iter().copied().fold(f64::MIN, f64::max) - near.iter().copied().fold(f64::MAX, f64::min);
    made.rows.push(Row {
        quantity: "share of the rise within 10 mm of the loaded end".into(),
        ours: part / most,
        note: "the paper: large gradients of the shape near the boundaries".into(),
        ..Row::default()
    });
    made.rows.push(Row { quantity: "cells of both bodies in the picture".into(), ours: cells as f64, ..Row::default() });
    let pressure = solved.pressure();
    let word = if pressure.character == Some(wearshape::Character::Maximum) {
        "is a maximum of the wear power"
    } else {
        "is a minimum of the wear power"
    };
    made.remarks.push(format!(
        "This pressure {word} ({}); stresses of this size are far beyond any yield stress, the figure is a matter of principle.",
        wearshape::word(&pressure.regime)
    ));
    Ok(made)
}
