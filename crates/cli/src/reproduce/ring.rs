//! Figures 9 to 11: the shoe of constant thickness.

use scene::Fault;

use crate::reproduce::drum::asymmetry;
use crate::reproduce::made::{Made, plot, series};
use crate::reproduce::row::Row;
use crate::reproduce::run::{column, highest, run, set, value_at};
use crate::reproduce::section::meshes;

const SCENE: &str = "drum-brake-ring";
const ANGLE: &str = "angle (deg)";

/// Figure 9.
pub(super) fn mesh() -> Result<Made, Fault> {
    let mut made = Made::default();
    let cells =
        meshes(&mut made, SCENE, &set(&["mesh.degree=8", "mesh.layers=3"]), "Ring shoe on its drum: mesh with three layers")?;
    made.rows.push(Row {
        quantity: "traction of the load, 10 kN on 16.7832 mm x 10 mm".into(),
        unit: "MPa",
        paper: Some((59.58336, "section 5.4 (59.58333 in the caption of Fig. 9)")),
        ours: 10_000.0 / (16.7832 * 10.0),
        note: "the width is not printed; it follows from traction, thickness and force".into(),
        ..Row::default()
    });
    made.rows.push(Row { quantity: "cells of both bodies".into(), ours: cells as f64, ..Row::default() });
    made.remarks
        .push("Our mesh, not the paper's: layers towards every singular point, the whole brake instead of its half.".into());
    Ok(made)
}

/// Figure 10.
pub(super) fn initial_pressure() -> Result<Made, Fault> {
    let mut made = Made::default();
    let solved = run(SCENE, &set(&["tasks=[contact]", "accuracy=1e-2"]))?;
    made.ran(&solved);
    let curve = solved.curve(column::pressure);
    let contact = solved.solution.contact.clone().unwrap_or_default();
    made.rows.push(Row {
        quantity: "vertical force carried".into(),
        unit: "N",
        paper: Some((10_000.0, "section 5.4")),
        ours: contact.force.unwrap_or(f64::NAN),
        ..Row::default()
    });
    let inner: Vec<(f64, f64)> = curve.iter().copied().filter(|point| point.0.abs() < 20.0).collect();
    let title = "Ring shoe, contact pressure before wear, \u{b5} = 0.25";
    let picture = plot(title, ANGLE, "pressure (MPa)", vec![series("", curve.clone())]);
    made.draw_within("curves", &picture, [0.0, 1.5 * highest(&inner).1]);
    made.rows.push(Row {
        quantity: "angle of the central peak".into(),
        unit: "deg",
        ours: highest(&inner).0,
        note: "the paper: highly localised near the centre line".into(),
        ..Row::default()
    });
    made.rows.push(Row {
        quantity: "pressure of the central peak".into(),
        unit: "MPa",
        ours: highest(&inner).1,
        note: "curve only".into(),
        ..Row::default()
    });
    for (side, angle) in [("left", -29.5), ("right", 29.5)] {
        made.rows.push(Row {
            quantity: format!("pressure at {angle} deg, near the {side} end"),
            unit: "MPa",
            ours: value_at(&curve, angle),
            note: if side == "left" {
                "the paper: localised at the left end too, because of friction".into()
            } else {
                String::new()
            },
            ..Row::default()
        });
    }
    made.remarks.push("The shoe touches in patches. At the left corner itself the pressure is singular (the picture leaves it out, the table has it); elsewhere pressures are good to about one per cent (accuracy = 1e-2). Thickness 20 mm of the shoe and hub radius are ours.".into());
    Ok(made)
}

/// Figure 11.
pub(super) fn gaps() -> Result<Made, Fault> {
    let mut made = Made::default();
    gaps_by_friction(&mut made)?;
    gaps_by_support(&mut made)?;
    Ok(made)
}

/// Both ends held, by the coefficient of friction.
fn gaps_by_friction(made: &mut Made) -> Result<(), Fault> {
    let mut curves = Vec::new();
    let mut pressures = Vec::new();
    for friction in ["0", "0.1", "0.2", "0.25"] {
        let solved = run(SCENE, &set(&["optimum.functional=uniform", &format!("contact.friction={friction}"), "check=false"]))?;
        made.ran(&solved);
        pressures.push((friction, solved.at(column::pressure, 10.0)));
        curves.push(series(format!("\u{b5} = {friction}"), solved.curve(column::gap)));
    }
    made.rows.push(Row {
        quantity: "mu = 0: asymmetry of the gap, max |g(a) - g(-a)| / max g".into(),
        reference: Some(0.0),
        ours: asymmetry(&curves[0].points),
        note: "a symmetric problem".into(),
        ..Row::default()
    });
    made.rows.push(Row {
        quantity: "mu = 0.25: asymmetry of the gap".into(),
        ours: asymmetry(&curves[3].points),
        note: "the paper: not symmetric because of friction".into(),
        ..Row::default()
    });
    for (friction, pressure) in pressures.into_iter().filter(|(friction, _)| ["0", "0.25"].contains(friction)) {
        made.rows.push(Row {
            quantity: format!("mu = {friction}: uniform pressure"),
            unit: "MPa",
            paper: Some((5.028, "section 5.4")),
            reference: Some(10_000.0 / (200.0 * 10.0)),
            ours: pressure,
            note: "F0 over the projected chord of 200 mm; no radius and angle we tried give both 5.028 and 59.58".into(),
            ..Row::default()
        });
    }
    made.draw("a", &plot("Ring shoe, both ends held: gap for uniform pressure", ANGLE, "gap (\u{b5}m)", curves));
    Ok(())
}

/// With the friction of the scene, by what holds the shoe.
fn gaps_by_support(made: &mut Made) -> Result<(), Fault> {
    let mut curves = Vec::new();
    let uniform = ["optimum.functional=uniform", "check=false"];
    let drop = ["load={edge=\"outer\",as=\"vertical\",force=\"10 kN\"}"];
    let cases: [(&str, &str, &[&str]); 4] = [
        ("both ends", "body1.support={left=[\"x\"],right=[\"x\"]}", &[]),
        ("left end", "body1.support={left=[\"x\"]}", &drop),
        ("right end", "body1.support={right=[\"x\"]}", &[]),
        ("centre", "body1.support={centre=[\"x\"]}", &[]),
    ];
    for (name, support, load) in cases {
        let words: Vec<&str> = uniform.iter().chain(&[support]).chain(load).copied().collect();
        let solved = run(SCENE, &set(&words))?;
        made.ran(&solved);
        let curve = solved.curve(column::gap);
        let (angle, most) = highest(&curve);
        made.rows.push(Row {
            quantity: format!("held at {name}: largest gap"),
            unit: "um",
            ours: most,
            note: format!("at {} deg; curve only", (angle * 10.0).round() / 10.0 + 0.0),
            ..Row::default()
        });
        curves.push(series(format!("held at {name}"), curve));
    }
    made.rows.push(Row {
        quantity: "left end: load over the whole top".into(),
        unit: "MPa",
        paper: Some((5.0, "section 5.4")),
        ours: 10_000.0 / (200.0 * 10.0),
        note: "10 kN on the chord of 200 mm x 10 mm".into(),
        ..Row::default()
    });
    made.draw("b", &plot("Ring shoe, \u{b5} = 0.25: gap for uniform pressure by support", ANGLE, "gap (\u{b5}m)", curves));
    Ok(())
}
